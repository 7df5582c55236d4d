//! Tables for pressures that are a polynomial of r²: the weighted sum of their members' tables.

use super::lateral::{self, LateralFriction, LateralJacobian};
use super::profile::{self, PowerLawFriction, SmoothProfile};
use super::regime_table::RegimeTables;
use super::speeds::Speeds;
use super::table::{CELLS_F64, MAX_EXPONENT, TERMS_F64};
use super::{ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::law::{LawError, validated_exponent};
use crate::patch::PolynomialPressure;

/// A table of Φ and Χ for a polynomial pressure and one exponent, in f64 (48 KiB).
///
/// *Accuracy*: as [`super::round::RoundTable64`], times Σ|wⱼ| of the pressure's shares.
#[derive(Clone, Copy, Debug)]
pub struct PolynomialTable {
    sides: RegimeTables<f64, CELLS_F64, TERMS_F64>,
}

impl PolynomialTable {
    /// *Domain*: −1 < α ≤ 10.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, round::PolynomialTable};
    /// use tribos_core::patch::PolynomialPressure;
    /// // All load towards the rim: p ~ r².
    /// let table = PolynomialTable::new(0.0, &PolynomialPressure::new([0.0, 1.0])?)?;
    /// assert!((table.reduced_wrench(0.0, 1.0).torque - 0.8).abs() < 1e-15);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn new<const N: usize>(
        alpha: f64,
        pressure: &PolynomialPressure<N>,
    ) -> Result<Self, LawError> {
        let alpha = validated_exponent(alpha, MAX_EXPONENT)?;
        Ok(Self {
            sides: RegimeTables::of_shares(alpha, *pressure.shares()),
        })
    }
}

impl PowerLawFriction<f64> for PolynomialTable {
    #[inline]
    fn exponent(&self) -> f64 {
        self.sides.alpha
    }
    #[inline]
    fn factors(&self, at: &Speeds<f64>) -> [f64; 2] {
        self.sides.factors(at)
    }
    #[inline]
    fn speed_scale(&self, speed: f64) -> f64 {
        self.sides.speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: f64) -> f64 {
        self.sides.rate_scale(speed)
    }
}

impl SmoothProfile<f64> for PolynomialTable {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<f64>) -> [f64; 3] {
        self.sides.factors_and_slope(at)
    }
}

impl ReducedFriction<f64> for PolynomialTable {
    #[inline]
    fn reduced_wrench(&self, slide: f64, rim: f64) -> ReducedWrench<f64> {
        profile::wrench(self, slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: f64, rim: f64) -> ReducedJacobian<f64> {
        profile::jacobian(self, slide, rim)
    }
}

/// A [`PolynomialTable`] with its lateral function (95 KiB together).
///
/// ```
/// use tribos_core::coupling::{LateralFriction, round::LateralPolynomialTable};
/// use tribos_core::patch::PolynomialPressure;
/// // All load towards the rim, p ~ r²: mean radius 4/5, mean square 2/3.
/// let hollow = PolynomialPressure::new([0.0, 1.0])?;
/// let table = LateralPolynomialTable::new(0.0, &hollow)?; // dry friction
/// assert!((table.mean_square_radius() - 2.0 / 3.0).abs() < 1e-14);
/// // Spinning in place under a pressure that leans: half the mean radius goes sideways.
/// assert!((table.lateral(0.0, 1.0) - 0.8 / 2.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LateralPolynomialTable {
    table: PolynomialTable,
    /// The same sum with every share over its own 2(n+1): (w F + v T)/v of it is G.
    lateral: RegimeTables<f64, CELLS_F64, TERMS_F64>,
    mean_square_radius: f64,
}

impl LateralPolynomialTable {
    /// *Domain*: −1 < α ≤ 10.
    pub fn new<const N: usize>(
        alpha: f64,
        pressure: &PolynomialPressure<N>,
    ) -> Result<Self, LawError> {
        let table = PolynomialTable::new(alpha, pressure)?;
        let shares = pressure.shares().iter().enumerate();
        let shares = shares.map(|(j, share)| share / lateral::divisor(j as f64, alpha));
        Ok(Self {
            table,
            lateral: RegimeTables::of_shares(alpha, shares),
            mean_square_radius: pressure.mean_square_radius(),
        })
    }
}

impl PowerLawFriction<f64> for LateralPolynomialTable {
    #[inline]
    fn exponent(&self) -> f64 {
        self.table.exponent()
    }
    #[inline]
    fn factors(&self, at: &Speeds<f64>) -> [f64; 2] {
        self.table.factors(at)
    }
    #[inline]
    fn speed_scale(&self, speed: f64) -> f64 {
        self.table.speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: f64) -> f64 {
        self.table.rate_scale(speed)
    }
}

impl SmoothProfile<f64> for LateralPolynomialTable {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<f64>) -> [f64; 3] {
        self.table.factors_and_slope(at)
    }
}

impl ReducedFriction<f64> for LateralPolynomialTable {
    #[inline]
    fn reduced_wrench(&self, slide: f64, rim: f64) -> ReducedWrench<f64> {
        self.table.reduced_wrench(slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: f64, rim: f64) -> ReducedJacobian<f64> {
        self.table.reduced_jacobian(slide, rim)
    }
}

impl LateralFriction<f64> for LateralPolynomialTable {
    fn lateral(&self, slide: f64, rim: f64) -> f64 {
        lateral::of_profile(&self.lateral, 1.0, slide, rim)
    }
    fn lateral_jacobian(&self, slide: f64, rim: f64) -> LateralJacobian<f64> {
        lateral::jacobian_of_profile(&self.lateral, 1.0, slide, rim)
    }
    fn mean_square_radius(&self) -> f64 {
        self.mean_square_radius
    }
}
