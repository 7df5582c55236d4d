//! Bonds whose breaking strains are spread exponentially.

use super::BondLaw;
use crate::law::{LawError, LocalLaw, validated_positive};
use crate::real::Real;

/// f(d) = k d exp(−d/x0): springs that break, the shares of them that still hold fall
/// exponentially.
///
/// It is [`super::WeibullBond`] with m = 1, without the power. Its largest force is k x0/e, at d = x0.
///
/// *Units*: k in 1/length (force per load and strain), x0 in length. *Accuracy*: 4 ulp of the force, times
/// 1 + d/x0. *Special values*: 0 at no strain and at infinite strain.
///
/// ```
/// use tribos_core::bond::ExponentialBond;
/// use tribos_core::law::LocalLaw;
/// let bonds = ExponentialBond::new(2.0_f64, 0.5)?; // 1/m, m
/// assert!((bonds.friction(0.5) - 1.0 / 1.0_f64.exp()).abs() < 1e-15);
/// assert_eq!(bonds.slope(0.5), 0.0);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExponentialBond<R> {
    stiffness: R,
    strain: R,
}

impl<R: Real> ExponentialBond<R> {
    /// *Domain*: 0 < `stiffness` < ∞ (k), 0 < `strain` < ∞ (x0).
    pub fn new(stiffness: R, strain: R) -> Result<Self, LawError> {
        Ok(Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain: validated_positive("strain", strain)?,
        })
    }

    /// The work that strains bonds from 0 to `strain`, k x0² (1 − (1 + t) exp(−t)) with t = d/x0.
    ///
    /// *Units*: length, per load. *Accuracy*: 3 ulp of k x0². *Special values*: k x0² at infinite strain.
    ///
    /// ```
    /// use tribos_core::bond::ExponentialBond;
    /// let bonds = ExponentialBond::new(2.0_f64, 0.5)?; // 1/m, m
    /// assert!((bonds.energy(1e3) - 0.5).abs() < 1e-15); // all are broken
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn energy(&self, strain: R) -> R {
        let t = strain / self.strain;
        let decay = (-t).exp();
        let lost = if decay == R::ZERO { decay } else { t * decay };
        self.stiffness * self.strain * self.strain * (-(-t).exp_m1() - lost)
    }
}

impl<R: Real> LocalLaw<R> for ExponentialBond<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        let decay = (-(speed / self.strain)).exp();
        if decay == R::ZERO {
            return decay;
        }
        self.stiffness * speed * decay
    }
    /// k (1 − d/x0) exp(−d/x0)
    #[inline]
    fn slope(&self, speed: R) -> R {
        let t = speed / self.strain;
        let decay = (-t).exp();
        if decay == R::ZERO {
            return decay;
        }
        self.stiffness * (R::ONE - t) * decay
    }
}

impl<R: Real> BondLaw<R> for ExponentialBond<R> {
    fn stiffness(&self) -> R {
        self.stiffness
    }
    fn peak(&self) -> R {
        self.strain
    }
    fn is_brittle(&self) -> bool {
        false
    }
    fn plateau(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        self.stiffness * (-(strain / self.strain)).exp()
    }
}
