//! A body on a table, with and without patch.

use rapier3d::prelude::*;
use tribos_rapier::{Patch, PatchContacts};

pub use crate::exact::{GRAVITY, MU, RADIUS};

pub const HALF_HEIGHT: f32 = 0.01;

pub struct Table {
    pub world: PhysicsWorld,
    pub patches: PatchContacts,
    pub ground: ColliderHandle,
}

impl Table {
    /// A fixed table whose top is the plane y = 0, turned about the origin.
    pub fn turned(rotation: Rotation, gravity: Vector) -> Self {
        let below = rotation * Vector::new(0.0, -0.1, 0.0);
        let body = RigidBodyBuilder::fixed().pose(Pose::from_parts(below, rotation));
        Self::on(body, gravity)
    }

    /// A table of 10 m width on a body.
    pub fn on(body: RigidBodyBuilder, gravity: Vector) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = gravity;
        let top = ColliderBuilder::cuboid(5.0, 0.1, 5.0).friction(MU);
        let (_, ground) = world.insert(body, top);
        Self {
            world,
            patches: PatchContacts::new(),
            ground,
        }
    }

    pub fn level() -> Self {
        Self::turned(Rotation::IDENTITY, Vector::new(0.0, -GRAVITY, 0.0))
    }

    /// A body that lies on the table and never sleeps; with a patch if one is given.
    pub fn put(
        &mut self,
        body: RigidBodyBuilder,
        shape: ColliderBuilder,
        patch: Option<Patch>,
    ) -> (RigidBodyHandle, ColliderHandle) {
        let body = body.can_sleep(false).allow_fast_rotation(true);
        let (body, foot) = self.world.insert(body, shape.friction(MU));
        if let Some(patch) = patch {
            self.give(foot, patch);
        }
        (body, foot)
    }

    /// Gives a foot a patch on the table.
    pub fn give(&mut self, foot: ColliderHandle, patch: Patch) {
        let world = &mut self.world;
        self.patches
            .insert(
                foot,
                self.ground,
                patch,
                &world.bodies,
                &mut world.colliders,
            )
            .expect("a dynamic foot");
    }

    pub fn steps(&mut self, steps: usize) {
        for _ in 0..steps {
            self.patches.step(&mut self.world);
        }
    }
}

/// A body whose lowest point touches the plane y = 0, in the middle.
pub fn lying(half_height: f32) -> RigidBodyBuilder {
    RigidBodyBuilder::dynamic().translation(Vector::new(0.0, half_height, 0.0))
}

pub fn puck_shape() -> ColliderBuilder {
    ColliderBuilder::cylinder(HALF_HEIGHT, RADIUS)
}

pub fn disk() -> Option<Patch> {
    Patch::disk(MU, RADIUS).ok()
}

pub fn ring() -> Option<Patch> {
    Patch::ring(MU, RADIUS).ok()
}
