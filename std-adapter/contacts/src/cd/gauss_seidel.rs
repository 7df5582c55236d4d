//! Non-linear Gauss–Seidel: contacts solved one after the other until a stopping rule is met.

use super::operator::{GlobalChange, LocalChange, NoMonitor, Operator, Visit};
use tribos_base::random::Random;

/// Order in which a sweep visits the contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IterationOrder {
    /// Always in the order of their numbers.
    Fixed,
    /// Alternately forwards and backwards, which gives a symmetric iteration.
    Alternating,
    /// A new random permutation for each sweep (Unger and Kertész 2003), generated from a seed.
    Random {
        /// Seed of the random stream.
        seed: u64,
    },
}

/// Stopping rule of the iteration (thesis, section 4.4.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StopRule {
    /// A fixed number of sweeps.
    Fixed,
    /// No contact's impulse changes by more than this fraction of its own P, or by more than the rounding of the
    /// largest P.
    Local(f64),
    /// The mean change is below this fraction of the mean P.
    Global(f64),
}

/// Performs sweeps in a given order.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::IterationOrder;
/// # use tribos::cd::internals::{GlobalChange, Link, Spheres, Sweeper};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let (spin, velocity) = (Vector3::zeros(), Vector3::new(1.0, 0.0, -0.01));
/// # let ball = SphereBody { velocity, spin, inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # let mut problem = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// # problem.free = (vec![ball], vec![floor]);
/// # problem.walls.push(Link { bodies: [0, 0], contact });
/// # problem.start();
/// // A ball that slides on the floor: its one contact is solved by the first sweep, and the second
/// // has nothing to do.
/// let mut sweeper = Sweeper::new(IterationOrder::Alternating, 0);
/// let [mut first, mut second] = [GlobalChange::default(); 2];
/// sweeper.sweep(&mut problem, &mut first);
/// sweeper.sweep(&mut problem, &mut second);
/// assert!(first.relative() > 1.0); // all of the friction as well
/// assert!(second.relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sweeper {
    order: IterationOrder,
    turn: u64,
    random: Random,
    permutation: Vec<u32>,
}

impl Sweeper {
    /// Starts at the first sweep; random orders differ between streams.
    pub fn new(order: IterationOrder, stream: u64) -> Self {
        let seed = match order {
            IterationOrder::Random { seed } => seed,
            _ => 0,
        };
        Self {
            order,
            turn: 0,
            random: Random::new(seed, stream),
            permutation: Vec::new(),
        }
    }

    /// Performs one sweep.
    pub fn sweep<O: Operator, W: super::operator::Monitor>(
        &mut self,
        problem: &mut O,
        watch: &mut W,
    ) {
        self.turn += 1;
        match self.order {
            IterationOrder::Fixed => problem.sweep(Visit::Forward, watch),
            IterationOrder::Alternating if self.turn % 2 == 1 => {
                problem.sweep(Visit::Forward, watch)
            }
            IterationOrder::Alternating => problem.sweep(Visit::Backward, watch),
            IterationOrder::Random { .. } => {
                self.shuffle(problem.contacts());
                problem.sweep(Visit::Listed(&self.permutation), watch);
            }
        }
    }

    /// A new permutation (Fisher and Yates).
    fn shuffle(&mut self, count: usize) {
        self.permutation.clear();
        self.permutation.extend(0..count as u32);
        for last in (1..count).rev() {
            // The upper half of the product has a bias of at most count/2⁶⁴.
            let drawn = (u128::from(self.random.bits()) * (last as u128 + 1)) >> 64;
            self.permutation.swap(last, drawn as usize);
        }
    }
}

/// Cost and result of an iteration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Iterations {
    /// Number of sweeps over all contacts, including other work of the same cost.
    pub sweeps: usize,
    /// Whether the stopping rule was met; always true for a fixed number of sweeps.
    pub met: bool,
}

/// Performs sweeps until `stop` is met, or `most` sweeps.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::{Iterations, IterationOrder, StopRule};
/// # use tribos::cd::internals::{Link, Spheres, Sweeper, solve};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let velocity = up * (-9.81 * dt);
/// # let ball = SphereBody { velocity, spin: Vector3::zeros(), inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let touch = ContactGeometry::spheres(&(up * 0.1), [0.05; 2])?;
/// # let contact = Contact::new(&touch, &law, &ball, &ball, dt);
/// # let mut column = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// # column.free = (vec![ball; 5], vec![floor]);
/// # (1..5).for_each(|top| column.join(&Link { bodies: [top - 1, top], contact }));
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # column.walls.push(Link { bodies: [0, 0], contact });
/// # column.start();
/// // A column of five balls of 1 kg: in any order of visits the floor comes to bear 5 kg.
/// for order in [IterationOrder::Fixed, IterationOrder::Alternating, IterationOrder::Random { seed: 1 }] {
///     let mut trial = column.clone();
///     let mut sweeper = Sweeper::new(order, 0);
///     let iterations = solve(&mut trial, &mut sweeper, StopRule::Global(1e-12), 1000);
///     assert!(iterations.met && iterations.sweeps < 1000);
///     let floor = trial.walls[0].contact.impulse().normal / dt;
///     assert!((floor - 5.0 * 9.81).abs() < 1e-6);
/// }
/// // A fixed number of sweeps is always done.
/// let mut sweeper = Sweeper::new(IterationOrder::Fixed, 0);
/// let iterations = solve(&mut column, &mut sweeper, StopRule::Fixed, 3);
/// assert_eq!(iterations, Iterations { sweeps: 3, met: true });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve<O: Operator>(
    problem: &mut O,
    sweeper: &mut Sweeper,
    stop: StopRule,
    most: usize,
) -> Iterations {
    for sweeps in 1..=most {
        let met = match stop {
            StopRule::Fixed => {
                sweeper.sweep(problem, &mut NoMonitor);
                false
            }
            StopRule::Local(tolerance) => {
                let mut watch = LocalChange::above(tolerance);
                sweeper.sweep(problem, &mut watch);
                watch.is_at_rest()
            }
            StopRule::Global(tolerance) => {
                let mut watch = GlobalChange::default();
                sweeper.sweep(problem, &mut watch);
                watch.relative_mean() <= tolerance
            }
        };
        if met {
            return Iterations { sweeps, met };
        }
    }
    Iterations {
        sweeps: most,
        met: stop == StopRule::Fixed,
    }
}
