//! How far impulses and velocities are from obeying the laws, judged without the solver's code.
//!
//! Velocities are worked out anew from the impulses. Each law is read as a set: what it asks of a
//! contact is written down here once more, from the formulas, not through [`Contact::update`].

use super::operator::Operator;
use super::spheres::{Link, Spheres};
use nalgebra::Vector3;
use tribos_core::contact::{AxialPart, ContactFriction, Modal, Modes, PlanarPart, Thresholds};

/// Violation of the contact laws. *Units*: those of the problem.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residual {
    /// Largest speed at which a closed contact still closes; times the step, the overlap made in it.
    pub penetration: f64,
    /// Largest friction impulse beyond its threshold, or pull beyond cohesion.
    pub excess: f64,
    /// Largest |P · U| of contacts that push and part, as a power times time: energy.
    pub complementarity: f64,
    /// √(Σ|p − proj(p − m U)|²/ΣP²) over all modes, torques as forces at the lever: 0 for a solution.
    pub relative: f64,
}

/// Coefficients of friction as the residual needs them.
pub trait Coefficients {
    /// μ, μ_t and μ_n.
    fn coefficients(&self) -> [f64; 3];
}

impl<M> Coefficients for Thresholds<f64, M> {
    fn coefficients(&self) -> [f64; 3] {
        [self.mu(), self.mu_rolling(), self.mu_torsion()]
    }
}

/// Judges a problem with independent thresholds.
pub fn residual<F>(problem: &Spheres<F>) -> Residual
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut fresh = problem.clone();
    fresh.refresh();
    let mut sum = Sum::default();
    let [pair, wall] = [&problem.friction[0], &problem.friction[1]].map(Coefficients::coefficients);
    for link in &fresh.pairs {
        let [a, b] = link.bodies.map(|body| &fresh.spheres[body as usize]);
        sum.add(link, &link.contact.velocity(a, b), pair);
    }
    for link in &fresh.walls {
        let [a, b] = link.bodies.map(|body| body as usize);
        let velocity = link.contact.velocity(&fresh.spheres[a], &fresh.plates[b]);
        sum.add(link, &velocity, wall);
    }
    sum.finish()
}

#[derive(Default)]
struct Sum {
    residual: Residual,
    map_sq: f64,
    bound_sq: f64,
}

impl Sum {
    fn add<M: Modes<f64>>(&mut self, link: &Link<M>, u: &Modal<f64, M>, [mu, mu_t, mu_n]: [f64; 3]) {
        let contact = &link.contact;
        let (p, block, lever) = (contact.impulse(), contact.block(), contact.lever());
        let (bound, gap_speed) = (contact.bound(), u.normal + contact.allowance());
        let r = &mut self.residual;

        // 0 ≤ P ⟂ U + allowance ≥ 0; a resistance may also rest with the gap open.
        let rests = contact.rests_open() && gap_speed >= 0.0;
        let normal = if rests {
            resting(p.normal, u.normal, contact.cohesion(), block.mass_normal)
        } else {
            bound - (bound - block.mass_normal * gap_speed).max(0.0)
        };
        r.penetration = r.penetration.max(-gap_speed);
        r.excess = r.excess.max(-bound);
        if !rests {
            r.complementarity = r.complementarity.max((bound * gap_speed).abs());
        }

        // Friction: p is the point of the disc nearest to p − m U.
        let sliding = disc(p.sliding.vector(), u.sliding.vector(), block.mass_sliding, mu * bound);
        let rolling = disc(p.rolling.vector(), u.rolling.vector(), block.inertia, mu_t * bound * lever);
        let (torsion, spin) = (p.torsion.component(), u.torsion.component());
        let limit = (mu_n * bound * lever).max(0.0);
        let mut twist = 0.0;
        if M::Torsion::PRESENT {
            twist = torsion - (torsion - block.inertia * spin).clamp(-limit, limit);
            r.excess = r.excess.max((torsion.abs() - limit) / lever);
        }
        let mut map_sq = normal * normal;
        if M::Sliding::PRESENT {
            map_sq += sliding.0.norm_squared();
            r.excess = r.excess.max(sliding.1);
        }
        if M::Rolling::PRESENT {
            map_sq += rolling.0.norm_squared() / (lever * lever);
            r.excess = r.excess.max(rolling.1 / lever);
        }
        self.map_sq += map_sq + twist * twist / (lever * lever);
        self.bound_sq += bound * bound;
    }

    fn finish(self) -> Residual {
        let relative = if self.map_sq == 0.0 {
            0.0
        } else {
            (self.map_sq / self.bound_sq).sqrt()
        };
        Residual {
            relative,
            ..self.residual
        }
    }
}

/// Natural map of a contact that rests open: −C ≤ p ≤ 0, p = −C where it opens, 0 where it closes.
fn resting(p: f64, u: f64, cohesion: f64, mass: f64) -> f64 {
    p - (p - mass * u).clamp(-cohesion, 0.0)
}

/// Natural map of a disc, and how far the point lies outside.
fn disc(p: Vector3<f64>, u: Vector3<f64>, mass: f64, limit: f64) -> (Vector3<f64>, f64) {
    let trial = p - u * mass;
    let (size, limit) = (trial.norm(), limit.max(0.0));
    let nearest = if size > limit { trial * (limit / size) } else { trial };
    (p - nearest, p.norm() - limit)
}
