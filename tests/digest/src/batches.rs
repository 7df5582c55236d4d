//! Bits of batches: on every platform those of its single calls.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, arguments, ends, twist};
use tribos_core::coupling::round::{RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::coupling::{ReducedFriction, ReducedJacobian, ReducedWrench, RoundFriction};
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;
use tribos_core::twist::{Wrench, WrenchJacobian};

/// Speeds of a batch: not a whole number of groups.
const SPEEDS: usize = 43;
/// Batches of each table.
const BATCHES: u64 = 12;

/// Digest of batches in both precisions.
pub fn batches() -> u64 {
    let mut hash = Fnv::new();
    hash.feed(in_both(dry::<f64>, dry::<f32>));
    for alpha in [-0.75, 0.375, 1.0] {
        of(&mut hash, &DiskTable64::new(alpha).expect("in range"));
        of(
            &mut hash,
            &DiskTable32::new(alpha as f32).expect("in range"),
        );
        let hertz = RoundTable64::new(alpha, PowerPressure::HERTZ).expect("in range");
        of(&mut hash, &hertz);
        let hertz = RoundTable32::new(alpha as f32, PowerPressure::HERTZ).expect("in range");
        of(&mut hash, &hertz);
    }
    hash.0
}

fn dry<R: Real>(hash: &mut Fnv) {
    of::<R, _>(hash, &table::CoulombDisk);
}

fn of<R: Real, C: ReducedFriction<R>>(hash: &mut Fnv, coupling: &C) {
    let [coefficient, radius, load] = [0.3, 0.0625, 1.75].map(R::from_f64);
    let patch = RoundFriction::new(coupling, coefficient, radius).expect("in range");
    for seed in 0..BATCHES {
        let (mut slides, mut rims) = ([R::ZERO; SPEEDS], [R::ZERO; SPEEDS]);
        let speeds = slides.iter_mut().zip(&mut rims);
        for ((slide, rim), pair) in speeds.zip(arguments(seed + 211, SPEEDS)) {
            (*slide, *rim) = pair;
        }
        let mut rng = Lcg::new(seed + 223);
        let mut twists = [(); SPEEDS].map(|()| twist::<R>(&mut rng));
        // The last group meets a number out of the ordinary.
        if let Some(&end) = ends::<R>().get(seed as usize) {
            (slides[SPEEDS - 5], twists[SPEEDS - 5].spin) = (end, end);
        }
        reduced(hash, coupling, &slides, &rims);
        let (vx, vy) = (
            twists.map(|twist| twist.velocity.x),
            twists.map(|twist| twist.velocity.y),
        );
        let spins = twists.map(|twist| twist.spin);
        let [mut fx, mut fy, mut torques] = [[R::ZERO; SPEEDS]; 3];
        patch.wrench_columns(load, [&vx, &vy, &spins], [&mut fx, &mut fy, &mut torques]);
        for ((fx, fy), torque) in fx.into_iter().zip(fy).zip(torques) {
            hash.wrench(&Wrench::new(fx, fy, torque));
        }
        let mut jacobians = [WrenchJacobian::from_element(R::ZERO); SPEEDS];
        patch.jacobian_batch(load, &twists, &mut jacobians);
        for jacobian in jacobians {
            hash.numbers(jacobian.iter().copied());
        }
    }
}

fn reduced<R: Real, C: ReducedFriction<R>>(hash: &mut Fnv, coupling: &C, slides: &[R], rims: &[R]) {
    let (mut forces, mut torques) = ([R::ZERO; SPEEDS], [R::ZERO; SPEEDS]);
    coupling.reduced_wrench_batch(slides, rims, &mut forces, &mut torques);
    let mut jacobians = [ReducedJacobian::default(); SPEEDS];
    coupling.reduced_jacobian_batch(slides, rims, &mut jacobians);
    for ((force, torque), jacobian) in forces.into_iter().zip(torques).zip(jacobians) {
        hash.reduced(ReducedWrench { force, torque }, jacobian);
    }
}
