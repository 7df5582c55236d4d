//! Radius of a contact patch from load, moduli and curvature.
//!
//! Elastic bodies touch in a patch that grows with the load. Friction needs its radius a and, where the load changes, how
//! a follows:
//!
//! | contact | radius | growth d ln a/d ln N |
//! |---|---|---|
//! | two spheres ([`HertzSphere`]) | (3 N R/(4 E*))^⅓ | ⅓ |
//! | two curved faces ([`HertzEllipse`]) | semi-axes of an ellipse | ⅓ |
//! | spheres that stick together ([`AdhesiveSphere`]) | (3 R/(4 E*) (N + P + √(P (P + 2N))))^⅓, P = 3π w R | from −∞ at the pull-off to ⅓ |
//! | soft finger ([`SoftFinger`]) | c N^γ | γ, from 0 to ⅓ |
//!
//! E* is the [`effective_modulus`] and 1/R the sum of both curvatures. The pressure of Hertz' contacts is
//! that of [`crate::coupling::coulomb::CoulombHertz`]. [`crate::coupling::LoadedFriction`] is the friction of a
//! patch whose radius follows its load.
//!
//! ```
//! use tribos_core::patch::elastic::{Elasticity, HertzSphere, LoadedRadius, effective_modulus};
//! let steel = Elasticity { young: 206e9_f64, poisson: 0.3 }; // Pa
//! let glass = Elasticity { young: 70e9, poisson: 0.22 };
//! let ball = HertzSphere::new(effective_modulus(steel, glass)?, 5e-3)?; // a ball of 5 mm on a plate
//! assert!((ball.radius(10.0) - 8.774e-5).abs() < 1e-8); // m under 10 N
//! # Ok::<(), tribos_core::law::LawError>(())
//! ```

mod adhesive;
mod ellipse;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;

pub use adhesive::AdhesiveSphere;
pub use ellipse::{HertzEllipse, relative_curvatures};

use crate::law::{LawError, validated_fraction, validated_positive};
use crate::real::Real;

/// A radius that follows the load.
///
/// All methods are total: NaN gives NaN, and where there is no contact the radius is zero and does not grow.
///
/// ```
/// use tribos_core::patch::elastic::{LoadedRadius, SoftFinger};
/// // By how much a patch grows when the load does by a tenth.
/// fn gain(patch: &impl LoadedRadius<f64>, load: f64) -> f64 {
///     patch.radius(1.1 * load) / patch.radius(load)
/// }
/// let rubber = SoftFinger::new(3e-3, 0.3)?; // m/N^0.3
/// assert!((gain(&rubber, 2.0) - 1.1_f64.powf(0.3)).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub trait LoadedRadius<R: Real> {
    /// The radius a under `load`. *Units*: length.
    fn radius(&self, load: R) -> R;

    /// da/dN. *Units*: length/force. *Special values*: infinite where the radius begins to grow from zero.
    fn slope(&self, load: R) -> R;

    /// d ln a/d ln N = (N/a) da/dN, a number also where the load is zero.
    fn growth(&self, load: R) -> R;
}

/// Elastic constants of an isotropic material.
///
/// ```
/// use tribos_core::patch::elastic::{Elasticity, effective_modulus};
/// let rubber = Elasticity { young: 2e6_f64, poisson: 0.5 }; // Pa
/// let rigid = Elasticity { young: f64::INFINITY, poisson: 0.0 };
/// assert_eq!(effective_modulus(rubber, rigid)?, 2e6 / 0.75);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Elasticity<R> {
    /// Young's modulus E. *Units*: pressure. *Domain*: E > 0; infinite for a rigid body.
    pub young: R,
    /// Poisson's ratio ν. *Domain*: 0 ≤ ν ≤ ½.
    pub poisson: R,
}

impl<R: Real> Elasticity<R> {
    /// (1 − ν²)/E
    fn compliance(&self) -> Result<R, LawError> {
        validated_fraction("double of Poisson's ratio", R::TWO * self.poisson)?;
        if self.young != R::INFINITY {
            validated_positive("Young's modulus", self.young)?;
        }
        Ok((R::ONE - self.poisson) * (R::ONE + self.poisson) / self.young)
    }
}

/// The modulus E* of two bodies in contact, 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂.
///
/// *Units*: pressure. *Domain*: that of [`Elasticity`]; one of both is not rigid. *Accuracy*: 4 ulp.
/// *Source*: Hertz, J. reine angew. Math. 92 (1881) 156; Johnson, Contact Mechanics (1985), eq. 4.20.
///
/// ```
/// use tribos_core::patch::elastic::{Elasticity, effective_modulus};
/// let steel = Elasticity { young: 206e9_f64, poisson: 0.3 }; // Pa
/// assert!((effective_modulus(steel, steel)? / 113.19e9 - 1.0).abs() < 1e-4);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub fn effective_modulus<R: Real>(
    first: Elasticity<R>,
    second: Elasticity<R>,
) -> Result<R, LawError> {
    let compliance = first.compliance()? + second.compliance()?;
    validated_positive("effective modulus", R::ONE / compliance)
}

