//! Stick–slip within a stroke: a saw-tooth whose falls are faster than its rises.

use std::ops::Range;

/// Stick–slip of one stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StickSlip {
    /// Number of slips; 0 if there are fewer than three.
    pub slips: usize,
    /// Mean fall of the friction in a slip, in the unit of friction; none without slips.
    pub drop: Option<f64>,
    /// Mean time between slips that follow each other, in s; none without slips that follow each other.
    pub period: Option<f64>,
}

/// Smallest fall of a slip in standard deviations of the noise: a million rows of white noise span
/// ten of them.
const NOISE: f64 = 10.0;
/// Smallest fall of a slip, as a share of the friction.
const SHARE: f64 = 0.02;
/// A slip takes at most this part of the time of the stick before it.
const FALL: f64 = 0.5;
/// A fall within so many rows is quick, however short the stick was sampled.
const QUICK: usize = 1;
/// Largest deviation of a stick from a straight line, in the root mean square, as a share of the fall.
const STRAIGHT: f64 = 0.2;
/// Smallest share of slips among the falls: waves and slow noise fall quickly now and then.
const REGULAR: f64 = 0.5;
/// Rows so few standard deviations of the noise from a turning point may be the turning point.
const DOUBT: f64 = 3.0;
/// Fewest slips that are stick–slip: one fall is that of the static peak, and another may be a place of the track.
const FEWEST_SLIPS: usize = 3;

/// The smallest fall that counts as a slip of friction with this mean and noise.
pub(super) fn smallest_fall(mean: f64, noise: f64) -> f64 {
    (NOISE * noise).max(SHARE * mean.abs())
}

/// Finds the slips of a stroke; `friction` resists the motion and is positive.
pub(super) fn stick_slip(times: &[f64], friction: &[f64], mean: f64, noise: f64) -> StickSlip {
    let mut sticks = sticks(friction, smallest_fall(mean, noise));
    sharpen(&mut sticks, friction, DOUBT * noise);
    let mut falls = Vec::new();
    let mut moments = Vec::new();
    let time = |i: usize| times.get(i).copied().unwrap_or(0.0);
    let value = |i: usize| friction.get(i).copied().unwrap_or(0.0);
    for (k, stick) in sticks.iter().enumerate() {
        let peak = stick.rise.end - 1;
        let fall = value(peak) - value(stick.valley);
        let fall_time = time(stick.valley) - time(peak);
        let rise_time = time(peak) - time(stick.rise.start);
        let is_quick = stick.valley - peak <= QUICK || fall_time <= FALL * rise_time;
        // The first stick of a stroke loads the contact from anywhere: it may bend.
        let is_straight = k == 0 || bend(friction, &stick.rise) <= STRAIGHT * fall;
        if is_quick && is_straight {
            falls.push(fall);
            moments.push((k, time(peak)));
        }
    }
    if (falls.len() as f64) < REGULAR * sticks.len() as f64 {
        return StickSlip::default();
    }
    summary(&falls, &moments)
}

/// Mean fall and period, where there are slips enough.
fn summary(falls: &[f64], moments: &[(usize, f64)]) -> StickSlip {
    if falls.len() < FEWEST_SLIPS {
        return StickSlip::default();
    }
    let gaps = moments.windows(2).filter_map(|pair| match pair {
        [(a, from), (b, to)] if *b == a + 1 => Some(to - from),
        _ => None,
    });
    let gaps: Vec<f64> = gaps.collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    StickSlip {
        slips: falls.len(),
        drop: Some(mean(falls)),
        period: (!gaps.is_empty()).then(|| mean(&gaps)),
    }
}

/// A stick that ends in a fall.
struct Stick {
    /// Rows from the valley to the peak.
    rise: Range<usize>,
    /// Lowest row after the peak.
    valley: usize,
}

/// Turning points with hysteresis: a peak counts when friction has fallen from it by `fall`, a valley when
/// it has risen by as much.
fn sticks(friction: &[f64], fall: f64) -> Vec<Stick> {
    let value = |i: usize| friction.get(i).copied().unwrap_or(0.0);
    let mut found: Vec<Stick> = Vec::new();
    let (mut start, mut peak, mut valley) = (0, 0, 0);
    let mut is_rising = true;
    for i in 1..friction.len() {
        if is_rising {
            if value(i) >= value(peak) {
                peak = i;
            } else if value(peak) - value(i) > fall {
                valley = i;
                is_rising = false;
            }
        } else if value(i) <= value(valley) {
            valley = i;
        } else if value(i) - value(valley) > fall {
            found.push(Stick {
                rise: start..peak + 1,
                valley,
            });
            (start, peak) = (valley, i);
            is_rising = true;
        }
    }
    if !is_rising {
        found.push(Stick {
            rise: start..peak + 1,
            valley,
        });
    }
    found
}

/// Moves each peak to the last and each valley to the first row of the fall that noise may have made the
/// turning point: sticks end where the fall begins.
fn sharpen(sticks: &mut [Stick], friction: &[f64], doubt: f64) {
    let value = |i: usize| friction.get(i).copied().unwrap_or(0.0);
    let mut start = None;
    for stick in sticks {
        stick.rise.start = start.unwrap_or(stick.rise.start);
        let (peak, valley) = (stick.rise.end - 1, stick.valley);
        let is_high = |i: &usize| value(*i) >= value(peak) - doubt;
        let last = (peak..valley).rev().find(is_high).unwrap_or(peak);
        let is_low = |i: &usize| value(*i) <= value(valley) + doubt;
        stick.valley = (last + 1..valley).find(is_low).unwrap_or(valley);
        stick.rise.end = last + 1;
        start = Some(stick.valley);
    }
}

/// Root mean square of what the straight line through a stick, by least squares, leaves.
fn bend(friction: &[f64], rows: &Range<usize>) -> f64 {
    let values = friction.get(rows.clone()).unwrap_or_default();
    let count = values.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = values.iter().sum::<f64>() / count;
    let (mut moment, mut squares) = (0.0, 0.0);
    for (i, value) in values.iter().enumerate() {
        let x = i as f64 - middle;
        moment += x * (value - mean);
        squares += x * x;
    }
    let slope = if squares > 0.0 { moment / squares } else { 0.0 };
    let left = values.iter().enumerate().map(|(i, value)| {
        let left = value - mean - slope * (i as f64 - middle);
        left * left
    });
    (left.sum::<f64>() / count).sqrt()
}
