//! Reduced friction of a round patch under a power law, as two functions of the ratio of its speeds.
//!
//! Let v be the sliding speed, w = ωR the rim speed, m = max(v, w), h = min(v, w)/m and x = h².
//! For the local law |u|^α the dissipation potential D(v, w) = ⟨|u|^(α+1)⟩/(α+1), a mean over the
//! pressure, is homogeneous of degree α + 1. Its gradient is
//!
//! ```text
//! F = m^(α−1) v Φ,      T = m^(α−1) w Χ,      Φ and Χ functions of x, apart for v > w and v ≤ w
//! ```
//!
//! and C_α(ε) = ε T/F, which decides the final motion, is Χ/Φ. The symmetry ∂F/∂w = ∂T/∂v ties
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

use super::extended_range::is_in_normal_range;
use super::extreme_range;
use super::speeds::{DominantSpeed, Speeds};
use super::{ReducedJacobian, ReducedWrench};
use crate::real::Real;

/// A round patch under a power law |v|^α: every fitted form, table and series is one.
///
/// Its methods but [`PowerLawFriction::exponent`] serve the kernel and are no part of the promise.
///
/// ```
/// use tribos_core::coupling::{PowerLawFriction, compact::CompactPower, coulomb::CoulombDisk};
/// fn is_dry(profile: &impl PowerLawFriction<f64>) -> bool {
///     profile.exponent() == 0.0
/// }
/// assert!(is_dry(&CoulombDisk) && !is_dry(&CompactPower::new(0.5)?));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub trait PowerLawFriction<R: Real> {
    /// The exponent α > −1 of the local law.
    fn exponent(&self) -> R;

    /// Φ and Χ of a motion: at rest there is no larger speed, and callers answer themselves.
    #[doc(hidden)]
    fn factors(&self, at: &Speeds<R>) -> [R; 2];

    /// Φ and T/m^α = b Χ with b = w/m.
    #[doc(hidden)]
    #[inline]
    fn drag_and_torque(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, chi] = self.factors(at);
        [phi, at.rim * chi]
    }

    /// F/v and T for v² and w. *Domain*: that of [`super::ReducedFriction::reduced_drag`].
    #[doc(hidden)]
    #[inline]
    fn drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        drag(self, slide_sq, rim)
    }

    /// C_α(ε) − C: its sign decides where ε goes, its size how fast.
    /// A profile that can keeps its digits where the plain difference has none, at α → 1.
    #[doc(hidden)]
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        let [phi, chi] = self.factors(at);
        chi / phi - inertia_ratio
    }

    /// C_α(0) and C_α(∞), the ends of C_α = Χ/Φ.
    #[doc(hidden)]
    fn inertia_ends(&self) -> [R; 2] {
        [DominantSpeed::Spinning, DominantSpeed::Sliding].map(|lead| {
            let [phi, chi] = self.factors(&Speeds::from_ratio(lead, R::ZERO));
            chi / phi
        })
    }

    /// `speed`^α.
    #[doc(hidden)]
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
    #[doc(hidden)]
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        let alpha = self.exponent();
        if alpha == R::ZERO {
            R::ONE / speed
        } else {
            speed.pow(alpha - R::ONE)
        }
    }
}

/// A profile with the slope of Φ, which makes its Jacobian analytic.
pub trait SmoothProfile<R: Real>: PowerLawFriction<R> {
    /// Φ, Φ' (with respect to x = h²) and Χ.
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3];

    /// The same, and Φ' for a Newton step: half of its digits are enough.
    #[doc(hidden)]
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.factors_and_slope(at)
    }
}

impl<R: Real, P: PowerLawFriction<R> + ?Sized> PowerLawFriction<R> for &P {
    #[inline]
    fn exponent(&self) -> R {
        (**self).exponent()
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        (**self).factors(at)
    }
    #[inline]
    fn drag_and_torque(&self, at: &Speeds<R>) -> [R; 2] {
        (**self).drag_and_torque(at)
    }
    #[inline]
    fn drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        (**self).drag(slide_sq, rim)
    }
    #[inline]
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        (**self).inertia_excess(at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        (**self).inertia_ends()
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        (**self).speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        (**self).rate_scale(speed)
    }
}

impl<R: Real, P: SmoothProfile<R> + ?Sized> SmoothProfile<R> for &P {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        (**self).factors_and_slope(at)
    }
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        (**self).factors_and_rough_slope(at)
    }
}

/// The wrench with the power of the velocity scale left out, (F, T)/max(v, w)^α: what a caller
/// that keeps the scale itself needs. Zero at rest.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, table::DiskTable64, unscaled_wrench};
/// let law = DiskTable64::new(0.5)?;
/// let (whole, bare) = (law.reduced_wrench(0.3, 0.4), unscaled_wrench(&law, 0.3, 0.4));
/// assert!((whole.force - bare.force * 0.4_f64.sqrt()).abs() < 1e-15);
/// assert!((whole.torque - bare.torque * 0.4_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[doc(hidden)]
#[inline]
pub fn unscaled_wrench<R: Real, P: PowerLawFriction<R>>(
    profile: &P,
    slide: R,
    rim: R,
) -> ReducedWrench<R> {
    let speeds = Speeds::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench::default();
    }
    let [drag, torque] = profile.drag_and_torque(&speeds);
    ReducedWrench {
        force: speeds.slide * drag,
        torque,
    }
}

