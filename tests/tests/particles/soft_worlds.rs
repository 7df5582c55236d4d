//! Packings of soft spheres: invariants, energy, bits.

use nalgebra::{Rotation3, Vector3};
use tribos::cd::{Wall, WorldMaterials, solid};
use tribos::random::Random;
use tribos::soft::{SoftSetup, SoftWorld, Stiffness};
use tribos::space::PeriodicBox;
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, ContactFriction, CoupledFriction, IndependentFriction,
    NormalLaw,
};
use tribos_core::limit_surface::LimitEllipsoid;

type Rough = IndependentFriction<f64, AllModes>;

fn laws(mu: f64, mu_rolling: f64, mu_torsion: f64) -> WorldMaterials<Rough> {
    let cohesion = Cohesion::new(1.0, 0.05, Attraction::Pull).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    WorldMaterials::uniform(
        normal,
        IndependentFriction::all(mu, mu_rolling, mu_torsion).expect("mu is valid"),
    )
}

/// A shaken cluster of spheres of different sizes that nearly touch, in open space.
fn cluster<F: ContactFriction<f64>>(
    edge: usize,
    laws: WorldMaterials<F>,
    stiffness: Stiffness,
) -> SoftSetup<F> {
    let mut random = Random::new(7, 1);
    let mut jitter = |size: f64| {
        let mut component = || size * (2.0 * random.unit() - 1.0);
        Vector3::new(component(), component(), component())
    };
    let mut setup = SoftSetup::new(laws, stiffness);
    for index in 0..edge.pow(3) {
        let cell = [index % edge, index / edge % edge, index / (edge * edge)];
        let place = Vector3::from(cell.map(|cell| 1.99 * cell as f64)) + jitter(0.01);
        let radius = 0.9 + 0.1 * jitter(1.0).x;
        let mut sphere = solid(radius, 1.0);
        (sphere.velocity, sphere.spin) = (jitter(0.3), jitter(0.3));
        setup = setup.sphere(place, radius, sphere);
    }
    setup.longest = 0.1;
    setup
}

fn stepped<F: ContactFriction<f64>>(setup: SoftSetup<F>, steps: usize) -> SoftWorld<F> {
    let mut world = SoftWorld::new(setup).expect("the setup is valid");
    for _ in 0..steps {
        world.step().expect("the step is taken");
    }
    world
}

/// Momentum and angular momentum.
fn momenta<F: ContactFriction<f64>>(world: &SoftWorld<F>) -> [Vector3<f64>; 2] {
    let state = world.state();
    let bodies = state.spheres.iter().zip(&state.positions);
    bodies.fold([Vector3::zeros(); 2], |[p, l], (sphere, x)| {
        let momentum = sphere.velocity / sphere.inv_mass;
        [
            p + momentum,
            l + x.cross(&momentum) + sphere.spin / sphere.inv_inertia,
        ]
    })
}

#[test]
fn momentum_and_angular_momentum_are_kept_to_rounding() {
    for stiffness in [Stiffness::Linear(1e3), Stiffness::Hertz(1e3)] {
        let mut world = stepped(cluster(3, laws(0.3, 0.1, 0.1), stiffness), 0);
        let before = momenta(&world);
        for _ in 0..5_000 {
            world.step().expect("the step is taken");
        }
        for (before, after) in before.iter().zip(momenta(&world)) {
            assert!(
                (before - after).norm() < 1e-11,
                "{stiffness:?}: {before:?} {after:?}"
            );
        }
    }
}

#[test]
fn a_pair_that_sticks_turns_as_one_body_for_ten_turns() {
    // Two spheres on an orbit with the spin of the orbit: no spring is strained but by the centrifugal force.
    let spin = Vector3::new(0.0, 0.0, 0.05);
    let mut setup = SoftSetup::new(laws(0.5, 0.5, 0.5), Stiffness::Linear(1e3));
    for side in [-1.0, 1.0] {
        let at = Vector3::x() * side;
        let mut sphere = solid(1.0, 1.0);
        (sphere.velocity, sphere.spin) = (spin.cross(&at), spin);
        setup = setup.sphere(at, 1.0, sphere);
    }
    setup.longest = 0.1;
    let mut world = stepped(setup, 0);
    let before = momenta(&world)[1];
    while world.state().time < 10.0 * std::f64::consts::TAU / spin.z {
        world.step().expect("the step is taken");
    }
    let state = world.state();
    assert!((momenta(&world)[1] - before).norm() < 1e-10);
    for sphere in &state.spheres {
        assert!((sphere.spin - spin).norm() < 2e-4, "{:?}", sphere.spin);
    }
    assert!(state.energy.sliding.abs() + state.energy.torsion.abs() < 1e-6);
}

/// Every loss of a run's steps, and the imbalance at its end as a share of the initial energy.
fn losses<F: ContactFriction<f64>>(mut setup: SoftSetup<F>, longest: f64, end: f64) -> (f64, f64) {
    setup.longest = longest;
    let mut world = stepped(setup, 0);
    let mut least = 0.0_f64;
    let taken = |world: &SoftWorld<F>| {
        let energy = &world.state().energy;
        [
            energy.normal,
            energy.sliding,
            energy.rolling,
            energy.torsion,
        ]
    };
    while world.state().time < end {
        let before = taken(&world);
        world.step().expect("the step is taken");
        let [normal, sliding, rolling, torsion] = before;
        let after = taken(&world);
        // Under one threshold sliding and torsion may pass energy to each other.
        let gains = [
            after[0] - normal,
            after[1] + after[3] - (sliding + torsion),
            after[2] - rolling,
        ];
        least = gains.into_iter().fold(least, f64::min);
    }
    let energy = &world.state().energy;
    let lost = taken(&world);
    assert!(
        lost.iter().all(|lost| *lost > 1e-4),
        "nothing is lost: {lost:?}"
    );
    let initial = energy.kinetic_initial.expect("a step was taken");
    (least / initial, energy.imbalance() / initial)
}

