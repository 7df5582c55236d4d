//! Speed against error: what the kernel costs, what it is worth, and what else there is.
//!
//! Two programs make the fronts that the documentation shows, from the code that the benches time:
//! `front` (one evaluation of force and torque) and `slider_front` (one stop of a sliding,
//! spinning disk). The benches under `benches/` time the same methods with criterion.

pub mod args;
pub mod baselines;
pub mod catalogue;
pub mod contact;
pub mod errors;
pub mod methods;
pub mod mix;
pub mod picture;
pub mod reference;
pub mod stepping;
pub mod timing;
pub mod written;
