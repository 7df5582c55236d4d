//! Impacts with restitution: energy, closed solutions, several impacts in a step, small steps.

use nalgebra::Vector3;
use tribos::cd::{StepLimits, Wall, World, WorldMaterials, WorldSetup, solid};
use tribos::random::Random;
use tribos_core::contact::{Attraction, Cohesion, NormalLaw};
use tribos_tests::gas::{gas, periodic};
use tribos_tests::packings::{Rough, chain, rough, spheres};
use tribos_tests::rebounds::{self, Cell, run};

/// Rounding of some hundred impacts, in units of the energy.
const ROUNDING: f64 = 1e-13;
/// Time in which the gas collides about a hundred times.
const TIME: f64 = 2.0;
/// How far the largest impulse of a chaotic gas may depend on the step.
const CHAOS: f64 = 1.5;

fn bouncing(restitution: f64) -> NormalLaw<f64> {
    NormalLaw::new(Cohesion::NONE, restitution).expect("the law is valid")
}

#[test]
fn every_share_of_the_energy_has_its_sign_and_no_impulse_depends_on_the_step() {
    for restitution in [0.3, 0.9, 1.0] {
        for (mu, rolling) in [(0.0, 0.0), (0.3, 0.3), (1.0, 0.0), (1.0, 0.3), (10.0, 0.3)] {
            let answers = [0.04, 0.02, 0.01].map(|dt| {
                let cell = Cell {
                    restitution,
                    mu,
                    rolling,
                    dt,
                };
                let answer = run(cell, TIME);
                assert!(answer.least > -ROUNDING, "{cell:?}: {answer:?}");
                assert!(answer.imbalance.abs() < ROUNDING, "{cell:?}: {answer:?}");
                let sum: f64 = answer.lost.iter().sum::<f64>() + answer.kept;
                assert!((sum - 1.0).abs() < ROUNDING, "{cell:?}: {answer:?}");
                assert_eq!(answer.unmet, 0, "{cell:?}");
                // What can be lost is lost.
                let expected = [restitution < 1.0, mu > 0.0, rolling > 0.0, rolling > 0.0];
                for (share, expected) in answer.lost.into_iter().zip(expected) {
                    assert_eq!(share > 1e-3, expected, "{cell:?}: {answer:?}");
                }
                answer.largest
            });
            let [low, high] = [f64::min, f64::max].map(|pick| answers.into_iter().reduce(pick));
            let ratio = high.unwrap_or(f64::NAN) / low.unwrap_or(f64::NAN);
            assert!(ratio < CHAOS, "e {restitution}, mu {mu}: {answers:?}");
        }
    }
}

#[test]
fn without_rebound_friction_takes_too() {
    friction_takes_at(&[0.04, 0.02]);
}

#[test]
#[ignore = "for its breadth: cargo test --release -p tribos-tests --test contacts cd_restitution -- --ignored"]
fn without_rebound_friction_takes_in_small_steps_too() {
    friction_takes_at(&[0.01]);
}

/// Runs in steps of each of these times.
fn friction_takes_at(steps: &[f64]) {
    for (mu, rolling) in [(0.3, 0.3), (1.0, 0.0), (10.0, 0.0), (10.0, 0.3)] {
        for &dt in steps {
            let cell = Cell {
                restitution: 0.0,
                mu,
                rolling,
                dt,
            };
            let answer = run(cell, TIME);
            // To the solver's tolerance, which every step meets.
            assert!(answer.least > -1e-10, "{cell:?}: {answer:?}");
            assert_eq!(answer.unmet, 0, "{cell:?}");
            assert!(answer.imbalance.abs() < ROUNDING, "{cell:?}: {answer:?}");
        }
    }
}

/// A solid ball of radius 1 above the floor by this gap, coming down at 1, at `across` along x,
/// spinning about z.
fn oblique(law: NormalLaw<f64>, friction: Rough, [across, gap]: [f64; 2], dt: f64) -> World<Rough> {
    let mut setup = chain(1, WorldMaterials::uniform(law, friction));
    setup.positions[0].z += gap;
    setup.gravity.fill(0.0);
    setup.spheres[0].velocity = Vector3::new(across, 0.0, -1.0);
    setup.spheres[0].spin.z = 1.0;
    setup.step_limits = StepLimits {
        longest: dt,
        motion: 10.0,
    };
    World::new(setup).expect("the setup is valid")
}

