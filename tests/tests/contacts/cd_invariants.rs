//! What a world keeps, whatever happens in it: momentum, energy, room, bits.

use nalgebra::Vector3;
use tribos::cd::{
    ContactSolver, EnergyBalance, IterationOrder, SolverMethod, StepLimits, StopRule, World,
    WorldMaterials, WorldState,
};
use tribos_core::contact::{AllModes, Attraction, Cohesion, NormalLaw};
use tribos_tests::gas::{SIDE, gas, periodic};
use tribos_tests::packings::{Rough, accelerated, rough, spheres};

/// Steps of a run: a few hundred, in which the gas collides about a hundred times a sphere.
const STEPS: usize = 250;

fn law(strength: f64, attraction: Attraction, restitution: f64) -> NormalLaw<f64> {
    let cohesion = Cohesion::new(strength, 0.1, attraction).expect("cohesion is valid");
    NormalLaw::new(cohesion, restitution).expect("the law is valid")
}

/// Linear and angular momentum, and the sums of their parts' sizes.
fn momenta(state: &WorldState<AllModes>) -> ([Vector3<f64>; 2], [f64; 2]) {
    let (mut sums, mut sizes) = ([Vector3::zeros(); 2], [0.0; 2]);
    for (sphere, x) in state.spheres.iter().zip(&state.positions) {
        let push = sphere.velocity / sphere.inv_mass;
        let turn = x.cross(&push) + sphere.spin / sphere.inv_inertia;
        sums[0] += push;
        sums[1] += turn;
        sizes[0] += push.norm();
        sizes[1] += turn.norm();
    }
    (sums, sizes)
}

#[test]
fn momentum_and_angular_momentum_stay_to_rounding() {
    let friction = rough(0.5, 0.3, 0.2);
    for (axes, kept) in [([false; 3], 2), ([true, false, false], 1), ([true; 3], 1)] {
        for attraction in [Attraction::Pull, Attraction::Resistance] {
            let setup = gas(periodic(axes), law(0.5, attraction, 0.2), friction);
            let mut world = World::new(setup).expect("the setup is valid");
            let (start, sizes) = momenta(world.state());
            let mut contacts = 0;
            for _ in 0..STEPS {
                contacts += world.step().expect("the gas can step").contacts;
            }
            assert!(contacts > 10_000, "{contacts} contacts in all");
            let (end, _) = momenta(world.state());
            for (name, index) in ["linear", "angular"].iter().zip(0..kept) {
                let drift = (end[index] - start[index]).norm() / sizes[index];
                println!("{axes:?} {attraction:?}: {name} momentum drifts {drift:e}");
                assert!(drift < 2e-14, "{name}: {drift:e}");
            }
        }
    }
}

/// Entries that friction may only raise.
fn losses(book: &EnergyBalance) -> [f64; 3] {
    [book.sliding, book.rolling, book.torsion]
}

#[test]
fn the_book_closes_and_friction_only_takes() {
    for (strength, attractions) in [
        // Without cohesion it attracts in no way.
        (0.0, &[Attraction::Pull][..]),
        (0.5, &[Attraction::Pull, Attraction::Resistance]),
        (2.0, &[Attraction::Pull, Attraction::Resistance]),
    ] {
        for &attraction in attractions {
            let normal = law(strength, attraction, 0.0);
            let setup = gas(periodic([true; 3]), normal, rough(0.5, 0.3, 0.2));
            let mut world = World::new(setup).expect("the setup is valid");
            let mut worst = 0.0_f64;
            for _ in 0..STEPS {
                let before = world.state().energy;
                world.step().expect("the gas can step");
                let after = world.state().energy;
                for (old, new) in losses(&before).into_iter().zip(losses(&after)) {
                    worst = worst.max((old - new) / after.kinetic_initial.unwrap_or(0.0));
                }
                if strength == 0.0 {
                    assert!(after.kinetic <= after.kinetic_initial.unwrap_or(0.0));
                    assert!(
                        after.kinetic
                            <= before.kinetic
                                + before.kinetic_initial.map_or(f64::INFINITY, |e| 1e-12 * e)
                    );
                }
            }
            let book = world.state().energy;
            let scale = book.kinetic_initial.unwrap_or(0.0);
            println!(
                "F_coh {strength}, {attraction:?}: imbalance {:e}, friction gave back {worst:e}, \
                 taken {:?} of {scale}",
                book.imbalance() / scale,
                losses(&book)
            );
            assert!(book.imbalance().abs() < 1e-12 * scale);
            assert!(worst < 1e-11, "friction gave {worst:e} of the energy");
            assert!(losses(&book).iter().all(|loss| *loss > 1e-3 * scale));
        }
    }
}

/// Smallest gap of any pair.
fn smallest_gap(world: &World<Rough>) -> f64 {
    let (setup, positions) = (world.setup(), &world.state().positions);
    let mut smallest = f64::INFINITY;
    for (b, y) in positions.iter().enumerate() {
        for (a, x) in positions[..b].iter().enumerate() {
            let distance = setup.space.displacement(x, y).norm();
            smallest = smallest.min(distance - setup.radii[a] - setup.radii[b]);
        }
    }
    smallest
}

