//! The quickest tier: polynomial tables, a few ulp, the same cost for every exponent.

use super::octave::{self, Cell};
use super::profile::{self, Profile};
use super::{Coupling, DryCoupling, ReducedJacobian, ReducedWrench};
use crate::law::{LawError, validated_exponent};
use crate::real::Real;

/// f64: 52 octaves of z reach the smallest gap between two speeds; degree 12.
const CELLS_F64: usize = 2 * 52 + 2;
const TERMS_F64: usize = 13;
/// f32: 23 octaves; degree 5.
const CELLS_F32: usize = 2 * 23 + 2;
const TERMS_F32: usize = 6;
/// One degree less is enough for α = 0 in f32, whose singularity is weaker than that of α < 0.
const TERMS_COULOMB_F32: usize = 5;

/// Largest exponent that a table resolves to its stated bound.
pub const MAX_EXPONENT: f64 = 10.0;

/// A table of Φ and Θ.
#[derive(Clone, Copy, Debug)]
pub struct Table<R, const CELLS: usize, const TERMS: usize> {
    alpha: R,
    cells: [Cell<R, TERMS>; CELLS],
}

/// Table of one exponent in f64 (23 KiB).
pub type Table64 = Table<f64, CELLS_F64, TERMS_F64>;
/// Table of one exponent in f32 (3 KiB).
pub type Table32 = Table<f32, CELLS_F32, TERMS_F32>;

impl Table64 {
    /// Builds the table of exponent α; `const`, so that a `static` table can live in flash.
    ///
    /// *Domain*: −1 < α ≤ [`MAX_EXPONENT`]. *Accuracy* of force and torque: 1.5e-15 relative for
    /// α ≥ −0.75 (5 ulp at α = 0), 1.2e-14 below; Jacobian 2e-13 of F/v. *Cost*: about 300,000
    /// floating-point operations.
    pub const fn new(alpha: f64) -> Result<Self, LawError> {
        match validated_exponent(alpha, MAX_EXPONENT) {
            Ok(alpha) => Ok(Self::build(alpha)),
            Err(error) => Err(error),
        }
    }

    const fn build(alpha: f64) -> Self {
        Self {
            alpha,
            cells: octave::cells(alpha),
        }
    }
}

impl Table32 {
    /// Builds the table of exponent α in f64 arithmetic and rounds it; `const`.
    ///
    /// *Domain*: −1 < α ≤ [`MAX_EXPONENT`]. *Accuracy* of force and torque: 5 ulp for
    /// −0.75 ≤ α ≤ 5, 8 ulp up to 10; Jacobian 6e-6 of F/v. *Cost*: about 150,000 operations in
    /// f64.
    pub const fn new(alpha: f32) -> Result<Self, LawError> {
        match validated_exponent(alpha as f64, MAX_EXPONENT) {
            Ok(_) => Ok(Self::build(alpha)),
            Err(error) => Err(error),
        }
    }
}

