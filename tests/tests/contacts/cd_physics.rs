//! One sphere in a world against closed solutions: rolling, slopes, spin-down, pull-off.
//!
//! Gravity 1, radius 1, density 1. Implicit Euler is exact in the velocity under a constant force;
//! places lag by half a step.

use nalgebra::Vector3;
use tribos::cd::{StepLimits, Wall, World, WorldMaterials, WorldSetup};
use tribos_core::contact::{Attraction, Cohesion, NormalLaw};
use tribos_tests::packings::{Rough, chain, dry, rough, spheres};

/// Rounding of a few hundred steps of a single contact.
const ROUNDING: f64 = 1e-13;

/// A ball on the floor z = 0 under gravity, with steps of length `dt` and fast balls allowed.
fn ball(friction: Rough, gravity: Vector3<f64>, dt: f64) -> WorldSetup<Rough> {
    let step_limits = StepLimits {
        longest: dt,
        motion: 4.0,
    };
    WorldSetup {
        gravity,
        step_limits,
        ..chain(1, WorldMaterials::uniform(dry(), friction))
    }
}

/// A world after `time`, a whole number of steps.
fn after(setup: WorldSetup<Rough>, time: f64) -> World<Rough> {
    let steps = (time / setup.step_limits.longest).round() as usize;
    let mut world = World::new(setup).expect("the setup is valid");
    for _ in 0..steps {
        world.step().expect("a single ball can step");
    }
    world
}

/// Gravity 1 seen from a slope whose tangent is `slope`, downhill along x.
fn on_slope(slope: f64) -> Vector3<f64> {
    let cos = 1.0 / slope.hypot(1.0);
    Vector3::new(slope * cos, 0.0, -cos)
}

#[test]
fn a_sliding_ball_ends_at_five_sevenths_of_its_speed() {
    for (mu, dt, speed) in [(0.3, 0.01, 1.0), (0.1, 0.013, 2.0), (1.5, 0.1, 0.5)] {
        let mut setup = ball(rough(mu, 0.0, 0.0), -Vector3::z(), dt);
        setup.spheres[0].velocity.x = speed;
        let sliding = 2.0 * speed / (7.0 * mu);
        let world = after(setup, 1.5 * sliding + dt);
        let ball = &world.state().spheres[0];
        assert!((ball.velocity.x - 5.0 / 7.0 * speed).abs() < ROUNDING);
        assert!((ball.spin.y - ball.velocity.x).abs() < ROUNDING);
        // Friction took the rest: 2/7 of the energy.
        let (book, energy) = (&world.state().energy, 0.5 * speed * speed / ball.inv_mass);
        assert!((book.sliding + book.normal - 2.0 / 7.0 * energy).abs() < ROUNDING);
    }
}

#[test]
fn places_converge_with_the_first_power_of_the_step() {
    let (mu, speed, time) = (0.25, 1.0, 2.0);
    // Slides until 8/7, rolls then.
    let sliding = 2.0 * speed / (7.0 * mu);
    let wanted = speed * sliding - 0.5 * mu * sliding * sliding + 5.0 / 7.0 * (time - sliding);
    let errors = [0.04, 0.02, 0.01, 0.005, 0.0025].map(|dt| {
        let mut setup = ball(rough(mu, 0.0, 0.0), -Vector3::z(), dt);
        setup.spheres[0].velocity.x = speed;
        after(setup, time).state().positions[0].x - wanted
    });
    println!("errors of the way: {errors:?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 1.0).abs() < 0.1, "order {order}");
    }
}

#[test]
fn a_block_on_a_slope_stays_below_mu_and_slides_above() {
    // A ball that cannot roll is a block.
    let (mu, time) = (0.4, 3.0);
    let slide = |slope: f64| {
        let world = after(ball(rough(mu, 10.0, 0.0), on_slope(slope), 0.01), time);
        world.state().spheres[0].velocity.x
    };
    for slope in [0.1, 0.399, mu * (1.0 - 1e-9)] {
        assert!(slide(slope).abs() < 1e-15, "slope {slope}");
    }
    for slope in [mu * (1.0 + 1e-9), 0.401, 0.5, 1.0, 3.0] {
        let down = on_slope(slope);
        let wanted = (down.x + mu * down.z) * time;
        assert!((slide(slope) - wanted).abs() < 1e-12, "slope {slope}");
    }
}

