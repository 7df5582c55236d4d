//! The names of everyday use: `use tribos_core::prelude::*;`.
//!
//! ```
//! use tribos_core::prelude::*;
//! let puck = PatchFriction::new(Coulomb, 0.3, 0.04)?; // μ, m
//! assert!(puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)).torque < 0.0); // N; m/s, m/s, rad/s
//! # Ok::<(), Error>(())
//! ```

pub use crate::contact::{
    Body, Cohesion, Contact, ContactFriction, CoupledFriction, NormalLaw, Plate, Sphere,
    Thresholds, TimeStep, Touch,
};
pub use crate::coupling::nodes::NodeFriction;
pub use crate::coupling::quadrature::DiskQuadrature;
pub use crate::coupling::table::Coulomb;
pub use crate::coupling::{Coupling, DryCoupling, PatchFriction};
pub use crate::error::Error;
pub use crate::law::{
    DryFriction, LocalLaw, LuGre, LuGreParameters, PowerLaw, Stribeck, StribeckParameters,
};
pub use crate::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
pub use crate::manifold::Manifold;
pub use crate::modes::Modes;
pub use crate::planar::PlanarBody;
pub use crate::real::Real;
pub use crate::slider::{Motion, Slider, SliderParameters};
pub use crate::twist::{Twist, Wrench};
