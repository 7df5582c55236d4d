//! Bodies on a table, 60 steps a second.

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::transform::TransformPlugin;
use std::time::Duration;
use tribos_bevy::{FrictionPatch, FrictionPatchPlugin, PatchFriction};

pub use crate::exact::{GRAVITY, MU, RADIUS};

pub const HEIGHT: f32 = 0.02;
pub const STEPS_A_SECOND: f32 = 60.0;

pub struct Table {
    pub app: App,
    pub ground: Entity,
}

impl Table {
    /// A table of 10 m width whose top is the plane y = 0, turned about the origin.
    pub fn turned(rotation: Quat, gravity: Vec3) -> Self {
        Self::on(RigidBody::Static, rotation, gravity)
    }

    /// A table with the components `body`.
    pub fn on(body: impl Bundle, rotation: Quat, gravity: Vec3) -> Self {
        let mut app = App::new();
        app.add_plugins((
            MinimalPlugins,
            TransformPlugin,
            PhysicsPlugins::default(),
            FrictionPatchPlugin,
        ));
        let step = Duration::from_secs_f32(STEPS_A_SECOND.recip());
        app.insert_resource(Time::<Fixed>::from_duration(step));
        app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
        app.insert_resource(Gravity(gravity));
        let place = Transform::from_translation(rotation * (Vec3::NEG_Y * 0.1));
        let ground = app.world_mut().spawn((
            body,
            Collider::cuboid(10.0, 0.2, 10.0),
            Friction::new(MU),
            place.with_rotation(rotation),
        ));
        let ground = ground.id();
        app.finish();
        app.cleanup();
        Self { app, ground }
    }

    pub fn level() -> Self {
        Self::turned(Quat::IDENTITY, Vec3::NEG_Y * GRAVITY)
    }

    /// A puck at `place`, its lower face at the height of `place`, which moves by `velocity` and spins about
    /// the y axis.
    pub fn puck(&mut self, place: Vec3, velocity: Vec3, spin: f32) -> Entity {
        let puck = self.app.world_mut().spawn((
            RigidBody::Dynamic,
            Collider::cylinder(RADIUS, HEIGHT),
            Friction::new(MU),
            SleepingDisabled,
            Transform::from_translation(place + Vec3::Y * (0.5 * HEIGHT)),
            LinearVelocity(velocity),
            AngularVelocity(Vec3::Y * spin),
        ));
        puck.id()
    }

    pub fn steps(&mut self, steps: usize) {
        for _ in 0..steps {
            self.app.update();
        }
    }

    pub fn give(&mut self, foot: Entity, patch: FrictionPatch) {
        self.app.world_mut().entity_mut(foot).insert(patch);
    }

    pub fn place(&self, body: Entity) -> Vec3 {
        self.app.world().get::<Position>(body).expect("a body").0
    }

    /// Linear and angular velocity.
    pub fn velocity(&self, body: Entity) -> [Vec3; 2] {
        let world = self.app.world();
        let linear = world.get::<LinearVelocity>(body).expect("a body").0;
        let angular = world.get::<AngularVelocity>(body).expect("a body").0;
        [linear, angular]
    }

    pub fn friction(&self, foot: Entity) -> PatchFriction {
        *self.app.world().get::<PatchFriction>(foot).expect("a foot")
    }
}

pub fn disk(mu: f32) -> FrictionPatch {
    FrictionPatch::disk(mu, RADIUS).expect("a valid disk")
}
