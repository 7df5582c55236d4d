//! Projections, gauges and normals on the limit surface of a disk, one by one and in batches: wrenches deep
//! inside, next to the surface and outside apart.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;
use tribos_benches::mix::Lcg;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, Projection, Region, RoundLimitSurface};
use tribos_core::twist::{Twist, Wrench};

const SEED: u64 = 7;
const COUNT: usize = 1000;
/// μ and radius in m; loads are 1 N.
const MU: f64 = 0.5;
/// See [`MU`].
const RADIUS: f64 = 0.04;
/// Regions, as bounds of the gauge.
const REGIONS: [(&str, f64, f64); 4] = [
    ("inside", 0.05, 0.5),
    ("near inside", 0.95, 0.999),
    ("near outside", 1.001, 1.05),
    ("outside", 1.5, 10.0),
];

fn wrenches(set: &impl FrictionSet<f64>, low: f64, high: f64) -> Vec<Wrench<f64>> {
    let mut rng = Lcg::new(SEED);
    let mut one = || {
        let (tilt, turn) = (rng.uniform(0.0, FRAC_PI_2), rng.uniform(0.0, TAU));
        let push = Wrench::new(
            tilt.cos() * turn.cos(),
            tilt.cos() * turn.sin(),
            tilt.sin() * RADIUS,
        );
        set.scale_to_surface(&push) * rng.log_uniform(low, high)
    };
    (0..COUNT).map(|_| one()).collect()
}

fn surfaces(criterion: &mut Criterion) {
    let set = RoundLimitSurface::new(CoulombDisk, MU, RADIUS).expect("in range");
    let loads = [1.0; COUNT];
    let blank = Projection {
        wrench: Wrench::ZERO,
        region: Region::Inside,
    };
    let (mut nearest, mut gauges, mut motions) = (
        vec![blank; COUNT],
        vec![0.0; COUNT],
        vec![Twist::ZERO; COUNT],
    );
    let mut group = criterion.benchmark_group("limit surface");
    group.throughput(Throughput::Elements(COUNT as u64));
    for (region, low, high) in REGIONS {
        let given = wrenches(&set, low, high);
        set.project_batch(RADIUS, &loads, &given, &mut nearest);
        for (one, given) in nearest.iter().zip(&given) {
            assert_eq!(*one, set.project(given), "{given:?}");
            assert_eq!(one.region == Region::Inside, high < 1.0, "{given:?}");
        }
        group.bench_function(BenchmarkId::new("project", region), |bencher| {
            bencher.iter(|| {
                for (to, given) in nearest.iter_mut().zip(black_box(&given)) {
                    *to = set.project(given);
                }
                black_box(&mut nearest);
            });
        });
        group.bench_function(BenchmarkId::new("project batch", region), |bencher| {
            bencher.iter(|| {
                set.project_batch(RADIUS, &loads, black_box(&given), &mut nearest);
                black_box(&mut nearest);
            });
        });
        group.bench_function(BenchmarkId::new("gauge batch", region), |bencher| {
            bencher.iter(|| {
                set.gauge_batch(&loads, black_box(&given), &mut gauges);
                black_box(&mut gauges);
            });
        });
        group.bench_function(BenchmarkId::new("normal batch", region), |bencher| {
            bencher.iter(|| {
                set.twist_normal_to_batch(black_box(&given), &mut motions);
                black_box(&mut motions);
            });
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = surfaces
}
criterion_main!(benches);
