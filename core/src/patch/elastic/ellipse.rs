//! Hertz' contact of two curved faces: an ellipse.
//!
//! With the relative principal curvatures 2A ≤ 2B, the ratio κ = b/a ≤ 1 of the semi-axes and the elliptic integrals
//! B, D of m = 1 − κ² (as in [`CompleteElliptic`]) Hertz' conditions are (Johnson, Contact Mechanics (1985), eq. 4.26)
//!
//! ```text
//! A/B = κ² D(m)/B(m),     a³ = (3 N/(2π E*)) D(m)/A
//! ```
//!
//! The first gives κ by Newton's method in logarithms, where its slope is d ln(A/B)/d ln κ = 1 + C/D + κ² C/B, between 3/2 and
//! 2: from κ = (A/B)^⅔, which is right for circles (Greenwood, Tribol. Int. 30 (1997) 235), each step leaves a small share.

use super::{cube_root, hertz_growth, hertz_slope};
use crate::error::Error;
use crate::law::validated_positive;
use crate::patch::PatchError;
use crate::real::Real;
use crate::special::CompleteElliptic;

/// Relative principal curvatures of two faces, whose first axes are `angle` apart, the smaller one first.
///
/// Half of their sum is Σκ/2 over all four, half of their difference √(δ₁² + δ₂² + 2 δ₁ δ₂ cos 2ψ)/2 with δ the
/// difference of both curvatures of a face. Hollow faces count as negative, planes have none.
/// *Units*: 1/length; radians. *Accuracy*: 4 ulp of the largest curvature. *Special values*: NaN for NaN and infinities.
/// *Source*: Johnson, Contact Mechanics (1985), eqs. 4.3 to 4.5.
///
/// ```
/// use tribos_core::patch::elastic::relative_curvatures;
/// // Two cylinders of 1 cm, crossed at a right angle: as a sphere of 1 cm on a plane.
/// let cylinder = [100.0_f64, 0.0]; // 1/m
/// let crossed = relative_curvatures(cylinder, cylinder, core::f64::consts::FRAC_PI_2);
/// assert!(crossed.map(|curvature| (curvature - 100.0).abs() < 1e-12) == [true; 2]);
/// ```
pub fn relative_curvatures<R: Real>(first: [R; 2], second: [R; 2], angle: R) -> [R; 2] {
    let [[a, b], [c, d]] = [first, second];
    let (own, other) = (a - b, c - d);
    // The two differences as arms that are twice the angle apart.
    let double = R::TWO * angle;
    let apart = (own + other * double.cos()).hypot(other * double.sin());
    let sum = a + b + c + d;
    [R::HALF * (sum - apart), R::HALF * (sum + apart)]
}

/// Hertz' contact of two faces with different relative curvatures: an ellipse, whose axes grow with N^⅓.
///
/// *Units*: any consistent set. *Accuracy*: semi-axes 4 ulp, 16 ulp where their ratio is below 1e-2.
/// *Special values*: zero for loads below zero, NaN for NaN. *Source*: Hertz, J. reine angew. Math. 92 (1881) 156.
///
/// ```
/// use tribos_core::patch::elastic::HertzEllipse;
/// // A railway wheel of 0.46 m on a rail of 0.3 m, of steel, under 100 kN.
/// let wheel = HertzEllipse::new(113.19e9_f64, [1.0 / 0.46, 1.0 / 0.3])?; // E* in Pa, 1/m
/// let [along, across] = wheel.semi_axes(1e5);
/// assert!((along - 7.2077e-3).abs() < 1e-6 && (across - 5.4218e-3).abs() < 1e-6); // m
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HertzEllipse<R> {
    /// a³/N along each direction.
    softness: [R; 2],
    ratio: R,
}

/// Newton steps at most; four were the most in 10⁵ ratios over twenty decades.
const MOST_STEPS: u32 = 12;
/// Rounding errors of a step after which none follows.
const STILL_ULPS: f64 = 8.0;
/// 3/π of a³ = (3 N/(π E*)) D/(2A).
const THREE_OVER_PI: f64 = 3.0 / core::f64::consts::PI;

impl<R: Real> HertzEllipse<R> {
    /// The least ratio of curvatures served: below, the patch is a line for all purposes of this model.
    pub const LEAST_RATIO: f64 = 1e-20;

    /// *Domain*: `modulus` E* and both relative `curvatures` (as of [`relative_curvatures`], along two axes at a right angle)
    /// positive and finite; the smaller at least [`HertzEllipse::LEAST_RATIO`] of the larger. *Errors*: [`PatchError::Unsolved`]
    /// if the equation of the axes is not solved to rounding within 12 steps, which was never seen.
    pub fn new(modulus: R, curvatures: [R; 2]) -> Result<Self, Error> {
        validated_positive("effective modulus", modulus)?;
        let [first, second] = curvatures;
        for curvature in curvatures {
            validated_positive("relative curvature", curvature)?;
        }
        let is_first_longer = first <= second;
        let (small, large) = if is_first_longer {
            (first, second)
        } else {
            (second, first)
        };
        let wanted = small / large;
        if wanted < R::from_f64(Self::LEAST_RATIO) {
            let given = wanted.to_f64();
            let least = Self::LEAST_RATIO;
            return Err(PatchError::CurvatureRatio { given, least }.into());
        }
        let ratio = axes_ratio(wanted).ok_or(PatchError::Unsolved)?;
        // The longer axis from the smaller curvature.
        let integrals = CompleteElliptic::new(ratio * ratio);
        let long = R::from_f64(THREE_OVER_PI) * integrals.d / modulus / small;
        let short = long * ratio * ratio * ratio;
        let softness = if is_first_longer {
            [long, short]
        } else {
            [short, long]
        };
        for part in softness {
            validated_positive("cube of an axis over the load", part)?;
        }
        Ok(Self { softness, ratio })
    }

    /// Shorter over longer axis, κ = b/a.
    pub fn axes_ratio(&self) -> R {
        self.ratio
    }

    /// Semi-axes under `load`, in the order of the curvatures: the larger curvature has the shorter axis.
    pub fn semi_axes(&self, load: R) -> [R; 2] {
        if load < R::ZERO {
            return [R::ZERO; 2];
        }
        self.softness.map(|softness| cube_root(softness * load))
    }

    /// Their slopes by the load. *Units*: length/force. *Special values*: infinite without load.
    pub fn slopes(&self, load: R) -> [R; 2] {
        self.semi_axes(load).map(|axis| hertz_slope(load, axis))
    }

    /// d ln a/d ln N = ⅓ of both.
    pub fn growth(&self, load: R) -> R {
        hertz_growth(load)
    }
}

/// κ = b/a for A/B; nothing if the steps do not end.
fn axes_ratio<R: Real>(wanted: R) -> Option<R> {
    let mut ratio = wanted.pow(R::from_f64(2.0 / 3.0));
    for _ in 0..MOST_STEPS {
        let square = ratio * ratio;
        let CompleteElliptic { b, d, c, .. } = CompleteElliptic::new(square);
        // ln of what this ratio misses, by what is missing.
        let missed = (square * d / b - wanted) / wanted;
        let slope = R::ONE + c / d + square * c / b;
        let step = -missed.ln_1p() / slope;
        ratio += ratio * step.exp_m1();
        // Rounding may carry a circle beyond itself.
        if ratio > R::ONE {
            ratio = R::ONE;
        }
        let still = R::from_f64(STILL_ULPS) * R::EPSILON * (R::ONE + d);
        if step.abs() <= still {
            return Some(ratio);
        }
    }
    None
}
