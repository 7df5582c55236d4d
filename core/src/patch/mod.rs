//! Contact patches: shape and pressure distribution.
//!
//! Round patches are measured in units of their radius: a pressure says how a unit load is spread
//! over the unit disk, and [`crate::coupling::PatchFriction`] adds the radius.

pub mod bar;
mod borrowed;
mod edge;
mod flat_pressure;
mod gauss_jacobi;
pub mod nodes;
pub mod outline;
pub mod polar;
pub mod polygon;
mod polynomial;
mod power;
mod simple;
pub mod tripod;

pub use polynomial::PolynomialPressure;
pub use power::PowerPressure;

use crate::real::Real;

/// An invalid parameter of a patch.
///
/// ```
/// use tribos_core::coupling::{Annulus, table::Coulomb};
/// use tribos_core::patch::{PatchError, PolynomialPressure, PowerPressure};
/// let max = PowerPressure::MAX_ORDER;
/// assert_eq!(PowerPressure::new(-2.0), Err(PatchError::Order { given: -2.0, max }));
/// assert_eq!(PolynomialPressure::new([0.0]), Err(PatchError::NoLoad));
/// assert!(matches!(Annulus::new(Coulomb, 1.0), Err(PatchError::InnerRatio { .. })));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PatchError {
    /// The radius is not positive and finite.
    Radius {
        /// What was given.
        given: f64,
    },
    /// The order q of a pressure (1−r²)^q is not in [−1, `max`].
    Order {
        /// What was given.
        given: f64,
        /// Largest order served.
        max: f64,
    },
    /// The inner over the outer radius of an annulus is not in [0, `max`].
    InnerRatio {
        /// What was given.
        given: f64,
        /// Thinnest annulus served; a thinner one is a ring.
        max: f64,
    },
    /// The height of the centre of mass is negative, infinite or NaN.
    Height {
        /// What was given.
        given: f64,
    },
    /// The lean of a tall body is negative, infinite or NaN.
    Lean {
        /// What was given.
        given: f64,
    },
    /// A polynomial pressure is negative somewhere on the patch, or not finite.
    Negative,
    /// The pressure carries no load.
    NoLoad,
}

impl core::fmt::Display for PatchError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Radius { given } => {
                write!(
                    f,
                    "the contact radius must be positive and finite, not {given}"
                )
            }
            Self::Order { given, max } => {
                write!(
                    f,
                    "the order q of a pressure (1-r^2)^q must satisfy -1 <= q <= {max}, not {given}"
                )
            }
            Self::InnerRatio { given, max } => {
                write!(
                    f,
                    "inner radius / outer radius must be from 0 to {max}, not {given}; \
                     a thinner annulus is a ring"
                )
            }
            Self::Height { given } => {
                write!(
                    f,
                    "the height of the centre of mass must be finite and not negative, not {given}"
                )
            }
            Self::Lean { given } => {
                write!(f, "the lean must be finite and not negative, not {given}")
            }
            Self::Negative => f.write_str(
                "the pressure must be finite and nowhere negative on the patch; \
                 change its coefficients",
            ),
            Self::NoLoad => {
                f.write_str("the pressure carries no load; give a positive coefficient")
            }
        }
    }
}

impl core::error::Error for PatchError {}

/// `radius` if positive and finite.
pub(crate) fn validated_radius<R: Real>(radius: R) -> Result<R, PatchError> {
    if radius > R::ZERO && radius.is_finite() {
        Ok(radius)
    } else {
        Err(PatchError::Radius {
            given: radius.to_f64(),
        })
    }
}
