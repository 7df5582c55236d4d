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
//! With z = 1 − h² from 0 (equal speeds) to 1 (one motion alone) and q the order of the pressure, Φ has the
//! singular part z^(q+2), times ln z for whole q. Polynomials P, Q, R, S in
//!
//! ```text
//! Φ = P(z) + z^(q+2) ln z Q(z),      Φ' = R(z) + z^(q+1) ln z S(z)          whole q
//! Φ = P(u²) + u Q(u²),               Φ' = R(u²) + u S(u²),   u = √z − 1/2   half q
//! ```
//!
//! are fitted so that the sums count and not each part: few terms serve the whole range. Torque and Jacobian follow
//! from Φ and Φ', and nothing cancels anywhere. z comes from the squares of the speeds where those are known.
//!
//! *Accuracy*: force 4 ulp in f64 (ring 9), torque 12 ulp (paraboloid 20); 7 ulp in f32 (ring 8). Jacobian 3e-15
//! (f32: 6e-6) of the larger of the entry and F/v, also next to equal speeds, where a ring's entries grow without bound. *Cost*: a root, two
//! divisions and about 120 other operations (f32: 70), for all pressures and speeds.

use super::DryReducedFriction;
use super::pressure_family::{self, moment};
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::lanes::Lanes;
use crate::patch::PowerPressure;
use crate::real::{InEach, Real};
use crate::special::ln_part;
use core::marker::PhantomData;

mod curve;
#[rustfmt::skip]
#[expect(clippy::approx_constant, reason = "they are fitted")]
mod terms;

