//! Friction of area contacts for [Bevy](https://bevy.org) with the physics engine
//! [Avian](https://docs.rs/avian3d): bodies that slide and spin at once.
//!
//! Avian resists the sliding of contact points. A spinning puck slides farther than its points predict, because
//! every element of the area resists along its own velocity. The component [`FrictionPatch`] replaces the engine's
//! friction below a collider by the exact friction of a disk, a ring or a polygon. Everything else (normal forces,
//! other contacts, joints, sleep) is left to the engine.
//!
//! ```
//! use avian3d::prelude::*;
//! use bevy::prelude::*;
//! use bevy::{time::TimeUpdateStrategy, transform::TransformPlugin};
//! use tribos_bevy::{FrictionPatch, FrictionPatchPlugin, PatchFriction};
//!
//! let mut app = App::new();
//! app.add_plugins((MinimalPlugins, TransformPlugin));
//! app.add_plugins((PhysicsPlugins::default(), FrictionPatchPlugin));
//! # let step = std::time::Duration::from_secs_f64(1.0 / 60.0);
//! # app.insert_resource(Time::<Fixed>::from_duration(step));
//! # app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
//! let table = (RigidBody::Static, Collider::cuboid(4.0, 0.2, 4.0), Transform::from_xyz(0.0, -0.1, 0.0));
//! app.world_mut().spawn(table);
//! let puck = app.world_mut().spawn((
//!     RigidBody::Dynamic,
//!     Collider::cylinder(0.08, 0.02),
//!     Transform::from_xyz(0.0, 0.01, 0.0),
//!     LinearVelocity(Vec3::X),              // m/s
//!     AngularVelocity(12.5 * Vec3::Y),      // rad/s
//!     FrictionPatch::disk(0.3, 0.08)?,      // mu, radius in metres
//! ));
//! let puck = puck.id();
//! # app.finish();
//! # app.cleanup();
//! for _ in 0..60 {
//!     app.update();
//! }
//! let friction = app.world().get::<PatchFriction>(puck).ok_or("no puck")?;
//! assert!(friction.holds);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! *Feet*: the component belongs on the entity of a collider. All feet of a body on one ground, or on grounds that
//! friction does not move, are solved together, each with its own lever and its own share of the load.
//! *Units*: metres, kilograms, seconds. *Results*: [`PatchFriction`].
//!
//! *How*: in every substep the engine first solves the normal impulses without friction at the patch. With these
//! impulses as loads, one implicit step of the body on its feet then gives the motion that the engine integrates.
//! Loads, pushes and friction belong to the same substep: there is no delay, and no state beyond the components.

mod frame;
mod friction;
mod gather;
mod group;
mod patch;
mod plugin;
mod reduced;

pub use friction::PatchFriction;
pub use patch::{FrictionPatch, PatchError};
pub use plugin::FrictionPatchPlugin;
pub use tribos_feet::{Footprint, FootprintError};

/// The example of the guide.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Guide;
