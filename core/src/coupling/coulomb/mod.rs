//! Coulomb friction of round patches: one form for all speeds, a few ulp, no table.
//!
//! | type | pressure |
//! |---|---|
//! | [`CoulombRing`] | all on the rim |
//! | [`CoulombPunch`] | 1/√(1−r²) |
//! | [`CoulombDisk`] | uniform |
//! | [`CoulombHertz`] | √(1−r²) |
//! | [`CoulombParaboloid`] | 1 − r² |
//!
//! With z = 1 − h² from 0 (equal speeds) to 1 (one motion alone) and q the order of the pressure, Φ and Χ = T/w have the
//! singular part z^(q+2), times ln z for whole q, and Φ' one power less. Polynomials P and Q in
//!
//! ```text
//! Φ, Χ = P(u) + z^(q+2) ln z Q(u),     Φ' = P(u) + z^(q+1) ln z Q(u),     u = z − 1/2          whole q
//! Φ, Χ, Φ' = P(u²) + u Q(u²),                                             u = √z − 1/2         half q
//! ```
//!
//! are fitted so that the sums count and not each part: few terms serve the whole range, and little cancels. Where a ring's
//! Φ' is needed its Φ and Φ' have u = z, so that what multiplies ln z ends exactly. The disk has one
//! Φ for both sides, and Θ = Χ where sliding leads; where spinning does, Χ = Θ + z (Φ/n − Θ). z comes from the squares of
//! the speeds where those are known.
//!
//! *Accuracy*: force 4 ulp (ring 9), torque 5 ulp (ring and paraboloid 7) in f64; 5 ulp in f32. Jacobian 3e-15 (f32: 6e-6)
//! of the larger of the entry and F/v, also next to equal speeds, where a ring's entries grow without bound. *Cost* for whole
//! q: a root, two divisions and about 115 other operations (f32: 75) from v² and w, as [`super::RoundFriction`] has them;
//! four divisions and no root from v and w. For half q: two roots and a division; three divisions and a root.

use super::DryReducedFriction;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::lanes::{Lanes, Numbers};
use crate::patch::PowerPressure;
use crate::real::Real;
use form::{Terms, numbers, order};

mod curve;
pub(super) mod form;
#[rustfmt::skip]
#[expect(clippy::approx_constant, reason = "they are fitted")]
pub(super) mod terms;

pub(crate) use form::Fitted;
use form::FittedRows;

