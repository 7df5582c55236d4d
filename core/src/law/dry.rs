//! Dry friction with different coefficients at rest and in motion.

use super::error::{ordered, validated_coefficient};
use super::{LawError, LocalLaw, StickSlip};
use crate::real::Real;

/// Coulomb's law with a static and a dynamic coefficient: up to μₛ × load holds a body at rest,
/// μ_d × load resists it in motion.
///
/// *Units*: both dimensionless. *Source*: thesis section 2.1, fig. 2.5.
///
/// ```
/// use tribos_core::law::{DryFriction, StickSlip};
/// let wood = DryFriction::new(0.5_f64, 0.3)?;
/// assert_eq!(wood.at_rest(0.45), StickSlip::Stick); // pulled with 0.45 of the load
/// assert_eq!(wood.at_rest(0.55), StickSlip::Slip);
///
/// // It starts with a jump, in either direction.
/// let jump = wood.mu_static() - wood.mu_dynamic();
/// assert_eq!(wood.net_drive(0.5), 0.0);
/// assert!((wood.net_drive(0.5 + 1e-9) - jump).abs() < 1e-8);
/// assert_eq!(wood.net_drive(-0.7), -wood.net_drive(0.7));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DryFriction<R> {
    mu_static: R,
    mu_dynamic: R,
}

impl<R: Real> DryFriction<R> {
    /// *Domain*: 0 ≤ `mu_dynamic` ≤ `mu_static` < ∞.
    pub fn new(mu_static: R, mu_dynamic: R) -> Result<Self, LawError> {
        validated_coefficient(mu_static)?;
        validated_coefficient(mu_dynamic)?;
        ordered(
            ("dynamic coefficient", mu_dynamic),
            ("static coefficient", mu_static),
        )?;
        Ok(Self {
            mu_static,
            mu_dynamic,
        })
    }

    /// The static coefficient μₛ.
    pub fn mu_static(&self) -> R {
        self.mu_static
    }

    /// The dynamic coefficient μ_d.
    pub fn mu_dynamic(&self) -> R {
        self.mu_dynamic
    }

    /// Whether a body at rest stays there under a tangential drive, per load, of either sign.
    ///
    /// *Special values*: |drive| = μₛ sticks; NaN slips.
    #[inline]
    pub fn at_rest(&self, drive_per_load: R) -> StickSlip {
        StickSlip::of(drive_per_load, self.mu_static)
    }

    /// What a body at rest has left of the drive, per load: zero if it sticks, else the drive
    /// less dynamic friction, with the drive's sign.
    ///
    /// *Special values*: NaN stays NaN.
    #[inline]
    pub fn net_drive(&self, drive_per_load: R) -> R {
        match self.at_rest(drive_per_load) {
            StickSlip::Stick => R::ZERO,
            StickSlip::Slip => drive_per_load - self.mu_dynamic.copysign(drive_per_load),
        }
    }
}

/// Dynamic friction.
impl<R: Real> LocalLaw<R> for DryFriction<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        if speed.is_nan() {
            speed
        } else {
            self.mu_dynamic
        }
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        if speed.is_nan() { speed } else { R::ZERO }
    }
}
