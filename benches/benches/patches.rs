//! Every patch under Coulomb friction in f64: tables, closed forms, tall bodies, limit surfaces.
//!
//! The rows are those of the front `patches`, which shows errors beside times.

mod settings;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use tribos_benches::patches::{Entry, round, surface, tall};

/// Largest accepted error of a tier in f64, relative to the larger of force and torque.
const BOUND: f64 = 1e-12;

/// Checks each row, then times it.
fn time(criterion: &mut Criterion, name: &str, entries: Vec<Entry>) {
    let mut group = criterion.benchmark_group(name);
    for mut entry in entries {
        let label = entry.label;
        if label.law != "Coulomb" {
            continue;
        }
        let error = entry.worst.of_larger;
        assert!(error <= BOUND, "{label:?} errs by {error:e}");
        group.throughput(Throughput::Elements(entry.elements as u64));
        let name = format!("{} {}", label.patch, label.tier);
        group.bench_function(name, |bencher| bencher.iter(&mut entry.run));
    }
    group.finish();
}

fn patches(criterion: &mut Criterion) {
    let valid = "the constants are in the domain";
    time(criterion, "pressures", round::powers::<f64>().expect(valid));
    time(criterion, "polynomial", round::polynomial().expect(valid));
    time(criterion, "tall", tall::rows::<f64>().expect(valid));
    time(criterion, "surface", surface::rows::<f64>().expect(valid));
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = patches
}
criterion_main!(benches);
