//! Gauss–Seidel sweeps with Nesterov's momentum.
//!
//! A sweep maps impulses y to x(y), and only a solution is mapped to itself. The next sweep starts from a
//! point extrapolated along the last step:
//!
//! ```text
//! y' = x + β (x − x₋),   β = (t − 1)/t',   t' = (1 + √(1 + 4 t²))/2
//! ```
//!
//! with x₋ the impulses of the sweep before (Nesterov 1983). When a sweep leads back, against
//! y − x₋, the momentum is reset (the gradient scheme of O'Donoghue and Candès, Found. Comput. Math.
//! 15 (2015) 715). Mazhar et al. (ACM Trans. Graph. 34 (2015) 32) applied the method to contacts with
//! projected gradients. Second: the gradient step is a sweep, which needs no step length;
//! every extrapolated impulse is first projected onto the impulses that its contact admits; a restart
//! halves the age t of the momentum instead of setting it to 1, because bounds that follow the normal
//! forces reverse sweeps more often than the curvature does; products count torques as forces at the
//! contact's lever.
//!
//! If friction is large, sweeps may cycle, with or without momentum: each contact responds to bounds that
//! depend on its own response. The method then continues with damped sweeps, y' = y + ω (x − y), which are
//! slower and converge.

use super::gauss_seidel::Iterations;
use super::operator::{GlobalChange, Impulse, Operator, Visit};

/// Buffers of the iteration, kept from step to step.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::{IterationOrder, StopRule};
/// # use tribos::cd::internals::{Accelerated, Tolerance, Link, Spheres, Sweeper, residual, solve};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let velocity = up * (-9.81 * dt);
/// # let ball = SphereBody { velocity, spin: Vector3::zeros(), inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let touch = ContactGeometry::spheres(&(up * 0.1), [0.05; 2])?;
/// # let contact = Contact::new(&touch, &law, &ball, &ball, dt);
/// # let mut column = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// # column.free = (vec![ball; 20], vec![floor]);
/// # (1..20).for_each(|top| column.join(&Link { bodies: [top - 1, top], contact }));
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # column.walls.push(Link { bodies: [0, 0], contact });
/// # column.start();
/// // The weight of a column of twenty balls has to find its way down. For the work of 100 sweeps
/// // momentum comes nearer to it than sweeps alone.
/// let mut swept = column.clone();
/// solve(&mut swept, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Fixed, 100);
/// let never = Tolerance { relative: 0.0, speed: 0.0 };
/// Accelerated::default().solve(&mut column, never, 100);
/// assert!(residual(&column).relative < 0.1 * residual(&swept).relative);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Accelerated<I> {
    /// Impulses x₋ after the previous sweep.
    swept: Vec<I>,
}

impl<I> Default for Accelerated<I> {
    fn default() -> Self {
        Self { swept: Vec::new() }
    }
}

/// Measured cost of an extrapolation (projection and new velocities), in sweeps.
const EXTRAPOLATION: usize = 1;
/// Factor that a restart applies to the age of the momentum: results are the same for 1/4 to 3/4.
const LEFT: f64 = 0.5;

/// Damping factor ω of the first and of the second half of the damped sweeps: of the cycles of a gas
/// with μ = 10, 0.5 leaves many and 0.2 few.
const DAMPED: [f64; 2] = [0.2, 0.05];
/// Sweeps cycle if their mean change in the second half of all sweeps exceeds this fraction of the mean
/// change in the quarter before; for convergence like 1/t the fraction is one half.
const CIRCLING: f64 = 0.7;

/// Sweeps that judge another solver's impulses.
const JUDGING: usize = 20;

/// Changes of the sweeps, which show whether they still decrease.
#[derive(Clone, Copy, Debug, Default)]
struct Progress {
    /// Sum and number of the changes, in the second quarter of all sweeps and in the second half.
    changes: [(f64, usize); 2],
}

impl Progress {
    fn see(&mut self, change: f64, sweeps: usize, most: usize) {
        let late = usize::from(sweeps > most / 2);
        if sweeps > most / 4 {
            self.changes[late].0 += change;
            self.changes[late].1 += 1;
        }
    }

    /// Whether the changes stay above the tolerance and no longer decrease.
    fn is_cycling(&self, goal: f64) -> bool {
        let [early, late] = self.changes.map(|(sum, count)| sum / count as f64);
        late > goal && late > CIRCLING * early
    }
}

