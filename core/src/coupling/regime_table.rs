//! Cells of one pair of functions on 0 ≤ z ≤ 1: finding one, evaluating it.

use super::family_member::FamilyMember;
use super::half_octave_table::{self, Cell, Pair};
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::power::FixedPower;
use crate::real::Real;

/// The cells of Φ and its partner.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(super) struct RegimeTable<R, const CELLS: usize, const TERMS: usize> {
    cells: [Cell<R, TERMS>; CELLS],
}

impl<const CELLS: usize, const TERMS: usize> RegimeTable<f64, CELLS, TERMS> {
    pub const fn build(pair: &Pair) -> Self {
        Self {
            cells: half_octave_table::cells(pair),
        }
    }

    /// Φ and dΦ/dz at z = 0.
    pub const fn end_terms(&self) -> [f64; 2] {
        [self.cells[0].terms[0][0], self.cells[0].terms[1][0]]
    }

    /// With terms of second and third degree in the cell of z = 0.
    pub const fn with_end(mut self, [second, third]: [[f64; 2]; 2]) -> Self {
        self.cells[0].terms[2] = second;
        self.cells[0].terms[3] = third;
        self
    }

    fn empty() -> Self {
        let cell = Cell {
            center: 0.0,
            mirror: 0.0,
            terms: [[0.0; 2]; TERMS],
        };
        Self {
            cells: [cell; CELLS],
        }
    }

    /// Adds `weight` times another side, term by term; takes over its cells' centers, which are
    /// the same for all.
    fn add(&mut self, weight: f64, other: &Self) {
        for (sum, cell) in self.cells.iter_mut().zip(&other.cells) {
            (sum.center, sum.mirror) = (cell.center, cell.mirror);
            for (terms, more) in sum.terms.iter_mut().zip(&cell.terms) {
                for (term, x) in terms.iter_mut().zip(more) {
                    *term += weight * x;
                }
            }
        }
    }
}

