//! The four derivatives of force and torque, by tier.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::mix;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{ReducedFriction, ReducedJacobian, compact, coulomb};
use tribos_core::law;
use tribos_core::real::Real;

const SEED: u64 = 1;
/// Relative step of the central differences that check the derivatives, and what they can err by
/// where the derivatives bend slowly.
const STEP: f64 = 1e-5;
const CHECK: f64 = 1e-4;

/// Compares ∂F/∂v and ∂T/∂w with central differences at one moderate pair.
fn assert_right<C: ReducedFriction<f64>>(coupling: &C) {
    let (v, w) = (0.4, 1.0);
    let at = |v, w| coupling.reduced_wrench(v, w);
    let force = (at(v + STEP, w).force - at(v - STEP, w).force) / (2.0 * STEP);
    let torque = (at(v, w + STEP).torque - at(v, w - STEP).torque) / (2.0 * STEP);
    let found = coupling.reduced_jacobian(v, w);
    assert!((found.force_slide - force).abs() < CHECK, "dF/dv");
    assert!((found.torque_rim - torque).abs() < CHECK, "dT/dw");
}

fn time<R: Real>(
    criterion: &mut Criterion,
    name: &str,
    pairs: &[[R; 2]],
    c: &impl ReducedFriction<R>,
) {
    let mut results = vec![ReducedJacobian::default(); pairs.len()];
    let mut group = criterion.benchmark_group("jacobian");
    group.throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
        bencher.iter(|| {
            for (&[slide, rim], result) in black_box(pairs).iter().zip(&mut results) {
                *result = c.reduced_jacobian(slide, rim);
            }
            black_box(&mut results);
        });
    });
    group.finish();
}

fn jacobian(criterion: &mut Criterion) {
    let pairs = mix::long_pairs(SEED);
    let narrow = mix::narrowed(&pairs);
    let few: Vec<_> = pairs.iter().step_by(10).copied().collect();
    let half = DiskTable64::new(0.5).expect("1/2 is a valid exponent");
    let power = compact::CompactPower::new(0.5).expect("1/2 is a valid exponent");
    let law = law::CoulombLaw::new(1.0).expect("1 is a valid coefficient");
    let quadrature = DiskQuadrature::new(law);
    assert_right(&coulomb::CoulombDisk);
    assert_right(&half);
    assert_right(&power);
    assert_right(&quadrature);

    time(criterion, "form", &pairs, &coulomb::CoulombDisk);
    time(criterion, "form f32", &narrow, &coulomb::CoulombDisk);
    time(criterion, "table alpha 0.5", &pairs, &half);
    time(criterion, "compact alpha 0.5", &few, &power);
    time(criterion, "quadrature", &few, &quadrature);
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = jacobian
}
criterion_main!(benches);
