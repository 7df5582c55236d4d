//! Friction of area contacts for [Rapier](https://rapier.rs): bodies that slide and spin at once.
//!
//! Rapier resists the sliding of contact points. A spinning puck slides farther than its points
//! predict, because every element of the area resists along its own velocity. [`PatchContacts`]
//! replaces the engine's friction of chosen pairs of colliders by the exact friction of a patch: a
//! disk, a ring or a polygon. Everything else (normal forces, other contacts, joints) is left to the
//! engine.
//!
//! ```
//! use rapier3d::prelude::*;
//! use tribos_rapier::{Patch, PatchContacts};
//!
//! let mut world = PhysicsWorld::new();
//! world.gravity = Vector::new(0.0, -9.81, 0.0);
//! let (_, table) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::cuboid(2.0, 0.1, 2.0));
//! let body = RigidBodyBuilder::dynamic()
//!     .translation(Vector::new(0.0, 0.11, 0.0))
//!     .linvel(Vector::new(1.0, 0.0, 0.0))
//!     .angvel(Vector::new(0.0, 12.5, 0.0));
//! let (puck, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08));
//!
//! let mut patches = PatchContacts::new();
//! let patch = Patch::disk(0.3, 0.08)?;
//! patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
//! for _ in 0..60 {
//!     patches.step(&mut world); // instead of world.step()
//! }
//! assert_eq!(world.bodies[puck].linvel().x, 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! *Feet*: a foot is a collider, its patch is centred below the collider's origin
//! ([`Patch::centered_at`] moves it). All feet of a body on one ground, or on grounds that friction
//! does not move, are solved together, each with its own lever and its own share of the load.
//! *Grounds*: [`PatchContacts::insert_ground`] gives everything that stands flat on a ground the patch of its
//! face.
//! *Accuracy*: travel and stop of a puck, and of a body on 1, 2, 4 or 8 feet on and off its centre of
//! mass, within 0.5 % of the exact solution at 60 steps a second.
//! *At rest*: a patch that friction holds has no relative motion, to the last bit where the contact's
//! normal is an axis of the world, and creeps no farther than the engine rounds elsewhere.
//! *Refused*: feet on a fixed or kinematic body, or on none, as results from swapped arguments
//! ([`PairError`]). *State*: [`PatchContacts`] can be cloned, and serialised with the feature
//! `serde-serialize`; a simulation then continues with the same bits. *Limits*: the pressure stays
//! uniform within each patch whatever leans on the body; friction acts from the second step of a
//! contact on, and responds one step late to a new push from another body; a rotation of more than
//! 45° a step needs `allow_fast_rotation` of the body, as always in Rapier. Feet of one body on
//! several grounds that move freely, or on planes that are more than 8° apart, are solved one ground
//! after another. Links of multibodies are not moved. With `max_ccd_substeps` above 1 a step that the
//! engine splits is corrected by its last part.

mod active_pairs;
mod contacts;
mod flat_faces;
mod foot_pose;
mod frame;
mod grounds;
mod group;
mod members;
mod pair;
mod patch;
mod reduced;
mod refusal;
mod temporary_forces;

pub use contacts::PatchContacts;
pub use grounds::GroundMu;
pub use pair::{Friction, Stop};
pub use patch::{Patch, PatchError};
pub use refusal::PairError;
pub use tribos_feet::Footprint;

/// The examples of the guide.
#[cfg(doctest)]
#[doc = include_str!("../games.md")]
struct Guide;