/// Tolerance at which the iteration stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest root mean square of a sweep's change relative to P.
    pub relative: f64,
    /// Largest correction of the normal speed at any contact in a sweep. If heavy bodies lie on
    /// light ones, forces change slowly, and this criterion detects that they have not yet converged.
    pub speed: f64,
}

impl Tolerance {
    fn is_met(&self, change: &GlobalChange) -> bool {
        change.relative() <= self.relative && change.speed <= self.speed
    }
}

impl From<f64> for Tolerance {
    /// Tolerance for the relative change only.
    fn from(relative: f64) -> Self {
        Self {
            relative,
            speed: f64::INFINITY,
        }
    }
}

impl<I: Impulse> Accelerated<I> {
    /// Iterates until a sweep meets the tolerance, for at most `most` sweeps. An extrapolation counts as one.
    /// If the sweeps cycle, at most half as many damped sweeps follow.
    pub fn solve<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        goal: impl Into<Tolerance>,
        most: usize,
    ) -> Iterations {
        self.solve_or(problem, goal, most, |_| false)
    }

    /// [`Accelerated::solve`] with a `rescue`: another way to a solution, taken when all sweeps have missed the
    /// tolerance. It tells whether it has set the impulses; a few sweeps then judge them.
    pub fn solve_or<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        goal: impl Into<Tolerance>,
        most: usize,
        rescue: impl FnOnce(&mut O) -> bool,
    ) -> Iterations {
        let goal = goal.into();
        let mut end = self.iterate(problem, goal, most);
        if !end.met && rescue(problem) {
            end.met = self.verify_by_plain_sweeps(problem, goal, &mut end.sweeps);
        }
        end
    }

    /// Sweeps with momentum, then damped ones if they cycle.
    fn iterate<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        goal: Tolerance,
        most: usize,
    ) -> Iterations {
        let contacts = problem.contacts();
        self.swept.clear();
        self.swept
            .extend((0..contacts).map(|contact| problem.impulse(contact)));
        let mut age = 1.0_f64;
        let mut sweeps = 0;
        let mut progress = Progress::default();
        while sweeps < most {
            let mut change = GlobalChange::default();
            problem.sweep_on(&self.swept, &mut change);
            sweeps += 1;
            if goal.is_met(&change) {
                return Iterations { sweeps, met: true };
            }
            progress.see(change.relative(), sweeps, most);
            let older = 0.5 * (1.0 + (1.0 + 4.0 * age * age).sqrt());
            if change.along < 0.0 {
                age = (LEFT * age).max(1.0);
                self.restart_momentum(problem);
            } else {
                problem.extrapolate((age - 1.0) / older, &mut self.swept);
                age = older;
                sweeps += EXTRAPOLATION;
            }
        }
        if progress.is_cycling(goal.relative) {
            self.damp(problem, goal, sweeps, sweeps + most / 2)
        } else {
            Iterations { sweeps, met: false }
        }
    }

    /// A few plain sweeps from impulses that should solve the problem. Tells whether they meet the tolerance.
    fn verify_by_plain_sweeps<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        goal: Tolerance,
        sweeps: &mut usize,
    ) -> bool {
        for _ in 0..JUDGING {
            let mut change = GlobalChange::default();
            problem.sweep(Visit::Forward, &mut change);
            *sweeps += 1;
            if goal.is_met(&change) {
                return true;
            }
        }
        false
    }

    /// Continues with damped sweeps, up to a total of `most`.
    fn damp<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        goal: Tolerance,
        mut sweeps: usize,
        most: usize,
    ) -> Iterations {
        let middle = sweeps + (most - sweeps) / 2;
        while sweeps < most {
            let share = DAMPED[usize::from(sweeps > middle)];
            self.restart_momentum(problem);
            let mut change = GlobalChange::default();
            problem.sweep(Visit::Forward, &mut change);
            sweeps += 1;
            if goal.is_met(&change) {
                return Iterations { sweeps, met: true };
            }
            for (contact, start) in self.swept.iter().enumerate() {
                let step = problem.impulse(contact).plus_scaled(-1.0, start);
                problem.guess(contact, &start.plus_scaled(share, &step));
            }
            problem.refresh();
            sweeps += EXTRAPOLATION;
        }
        Iterations { sweeps, met: false }
    }

    /// Continues from the result of the sweep, without extrapolation.
    fn restart_momentum<O: Operator<Impulse = I>>(&mut self, problem: &O) {
        for (contact, swept) in self.swept.iter_mut().enumerate() {
            *swept = problem.impulse(contact);
        }
    }
}