#[test]
fn overlaps_are_no_larger_than_the_residuals_say() {
    // Coarse to fine: what is left of closing speeds, times the steps, is all that may overlap.
    for tolerance in [1e-2, 1e-4, 1e-8, 1e-10] {
        let mut setup = gas(
            periodic([true; 3]),
            law(2.0, Attraction::Pull, 0.0),
            rough(0.5, 0.3, 0.2),
        );
        setup.solver = accelerated(tolerance);
        let mut world = World::new(setup).expect("the setup is valid");
        let (mut allowed, mut overlap) = (0.0, 0.0_f64);
        for _ in 0..STEPS {
            let report = world.step().expect("the gas can step");
            allowed += report.residual.penetration * report.dt;
            overlap = overlap.max(-smallest_gap(&world));
            assert!(overlap <= allowed + 1e-12, "{overlap:e} after {allowed:e}");
        }
        println!("tolerance {tolerance:e}: overlap {overlap:e}, residuals allow {allowed:e}");
    }
}

/// Every bit of a state, as text.
fn bits(world: &World<Rough>) -> String {
    format!("{:?}", world.state())
}

/// The four kinds of solver.
fn solvers() -> [ContactSolver; 4] {
    let gauss_seidel = |order| ContactSolver {
        method: SolverMethod::GaussSeidel {
            order,
            stop: StopRule::Global(1e-6),
        },
        most_sweeps: 200,
        warm_start: 1.0,
    };
    [
        gauss_seidel(IterationOrder::Fixed),
        gauss_seidel(IterationOrder::Alternating),
        gauss_seidel(IterationOrder::Random { seed: 3 }),
        accelerated(1e-6),
    ]
}

#[test]
fn runs_repeat_and_resume_to_the_same_bits() {
    for solver in solvers() {
        let mut setup = gas(
            periodic([true, true, false]),
            law(2.0, Attraction::Pull, 0.0),
            rough(0.5, 0.3, 0.2),
        );
        setup.solver = solver;
        setup.sleep_speed = 1e-3;
        let steps = |world: &mut World<Rough>, count| {
            for _ in 0..count {
                world.step().expect("the gas can step");
            }
        };
        let mut through = World::new(setup.clone()).expect("the setup is valid");
        let mut again = World::new(setup.clone()).expect("the setup is valid");
        steps(&mut through, 120);
        steps(&mut again, 70);
        let mut resumed = World::resume(setup, again.state().clone());
        steps(&mut resumed, 50);
        steps(&mut again, 50);
        assert_eq!(bits(&again), bits(&through), "{solver:?}");
        assert_eq!(bits(&resumed), bits(&through), "{solver:?}");
    }
}

#[test]
fn whole_periods_make_no_difference() {
    for axes in [
        [true, false, false],
        [false, true, false],
        [true, true, true],
    ] {
        let setup = gas(
            periodic(axes),
            law(0.5, Attraction::Pull, 0.0),
            rough(0.5, 0.3, 0.2),
        );
        let mut shifted = setup.clone();
        for (body, x) in shifted.positions.iter_mut().enumerate() {
            for axis in (0..3).filter(|axis| axes[*axis]) {
                x[axis] += SIDE * ((body * 7 + axis * 3) % 5) as f64 - 2.0 * SIDE;
            }
        }
        let mut worlds = [setup, shifted].map(|setup| World::new(setup).expect("valid"));
        let mut contacts = 0;
        for _ in 0..100 {
            for world in &mut worlds {
                contacts += world.step().expect("the gas can step").contacts;
            }
        }
        assert!(contacts > 2_000);
        let spheres = worlds.each_ref().map(|world| &world.state().spheres);
        let apart = spheres[0]
            .iter()
            .zip(spheres[1])
            .map(|(a, b)| (a.velocity - b.velocity).norm() + (a.spin - b.spin).norm());
        let apart = apart.fold(0.0, f64::max);
        println!("{axes:?}: shifted copies part by {apart:e}");
        assert!(apart < 1e-9, "{axes:?}: {apart:e}");
    }
}

#[test]
fn a_step_in_which_something_leaps_is_taken_again_shorter() {
    // A pull that the bound of the step cannot foresee.
    let pair = |strength: f64| {
        let cohesion = Cohesion::new(strength, 1.0, Attraction::Pull).expect("valid");
        let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
        let places = vec![Vector3::zeros(), Vector3::new(2.9, 0.0, 0.0)];
        let mut setup = spheres(
            places,
            WorldMaterials::uniform(normal, rough(0.3, 0.1, 0.1)),
        );
        setup.step_limits = StepLimits {
            longest: 1.0,
            motion: 0.01,
        };
        World::new(setup).expect("the setup is valid")
    };
    let mut world = pair(100.0);
    let report = world.step().expect("a shorter step will do");
    let moved = world.state().positions[0].x;
    // 100/m dt² ≤ 0.02, in halves of 1.
    let mass = 1.0 / world.state().spheres[0].inv_mass;
    let wanted = (0..)
        .map(|n| 0.5_f64.powi(n))
        .find(|dt| 100.0 / mass * dt * dt <= 0.02);
    assert_eq!(Some(report.dt), wanted);
    assert!((moved - 100.0 / mass * report.dt * report.dt).abs() < 1e-15);
    assert_eq!(world.state().time, report.dt);
    let error = pair(1e30).step().expect_err("no step is short enough");
    assert!(
        matches!(error, tribos::cd::WorldError::TooFast { step: 0, .. }),
        "{error}"
    );
}
