//! Tables for round patches under the pressures (1−r²)^q: a few ulp, the same cost for all.
//!
//! The uniform disk has one table for both regimes ([`super::table`]); every other pressure needs
//! one for spinning and one for sliding, each of Φ and Χ.

use super::family_member::FamilyMember;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::regime_table::RegimeTables;
use super::speeds::Speeds;
use super::table::MAX_EXPONENT;
use super::table::{CELLS_F32, CELLS_F64, TERMS_F32, TERMS_F64};
use crate::law::{LawError, validated_exponent};
use crate::patch::PowerPressure;
use crate::real::Real;

/// Both tables, of Φ and Χ.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct RoundTable<R, const CELLS: usize, const TERMS: usize> {
    order: R,
    pub(super) sides: RegimeTables<R, CELLS, TERMS>,
}

/// Exponents this close to 1 leave C_α too flat for a plain difference.
const NEARLY_LINEAR: f64 = 0.125;

/// Friction v^α under a pressure (1−r²)^q, from a table in f64 (48 KiB).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, round::RoundTable64};
/// use tribos_core::patch::PowerPressure;
/// // Torque of spinning in place under dry friction: the mean radius, 8/15 for a paraboloid.
/// let pad = RoundTable64::new(0.0, PowerPressure::PARABOLOID)?;
/// assert!((pad.reduced_wrench(0.0, 1.0).torque - 8.0 / 15.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub type RoundTable64 = RoundTable<f64, CELLS_F64, TERMS_F64>;
/// Friction v^α under a pressure (1−r²)^q, from a table in f32 (7 KiB).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, round::RoundTable32};
/// use tribos_core::patch::PowerPressure;
/// // Torque of spinning in place under dry friction: the mean radius, 8/15 for a paraboloid.
/// let pad = RoundTable32::new(0.0, PowerPressure::PARABOLOID)?;
/// assert!((pad.reduced_wrench(0.0, 1.0).torque - 8.0 / 15.0).abs() < 1e-6);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub type RoundTable32 = RoundTable<f32, CELLS_F32, TERMS_F32>;

impl RoundTable64 {
    /// Builds the table; `const`, so that a `static` table can live in flash.
    ///
    /// *Domain*: −1 < α ≤ 10. *Accuracy* for orders up to 6: force, torque and lateral
    /// function 4e-15 relative for −0.5 ≤ α ≤ 3, 3e-14 for −0.9 ≤ α ≤ 10; Jacobian, in units of the
    /// larger of the entry and F/v (next to equal speeds a ring's entries grow without bound), 2e-13
    /// for q ≥ 0, 8e-12 below for α ≥ −0.5, 1.2e-10 for α ≥ −0.99. *Cost*: about 600,000 floating-point
    /// operations.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, round::RoundTable64};
    /// use tribos_core::patch::PowerPressure;
    /// static HERTZ: RoundTable64 = match RoundTable64::new(0.0, PowerPressure::HERTZ) {
    ///     Ok(table) => table,
    ///     Err(_) => panic!("the exponent is in range"),
    /// };
    /// let force = HERTZ.reduced_wrench(1.0, 1.0).force;
    /// assert!((force - 9.0 * core::f64::consts::PI / 32.0).abs() < 1e-15);
    /// ```
    pub const fn new(alpha: f64, pressure: PowerPressure) -> Result<Self, LawError> {
        let order = pressure.order();
        match validated_exponent(alpha, MAX_EXPONENT) {
            Ok(alpha) => Ok(Self {
                order,
                sides: RegimeTables::of_member(&FamilyMember { alpha, order }),
            }),
            Err(error) => Err(error),
        }
    }
}

impl RoundTable32 {
    /// Builds the table in f64 arithmetic and rounds it; `const`.
    ///
    /// *Domain*: −1 < α ≤ 10. *Accuracy* of force and torque for −0.75 ≤ α and orders
    /// up to 2: 10 ulp for α ≤ 3, 25 ulp for α ≤ 5; 220 ulp for orders up to 6 and α ≤ 10.
    ///
    /// ```
    /// use tribos_core::coupling::round::RoundTable32;
    /// use tribos_core::law::LawError;
    /// use tribos_core::patch::PowerPressure;
    /// assert!(size_of::<RoundTable32>() < 7 * 1024); // bytes of flash
    /// let refused = RoundTable32::new(-1.0, PowerPressure::HERTZ);
    /// assert!(matches!(refused, Err(LawError::Exponent { given: -1.0, .. })));
    /// ```
    pub const fn new(alpha: f32, pressure: PowerPressure) -> Result<Self, LawError> {
        let order = pressure.order();
        match validated_exponent(alpha as f64, MAX_EXPONENT) {
            Ok(wide) => Ok(Self {
                order: order as f32,
                sides: RegimeTables::rounded(
                    alpha,
                    &RegimeTables::of_member(&FamilyMember { alpha: wide, order }),
                ),
            }),
            Err(error) => Err(error),
        }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> PowerLawFriction<R>
    for RoundTable<R, CELLS, TERMS>
{
    #[inline]
    fn exponent(&self) -> R {
        self.sides.exponent()
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.sides.factors(at)
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        self.sides.speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        self.sides.rate_scale(speed)
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        // The slope of a table is less accurate than its values: needed near α = 1 only.
        if (self.exponent() - R::ONE).abs() < R::from_f64(NEARLY_LINEAR) {
            return pressure_family::inertia_excess(&self.sides, self.order, at, inertia_ratio);
        }
        let [phi, chi] = self.factors(at);
        chi / phi - inertia_ratio
    }
    fn inertia_ends(&self) -> [R; 2] {
        pressure_family::inertia_ends(self.exponent(), self.order)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> SmoothProfile<R>
    for RoundTable<R, CELLS, TERMS>
{
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.sides.factors_and_slope(at)
    }
}

pub use super::polynomial::{LateralPolynomialTable, PolynomialTable};

pressure_family::coupled_in_lanes!([R: Real, const CELLS: usize, const TERMS: usize] RoundTable<R, CELLS, TERMS>, |table| table.order);