impl<const CELLS: usize, const TERMS: usize> RegimeTable<f32, CELLS, TERMS> {
    /// Built in f64, then rounded.
    pub const fn rounded(wide: &RegimeTable<f64, CELLS, TERMS>) -> Self {
        let mut cells = [Cell {
            center: 0.0,
            mirror: 0.0,
            terms: [[0.0; 2]; TERMS],
        }; CELLS];
        let mut i = 0;
        while i < CELLS {
            cells[i].center = wide.cells[i].center as f32;
            cells[i].mirror = wide.cells[i].mirror as f32;
            let mut n = 0;
            while n < TERMS {
                let [phi, partner] = wide.cells[i].terms[n];
                cells[i].terms[n] = [phi as f32, partner as f32];
                n += 1;
            }
            i += 1;
        }
        Self { cells }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> RegimeTable<R, CELLS, TERMS> {
    /// The cell that holds z in [0, 1]; some cell if z is NaN.
    #[inline]
    fn cell(&self, z: R) -> Option<&Cell<R, TERMS>> {
        // z = 1 belongs to the last cell.
        let below = const { R::HALF_OCTAVE_OF_ONE - (CELLS - 1) };
        self.cells.get(z.half_octave().saturating_sub(below))
    }

    /// Some z in the cell of z = 0.
    #[allow(dead_code, reason = "for targets with vectors")]
    #[inline]
    pub fn least(&self) -> R {
        R::of_half_octave(const { R::HALF_OCTAVE_OF_ONE - (CELLS - 1) })
    }

    /// The cell that holds z from [`RegimeTable::least`] to 1, found without a branch.
    #[allow(dead_code, reason = "for targets with vectors")]
    #[inline]
    pub fn cell_from_least(&self, z: R) -> &Cell<R, TERMS> {
        let below = const { R::HALF_OCTAVE_OF_ONE - (CELLS - 1) };
        let cell = self.cells.get(z.half_octave().wrapping_sub(below));
        cell.unwrap_or(&self.cells[0])
    }

    /// The cell that holds z in (0, 1] unless it is that of z = 0; none if z is NaN. Next to nothing,
    /// since what is below wraps around.
    #[inline]
    pub fn cell_above_end(&self, z: R) -> Option<&Cell<R, TERMS>> {
        let (_, above) = self.cells.split_first()?;
        let below = const { R::HALF_OCTAVE_OF_ONE - (CELLS - 2) };
        above.get(z.half_octave().wrapping_sub(below))
    }

    /// The smallest z above the cell of z = 0.
    #[allow(dead_code, reason = "for targets with vectors")]
    #[inline]
    pub fn end(&self) -> R {
        R::of_half_octave(const { R::HALF_OCTAVE_OF_ONE - (CELLS - 2) })
    }

    /// The cell of z = 0; out of line, so that finding the others needs no clamp.
    #[cold]
    #[inline(never)]
    pub fn end_cell(&self) -> &Cell<R, TERMS> {
        &self.cells[0]
    }

    /// Both functions at z, for functions that may leave z = 0 with infinite slope.
    #[inline]
    pub fn at_complement(&self, z: R) -> [R; 2] {
        match self.cell(z) {
            Some(cell) if z > R::ZERO => evaluated(cell, z - cell.center),
            _ => self.at_end(z),
        }
    }

    /// Values at z = 0, whose slopes may be infinite; NaN for NaN.
    #[cold]
    #[inline(never)]
    fn at_end(&self, z: R) -> [R; 2] {
        self.cells[0].terms[0].map(|value| value + z)
    }

    /// Φ and Φ' at z; Φ' = −dΦ/dz.
    #[inline]
    pub fn value_and_slope(&self, z: R) -> [R; 2] {
        if z == R::ZERO {
            return self.end_and_slope();
        }
        let cell = match self.cell(z) {
            Some(cell) => cell,
            None => self.end_cell(),
        };
        value_and_slope(cell, z)
    }

    /// Φ and Φ' at z = 0.
    #[cold]
    fn end_and_slope(&self) -> [R; 2] {
        let [[phi, _], [slope, _], ..] = self.cells[0].terms[..] else {
            return [R::NAN; 2];
        };
        [phi, -slope]
    }
}

/// Φ and Φ' = −dΦ/dz at z.
#[inline]
pub(super) fn value_and_slope<R: Real, const TERMS: usize>(cell: &Cell<R, TERMS>, z: R) -> [R; 2] {
    let u = z - cell.center;
    let mut phi = cell.terms[TERMS - 1][0];
    let mut slope = R::ZERO;
    for [a, _] in cell.terms.iter().rev().skip(1) {
        slope = slope * u + phi;
        phi = phi * u + *a;
    }
    [phi, -slope]
}

/// Both functions at `u` from the center.
#[inline(always)]
pub(super) fn evaluated<R: Real, const TERMS: usize>(cell: &Cell<R, TERMS>, u: R) -> [R; 2] {
    R::sums(&cell.terms, u)
}

/// The cells of both regimes under exponent α: Φ and Χ.
#[derive(Clone, Copy, Debug)]
pub(super) struct RegimeTables<R, const CELLS: usize, const TERMS: usize> {
    pub alpha: R,
    pub power: FixedPower<R>,
    pub spinning: RegimeTable<R, CELLS, TERMS>,
    pub sliding: RegimeTable<R, CELLS, TERMS>,
}

impl<const CELLS: usize, const TERMS: usize> RegimeTables<f64, CELLS, TERMS> {
    /// One pressure of the family.
    pub const fn of_member(member: &FamilyMember) -> Self {
        Self {
            alpha: member.alpha,
            power: FixedPower::<f64>::new(member.alpha),
            spinning: RegimeTable::build(&member.spinning()),
            sliding: RegimeTable::build(&member.sliding()),
        }
    }

    /// Σ wⱼ times the pressure of order j.
    pub fn of_shares(alpha: f64, shares: impl IntoIterator<Item = f64>) -> Self {
        let mut sum = Self {
            alpha,
            power: FixedPower::<f64>::new(alpha),
            spinning: RegimeTable::empty(),
            sliding: RegimeTable::empty(),
        };
        let mut order = 0.0;
        for share in shares {
            let member = Self::of_member(&FamilyMember { alpha, order });
            sum.spinning.add(share, &member.spinning);
            sum.sliding.add(share, &member.sliding);
            order += 1.0;
        }
        sum
    }
}

impl<const CELLS: usize, const TERMS: usize> RegimeTables<f32, CELLS, TERMS> {
    /// Built in f64, then rounded.
    pub const fn rounded(alpha: f32, wide: &RegimeTables<f64, CELLS, TERMS>) -> Self {
        Self {
            alpha,
            power: FixedPower::<f32>::new(alpha),
            spinning: RegimeTable::rounded(&wide.spinning),
            sliding: RegimeTable::rounded(&wide.sliding),
        }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> RegimeTables<R, CELLS, TERMS> {
    #[inline]
    fn leading(&self, at: &Speeds<R>) -> &RegimeTable<R, CELLS, TERMS> {
        match at.lead() {
            DominantSpeed::Spinning => &self.spinning,
            DominantSpeed::Sliding => &self.sliding,
        }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> PowerLawFriction<R>
    for RegimeTables<R, CELLS, TERMS>
{
    #[inline]
    fn exponent(&self) -> R {
        self.alpha
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.leading(at).at_complement(at.complement())
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

impl<R: Real, const CELLS: usize, const TERMS: usize> SmoothProfile<R>
    for RegimeTables<R, CELLS, TERMS>
{
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        let (side, z) = (self.leading(at), at.complement());
        let [_, chi] = side.at_complement(z);
        let [phi, slope] = side.value_and_slope(z);
        [phi, slope, chi]
    }
}
