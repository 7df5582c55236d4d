//! Two pucks thrown with the same spin, seen from above: green with a friction patch, red with the friction of
//! the engine. Space throws them again.
//!
//! `cargo run --release --features window --example window`

use avian3d::prelude::*;
use bevy::prelude::*;
use std::error::Error;
use tribos_bevy::{FrictionPatch, FrictionPatchPlugin};

const MU: f32 = 0.3;
const RADIUS: f32 = 0.08;
const HEIGHT: f32 = 0.02;
const SPEED: f32 = 1.0;
const SPIN: f32 = 40.0;
const PIXELS_A_METRE: f32 = 900.0;
/// Where the throws begin, and the distance between them, in metres.
const START: f32 = -0.5;
const APART: f32 = 0.3;

#[derive(Component, Clone, Copy)]
struct Puck {
    colour: Color,
    lane: f32,
}

impl Puck {
    fn start(&self) -> (Position, Rotation, LinearVelocity, AngularVelocity) {
        let place = Vec3::new(START, 0.5 * HEIGHT, 0.5 * APART * self.lane);
        (
            Position(place),
            Rotation::default(),
            LinearVelocity(Vec3::X * SPEED),
            AngularVelocity(Vec3::Y * SPIN),
        )
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let patch = FrictionPatch::disk(MU, RADIUS)?;
    App::new()
        .add_plugins((
            DefaultPlugins,
            PhysicsPlugins::default(),
            FrictionPatchPlugin,
        ))
        .add_systems(Startup, move |mut commands: Commands| {
            commands.spawn(Camera2d);
            commands.spawn((
                RigidBody::Static,
                Collider::cuboid(10.0, 0.2, 10.0),
                Friction::new(MU),
                Transform::from_xyz(0.0, -0.1, 0.0),
            ));
            let red = Puck {
                colour: Color::srgb(0.9, 0.3, 0.2),
                lane: 1.0,
            };
            let green = Puck {
                colour: Color::srgb(0.2, 0.8, 0.4),
                lane: -1.0,
            };
            let shape = || (RigidBody::Dynamic, Collider::cylinder(RADIUS, HEIGHT));
            commands.spawn((red, red.start(), shape(), Friction::new(MU)));
            commands.spawn((green, green.start(), shape(), patch.clone()));
        })
        .add_systems(Update, (throw_again, draw))
        .run();
    Ok(())
}

fn throw_again(
    keys: Res<ButtonInput<KeyCode>>,
    pucks: Query<(Entity, &Puck)>,
    mut commands: Commands,
) {
    if keys.just_pressed(KeyCode::Space) {
        for (entity, puck) in &pucks {
            commands
                .entity(entity)
                .insert(puck.start())
                .remove::<Sleeping>();
        }
    }
}

fn draw(mut gizmos: Gizmos, pucks: Query<(&Puck, &Position, &Rotation)>) {
    for (puck, place, rotation) in &pucks {
        let seen = |world: Vec3| Vec2::new(world.x, -world.z) * PIXELS_A_METRE;
        let centre = seen(place.0);
        let rim = centre + seen(*rotation * (Vec3::X * RADIUS));
        gizmos.circle_2d(centre, RADIUS * PIXELS_A_METRE, puck.colour);
        gizmos.line_2d(centre, rim, puck.colour);
    }
}
