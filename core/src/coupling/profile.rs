//! What a round patch under a power law comes to: two functions of the ratio of its speeds.
//!
//! Let v be the sliding speed, w = ωR the rim speed, m = max(v, w), h = min(v, w)/m and x = h².
//! For the local law |u|^α the dissipation potential D(v, w) = ⟨|u|^(α+1)⟩/(α+1), a mean over the
//! pressure, is homogeneous of degree α + 1. Its gradient is
//!
//! ```text
//! F = m^(α−1) v Φ,      T = m^(α−1) w Χ,      Φ and Χ functions of x, apart for v > w and v ≤ w
//! ```
//!
//! and C_α(ε) = ε T/F, on which the final motion hangs, is Χ/Φ. The symmetry ∂F/∂w = ∂T/∂v ties
//! the two, so that the Jacobian needs Φ' and nothing else:
//!
//! ```text
//! F/v   = m^(α−1) Φ
//! ∂F/∂v = m^(α−1) (αΦ − 2xΦ')  |  m^(α−1) (Φ + 2xΦ')          sliding | spinning leads
//! ∂F/∂w = ∂T/∂v = m^(α−1) 2hΦ' |  −m^(α−1) h ((1−α)Φ + 2xΦ')
//! ∂T/∂w = (α T − v ∂T/∂v)/w, with w divided out
//! ```
//!
//! For the pressures (1−r²)^q Gauss' relations give Χ from Φ and Φ' as well. With z = 1 − x and
//! n = q + (3+α)/2, which is F'(0)/T(0),
//!
//! ```text
//! Θ = ( (1+α)/2 Φ + z Φ' )/n
//! sliding leads: Χ = Θ,      spinning leads: Χ = z Φ/n + x Θ
//! ```
//!
//! *Source*: the integrals are eqs. 3.6–3.10 of the thesis (for α = 0: Farkas, Bartels, Unger, Wolf,
//! Phys. Rev. Lett. 90 (2003) 248302); `docs/theory.md` derives the forms above.

use super::speeds::{Lead, Speeds};
use super::{ReducedJacobian, ReducedWrench};
use crate::real::Real;

/// A way to evaluate Φ and Χ for one exponent and pressure: what an accuracy tier implements.
pub trait Profile<R: Real> {
    /// The exponent α > −1 of the local law.
    fn exponent(&self) -> R;

    /// Φ and Χ.
    fn factors(&self, at: &Speeds<R>) -> [R; 2];

    /// (F, T)/m^α = (a Φ, b Χ) with a = v/m and b = w/m.
    #[inline]
    fn unscaled(&self, at: &Speeds<R>) -> ReducedWrench<R> {
        let [phi, chi] = self.factors(at);
        ReducedWrench {
            force: at.slide * phi,
            torque: at.rim * chi,
        }
    }

    /// C_α(ε) − C up to a positive factor, by default 1: its sign decides the final motion.
    /// A profile that can keeps its digits where C_α − C has none, at α → 1.
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        let [phi, chi] = self.factors(at);
        chi / phi - inertia_ratio
    }

    /// C_α(0) and C_α(∞), the ends of C_α = Χ/Φ.
    fn inertia_ends(&self) -> [R; 2] {
        [Lead::Spinning, Lead::Sliding].map(|lead| {
            let [phi, chi] = self.factors(&Speeds::from_ratio(lead, R::ZERO));
            chi / phi
        })
    }

    /// `speed`^α.
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        let alpha = self.exponent();
        if alpha == R::ZERO {
            R::ONE
        } else {
            speed.pow(alpha)
        }
    }

    /// `speed`^(α−1).
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        let alpha = self.exponent();
        if alpha == R::ZERO {
            R::ONE / speed
        } else {
            speed.pow(alpha - R::ONE)
        }
    }

    /// Square roots of the two scales, for results whose scale alone leaves the number range.
    #[cold]
    fn half_scales(&self, speed: R) -> [R; 2] {
        let alpha = self.exponent();
        if alpha == R::ZERO {
            return [R::ONE, R::ONE / speed.sqrt()];
        }
        [
            speed.pow(R::HALF * alpha),
            speed.pow(R::HALF * (alpha - R::ONE)),
        ]
    }
}

