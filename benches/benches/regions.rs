//! Force and torque where one motion dominates and where both are similar, timed separately:
//! branches that always go the same way, and iterations that are always few or many.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use tribos_benches::catalogue;
use tribos_benches::methods::Inputs;
use tribos_benches::mix::Region;

const SEED: u64 = 1;
/// The table and what it is first compared with.
const METHODS: [&str; 2] = ["form", "agm"];

fn regions(criterion: &mut Criterion) {
    let mut all = catalogue::tiers().expect("alpha = 0 is a valid exponent");
    all.extend(catalogue::baselines());
    all.retain(|method| METHODS.contains(&method.name.as_str()));
    let mut group = criterion.benchmark_group("regions");
    for region in Region::ALL {
        let inputs = Inputs::new(region.pairs(SEED));
        group.throughput(Throughput::Elements(inputs.wide.len() as u64));
        for method in &all {
            method.assert_right(&inputs);
            let mut run = method.runner(&inputs);
            group.bench_function(BenchmarkId::new(&method.name, region.name()), |bencher| {
                bencher.iter(&mut run);
            });
        }
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = regions
}
criterion_main!(benches);