#[test]
fn an_oblique_impact_is_the_closed_solution_at_every_step() {
    // Walton (1993): with m_t = 2/7 m the slip falls by 7/2 μ (1 + e) of the approach, or stops.
    let mu = 0.2;
    for restitution in [0.1, 0.5, 0.9, 1.0] {
        let slips = 3.5 * mu * (1.0 + restitution);
        for across in [0.3, 0.999 * slips, 1.001 * slips, 5.0] {
            // Steps leave different gaps when they take the impact.
            for (dt, gap) in [(0.1, 0.0), (0.1, 0.17), (0.01, 0.17), (0.003, 0.17)] {
                let friction = rough(mu, 0.0, 0.1);
                let mut world = oblique(bouncing(restitution), friction, [across, gap], dt);
                let mut largest = 0.0_f64;
                while world.state().time < 0.8 {
                    world.step().expect("a ball can step");
                    let links = world.problem().links();
                    let normals = links.map(|link| link.contact.impulse().normal);
                    largest = normals.fold(largest, f64::max);
                }
                let ball = &world.state().spheres[0];
                let mass = 1.0 / ball.inv_mass;
                let stopped = across.min(slips);
                let velocity = Vector3::new(across - stopped * 2.0 / 7.0, 0.0, restitution);
                assert!((ball.velocity - velocity).norm() < ROUNDING);
                assert!((ball.spin.y - stopped * 5.0 / 7.0).abs() < ROUNDING);
                // μ_n P R on I = 2/5 m R².
                let spin = 1.0 - 0.1 * (1.0 + restitution) / 0.4;
                assert!((ball.spin.z - spin.max(0.0)).abs() < ROUNDING);
                assert!((largest / mass - 1.0 - restitution).abs() < ROUNDING);
                // Each share by itself.
                let book = &world.state().energy;
                let normal = 0.5 * (1.0 - restitution * restitution);
                let sliding = stopped * (2.0 * across - stopped) / 7.0;
                assert!((book.normal / mass - normal).abs() < ROUNDING);
                assert!((book.sliding / mass - sliding).abs() < ROUNDING);
                let turning = 0.2 * (1.0 - spin.max(0.0).powi(2));
                assert!((book.torsion / mass - turning).abs() < ROUNDING);
            }
        }
    }
}

/// Smooth balls along x at these places, the first of which moves at 1.
fn row(places: &[f64], restitution: f64, dt: f64) -> World<Rough> {
    let places = places.iter().map(|x| Vector3::new(*x, 0.0, 0.0)).collect();
    let laws = WorldMaterials::uniform(bouncing(restitution), rough(0.0, 0.0, 0.0));
    let mut setup = spheres(places, laws);
    setup.spheres[0].velocity.x = 1.0;
    setup.step_limits = StepLimits {
        longest: dt,
        motion: 1.0,
    };
    World::new(setup).expect("the setup is valid")
}

#[test]
fn an_oblique_impact_of_two_balls_depends_on_the_step_in_the_first_order() {
    // Off the line of centres, so that the normal turns on the way; all of it sticks.
    let impulses = |dt| {
        let places = vec![Vector3::zeros(), Vector3::new(2.3, 0.5, 0.0)];
        let mut setup = spheres(
            places,
            WorldMaterials::uniform(bouncing(0.9), rough(10.0, 0.0, 0.0)),
        );
        setup.spheres[0].velocity.x = 1.0;
        setup.step_limits = StepLimits {
            longest: dt,
            motion: 1.0,
        };
        let mut world = World::new(setup).expect("the setup is valid");
        while world.step().expect("two balls can step").impacts == 0 {}
        let momentum = |world: &World<Rough>| {
            let (x, balls) = (&world.state().positions, &world.state().spheres);
            let turning = x.iter().zip(balls).map(|(x, ball)| {
                x.cross(&ball.velocity) / ball.inv_mass + ball.spin / ball.inv_inertia
            });
            turning.sum::<Vector3<f64>>()
        };
        assert!(momentum(&world).norm() < ROUNDING);
        let impulse = world.problem().pairs.impulses[0];
        [impulse.normal, impulse.sliding().norm()]
    };
    let finest = impulses(1e-5);
    let steps = [0.1, 0.01, 1e-3];
    for dt in steps {
        let found = impulses(dt);
        let apart = found.iter().zip(finest);
        let apart = apart.map(|(p, fine)| (p / fine - 1.0).abs());
        let worst = apart.fold(0.0, f64::max);
        println!("step {dt}: impulses {found:?}, off by {worst:.1e}");
        // A step moves the ball by dt, so much of its radius.
        assert!(worst < dt, "step {dt}: {worst}");
    }
}

