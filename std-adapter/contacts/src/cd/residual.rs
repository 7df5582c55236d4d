//! Violation of the contact laws by impulses and velocities, judged without the solver's code.
//!
//! Velocities are recomputed from the impulses. Each law is treated as a set: its conditions on a
//! contact are implemented here a second time, from the formulas, not through [`Contact::update`].
//!
//! Each bound P is held where [`crate::problem::residual`] moves it with the normal impulse: any convex set, and a gap
//! that a resistance holds open, have a map then. Both are zero for the same impulses; their sizes differ.

use super::cell::CellBody;
use super::operator::largest;
use super::spheres::{Link, Spheres};
use nalgebra::Vector3;
use std::any::TypeId;
use tribos_core::contact::{
    Contact, ContactFriction, ContactModes, ContactVector, CoupledFriction, IndependentFriction,
    SphereBody, WallBody,
};
use tribos_core::internals::{AxialPart, PlanarPart};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid};
use tribos_core::twist::{Twist, Wrench};

/// Violation of the contact laws. *Units*: those of the problem.
///
/// See [`residual`] for an example.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactResidual {
    /// Largest closing speed of a closed contact; multiplied by the step, the overlap that it creates.
    pub penetration: f64,
    /// Largest friction impulse in excess of its threshold, or pull in excess of cohesion.
    pub excess: f64,
    /// Largest |P · U| of contacts that push while they separate, an energy (impulse times speed).
    pub complementarity: f64,
    /// √(Σ|p − proj(p − m U)|²/ΣP²) over all modes, with torques as forces at the lever: 0 for a solution.
    pub relative: f64,
}

/// Friction coefficients in the form that the residual needs.
///
/// ```
/// use tribos::cd::internals::Coefficients;
/// use tribos::kernel::contact::{AllModes, CoupledFriction, IndependentFriction};
/// use tribos::kernel::limit_surface::LimitEllipsoid;
/// let apart = IndependentFriction::<f64, AllModes>::all(0.3, 0.1, 0.05)?;
/// assert_eq!(apart.coefficients(), [0.3, 0.1, 0.05]);
/// assert!(apart.joint().is_none());
/// // A round contact of half the effective radius: μ_n is 2/3 of μ/2 under uniform pressure.
/// let together = CoupledFriction::all(LimitEllipsoid::new(0.3, 0.5, 2.0 / 3.0)?, 0.1)?;
/// assert!((together.coefficients()[2] - 0.1).abs() < 1e-15);
/// assert!(together.joint().is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Coefficients {
    /// Coefficients μ, μ_t and μ_n.
    fn coefficients(&self) -> [f64; 3];

    /// The set of sliding forces and torsion torques for P = 1 and r_eff = 1, if sliding and torsion have
    /// a common threshold.
    fn joint(&self) -> Option<&dyn FrictionSet<f64>> {
        None
    }

    /// Whether that set is an ellipsoid.
    fn is_ellipsoid(&self) -> bool {
        false
    }
}

impl<S: FrictionSet<f64> + 'static, M> Coefficients for CoupledFriction<f64, S, M> {
    fn coefficients(&self) -> [f64; 3] {
        [self.mu(), self.mu_rolling(), self.mu_torsion()]
    }

    fn joint(&self) -> Option<&dyn FrictionSet<f64>> {
        Some(self.set())
    }

    fn is_ellipsoid(&self) -> bool {
        TypeId::of::<S>() == TypeId::of::<LimitEllipsoid<f64>>()
    }
}

impl<M> Coefficients for IndependentFriction<f64, M> {
    fn coefficients(&self) -> [f64; 3] {
        [self.mu(), self.mu_rolling(), self.mu_torsion()]
    }
}