macro_rules! fitted {
    ($form:ident, $pressure:ident, $torque:expr, $slope:expr) => {
        impl Fitted for $form {
            const PRESSURE: PowerPressure = PowerPressure::$pressure;
            const SLOPE: Terms<6, 12> = $slope;
            #[inline(always)]
            fn torque_sums<L: Numbers<Real: Real>>(slides: L::Mask, argument: L) -> [L; 4] {
                $torque.sums(slides, argument)
            }
        }

        impl $form {
            /// Terms of Φ and Χ, Θ where one function serves both sides, and of Φ and Φ'.
            #[doc(hidden)]
            pub const FITTED: [FittedRows; 2] = [$torque.rows(), $slope.rows()];
        }

        impl<R: Real> PowerLawFriction<R> for $form {
            #[inline]
            fn exponent(&self) -> R {
                R::ZERO
            }
            #[inline]
            fn factors(&self, at: &Speeds<R>) -> [R; 2] {
                let slides = at.lead() == DominantSpeed::Sliding;
                let z = R::Alone::repeat(at.complement());
                numbers(form::force_and_torque::<Self, R::Alone>(slides, z))
            }
            #[inline]
            fn drag(&self, slide_sq: R, rim: R) -> [R; 2] {
                let [slide_sq, rim] = [slide_sq, rim].map(R::Alone::repeat);
                numbers(form::drag::<Self, R::Alone>(slide_sq, rim))
            }
            fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
                pressure_family::inertia_excess(self, order::<Self, R>(), at, inertia_ratio)
            }
            fn inertia_ends(&self) -> [R; 2] {
                pressure_family::inertia_ends(R::ZERO, order::<Self, R>())
            }
        }

        impl<R: Real> SmoothProfile<R> for $form {
            #[inline]
            fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
                let slides = at.lead() == DominantSpeed::Sliding;
                let (x, z) = at.square_and_complement();
                let [x, z] = [x, z].map(R::Alone::repeat);
                numbers(form::factors_and_slope::<Self, R::Alone>(slides, [x, z]))
            }
        }

        impl<R: Real> DryReducedFriction<R> for $form {
            #[inline]
            fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
                curve::point_alone::<Self, R>(lead, ratio)
            }
            #[inline]
            fn reduced_points(
                &self,
                slides: <R::SideBySide as Lanes>::Mask,
                ratios: R::SideBySide,
            ) -> [R::SideBySide; 3] {
                curve::point::<Self, R::SideBySide>(slides, ratios)
            }
            #[inline]
            fn rough_point(&self, lead: DominantSpeed, ratio: R) -> Option<[R; 3]> {
                curve::rough_point_alone::<Self, R>(lead, ratio)
            }
            #[inline]
            fn rough_points(
                &self,
                slides: <R::SideBySide as Lanes>::Mask,
                ratios: R::SideBySide,
            ) -> Option<[R::SideBySide; 3]> {
                curve::rough_point::<Self, R::SideBySide>(slides, ratios)
            }
            #[inline]
            fn minor_powers(&self, lead: DominantSpeed) -> Option<[R; 6]> {
                Self::IS_ONE_SIDED.then(|| curve::minor_powers(lead))
            }
            #[inline]
            fn is_smooth(&self) -> bool {
                Self::PRESSURE.order() >= 0.0
            }
        }

        pressure_family::coupled_in_lanes!([R: Real] $form, |_form| order::<Self, R>());
    };
}

/// A thin ring, q = −1.
///
/// *Special values*: at equal speeds ∂F/∂v and its like are infinite.
///
/// ```
/// use core::f64::consts::FRAC_2_PI;
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombRing};
/// // Sliding and spinning may change places.
/// let [a, b] = [CoulombRing.reduced_wrench(0.3_f64, 0.4), CoulombRing.reduced_wrench(0.4, 0.3)];
/// assert!((a.force - b.torque).abs() < 1e-15);
/// assert!((CoulombRing.reduced_wrench(1.0, 1.0).force - FRAC_2_PI).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombRing;

/// A rigid flat punch, q = −1/2: F = (π/4) ε for ε ≤ 1, (ε asin(1/ε) + √(ε²−1)/ε)/2 beyond.
///
/// ```
/// use core::f64::consts::FRAC_PI_4;
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombPunch};
/// // As long as spinning leads, the force is proportional to the sliding speed.
/// let wrench = CoulombPunch.reduced_wrench(0.5_f64, 1.0);
/// assert!((wrench.force - 0.5 * FRAC_PI_4).abs() < 1e-15);
/// assert!((CoulombPunch.reduced_wrench(0.0_f64, 1.0).torque - FRAC_PI_4).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombPunch;

/// Uniform pressure, q = 0.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombDisk};
/// let w = CoulombDisk.reduced_wrench(1.0_f64, 1.0);
/// assert!((w.force - 8.0 / (3.0 * core::f64::consts::PI)).abs() < 1e-15);
/// ```
///
/// In code that is generic in the scalar:
///
/// ```
/// use tribos_core::Real;
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombDisk};
/// /// The arm of a disk's torque, 2/3 of its radius.
/// fn arm<R: Real>() -> R {
///     CoulombDisk.reduced_wrench(R::ZERO, R::ONE).torque
/// }
/// assert!((arm::<f64>() - 2.0 / 3.0).abs() < 1e-15);
/// assert!((arm::<f32>() - 2.0 / 3.0).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombDisk;

