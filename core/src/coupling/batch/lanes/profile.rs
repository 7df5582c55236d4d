//! Tables in lanes.

use super::speeds::LaneSpeeds;
use super::{Lanes, power};
use crate::coupling::disk::{Disk, pure_spin_torque};
use crate::coupling::equal_speeds::{bends_slopes, bends_values};
use crate::coupling::half_octave_table::Cell;
use crate::coupling::pressure_family::moment;
use crate::coupling::regime_table::RegimeTables;
use crate::coupling::round::RoundTable;
use crate::coupling::table::Table;
use crate::coupling::{PowerLawFriction, SmoothProfile};
use crate::lanes::{Eight as _, Group, Lanes as _, Numbers};
use crate::real::Real;

/// [`SmoothProfile`] of a group. Nothing where an argument is out of the ordinary.
pub trait LaneProfile<R: Real>: SmoothProfile<R> {
    /// F/v and T for v² and w.
    #[inline(always)]
    fn drags(&self, slide_sq: Lanes<R>, rim: Lanes<R>) -> Option<[Lanes<R>; 2]> {
        super::speeds::drags_of_speeds(self, slide_sq.sqrt(), rim)
    }
    /// Φ and T/m^α.
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]>;
    /// Φ, Φ' and Χ.
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]>;
    /// `speed`^α
    fn speed_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>>;
    /// `speed`^(α−1)
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>>;
}

/// One number of each cell.
#[inline(always)]
fn of_each<R: Real, const TERMS: usize>(
    cells: &Group<&Cell<R, TERMS>>,
    number: impl Fn(&Cell<R, TERMS>) -> R,
) -> Lanes<R> {
    Numbers::new(cells.map(number))
}

/// Both functions at `u` from the centers.
#[inline(always)]
fn evaluated<R: Real, const TERMS: usize>(
    cells: &Group<&Cell<R, TERMS>>,
    u: Lanes<R>,
) -> [Lanes<R>; 2] {
    Lanes::<R>::sums(cells.map(|cell| &cell.terms), u)
}

/// Φ and Φ' at z.
#[inline(always)]
fn value_and_slope<R: Real, const TERMS: usize>(
    cells: &Group<&Cell<R, TERMS>>,
    z: Lanes<R>,
) -> [Lanes<R>; 2] {
    let u = z - of_each(cells, |cell| cell.center);
    let mut phi = of_each(cells, |cell| cell.terms[TERMS - 1][0]);
    let mut slope = Lanes::<R>::repeat(R::ZERO);
    for n in (0..TERMS - 1).rev() {
        slope = slope * u + phi;
        phi = phi * u + of_each(cells, |cell| cell.terms[n][0]);
    }
    [phi, -slope]
}

impl<R: Real, const CELLS: usize, const TERMS: usize> Disk<R, CELLS, TERMS> {
    #[inline(always)]
    fn cells(&self, z: Lanes<R>) -> Group<&Cell<R, TERMS>> {
        let z = z.larger(Numbers::repeat(self.side.least()));
        z.to_array().map(|z| self.side.cell_from_least(z))
    }

    /// True if none is in the cell of z = 0.
    #[inline(always)]
    fn above_end(&self, z: Lanes<R>) -> bool {
        Lanes::<R>::all(z.at_least(Numbers::repeat(self.side.end())))
    }

    /// The two functions with those of lanes in the cell of z = 0 from `near`.
    #[cold]
    #[inline(never)]
    fn with_ends(
        &self,
        z: Lanes<R>,
        [first, second]: [Lanes<R>; 2],
        near: impl Fn(R) -> [R; 2],
    ) -> [Lanes<R>; 2] {
        let (mut first, mut second) = (first.to_array(), second.to_array());
        for ((z, first), second) in z.to_array().into_iter().zip(&mut first).zip(&mut second) {
            if z < self.side.end() {
                [*first, *second] = near(z);
            }
        }
        [Numbers::new(first), Numbers::new(second)]
    }

