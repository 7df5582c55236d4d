//! Contact dynamics of a jammed box: a sweep for every set of modes, the setup of a step, and
//! the residual. The front `contacts` shows speeds beside accuracy.

mod settings;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos::cd::internals::{
    Accelerated, Coefficients, NoMonitor, Operator, Spheres, Visit, residual,
};
use tribos::cd::{World, WorldMaterials};
use tribos_core::contact::{ContactFriction, IndependentFriction};
use tribos_tests::packings::{dry, first_problem, jammed_box, rough};

/// Spheres of the box, its seed.
const COUNT: usize = 1000;
const SEED: u64 = 1;
/// Sliding, rolling and torsion coefficients.
const MU: [f64; 3] = [0.3, 0.1, 0.1];
/// Residual of a solution before anything is timed.
const CONVERGED: f64 = 1e-5;
const MOST_SWEEPS: usize = 10_000;

/// The box solved, checked without the solver.
fn solved<F: ContactFriction<f64> + Coefficients>(friction: F) -> Spheres<F> {
    let setup = jammed_box(COUNT, SEED, WorldMaterials::uniform(dry(), friction));
    let mut problem = first_problem(&setup).expect("the box is valid");
    Accelerated::default().solve(&mut problem, CONVERGED, MOST_SWEEPS);
    let left = residual(&problem).relative;
    assert!(left <= CONVERGED, "residual {left:e}");
    problem
}

/// One forward sweep over solved contacts, which leaves them as they are.
fn sweep<F: ContactFriction<f64> + Coefficients>(
    criterion: &mut Criterion,
    name: &str,
    friction: F,
) {
    let mut problem = solved(friction);
    let mut group = criterion.benchmark_group("sweep");
    group.throughput(Throughput::Elements(problem.contacts() as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| black_box(&mut problem).sweep(Visit::Forward, &mut NoMonitor));
    });
    group.finish();
}

fn sweeps(criterion: &mut Criterion) {
    let valid = "the coefficients are in the domain";
    let [mu, mu_t, mu_n] = MU;
    sweep(criterion, "all six", rough(mu, mu_t, mu_n));
    let rolling = IndependentFriction::sliding_rolling(mu, mu_t).expect(valid);
    sweep(criterion, "sliding, rolling", rolling);
    let torsion = IndependentFriction::sliding_torsion(mu, mu_n).expect(valid);
    sweep(criterion, "sliding, torsion", torsion);
    sweep(
        criterion,
        "sliding",
        IndependentFriction::sliding(mu).expect(valid),
    );
    sweep(criterion, "frictionless", IndependentFriction::none());
}

/// A step without sweeps: neighbours, contacts, free motion, residual and energy.
fn assembly(criterion: &mut Criterion) {
    let mut setup = jammed_box(
        COUNT,
        SEED,
        WorldMaterials::uniform(dry(), rough(MU[0], MU[1], MU[2])),
    );
    setup.solver.most_sweeps = 0;
    // Without a load nothing moves, so that every step is the same.
    setup.walls.iter_mut().for_each(|wall| wall.force = 0.0);
    let mut world = World::new(setup).expect("the box is valid");
    let report = world.step().expect("nothing moves");
    assert!(report.contacts > 3 * COUNT && world.state().spheres[0].velocity.norm() == 0.0);
    let mut group = criterion.benchmark_group("step");
    group.throughput(Throughput::Elements(report.contacts as u64));
    group.bench_function("without sweeps", |bencher| {
        bencher.iter(|| black_box(&mut world).step().expect("nothing moves"));
    });
    group.finish();
}

fn residuals(criterion: &mut Criterion) {
    let problem = solved(rough(MU[0], MU[1], MU[2]));
    let mut group = criterion.benchmark_group("residual");
    group.throughput(Throughput::Elements(problem.contacts() as u64));
    group.bench_function("all six", |bencher| {
        bencher.iter(|| residual(black_box(&problem)));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = sweeps, assembly, residuals
}
criterion_main!(benches);