/// [`super::ReducedFriction::reduced_wrench`] of a profile.
#[inline]
pub(super) fn wrench<R: Real, P: PowerLawFriction<R>>(
    profile: &P,
    slide: R,
    rim: R,
) -> ReducedWrench<R> {
    let speeds = Speeds::new(slide, rim);
    if speeds.at_rest() {
        return ReducedWrench::default();
    }
    let scale = profile.speed_scale(speeds.major);
    let [force, torque] = if speeds.may_be_scaled(scale, slide, rim) {
        let [drag, torque] = profile.drag_and_torque(&speeds);
        [scale * (speeds.slide * drag), scale * torque]
    } else {
        extreme_range::wrench(profile, &speeds, slide, rim)
    };
    ReducedWrench { force, torque }
}

/// [`PowerLawFriction::drag`] of any profile: one division for all.
#[inline]
fn drag<R: Real, P: PowerLawFriction<R> + ?Sized>(profile: &P, slide_sq: R, rim: R) -> [R; 2] {
    let slide = slide_sq.sqrt();
    let (speeds, per_major) = Speeds::of_ordinary(slide, rim);
    let scale = profile.speed_scale(speeds.major);
    let per_speed = scale * per_major;
    // 1/m itself is ordinary.
    if scale == R::ONE || is_in_normal_range(scale) && is_in_normal_range(per_speed) {
        let [drag, torque] = profile.drag_and_torque(&speeds);
        [per_speed * drag, scale * torque]
    } else {
        drag_extended_range(profile, slide, rim)
    }
}

#[cold]
#[inline(never)]
fn drag_extended_range<R: Real, P: PowerLawFriction<R> + ?Sized>(
    profile: &P,
    slide: R,
    rim: R,
) -> [R; 2] {
    let ReducedWrench { force, torque } = wrench(&profile, slide, rim);
    [force / slide, torque]
}

/// [`super::ReducedFriction::reduced_jacobian`] of a profile.
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
    let scale = profile.rate_scale(speeds.major);
    let [force_per_slide, force_slide, mixed, torque_rim] =
        if is_in_normal_range(scale) && speeds.major.is_finite() && speeds.are_resolved(slide, rim)
        {
            let factors = profile.factors_and_slope(&speeds);
            unscaled_jacobian(profile.exponent(), &speeds, factors).map(|x| scale * x)
        } else {
            extreme_range::jacobian(profile, &speeds, [slide, rim])
        };
    ReducedJacobian {
        force_per_slide,
        force_slide,
        mixed,
        torque_rim,
    }
}

/// F/v, ∂F/∂v, ∂F/∂w and ∂T/∂w over m^(α−1).
#[inline]
fn unscaled_jacobian<R: Real>(alpha: R, speeds: &Speeds<R>, [phi, slope, chi]: [R; 3]) -> [R; 4] {
    let h = speeds.ratio();
    let bend = R::TWO * slope;
    // At equal speeds the slope may be infinite while its products are finite or infinite.
    let x_bend = h * h * bend;
    match speeds.lead() {
        DominantSpeed::Sliding => [phi, alpha * phi - x_bend, h * bend, alpha * chi - bend],
        DominantSpeed::Spinning => {
            let mixed = -h * ((R::ONE - alpha) * phi + x_bend);
            [phi, phi + x_bend, mixed, alpha * chi - h * mixed]
        }
    }
}

/// [`super::DryReducedFriction::reduced_point`] of a profile.
#[inline]
pub(super) fn point<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    lead: DominantSpeed,
    ratio: R,
) -> [R; 3] {
    let speeds = Speeds::from_ratio(lead, ratio);
    let [phi, slope, chi] = profile.factors_and_rough_slope(&speeds);
    match lead {
        DominantSpeed::Sliding => [phi, ratio * chi, -(R::TWO * slope)],
        DominantSpeed::Spinning => [chi, ratio * phi, phi + R::TWO * (ratio * ratio) * slope],
    }
}

/// The Jacobian at v = w = 0: zero for α > 1, the constant damping for α = 1, infinite below.
pub(super) fn at_rest<R: Real, P: PowerLawFriction<R>>(profile: &P) -> ReducedJacobian<R> {
    let alpha = profile.exponent();
    let (slide, rim) = if alpha > R::ONE {
        (R::ZERO, R::ZERO)
    } else if alpha == R::ONE {
        let [phi, chi] = profile.factors(&Speeds::from_ratio(DominantSpeed::Spinning, R::ZERO));
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
