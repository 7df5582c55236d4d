//! The quickest tier: polynomial tables, a few ulp, the same cost for every exponent.

use super::DryReducedFriction;
use super::coulomb;
use super::disk::Disk;
use super::equal_speeds::{DryExponent, Exponent, GeneralExponent};
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::lanes::Lanes;
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
/// One degree less is enough for α = 0 in f32, whose singularity is weaker than that of α < 0.
const TERMS_COULOMB_F32: usize = 5;

/// [`DiskTable64::MAX_EXPONENT`], and that of every other table.
pub(super) const MAX_EXPONENT: f64 = 10.0;

/// Both tables: a disk, and the power of its scale.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Table<R, const CELLS: usize, const TERMS: usize> {
    pub(super) disk: Disk<R, GeneralExponent<R>, CELLS, TERMS>,
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
                disk: Disk::<f64, _, _, _>::build(alpha, GeneralExponent(alpha)),
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
                disk: Disk::<f32, _, _, _>::build(alpha as f64, GeneralExponent(alpha)),
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
        self.disk.exponent.value()
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

/// Tables of α = 0, which need no power.
pub(crate) type CoulombTable64 = Disk<f64, DryExponent, DISK_CELLS_F64, TERMS_F64>;
pub(crate) type CoulombTable32 = Disk<f32, DryExponent, DISK_CELLS_F32, TERMS_COULOMB_F32>;

/// Aligned for vectors, which then take a cell's numbers as operands: its size is a multiple of 16.
#[derive(Debug)]
#[repr(C, align(16))]
pub(crate) struct Aligned<T>(pub T);

/// The tables of α = 0, in read-only memory.
pub(crate) static COULOMB_F64: Aligned<CoulombTable64> =
    Aligned(CoulombTable64::build(0.0, DryExponent));
pub(crate) static COULOMB_F32: Aligned<CoulombTable32> =
    Aligned(CoulombTable32::build(0.0, DryExponent));

/// Looks up the table of α = 0 in the precision of the caller.
macro_rules! in_own_table {
    ($real:ident, $given:ty => $gives:ty, |$table:ident, $at:pat_param| $found:expr, $value:expr) => {{
        struct Lookup;
        impl crate::real::InEach for Lookup {
            type Input<$real: Real> = $given;
            type Output<$real: Real> = $gives;
            #[inline(always)]
            fn single($at: Self::Input<f32>) -> Self::Output<f32> {
                let $table = &$crate::coupling::table::COULOMB_F32.0;
                $found
            }
            #[inline(always)]
            fn double($at: Self::Input<f64>) -> Self::Output<f64> {
                let $table = &$crate::coupling::table::COULOMB_F64.0;
                $found
            }
        }
        $real::in_own::<Lookup>($value)
    }};
}
#[allow(unused_imports, reason = "for targets with vectors")]
pub(super) use in_own_table;

/// Sizes of the tables of α = 0, f32 and f64.
#[doc(hidden)]
pub const COULOMB_TABLE_BYTES: [usize; 2] =
    [size_of::<CoulombTable32>(), size_of::<CoulombTable64>()];

/// Coulomb friction, α = 0, from a table built by the compiler: no constructor, no RAM, no power.
///
/// *Accuracy*: f64 and f32 at most 5 ulp in force and torque.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, table::CoulombDisk};
/// let w = CoulombDisk.reduced_wrench(1.0_f64, 1.0);
/// assert!((w.force - 8.0 / (3.0 * core::f64::consts::PI)).abs() < 1e-15);
/// ```
///
/// In code that is generic in the scalar:
///
/// ```
/// use tribos_core::Real;
/// use tribos_core::coupling::{ReducedFriction, table::CoulombDisk};
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

impl<R: Real> PowerLawFriction<R> for CoulombDisk {
    #[inline]
    fn exponent(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        in_own_table!(R, Speeds<R> => [R; 2], |table, at| table.factors(&at), *at)
    }
    #[inline(always)]
    fn drag_and_torque(&self, at: &Speeds<R>) -> [R; 2] {
        in_own_table!(R, Speeds<R> => [R; 2], |table, at| table.drag_and_torque(&at), *at)
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        in_own_table!(R, (Speeds<R>, R) => R, |table, (at, ratio)| table.inertia_excess(&at, ratio), (*at, inertia_ratio))
    }
    fn inertia_ends(&self) -> [R; 2] {
        in_own_table!(R, () => [R; 2], |table, ()| table.inertia_ends(), ())
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        in_own_table!(R, R => R, |table, speed| table.speed_scale(speed), speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        in_own_table!(R, R => R, |table, speed| table.rate_scale(speed), speed)
    }
}

impl<R: Real> SmoothProfile<R> for CoulombDisk {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        in_own_table!(R, Speeds<R> => [R; 3], |table, at| table.factors_and_slope(&at), *at)
    }
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        in_own_table!(R, Speeds<R> => [R; 3], |table, at| table.factors_and_rough_slope(&at), *at)
    }
}

impl<R: Real> DryReducedFriction<R> for CoulombDisk {
    #[inline]
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        coulomb::CoulombDisk.reduced_point(lead, ratio)
    }
    #[inline]
    fn reduced_points(
        &self,
        slides: <R::Beside as Lanes>::Mask,
        ratios: R::Beside,
    ) -> [R::Beside; 3] {
        DryReducedFriction::<R>::reduced_points(&coulomb::CoulombDisk, slides, ratios)
    }
    #[inline]
    fn rough_point(&self, lead: DominantSpeed, ratio: R) -> Option<[R; 3]> {
        coulomb::CoulombDisk.rough_point(lead, ratio)
    }
    #[inline]
    fn rough_points(
        &self,
        slides: <R::Beside as Lanes>::Mask,
        ratios: R::Beside,
    ) -> Option<[R::Beside; 3]> {
        DryReducedFriction::<R>::rough_points(&coulomb::CoulombDisk, slides, ratios)
    }
    #[inline]
    fn minor_powers(&self, lead: DominantSpeed) -> Option<[R; 6]> {
        coulomb::CoulombDisk.minor_powers(lead)
    }
    #[inline]
    fn is_smooth(&self) -> bool {
        true
    }
}

pressure_family::coupled_in_lanes!([R: Real, const CELLS: usize, const TERMS: usize] Table<R, CELLS, TERMS>, |_table| R::ZERO);

pressure_family::coupled_in_lanes!([R: Real] CoulombDisk, |_table| R::ZERO);
