//! The table of one exponent on the uniform disk, without the power of its scale.

use super::equal_speeds::{EqualSpeedExpansion, bends_slopes, bends_values};
use super::family_member::FamilyMember;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::regime_table::{self, RegimeTable};
use super::speeds::{DominantSpeed, Speeds};
use crate::real::Real;

/// Below this many roots of rounding Φ' is not taken from Θ, which loses its digits like 1/z.
const CLOSE: f64 = 64.0;

/// Φ and Θ of one exponent; Χ = (1−a²)Φ/n + a²Θ with a = v/m, whichever speed leads.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Disk<R, const CELLS: usize, const TERMS: usize> {
    pub(super) side: RegimeTable<R, CELLS, TERMS>,
    pub(super) tip: EqualSpeedExpansion<R>,
    pub(super) alpha: R,
}

/// The cells of exponent α with their end, in f64.
const fn cells_and_tip<const CELLS: usize, const TERMS: usize>(
    alpha: f64,
) -> (RegimeTable<f64, CELLS, TERMS>, EqualSpeedExpansion<f64>) {
    let disk = FamilyMember { alpha, order: 0.0 }.sliding();
    let side = RegimeTable::build(&disk);
    let octaves = (CELLS as u32 - 2) / 2;
    let tip = EqualSpeedExpansion::fitted(&disk, side.end_terms(), octaves);
    (side.with_end(tip.tangents(&disk, octaves)), tip)
}

impl<const CELLS: usize, const TERMS: usize> Disk<f64, CELLS, TERMS> {
    pub(super) const fn build(alpha: f64) -> Self {
        let (side, tip) = cells_and_tip(alpha);
        Self { side, tip, alpha }
    }
}

impl<const CELLS: usize, const TERMS: usize> Disk<f32, CELLS, TERMS> {
    /// Built in f64, then rounded.
    pub(super) const fn build(alpha: f32) -> Self {
        let (side, tip) = cells_and_tip(alpha as f64);
        Self {
            side: RegimeTable::rounded(&side),
            tip: tip.rounded(),
            alpha,
        }
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> PowerLawFriction<R>
    for Disk<R, CELLS, TERMS>
{
    #[inline]
    fn exponent(&self) -> R {
        self.alpha
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, theta] = self.force_and_theta(at);
        let a_sq = at.slide * at.slide;
        let spin = pure_spin_torque(self.alpha) * (R::ONE - a_sq);
        [phi, spin * phi + a_sq * theta]
    }
    /// One formula for both regimes, since which speed leads is a coin toss to a branch predictor,
    /// and one whose two lines the compiler computes side by side.
    #[inline(always)]
    fn drag_and_torque(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, theta] = self.force_and_theta(at);
        let (a, h) = (at.slide, at.ratio());
        let spin = pure_spin_torque(self.alpha) * (R::ONE - a * a);
        [phi, spin * phi + a * h * theta]
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        pressure_family::inertia_excess(self, R::ZERO, at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        pressure_family::inertia_ends(self.exponent(), R::ZERO)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> Disk<R, CELLS, TERMS> {
    /// Φ and Θ at x = h²: near z = 0 the rounding of z = 1 − x does not matter to them.
    #[inline(always)]
    fn force_and_theta(&self, at: &Speeds<R>) -> [R; 2] {
        let h = at.ratio();
        let x = h * h;
        let cell = match self.side.cell_above_end(R::ONE - x) {
            Some(cell) => cell,
            None if bends_values(self.alpha) => return self.bent_force_and_theta(R::ONE - x),
            None => self.side.end_cell(),
        };
        regime_table::evaluated(cell, cell.mirror - x)
    }

    /// Φ and Φ' at z.
    #[inline]
    fn force_and_slope(&self, z: R) -> [R; 2] {
        let cell = match self.side.cell_above_end(z) {
            Some(cell) => cell,
            None if bends_slopes(self.alpha) => return self.bent_force_and_slope(z),
            None => self.side.end_cell(),
        };
        regime_table::value_and_slope(cell, z)
    }

    /// Φ and Θ at z in the cell of z = 0, from their expansion; NaN for NaN.
    #[cold]
    #[inline(never)]
    pub(super) fn bent_force_and_theta(&self, z: R) -> [R; 2] {
        let [phi, slope] = self.bent_force_and_slope(z);
        let alpha = self.alpha;
        [
            phi,
            pressure_family::theta(R::ZERO, alpha, [phi, z * slope]),
        ]
    }

    /// Φ and Φ' at z in the cell of z = 0, from their expansion; NaN for NaN.
    #[cold]
    #[inline(never)]
    pub(super) fn bent_force_and_slope(&self, z: R) -> [R; 2] {
        self.tip.value_and_slope(self.alpha, z)
    }
}

/// 2/(3+α): the reduced torque of pure spinning.
#[inline]
pub(super) fn pure_spin_torque<R: Real>(alpha: R) -> R {
    R::TWO / (R::ONE + R::TWO + alpha)
}

impl<R: Real, const CELLS: usize, const TERMS: usize> SmoothProfile<R> for Disk<R, CELLS, TERMS> {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        let [phi, slope] = self.force_and_slope(at.complement());
        // One table read serves all.
        let chi = pressure_family::torque_factor(R::ZERO, self.alpha, at, [phi, slope]);
        [phi, slope, chi]
    }
    /// Φ' from Θ, next to equal speeds from the polynomial.
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        let [phi, theta] = self.force_and_theta(at);
        let z = at.complement();
        if z < R::from_f64(CLOSE) * R::EPSILON.sqrt() {
            return self.factors_and_slope(at);
        }
        let moment = pressure_family::moment(R::ZERO, self.alpha);
        let slope = (moment * theta - R::HALF * (R::ONE + self.alpha) * phi) / z;
        let a_sq = at.slide * at.slide;
        let spin = pure_spin_torque(self.alpha) * (R::ONE - a_sq);
        let chi = match at.lead() {
            DominantSpeed::Sliding => theta,
            DominantSpeed::Spinning => spin * phi + a_sq * theta,
        };
        [phi, slope, chi]
    }
}