impl<const TERMS: usize> Table<f32, CELLS_F32, TERMS> {
    const fn build(alpha: f32) -> Self {
        let wide: [Cell<f64, TERMS>; CELLS_F32] = octave::cells(alpha as f64);
        let mut cells = [Cell {
            center: 0.0,
            mirror: 0.0,
            terms: [[0.0; 2]; TERMS],
        }; CELLS_F32];
        let mut i = 0;
        while i < CELLS_F32 {
            cells[i].center = wide[i].center as f32;
            cells[i].mirror = wide[i].mirror as f32;
            let mut n = 0;
            while n < TERMS {
                let [phi, theta] = wide[i].terms[n];
                cells[i].terms[n] = [phi as f32, theta as f32];
                n += 1;
            }
            i += 1;
        }
        Self { alpha, cells }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> Table<R, CELLS, TERMS> {
    /// The cell that holds z in [0, 1]; some cell if z is NaN.
    #[inline]
    fn cell(&self, z: R) -> &Cell<R, TERMS> {
        // z = 1 belongs to the last cell.
        let below = const { R::HALF_OCTAVE_OF_ONE - (CELLS - 1) };
        match self.cells.get(z.half_octave().saturating_sub(below)) {
            Some(cell) => cell,
            None => self.end_cell(),
        }
    }

    /// The cell of z = 0; out of line, so that finding the others needs no clamp.
    #[cold]
    #[inline(never)]
    fn end_cell(&self) -> &Cell<R, TERMS> {
        &self.cells[0]
    }

    /// Φ and Θ at h: even and odd powers apart, on pairs.
    #[inline]
    fn factors(&self, ratio: R) -> [R; 2] {
        let x = ratio * ratio;
        let cell = self.cell(R::ONE - x);
        let u = cell.mirror - x;
        let square = u * u;
        let mut sums = [cell.terms[TERMS - 1], cell.terms[TERMS - 2]];
        for n in (1..TERMS - 2).rev() {
            let sum = &mut sums[(TERMS - 1 - n) % 2];
            sum[0] = sum[0] * square + cell.terms[n][0];
            sum[1] = sum[1] * square + cell.terms[n][1];
        }
        // The sums end with the first and the second power.
        let [first, second] = if TERMS.is_multiple_of(2) {
            sums
        } else {
            [sums[1], sums[0]]
        };
        let [phi, theta] = cell.terms[0];
        [
            phi + (first[0] * u + second[0] * square),
            theta + (first[1] * u + second[1] * square),
        ]
    }

    /// Φ and Φ' at z = 1 − h²; Φ' = −dΦ/dz.
    #[inline]
    fn factor_and_slope(&self, complement: R) -> [R; 2] {
        let cell = self.cell(complement);
        let u = complement - cell.center;
        let mut phi = cell.terms[TERMS - 1][0];
        let mut slope = R::ZERO;
        for [a, _] in cell.terms.iter().rev().skip(1) {
            slope = slope * u + phi;
            phi = phi * u + *a;
        }
        [phi, -slope]
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> Profile<R> for Table<R, CELLS, TERMS> {
    #[inline]
    fn exponent(&self) -> R {
        self.alpha
    }
    #[inline]
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2] {
        self.factors(ratio)
    }
    #[inline]
    fn force_factor_and_slope(&self, complement: R) -> [R; 2] {
        self.factor_and_slope(complement)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> Coupling<R> for Table<R, CELLS, TERMS> {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        profile::wrench(self, slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        profile::jacobian(self, slide, rim)
    }
}

/// Table of α = 0 in f32.
pub type CoulombTable32 = Table<f32, CELLS_F32, TERMS_COULOMB_F32>;

/// A scalar with a Coulomb table in read-only memory.
pub trait CoulombTable: Real + sealed::Sealed {
    /// The table's type.
    type Table: Profile<Self> + 'static;
    /// The table of α = 0.
    fn coulomb_table() -> &'static Self::Table;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

impl CoulombTable for f64 {
    type Table = Table64;
    #[inline]
    fn coulomb_table() -> &'static Table64 {
        static TABLE: Table64 = Table64::build(0.0);
        &TABLE
    }
}

impl CoulombTable for f32 {
    type Table = CoulombTable32;
    #[inline]
    fn coulomb_table() -> &'static Self::Table {
        static TABLE: CoulombTable32 = CoulombTable32::build(0.0);
        &TABLE
    }
}

/// Coulomb friction, α = 0, from a table built by the compiler: no constructor, no RAM, no power.
///
/// *Accuracy*: f64 and f32 at most 5 ulp in force and torque.
///
/// ```
/// use tribos_core::coupling::{Coupling, table::Coulomb};
/// let w = Coulomb.reduced_wrench(1.0_f64, 1.0);
/// assert!((w.force - 8.0 / (3.0 * core::f64::consts::PI)).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coulomb;

impl<R: CoulombTable> Profile<R> for Coulomb {
    #[inline]
    fn exponent(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn force_and_torque_factors(&self, ratio: R) -> [R; 2] {
        R::coulomb_table().force_and_torque_factors(ratio)
    }
    #[inline]
    fn force_factor_and_slope(&self, complement: R) -> [R; 2] {
        R::coulomb_table().force_factor_and_slope(complement)
    }
    #[inline]
    fn speed_scale(&self, _: R) -> R {
        R::ONE
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        R::ONE / speed
    }
    fn half_scales(&self, speed: R) -> [R; 2] {
        [R::ONE, R::ONE / speed.sqrt()]
    }
}

impl<R: CoulombTable> DryCoupling<R> for Coulomb {}

impl<R: CoulombTable> Coupling<R> for Coulomb {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        profile::wrench(self, slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        profile::jacobian(self, slide, rim)
    }
}