#[test]
fn a_ball_on_a_slope_rolls_without_and_with_resistance() {
    let time = 3.0;
    for mu_rolling in [0.0, 0.05, 0.2] {
        let roll = |slope: f64| {
            let friction = rough(1.0, mu_rolling, 0.0);
            let world = after(ball(friction, on_slope(slope), 0.01), time);
            world.state().spheres[0].velocity.x
        };
        for slope in [0.02, 0.049, 0.051, 0.19, 0.21, 0.5] {
            let down = on_slope(slope);
            // The torque μ_t N R works against gravity's, on the inertia 7/5 m R².
            let wanted = (down.x + mu_rolling * down.z).max(0.0) * time * 5.0 / 7.0;
            let got = roll(slope);
            assert!(
                (got - wanted).abs() < 1e-11,
                "slope {slope}, mu_rolling {mu_rolling}: {got} instead of {wanted}"
            );
        }
    }
}

#[test]
fn torsion_friction_stops_a_top_in_time() {
    let (mu_torsion, spin, dt) = (0.3, 2.0, 0.01);
    let slowing = mu_torsion / 0.4;
    let mut setup = ball(rough(0.5, 0.1, mu_torsion), -Vector3::z(), dt);
    setup.spheres[0].spin.z = spin;
    let mut world = World::new(setup).expect("the setup is valid");
    for step in 1..=400 {
        world.step().expect("a top can step");
        let wanted = (spin - slowing * dt * f64::from(step)).max(0.0);
        assert!((world.state().spheres[0].spin.z - wanted).abs() < ROUNDING);
    }
    let energy = 0.5 * spin * spin / world.state().spheres[0].inv_inertia;
    // The book counts torsion with the velocity at the step's end, the rest under `normal`.
    let book = &world.state().energy;
    assert!((book.torsion + book.normal - energy).abs() < 1e-12);
    assert!((book.torsion - energy).abs() < dt * slowing / spin * energy);
}

/// Strength and range of the pull-off tests.
const PULL: (f64, f64) = (3.0, 0.02);

/// A cohesive ball under a ceiling, at a distance, with weight 4.19.
fn hanging(strength: f64, attraction: Attraction, gap: f64, dt: f64) -> WorldSetup<Rough> {
    let cohesion = Cohesion::new(strength, PULL.1, attraction).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    let mut setup = spheres(
        vec![Vector3::new(0.0, 0.0, -1.0 - gap)],
        WorldMaterials::uniform(normal, rough(0.3, 0.1, 0.1)),
    );
    setup.walls = vec![Wall::fixed(-Vector3::z(), 0.0)];
    setup.gravity = -Vector3::z();
    setup.step_limits = StepLimits {
        longest: dt,
        motion: 0.1,
    };
    setup
}

#[test]
fn breaking_a_contact_takes_its_cohesion_energy() {
    let (strength, range) = PULL;
    let energy = strength * range;
    for attraction in [Attraction::Pull, Attraction::Resistance] {
        let mut errors = Vec::new();
        for halvings in 0..6 {
            let dt = 0.02 / f64::from(1 << halvings);
            let mut world = World::new(hanging(strength, attraction, 0.0, dt)).expect("valid");
            while world.state().positions[0].z > -1.1 {
                world.step().expect("a falling ball can step");
            }
            let (state, weight) = (world.state(), 1.0 / world.state().spheres[0].inv_mass);
            // At the end of the range it falls at √(2 a d_c).
            let speed = (2.0 * (weight - strength) / weight * range).sqrt();
            let error = state.energy.cohesion - energy;
            assert!(
                (-1e-15..=strength * (speed + dt) * dt).contains(&error),
                "{attraction:?}, dt {dt}: {error:e}"
            );
            // What gravity gave beyond the energy of cohesion is motion, up to Euler's loss.
            let kept = state.energy.work - state.energy.cohesion - state.energy.normal;
            assert!((kept - state.energy.kinetic).abs() < 1e-13);
            errors.push(error);
        }
        println!("{attraction:?}: excess of the breaking work {errors:?}");
        assert!(errors[5] < errors[0] / 16.0);
    }
}

