//! Force and torque: every tier and every method it is compared with, over the mix.
//!
//! The group `price` shows that unused features cost nothing: Coulomb's table, a table
//! of another exponent without the power of the scale, and with it.

mod settings;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use tribos_benches::catalogue;
use tribos_benches::methods::{Inputs, Method};
use tribos_benches::mix;

const SEED: u64 = 1;
/// Beyond this n one evaluation takes milliseconds and the front's few samples suffice.
const LARGEST_TRAPEZOID: &str = "trapezoid 512";

/// Checks a method, then times one sweep.
fn time(criterion: &mut Criterion, group: &str, method: &Method, inputs: &Inputs) {
    let inputs = inputs.thinned(method.stride);
    method.assert_right(&inputs);
    let mut run = method.runner(&inputs);
    let mut group = criterion.benchmark_group(group);
    group.throughput(Throughput::Elements(inputs.wide.len() as u64));
    group.bench_function(&method.name, |bencher| bencher.iter(&mut run));
    group.finish();
}

fn wrench(criterion: &mut Criterion) {
    let inputs = Inputs::new(mix::long_pairs(SEED));
    let mut all = catalogue::tiers().expect("alpha = 0 is a valid exponent");
    all.extend(catalogue::baselines());
    all.extend(catalogue::exponents().expect("the listed exponents are valid"));
    for method in all.iter().filter(|method| method.name != LARGEST_TRAPEZOID) {
        time(criterion, "wrench", method, &inputs);
    }
}

fn price(criterion: &mut Criterion) {
    let inputs = Inputs::new(mix::long_pairs(SEED));
    let mut all = catalogue::tiers().expect("alpha = 0 is a valid exponent");
    all.extend(catalogue::exponents().expect("the listed exponents are valid"));
    let named = [
        "form",
        "table alpha 0.5 unscaled",
        "table alpha 0.5",
        "table alpha 1.5",
    ];
    for method in all
        .iter()
        .filter(|method| named.contains(&method.name.as_str()))
    {
        time(criterion, "price", method, &inputs);
    }
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = wrench, price
}
criterion_main!(benches);
