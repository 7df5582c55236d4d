//! Accelerations where none were measured: slopes of the velocity, over as many rows as explain friction best.
//!
//! Slopes over few rows are noise, and a fit on noisy accelerations finds too small an inertia; slopes over many rows
//! round the corners off, and the inertia comes out too large. So the slopes `s` over the width that explains friction
//! best are scaled to the accelerations `a` that they tell of: by the factor Σ s a/Σ s², after which least squares of
//! friction on them find the inertia Σ s f/Σ s a (two-stage least squares with s as the instrument; Wooldridge,
//! *Econometric Analysis of Cross Section and Panel Data*, chapter 5). For a stand slopes over a quarter of the width, whose
//! corners are sharper, and whose noise the wide slopes have hardly in common.

use super::data::Measurements;
use std::ops::Range;

/// Half widths, in rows, that are tried.
const WIDTHS: [usize; 8] = [1, 2, 4, 8, 16, 32, 64, 128];
/// Fewest rows for each row of a half width.
const FEWEST: usize = 8;
/// Half width over that of the slopes that stand for the accelerations.
const SHARPER: usize = 4;
/// Most rows by which a width is chosen.
const MOST: usize = 100_000;
/// Interval between two rows over those before and after it that is a gap.
const GAP: f64 = 4.0;
/// Share of a column's squares below which it is a sum of others.
const NOTHING: f64 = 1e-12;

/// A record whose accelerations are sought.
#[derive(Clone, Copy)]
pub(super) struct Accelerated<'a> {
    /// Times in s, rising.
    pub times: &'a [f64],
    /// Velocities in m/s.
    pub velocities: &'a [f64],
    /// Friction, or what remains of it, that may follow the acceleration.
    pub friction: &'a [f64],
    /// Loads, where friction is a force that goes with them.
    pub load: Option<&'a [f64]>,
}

impl<'a> Accelerated<'a> {
    /// Of data over time, with their friction or what remains of it.
    pub fn of(data: &'a Measurements, friction: &'a [f64]) -> Option<Self> {
        Some(Self {
            times: data.times()?,
            velocities: data.velocities(),
            friction,
            load: data.load(),
        })
    }

    /// Accelerations in m/s² at all rows, and the share of noise in their variance. Rows that do not slide choose no
    /// width.
    pub fn slopes(&self, slides: impl Fn(usize) -> bool) -> (Vec<f64>, f64) {
        let count = self.times.len();
        let begins = self.beginnings();
        let slope = |row: usize, width: usize, has: fn(usize) -> bool| {
            let next = begins.partition_point(|begin| *begin <= row);
            let begin = begins.get(next.wrapping_sub(1)).map_or(0, |begin| *begin);
            let end = begins.get(next).map_or(count, |end| *end);
            self.slope(
                row,
                begin.max(row.saturating_sub(width))..end.min(row + width + 1),
                has,
            )
        };
        let stride = (0..count).filter(|row| slides(*row)).count().div_ceil(MOST);
        let rows = (0..count).filter(|row| slides(*row)).step_by(stride.max(1));
        let rows: Vec<usize> = rows.collect();
        let column = |width: usize, has: fn(usize) -> bool| -> Vec<f64> {
            rows.iter().map(|&row| slope(row, width, has)).collect()
        };

        // Of friction beside a Coulomb, a viscous and a constant term, the most is explained by the best slopes.
        let terms = self.terms(&rows);
        let friction = beside(&terms, rows.iter().map(|&row| self.friction[row]).collect());
        let mut best = (WIDTHS[0], f64::NEG_INFINITY);
        for width in WIDTHS {
            let slopes = beside(&terms, column(width, all));
            let (along, square) = (product(&slopes, &friction), product(&slopes, &slopes));
            let explained = along * along / square;
            if (width == 1 || FEWEST * width <= rows.len()) && explained > best.1 {
                best = (width, explained);
            }
        }

        // Two-stage least squares.
        let width = best.0;
        let slopes = beside(&terms, column(width, all));
        let sharper = beside(&terms, column((width / SHARPER).max(1), all));
        let scale = product(&slopes, &sharper) / product(&slopes, &slopes);
        let scale = if scale > 0.0 && scale.is_finite() {
            scale
        } else {
            1.0
        };

        // Slopes over every other row and over those between have the motion in common, but no noise.
        let [odd, even] = [|k| k % 2 == 1, |k| k % 2 == 0].map(|has| column(width.max(2), has));
        let slopes = column(width, all);
        let common = product(&odd, &even) / product(&slopes, &slopes);
        let noise = if common < 1.0 {
            (1.0 - common).min(1.0)
        } else {
            0.0
        };
        let scaled = |row: usize| scale * slope(row, width, all);
        ((0..count).map(scaled).collect(), noise)
    }

    /// Rows where the record begins, or begins anew after a gap.
    fn beginnings(&self) -> Vec<usize> {
        let steps = self.times.windows(2).map(|pair| pair[1] - pair[0]);
        let steps: Vec<f64> = steps.collect();
        let gaps = steps
            .windows(3)
            .enumerate()
            .filter_map(|(i, step)| (step[1] > GAP * step[0].max(step[2])).then_some(i + 2));
        std::iter::once(0).chain(gaps).collect()
    }

    /// Slope of the straight line through a row's neighbours, by least squares; 0 where there are none.
    fn slope(&self, row: usize, rows: Range<usize>, has: fn(usize) -> bool) -> f64 {
        let [mut count, mut t, mut v, mut tt, mut tv] = [0.0; 5];
        for other in rows.filter(|other| has(other.abs_diff(row))) {
            let time = self.times[other] - self.times[row];
            let velocity = self.velocities[other] - self.velocities[row];
            count += 1.0;
            t += time;
            v += velocity;
            tt += time * time;
            tv += time * velocity;
        }
        let spread = count * tt - t * t;
        if spread > 0.0 {
            (count * tv - t * v) / spread
        } else {
            0.0
        }
    }

    /// What friction has beside an inertia: orthonormal columns.
    fn terms(&self, rows: &[usize]) -> Vec<Vec<f64>> {
        let load = |row: usize| self.load.map_or(1.0, |load| load[row]);
        let sign = |v: f64| f64::from(v > 0.0) - f64::from(v < 0.0);
        let coulomb = rows
            .iter()
            .map(|&row| load(row) * sign(self.velocities[row]));
        let viscous = rows.iter().map(|&row| load(row) * self.velocities[row]);
        let mut terms: Vec<Vec<f64>> = Vec::new();
        for term in [vec![1.0; rows.len()], coulomb.collect(), viscous.collect()] {
            let whole = product(&term, &term);
            let mut rest = beside(&terms, term);
            let square = product(&rest, &rest);
            if square > NOTHING * whole {
                rest.iter_mut().for_each(|x| *x /= square.sqrt());
                terms.push(rest);
            }
        }
        terms
    }
}

/// All rows of a window.
fn all(_: usize) -> bool {
    true
}

/// A column less its components along orthonormal ones.
fn beside(terms: &[Vec<f64>], mut column: Vec<f64>) -> Vec<f64> {
    for term in terms {
        let along = product(term, &column);
        for (x, of_term) in column.iter_mut().zip(term) {
            *x -= along * of_term;
        }
    }
    column
}

fn product(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
