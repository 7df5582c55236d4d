//! Rapier with patches before the problems of friction-answers:
//!
//! `cargo build --release --manifest-path engines/Cargo.toml -p tribos-rapier --example rapier_answers`, then
//! `friction-answers run engines/target/release/examples/librapier_answers.so`.

use core::ffi::CStr;
use friction_answers_engine::{Body, Engine, FOOT, Scene, Shape, State};
use rapier3d::prelude::*;
use tribos_rapier::{GroundMu, Patch, PatchContacts};

/// Thickness of the ground in m.
const GROUND: f32 = 0.5;
/// Radius of the patch of a foot, in m: a point.
const POINT: f32 = 1e-4;

#[derive(Default)]
struct Patched {
    world: PhysicsWorld,
    patches: PatchContacts,
    bodies: Vec<RigidBodyHandle>,
}

fn vector(v: [f64; 3]) -> Vector {
    Vector::new(v[0] as f32, v[1] as f32, v[2] as f32)
}

fn numbers(v: Vector) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

/// Colliders of a body, each with a patch where it has no flat face, which gets one by itself.
fn colliders(body: &Body, mu: f32) -> Vec<(ColliderBuilder, Option<Patch>)> {
    match body.shape {
        Shape::Box([x, y, z]) => {
            vec![(ColliderBuilder::cuboid(x as f32, y as f32, z as f32), None)]
        }
        Shape::Ball(radius) => vec![(ColliderBuilder::ball(radius as f32), None)],
        Shape::Capsule(radius, half) => {
            vec![(ColliderBuilder::capsule_x(half as f32, radius as f32), None)]
        }
        Shape::Cylinder(radius, half, is_rim) => {
            let is_upright = body.pose[3] == 1.0;
            let own = match (is_rim, is_upright) {
                (true, _) => Patch::ring(mu, radius as f32).ok(),
                (false, true) => None,
                (false, false) => Patch::bar(mu, half as f32)
                    .ok()
                    .map(|bar| bar.along(Vector::Y)),
            };
            vec![(ColliderBuilder::cylinder(half as f32, radius as f32), own)]
        }
        Shape::Feet(feet) => feet
            .map(|[x, z]| {
                let ball = ColliderBuilder::ball(FOOT as f32).translation(vector([x, 0.0, z]));
                (ball, Patch::disk(mu, POINT).ok())
            })
            .into(),
    }
}

impl Engine for Patched {
    const ABOUT: &CStr = c"{\"name\": \"Rapier with tribos\", \"version\": \"0.36\", \"licence\": \"MIT OR Apache-2.0\", \"kind\": \"games\", \"settings\": {\
        \"default\": {\"dt\": 0.016666666666666666}, \"240 Hz, no recycling\": {\"dt\": 0.004166666666666667}, \
        \"1 ms, no recycling\": {\"dt\": 0.001}}}";

    fn new(scene: &Scene) -> Result<Self, &'static CStr> {
        let mut made = Self::default();
        made.world.gravity = vector(scene.gravity);
        made.world.integration_parameters.dt = scene.dt as f32;
        made.world.integration_parameters.contact_recycling = scene.setting == 0;
        let mu = scene.mu as f32;
        let refused = c"The patch was refused.";
        let mut grounds = Vec::new();
        if scene.has_floor {
            let floor = ColliderBuilder::cuboid(50.0, GROUND, 50.0).friction(mu);
            let fixed = RigidBodyBuilder::fixed().translation(Vector::new(0.0, -GROUND, 0.0));
            grounds.push(made.world.insert(fixed, floor).1);
        }
        for body in &scene.bodies {
            let builder = if body.is_driven {
                RigidBodyBuilder::kinematic_velocity_based()
            } else {
                RigidBodyBuilder::dynamic()
            };
            let [x, y, z, w] = body.pose.map(|part| part as f32);
            let mass =
                MassProperties::new(vector(body.com), body.mass as f32, vector(body.inertia));
            let builder = builder
                .translation(vector(body.place))
                .additional_mass_properties(mass)
                .can_sleep(false);
            let handle = made.world.insert_body(
                builder
                    .allow_fast_rotation(true)
                    .gyroscopic_forces_enabled(true),
            );
            made.world.bodies[handle].set_rotation(Rotation::from_xyzw(x, y, z, w), true);
            made.bodies.push(handle);
            for (shape, patch) in colliders(body, mu) {
                let foot = made
                    .world
                    .insert_collider(shape.density(0.0).friction(mu), Some(handle));
                let PhysicsWorld {
                    bodies, colliders, ..
                } = &mut made.world;
                if let (Some(patch), Some(&floor)) = (patch, grounds.first()) {
                    made.patches
                        .insert(foot, floor, patch, bodies, colliders)
                        .or(Err(refused))?;
                }
                if body.is_driven {
                    grounds.push(foot);
                }
            }
        }
        for ground in grounds {
            made.patches
                .insert_ground(ground, GroundMu::Combined, &mut made.world.colliders)
                .or(Err(refused))?;
        }
        Ok(made)
    }

    fn set(&mut self, body: usize, velocity: [f64; 3], spin: [f64; 3]) {
        let body = &mut self.world.bodies[self.bodies[body]];
        body.set_linvel(vector(velocity), true);
        body.set_angvel(vector(spin), true);
    }

    fn step(&mut self) {
        self.patches.step(&mut self.world);
        for &body in &self.bodies {
            self.world.bodies[body].reset_forces(true);
        }
    }

    fn state(&self, body: usize) -> State {
        let body = &self.world.bodies[self.bodies[body]];
        let pose = body.rotation();
        State {
            place: numbers(body.center_of_mass()),
            pose: [pose.x, pose.y, pose.z, pose.w].map(f64::from),
            velocity: numbers(body.linvel()),
            spin: numbers(body.angvel()),
        }
    }

    fn gravity(&mut self, gravity: [f64; 3]) {
        self.world.gravity = vector(gravity);
    }

    fn force(&mut self, body: usize, force: [f64; 3]) {
        self.world.bodies[self.bodies[body]].add_force(vector(force), true);
    }
}

friction_answers_engine::export!(Patched);
