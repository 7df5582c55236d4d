//! Coulomb friction in closed form: pressures whose functions are elementary or elliptic.
//!
//! | type | pressure | v ≤ w | v > w |
//! |---|---|---|---|
//! | [`CoulombRing`] | all on the rim | B | B + (1−m) D |
//! | [`CoulombPunch`] | 1/√(1−r²) | constant | arc sine |
//! | [`CoulombHertz`] | √(1−r²) | polynomial | arc sine |
//!
//! The uniform disk's is [`super::compact::CompactCoulombDisk`]. No table, no power; *Accuracy*: 1e-14
//! relative in f64, 1e-5 in f32; Jacobian 1e-14 of the larger of the entry and F/v, also next to
//! equal speeds, where a ring's entries grow without bound. *Source*: `docs/theory.md`; Hertz: Johnson, Contact Mechanics,
//! has the end values T(0) = 3π/16 and 1.

use super::DryReducedFriction;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::patch::PowerPressure;
use crate::real::Real;
use crate::special::CompleteElliptic;
use core::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};

/// A thin ring, q = −1: Φ = (2/π) B where spinning leads, (2/π)(B + (1−m) D) where sliding leads,
/// with the complete elliptic integrals of parameter m = h².
///
/// *Special values*: at equal speeds ∂F/∂v and its like are infinite.
///
/// ```
/// use core::f64::consts::FRAC_2_PI;
/// use tribos_core::coupling::{ReducedFriction, closed::CoulombRing};
/// // Sliding and spinning may change places.
/// let [a, b] = [CoulombRing.reduced_wrench(0.3_f64, 0.4), CoulombRing.reduced_wrench(0.4, 0.3)];
/// assert!((a.force - b.torque).abs() < 1e-14);
/// assert!((CoulombRing.reduced_wrench(1.0, 1.0).force - FRAC_2_PI).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombRing;

/// A rigid flat punch, q = −1/2: F = (π/4) ε for ε ≤ 1, (ε asin(1/ε) + √(ε²−1)/ε)/2 beyond.
///
/// ```
/// use core::f64::consts::FRAC_PI_4;
/// use tribos_core::coupling::{ReducedFriction, closed::CoulombPunch};
/// // As long as spinning leads, the force is proportional to the sliding speed.
/// let wrench = CoulombPunch.reduced_wrench(0.5_f64, 1.0);
/// assert!((wrench.force - 0.5 * FRAC_PI_4).abs() < 1e-14);
/// assert!((CoulombPunch.reduced_wrench(0.0_f64, 1.0).torque - FRAC_PI_4).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombPunch;

/// Hertz' pressure, q = 1/2: F = (3π/8) ε (1 − ε²/4) for ε ≤ 1, arc sines beyond.
///
/// ```
/// use core::f64::consts::PI;
/// use tribos_core::coupling::{ReducedFriction, closed::CoulombHertz};
/// let ball = CoulombHertz.reduced_wrench(0.5_f64, 1.0); // pressed on a plane
/// assert!((ball.force - 3.0 * PI / 8.0 * 0.5 * (1.0 - 0.25 / 4.0)).abs() < 1e-14);
/// // Spinning in place it resists with the mean radius of the pressure.
/// assert!((CoulombHertz.reduced_wrench(0.0_f64, 1.0).torque - 3.0 * PI / 16.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoulombHertz;

/// Φ and Φ' of one pressure at α = 0.
trait ClosedForm {
    const PRESSURE: PowerPressure;
    fn force<R: Real>(at: &Speeds<R>) -> [R; 2];
}

impl ClosedForm for CoulombRing {
    const PRESSURE: PowerPressure = PowerPressure::RING;

    fn force<R: Real>(at: &Speeds<R>) -> [R; 2] {
        let (two_by_pi, inv_pi) = (R::from_f64(FRAC_2_PI), R::from_f64(FRAC_1_PI));
        let z = at.complement();
        let CompleteElliptic { b, d, c, .. } = CompleteElliptic::new(z);
        match at.lead() {
            DominantSpeed::Spinning => [two_by_pi * b, inv_pi * c],
            DominantSpeed::Sliding => [two_by_pi * (b + z * d), -inv_pi * d],
        }
    }
}

