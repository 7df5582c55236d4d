//! The noise of a record from its differences, and filters that spare edges.

use std::ops::Range;

/// Standard deviations of a normal distribution in its median absolute deviation.
pub(in crate::fit) const SIGMAS_PER_MEDIAN: f64 = 1.482_602_218_505_602;
/// Second and fourth differences of white noise have this many times its variance: 1 + 4 + 1 and
/// 1 + 16 + 36 + 16 + 1.
const SECOND: f64 = 6.0;
const FOURTH: f64 = 70.0;
/// A signal that changes in fewer than one of so many rows is set, not rounded.
const RARE: usize = 20;
/// Variance of the rounding to whole steps, in squares of the step.
const ROUNDING: f64 = 12.0;

/// Standard deviation of the white noise on a signal.
///
/// The smaller of two estimates, from the medians of the absolute second and fourth differences: a
/// smooth signal vanishes in the fourth, and the jumps of a saw-tooth spoil fewer of the second. It is no
/// smaller than the rounding to whole steps, where the smallest change between rows is one step, unless the signal
/// changes seldom: then it is set, not measured.
pub(super) fn noise(signal: &[f64]) -> f64 {
    noise_within(signal, std::iter::once(0..signal.len()))
}

/// The same within some ranges of rows alone: a sensor is quieter at rest.
pub(super) fn noise_within(signal: &[f64], ranges: impl Iterator<Item = Range<usize>>) -> f64 {
    let (mut second, mut fourth) = (Vec::new(), Vec::new());
    let (mut step, mut changes, mut count) = (f64::INFINITY, 0, 0);
    for rows in ranges.filter_map(|rows| signal.get(rows)) {
        second.extend(rows.windows(3).filter_map(|w| match w {
            [a, b, c] => Some((a - 2.0 * b + c).abs()),
            _ => None,
        }));
        fourth.extend(rows.windows(5).filter_map(|w| match w {
            [a, b, c, d, e] => Some(((a + e) - 4.0 * (b + d) + 6.0 * c).abs()),
            _ => None,
        }));
        step = step.min(smallest_change(rows));
        changes += rows.windows(2).filter(|w| w.first() != w.last()).count();
        count += rows.len();
    }
    let second = median(second) * SIGMAS_PER_MEDIAN / SECOND.sqrt();
    let fourth = median(fourth) * SIGMAS_PER_MEDIAN / FOURTH.sqrt();
    let rounding = match step.is_finite() && changes * RARE > count {
        true => step / ROUNDING.sqrt(),
        false => 0.0,
    };
    second.min(fourth).max(rounding)
}

/// The smallest change from row to row that is one; infinite without any.
fn smallest_change(rows: &[f64]) -> f64 {
    let changes = rows.windows(2).filter_map(|w| match w {
        [a, b] if a != b => Some((b - a).abs()),
        _ => None,
    });
    changes.fold(f64::INFINITY, f64::min)
}

/// Median of values without NaN, the upper one of two; 0 of none.
pub(in crate::fit) fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// The median of each row and its two neighbours: a single wild row leaves no trace.
pub(super) fn median_of_three(signal: &[f64], at: usize) -> f64 {
    let here = signal.get(at).copied().unwrap_or(0.0);
    let before = at.checked_sub(1).and_then(|i| signal.get(i)).copied();
    match (before, signal.get(at + 1).copied()) {
        (Some(a), Some(c)) => a.min(here).max(a.max(here).min(c)),
        (Some(a), None) => a.min(here),
        (None, Some(c)) => c.min(here),
        (None, None) => here,
    }
}

/// Velocity from positions: differences over as many rows as the noise of the positions asks for, so
/// that six standard deviations of it stay below `share` of the largest speed.
pub(super) fn velocities(times: &[f64], positions: &[f64], share: f64) -> Vec<f64> {
    /// The widest difference, as a part of the rows.
    const WIDEST: usize = 16;
    /// Standard deviations that count as noise.
    const SIGMAS: f64 = 6.0;
    let count = times.len();
    let at = |half: usize| -> Vec<f64> {
        let one = |i: usize| {
            let (low, high) = (i.saturating_sub(half), (i + half).min(count - 1));
            match (
                positions.get(low),
                positions.get(high),
                times.get(low),
                times.get(high),
            ) {
                (Some(x0), Some(x1), Some(t0), Some(t1)) if t1 > t0 => (x1 - x0) / (t1 - t0),
                _ => 0.0,
            }
        };
        (0..count).map(one).collect()
    };
    let step = smallest_change(positions);
    let rounding = if step.is_finite() {
        step / ROUNDING.sqrt()
    } else {
        0.0
    };
    let spread = std::f64::consts::SQRT_2 * noise(positions).max(rounding);
    let intervals = times.windows(2).map(|w| match w {
        [a, b] => b - a,
        _ => 0.0,
    });
    let interval = median(intervals.collect());
    let mut half = 1;
    loop {
        let found = at(half);
        let doubt = spread / (2.0 * half as f64 * interval);
        if SIGMAS * doubt <= share * largest(&found) || 2 * half > count / WIDEST {
            return found;
        }
        half *= 2;
    }
}

/// Largest magnitude, without single wild rows.
pub(super) fn largest(signal: &[f64]) -> f64 {
    let magnitudes: Vec<f64> = signal.iter().map(|x| x.abs()).collect();
    (0..signal.len()).fold(0.0, |most: f64, i| {
        most.max(median_of_three(&magnitudes, i))
    })
}
