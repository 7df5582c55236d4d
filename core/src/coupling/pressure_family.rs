//! The pressures (1−r²)^q: Χ from Φ and Φ', and the final motion's balance.

use super::profile::SmoothProfile;
use super::speeds::{DominantSpeed, Speeds};
use crate::real::Real;

/// n = q + (3+α)/2 = F'(0)/T(0).
#[inline]
pub(super) fn moment<R: Real>(order: R, alpha: R) -> R {
    order + R::HALF * (R::ONE + R::TWO + alpha)
}

/// Θ from Φ and zΦ', for pressure of order q under exponent α.
#[inline]
pub(super) fn theta<R: Real>(order: R, alpha: R, [phi, z_slope]: [R; 2]) -> R {
    let inv_n = R::ONE / moment(order, alpha);
    inv_n * (R::HALF * (R::ONE + alpha) * phi + z_slope)
}

/// Χ from Φ and Φ', for pressure of order q under exponent α.
#[inline]
pub(super) fn torque_factor<R: Real>(
    order: R,
    alpha: R,
    at: &Speeds<R>,
    [phi, slope]: [R; 2],
) -> R {
    let (x, z) = at.square_and_complement();
    // The slope's singularity is weaker than 1/z.
    let z_slope = if z == R::ZERO { R::ZERO } else { z * slope };
    let theta = theta(order, alpha, [phi, z_slope]);
    match at.lead() {
        DominantSpeed::Sliding => theta,
        DominantSpeed::Spinning => R::ONE / moment(order, alpha) * z * phi + x * theta,
    }
}

/// C_α(0) = 1/n and C_α(∞) = (1+α)/(2(q+2)) for the pressure (1−r²)^q.
pub(crate) fn inertia_ends<R: Real>(alpha: R, order: R) -> [R; 2] {
    // Sums of small integers and halves: exact for the α and q that people name.
    let twice = R::TWO * order;
    let spinning = R::TWO / (twice + (R::ONE + R::TWO + alpha));
    let sliding = (R::ONE + alpha) / (twice + (R::TWO + R::TWO));
    [spinning, sliding]
}

/// C_α − C, every term with its own relative accuracy when α → 1 and C_α becomes constant:
///
/// ```text
/// n (C_α − C) = (1 − (q+2) C) − (1−α)/2 (1 − C) + zΦ'/Φ       sliding leads
/// n (C_α − C) = (1 − (q+2) C) − (1−α)/2 (x − C) + xzΦ'/Φ      spinning leads
/// ```
pub(super) fn inertia_excess<R: Real, P: SmoothProfile<R>>(
    profile: &P,
    order: R,
    at: &Speeds<R>,
    inertia_ratio: R,
) -> R {
    let [phi, slope, _] = profile.factors_and_slope(at);
    let (x, z) = at.square_and_complement();
    let constant = R::ONE - (order + R::TWO) * inertia_ratio;
    let beta = R::HALF * (R::ONE - profile.exponent());
    let bend = if z == R::ZERO {
        R::ZERO
    } else {
        z * slope / phi
    };
    let scaled = match at.lead() {
        DominantSpeed::Sliding => constant - beta * (R::ONE - inertia_ratio) + bend,
        DominantSpeed::Spinning => constant - beta * (x - inertia_ratio) + x * bend,
    };
    scaled / moment(order, profile.exponent())
}

/// [`super::ReducedFriction`] and [`super::LateralFriction`] of a smooth profile, from its order q.
macro_rules! coupled {
    ([$($generics:tt)*] $profile:ty, |$this:ident| $order:expr) => {
        impl<$($generics)*> $crate::coupling::ReducedFriction<R> for $profile {
            $crate::coupling::pressure_family::coupling_methods!();
        }

        $crate::coupling::pressure_family::lateral!([$($generics)*] $profile, |$this| $order);
    };
}

/// The same, of a profile that computes groups in lanes.
macro_rules! coupled_in_lanes {
    ([$($generics:tt)*] $profile:ty, |$this:ident| $order:expr) => {
        impl<$($generics)*> $crate::coupling::ReducedFriction<R> for $profile {
            $crate::coupling::pressure_family::coupling_methods!();

            #[inline]
            fn reduced_drags(&self, slide_squares: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
                $crate::coupling::batch::drags(self, slide_squares, rims)
            }
            #[inline]
            fn reduced_wrenches(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
                $crate::coupling::batch::wrenches(self, slides, rims)
            }
            #[inline]
            fn reduced_jacobians(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 4]> {
                $crate::coupling::batch::jacobians(self, slides, rims)
            }
        }

        $crate::coupling::pressure_family::lateral!([$($generics)*] $profile, |$this| $order);
    };
}

/// The methods of [`super::ReducedFriction`].
macro_rules! coupling_methods {
    () => {
        #[inline]
        fn reduced_wrench(&self, slide: R, rim: R) -> $crate::coupling::ReducedWrench<R> {
            $crate::coupling::profile::wrench(self, slide, rim)
        }
        #[inline]
        fn reduced_jacobian(&self, slide: R, rim: R) -> $crate::coupling::ReducedJacobian<R> {
            $crate::coupling::profile::jacobian(self, slide, rim)
        }
        #[inline]
        fn reduced_drag(&self, slide_sq: R, rim: R) -> [R; 2] {
            $crate::coupling::PowerLawFriction::drag(self, slide_sq, rim)
        }
    };
}

macro_rules! lateral {
    ([$($generics:tt)*] $profile:ty, |$this:ident| $order:expr) => {
        impl<$($generics)*> $crate::coupling::LateralFriction<R> for $profile {
            #[inline]
            fn lateral(&self, slide: R, rim: R) -> R {
                let $this = self;
                $crate::coupling::lateral::of_order(self, $order, slide, rim)
            }
            #[inline]
            fn lateral_jacobian(&self, slide: R, rim: R) -> $crate::coupling::LateralJacobian<R> {
                let $this = self;
                $crate::coupling::lateral::jacobian_of_order(self, $order, slide, rim)
            }
            fn mean_square_radius(&self) -> R {
                let $this = self;
                R::ONE / ($order + R::TWO)
            }
        }
    };
}
pub(super) use {coupled, coupled_in_lanes, coupling_methods, lateral};