#[test]
fn impacts_that_share_a_step_follow_each_other() {
    for gap in [0.0, 1e-12, 1e-3, 0.1] {
        for dt in [0.2, 0.02, 0.005] {
            let places = [0.0, 2.0 + gap, 4.0 + 2.0 * gap, 6.0 + 3.0 * gap];
            let mut world = row(&places, 1.0, dt);
            while world.state().time < 1.0 {
                world.step().expect("a row can step");
            }
            let speeds = world.state().spheres.iter().map(|ball| ball.velocity.x);
            // The last one takes all, as in Newton's cradle.
            for (speed, wanted) in speeds.zip([0.0, 0.0, 0.0, 1.0]) {
                assert!((speed - wanted).abs() < ROUNDING, "gap {gap}, dt {dt}");
            }
        }
    }
}

#[test]
fn a_gas_without_loss_keeps_its_energy_at_every_step() {
    for dt in [0.04, 0.01] {
        let cell = Cell {
            restitution: 1.0,
            mu: 0.0,
            rolling: 0.0,
            dt,
        };
        let answer = run(cell, TIME);
        assert!((answer.kept - 1.0).abs() < ROUNDING, "{answer:?}");
        assert!(answer.largest > 1.0);
    }
}

#[test]
fn two_impacts_at_once_keep_their_symmetry() {
    // One ball runs into two that touch each other: 2/5 v√3 each, and −1/5 v back.
    let places = vec![
        Vector3::new(-3.0_f64.sqrt(), 0.0, 0.0),
        Vector3::new(0.0, 1.0, 0.0),
        Vector3::new(0.0, -1.0, 0.0),
    ];
    let laws = WorldMaterials::uniform(bouncing(1.0), rough(0.0, 0.0, 0.0));
    let mut setup = spheres(places, laws);
    setup.spheres[0].velocity.x = 1.0;
    let mut world = World::new(setup).expect("the setup is valid");
    world.step().expect("three balls can step");
    let balls = &world.state().spheres;
    assert!((balls[0].velocity - Vector3::x() * -0.2).norm() < ROUNDING);
    let side = 0.4 * 3.0_f64.sqrt();
    for (ball, sign) in balls[1..].iter().zip([1.0, -1.0]) {
        let wanted = Vector3::new(0.75_f64.sqrt(), 0.5 * sign, 0.0) * side;
        assert!((ball.velocity - wanted).norm() < ROUNDING);
    }
}

/// A smooth ball let go 1 above the floor, under gravity 1.
fn dropped(restitution: f64, dt: f64) -> World<Rough> {
    let laws = WorldMaterials::uniform(bouncing(restitution), rough(0.0, 0.0, 0.0));
    let mut setup = chain(1, laws);
    setup.positions[0].z = 2.0;
    setup.step_limits = StepLimits {
        longest: dt,
        motion: 10.0,
    };
    World::new(setup).expect("the setup is valid")
}

#[test]
fn a_ball_that_loses_nothing_comes_back_to_its_height() {
    for dt in [0.013, 0.003] {
        let mut world = dropped(1.0, dt);
        let (mut highest, mut bounces) = (0.0_f64, 0);
        while bounces < 30 {
            let report = world.step().expect("a ball can step");
            bounces += report.impacts;
            if bounces >= 29 {
                highest = highest.max(world.state().positions[0].z);
            }
        }
        // The fall's own error of the step, not one of every bounce.
        assert!((highest - 2.0).abs() < 2.0 * dt, "dt {dt}: {highest}");
        assert!(world.state().energy.imbalance().abs() < 1e-11);
    }
}

