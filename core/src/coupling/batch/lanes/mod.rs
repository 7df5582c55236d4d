//! Groups in lanes: the formulas of the scalar functions, a selection for every branch.

mod coulomb;
mod patch;
mod power;
mod profile;
mod speeds;

pub use patch::{patch_jacobians, patch_wrenches};
pub use profile::LaneProfile;
pub use speeds::{drags, jacobians, wrenches};

use crate::lanes::Laned;

/// The lanes of a precision.
type Lanes<R> = <R as Laned>::Lanes;
