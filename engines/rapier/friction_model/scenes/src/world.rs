//! A floor, bodies on it, and steps.

use rapier3d::prelude::*;

pub const GRAVITY: f32 = 9.81;

/// A floor whose slope has this tangent, along x.
pub fn new_world(model: FrictionModel, rate_hz: f32, tangent: f32, mu: f32) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let cosine = (1.0 + tangent * tangent).sqrt().recip();
    world.gravity = Vector::new(GRAVITY * tangent * cosine, -GRAVITY * cosine, 0.0);
    world.integration_parameters.dt = rate_hz.recip();
    world.integration_parameters.friction_model = model;
    let floor = ColliderBuilder::cuboid(50.0, 1.0, 50.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.insert_collider(floor.friction(mu), None);
    world
}

/// A body that does not sleep, turned about the vertical.
pub fn add_body(
    world: &mut PhysicsWorld,
    shape: ColliderBuilder,
    position: Vector,
    angle: f32,
    mu: f32,
) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic()
        .translation(position)
        .rotation(Vector::new(0.0, angle, 0.0))
        .can_sleep(false)
        .allow_fast_rotation(true);
    world.insert(body, shape.friction(mu)).0
}

pub fn throw(world: &mut PhysicsWorld, body: RigidBodyHandle, velocity: Vector, spin: f32) {
    world.bodies[body].set_linvel(velocity, true);
    world.bodies[body].set_angvel(Vector::new(0.0, spin, 0.0), true);
}

pub fn step_for(world: &mut PhysicsWorld, seconds: f32) {
    let steps = (seconds / world.integration_parameters.dt).round() as usize;
    for _ in 0..steps {
        world.step();
    }
}

/// Angle about the vertical, in rad.
pub fn heading(world: &PhysicsWorld, body: RigidBodyHandle) -> f32 {
    let q = world.bodies[body].rotation();
    within_half_turn(2.0 * q.y.atan2(q.w))
}

pub fn within_half_turn(angle: f32) -> f32 {
    let turn = std::f32::consts::TAU;
    angle - turn * (angle / turn).round()
}
