//! One type for all laws of bonds.

use tribos_core::bond::{
    BondLaw, BrittleBond, ExponentialBond, PlasticBond, ReformingBond, WeibullBond,
};
use tribos_core::law::LocalLaw;

/// A law of bonds that was chosen at run time.
///
/// ```
/// use tribos::kernel::bond::BondLaw;
/// use tribos::onset::{Bond, AnyBond};
/// let law: AnyBond = "re-forming-one-strength".parse::<Bond>()?.with(0.6, 1e-5)?; // m
/// assert_eq!(law.largest_force(), 0.6); // per load
/// assert_eq!(law.plateau(), 0.3); // of steady sliding
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyBond {
    /// Bonds that yield.
    Plastic(PlasticBond<f64>),
    /// Bonds of exponentially spread strengths.
    Exponential(ExponentialBond<f64>),
    /// Bonds of strengths spread by an exponent.
    Weibull(WeibullBond<f64>),
    /// Bonds of one strength.
    OneStrength(BrittleBond<f64>),
    /// Bonds that re-form.
    ReForming(ReformingBond<f64>),
}

impl AnyBond {
    /// The force at the first peak, or its limit where there is none.
    pub fn largest_force(&self) -> f64 {
        let peak = self.peak();
        if peak.is_finite() {
            self.friction(peak)
        } else {
            self.plateau()
        }
    }

    fn law(&self) -> &dyn BondLaw<f64> {
        match self {
            Self::Plastic(law) => law,
            Self::Exponential(law) => law,
            Self::Weibull(law) => law,
            Self::OneStrength(law) => law,
            Self::ReForming(law) => law,
        }
    }
}

impl LocalLaw<f64> for AnyBond {
    fn friction(&self, speed: f64) -> f64 {
        self.law().friction(speed)
    }
    fn slope(&self, speed: f64) -> f64 {
        self.law().slope(speed)
    }
}

impl BondLaw<f64> for AnyBond {
    fn stiffness(&self) -> f64 {
        self.law().stiffness()
    }
    fn peak(&self) -> f64 {
        self.law().peak()
    }
    fn is_brittle(&self) -> bool {
        self.law().is_brittle()
    }
    fn plateau(&self) -> f64 {
        self.law().plateau()
    }
    fn transverse_stiffness(&self, strain: f64) -> f64 {
        self.law().transverse_stiffness(strain)
    }
}
