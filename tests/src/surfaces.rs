//! Shared parts of the tests of friction sets: wrenches, norms, special couplings.

use crate::sweep::Lcg;
use std::cell::Cell;
use tribos_core::Real;
use tribos_core::coupling::{
    DryReducedFriction, PowerLawFriction, ReducedFriction, ReducedJacobian, ReducedWrench,
};
use tribos_core::internals::CompleteElliptic;
use tribos_core::internals::Speeds;
use tribos_core::twist::Wrench;

/// Force limit μN in N, and radius R in m, of every set with dimensions; neither is a power of two.
pub const FORCE_LIMIT: f64 = 0.51;
/// See [`FORCE_LIMIT`].
pub const RADIUS: f64 = 0.04;

/// Inner product of two wrenches, with torques divided by `length`.
pub fn inner(a: &Wrench<f64>, b: &Wrench<f64>, length: f64) -> f64 {
    a.force.dot(&b.force) + a.torque / length * (b.torque / length)
}

/// Norm of a wrench, with the torque divided by `length`.
pub fn norm(a: &Wrench<f64>, length: f64) -> f64 {
    a.force.x.hypot(a.force.y).hypot(a.torque / length)
}

/// True if every component has the same bit pattern.
pub fn same_bits(a: &Wrench<f64>, b: &Wrench<f64>) -> bool {
    [
        (a.force.x, b.force.x),
        (a.force.y, b.force.y),
        (a.torque, b.torque),
    ]
    .iter()
    .all(|(a, b)| a.to_bits() == b.to_bits())
}

/// A wrench in a random direction, one in four near a pole or on it; force and torque/`RADIUS` over
/// `FORCE_LIMIT` have the joint norm `size`.
pub fn random_wrench(rng: &mut Lcg, size: f64) -> Wrench<f64> {
    use std::f64::consts::{FRAC_PI_2, TAU};
    let tilt = match rng.bits() >> 60 {
        0 => 0.0,
        1 => FRAC_PI_2,
        2 => rng.log_between(1e-18, 1.0),
        3 => FRAC_PI_2 - rng.log_between(1e-18, 1.0),
        _ => rng.between(0.0, FRAC_PI_2),
    };
    let turn = rng.between(0.0, TAU);
    let force = size * FORCE_LIMIT * if tilt == FRAC_PI_2 { 0.0 } else { tilt.cos() };
    let torque = size * FORCE_LIMIT * RADIUS * tilt.sin();
    let sign = if rng.unit() < 0.5 { 1.0 } else { -1.0 };
    Wrench::new(force * turn.cos(), force * turn.sin(), sign * torque)
}

/// Coulomb friction of a ring: D = (2/π)(2E − (1−h²)K) of the larger speed. At equal speeds the
/// slopes have a logarithmic singularity.
#[derive(Clone, Copy, Debug)]
pub struct Ring;

impl DryReducedFriction<f64> for Ring {}

impl ReducedFriction<f64> for Ring {
    fn reduced_wrench(&self, slide: f64, rim: f64) -> ReducedWrench<f64> {
        let (slide, rim) = (slide.abs(), rim.abs());
        if slide == 0.0 && rim == 0.0 {
            return ReducedWrench::default();
        }
        let (force, torque) = if slide > rim {
            ring_factors(rim / slide)
        } else {
            let (torque, force) = ring_factors(slide / rim);
            (force, torque)
        };
        ReducedWrench { force, torque }
    }

    fn reduced_jacobian(&self, slide: f64, rim: f64) -> ReducedJacobian<f64> {
        let (slide, rim) = (slide.abs(), rim.abs());
        let major = slide.max(rim);
        let (a, b) = (slide / major, rim / major);
        let h = a * b;
        let rate = CompleteElliptic::new((1.0 - h) * (1.0 + h)).d * std::f64::consts::FRAC_2_PI;
        ReducedJacobian {
            force_per_slide: self.reduced_wrench(slide, rim).force / slide,
            force_slide: b * b * rate / major,
            mixed: -h * rate / major,
            torque_rim: a * a * rate / major,
        }
    }
}

/// Dominant and minor component, (2/π) E and (2/π) h B.
fn ring_factors(h: f64) -> (f64, f64) {
    let integrals = CompleteElliptic::new((1.0 - h) * (1.0 + h));
    let unit = std::f64::consts::FRAC_2_PI;
    (unit * integrals.e(), unit * h * integrals.b)
}

/// A coupling that counts its evaluations.
#[derive(Debug)]
pub struct Counting<C> {
    coupling: C,
    calls: Cell<u32>,
}

impl<C> Counting<C> {
    /// Counts the evaluations of `coupling`.
    pub fn new(coupling: C) -> Self {
        Self {
            coupling,
            calls: Cell::new(0),
        }
    }

    /// Number of wrenches and Jacobians since the last call.
    pub fn take(&self) -> u32 {
        self.calls.replace(0)
    }
}

impl<R: Real, C: DryReducedFriction<R>> DryReducedFriction<R> for Counting<C> {}

impl<R: Real, C: ReducedFriction<R>> ReducedFriction<R> for Counting<C> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        self.calls.set(self.calls.get() + 1);
        self.coupling.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        self.calls.set(self.calls.get() + 1);
        self.coupling.reduced_jacobian(slide, rim)
    }
}

impl<R: Real, C: PowerLawFriction<R>> PowerLawFriction<R> for Counting<C> {
    fn exponent(&self) -> R {
        self.coupling.exponent()
    }
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.calls.set(self.calls.get() + 1);
        self.coupling.factors(at)
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        self.calls.set(self.calls.get() + 1);
        self.coupling.inertia_excess(at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        self.coupling.inertia_ends()
    }
}
