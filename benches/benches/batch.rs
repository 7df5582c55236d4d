//! A contact with its dimensions: many twists in one call against one call a twist.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::contact::Contact;
use tribos_benches::mix;
use tribos_core::Real;
use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};

const SEED: u64 = 1;
/// An exponent for which no power is a root or a product.
const ALPHA: f64 = 0.37;

fn time<R: Real>(criterion: &mut Criterion, coupling: impl ReducedFriction<R>, name: &str) {
    let pairs = mix::long_pairs(SEED);
    let mut contact =
        Contact::<R, _>::new(coupling, &pairs, SEED).expect("the contact of the benches is valid");
    contact.assert_right();
    let mut group = criterion.benchmark_group("batch");
    group.throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function(BenchmarkId::new("one by one", name), |bencher| {
        bencher.iter(|| {
            black_box(contact.one_by_one());
        });
    });
    group.bench_function(BenchmarkId::new("batch", name), |bencher| {
        bencher.iter(|| {
            black_box(contact.batch());
        });
    });
    group.finish();
}

fn batch(criterion: &mut Criterion) {
    time::<f64>(criterion, CoulombDisk, "f64");
    time::<f32>(criterion, CoulombDisk, "f32");
    let double = DiskTable64::new(ALPHA).expect("the exponent is in range");
    time::<f64>(criterion, double, "f64 alpha 0.37");
    let single = DiskTable32::new(ALPHA as f32).expect("the exponent is in range");
    time::<f32>(criterion, single, "f32 alpha 0.37");
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = batch
}
criterion_main!(benches);
