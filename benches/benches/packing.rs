//! Contact dynamics of a jammed box: a sweep for every set of modes, the setup of a step, and
//! the residual; lists of neighbours. The front `contacts` shows speeds beside accuracy.

mod settings;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::hint::black_box;
use tribos::cd::internals::{
    Accelerated, Coefficients, NoMonitor, Operator, Spheres, Visit, residual,
};
use tribos::cd::{World, WorldMaterials};
use tribos::random::Random;
use tribos::space::PeriodicBox;
use tribos::space::pairs::Cells;
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
/// Share of space that the spheres of a list fill, and the gap of neighbours in smallest radii.
const SOLID: f64 = 0.5;
const SKIN: f64 = 0.1;

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

/// Lists of neighbours of a powder with equal volumes in each range of sizes up to a ratio, at a solid fraction of 0.5: the
/// number of radii above r falls with r^-3.
fn lists(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("list");
    group.sample_size(10);
    for ratio in [1.0_f64, 10.0, 100.0] {
        for count in [1_000, 10_000, 100_000, 1_000_000] {
            let mut random = Random::new(SEED, 0);
            let radius = |share: f64| (1.0 - share * (1.0 - ratio.powi(-3))).powf(-1.0 / 3.0);
            let radii: Vec<f64> = (0..count).map(|_| radius(random.unit())).collect();
            let volume: f64 = radii.iter().map(|r| 4.0 / 3.0 * PI * r.powi(3)).sum();
            let side = (volume / SOLID).cbrt();
            let place = |_| Vector3::from_fn(|_, _| side * random.unit());
            let positions: Vec<_> = (0..count).map(place).collect();
            let mut cells = Cells::default();
            group.throughput(Throughput::Elements(count));
            group.bench_function(format!("{count} at 1:{ratio}"), |bencher| {
                bencher.iter(|| {
                    let found = cells.find(&PeriodicBox::OPEN, black_box(&positions), &radii, SKIN);
                    found.expect("the places are finite").len()
                });
            });
        }
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = sweeps, assembly, residuals, lists
}
criterion_main!(benches);