/// Rows of P, Q, R and S, and where they serve: spinning leads, sliding leads.
type Sides<R, const TERMS: usize> = [&'static [[R; 4]; TERMS]; 2];

/// A pressure with its fitted terms.
pub(crate) trait Fitted: Copy {
    const PRESSURE: PowerPressure;
    const SINGLE: Sides<f32, 6>;
    const DOUBLE: Sides<f64, 12>;

    /// One function serves both sides.
    const IS_ONE_SIDED: bool = Self::PRESSURE.order() == 0.0;
    /// Twice q + 1, the power of z in the singular part of Φ'.
    const TWICE_POWER: u32 = (2.0 * Self::PRESSURE.order() + 2.0) as u32;
    /// q is not whole: powers of √z stand in for the logarithm.
    const HAS_ROOTS: bool = Self::TWICE_POWER % 2 == 1;
}

/// P, Q, R and S at their argument, where sliding or spinning leads.
#[inline(always)]
pub(crate) fn sums<F: Fitted, R: Real>(slides: bool, argument: R) -> [R; 4] {
    struct Sums<F>(PhantomData<F>);
    impl<F: Fitted> InEach for Sums<F> {
        type Input<R: Real> = (bool, R);
        type Output<R: Real> = [R; 4];
        #[inline(always)]
        fn single((slides, argument): (bool, f32)) -> [f32; 4] {
            let [spinning, sliding] = F::SINGLE;
            crate::lanes::Laned::four_sums(if slides { sliding } else { spinning }, argument)
        }
        #[inline(always)]
        fn double((slides, argument): (bool, f64)) -> [f64; 4] {
            let [spinning, sliding] = F::DOUBLE;
            crate::lanes::Laned::four_sums(if slides { sliding } else { spinning }, argument)
        }
    }
    R::in_own::<Sums<F>>((slides, argument))
}

/// Φ and Φ' at z in [0, 1]; a ring's Φ' is infinite at z = 0. NaN for NaN.
#[inline(always)]
pub(crate) fn force_and_slope<F: Fitted, R: Real>(slides: bool, z: R) -> [R; 2] {
    if F::HAS_ROOTS {
        let u = z.sqrt() - R::HALF;
        let [p, q, r, s] = sums::<F, R>(slides, u * u);
        return [p + u * q, r + u * s];
    }
    let [p, q, r, s] = sums::<F, R>(slides, z);
    // Below the least normal number the products count as nothing.
    let least = R::MIN_POSITIVE;
    let log = ln_part(if z < least { least } else { z });
    match F::TWICE_POWER {
        0 if z == R::ZERO => [p, R::ZERO - s * R::INFINITY],
        0 => [p + z * log * q, r + log * s],
        2 => [p + z * (z * log) * q, r + z * log * s],
        _ => [p + z * z * (z * log) * q, r + z * (z * log) * s],
    }
}

/// F/v and T for v² and w.
#[inline(always)]
fn drag<F: Fitted, R: Real>(slide_sq: R, rim: R) -> [R; 2] {
    let rim_sq = rim * rim;
    // A comparison of its own for each selection: see `Speeds::of_ordinary`.
    let major = if slide_sq > rim_sq { slide_sq } else { rim_sq };
    let minor = if slide_sq < rim_sq { slide_sq } else { rim_sq };
    let per_major = R::ONE / major;
    let (x, z) = (minor * per_major, (major - minor) * per_major);
    let slides = slide_sq > rim_sq;
    let [phi, slope] = force_and_slope::<F, R>(slides, z);
    let inv_n = R::ONE / moment(R::from_f64(F::PRESSURE.order()), R::ZERO);
    let z_slope = if z == R::ZERO { R::ZERO } else { z * slope };
    let theta = inv_n * (R::HALF * phi + z_slope);
    let turns = if slide_sq > rim_sq {
        R::ZERO
    } else {
        inv_n * z
    };
    let part = if slide_sq > rim_sq { R::ONE } else { x };
    let per_speed = per_major.sqrt();
    [
        per_speed * phi,
        rim * (per_speed * (turns * phi + part * theta)),
    ]
}

macro_rules! fitted {
    ($form:ident, $pressure:ident, $single:expr, $double:expr) => {
        impl Fitted for $form {
            const PRESSURE: PowerPressure = PowerPressure::$pressure;
            const SINGLE: Sides<f32, 6> = $single;
            const DOUBLE: Sides<f64, 12> = $double;
        }

        impl<R: Real> PowerLawFriction<R> for $form {
            #[inline]
            fn exponent(&self) -> R {
                R::ZERO
            }
            #[inline]
            fn factors(&self, at: &Speeds<R>) -> [R; 2] {
                let [phi, _, chi] = self.factors_and_slope(at);
                [phi, chi]
            }
            #[inline]
            fn drag(&self, slide_sq: R, rim: R) -> [R; 2] {
                drag::<Self, R>(slide_sq, rim)
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
                let force = force_and_slope::<Self, R>(slides, at.complement());
                let chi = pressure_family::torque_factor(order::<Self, R>(), R::ZERO, at, force);
                [force[0], force[1], chi]
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
                curve::point::<Self, R, R::SideBySide>(slides, ratios)
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
                curve::rough_point::<Self, R, R::SideBySide>(slides, ratios)
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

#[inline]
fn order<F: Fitted, R: Real>() -> R {
    R::from_f64(F::PRESSURE.order())
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
    [&terms::RING_SPINNING_F32, &terms::RING_SLIDING_F32],
    [&terms::RING_SPINNING_F64, &terms::RING_SLIDING_F64]
);
fitted!(
    CoulombPunch,
    FLAT_PUNCH,
    [&terms::PUNCH_SPINNING_F32, &terms::PUNCH_SLIDING_F32],
    [&terms::PUNCH_SPINNING_F64, &terms::PUNCH_SLIDING_F64]
);
fitted!(
    CoulombDisk,
    UNIFORM,
    [&terms::DISK_F32; 2],
    [&terms::DISK_F64; 2]
);
fitted!(
    CoulombHertz,
    HERTZ,
    [&terms::HERTZ_SPINNING_F32, &terms::HERTZ_SLIDING_F32],
    [&terms::HERTZ_SPINNING_F64, &terms::HERTZ_SLIDING_F64]
);
fitted!(
    CoulombParaboloid,
    PARABOLOID,
    [
        &terms::PARABOLOID_SPINNING_F32,
        &terms::PARABOLOID_SLIDING_F32
    ],
    [
        &terms::PARABOLOID_SPINNING_F64,
        &terms::PARABOLOID_SLIDING_F64
    ]
);

#[cfg(test)]
mod tests;
