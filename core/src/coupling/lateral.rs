//! The lateral function: the sideways force on a spinning contact whose pressure increases forwards.
//!
//! Let the pressure gain a linear term, p (1 + l·r) with r in radii and l in the contact plane. The
//! element at r then adds to the dissipation potential a multiple of one new function of the speeds,
//!
//! ```text
//! D = D₀(v, w) − l_y v G(v, w),      x along the velocity, y to the left, spin counterclockwise
//! ```
//!
//! Its gradient is all there is: a force l_x G to the right of the velocity, and from l_y the
//! changes −l_y ∂(vG)/∂v of F and −l_y ∂(vG)/∂w of T. For the pressures (1−r²)^q G needs no function
//! of its own,
//!
//! ```text
//! v G = (w F + v T)/(2(n+1)),      n = q + (3+α)/2
//! ```
//!
//! *Source*: eqs. 3.37 and 3.38 of the thesis, whose lateral function is 2G; `docs/theory.md`
//! derives the rest.

use super::ReducedFriction;
use super::extreme_range;
use super::profile::SmoothProfile;
use super::speeds::{DominantSpeed, Speeds};
use crate::real::Real;

/// A coupling with its lateral function G.
///
/// ```
/// use tribos_core::coupling::{LateralFriction, coulomb::CoulombDisk};
/// // Spinning in place under a pressure that leans: half the mean radius goes sideways.
/// assert!((CoulombDisk.lateral(0.0_f64, 1.0) - 0.5 * 2.0 / 3.0).abs() < 1e-14);
/// assert_eq!(CoulombDisk.lateral(1.0_f64, 0.0), 0.0); // sliding without spin: nothing
/// ```
pub trait LateralFriction<R: Real>: ReducedFriction<R> {
    /// G: the lateral force per coefficient, load and unit of pressure gradient l along the
    /// velocity (l = 1: the pressure vanishes at the trailing edge).
    ///
    /// *Units*: those of F. Zero without spin; signs of the arguments are ignored.
    fn lateral(&self, slide: R, rim: R) -> R;

    /// ∂(vG)/∂v and ∂(vG)/∂w: minus the change of F and T per unit of pressure gradient across
    /// the velocity, towards the side that spinning moves forward least.
    #[doc(hidden)]
    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R>;

    /// ⟨r²⟩ of the pressure without gradient, in radii squared.
    fn mean_square_radius(&self) -> R;
}

/// Loss of force and torque by a pressure gradient across the velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LateralJacobian<R> {
    /// ∂(vG)/∂v
    pub slide: R,
    /// ∂(vG)/∂w
    pub rim: R,
}

impl<R: Real, C: LateralFriction<R> + ?Sized> LateralFriction<R> for &C {
    #[inline]
    fn lateral(&self, slide: R, rim: R) -> R {
        (**self).lateral(slide, rim)
    }
    #[inline]
    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        (**self).lateral_jacobian(slide, rim)
    }
    #[inline]
    fn mean_square_radius(&self) -> R {
        (**self).mean_square_radius()
    }
}

/// (w F + v T)/(`divisor` v) of a profile.
#[inline]
pub(super) fn of_profile<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    divisor: R,
    slide: R,
    rim: R,
) -> R {
    let at = Speeds::new(slide, rim);
    if at.at_rest() {
        return R::ZERO;
    }
    let scale = profile.speed_scale(at.major);
    let [phi, chi] = profile.factors(&at);
    if at.may_be_scaled(scale, slide, rim) {
        scale * (at.rim * (phi + chi) / divisor)
    } else {
        let sum = (phi + chi) / divisor;
        extreme_range::lateral(profile.exponent(), sum, &at, [slide, rim])
    }
}

/// The gradient of (w F + v T)/`divisor`.
#[inline]
pub(super) fn jacobian_of_profile<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    divisor: R,
    slide: R,
    rim: R,
) -> LateralJacobian<R> {
    let at = Speeds::new(slide, rim);
    if at.at_rest() {
        return LateralJacobian::default();
    }
    let factors = profile.factors_and_slope(&at);
    let (alpha, scale) = (profile.exponent(), profile.speed_scale(at.major));
    let [slide, rim] = if at.may_be_scaled(scale, slide, rim) {
        unscaled_jacobian(alpha, &at, factors).map(|entry| scale * (entry / divisor))
    } else {
        extreme_range::lateral_jacobian(alpha, factors, divisor, &at, [slide, rim])
    };
    LateralJacobian { slide, rim }
}

/// The gradient of w F + v T over m^α.
#[inline]
fn unscaled_jacobian<R: Real>(alpha: R, at: &Speeds<R>, [phi, slope, chi]: [R; 3]) -> [R; 2] {
    let (x, z) = at.square_and_complement();
    let h = at.ratio();
    let bend = twice_z_slope(z, slope);
    // F_v w + T + T_v v and F + F_w w + T_w v.
    match at.lead() {
        DominantSpeed::Spinning => {
            let beta = R::ONE - alpha;
            [
                (R::ONE - x * beta) * phi + x * bend + chi,
                h * ((alpha + x * beta) * phi + alpha * chi - x * bend),
            ]
        }
        DominantSpeed::Sliding => [h * (alpha * phi + bend + chi), phi + alpha * chi - bend],
    }
}

/// 2zΦ': the slope's singularity at equal speeds is weaker than 1/z.
#[inline]
pub(super) fn twice_z_slope<R: Real>(z: R, slope: R) -> R {
    if z == R::ZERO {
        R::ZERO
    } else {
        R::TWO * z * slope
    }
}

/// G of the pressure of order q.
#[inline]
pub(super) fn of_order<R: Real, P: SmoothProfile<R>>(profile: &P, order: R, slide: R, rim: R) -> R {
    of_profile(profile, divisor(order, profile.exponent()), slide, rim)
}

/// The gradient of vG for the pressure of order q.
#[inline]
pub(super) fn jacobian_of_order<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    order: R,
    slide: R,
    rim: R,
) -> LateralJacobian<R> {
    jacobian_of_profile(profile, divisor(order, profile.exponent()), slide, rim)
}

/// 2(n+1) for pressure of order q under exponent α.
#[inline]
pub(super) fn divisor<R: Real>(order: R, alpha: R) -> R {
    R::TWO * (super::pressure_family::moment(order, alpha) + R::ONE)
}