#[test]
fn bounces_converge_with_the_first_power_of_the_step() {
    // It falls for √2 and then flies for 2√2 eⁿ.
    let (restitution, time): (f64, f64) = (0.8, 5.0);
    let (mut start, mut speed) = (2.0_f64.sqrt(), 2.0_f64.sqrt() * restitution);
    while start + 2.0 * speed < time {
        start += 2.0 * speed;
        speed *= restitution;
    }
    let since = time - start;
    let wanted = 1.0 + speed * since - 0.5 * since * since;
    let errors = [100, 200, 400, 800, 1600, 3200].map(|steps| {
        let mut world = dropped(restitution, time / f64::from(steps));
        for _ in 0..steps {
            world.step().expect("a ball can step");
        }
        (world.state().positions[0].z - wanted).abs()
    });
    println!("errors of the height: {errors:?}");
    // The moment of an impact within its step is chance: first order in the bound.
    for (halving, error) in errors.iter().enumerate() {
        assert!(*error < 8.0 * 0.05 / f64::from(1 << halving), "{errors:?}");
    }
}

#[test]
fn a_gas_before_chaos_converges_with_the_first_power_of_the_step() {
    let cell = |dt| Cell {
        restitution: 0.9,
        mu: 0.5,
        rolling: 0.1,
        dt,
    };
    let time = 0.7;
    let after = |steps: u32| {
        let mut world = World::new(rebounds::setup(cell(time / f64::from(steps)))).expect("valid");
        let mut impacts = 0;
        for _ in 0..steps {
            impacts += world.step().expect("the gas can step").impacts;
        }
        assert!(impacts > 5, "{impacts}");
        world.state().positions.clone()
    };
    let finest = after(4096);
    let errors = [32, 64, 128, 256].map(|steps| {
        let apart = after(steps)
            .iter()
            .zip(&finest)
            .map(|(x, y)| (x - y).norm_squared())
            .sum::<f64>();
        (apart / 64.0).sqrt()
    });
    println!("errors of the places: {errors:?}");
    let order = (errors[0] / errors[3]).log2() / 3.0;
    assert!((order - 1.0).abs() < 0.5, "order {order}: {errors:?}");
}

#[test]
fn other_coefficients_at_walls_driven_walls_and_cohesion_close_the_book() {
    let mut rebounds = 0;
    for (strength, pair, wall) in [
        (0.0, 0.9, 0.4),
        (0.0, 0.0, 1.0),
        (2.0, 0.7, 0.7),
        (2.0, 1.0, 0.0),
    ] {
        let law = |restitution| {
            let cohesion = Cohesion::new(strength, 0.1, Attraction::Pull).expect("valid");
            NormalLaw::new(cohesion, restitution).expect("the law is valid")
        };
        let cell = Cell {
            restitution: 0.0,
            mu: 0.5,
            rolling: 0.2,
            dt: 0.02,
        };
        let mut setup = rebounds::setup(cell);
        (setup.laws.pairs.normal, setup.laws.walls.normal) = (law(pair), law(wall));
        setup.gravity = Vector3::new(0.3, 0.0, -0.5);
        setup.walls[0].plate.velocity = Vector3::new(0.2, 0.5, 0.0);
        setup.walls[5] = Wall::piston(-Vector3::z(), -16.0, 100.0, 50.0);
        let mut world = World::new(setup).expect("the setup is valid");
        for _ in 0..100 {
            let before = world.state().energy;
            rebounds += world.step().expect("the gas can step").impacts;
            let (after, scale) = (world.state().energy, before.kinetic + 1.0);
            let changes = [
                after.normal - before.normal,
                after.sliding - before.sliding,
                after.rolling - before.rolling,
                after.torsion - before.torsion,
            ];
            assert!(
                changes.iter().all(|loss| *loss > -1e-9 * scale),
                "{changes:?}"
            );
        }
        let book = world.state().energy;
        let scale = book.kinetic_initial.unwrap_or(0.0);
        assert!(book.imbalance().abs() < 10.0 * ROUNDING * scale, "{book:?}");
    }
    assert!(rebounds > 50, "{rebounds}");
}

