//! Special functions with bounded work and stated accuracy. Nothing here knows any physics.

mod elliptic;
mod hypergeometric;
pub(crate) mod legendre;

pub use elliptic::CompleteElliptic;
pub use hypergeometric::{Gauss, Jet};
