//! Special functions with bounded work and stated accuracy. They are independent of the physics.

mod elliptic;
mod hypergeometric;
pub(crate) mod legendre;
mod log_part;
mod log_quotient;
pub(crate) mod triangle;

pub use elliptic::CompleteElliptic;
pub use hypergeometric::{Gauss, Jet};
pub(crate) use log_part::log_part;
pub(crate) use log_quotient::log_quotient;
pub use log_quotient::{ATANH, ATANH_SINGLE};