#[test]
fn a_run_with_rebounds_repeats_and_resumes_to_the_same_bits() {
    let setup: WorldSetup<Rough> = gas(periodic([true; 3]), bouncing(0.9), rough(0.5, 0.3, 0.2));
    let steps = |world: &mut World<Rough>, count| {
        for _ in 0..count {
            world.step().expect("the gas can step");
        }
    };
    let mut through = World::new(setup.clone()).expect("the setup is valid");
    steps(&mut through, 60);
    let mut first = World::new(setup.clone()).expect("the setup is valid");
    steps(&mut first, 35);
    let mut resumed = World::resume(setup, first.state().clone());
    steps(&mut resumed, 25);
    let bits = |world: &World<Rough>| format!("{:?}", world.state());
    assert_eq!(bits(&resumed), bits(&through));
}

#[test]
fn impulses_of_a_step_explain_its_velocities() {
    let mut world = oblique(bouncing(0.6), rough(0.3, 0.1, 0.1), [2.0, 0.0], 0.05);
    let mass = 1.0 / solid(1.0, 1.0).inv_mass;
    loop {
        let before = world.state().spheres[0].velocity;
        let report = world.step().expect("a ball can step");
        let change = (world.state().spheres[0].velocity - before) * mass;
        let impulses = world.problem().links().map(|link| {
            let impulse = link.contact.impulse();
            // The ball is the first body.
            -(link.contact.normal() * impulse.normal + impulse.sliding())
        });
        assert!((change - impulses.sum::<Vector3<f64>>()).norm() < ROUNDING);
        if report.impacts > 0 {
            assert_eq!(
                (report.impacts, report.impact_rounds, report.impacts_cut),
                (1, 1, false)
            );
            break;
        }
    }
}

/// A cube of spheres that touch, `side` along an edge, thrown on the floor with spins.
fn block(side: usize, law: NormalLaw<f64>, friction: Rough) -> World<Rough> {
    let place = |index: usize| {
        let cell = [index % side, index / side % side, index / side / side];
        Vector3::from(cell.map(|cell| 2.0 * cell as f64)) + Vector3::z()
    };
    let places = (0..side.pow(3)).map(place).collect();
    let mut setup = spheres(places, WorldMaterials::uniform(law, friction));
    setup.walls = vec![Wall::fixed(Vector3::z(), 0.0)];
    let mut random = Random::new(7, 1);
    let mut vector = || Vector3::from([(); 3].map(|()| 2.0 * random.unit() - 1.0));
    for sphere in &mut setup.spheres {
        (sphere.velocity, sphere.spin) = (vector() - Vector3::z(), vector());
    }
    World::new(setup).expect("the setup is valid")
}

#[test]
fn impulses_far_below_the_momenta_are_solved_to_rounding() {
    for restitution in [0.5, 1.0] {
        for mu in [0.3, 1.0, 10.0] {
            for side in [4, 6] {
                let mut world = block(side, bouncing(restitution), rough(mu, 0.0, 0.0));
                let report = world.step().expect("the block can step");
                let case = format!("e {restitution}, mu {mu}, side {side}: {report:?}");
                // Impulses of the last rounds are 1e-8 of the first.
                assert!(report.impact_rounds >= 8, "{case}");
                assert_eq!(report.impacts_unmet, 0, "{case}");
                let met = report.iterations.met && !report.impacts_cut;
                assert_eq!(report.is_met(), met, "{case}");
                let book = world.state().energy;
                let scale = book.kinetic_initial.unwrap_or(f64::NAN);
                assert!(book.imbalance().abs() < ROUNDING * scale, "{case}");
                for loss in [book.normal, book.sliding] {
                    assert!(loss > -ROUNDING * scale, "{case}: {book:?}");
                }
            }
        }
    }
}

#[test]
fn a_step_whose_impacts_are_cut_is_not_met() {
    // Ten spheres that touch: with e = 0.5 every round leaves approaches for the next.
    let reports = [0.5, 1.0].map(|restitution| {
        let friction = rough(0.5, 0.0, 0.0);
        let mut setup = chain(10, WorldMaterials::uniform(bouncing(restitution), friction));
        setup.gravity.fill(0.0);
        for sphere in &mut setup.spheres {
            sphere.velocity.z = -1.0;
        }
        let mut world = World::new(setup).expect("the setup is valid");
        world.step().expect("the chain can step")
    });
    let told = reports.map(|report| {
        assert!(report.iterations.met);
        (report.impact_rounds, report.impacts_cut, report.is_met())
    });
    assert_eq!(told, [(100, true, false), (19, false, true)]);
}
