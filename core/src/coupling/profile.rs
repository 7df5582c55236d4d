//! The two functions of one variable that carry the whole coupling of the uniform disk.
//!
//! Let v be the sliding speed, w = ωR the rim speed, h ∈ [0, 1] the smaller over the larger of the
//! two and x = h². For the local law |u|^α the dissipation potential is
//! D(v, w) = ⟨|u|^(α+1)⟩/(α+1), homogeneous of degree α + 1, and its gradient is (F, T). With
//!
//! ```text
//! Φ(x) = ₂F₁((1−α)/2, −(1+α)/2; 2; x),      Θ(x) = (1+α)/4 · ₂F₁((1−α)/2, (1−α)/2; 3; x)
//! ```
//!
//! sliding leads (v > w):  F = v^α Φ,    T = v^α h Θ;
//! spinning leads (v ≤ w): F = w^α h Φ,  T = w^α ( 2/(3+α) · (1−x) Φ + x Θ ).
//!
//! The last line replaces the torque's own hypergeometric function, 2/(3+α) ₂F₁((1−α)/2,
//! −(3+α)/2; 1; x): contiguous to Φ and Θ, it is their combination with positive coefficients, so
//! that nothing cancels for any α > −1. Gauss' relations also give
//! Θ = 2/(3+α) · ( (1+α)/2 Φ + (1−x) Φ' ), hence Φ and Φ' alone are enough to build everything,
//! and the Jacobian needs Φ' and nothing else:
//!
//! ```text
//! F/v   = m^(α−1) Φ                                  (m = the larger speed, in both regimes)
//! ∂F/∂v = m^(α−1) (αΦ − 2xΦ')  |  m^(α−1) (Φ + 2xΦ')          sliding | spinning leads
//! ∂F/∂w = ∂T/∂v = m^(α−1) 2hΦ' |  −m^(α−1) h ((1−α)Φ + 2xΦ')
//! ∂T/∂w = (α T − v ∂T/∂v)/w, with w divided out
//! ```
//!
//! *Source*: the integrals are eqs. 3.6–3.10 of the thesis (for α = 0: Farkas, Bartels, Unger, Wolf,
//! Phys. Rev. Lett. 90 (2003) 248302); `docs/theory.md` derives the forms above.

#[cfg(doc)]
use super::Coupling;
use super::{ReducedJacobian, ReducedWrench};
use crate::real::Real;

/// A way to evaluate Φ, Θ and Φ' for one exponent: what an accuracy tier implements.
pub trait Profile<R: Real> {
    /// The exponent α > −1 of the local law.
    fn exponent(&self) -> R;

    /// Φ and Θ at h ∈ [0, 1].
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2];

    /// Φ and Φ' (with respect to x = h²) at z = 1 − h².
    fn force_factor_and_slope(&self, complement: R) -> [R; 2];

    /// `speed`^α.
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        speed.pow(self.exponent())
    }

    /// `speed`^(α−1).
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        speed.pow(self.exponent() - R::ONE)
    }

    /// Square roots of the two scales, for results whose scale alone leaves the number range.
    #[cold]
    fn half_scales(&self, speed: R) -> [R; 2] {
        let alpha = self.exponent();
        [
            speed.pow(R::HALF * alpha),
            speed.pow(R::HALF * (alpha - R::ONE)),
        ]
    }
}

impl<R: Real, P: Profile<R> + ?Sized> Profile<R> for &P {
    #[inline]
    fn exponent(&self) -> R {
        (**self).exponent()
    }
    #[inline]
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2] {
        (**self).force_and_torque_factors(ratio)
    }
    #[inline]
    fn force_factor_and_slope(&self, complement: R) -> [R; 2] {
        (**self).force_factor_and_slope(complement)
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        (**self).speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        (**self).rate_scale(speed)
    }
    #[inline]
    fn half_scales(&self, speed: R) -> [R; 2] {
        (**self).half_scales(speed)
    }
}

/// The two speeds in units of the larger one.
struct Scaled<R> {
    major: R,
    slide: R,
    rim: R,
}

impl<R: Real> Scaled<R> {
    #[inline]
    fn new(slide: R, rim: R) -> Self {
        let (slide, rim) = (slide.abs(), rim.abs());
        let major = if slide > rim { slide } else { rim };
        let (a, b) = (slide / major, rim / major);
        // One comparison finds rest (0/0), infinities (∞/∞) and NaN.
        if a * b >= R::ZERO {
            Self {
                major,
                slide: a,
                rim: b,
            }
        } else {
            Self::unordinary(slide, rim)
        }
    }

    /// Rest, infinities and NaN: the limit if only one speed is infinite, zeros at rest.
    #[cold]
    fn unordinary(slide: R, rim: R) -> Self {
        let in_units = |speed: R, other: R| {
            if speed == R::INFINITY && other < R::INFINITY {
                R::ONE
            } else if other == R::INFINITY && speed < R::INFINITY {
                R::ZERO
            } else if speed == R::INFINITY {
                speed - other
            } else {
                // Zero, or NaN from either.
                speed + R::ZERO * other
            }
        };
        Self {
            major: slide + rim,
            slide: in_units(slide, rim),
            rim: in_units(rim, slide),
        }
    }

    /// True if nothing moves; false for NaN.
    #[inline]
    fn at_rest(&self) -> bool {
        self.major == R::ZERO
    }

