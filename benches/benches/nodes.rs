//! Force and torque of contacts at nodes, by number of nodes, beside the disk's own table.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::mix;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{RoundFriction, coulomb};
use tribos_core::law::{CoulombLaw, PowerLaw};
use tribos_core::patch::nodes::{NodeList, NodePatch, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

const SEED: u64 = 1;
/// Largest accepted difference between 100 nodes and the disk that they represent, relative to the load.
const CHECK: f64 = 2e-2;

/// Twists with velocities in both directions.
fn twists<R: Real>() -> Vec<Twist<R>> {
    let pairs = mix::long_pairs(SEED);
    let turned = |[v, w]: [f64; 2]| {
        let [x, y] = [0.6 * v, 0.8 * v].map(R::from_f64);
        Twist::new(x, y, R::from_f64(w))
    };
    pairs.into_iter().step_by(20).map(turned).collect()
}

fn disk<R: Real, const CAPACITY: usize>(rings: u32, angles: u32) -> NodeList<R, CAPACITY> {
    let rule = PolarQuadrature::new(R::ONE, rings, angles).expect("a valid rule");
    rule.nodes().expect("room for all nodes")
}

/// The disk that the rules stand for.
fn whole_disk() -> RoundFriction<f64, coulomb::CoulombDisk> {
    RoundFriction::new(coulomb::CoulombDisk, 1.0, 1.0).expect("1 is a valid coefficient")
}

/// Compares with the table of the disk at one moderate twist.
fn assert_right<P: NodePatch<f64>>(nodes: &NodeFriction<CoulombLaw<f64>, P>) {
    let table = whole_disk();
    let twist = Twist::new(0.3, 0.4, 0.7);
    let (found, expected) = (nodes.wrench(1.0, &twist), table.wrench(1.0, &twist));
    assert!((found.force - expected.force).norm() < CHECK, "force");
    assert!((found.torque - expected.torque).abs() < CHECK, "torque");
}

/// Times `friction` over all twists.
fn time<R: Real, T: Copy>(
    criterion: &mut Criterion,
    name: &str,
    friction: impl Fn(&Twist<R>) -> T,
) {
    let twists = twists::<R>();
    let mut results: Vec<_> = twists.iter().map(&friction).collect();
    let mut group = criterion.benchmark_group("nodes");
    group.throughput(Throughput::Elements(twists.len() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
        bencher.iter(|| {
            for (twist, result) in black_box(&twists).iter().zip(&mut results) {
                *result = friction(twist);
            }
            black_box(&mut results);
        });
    });
    group.finish();
}

fn nodes(criterion: &mut Criterion) {
    let law = CoulombLaw::new(1.0).expect("1 is a valid coefficient");
    let narrow = CoulombLaw::new(1.0_f32).expect("1 is a valid coefficient");
    let power = PowerLaw::new(0.5, 1.0).expect("1/2 is a valid exponent");
    let feet =
        Nodes::tripod([[1.0, 0.0], [-0.5, 0.8], [-0.5, -0.8]], [0.1, 0.0]).expect("it stands");
    let table = whole_disk();
    let feet = NodeFriction::new(law, feet);
    let hundred = NodeFriction::new(law, disk::<f64, 100>(5, 20));
    let narrow = NodeFriction::new(narrow, disk::<f32, 100>(5, 20));
    let power = NodeFriction::new(power, disk::<f64, 100>(5, 20));
    let standard = NodeFriction::new(law, disk::<f64, 512>(16, 32));
    assert_right(&hundred);
    assert_right(&standard);

    time(criterion, "disk by table", |t| table.wrench(1.0, t));
    time(criterion, "3", |t| feet.wrench(1.0, t));
    time(criterion, "100", |t| hundred.wrench(1.0, t));
    time(criterion, "100 f32", |t| narrow.wrench(1.0, t));
    time(criterion, "100 alpha 0.5", |t| power.wrench(1.0, t));
    time(criterion, "512", |t| standard.wrench(1.0, t));
    time(criterion, "100 Jacobian", |t| {
        hundred.wrench_jacobian(1.0, t)
    });
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = nodes
}
criterion_main!(benches);
