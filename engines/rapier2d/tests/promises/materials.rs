//! Materials of the floor and of single bodies.

use crate::game::*;
use rapier2d::prelude::*;
use tribos_rapier2d::FloorError;

const ICE: f32 = 0.05;

fn on_ice(from: f32, to: f32) -> Game {
    let mut game = Game::level();
    let half = 0.5 * (to - from);
    let ice = SharedShape::cuboid(half, 10.0);
    let at = Pose::translation(from + half, 0.0);
    game.floor.add_region(ice, at, ICE).unwrap();
    game
}

#[test]
fn a_puck_on_ice_alone_stops_as_on_a_floor_of_ice() {
    for spin in [0.0, 12.5] {
        let mut game = on_ice(-5.0, 5.0);
        let puck = game.put(thrown(1.0, spin), disk());
        let mut own = Game::level();
        let same = own.put(thrown(1.0, spin), disk());
        own.floor.set_mu(same, ICE).unwrap();
        assert_eq!(game.run_to_rest(puck), own.run_to_rest(same));
    }
}

#[test]
fn a_puck_that_leaves_the_ice_stops_by_the_energy_that_is_left() {
    let mut game = on_ice(-5.0, 0.5);
    let puck = game.put(thrown(2.0, 0.0), disk());
    let travel = game.run_to_rest(puck).travel;
    // Without spin friction is the mean coefficient below the area, whose centre passes the border.
    let (mu, ice, g) = (f64::from(MU), f64::from(ICE), f64::from(GRAVITY));
    let right = 0.5 + (2.0 - ice * g * 0.5) / (mu * g);
    assert!(
        (travel / right - 1.0).abs() < 5e-3,
        "{travel} m for {right} m"
    );
}

#[test]
fn a_puck_half_on_ice_turns_towards_the_rough_side() {
    let mut game = Game::level();
    let ice = SharedShape::cuboid(10.0, 5.0);
    game.floor
        .add_region(ice, Pose::translation(0.0, 5.0), ICE)
        .unwrap();
    let puck = game.put(thrown(2.0, 0.0), disk());
    game.steps(1);
    // Force and torque of a half disk at its centroid, 4 R/(3 π) off the middle, while nothing spins.
    let weight = GRAVITY * game.world.bodies[puck].mass();
    let friction = game.floor.friction(puck).unwrap();
    let force = 0.5 * weight * (MU + ICE);
    let torque = 0.5 * weight * (MU - ICE) * 4.0 * RADIUS / (3.0 * core::f32::consts::PI);
    assert!(
        (friction.force.x / -force - 1.0).abs() < 1e-2,
        "{friction:?} for {force}"
    );
    // The rough half is at y < 0: its pull backwards turns clockwise.
    assert!(
        (friction.torque / -torque - 1.0).abs() < 3e-2,
        "{friction:?} for {torque}"
    );
}

#[test]
fn the_last_region_counts_and_a_removed_one_does_not() {
    let mut game = Game::level();
    let add = |game: &mut Game, mu: f32| {
        game.floor
            .add_region(SharedShape::ball(1.0), Pose::identity(), mu)
            .unwrap()
    };
    add(&mut game, 0.1);
    let carpet = add(&mut game, 0.9);
    assert_eq!(game.floor.mu_at(Vector::ZERO), 0.9);
    assert!(game.floor.remove_region(carpet) && !game.floor.remove_region(carpet));
    assert_eq!(game.floor.mu_at(Vector::ZERO), 0.1);
    assert_eq!(game.floor.mu_at(Vector::new(2.0, 0.0)), MU);
}

#[test]
fn own_coefficient_load_and_reset_apply() {
    let decelerated = |set: &dyn Fn(&mut Game, RigidBodyHandle)| {
        let mut game = Game::level();
        let puck = game.put(thrown(3.0, 0.0), disk());
        set(&mut game, puck);
        game.steps(30);
        (3.0 - game.world.bodies[puck].linvel().x) / 0.5
    };
    let near = |is: f32, right: f32| assert!((is - right).abs() < 1e-4, "{is} for {right}");
    near(decelerated(&|_, _| ()), MU * GRAVITY);
    near(
        decelerated(&|game, puck| game.floor.set_mu(puck, 0.0).unwrap()),
        0.0,
    );
    near(
        decelerated(&|game, puck| game.floor.set_mu(puck, 0.1).unwrap()),
        0.1 * GRAVITY,
    );
    let heavy = |game: &mut Game, puck: RigidBodyHandle| {
        let weight = GRAVITY * game.world.bodies[puck].mass();
        game.floor.set_load(puck, 1.5 * weight).unwrap();
    };
    near(decelerated(&heavy), 1.5 * MU * GRAVITY);
    let reset = |game: &mut Game, puck: RigidBodyHandle| {
        heavy(game, puck);
        game.floor.reset(puck);
    };
    near(decelerated(&reset), MU * GRAVITY);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let mut game = Game::level();
    let puck = game.put(RigidBodyBuilder::dynamic(), disk());
    let refused = game.floor.set_load(puck, f32::NAN);
    assert!(matches!(refused, Err(FloorError::Load { .. })));
    assert_eq!(
        game.floor.set_mu(puck, -1.0),
        Err(FloorError::Coefficient { given: -1.0 })
    );
    assert_eq!(
        game.floor.set_feet(puck, Vec::new()),
        Err(FloorError::NoFeet)
    );
}
