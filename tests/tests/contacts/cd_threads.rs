//! The number of threads changes no bit.

use nalgebra::Vector3;
use tribos::cd::{
    ContactSolver, IterationOrder, SolverMethod, StopRule, World, WorldMaterials, WorldSetup,
};
use tribos::random::Random;
use tribos_core::contact::{Attraction, Cohesion, NormalLaw};
use tribos_tests::packings::{Rough, accelerated, rough, spheres};

/// Spheres along each axis: several blocks, with enough pairs inside to be worth threads.
const AXES: [usize; 3] = [12, 12, 24];
/// Enough to remember forces of steps before.
const STEPS: usize = 6;

/// A lattice of spheres that nearly touch, shaken.
fn lattice(solver: ContactSolver) -> WorldSetup<Rough> {
    let mut random = Random::new(3, 1);
    let mut jitter = |size: f64| {
        let mut component = || size * (2.0 * random.unit() - 1.0);
        Vector3::new(component(), component(), component())
    };
    let mut centres = Vec::new();
    for index in 0..AXES.iter().product() {
        let [x, y, _] = AXES;
        let cell = [index % x, index / x % y, index / (x * y)];
        centres.push(Vector3::from(cell.map(|cell| 2.02 * cell as f64)) + jitter(0.005));
    }
    let cohesion = Cohesion::new(1.0, 0.1, Attraction::Pull).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    let mut setup = spheres(
        centres,
        WorldMaterials::uniform(normal, rough(0.3, 0.1, 0.1)),
    );
    for sphere in &mut setup.spheres {
        (sphere.velocity, sphere.spin) = (jitter(0.3), jitter(0.3));
    }
    setup.solver = solver;
    setup
}

/// The state after some steps on so many threads, and how many pairs there were.
fn state_on(threads: usize, solver: ContactSolver) -> (String, usize) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads can be made").install(|| {
        let mut world = World::new(lattice(solver)).expect("the setup is valid");
        for _ in 0..STEPS {
            world.step().expect("the step is taken");
        }
        (format!("{:?}", world.state()), world.problem().pairs.len())
    })
}

#[test]
fn states_have_the_same_bits_on_any_number_of_threads() {
    let sweeps = ContactSolver {
        method: SolverMethod::GaussSeidel {
            order: IterationOrder::Alternating,
            stop: StopRule::Global(1e-4),
        },
        ..accelerated(1e-4)
    };
    for solver in [accelerated(1e-4), sweeps] {
        let (alone, pairs) = state_on(1, solver);
        assert!(pairs > 4_000, "{pairs} pairs would not be shared out");
        for threads in [2, 3] {
            assert!(state_on(threads, solver).0 == alone, "{threads} threads");
        }
    }
}
