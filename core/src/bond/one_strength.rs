//! Bonds that all break at one strain.

use super::BondLaw;
use crate::law::{LawError, LocalLaw, validated_positive};
use crate::real::Real;

/// f(d) = k d up to d = x0, and 0 beyond: the bond that is strained most breaks first and takes
/// the others with it.
///
/// Up to the first break the contact is linear, so that the onset of any patch is in closed form:
/// the wrench is −k N M q with the second moments M of the patch at the displacement q whose farthest
/// bond has the strain x0. For round patches F/F_s + T/T_s = 1.
///
/// *Units*: k in 1/length (force per load and strain), x0 in length. *Accuracy*: 1 ulp.
/// *Special values*: k x0 at x0 itself; 0 at infinite strain.
///
/// ```
/// use tribos_core::bond::BrittleBond;
/// use tribos_core::law::LocalLaw;
/// let bonds = BrittleBond::new(2.0, 0.5)?; // 1/m, m
/// assert_eq!([0.25, 0.5, 0.6].map(|strain| bonds.friction(strain)), [0.5, 1.0, 0.0]);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BrittleBond<R> {
    stiffness: R,
    strain: R,
}

impl<R: Real> BrittleBond<R> {
    /// *Domain*: 0 < `stiffness` < ∞ (k), 0 < `strain` < ∞ (x0).
    pub fn new(stiffness: R, strain: R) -> Result<Self, LawError> {
        Ok(Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain: validated_positive("strain", strain)?,
        })
    }

    /// The work that strains bonds from 0 to `strain`, k d²/2 up to x0.
    ///
    /// *Units*: length, per load. *Accuracy*: 3 ulp.
    ///
    /// ```
    /// use tribos_core::bond::BrittleBond;
    /// let bonds = BrittleBond::new(2.0, 0.5)?; // 1/m, m
    /// assert_eq!([0.25, 0.5, 9.0].map(|strain| bonds.energy(strain)), [0.0625, 0.25, 0.25]);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn energy(&self, strain: R) -> R {
        let reached = if strain > self.strain {
            self.strain
        } else {
            strain
        };
        R::HALF * self.stiffness * reached * reached
    }
}

impl<R: Real> LocalLaw<R> for BrittleBond<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        if speed > self.strain {
            R::ZERO
        } else {
            self.stiffness * speed
        }
    }
    /// k up to x0, 0 beyond.
    #[inline]
    fn slope(&self, speed: R) -> R {
        self.transverse_stiffness(speed)
    }
}

impl<R: Real> BondLaw<R> for BrittleBond<R> {
    fn stiffness(&self) -> R {
        self.stiffness
    }
    fn peak(&self) -> R {
        self.strain
    }
    fn is_brittle(&self) -> bool {
        true
    }
    fn plateau(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        if strain > self.strain {
            R::ZERO
        } else if strain.is_nan() {
            strain
        } else {
            self.stiffness
        }
    }
}