/// Computes the residual of a contact problem.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::{IterationOrder, ContactResidual, StopRule};
/// # use tribos::cd::internals::{Link, Spheres, Sweeper, residual, solve};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let (spin, velocity) = (Vector3::zeros(), Vector3::new(1.0, 0.0, -2.0));
/// # let ball = SphereBody { velocity, spin, inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # let mut problem = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// # problem.free = (vec![ball], vec![floor]);
/// # problem.walls.push(Link { bodies: [0, 0], contact });
/// # problem.start();
/// // A ball that comes down at 2 m/s and slides: without an impulse it would enter the floor.
/// assert_eq!(residual(&problem).penetration, 2.0);
/// solve(&mut problem, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Fixed, 1);
/// let left: ContactResidual = residual(&problem);
/// assert!(left.relative < 1e-15 && left.penetration <= 0.0 && left.excess < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn residual<F>(problem: &Spheres<F>) -> ContactResidual
where
    F: ContactFriction<f64> + Coefficients,
{
    let (spheres, plates) = velocities(problem);
    let mut sum = Sum::default();
    let mut images = problem.images.iter().enumerate().peekable();
    // A cell that deforms moves its images as the impulses say.
    let cell = problem.cell.clone().map(|cell| CellBody {
        speeds: problem.cell_speeds(&cell),
        ..cell
    });
    for (number, link) in problem.pairs.iter().enumerate() {
        let [a, b] = link.bodies.map(|body| spheres[body as usize]);
        // An image moves faster than its sphere.
        let faster = images.next_if(|(_, (pair, _))| *pair as usize == number);
        let velocity = faster.map_or(b.velocity, |(image, (_, velocity))| {
            let moved = cell.as_ref().map(|cell| cell.image(&cell.periods[image]));
            b.velocity + moved.unwrap_or(*velocity)
        });
        let b = SphereBody { velocity, ..b };
        sum.add(
            &link,
            &link.contact.velocity(&a, &b),
            problem.pair_friction(link.bodies),
        );
    }
    for (wall, link) in problem.walls.iter().enumerate() {
        let sphere = &spheres[link.bodies[0] as usize];
        let velocity = problem.velocity_at_wall(wall, (sphere, &plates));
        sum.add(link, &velocity, problem.wall_friction(link.bodies));
    }
    sum.finish()
}

/// Bodies with the velocities that follow from the impulses, in the order of the contacts.
fn velocities<F: ContactFriction<f64>>(
    problem: &Spheres<F>,
) -> (Vec<SphereBody<f64>>, Vec<WallBody<f64>>) {
    let (mut spheres, mut plates) = problem.free.clone();
    for Link { bodies, contact } in problem.pairs.iter() {
        let bodies = bodies.map(|body| body as usize);
        if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
            contact.apply(contact.impulse(), a, b);
        }
    }
    for (wall, Link { bodies, contact }) in problem.walls.iter().enumerate() {
        let [a, b] = bodies.map(|body| body as usize);
        if let (Some(a), Some(surface)) = (spheres.get_mut(a), problem.surface(wall)) {
            contact.apply(contact.impulse(), a, &mut { *surface });
        } else if let (Some(a), Some(b)) = (spheres.get_mut(a), plates.get_mut(b)) {
            contact.apply(contact.impulse(), a, b);
        }
    }
    (spheres, plates)
}

#[derive(Default)]
struct Sum {
    residual: ContactResidual,
    map_sq: f64,
    bound_sq: f64,
}

