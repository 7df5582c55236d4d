//! The names of everyday use: `use tribos_core::prelude::*;`.
//!
//! ```
//! use tribos_core::prelude::*;
//! let puck = RoundFriction::new(CoulombDisk, 0.3, 0.04)?; // μ, m
//! assert!(puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)).torque < 0.0); // N; m/s, m/s, rad/s
//! # Ok::<(), Error>(())
//! ```

pub use crate::contact::{
    Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry, CoupledFriction,
    IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
pub use crate::coupling::coulomb::CoulombDisk;
pub use crate::coupling::nodes::NodeFriction;
pub use crate::coupling::quadrature::DiskQuadrature;
pub use crate::coupling::{DryReducedFriction, ReducedFriction, RoundFriction};
pub use crate::error::Error;
pub use crate::law::{
    DryFriction, LocalLaw, LuGre, LuGreParameters, PowerLaw, Stribeck, StribeckParameters,
};
pub use crate::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
pub use crate::manifold::ContactSystem;
pub use crate::modes::TerminalMotion;
pub use crate::planar::PlanarBody;
pub use crate::real::Real;
pub use crate::slider::{Slider, SliderParameters, SliderState};
pub use crate::twist::{Twist, Wrench};
