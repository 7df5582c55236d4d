//! Means over the strokes after the run-in.

use super::{Stroke, StrokeDirection};
use tribos_base::statistics::correlation::{correlation_time, error_factor};

/// Means over the complete strokes after the run-in, in the unit of friction.
///
/// With strokes of both directions every mean is that of the means of the two: an offset of the
/// sensor drops out, and is told apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeSummary {
    /// Number of the strokes.
    pub strokes: usize,
    /// Mean friction.
    pub mean: f64,
    /// Standard error of the mean from the scatter between strokes, enlarged by √(2τ) where means of
    /// following strokes are correlated; none with a single stroke of each direction.
    pub standard_error: Option<f64>,
    /// Standard deviation of the mean friction between strokes of one direction.
    pub deviation: Option<f64>,
    /// Half of the difference between forward and backward friction: an offset of the sensor, or a friction that
    /// depends on the direction. None without both directions. Its standard error is that of the mean.
    pub offset: Option<f64>,
    /// Mean of the static peaks.
    pub static_peak: Option<f64>,
    /// Standard deviation of the static peaks between strokes of one direction.
    pub static_peak_deviation: Option<f64>,
    /// Number of slips in all of these strokes.
    pub slips: usize,
    /// Mean fall of a slip.
    pub drop: Option<f64>,
    /// Mean time between slips that follow each other, in s.
    pub period: Option<f64>,
    /// Total length of all strokes of the record, in m, those of the run-in included.
    pub distance: Option<f64>,
}

impl StrokeSummary {
    /// Sums up the complete strokes after a number; all complete ones if none is left, and all if none is
    /// complete.
    pub(super) fn of(strokes: &[Stroke], after: usize) -> Self {
        let complete = |stroke: &&Stroke| !stroke.is_cut_off && stroke.number > after;
        let mut used: Vec<&Stroke> = strokes.iter().filter(complete).collect();
        if used.is_empty() {
            used = strokes.iter().collect();
        }
        let means = used.iter().map(|stroke| (stroke.mean, stroke.direction));
        let level = Level::of(means.collect());
        let peaks = used.iter();
        let peaks = peaks.filter_map(|s| Some((s.static_peak?.value, s.direction)));
        let peaks: Vec<_> = peaks.collect();
        let peak = (!peaks.is_empty()).then(|| Level::of(peaks));
        let slips = used.iter().map(|stroke| stroke.stick_slip.slips).sum();
        let weighed = |value: fn(&Stroke) -> Option<f64>| {
            let all = used
                .iter()
                .filter_map(|s| Some((s.stick_slip.slips as f64, value(s)?)));
            let sums = all.fold((0.0, 0.0), |(sum, count), (n, x)| (sum + n * x, count + n));
            (sums.1 > 0.0).then(|| sums.0 / sums.1)
        };
        let lengths = strokes.iter().map(|stroke| stroke.length);
        Self {
            strokes: used.len(),
            mean: level.value,
            standard_error: level.standard_error,
            deviation: level.deviation,
            offset: level.offset,
            static_peak: peak.as_ref().map(|peak| peak.value),
            static_peak_deviation: peak.and_then(|peak| peak.deviation),
            slips,
            drop: weighed(|stroke| stroke.stick_slip.drop),
            period: weighed(|stroke| stroke.stick_slip.period),
            distance: lengths.sum(),
        }
    }
}

/// Half of the difference of the directions over the last third of the strokes; 0 without both.
pub(super) fn late_offset<'a>(strokes: impl Iterator<Item = &'a Stroke>) -> f64 {
    const PARTS: usize = 3;
    let all: Vec<_> = strokes
        .map(|stroke| (stroke.mean, stroke.direction))
        .collect();
    let late = all.len() - all.len().div_ceil(PARTS);
    let late = all.get(late..).unwrap_or_default().to_vec();
    Level::of(late).offset.unwrap_or(0.0)
}

/// The common value of strokes in both directions.
struct Level {
    value: f64,
    offset: Option<f64>,
    deviation: Option<f64>,
    standard_error: Option<f64>,
}

impl Level {
    fn of(values: Vec<(f64, StrokeDirection)>) -> Self {
        let mean = |wanted: StrokeDirection| {
            let mine = values.iter().filter(|(_, direction)| *direction == wanted);
            let (sum, count) = mine.fold((0.0, 0.0), |(s, n), (x, _)| (s + x, n + 1.0));
            (count > 0.0).then(|| (sum / count, count))
        };
        let forward = mean(StrokeDirection::Forward);
        let backward = mean(StrokeDirection::Backward);
        let (value, offset, spread, levels) = match (forward, backward) {
            (Some((a, n)), Some((b, m))) => {
                let spread = 0.5 * (1.0 / n + 1.0 / m).sqrt();
                (0.5 * (a + b), Some(0.5 * (a - b)), spread, 2.0)
            }
            (Some((a, n)), None) | (None, Some((a, n))) => (a, None, 1.0 / n.sqrt(), 1.0),
            (None, None) => (f64::NAN, None, f64::NAN, 0.0),
        };
        let shift = offset.unwrap_or(0.0);
        let left = values.iter();
        let left: Vec<f64> = left
            .map(|(x, way)| x - value - shift * way.sign())
            .collect();
        let freedoms = left.len() as f64 - levels;
        let squares: f64 = left.iter().map(|x| x * x).sum();
        let deviation = (freedoms > 0.0).then(|| (squares / freedoms).sqrt());
        let factor = error_factor(correlation_time(left));
        Self {
            value,
            offset,
            deviation,
            standard_error: deviation.map(|deviation| factor * spread * deviation),
        }
    }
}