impl Sum {
    fn add<M: ContactModes<f64>>(
        &mut self,
        link: &Link<M>,
        u: &ContactVector<f64, M>,
        friction: &impl Coefficients,
    ) {
        let [mu, mu_t, mu_n] = friction.coefficients();
        let contact = &link.contact;
        let (p, block, lever) = (
            contact.impulse(),
            contact.block(),
            contact.effective_radius(),
        );
        let (bound, gap_speed) = (contact.bound(), u.normal + contact.approach_limit());
        let r = &mut self.residual;

        // 0 ≤ P ⟂ U + allowance ≥ 0; a contact under a resistance may also rest with an open gap.
        let rests = contact.holds_gap_open() && gap_speed >= 0.0;
        let normal = if rests {
            resting(p.normal, u.normal, contact.cohesion(), block.mass_normal)
        } else {
            bound - (bound - block.mass_normal * gap_speed).max(0.0)
        };
        r.penetration = largest(r.penetration, -gap_speed);
        r.excess = largest(r.excess, -bound);
        if !rests {
            r.complementarity = largest(r.complementarity, (bound * gap_speed).abs());
        }

        let mut map_sq = normal * normal;
        let mut excess = 0.0_f64;
        if M::Rolling::PRESENT {
            let limit = mu_t * bound * lever;
            let (p, u) = (p.rolling(), u.rolling());
            let (map, beyond) = disc(p, u, block.inertia, limit);
            map_sq += map.norm_squared() / (lever * lever);
            excess = largest(excess, beyond / lever);
        }
        if let Some(set) = friction.joint() {
            let (joint_sq, beyond) = joint(set, contact, u);
            map_sq += joint_sq;
            excess = largest(excess, beyond);
        } else {
            if M::Sliding::PRESENT {
                let (p, u) = (p.sliding(), u.sliding());
                let (map, beyond) = disc(p, u, block.mass_sliding, mu * bound);
                map_sq += map.norm_squared();
                excess = largest(excess, beyond);
            }
            if M::Torsion::PRESENT {
                let (p, spin) = (p.torsion(), u.torsion());
                let limit = (mu_n * bound * lever).max(0.0);
                let map = p - (p - block.inertia * spin).clamp(-limit, limit);
                let reduced = map / lever;
                map_sq += reduced * reduced;
                excess = largest(excess, (p.abs() - limit) / lever);
            }
        }
        self.residual.excess = largest(self.residual.excess, excess);
        self.map_sq += map_sq;
        self.bound_sq += bound * bound;
    }

    fn finish(self) -> ContactResidual {
        let relative = if self.map_sq == 0.0 {
            0.0
        } else {
            (self.map_sq / self.bound_sq).sqrt()
        };
        ContactResidual {
            relative,
            ..self.residual
        }
    }
}

/// Natural map of a contact at rest with an open gap: −C ≤ p ≤ 0, p = −C if it opens, 0 if it closes.
fn resting(p: f64, u: f64, cohesion: f64, mass: f64) -> f64 {
    p - (p - mass * u).clamp(-cohesion, 0.0)
}

/// Natural map of a disc, and the distance of the point beyond it.
fn disc(p: Vector3<f64>, u: Vector3<f64>, mass: f64, limit: f64) -> (Vector3<f64>, f64) {
    let trial = p - u * mass;
    let (size, limit) = (trial.norm(), limit.max(0.0));
    let nearest = if size > limit {
        trial * (limit / size)
    } else {
        trial
    };
    (p - nearest, p.norm() - limit)
}

/// Sliding and torsion with a common threshold, without its projection: an upper bound of the square of the
/// natural map, and the distance of the pair beyond the set.
///
/// With y = proj(p − m U) the map p − y is at most m U, and |p − y|² ≤ m δ, where δ is the difference
/// between the power of friction and the largest possible, P·support(U) + p·U: a relation between the
/// nearest point and the support of a convex set.
fn joint<M: ContactModes<f64>>(
    set: &dyn FrictionSet<f64>,
    contact: &Contact<f64, M>,
    u: &ContactVector<f64, M>,
) -> (f64, f64) {
    let (p, block) = (contact.impulse(), contact.block());
    let (bound, lever) = (contact.bound().max(0.0), contact.effective_radius());
    let (slip, spin) = (u.sliding(), u.torsion());
    let (force, torque) = (p.sliding(), p.torsion());
    let power = bound * set.support(&Twist::new(slip.norm(), 0.0, spin * lever));
    let short = power + force.dot(&slip) + torque * spin;
    let energy = block.mass_sliding * slip.norm_squared() + block.inertia * spin * spin;
    let map_sq = block.mass_sliding * energy.min(short.abs());
    let gauge = set.gauge(&Wrench::new(force.norm(), 0.0, torque / lever));
    // The gauge of the zero wrench is 0 for any bound.
    let beyond = if gauge == 0.0 {
        0.0
    } else {
        (gauge - bound) * set.force_limit()
    };
    (map_sq, beyond)
}
