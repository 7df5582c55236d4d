//! Accelerations where none were measured: slopes of the velocity, over as many rows as explain friction best.
//!
//! Slopes over few rows are noise, and a fit on noisy accelerations finds too small an inertia; slopes over many rows
//! round the corners off, and the inertia comes out too large. So the slopes s over the width that explains friction
//! best are multiplied by Σ s a/Σ s², and least squares of friction f on them then finds the inertia Σ s f/Σ s a, which
//! has no such error: two-stage least squares with s as the instrument (Wooldridge, *Econometric Analysis of Cross
//! Section and Panel Data*, chapter 5). The sum Σ s a with the true accelerations a is extrapolated to no width at all, as
//! Richardson does, from Σ s s and from Σ s h with slopes h over half the width.

use super::abrupt::beginnings;
use super::data::Measurements;

/// Half widths, in rows, that are tried.
const WIDTHS: [usize; 8] = [1, 2, 4, 8, 16, 32, 64, 128];
/// Fewest rows for each row of a half width.
const FEWEST: usize = 8;
/// Half width over that of the sharper slopes from which the sum is extrapolated.
const SHARPER: usize = 2;
/// What a smooth course loses goes with the square of the width.
const LOSS: f64 = (SHARPER * SHARPER) as f64;
/// Most rows by which a width is chosen.
const MOST: usize = 50_000;
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

    /// Accelerations in m/s² at all rows, and the share of noise in their variance. Only rows that slide choose the width.
    pub fn slopes(&self, slides: impl Fn(usize) -> bool) -> (Vec<f64>, f64) {
        let begins = beginnings(self.times);
        let sliding = || (0..self.times.len()).filter(|row| slides(*row));
        let stride = sliding().count().div_ceil(MOST).max(1);
        let rows: Vec<usize> = sliding().step_by(stride).collect();
        let column = |width: usize, has: Neighbours| -> Vec<f64> {
            let slopes = rows.iter().map(|&row| self.slope(row, width, &begins, has));
            slopes.collect()
        };

        // The best slopes explain most of what friction has beside a Coulomb, a viscous and a constant term.
        let terms = self.terms(&rows);
        let friction = rows.iter().map(|&row| self.friction[row]).collect();
        let friction = beside(&terms, friction);
        let (mut width, mut most) = (WIDTHS[0], f64::NEG_INFINITY);
        for wider in WIDTHS {
            let slopes = beside(&terms, column(wider, all));
            let along = product(&slopes, &friction);
            let explained = along * along / product(&slopes, &slopes);
            if explained > most && (wider == WIDTHS[0] || FEWEST * wider <= rows.len()) {
                (width, most) = (wider, explained);
            }
        }

        // Two-stage least squares.
        let slopes = column(width, all);
        let square = product(&slopes, &slopes);
        let sharper = beside(&terms, column((width / SHARPER).max(1), all));
        // Slopes over every other row and over those between have the motion in common, but no noise.
        let halves = [|away| away % 2 == 1, |away| away % 2 == 0];
        let [odd, even] = halves.map(|half| column(width.max(2), half));
        let noise = 1.0 - product(&odd, &even) / square;
        let slopes = beside(&terms, slopes);
        let share = product(&slopes, &sharper) / product(&slopes, &slopes);
        let scale = (LOSS * share - 1.0) / (LOSS - 1.0);
        let scale = if scale > 0.0 && scale.is_finite() {
            scale
        } else {
            1.0
        };
        let scaled = |row| scale * self.slope(row, width, &begins, |_| true);
        let noise = if noise > 0.0 { noise.min(1.0) } else { 0.0 };
        ((0..self.times.len()).map(scaled).collect(), noise)
    }

    /// Slope of the straight line through a row's neighbours on the same side of all gaps, by least squares; 0 where
    /// there are none.
    fn slope(
        &self,
        row: usize,
        width: usize,
        begins: &[usize],
        has: impl Fn(usize) -> bool,
    ) -> f64 {
        let next = begins.partition_point(|begin| *begin <= row);
        let begin = begins.get(next.saturating_sub(1)).map_or(0, |begin| *begin);
        let end = begins.get(next).map_or(self.times.len(), |end| *end);
        let rows = begin.max(row.saturating_sub(width))..end.min(row + width + 1);
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

/// Whether rows so far away have a part in a slope.
type Neighbours = fn(usize) -> bool;

/// All do.
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

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;
    use crate::fit::{Apparatus, FitColumns, FitLaw, FitOptions};
    use tribos_base::random::Random;

    /// Velocity and acceleration of a drive: straight ramps with a period of 2 s, up to a speed of 1 m/s that is kept, a
    /// triangle where it is not kept, and a sine where the acceleration is that of its peaks.
    fn course(time: f64, acceleration: f64) -> [f64; 2] {
        const SINE: f64 = 10.0;
        if acceleration >= SINE {
            let (sine, cosine) = (acceleration * time).sin_cos();
            return [sine, acceleration * cosine];
        }
        let phase = (time / 2.0).fract();
        let [v, sign] = if phase < 0.25 {
            [phase, 1.0]
        } else if phase < 0.75 {
            [0.5 - phase, -1.0]
        } else {
            [phase - 1.0, 1.0]
        };
        let v = 2.0 * v * acceleration;
        if v.abs() < 1.0 {
            [v, sign * acceleration]
        } else {
            [v.signum(), 0.0]
        }
    }

    /// How the speed is measured.
    #[derive(Clone, Copy, Debug)]
    enum Sensor {
        /// With noise of this standard deviation.
        Noisy(f64),
        /// To a multiple of this step.
        Stepped(f64),
    }

    /// f = sgn v + 0.5 v + 0.2 a + 0.1 with noise of 0.02, for ten seconds.
    fn log(rate: f64, acceleration: f64, sensor: Sensor, seed: u64) -> (FitColumns, Vec<f64>) {
        let mut random = Random::new(seed, 0);
        let begin = random.unit();
        // Uniform noise has a variance of a twelfth of its width's square.
        let mut noise = |deviation: f64| 12.0_f64.sqrt() * deviation * (random.unit() - 0.5);
        let mut log = FitColumns {
            rest: 0.03,
            has_offset: true,
            wants_acceleration: true,
            ..FitColumns::default()
        };
        let (mut times, mut truth) = (Vec::new(), Vec::new());
        for k in 0..(10.0 * rate) as u32 {
            times.push(f64::from(k) / rate);
            let [v, a] = course(begin + f64::from(k) / rate, acceleration);
            log.velocities.push(match sensor {
                Sensor::Noisy(deviation) => v + noise(deviation),
                Sensor::Stepped(step) => (v / step).round() * step,
            });
            log.friction
                .push(v.signum() + 0.5 * v + 0.2 * a + 0.1 + noise(0.02));
            truth.push(v);
        }
        log.times = Some(times);
        (log, truth)
    }

    fn inertia(log: FitColumns) -> f64 {
        let data = log.prepared(Some(FitLaw::Viscous)).unwrap().data;
        let machine = Apparatus {
            inertia: true,
            offset: true,
            ..Apparatus::default()
        };
        let model = FitLaw::Viscous.model_on(&data, machine).unwrap();
        let found = data.fit(model.as_ref(), &FitOptions::default()).unwrap();
        found.value("inertia").unwrap()
    }

    #[test]
    fn inertia_is_right_on_corners_and_waves_whatever_the_speed_is_measured_with() {
        use Sensor::{Noisy, Stepped};
        for acceleration in [2.0, 5.0, 12.5] {
            for (rate, sensor) in [
                (100.0, Noisy(0.0)),
                (100.0, Noisy(0.03)),
                (300.0, Noisy(0.01)),
                (300.0, Stepped(0.02)),
                (1000.0, Noisy(0.01)),
                (1000.0, Noisy(0.03)),
            ] {
                for seed in 0..3 {
                    let found = inertia(log(rate, acceleration, sensor, seed).0);
                    assert!(
                        (found / 0.2 - 1.0).abs() < 0.025,
                        "{acceleration} {rate} {sensor:?}: {found}"
                    );
                }
            }
        }
        // Differences of neighbours lose the inertia in noise.
        let (mut plain, _) = log(1000.0, 5.0, Noisy(0.03), 0);
        let slopes = plain.velocities.windows(2).map(|v| 1000.0 * (v[1] - v[0]));
        plain.acceleration = Some(slopes.chain([0.0]).collect());
        assert!(inertia(plain) < 0.02);
    }

    #[test]
    fn the_share_of_noise_is_that_of_the_slopes() {
        // Over one row to either side, of accelerations ±2 with noise σ: 2 (σ/2 dt)² over that and 4.
        for deviation in [0.0, 0.01, 0.02, 0.04] {
            let (log, _) = log(100.0, 2.0, Sensor::Noisy(deviation), 1);
            let times = log.times.as_deref().unwrap();
            let record = Accelerated {
                times,
                velocities: &log.velocities,
                friction: &log.friction,
                load: None,
            };
            // Friction of nothing but these slopes chooses them.
            let narrow: Vec<f64> = (0..times.len())
                .map(|row| record.slope(row, 1, &[0], all))
                .collect();
            let record = Accelerated {
                friction: &narrow,
                ..record
            };
            let (found, noise) = record.slopes(|_| true);
            assert_eq!(found, narrow);
            let square = 0.5 * (deviation * 100.0) * (deviation * 100.0);
            let wanted = square / (square + 4.0);
            assert!((noise - wanted).abs() < 0.05, "{noise} for {wanted}");
        }
    }

    #[test]
    fn slopes_end_at_gaps_and_need_not_be_chosen() {
        // Two ramps with a gap of a minute between them, of uneven steps.
        let times: Vec<f64> = (0..200)
            .map(|k| {
                0.01 * f64::from(k) + 0.002 * f64::from(k % 3) + if k < 90 { 0.0 } else { 60.0 }
            })
            .collect();
        let of_time = |t: &f64| if *t < 50.0 { 3.0 * t } else { 7.0 - 2.0 * t };
        let velocities: Vec<f64> = times.iter().map(of_time).collect();
        let record = Accelerated {
            times: &times,
            velocities: &velocities,
            friction: &vec![0.0; 200],
            load: None,
        };
        for (row, slope) in record.slopes(|_| true).0.iter().enumerate() {
            let wanted = if row < 90 { 3.0 } else { -2.0 };
            assert!((slope - wanted).abs() < 1e-9, "{row}: {slope}");
        }
        // Nothing that slides, one row, and none.
        assert_eq!(record.slopes(|_| false).0.len(), 200);
        for count in [0, 1, 2] {
            let few = Accelerated {
                times: &times[..count],
                velocities: &velocities[..count],
                ..record
            };
            assert_eq!(few.slopes(|_| true).0.len(), count);
        }
    }
}