/// A profile that knows the slope of Φ, which makes its Jacobian analytic.
pub trait SmoothProfile<R: Real>: Profile<R> {
    /// Φ, Φ' (with respect to x = h²) and Χ.
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3];
}

impl<R: Real, P: Profile<R> + ?Sized> Profile<R> for &P {
    #[inline]
    fn exponent(&self) -> R {
        (**self).exponent()
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        (**self).factors(at)
    }
    #[inline]
    fn unscaled(&self, at: &Speeds<R>) -> ReducedWrench<R> {
        (**self).unscaled(at)
    }
    #[inline]
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        (**self).inertia_excess(at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        (**self).inertia_ends()
    }
}

impl<R: Real, P: SmoothProfile<R> + ?Sized> SmoothProfile<R> for &P {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        (**self).factors_and_slope(at)
    }
}

/// The wrench with the power of the velocity scale left out, (F, T)/max(v, w)^α: what a caller
/// that keeps the scale itself needs. Zero at rest.
#[inline]
pub fn unscaled_wrench<R: Real, P: Profile<R>>(profile: &P, slide: R, rim: R) -> ReducedWrench<R> {
    let speeds = Speeds::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench::default();
    }
    profile.unscaled(&speeds)
}

/// [`super::Coupling::reduced_wrench`] of a profile.
#[inline]
pub(super) fn wrench<R: Real, P: Profile<R>>(profile: &P, slide: R, rim: R) -> ReducedWrench<R> {
    let speeds = Speeds::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench::default();
    }
    let ReducedWrench { force, torque } = profile.unscaled(&speeds);
    let [force, torque] = scaled(profile, speeds.major, [force, torque]);
    ReducedWrench { force, torque }
}

/// `entries` times `major`^α.
#[inline]
pub(super) fn scaled<R: Real, P: Profile<R>, const N: usize>(
    profile: &P,
    major: R,
    entries: [R; N],
) -> [R; N] {
    let scale = profile.speed_scale(major);
    if is_ordinary(scale) {
        entries.map(|x| scale * x)
    } else {
        let [half, _] = profile.half_scales(major);
        entries.map(|x| in_halves(x, half, major))
    }
}

/// [`super::Coupling::reduced_jacobian`] of a profile.
#[inline]
pub(super) fn jacobian<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    slide: R,
    rim: R,
) -> ReducedJacobian<R> {
    let speeds = Speeds::new(slide, rim);
    if speeds.at_rest() {
        return at_rest(profile);
    }
    let [phi, slope, chi] = profile.factors_and_slope(&speeds);
    let alpha = profile.exponent();
    let h = speeds.ratio();
    let bend = R::TWO * slope;
    // At equal speeds the slope may be infinite while its products are finite or infinite.
    let x_bend = h * h * bend;
    let (force_slide, mixed, torque_rim) = match speeds.lead() {
        Lead::Sliding => (alpha * phi - x_bend, h * bend, alpha * chi - bend),
        Lead::Spinning => {
            let mixed = -h * ((R::ONE - alpha) * phi + x_bend);
            (phi + x_bend, mixed, alpha * chi - h * mixed)
        }
    };
    let entries = [phi, force_slide, mixed, torque_rim];
    let scale = profile.rate_scale(speeds.major);
    let [force_per_slide, force_slide, mixed, torque_rim] = if !speeds.major.is_finite() {
        [R::NAN; 4]
    } else if is_ordinary(scale) {
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
pub(super) fn is_ordinary<R: Real>(scale: R) -> bool {
    scale >= R::MIN_POSITIVE && scale.is_finite()
}

/// `x` times the square of `half`; zero stays zero for a finite `major` speed.
#[cold]
pub(super) fn in_halves<R: Real>(x: R, half: R, major: R) -> R {
    if x == R::ZERO && major.is_finite() {
        x
    } else {
        x * half * half
    }
}

/// The Jacobian at v = w = 0: zero for α > 1, the constant damping for α = 1, infinite below.
pub(super) fn at_rest<R: Real, P: Profile<R>>(profile: &P) -> ReducedJacobian<R> {
    let alpha = profile.exponent();
    let (slide, rim) = if alpha > R::ONE {
        (R::ZERO, R::ZERO)
    } else if alpha == R::ONE {
        let [phi, chi] = profile.factors(&Speeds::from_ratio(Lead::Spinning, R::ZERO));
        (phi, chi)
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