#[test]
fn a_pull_just_below_cohesion_holds_and_just_above_breaks() {
    for attraction in [Attraction::Pull, Attraction::Resistance] {
        let fall = |share: f64| {
            let weight = 1.0 / hanging(1.0, attraction, 0.0, 0.01).spheres[0].inv_mass;
            let world = after(hanging(share * weight, attraction, 0.0, 0.01), 10.0);
            -1.0 - world.state().positions[0].z
        };
        assert!(fall(1.0 + 1e-9) <= 1e-15, "{attraction:?}");
        // Exactly met: what rounding of the balance leaves, 1e-16 of g, over 10 time units.
        assert!(fall(1.0).abs() < 1e-14, "{attraction:?}: {:e}", fall(1.0));
        // 1e-4 of its weight is left over: 5e-3 down in this time, or free in the end.
        let gap = fall(1.0 - 1e-4);
        assert!((gap - 0.5e-4 * 100.0).abs() < 1e-5, "{attraction:?}: {gap}");
        assert!(fall(0.9) > 1.0, "{attraction:?}");
    }
}

#[test]
fn let_go_within_the_range_a_pull_closes_and_a_resistance_stays() {
    let closed = |attraction| {
        let mut setup = hanging(1.0, attraction, 0.5 * PULL.1, 0.01);
        setup.gravity.fill(0.0);
        after(setup, 5.0).state().positions[0].z
    };
    assert!((closed(Attraction::Pull) + 1.0).abs() < 1e-15);
    assert_eq!(closed(Attraction::Resistance), -1.0 - 0.5 * PULL.1);
}

#[test]
fn at_a_threshold_met_exactly_nothing_moves() {
    // Pushes of exactly μ N across, in numbers without rounding: slope 1/2, mass aside.
    let down = Vector3::new(0.5, 0.0, -1.0);
    let block = after(ball(rough(0.5, 4.0, 0.0), down, 1.0 / 64.0), 10.0);
    println!(
        "block at the threshold: {:e}",
        block.state().spheres[0].velocity.x
    );
    assert!(block.state().spheres[0].velocity.norm() < 1e-15);
    let roller = after(ball(rough(1.0, 0.5, 0.0), down, 1.0 / 64.0), 10.0);
    println!(
        "ball at the threshold: {:e}",
        roller.state().spheres[0].velocity.x
    );
    assert!(roller.state().spheres[0].velocity.norm() < 1e-14);
}

#[test]
fn a_ball_falls_rebounds_with_e_and_keeps_what_it_should() {
    for restitution in [0.0, 0.3, 0.8, 1.0] {
        let normal = NormalLaw::new(Cohesion::NONE, restitution).expect("the law is valid");
        let mut setup = chain(1, WorldMaterials::uniform(normal, rough(0.0, 0.0, 0.0)));
        setup.gravity.fill(0.0);
        setup.positions[0].z = 1.35;
        setup.spheres[0].velocity = Vector3::new(0.5, 0.0, -1.0);
        let world = after(setup, 1.0);
        let ball = &world.state().spheres[0];
        assert!(
            (ball.velocity.z - restitution).abs() < 1e-15,
            "{}",
            ball.velocity.z
        );
        let lost = 0.5 * (1.0 - restitution * restitution) / ball.inv_mass;
        assert!((world.state().energy.normal - lost).abs() < 1e-14);
    }
}

#[test]
fn driven_walls_do_the_work_that_is_booked() {
    // A floor that carries a ball along, and one that also lifts it.
    for lift in [0.0, 0.2] {
        let mut setup = chain(1, WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1)));
        setup.walls[0].plate.velocity = Vector3::new(0.5, 0.0, lift);
        let mut world = World::new(setup).expect("the setup is valid");
        for _ in 0..100 {
            world.step().expect("the step is taken");
        }
        let book = &world.state().energy;
        assert!(book.imbalance().abs() < 1e-13, "{book:?}");
        // The ball has taken up speed, which only the floor can have given.
        let gravity = lift * world.state().time * world.state().spheres[0].inv_mass.recip();
        assert!(
            book.kinetic > 0.01 && book.work + gravity > book.kinetic,
            "{book:?}"
        );
        assert!(book.sliding > 0.0);
    }
}
