//! One sliding, spinning disk: a step of one millisecond, and the whole motion to rest.

mod settings;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::stepping::{DISK, SPEED, SPINS};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// The step of an engine, in s.
const STEP: f64 = 1e-3;
/// Largest accepted speed error of a second-order step of 1 ms, in m/s.
const VERLET_ERROR: f64 = 1e-6;

fn slider(criterion: &mut Criterion) {
    let disk = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: DISK.deceleration,
            radius: DISK.radius,
            inertia_ratio: DISK.inertia_ratio,
        },
    )
    .expect("the disk of the front is valid");
    let mut group = criterion.benchmark_group("slider");
    for spin in SPINS {
        let launch = SliderState::launched(SPEED, spin);
        let exact = disk.advance(&launch, STEP).motion;
        let verlet = disk.verlet_step(&launch, STEP);
        assert!((exact.speed - verlet.speed).abs() < VERLET_ERROR);
        assert!(disk.to_rest(&launch).is_some());

        group.bench_function(BenchmarkId::new("advance 1 ms", spin), |bencher| {
            bencher.iter(|| disk.advance(black_box(&launch), black_box(STEP)));
        });
        group.bench_function(BenchmarkId::new("verlet 1 ms", spin), |bencher| {
            bencher.iter(|| disk.verlet_step(black_box(&launch), black_box(STEP)));
        });
        group.bench_function(BenchmarkId::new("to_rest", spin), |bencher| {
            bencher.iter(|| disk.to_rest(black_box(&launch)));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = slider
}
criterion_main!(benches);
