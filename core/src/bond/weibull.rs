//! Bonds whose breaking strains have Weibull's distribution.

use super::BondLaw;
use crate::law::{LawError, LocalLaw, validated_positive};
use crate::real::Real;

/// f(d) = k d exp(−(d/x0)^m): springs that break, of which the larger m is the less the strengths
/// differ.
///
/// m = 1 is [`super::ExponentialBond`]; m → ∞ is [`super::BrittleBond`]. The largest force is at
/// d = x0 m^(−1/m), so that x0 = m^(1/m) gives the form d exp(−d^m/m) with its peak at 1.
///
/// *Units*: k in 1/length (force per load and strain), x0 in length; m is a number. *Accuracy*: 4 ulp of the
/// force, times 1 + m (d/x0)^m. *Special values*: 0 at no strain and at infinite strain.
/// *Source*: W. Weibull, J. Appl. Mech. 18 (1951) 293, for the distribution.
///
/// ```
/// use tribos_core::bond::WeibullBond;
/// use tribos_core::law::LocalLaw;
/// let bonds = WeibullBond::new(1.0_f64, 2.0_f64.sqrt(), 2.0)?; // d exp(−d²/2)
/// assert!((bonds.friction(1.0) - (-0.5_f64).exp()).abs() < 1e-15);
/// assert!(bonds.slope(1.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WeibullBond<R> {
    stiffness: R,
    strain: R,
    exponent: R,
}

impl<R: Real> WeibullBond<R> {
    /// *Domain*: 0 < `stiffness` < ∞ (k), 0 < `strain` < ∞ (x0), 0 < `exponent` < ∞ (m); the peak
    /// x0 m^(−1/m) finite.
    pub fn new(stiffness: R, strain: R, exponent: R) -> Result<Self, LawError> {
        let law = Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain: validated_positive("strain", strain)?,
            exponent: validated_positive("exponent", exponent)?,
        };
        validated_positive("strain of the largest force", law.peak())?;
        Ok(law)
    }

    /// (d/x0)^m and the share of bonds that hold, its exponential exp(−(d/x0)^m).
    #[inline]
    fn holding(&self, strain: R) -> (R, R) {
        let power = (strain / self.strain).pow(self.exponent);
        (power, (-power).exp())
    }
}

impl<R: Real> LocalLaw<R> for WeibullBond<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        let (_, share) = self.holding(speed);
        if share == R::ZERO {
            return share;
        }
        self.stiffness * speed * share
    }
    /// k (1 − m (d/x0)^m) exp(−(d/x0)^m)
    #[inline]
    fn slope(&self, speed: R) -> R {
        let (power, share) = self.holding(speed);
        if share == R::ZERO {
            return share;
        }
        self.stiffness * (R::ONE - self.exponent * power) * share
    }
}

impl<R: Real> BondLaw<R> for WeibullBond<R> {
    fn stiffness(&self) -> R {
        self.stiffness
    }
    fn peak(&self) -> R {
        self.strain * self.exponent.pow(-(R::ONE / self.exponent))
    }
    fn is_brittle(&self) -> bool {
        false
    }
    fn plateau(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        let (_, share) = self.holding(strain);
        self.stiffness * share
    }
}
