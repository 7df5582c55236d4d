//! Area friction of a body's feet over one time step, without an engine: what adapters share.
//!
//! A [`Footprint`] is the shape of a foot's area, and how it spreads the load. [`Standing`] takes the feet of one
//! body with their friction limits, and returns the motion at the end of an implicit step: at rest it is
//! zero to the last bit.
//!
//! ```
//! use tribos_core::contact::TimeStep;
//! use tribos_core::planar::PlanarBody;
//! use tribos_core::twist::{Twist, Wrench};
//! use tribos_feet::{Foot, Footprint, Standing};
//!
//! // A stool of 5 kg on three legs with disks of 2 cm radius, mu 0.4.
//! let stool = PlanarBody::new(5.0, 0.1)?;
//! let disk = Footprint::disk(0.02)?;
//! let limit = 0.4 * 5.0 * 9.81 / 3.0; // N
//! let places = [[0.2, 0.0], [-0.1, 0.17], [-0.1, -0.17]]; // m
//! let feet = places.map(|place| Foot::new(&disk, limit, place));
//! let standing = Standing::new(&stool, None, &feet);
//! let push = Wrench::new(0.0, 0.0, 3.0); // N m: the feet carry 3.9
//! let held = standing.step(&Twist::ZERO, &push, TimeStep::new(1.0 / 60.0)?);
//! assert!(held.is_some_and(|held| held.is_at_rest() && held.twist == Twist::ZERO));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! *Units*: SI. All lengths are in the contact's plane, relative to the centre of mass.

mod area;
mod balance;
mod convex;
mod elements;
mod ended;
mod foot;
mod footprint;
mod points;
mod prediction;
mod pressed;
mod reduced;
mod refusal;
mod standing;
mod surface;
mod symmetric;

pub use ended::{Ended, FootFriction};
pub use foot::{Foot, Stance};
pub use footprint::{Footprint, SurfaceAside};
pub use prediction::{Correction, Prediction};
pub use reduced::Reduced;
pub use refusal::FootprintError;
pub use standing::Standing;
pub use tribos_friction::{FrictionError, Patch};
