//! Bonds that yield and do not break.

use super::BondLaw;
use crate::law::{LawError, LocalLaw, validated_positive};
use crate::real::Real;

/// f(d) = k d/√(1 + (d/x0)²): bonds that yield around the strain x0 and hold k x0 from then on, as a plastic
/// contact does.
///
/// The contact stiffens no more but never weakens. It lets go at no finite displacement, and what it
/// holds is in the limit the limit surface of dry friction with the coefficient k x0.
///
/// *Units*: k in 1/length (force per load and strain), x0 in length. *Accuracy*: 4 ulp of the force.
/// *Special values*: 0 at no strain, k x0 at infinite strain.
///
/// ```
/// use tribos_core::bond::PlasticBond;
/// use tribos_core::law::LocalLaw;
/// let bonds = PlasticBond::new(2.0_f64, 0.5)?; // 1/m, m
/// assert!((bonds.friction(0.5) - 0.5_f64.sqrt()).abs() < 1e-15);
/// assert_eq!(bonds.friction(f64::INFINITY), 1.0);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlasticBond<R> {
    stiffness: R,
    strain: R,
}

impl<R: Real> PlasticBond<R> {
    /// *Domain*: 0 < `stiffness` < ∞ (k), 0 < `strain` < ∞ (x0).
    pub fn new(stiffness: R, strain: R) -> Result<Self, LawError> {
        Ok(Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain: validated_positive("strain", strain)?,
        })
    }

    /// The work that strains bonds from 0 to `strain`, k x0² (√(1 + t²) − 1) with t = d/x0.
    ///
    /// *Units*: length, per load. *Accuracy*: 6 ulp. *Special values*: infinite at infinite strain.
    ///
    /// ```
    /// use tribos_core::bond::PlasticBond;
    /// let bonds = PlasticBond::new(2.0_f64, 0.5)?; // 1/m, m
    /// // Far beyond the yield strain every further metre costs k x0.
    /// assert!((bonds.energy(8e3) - bonds.energy(7e3) - 1e3).abs() < 1e-4);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn energy(&self, strain: R) -> R {
        // √(1 + t²) − 1 without cancellation: the force times t x0/(1 + √(1 + t²)).
        let root = R::ONE.hypot(strain / self.strain);
        if root == R::INFINITY {
            return root;
        }
        self.friction(strain) * (strain / (R::ONE + root)) * root
    }
}

impl<R: Real> LocalLaw<R> for PlasticBond<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        let t = speed / self.strain;
        if t > R::ONE {
            self.stiffness * self.strain / R::ONE.hypot(R::ONE / t)
        } else {
            self.stiffness * speed / R::ONE.hypot(t)
        }
    }
    /// k (1 + (d/x0)²)^(−3/2)
    #[inline]
    fn slope(&self, speed: R) -> R {
        let root = R::ONE.hypot(speed / self.strain);
        self.stiffness / root / root / root
    }
}

impl<R: Real> BondLaw<R> for PlasticBond<R> {
    fn stiffness(&self) -> R {
        self.stiffness
    }
    fn peak(&self) -> R {
        R::INFINITY
    }
    fn is_brittle(&self) -> bool {
        false
    }
    fn plateau(&self) -> R {
        self.stiffness * self.strain
    }
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        self.stiffness / R::ONE.hypot(strain / self.strain)
    }
}
