//! Contact patches: shape and pressure distribution.
//!
//! Round patches are measured in units of their radius: a pressure says how a unit load is spread
//! over the unit disk, and [`crate::coupling::RoundFriction`] adds the radius.

#[doc(hidden)]
pub mod affine_image;
pub mod anisotropic;
pub mod arcs;
mod arcs_cut;
pub mod bar;
mod edge;
pub mod elastic;
pub mod ellipse;
mod error;
pub mod feet;
mod flat_pressure;
mod gauss_jacobi;
pub mod mesh;
mod mesh_error;
mod node_storage;
pub mod nodes;
pub mod outline;
mod outline_check;
mod outline_error;
mod outline_extent;
pub mod piece;
pub mod points;
pub mod polar;
pub mod polygon;
mod polygon_parts;
mod polynomial;
mod power;
pub mod round;
mod triangle;
pub(crate) mod tripod;

pub use error::PatchError;
pub(crate) use error::validated_radius;
pub use polynomial::PolynomialPressure;
pub use power::PowerPressure;