/// Hertz' contact of spheres: a = (3 N R/(4 E*))^⅓.
///
/// *Units*: any consistent set. *Domain*: 3 N R/(4 E*) is a normal number. *Accuracy*: 4 ulp. *Special values*: zero for
/// loads below zero. *Source*: Johnson, Contact Mechanics (1985), eq. 4.22.
///
/// ```
/// use tribos_core::patch::elastic::{HertzSphere, LoadedRadius};
/// let ball = HertzSphere::new(1e6_f64, 0.01)?; // E* in Pa, radius in m
/// assert!((ball.radius(4.0 / 3.0) - 1e-8_f64.cbrt()).abs() < 1e-17); // N; m
/// assert!((ball.slope(1.0) - ball.radius(1.0) / 3.0).abs() < 1e-17); // m/N
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HertzSphere<R> {
    /// 3 R/(4 E*)
    softness: R,
}

/// Sphere's volume per load: a³ = ¾ N R/E*.
const THREE_QUARTERS: f64 = 0.75;
/// Growth of Hertz' contacts.
const ONE_THIRD: f64 = 1.0 / 3.0;

impl<R: Real> HertzSphere<R> {
    /// *Domain*: both positive and finite. `radius` is that of the sphere on a plane; of two spheres R₁ R₂/(R₁ + R₂), where a
    /// hollow one counts as negative.
    pub fn new(modulus: R, radius: R) -> Result<Self, LawError> {
        validated_positive("effective modulus", modulus)?;
        validated_positive("radius of the sphere", radius)?;
        let softness = R::from_f64(THREE_QUARTERS) * (radius / modulus);
        Ok(Self {
            softness: validated_positive("radius over modulus", softness)?,
        })
    }

    /// The radius under a `load` that is not negative.
    #[inline]
    fn pressed(&self, load: R) -> R {
        cube_root(self.softness * load)
    }
}

impl<R: Real> LoadedRadius<R> for HertzSphere<R> {
    #[inline]
    fn radius(&self, load: R) -> R {
        if load < R::ZERO {
            return R::ZERO;
        }
        self.pressed(load)
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        hertz_slope(load, self.pressed(load))
    }
    #[inline]
    fn growth(&self, load: R) -> R {
        hertz_growth(load)
    }
}

/// a/(3N) of what grows with N^⅓.
#[inline]
fn hertz_slope<R: Real>(load: R, radius: R) -> R {
    if load < R::ZERO || load == R::INFINITY {
        R::ZERO
    } else if load == R::ZERO {
        R::INFINITY
    } else {
        radius / load / R::from_f64(3.0)
    }
}

/// ⅓ under a load, and NaN for NaN.
#[inline]
fn hertz_growth<R: Real>(load: R) -> R {
    if load < R::ZERO {
        R::ZERO
    } else if load.is_nan() {
        load
    } else {
        R::from_f64(ONE_THIRD)
    }
}

/// A soft finger: a = c N^γ.
///
/// γ is ⅓ for a linear elastic one and 0 for one that stiffens so much that its patch no longer grows; rubbers lie between.
/// *Units*: c in length/force^γ. *Accuracy*: that of the power. *Special values*: zero for loads below zero.
/// *Source*: Xydas and Kao, Int. J. Robot. Res. 18 (1999) 941.
///
/// ```
/// use tribos_core::law::LawError;
/// use tribos_core::patch::elastic::{LoadedRadius, SoftFinger};
/// let finger = SoftFinger::new(4e-3_f64, 0.25)?; // m/N^0.25
/// assert!((finger.radius(16.0) - 8e-3).abs() < 1e-17); // N; m
/// assert!((finger.slope(16.0) - 0.25 * 8e-3 / 16.0).abs() < 1e-19);
/// assert!(SoftFinger::new(4e-3_f64, 0.5).is_err()); // grows faster than a linear elastic one
/// # Ok::<(), LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SoftFinger<R> {
    scale: R,
    exponent: R,
}

impl<R: Real> SoftFinger<R> {
    /// *Domain*: 0 < `scale` < ∞, the radius under unit load; 0 ≤ `exponent` ≤ ⅓.
    pub fn new(scale: R, exponent: R) -> Result<Self, LawError> {
        validated_positive("radius under unit load", scale)?;
        let third = R::from_f64(ONE_THIRD);
        if exponent != third {
            validated_fraction(
                "triple of the finger's exponent",
                R::from_f64(3.0) * exponent,
            )?;
        }
        Ok(Self { scale, exponent })
    }
}

impl<R: Real> LoadedRadius<R> for SoftFinger<R> {
    #[inline]
    fn radius(&self, load: R) -> R {
        if load < R::ZERO {
            return R::ZERO;
        }
        if load.is_nan() {
            return load;
        }
        self.scale * load.pow(self.exponent)
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        let is_still = self.exponent == R::ZERO && !load.is_nan();
        if load < R::ZERO || load == R::INFINITY || is_still {
            R::ZERO
        } else if load == R::ZERO {
            R::INFINITY
        } else {
            self.exponent * self.radius(load) / load
        }
    }
    #[inline]
    fn growth(&self, load: R) -> R {
        if load < R::ZERO {
            R::ZERO
        } else if load.is_nan() {
            load
        } else {
            self.exponent
        }
    }
}

/// The cube root of a number that is not negative: the power, and one step of Newton's method. *Accuracy*: 2 ulp.
#[inline]
fn cube_root<R: Real>(x: R) -> R {
    let rough = x.pow(R::from_f64(ONE_THIRD));
    let square = rough * rough;
    let change = (square * rough - x) / (R::from_f64(3.0) * square);
    // Zero and infinity are their own.
    if change.is_finite() {
        rough - change
    } else {
        rough
    }
}
