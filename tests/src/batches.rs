//! Batches against single calls, to the bit: speeds in groups as the kernel takes them.

use crate::sweep::Lcg;
use tribos_core::coupling::{ReducedFriction, ReducedJacobian, RoundFriction};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Speeds that a kernel may take together.
pub const GROUP: usize = 8;
const RADIUS: f64 = 0.08;
const MU: f64 = 0.3;
const LOAD: f64 = 1.7;
/// Groups between two batches with every number of speeds left over.
const GROUPS: usize = 500;

/// Numbers out of the ordinary, for a precision's own ends.
fn odd<R: Real>(rng: &mut Lcg) -> R {
    let tiny = R::MIN_POSITIVE;
    let all = [
        R::ZERO,
        -R::ZERO,
        R::INFINITY,
        -R::INFINITY,
        R::NAN,
        tiny,
        tiny * R::HALF,
        tiny * R::EPSILON,
        R::ONE / tiny,
        R::from_f64(1e-150),
        R::from_f64(1e150),
        R::from_f64(1e-16),
        R::from_f64(1e17),
        R::ONE,
    ];
    all[rng.bits() as usize % all.len()]
}

/// Sliding speed and rim speed of a kind: ordinary, next to equal, alike in size, without spin.
fn ordinary<R: Real>(rng: &mut Lcg, kind: u64) -> [R; 2] {
    let slide = rng.log_between(1e-6, 1e6);
    let rim = match kind {
        0..=3 => rng.log_between(1e-6, 1e6),
        4 => {
            let apart = rng.log_between(1e-16, 0.5);
            slide * (1.0 + if rng.unit() < 0.5 { apart } else { -apart })
        }
        5 => slide * rng.between(0.0, 2.0),
        6 if rng.unit() < 0.25 => 0.0,
        6 => slide,
        _ => slide * rng.log_between(1e-30, 1e30),
    };
    [slide, rim].map(R::from_f64)
}

/// One group of speeds; in one of four groups some numbers are out of the ordinary.
pub fn speeds<R: Real>(rng: &mut Lcg) -> [[R; 2]; GROUP] {
    let kind = (rng.bits() >> 20) % 10;
    let is_odd = rng.unit() < 0.25;
    [(); GROUP].map(|()| {
        let mut pair = ordinary(rng, kind);
        if is_odd && rng.unit() < 0.3 {
            pair[rng.bits() as usize >> 9 & 1] = odd(rng);
        }
        pair
    })
}

/// Twists with these speeds in random directions.
fn twists<R: Real>(rng: &mut Lcg, speeds: &[[R; 2]]) -> Vec<Twist<R>> {
    let of = |&[slide, rim]: &[R; 2]| {
        let angle = rng.between(0.0, core::f64::consts::TAU);
        let (mut sin, mut cos) = libm::sincos(angle);
        match rng.bits() >> 40 & 15 {
            0 => (sin, cos) = (0.0, 1.0),
            1 => (sin, cos) = (-1.0, -0.0),
            _ => (),
        }
        let sense = if rng.unit() < 0.5 { 1.0 } else { -1.0 };
        let spin = rim * R::from_f64(sense / RADIUS);
        Twist::new(slide * R::from_f64(cos), slide * R::from_f64(sin), spin)
    };
    speeds.iter().map(of).collect()
}

fn bits<R: Real>(numbers: impl IntoIterator<Item = R>) -> impl Iterator<Item = u64> {
    numbers.into_iter().map(|number| number.to_f64().to_bits())
}

fn same<R: Real, const N: usize>(one: [R; N], batch: [R; N], at: impl core::fmt::Debug) {
    assert!(bits(one).eq(bits(batch)), "{at:?}: {one:?} {batch:?}");
}

fn of_wrench<R: Real>(wrench: &Wrench<R>) -> [R; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

/// Panics unless batches of at least `count` inputs have the bits of single calls.
pub fn compare<R: Real, C: ReducedFriction<R>>(coupling: &C, count: usize, seed: u64) {
    let [mu, radius, load] = [MU, RADIUS, LOAD].map(R::from_f64);
    let patch = RoundFriction::new(coupling, mu, radius).expect("in range");
    let mut rng = Lcg::new(seed);
    for round in 0..count.div_ceil(GROUPS * GROUP) {
        // Every length of what is left over, from slices of different lengths.
        let mut pairs: Vec<[R; 2]> = (0..GROUPS).flat_map(|_| speeds(&mut rng)).collect();
        pairs.truncate(pairs.len() - round % (GROUP + 1));
        let twists = twists(&mut rng, &pairs);
        let longer = twists.len() + round % 3;
        let mut wrenches = vec![Wrench::ZERO; longer];
        patch.wrench_batch(load, &twists, &mut wrenches);
        let mut jacobians = vec![WrenchJacobian::from_element(R::ZERO); longer];
        patch.jacobian_batch(load, &twists, &mut jacobians);
        for (twist, (wrench, jacobian)) in twists.iter().zip(wrenches.iter().zip(&jacobians)) {
            let one = patch.wrench(load, twist);
            same(of_wrench(&one), of_wrench(wrench), twist);
            let one = patch.wrench_jacobian(load, twist);
            assert!(
                bits(one.iter().copied()).eq(bits(jacobian.iter().copied())),
                "{twist:?}: {one:?} {jacobian:?}"
            );
        }
        compare_reduced(coupling, &pairs, round);
        for wrench in wrenches.iter().skip(twists.len()) {
            assert!(*wrench == Wrench::ZERO, "beyond the twists");
        }
    }
}

fn of_jacobian<R>(of: ReducedJacobian<R>) -> [R; 4] {
    [of.force_per_slide, of.force_slide, of.mixed, of.torque_rim]
}

fn compare_reduced<R: Real, C: ReducedFriction<R>>(coupling: &C, pairs: &[[R; 2]], round: usize) {
    let [slides, rims] = [0, 1].map(|i| pairs.iter().map(|pair| pair[i]).collect::<Vec<_>>());
    let count = pairs.len() - round % 2;
    let (mut forces, mut torques) = (vec![R::ONE; count + round % 2], vec![R::ONE; count]);
    coupling.reduced_wrench_batch(&slides, &rims, &mut forces, &mut torques);
    let mut jacobians = vec![ReducedJacobian::default(); count];
    coupling.reduced_jacobian_batch(&slides, &rims, &mut jacobians);
    let results = forces.iter().zip(&torques).zip(jacobians);
    for (&[slide, rim], ((&force, &torque), jacobian)) in pairs.iter().zip(results) {
        let one = coupling.reduced_wrench(slide, rim);
        same([one.force, one.torque], [force, torque], (slide, rim));
        let one = of_jacobian(coupling.reduced_jacobian(slide, rim));
        same(one, of_jacobian(jacobian), (slide, rim));
    }
    assert!(
        forces.iter().skip(count).all(|force| *force == R::ONE),
        "beyond the torques"
    );
}