/// Hertz' pressure, q = 1/2: F = (3π/8) ε (1 − ε²/4) for ε ≤ 1, arc sines beyond.
///
/// *Source*: Johnson, Contact Mechanics, has the end values T(0) = 3π/16 and 1.
///
/// ```
/// use core::f64::consts::PI;
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombHertz};
/// let ball = CoulombHertz.reduced_wrench(0.5_f64, 1.0); // pressed on a plane
/// assert!((ball.force - 3.0 * PI / 8.0 * 0.5 * (1.0 - 0.25 / 4.0)).abs() < 1e-15);
/// // Spinning in place it resists with the mean radius of the pressure.
/// assert!((CoulombHertz.reduced_wrench(0.0_f64, 1.0).torque - 3.0 * PI / 16.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombHertz;

/// A paraboloid, q = 1.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombParaboloid};
/// // Spinning in place it resists with the mean radius of the pressure.
/// assert!((CoulombParaboloid.reduced_wrench(0.0_f64, 1.0).torque - 8.0 / 15.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombParaboloid;

fitted!(
    CoulombRing,
    RING,
    Terms {
        single: [&terms::RING_SPINNING_TORQUE_F32; 2],
        double: [&terms::RING_SPINNING_TORQUE_F64; 2],
    },
    Terms {
        single: [
            &terms::RING_SPINNING_SLOPE_F32,
            &terms::RING_SLIDING_SLOPE_F32
        ],
        double: [
            &terms::RING_SPINNING_SLOPE_F64,
            &terms::RING_SLIDING_SLOPE_F64
        ],
    }
);
fitted!(
    CoulombPunch,
    FLAT_PUNCH,
    Terms {
        single: [
            &terms::PUNCH_SPINNING_TORQUE_F32,
            &terms::PUNCH_SLIDING_TORQUE_F32
        ],
        double: [
            &terms::PUNCH_SPINNING_TORQUE_F64,
            &terms::PUNCH_SLIDING_TORQUE_F64
        ],
    },
    Terms {
        single: [
            &terms::PUNCH_SPINNING_SLOPE_F32,
            &terms::PUNCH_SLIDING_SLOPE_F32
        ],
        double: [
            &terms::PUNCH_SPINNING_SLOPE_F64,
            &terms::PUNCH_SLIDING_SLOPE_F64
        ],
    }
);
fitted!(
    CoulombDisk,
    UNIFORM,
    Terms {
        single: [&terms::DISK_TORQUE_F32; 2],
        double: [&terms::DISK_TORQUE_F64; 2],
    },
    Terms {
        single: [&terms::DISK_SLOPE_F32; 2],
        double: [&terms::DISK_SLOPE_F64; 2],
    }
);
fitted!(
    CoulombHertz,
    HERTZ,
    Terms {
        single: [
            &terms::HERTZ_SPINNING_TORQUE_F32,
            &terms::HERTZ_SLIDING_TORQUE_F32
        ],
        double: [
            &terms::HERTZ_SPINNING_TORQUE_F64,
            &terms::HERTZ_SLIDING_TORQUE_F64
        ],
    },
    Terms {
        single: [
            &terms::HERTZ_SPINNING_SLOPE_F32,
            &terms::HERTZ_SLIDING_SLOPE_F32
        ],
        double: [
            &terms::HERTZ_SPINNING_SLOPE_F64,
            &terms::HERTZ_SLIDING_SLOPE_F64
        ],
    }
);
fitted!(
    CoulombParaboloid,
    PARABOLOID,
    Terms {
        single: [
            &terms::PARABOLOID_SPINNING_TORQUE_F32,
            &terms::PARABOLOID_SLIDING_TORQUE_F32
        ],
        double: [
            &terms::PARABOLOID_SPINNING_TORQUE_F64,
            &terms::PARABOLOID_SLIDING_TORQUE_F64
        ],
    },
    Terms {
        single: [
            &terms::PARABOLOID_SPINNING_SLOPE_F32,
            &terms::PARABOLOID_SLIDING_SLOPE_F32
        ],
        double: [
            &terms::PARABOLOID_SPINNING_SLOPE_F64,
            &terms::PARABOLOID_SLIDING_SLOPE_F64
        ],
    }
);

#[cfg(test)]
mod tests;
