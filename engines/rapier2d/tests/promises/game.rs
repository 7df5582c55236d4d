//! A world seen from above.

use crate::exact::Throw;
use rapier2d::prelude::*;
use tribos_rapier2d::Floor;

pub use crate::exact::{GRAVITY, MU, RADIUS};

pub struct Game {
    pub world: PhysicsWorld,
    pub floor: Floor,
}

impl Game {
    /// A floor that is inclined along x: `pull` m/s² in the plane.
    pub fn inclined(pull: f32) -> Self {
        let mut game = Self::under(GRAVITY);
        game.world.gravity = Vector::new(pull, 0.0);
        game
    }

    /// A level floor under a gravity towards it.
    pub fn under(gravity: f32) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let floor = Floor::new(MU, gravity).expect("sound numbers");
        Self { world, floor }
    }

    pub fn level() -> Self {
        Self::inclined(0.0)
    }

    /// A body that never sleeps.
    pub fn put(&mut self, body: RigidBodyBuilder, shape: ColliderBuilder) -> RigidBodyHandle {
        let body = body.can_sleep(false).allow_fast_rotation(true);
        self.world
            .insert(body, shape.friction(0.2).restitution(0.5))
            .0
    }

    pub fn steps(&mut self, steps: usize) {
        for _ in 0..steps {
            self.floor.step(&mut self.world);
        }
    }

    /// Travel and time until rest of a body that began at the origin.
    pub fn run_to_rest(&mut self, body: RigidBodyHandle) -> Throw {
        let dt = f64::from(self.world.integration_parameters.dt);
        for step in 0..600 {
            self.steps(1);
            if let Some(stop) = self.floor.stop(body) {
                let place = self.world.bodies[body].center_of_mass();
                return Throw {
                    travel: f64::from(place.length()),
                    stop: f64::from(step) * dt + f64::from(stop.within_step),
                };
            }
        }
        panic!("moves after ten seconds");
    }
}

pub fn disk() -> ColliderBuilder {
    ColliderBuilder::ball(RADIUS)
}

pub fn thrown(speed: f32, spin: f32) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic()
        .linvel(Vector::new(speed, 0.0))
        .angvel(spin)
}