/// Below this square of the ratio the arc sines cancel, and the series in it serve.
const SERIES_BELOW: f64 = 0.25;
/// Terms of those series: 4⁻²⁶ < 2⁻⁵².
const SERIES_TERMS: usize = 26;

impl ClosedForm for CoulombPunch {
    const PRESSURE: PowerPressure = PowerPressure::FLAT_PUNCH;

    fn force<R: Real>(at: &Speeds<R>) -> [R; 2] {
        if at.lead() == DominantSpeed::Spinning {
            return [R::from_f64(FRAC_PI_4) + R::ZERO * at.ratio(), R::ZERO];
        }
        let (y, z) = at.square_and_complement();
        if y < R::from_f64(SERIES_BELOW) {
            return series(Self::PRESSURE.order() + 2.0, y);
        }
        let [root, p] = root_and_arc(at.ratio(), z);
        let four = R::TWO + R::TWO;
        [R::HALF * (p + root), (root - p) / (four * y)]
    }
}

impl ClosedForm for CoulombHertz {
    const PRESSURE: PowerPressure = PowerPressure::HERTZ;

    fn force<R: Real>(at: &Speeds<R>) -> [R; 2] {
        let (y, z) = at.square_and_complement();
        let quarter = R::HALF * R::HALF;
        if at.lead() == DominantSpeed::Spinning {
            let front = R::from_f64(3.0 * PI / 8.0);
            return [front * (R::ONE - quarter * y), -quarter * front];
        }
        if y < R::from_f64(SERIES_BELOW) {
            return series(Self::PRESSURE.order() + 2.0, y);
        }
        let [root, p] = root_and_arc(at.ratio(), z);
        let (three, four) = (R::ONE + R::TWO, R::TWO + R::TWO);
        // Φ = (3/16y) [ p (4y − 1) + √z (2y + 1) ], and its derivative with 1/√z divided out.
        let sixteenth = R::from_f64(3.0 / 16.0) / y;
        let value = sixteenth * (p * (four * y - R::ONE) + root * (R::TWO * y + R::ONE));
        let slope =
            R::HALF * sixteenth / y * (p * (three - four * y) - root * (three - R::TWO * y));
        [value, slope]
    }
}

/// √z and asin(h)/h for h ≥ 1/2: near equal speeds z knows the angle to its last digit, h does not.
#[inline]
fn root_and_arc<R: Real>(h: R, z: R) -> [R; 2] {
    let root = z.sqrt();
    [root, (R::from_f64(FRAC_PI_2) - root.asin()) / h]
}

/// ₂F₁(1/2, −1/2; `c`; y) and its slope for y < 1/4.
fn series<R: Real>(c: f64, y: R) -> [R; 2] {
    let (mut value, mut slope) = (R::ONE, R::ZERO);
    let mut power = R::ONE;
    let mut coefficient = 1.0;
    for n in 0..SERIES_TERMS {
        let k = n as f64;
        coefficient *= (k + 0.5) * (k - 0.5) / ((c + k) * (k + 1.0));
        slope += R::from_f64(coefficient * (k + 1.0)) * power;
        power *= y;
        value += R::from_f64(coefficient) * power;
    }
    [value, slope]
}

macro_rules! dry_profiles {
    ($($form:ty),*) => {$(
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
            fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
                pressure_family::inertia_excess(self, order::<Self, R>(), at, inertia_ratio)
            }
            fn inertia_ends(&self) -> [R; 2] {
                pressure_family::inertia_ends(self.exponent(), order::<Self, R>())
            }
        }

        impl<R: Real> SmoothProfile<R> for $form {
            #[inline]
            fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
                let force = Self::force(at);
                let chi = pressure_family::torque_factor(order::<Self, R>(), R::ZERO, at, force);
                [force[0], force[1], chi]
            }
        }

        impl<R: Real> DryReducedFriction<R> for $form {
            #[inline]
            fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
                super::profile::point(self, lead, ratio)
            }
        }

        pressure_family::coupled!([R: Real] $form, |_form| order::<Self, R>());
    )*};
}

dry_profiles!(CoulombRing, CoulombPunch, CoulombHertz);

#[inline]
fn order<F: ClosedForm, R: Real>() -> R {
    R::from_f64(F::PRESSURE.order())
}
