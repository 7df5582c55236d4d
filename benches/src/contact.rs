//! A contact with its dimensions: one call a twist against the batch.

use crate::mix::Lcg;
use core::f64::consts::TAU;
use std::hint::black_box;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Why the contact of the benches could not be made; it does not happen.
type Refused = Box<dyn core::error::Error>;

/// Radius, coefficient and load of the contact.
const RADIUS: f64 = 0.08;
const MU: f64 = 0.3;
const LOAD: f64 = 1.7;

/// A disk of radius 8 cm with μ = 0.3 under many twists.
#[derive(Clone, Debug)]
pub struct Contact<R: Real, C> {
    disk: RoundFriction<R, C>,
    twists: Vec<Twist<R>>,
    wrenches: Vec<Wrench<R>>,
    jacobians: Vec<WrenchJacobian<R>>,
}

impl<R: Real, C: ReducedFriction<R>> Contact<R, C> {
    /// Twists with the speeds of `pairs`.
    pub fn new(coupling: C, pairs: &[[f64; 2]], seed: u64) -> Result<Self, Refused> {
        let radius = R::from_f64(RADIUS);
        let twists = twists(pairs, seed);
        Ok(Self {
            disk: RoundFriction::new(coupling, R::from_f64(MU), radius)?,
            wrenches: vec![Wrench::ZERO; twists.len()],
            jacobians: vec![WrenchJacobian::from_element(R::ZERO); twists.len()],
            twists,
        })
    }

    /// One call per twist, each hidden from the optimiser.
    pub fn one_by_one(&mut self) -> &[Wrench<R>] {
        let load = R::from_f64(LOAD);
        for (twist, wrench) in self.twists.iter().zip(&mut self.wrenches) {
            *wrench = black_box(self.disk.wrench(load, black_box(twist)));
        }
        &self.wrenches
    }

    /// All twists in one call.
    pub fn batch(&mut self) -> &[Wrench<R>] {
        let (twists, wrenches) = (black_box(&self.twists), black_box(&mut self.wrenches));
        self.disk.wrench_batch(R::from_f64(LOAD), twists, wrenches);
        &self.wrenches
    }

    /// The Jacobian of every twist, each call hidden from the optimiser.
    pub fn jacobians(&mut self) -> &[WrenchJacobian<R>] {
        let load = R::from_f64(LOAD);
        for (twist, jacobian) in self.twists.iter().zip(&mut self.jacobians) {
            *jacobian = black_box(self.disk.wrench_jacobian(load, black_box(twist)));
        }
        &self.jacobians
    }

    /// The Jacobians of all twists in one call.
    pub fn jacobian_batch(&mut self) -> &[WrenchJacobian<R>] {
        let (twists, jacobians) = (black_box(&self.twists), black_box(&mut self.jacobians));
        self.disk
            .jacobian_batch(R::from_f64(LOAD), twists, jacobians);
        &self.jacobians
    }

    /// Panics unless both ways agree to the bit.
    pub fn assert_right(&mut self) {
        let single = self.one_by_one().to_vec();
        assert!(
            single == self.batch(),
            "the batch differs from single calls"
        );
        let single = self.jacobians().to_vec();
        assert!(
            single == self.jacobian_batch(),
            "the batch of Jacobians differs from single calls"
        );
    }
}

/// Twists with the speeds of `pairs` in random directions of sliding and spin.
fn twists<R: Real>(pairs: &[[f64; 2]], seed: u64) -> Vec<Twist<R>> {
    let mut random = Lcg::new(seed);
    let twist = |&[slide, rim]: &[f64; 2]| {
        let angle = random.uniform(0.0, TAU);
        let sense = if random.unit() < 0.5 { -1.0 } else { 1.0 };
        let components = [
            slide * angle.cos(),
            slide * angle.sin(),
            sense * rim / RADIUS,
        ];
        let [x, y, spin] = components.map(R::from_f64);
        Twist::new(x, y, spin)
    };
    pairs.iter().map(twist).collect()
}