    /// The smaller speed over the larger one: one of the two factors is 1.
    #[inline]
    fn ratio(&self) -> R {
        self.slide * self.rim
    }
}

/// 1 − h², without cancellation near equal speeds; NaN for infinite ones.
#[inline]
fn complement<R: Real>(slide: R, rim: R, major: R, ratio: R) -> R {
    (slide.abs() - rim.abs()).abs() / major * (R::ONE + ratio)
}

/// 2/(3+α): the reduced torque of pure spinning.
#[inline]
fn pure_spin_torque<R: Real>(alpha: R) -> R {
    R::TWO / (R::ONE + R::TWO + alpha)
}

/// F/m^α and T/m^α from the factors.
///
/// With a = v/m and h = min/max one pair of formulas serves both regimes, F = aΦ and
/// T = 2/(3+α) (1−a²) Φ + a h Θ: which speed leads is a coin toss to a branch predictor.
#[inline]
fn unscaled<R: Real, P: Profile<R>>(profile: &P, speeds: &Scaled<R>) -> ReducedWrench<R> {
    let (a, h) = (speeds.slide, speeds.ratio());
    let [phi, theta] = profile.force_and_torque_factors(h);
    let spin = pure_spin_torque(profile.exponent()) * (R::ONE - a * a);
    ReducedWrench {
        force: a * phi,
        torque: spin * phi + a * h * theta,
    }
}

/// The wrench with the power of the velocity scale left out, (F, T)/max(v, w)^α: what a caller
/// that keeps the scale itself needs. Zero at rest.
#[inline]
pub fn unscaled_wrench<R: Real, P: Profile<R>>(profile: &P, slide: R, rim: R) -> ReducedWrench<R> {
    let speeds = Scaled::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench {
            force: R::ZERO,
            torque: R::ZERO,
        };
    }
    unscaled(profile, &speeds)
}

/// [`Coupling::reduced_wrench`] of a profile.
#[inline]
pub(super) fn wrench<R: Real, P: Profile<R>>(profile: &P, slide: R, rim: R) -> ReducedWrench<R> {
    let speeds = Scaled::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench {
            force: R::ZERO,
            torque: R::ZERO,
        };
    }
    let ReducedWrench { force, torque } = unscaled(profile, &speeds);
    let scale = profile.speed_scale(speeds.major);
    let [force, torque] = if is_ordinary(scale) {
        [scale * force, scale * torque]
    } else {
        let [half, _] = profile.half_scales(speeds.major);
        [force, torque].map(|x| in_halves(x, half, speeds.major))
    };
    ReducedWrench { force, torque }
}

/// [`Coupling::reduced_jacobian`] of a profile.
#[inline]
pub(super) fn jacobian<R: Real, P: Profile<R>>(
    profile: &P,
    slide: R,
    rim: R,
) -> ReducedJacobian<R> {
    let speeds = Scaled::new(slide, rim);
    let alpha = profile.exponent();
    if speeds.at_rest() {
        return at_rest(alpha);
    }
    let h = speeds.ratio();
    let x = h * h;
    let z = complement(slide, rim, speeds.major, h);
    let [phi, slope] = profile.force_factor_and_slope(z);
    // Θ from Φ and Φ': one table read serves all.
    let theta = pure_spin_torque(alpha) * (R::HALF * (R::ONE + alpha) * phi + z * slope);
    let twice = R::TWO * slope;
    let (force_slide, mixed, torque_rim);
    if speeds.slide > speeds.rim {
        force_slide = alpha * phi - x * twice;
        mixed = h * twice;
        torque_rim = alpha * theta - twice;
    } else {
        force_slide = phi + x * twice;
        mixed = -h * ((R::ONE - alpha) * phi + x * twice);
        let torque = pure_spin_torque(alpha) * z * phi + x * theta;
        torque_rim = alpha * torque - h * mixed;
    }
    let scale = profile.rate_scale(speeds.major);
    let entries = [phi, force_slide, mixed, torque_rim];
    let [force_per_slide, force_slide, mixed, torque_rim] = if is_ordinary(scale) {
        entries.map(|x| scale * x)
    } else {
        let [_, half] = profile.half_scales(speeds.major);
        entries.map(|x| in_halves(x, half, speeds.major))
    };
    ReducedJacobian {
        force_per_slide,
        force_slide,
        mixed,
        torque_rim,
    }
}

/// True if a product with `scale` can be formed at once.
#[inline]
fn is_ordinary<R: Real>(scale: R) -> bool {
    scale >= R::MIN_POSITIVE && scale.is_finite()
}

/// `x` times the square of `half`; zero stays zero for a finite `major` speed.
#[cold]
fn in_halves<R: Real>(x: R, half: R, major: R) -> R {
    if x == R::ZERO && major.is_finite() {
        x
    } else {
        x * half * half
    }
}

/// The Jacobian at v = w = 0: zero for α > 1, the constant damping for α = 1, infinite below.
fn at_rest<R: Real>(alpha: R) -> ReducedJacobian<R> {
    let (slide, rim) = if alpha > R::ONE {
        (R::ZERO, R::ZERO)
    } else if alpha == R::ONE {
        (R::ONE, R::HALF)
    } else {
        (R::INFINITY, R::INFINITY)
    };
    ReducedJacobian {
        force_per_slide: slide,
        force_slide: slide,
        mixed: R::ZERO,
        torque_rim: rim,
    }
}