    /// [`LaneProfile::drags_and_torques`]
    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> [Lanes<R>; 2] {
        let one = Lanes::<R>::repeat(R::ONE);
        let (a, h) = (at.slide(), at.ratio);
        let x = h * h;
        let z = one - x;
        let cells = self.cells(z);
        let mut factors = evaluated(&cells, of_each(&cells, |cell| cell.mirror) - x);
        if bends_values(self.alpha) && !self.above_end(z) {
            factors = self.with_ends(z, factors, |z| self.bent_force_and_theta(z));
        }
        let [phi, theta] = factors;
        let spin = Lanes::<R>::repeat(pure_spin_torque(self.exponent())) * (one - a * a);
        [phi, spin * phi + a * h * theta]
    }

    /// [`LaneProfile::factors_and_slopes`]
    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> [Lanes<R>; 3] {
        let z = at.complement();
        let mut factors = value_and_slope(&self.cells(z), z);
        if bends_slopes(self.alpha) && !self.above_end(z) {
            factors = self.with_ends(z, factors, |z| self.bent_force_and_slope(z));
        }
        let [phi, slope] = factors;
        let alpha = self.exponent();
        let inv_n = Lanes::<R>::repeat(R::ONE / moment(R::ZERO, alpha));
        let half = Lanes::<R>::repeat(R::HALF * (R::ONE + alpha));
        let theta = inv_n * (half * phi + z * slope);
        let x = at.ratio * at.ratio;
        let chi = Lanes::<R>::select(at.slides, theta, inv_n * z * phi + x * theta);
        [phi, slope, chi]
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> LaneProfile<R> for Table<R, CELLS, TERMS> {
    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]> {
        Some(self.disk.drags_and_torques(at))
    }
    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]> {
        Some(self.disk.factors_and_slopes(at))
    }
    #[inline(always)]
    fn speed_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        power::of(&self.power, speed)
    }
    #[inline(always)]
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        power::rate(&self.power, speed)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> LaneProfile<R>
    for RegimeTables<R, CELLS, TERMS>
{
    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]> {
        let z = at.complement();
        let cells = self.cells_of(at, z)?;
        let [phi, chi] = evaluated(&cells, z - of_each(&cells, |cell| cell.center));
        Some([phi, at.rim() * chi])
    }

    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]> {
        let z = at.complement();
        let cells = self.cells_of(at, z)?;
        let [_, chi] = evaluated(&cells, z - of_each(&cells, |cell| cell.center));
        let [phi, slope] = value_and_slope(&cells, z);
        Some([phi, slope, chi])
    }

    #[inline(always)]
    fn speed_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        power::of(&self.power, speed)
    }

    #[inline(always)]
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        power::rate(&self.power, speed)
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> RegimeTables<R, CELLS, TERMS> {
    /// The cells of the side that leads in each lane; none at equal speeds.
    #[inline(always)]
    fn cells_of(&self, at: &LaneSpeeds<R>, z: Lanes<R>) -> Option<Group<&Cell<R, TERMS>>> {
        if !Lanes::<R>::all(z.above(Numbers::repeat(R::ZERO))) {
            return None;
        }
        let mut slides = at.leads();
        let z = z.larger(Numbers::repeat(self.sliding.least()));
        Some(z.to_array().map(|z| {
            let side = if slides & 1 == 0 {
                &self.spinning
            } else {
                &self.sliding
            };
            slides >>= 1;
            side.cell_from_least(z)
        }))
    }
}

impl<R: Real, const CELLS: usize, const TERMS: usize> LaneProfile<R>
    for RoundTable<R, CELLS, TERMS>
{
    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]> {
        self.sides.drags_and_torques(at)
    }
    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]> {
        self.sides.factors_and_slopes(at)
    }
    #[inline(always)]
    fn speed_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        self.sides.speed_scales(speed)
    }
    #[inline(always)]
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        self.sides.rate_scales(speed)
    }
}
