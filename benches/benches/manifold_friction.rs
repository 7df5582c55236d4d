//! Friction of an engine's manifolds: the two clamps that engines have, and one projection with each outline, of one
//! manifold alone and of four and eight side by side; all slide, then all are held.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_benches::mix::Lcg;
use tribos_core::manifold_friction::{
    DirectionalLimitCurve, FrictionImpulse, FrictionLimits, InverseEffectiveMasses,
    IsotropicLimitCurve, Lanes, ManifoldArea, manifold_friction_in, project_friction,
};
use wide::{f32x4, f32x8};

const SEED: u64 = 7;
const COUNT: usize = 1024;
/// A sole of 20 × 5 cm, in m.
const SOLE: [[f32; 2]; 4] = [[-0.1, -0.025], [0.1, -0.025], [0.1, 0.025], [-0.1, 0.025]];
/// Mean distance of a manifold's area from its centre, in m.
const LEVER: f64 = 0.05;

/// One manifold, or several side by side.
type Problem<T> = (
    FrictionImpulse<T>,
    FrictionLimits<T>,
    InverseEffectiveMasses<T>,
);

/// Tangential impulses and twist in N s and N m s, the largest tangential one, and the inverse mass of spin.
fn drawn(is_held: bool) -> Vec<[f32; 5]> {
    let mut rng = Lcg::new(SEED);
    let mut one = || {
        let force = rng.uniform(0.5, 1.5);
        let out = |rng: &mut Lcg| {
            if is_held {
                rng.uniform(0.0, 0.5)
            } else {
                rng.log_uniform(0.8, 100.0)
            }
        };
        let (push, turn) = (
            out(&mut rng) * force,
            rng.uniform(0.0, std::f64::consts::TAU),
        );
        let twist = out(&mut rng) * force * LEVER;
        let spin = rng.log_uniform(0.1, 10.0) / (LEVER * LEVER);
        [push * turn.cos(), push * turn.sin(), twist, force, spin].map(|x| x as f32)
    };
    (0..COUNT).map(|_| one()).collect()
}

/// The manifolds in vectors of `N` lanes, made by `vector`.
fn side_by_side<T: Lanes, const N: usize>(
    drawn: &[[f32; 5]],
    vector: fn([f32; N]) -> T,
) -> Vec<Problem<T>> {
    let problem = |lanes: &[[f32; 5]]| {
        let number = |k: usize| vector(std::array::from_fn(|lane| lanes[lane][k]));
        (
            FrictionImpulse {
                tangential: [number(0), number(1)],
                angular: number(2),
            },
            FrictionLimits {
                impulse: number(3),
                torsion_radius: T::splat(LEVER as f32),
                dynamic_over_static: T::splat(1.0),
            },
            InverseEffectiveMasses {
                tangential: T::splat(1.0),
                angular: number(4),
            },
        )
    };
    drawn.chunks_exact(N).map(problem).collect()
}

fn directed<T: Lanes>(area: &ManifoldArea<f32>) -> DirectionalLimitCurve<T> {
    DirectionalLimitCurve {
        spinning: area.outline.spinning.map(T::splat),
        slipping: area.outline.slipping.map(T::splat),
    }
}

/// What engines with one friction centre do: both limits, one after the other.
fn two_clamps<T: Lanes>((candidate, budget, _): &Problem<T>) -> FrictionImpulse<T> {
    let [x, y] = candidate.tangential;
    let size = (x * x + y * y).sqrt();
    let over = budget.impulse / size.larger(T::splat(1e-30));
    let scale = over.smaller(T::splat(1.0));
    let torque = budget.impulse * budget.torsion_radius;
    FrictionImpulse {
        tangential: [x * scale, y * scale],
        angular: candidate.angular.smaller(torque).larger(-torque),
    }
}

fn projections<T: Lanes, const N: usize>(
    criterion: &mut Criterion,
    name: &str,
    vector: fn([f32; N]) -> T,
) {
    let sole = directed(&ManifoldArea::of_corners(&SOLE));
    let mut group = criterion.benchmark_group(format!("manifold friction, {name}"));
    group.throughput(Throughput::Elements(COUNT as u64));
    let mut bench = |name: &str, state: &str, given: &[Problem<T>], project: &dyn Project<T>| {
        group.bench_function(BenchmarkId::new(name, state), |bencher| {
            bencher.iter(|| project.all(black_box(given)));
        });
    };
    for (state, is_held) in [("sliding", false), ("held", true)] {
        let given = side_by_side(&drawn(is_held), vector);
        bench("two clamps", state, &given, &Each(two_clamps::<T>));
        let area = |(candidate, budget, inverse): &Problem<T>| {
            project_friction(candidate, budget, inverse, &IsotropicLimitCurve::area())
        };
        bench("area", state, &given, &Each(area));
        let exactly = |(candidate, budget, inverse): &Problem<T>| {
            manifold_friction_in::<3, _, _>(
                candidate,
                budget,
                inverse,
                &IsotropicLimitCurve::area(),
            )
        };
        bench("area, three steps", state, &given, &Each(exactly));
        let along = |(candidate, budget, inverse): &Problem<T>| {
            project_friction(candidate, budget, inverse, &sole)
        };
        bench("sole of 4 : 1", state, &given, &Each(along));
    }
    group.finish();
}

/// All problems through one function; behind a pointer for the whole batch, not for each of them.
trait Project<T> {
    fn all(&self, given: &[Problem<T>]);
}

struct Each<F>(F);

impl<T, F: Fn(&Problem<T>) -> FrictionImpulse<T>> Project<T> for Each<F> {
    fn all(&self, given: &[Problem<T>]) {
        for problem in given {
            black_box((self.0)(problem));
        }
    }
}

fn all(criterion: &mut Criterion) {
    projections(criterion, "one alone", |[x]: [f32; 1]| x);
    projections(criterion, "four lanes", f32x4::new);
    projections(criterion, "eight lanes", f32x8::new);
    let corners = black_box(SOLE);
    criterion.bench_function("area of four corners", |bencher| {
        bencher.iter(|| ManifoldArea::of_corners(black_box(&corners)));
    });
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = all
}
criterion_main!(benches);