#[test]
fn no_mode_gains_energy_and_the_balance_closes_faster_than_in_the_first_order() {
    for stiffness in [Stiffness::Linear(200.0), Stiffness::Hertz(200.0)] {
        let of = |longest: f64| losses(cluster(3, laws(0.3, 0.05, 0.05), stiffness), longest, 1.0);
        let [coarse, middle, fine] = [4e-3, 2e-3, 1e-3].map(of);
        for (least, _) in [coarse, middle, fine] {
            assert!(least > -1e-12, "{stiffness:?}: {least:e}");
        }
        let errors = [coarse.1, middle.1, fine.1].map(f64::abs);
        for (error, step) in errors.iter().zip([4.0, 2.0, 1.0]) {
            assert!(*error < 5e-4 * step, "{stiffness:?}: {errors:?}");
        }
        assert!(errors[0] > 4.0 * errors[2], "{stiffness:?}: {errors:?}");
    }
}

#[test]
fn sliding_and_torsion_under_one_threshold_lose_energy_too() {
    let set = LimitEllipsoid::new(0.3, 0.5, 2.0 / 3.0).expect("the set is valid");
    let friction = CoupledFriction::all(set, 0.05).expect("the law is valid");
    let normal = laws(0.0, 0.0, 0.0).pairs.normal;
    let setup = cluster(
        3,
        WorldMaterials::uniform(normal, friction),
        Stiffness::Linear(200.0),
    );
    let (least, imbalance) = losses(setup, 1e-3, 1.0);
    assert!(least > -1e-12, "{least:e}");
    assert!(imbalance.abs() < 2e-3, "{imbalance:e}");
}

#[test]
fn trajectories_converge_in_the_first_order_of_the_step() {
    let end = |longest: f64| {
        let mut setup = cluster(2, laws(0.3, 0.1, 0.1), Stiffness::Linear(100.0));
        setup.longest = longest;
        stepped(setup, (0.4 / longest).round() as usize)
    };
    let [a, b, c, d] = [4e-3, 2e-3, 1e-3, 5e-4].map(end);
    let apart = |a: &SoftWorld<Rough>, b: &SoftWorld<Rough>| {
        let pairs = a.state().positions.iter().zip(&b.state().positions);
        pairs
            .map(|(a, b)| (a - b).norm_squared())
            .sum::<f64>()
            .sqrt()
    };
    let changes = [apart(&a, &b), apart(&b, &c), apart(&c, &d)];
    // Impacts that begin within a step make single ratios uneven.
    let order = 0.5 * (changes[0] / changes[2]).log2();
    assert!((0.7..1.4).contains(&order), "{order}: {changes:?}");
}

#[test]
fn rotated_and_boosted_packings_move_alike() {
    let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
    let boost = Vector3::new(0.7, -0.2, 0.4);
    let setup = cluster(2, laws(0.3, 0.1, 0.1), Stiffness::Linear(300.0));
    let mut moved = setup.clone();
    for (x, sphere) in moved.positions.iter_mut().zip(&mut moved.spheres) {
        *x = turn * *x;
        sphere.velocity = turn * sphere.velocity + boost;
        sphere.spin = turn * sphere.spin;
    }
    // Both take the same steps: springs, not speeds, decide about them.
    let steps = 400;
    let [a, b] = [setup, moved].map(|mut setup| {
        setup.longest = 1e-3;
        stepped(setup, steps)
    });
    assert_eq!(a.state().time, b.state().time);
    let drift = boost * a.state().time;
    for (i, x) in a.state().positions.iter().enumerate() {
        let error = (turn * x + drift - b.state().positions[i]).norm();
        assert!(error < 1e-10, "{i}: {error:e}");
        let spin = turn * a.state().spheres[i].spin - b.state().spheres[i].spin;
        assert!(spin.norm() < 1e-9, "{i}");
    }
}

/// A periodic packing between a floor and a piston.
fn pressed(edge: usize) -> SoftSetup<Rough> {
    let mut setup = cluster(edge, laws(0.3, 0.2, 0.1), Stiffness::Linear(1e3));
    let side = 1.99 * edge as f64;
    setup.space = PeriodicBox::new([Some(side), Some(side), None]).expect("periods are valid");
    let up = Vector3::z();
    setup
        .wall(Wall::fixed(up, -1.1))
        .wall(Wall::piston(-up, -side, 100.0, 5.0))
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads can be made").install(|| {
            let world = stepped(pressed(12), 30);
            let neighbours = world.state().contacts[0].len();
            assert!(neighbours > 4_200, "{neighbours} are not shared out");
            format!("{:?}", world.state())
        })
    };
    let alone = on(1);
    for threads in [2, 3] {
        assert!(on(threads) == alone, "{threads} threads");
    }
}

#[test]
fn a_world_goes_on_from_its_state_to_the_bit() {
    let mut whole = stepped(pressed(4), 500);
    let mut again = SoftWorld::resume(whole.setup().clone(), whole.state().clone());
    for _ in 0..500 {
        whole.step().expect("the step is taken");
        again.step().expect("the step is taken");
    }
    let [a, b] = [&whole, &again].map(|world| world.state());
    assert_eq!(
        (&a.positions, &a.spheres, &a.walls),
        (&b.positions, &b.spheres, &b.walls)
    );
    assert_eq!(a.energy, b.energy);
    assert!(a.steps == 1_000 && a.contacts[0].iter().any(|contact| contact.gap < 0.0));
}
