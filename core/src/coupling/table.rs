//! Powers of the speed on the uniform disk from polynomial tables: a few ulp, the same cost for every exponent.

use super::disk::Disk;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::Speeds;
use crate::law::{LawError, validated_exponent};
use crate::power::FixedPower;
use crate::real::Real;

/// Any pressure in f64: 52 octaves of z reach the smallest gap between two speeds; degree 12.
pub(super) const CELLS_F64: usize = 2 * 52 + 2;
pub(super) const TERMS_F64: usize = 13;
/// f32: 23 octaves; degree 5.
pub(super) const CELLS_F32: usize = 2 * 23 + 2;
pub(super) const TERMS_F32: usize = 6;
/// The uniform disk in f64: below 25 octaves an expansion serves, which neglects z³ < 2⁻⁷⁵ and, in
/// values for α ≥ 0, at most z²/70 < 2⁻⁵⁶ of them.
pub(super) const DISK_CELLS_F64: usize = 2 * 25 + 2;
/// f32: 16 octaves; for α ≥ 0 Jacobians need no expansion either, but for z/28 < 2⁻²⁰ of F/v.
pub(super) const DISK_CELLS_F32: usize = 2 * 16 + 2;

/// [`DiskTable64::MAX_EXPONENT`], and that of every other table.
pub(super) const MAX_EXPONENT: f64 = 10.0;

/// Both tables: a disk, and the power of its scale.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Table<R, const CELLS: usize, const TERMS: usize> {
    pub(super) disk: Disk<R, CELLS, TERMS>,
    pub(super) power: FixedPower<R>,
}

/// Friction v^α on a uniform disk, from a table of one exponent in f64 (14 KiB).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, table::DiskTable64};
/// use tribos_core::law::LawError;
/// // Torque of spinning in place under friction v^α: the mean of r^(1+α).
/// assert!((DiskTable64::new(0.5)?.reduced_wrench(0.0, 1.0).torque - 2.0 / 3.5).abs() < 1e-14);
/// let max = DiskTable64::MAX_EXPONENT;
/// assert_eq!(DiskTable64::new(10.5).err(), Some(LawError::Exponent { given: 10.5, max }));
/// # Ok::<(), LawError>(())
/// ```
pub type DiskTable64 = Table<f64, DISK_CELLS_F64, TERMS_F64>;
/// Friction v^α on a uniform disk, from a table of one exponent in f32 (3 KiB).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, table::DiskTable32};
/// // Torque of spinning in place under friction v^α: the mean of r^(1+α).
/// assert!((DiskTable32::new(0.5)?.reduced_wrench(0.0, 1.0).torque - 2.0 / 3.5).abs() < 1e-6);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub type DiskTable32 = Table<f32, DISK_CELLS_F32, TERMS_F32>;

impl<R, const CELLS: usize, const TERMS: usize> Table<R, CELLS, TERMS> {
    /// Largest exponent that a table resolves to its stated bound; it holds for all tables.
    pub const MAX_EXPONENT: f64 = MAX_EXPONENT;
}

impl DiskTable64 {
    /// Builds the table of exponent α; `const`, so that a `static` table can live in flash.
    ///
    /// *Domain*: −1 < α ≤ 10. *Accuracy* of force and torque: 1.5e-15 relative for
    /// α ≥ −0.75 (5 ulp at α = 0), 1.2e-14 below; Jacobian 2e-13 of F/v. *Cost*: about 300,000
    /// floating-point operations.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, table::DiskTable64};
    /// static VISCOUS: DiskTable64 = match DiskTable64::new(1.0) {
    ///     Ok(table) => table,
    ///     Err(_) => panic!("the exponent is in range"),
    /// };
    /// let wrench = VISCOUS.reduced_wrench(0.3, 0.4); // F = v, T = w/2
    /// assert!((wrench.force - 0.3).abs() < 1e-15 && (wrench.torque - 0.2).abs() < 1e-15);
    /// ```
    pub const fn new(alpha: f64) -> Result<Self, LawError> {
        match validated_exponent(alpha, MAX_EXPONENT) {
            Ok(alpha) => Ok(Self {
                disk: Disk::<f64, _, _>::build(alpha),
                power: FixedPower::<f64>::new(alpha),
            }),
            Err(error) => Err(error),
        }
    }
}

impl DiskTable32 {
    /// Builds the table of exponent α in f64 arithmetic and rounds it; `const`.
    ///
    /// *Domain*: −1 < α ≤ 10. *Accuracy* of force and torque: 5 ulp for
    /// −0.75 ≤ α ≤ 5, 8 ulp up to 10; Jacobian 6e-6 of F/v. *Cost*: about 240,000 operations in
    /// f64.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, table::DiskTable32};
    /// assert!(size_of::<DiskTable32>() < 3 * 1024); // bytes of flash
    /// let wrench = DiskTable32::new(1.0)?.reduced_wrench(0.3, 0.4); // F = v, T = w/2
    /// assert!((wrench.force - 0.3).abs() < 1e-6 && (wrench.torque - 0.2).abs() < 1e-6);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub const fn new(alpha: f32) -> Result<Self, LawError> {
        match validated_exponent(alpha as f64, MAX_EXPONENT) {
            Ok(_) => Ok(Self {
                disk: Disk::<f32, _, _>::build(alpha),
                power: FixedPower::<f32>::new(alpha),
            }),
            Err(error) => Err(error),
        }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> PowerLawFriction<R>
    for Table<R, CELLS, TERMS>
{
    #[inline]
    fn exponent(&self) -> R {
        self.disk.exponent()
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.disk.factors(at)
    }
    #[inline(always)]
    fn drag_and_torque(&self, at: &Speeds<R>) -> [R; 2] {
        self.disk.drag_and_torque(at)
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        self.disk.inertia_excess(at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        self.disk.inertia_ends()
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        self.power.of(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        self.power.rate(speed)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> SmoothProfile<R> for Table<R, CELLS, TERMS> {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.disk.factors_and_slope(at)
    }
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.disk.factors_and_rough_slope(at)
    }
}

pressure_family::coupled_in_lanes!([R: Real, const CELLS: usize, const TERMS: usize] Table<R, CELLS, TERMS>, |_table| R::ZERO);
