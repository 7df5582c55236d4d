//! Friction on the ground for [Rapier](https://rapier.rs)'s 2-D worlds seen from above.
//!
//! Seen from above a body has no contact with the ground, and the engine offers damping in its place: a motion
//! that dies out and never ends. [`Floor`] gives every dynamic body the exact Coulomb friction of its shape's
//! area: it slides and spins to rest, in a known time and on a known path. Contacts among bodies and with walls
//! are left to the engine.
//!
//! ```
//! use rapier2d::prelude::*;
//! use tribos_rapier2d::Floor;
//!
//! let mut world = PhysicsWorld::new();
//! world.gravity = Vector::ZERO; // of the plane: a level table
//! let body = RigidBodyBuilder::dynamic().linvel(Vector::new(1.0, 0.0)).angvel(12.5);
//! let (puck, _) = world.insert(body, ColliderBuilder::ball(0.08)); // a disk from above
//!
//! let mut floor = Floor::new(0.3, 9.81)?; // mu, m/s² towards the floor
//! for _ in 0..60 {
//!     floor.step(&mut world); // instead of world.step()
//! }
//! assert_eq!(world.bodies[puck].linvel(), Vector::ZERO);
//! # Ok::<(), tribos_rapier2d::FloorError>(())
//! ```
//!
//! *Shapes*: a ball is a disk, cuboids, triangles and convex polygons are polygons, capsules and rounded shapes
//! polygons with rounded corners, a segment is a bar, a compound all of these together; sensors carry nothing.
//! [`Floor::set_feet`] gives a body other areas: a ring, four wheels, two runners. *Materials*: one coefficient
//! for the floor, [`Floor::add_region`] for ice and carpets, [`Floor::set_mu`] for single bodies. *Accuracy*:
//! travel and stop of a disk and of a box within 0.1 % of the exact solution at 60 steps a second. *At rest*: a
//! body that friction holds does not move, to the last bit. *Load*: mass times gravity, shared among the
//! colliders of a body in proportion to their masses, so that the centre of pressure is below the centre of
//! mass. *State*: [`Floor`] can be cloned, and serialised with the feature `serde-serialize`; a simulation then
//! continues with the same bits. *Limits*: the pressure is uniform within each collider; friction responds one
//! step late to a new push from another body; the engine's joints are treated like contacts.

mod body;
mod feet;
mod floor;
mod refusal;
mod region;
mod report;
mod shape;

pub use feet::PlacedFoot;
pub use floor::Floor;
pub use refusal::FloorError;
pub use region::RegionId;
pub use report::{Friction, Stop};
pub use tribos_feet::{Footprint, FootprintError};

/// The program of the first page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Guide;
