//! Soft spheres: contacts of springs and dashpots with the thresholds of contact dynamics.
//!
//! The same law as in [`cd`](crate::cd), with springs in place of its inequalities: overlaps are F/k instead of
//! none, and a contact sticks by straining its springs. No equations are solved; steps are short instead.
//!
//! A billiard ball that is struck through its centre slides at first and finally rolls with 5/7 of its initial
//! speed, for any friction, but for the overlap over the radius, by which its lever is shorter:
//!
//! ```
//! use tribos::cd::{WorldMaterials, Wall, solid};
//! use tribos::kernel::contact::{Cohesion, NormalLaw, SphereBody, IndependentFriction};
//! use tribos::kernel::nalgebra::Vector3;
//! use tribos::soft::{SoftSetup, Stiffness, SoftWorld};
//!
//! let (up, radius) = (Vector3::z(), 0.028); // m
//! let ball = SphereBody { velocity: Vector3::x(), ..solid(radius, 1700.0) }; // m/s, kg/m³
//! let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::sliding(0.2)?);
//! let table = SoftSetup::new(laws, Stiffness::Linear(1e5)).wall(Wall::fixed(up, 0.0)); // N/m
//! let setup = table.gravity(up * -9.81).sphere(up * radius, radius, ball);
//! let mut world = SoftWorld::new(setup)?;
//! while world.state().time < 0.5 {
//!     world.step()?;
//! }
//! let ball = &world.state().spheres[0];
//! assert!((ball.velocity.x - 5.0 / 7.0).abs() < 1e-3);
//! assert!((ball.spin.y * radius - ball.velocity.x).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod balance;
mod cell;
mod contact;
mod kick;
mod law;
mod mesh;
mod neighbours;
mod setup;
mod step_length;
mod transport;
mod world;

pub use contact::SoftContact;
pub use law::{Sprung, Stiffness};
#[doc(hidden)]
pub use setup::STEPS_PER_COLLISION;
pub use setup::SoftSetup;
#[doc(hidden)]
pub use step_length::StepLength;
pub use world::{SoftState, SoftWorld};
