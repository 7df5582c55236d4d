//! Cost of building a table of a new exponent at run time.

mod settings;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};

/// Exponents whose build may differ in cost: terms fall quickly, slowly, or end.
const EXPONENTS: [f64; 4] = [-0.5, 0.5, 3.0, 10.0];

fn build(criterion: &mut Criterion) {
    // α = 1 is linear: F = v, T = w/2.
    let viscous = DiskTable64::new(1.0)
        .expect("1 is a valid exponent")
        .reduced_wrench(0.3, 1.0);
    assert!((viscous.force - 0.3).abs() < 1e-15 && (viscous.torque - 0.5).abs() < 1e-15);

    let mut group = criterion.benchmark_group("build");
    for alpha in EXPONENTS {
        group.bench_function(BenchmarkId::new("Table64", alpha), |bencher| {
            bencher.iter(|| DiskTable64::new(black_box(alpha)));
        });
        group.bench_function(BenchmarkId::new("Table32", alpha), |bencher| {
            bencher.iter(|| DiskTable32::new(black_box(alpha as f32)));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = build
}
criterion_main!(benches);
