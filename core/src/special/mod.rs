//! Special functions with bounded work and stated accuracy. They are independent of the physics.

mod elliptic;
mod hypergeometric;
pub(crate) mod legendre;

pub use elliptic::CompleteElliptic;
pub use hypergeometric::{Gauss, Jet};
