//! Friction laws of a surface element, a body or a joint.
//!
//! | law | friction depends on | [`LocalLaw`] |
//! |---|---|---|
//! | [`CoulombLaw`], [`DryFriction`] | load; rest or motion | dynamic friction |
//! | [`PowerLaw`], [`PlateauPowerLaw`] | a power of the speed | yes |
//! | [`Stribeck`] | speed: boundary and hydrodynamic lubrication | yes |
//! | [`Savkoor`] | speed: the maximum of rubber | yes |
//! | [`RisingLaw`] | speed: the rise of PTFE from rest to a level | yes |
//! | [`TanhLaw`] | speed: Coulomb friction made smooth at rest | yes |
//! | [`StaticAgeing`] | time of rest | – |
//! | [`RateState`] | speed and age, ageing law [`AgeingLaw`] or slip law [`SlipLaw`] | [`SteadyRateState`] |
//! | [`LuGre`] | velocity and deflection of bristles | [`LuGre::steady_per_load`] |
//!
//! States ([`RestTime`], [`StateVariable`], [`Bristle`]) are small values that the caller stores, one for
//! each contact; laws are immutable.
//!
//! Local laws couple sliding and spinning of a whole contact through
//! [`DiskQuadrature`](crate::coupling::quadrature::DiskQuadrature):
//!
//! ```
//! use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
//! use tribos_core::law::{DryFriction, Stribeck, StribeckParameters};
//! let dry = DryFriction::new(0.2_f64, 0.1)?;
//! let law = Stribeck::new(StribeckParameters { dry, speed: 0.05, exponent: 2.0, viscous: 0.01 })?;
//! let disk = DiskQuadrature::new(law);
//! assert!(disk.reduced_wrench(0.1, 0.5).force < disk.reduced_wrench(0.1, 0.0).force);
//! # Ok::<(), tribos_core::law::LawError>(())
//! ```

mod ageing;
mod contact_age;
mod coulomb;
mod dry;
mod error;
mod grip;
mod limits;
mod lugre;
mod plateau;
mod power;
mod rate_state;
mod rising;
mod savkoor;
mod steady_rate_state;
mod stribeck;
mod tanh;

pub use ageing::{RestTime, StaticAgeing};
pub use contact_age::{AgeingLaw, SlipLaw, StateEvolution, StateVariable};
pub use coulomb::CoulombLaw;
pub use dry::DryFriction;
pub use error::LawError;
pub(crate) use error::{fraction as validated_fraction, not_negative as validated_not_negative};
pub(crate) use error::{positive as validated_positive, validated_coefficient, validated_exponent};
pub use grip::StickSlip;
pub use lugre::{Bristle, LuGre, LuGreParameters, SteadyLuGre};
pub use plateau::{PlateauPowerLaw, PlateauPowerLawParameters};
pub use power::PowerLaw;
pub use rate_state::{RateState, RateStateParameters};
pub use rising::{RisingLaw, RisingLawParameters};
pub use savkoor::{Savkoor, SavkoorParameters};
pub use steady_rate_state::SteadyRateState;
pub use stribeck::{Stribeck, StribeckParameters};
pub use tanh::TanhLaw;

use crate::real::Real;

/// A law of the local sliding speed: friction force per unit load, along the velocity.
///
/// *Units*: `speed` in any unit of velocity; the result is dimensionless.
///
/// A law of your own couples sliding and spinning like those here:
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
/// use tribos_core::law::LocalLaw;
/// /// A film of grease: 0.4 v/(v + 0.1 m/s).
/// struct Grease;
/// impl LocalLaw<f64> for Grease {
///     fn friction(&self, speed: f64) -> f64 {
///         0.4 * speed / (speed + 0.1)
///     }
///     fn slope(&self, speed: f64) -> f64 {
///         0.4 * 0.1 / (speed + 0.1).powi(2)
///     }
/// }
/// // A disk that does not spin has one speed everywhere.
/// let disk = DiskQuadrature::new(Grease);
/// assert!((disk.reduced_wrench(0.3, 0.0).force - 0.3).abs() < 1e-12);
/// ```
pub trait LocalLaw<R: Real> {
    /// Friction per load at `speed` > 0.
    fn friction(&self, speed: R) -> R;
    /// Derivative of [`LocalLaw::friction`] at `speed` > 0.
    fn slope(&self, speed: R) -> R;
}

impl<R: Real, L: LocalLaw<R> + ?Sized> LocalLaw<R> for &L {
    #[inline]
    fn friction(&self, speed: R) -> R {
        (**self).friction(speed)
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        (**self).slope(speed)
    }
}
