//! Force and torque of contacts at nodes, by number of nodes, beside the disk's own table.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::mix;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{DiskFriction, table};
use tribos_core::law::{Coulomb, LocalLaw, PowerLaw};
use tribos_core::patch::UniformDisk;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::PolarRule;
use tribos_core::patch::tripod::tripod;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

const SEED: u64 = 1;
/// What 100 nodes may differ from the disk they stand for, of the load.
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
    let rule = PolarRule::new(R::ONE, rings, angles).expect("a valid rule");
    rule.nodes().expect("room for all nodes")
}

/// Compares with the table of the disk at one moderate twist.
fn assert_right<P: NodePatch<f64>>(nodes: &NodeFriction<Coulomb<f64>, P>) {
    let patch = UniformDisk::new(1.0).expect("1 is a valid radius");
    let table = DiskFriction::new(table::Coulomb, 1.0, patch).expect("1 is a valid coefficient");
    let twist = Twist::new(0.3, 0.4, 0.7);
    let (found, expected) = (nodes.wrench(1.0, &twist), table.wrench(1.0, &twist));
    assert!((found.force - expected.force).norm() < CHECK, "force");
    assert!((found.torque - expected.torque).abs() < CHECK, "torque");
}

fn time<R: Real, L: LocalLaw<R>, P: NodePatch<R>>(
    criterion: &mut Criterion,
    name: &str,
    friction: &NodeFriction<L, P>,
) {
    let twists = twists::<R>();
    let mut wrenches = vec![Wrench::ZERO; twists.len()];
    let mut group = criterion.benchmark_group("nodes");
    group.throughput(Throughput::Elements(twists.len() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
        bencher.iter(|| {
            for (twist, wrench) in black_box(&twists).iter().zip(&mut wrenches) {
                *wrench = friction.wrench(R::ONE, twist);
            }
            black_box(&mut wrenches);
        });
    });
    group.finish();
}

fn time_jacobian(
    criterion: &mut Criterion,
    name: &str,
    friction: &impl Fn(&Twist<f64>) -> WrenchJacobian<f64>,
) {
    let twists = twists();
    let mut jacobians = vec![WrenchJacobian::default(); twists.len()];
    let mut group = criterion.benchmark_group("nodes");
    group.throughput(Throughput::Elements(twists.len() as u64));
    group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
        bencher.iter(|| {
            for (twist, jacobian) in black_box(&twists).iter().zip(&mut jacobians) {
                *jacobian = friction(twist);
            }
            black_box(&mut jacobians);
        });
    });
    group.finish();
}

fn nodes(criterion: &mut Criterion) {
    let law = Coulomb::new(1.0).expect("1 is a valid coefficient");
    let narrow = Coulomb::new(1.0_f32).expect("1 is a valid coefficient");
    let power = PowerLaw::new(0.5, 1.0).expect("1/2 is a valid exponent");
    let feet = tripod([[1.0, 0.0], [-0.5, 0.8], [-0.5, -0.8]], [0.1, 0.0]).expect("it stands");
    let hundred = NodeFriction::new(law, disk::<f64, 100>(5, 20));
    assert_right(&hundred);

    time(criterion, "3", &NodeFriction::new(law, feet));
    time(criterion, "100", &hundred);
    time(
        criterion,
        "100 f32",
        &NodeFriction::new(narrow, disk::<f32, 100>(5, 20)),
    );
    time(
        criterion,
        "100 alpha 0.5",
        &NodeFriction::new(power, disk::<f64, 100>(5, 20)),
    );
    time(
        criterion,
        "512",
        &NodeFriction::new(law, disk::<f64, 512>(16, 32)),
    );
    time_jacobian(criterion, "100 Jacobian", &|twist| {
        hundred.wrench_jacobian(1.0, twist)
    });
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = nodes
}
criterion_main!(benches);
