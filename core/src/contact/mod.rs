//! Contacts of rigid bodies that may open, slide, roll and spin: impulses under thresholds.
//!
//! A contact of two spheres has six relative motions: one along the normal, two of sliding, two of
//! rolling, one of torsion. Each law names the modes that it resists, by type, and the others are
//! neither stored nor computed. [`IndependentFriction`] limit each mode for itself; [`CoupledFriction`] gives
//! sliding and torsion the one set that friction on a patch has. In one step of implicit time
//! stepping (Moreau–Jean) the impulse of a contact follows from the relative velocity that the
//! bodies would have without it:
//!
//! ```
//! use nalgebra::Vector3;
//! use tribos_core::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
//!
//! // A ball on a table, 1 kg, 5 cm, sliding at 1 m/s; gravity has pulled for 1 ms.
//! let dt = 1e-3;
//! let mut ball = SphereBody {
//!     velocity: Vector3::new(1.0, 0.0, -9.81 * dt),
//!     spin: Vector3::new(0.0, 0.0, 0.0),
//!     inv_mass: 1.0,
//!     inv_inertia: 1.0 / (0.4 * 0.05 * 0.05),
//! };
//! let mut table = WallBody { velocity: Vector3::new(0.0, 0.0, 0.0), inv_mass: 0.0 };
//! let touch = ContactGeometry::plate(0.05, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
//! let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
//! let friction = IndependentFriction::sliding(0.3_f64)?;
//! let mut contact = Contact::new(&touch, &law, &ball, &table, dt);
//! contact.update(&friction, &mut ball, &mut table);
//! assert_eq!(ball.velocity.z, 0.0); // it does not sink
//! assert!((ball.velocity.x - (1.0 - 0.3 * 9.81 * dt)).abs() < 1e-15);
//! assert!(ball.spin.y > 0.0); // and begins to roll
//! # Ok::<(), tribos_core::Error>(())
//! ```

mod block;
mod body;
mod coupled;
mod disc;
mod friction;
mod geometry;
mod modes;
mod normal;
mod prepared;
mod sliding_rolling;
mod time_step;
mod update;
mod vector;

pub use body::{ContactBody, SphereBody, WallBody};
pub use coupled::CoupledFriction;
pub use friction::{ContactFriction, IndependentFriction};
pub use geometry::{ContactError, ContactGeometry};
pub use modes::{
    AllModes, ContactModes, ContactVector, Frictionless, SlidingOnly, SlidingRolling,
    SlidingTorsion,
};
pub use normal::{Attraction, Cohesion, NormalLaw};
pub use time_step::TimeStep;
pub use update::Contact;

/// See [`crate::internals`].
pub(crate) mod internals {
    pub use super::block::{Block, Masses};
    pub use super::disc::project_on_disc;
    pub use super::friction::TangentialLoad;
    pub use super::modes::{AboutNormal, Absent, AxialPart, InPlane, PlanarPart};
    pub use super::prepared::PreparedContact;
}
