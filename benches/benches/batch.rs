//! A contact with its dimensions: many twists in one call against one call a twist.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::contact::Contact;
use tribos_benches::mix;
use tribos_core::Real;

const SEED: u64 = 1;

fn time<R: Real>(criterion: &mut Criterion, precision: &str) {
    let pairs = mix::long_pairs(SEED);
    let mut contact = Contact::<R>::new(&pairs, SEED).expect("the contact of the benches is valid");
    contact.assert_right();
    let mut group = criterion.benchmark_group("batch");
    group.throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function(BenchmarkId::new("one by one", precision), |bencher| {
        bencher.iter(|| {
            black_box(contact.one_by_one());
        });
    });
    group.bench_function(BenchmarkId::new("batch", precision), |bencher| {
        bencher.iter(|| {
            black_box(contact.batch());
        });
    });
    group.finish();
}

fn batch(criterion: &mut Criterion) {
    time::<f64>(criterion, "f64");
    time::<f32>(criterion, "f32");
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = batch
}
criterion_main!(benches);
