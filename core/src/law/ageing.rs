//! Static friction that grows with the time of rest.

use super::error::{positive, validated_coefficient};
use super::limits::{ln_ratio, scaled};
use super::{LawError, StickSlip};
use crate::real::Real;

/// μₛ(t) = A + B ln(t/t₀) for ages t ≥ t₀, and A for younger contacts.
///
/// The cut-off age t₀ is also the reference of the logarithm: any other reference only shifts A.
/// The law has no upper limit; Coulomb saw one after minutes (wood) to days (metal on wood).
///
/// *Units*: A, B dimensionless; ages and t₀ in one unit of time.
/// *Source*: thesis section 2.1 (F = A + B ln t), fig. 2.5. The cut-off is ours.
///
/// ```
/// use tribos_core::law::{RestTime, StaticAgeing, StickSlip};
/// let wood = StaticAgeing::new(0.4_f64, 0.03, 1.0)?; // reference and cut-off 1 s
/// let rested = RestTime::ZERO.advance(100.0, StickSlip::Stick);
/// assert!((wood.mu_static(rested) - 0.538).abs() < 1e-3);
/// assert!((wood.rate(rested) - 0.03 / 100.0).abs() < 1e-18); // B/t, in 1/s
/// assert_eq!(wood.at_rest(rested, 0.5), StickSlip::Stick); // pulled with half the load
/// assert_eq!(wood.at_rest(RestTime::ZERO, 0.5), StickSlip::Slip);
/// assert_eq!(wood.mu_static(rested.advance(0.1, StickSlip::Slip)), 0.4);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StaticAgeing<R> {
    young: R,
    growth: R,
    cut_off: R,
}

/// Time of a contact at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RestTime<R> {
    /// Time since the contact last slipped.
    pub time: R,
}

impl<R: Real> RestTime<R> {
    /// A contact that has just slipped.
    pub const ZERO: Self = Self { time: R::ZERO };

    /// The age `dt` ≥ 0 later: a contact that sticks ages, one that slips is new.
    #[must_use]
    #[inline]
    pub fn advance(self, dt: R, grip: StickSlip) -> Self {
        match grip {
            StickSlip::Stick => Self {
                time: self.time + dt,
            },
            StickSlip::Slip => Self::ZERO,
        }
    }
}

impl<R: Real> StaticAgeing<R> {
    /// Coefficient A of contacts up to the age `cut_off` = t₀, growth B per e-fold of the age.
    ///
    /// *Domain*: 0 ≤ `young`, `growth` < ∞; 0 < `cut_off` < ∞.
    pub fn new(young: R, growth: R, cut_off: R) -> Result<Self, LawError> {
        Ok(Self {
            young: validated_coefficient(young)?,
            growth: validated_coefficient(growth)?,
            cut_off: positive("cut-off age", cut_off)?,
        })
    }

    /// The static coefficient at an age.
    ///
    /// *Special values*: A below the cut-off; infinite age gives infinity if B > 0.
    #[inline]
    pub fn mu_static(&self, age: RestTime<R>) -> R {
        if age.time < self.cut_off {
            self.young
        } else {
            self.young + scaled(self.growth, ln_ratio(age.time, self.cut_off))
        }
    }

    /// dμₛ/dt: B/t above the cut-off, 0 below.
    #[inline]
    pub fn rate(&self, age: RestTime<R>) -> R {
        if age.time < self.cut_off {
            R::ZERO
        } else {
            self.growth / age.time
        }
    }

    /// Whether a body at rest of this age sticks under a tangential force per load.
    #[inline]
    pub fn at_rest(&self, age: RestTime<R>, drive_per_load: R) -> StickSlip {
        StickSlip::of(drive_per_load, self.mu_static(age))
    }
}
