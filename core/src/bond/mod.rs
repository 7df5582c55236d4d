//! Bonds between two bodies at rest, and the load under which they let go: static friction of a
//! contact that is pushed and turned.
//!
//! A rigid body that is displaced by u and turned by the angle θ, before it slides, strains the
//! bond at x by d = u + θ z × x. A bond of the law f pulls back with f(|d|) d/|d|, so that
//!
//! ```text
//! force = −N ∫p f(|d|) d/|d| dA,     torque = −N ∫p f(|d|) (x × d)/|d| dA
//! ```
//!
//! are the integrals of [`crate::coupling`] with a displacement in place of the velocity and the law
//! of a bond in place of the law of friction. A bond law is a [`LocalLaw`] for that reason: its
//! "speed" is a strain, its "friction" a force per unit load. [`Bonds`] puts law and patch together.
//! Under a growing load the body lets go where the stiffness −∂wrench/∂displacement first turns singular ([`SlipOnset`]).
//!
//! | law | bonds | force at the strain d | T_s/(F_s R) of the uniform disk |
//! |---|---|---|---|
//! | [`PlasticBond`] | yield and hold on: limit analysis | k d/√(1 + (d/x0)²) | 2/3 |
//! | [`ExponentialBond`] | break, in a broad spread of strengths | k d exp(−d/x0) | 0.6399 |
//! | [`WeibullBond`] | break, spread by the exponent m | k d exp(−(d/x0)^m) | 0.6231 (m = 2), 0.5775 (m = 8) |
//! | [`BrittleBond`] | all break at one strain | k d up to x0 | 1/2 |
//! | [`ReformingBond`] | break and re-form without strain | k times the mean age of a renewal process | 2/3 to 1/2 |
//!
//! *Source*: a model in the spirit of S. R. Dahmen, Z. Farkas, H. Hinrichsen, D. E. Wolf, Phys. Rev. E 71
//! (2005) 066602 and J. Stat. Mech. (2005) P03004, of whose equations none is used here.
//!
//! ```
//! use tribos_core::bond::{Bonds, BrittleBond};
//! use tribos_core::patch::nodes::NodeList;
//! use tribos_core::patch::polar::PolarQuadrature;
//! use tribos_core::twist::Twist;
//! let puck: NodeList<f64, 128> = PolarQuadrature::new(0.04, 8, 16)?.nodes()?; // radius in m
//! let bonds = Bonds::new(BrittleBond::new(5e4, 1e-5)?, puck)?.with_rim(0.04)?; // 1/m; m
//! let [pushed, turned] = [Twist::new(1.0, 0.0, 0.0), Twist::new(0.0, 0.0, 1.0)]
//!     .map(|direction| bonds.onset(1.7, &direction)); // load in N
//! let (Some(pushed), Some(turned)) = (pushed, turned) else { panic!("both let go") };
//! assert!((pushed.push.force.x - 0.85).abs() < 1e-12); // N: 5e4/m · 1e-5 m · 1.7 N
//! assert!((turned.push.torque / (0.85 * 0.04) - 0.5).abs() < 1e-12);
//! # Ok::<(), tribos_core::Error>(())
//! ```

mod bonds;
mod exponential;
mod one_strength;
mod onset;
mod re_forming;
mod renewal;
mod saturating;
mod weibull;

pub use bonds::Bonds;
pub use exponential::ExponentialBond;
pub use one_strength::BrittleBond;
pub use onset::{FailureMode, SlipOnset};
pub use re_forming::ReformingBond;
pub use saturating::PlasticBond;
pub use weibull::WeibullBond;

use crate::law::LocalLaw;
use crate::real::Real;

/// A law of bonds: the mean force of many bonds at one strain, per unit load.
///
/// [`LocalLaw::friction`] is the force at a strain > 0 and [`LocalLaw::slope`] its derivative.
///
/// *Units*: strains are lengths; forces per load are numbers, stiffnesses 1/length.
///
/// ```
/// use tribos_core::bond::{BondLaw, ExponentialBond, BrittleBond};
/// /// Static friction coefficient of a body that is pushed and not turned.
/// fn static_coefficient(law: &impl BondLaw<f64>) -> f64 {
///     law.friction(law.peak())
/// }
/// assert_eq!(static_coefficient(&BrittleBond::new(5e4, 1e-5)?), 0.5);
/// let broad = ExponentialBond::new(5e4, 1e-5)?;
/// assert!((static_coefficient(&broad) - 0.5 / 1.0_f64.exp()).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub trait BondLaw<R: Real>: LocalLaw<R> {
    /// Force per strain of bonds that are not strained yet.
    fn stiffness(&self) -> R;

    /// The strain up to which the force grows; infinite for bonds that never weaken.
    fn peak(&self) -> R;

    /// True if all bonds break at once at the peak.
    fn is_brittle(&self) -> bool;

    /// The mean force of bonds that have been strained without end: 0 if all are broken.
    fn plateau(&self) -> R;

    /// Force per strain against a small strain across that of the bond, at a strain > 0.
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        self.friction(strain) / strain
    }
}

impl<R: Real, L: BondLaw<R> + ?Sized> BondLaw<R> for &L {
    fn stiffness(&self) -> R {
        (**self).stiffness()
    }
    fn peak(&self) -> R {
        (**self).peak()
    }
    fn is_brittle(&self) -> bool {
        (**self).is_brittle()
    }
    fn plateau(&self) -> R {
        (**self).plateau()
    }
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        (**self).transverse_stiffness(strain)
    }
}

#[cfg(test)]
mod tests;
