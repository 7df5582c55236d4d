//! What is measured of each stroke.

use super::divide::Span;
use super::noise::{median, median_of_three};
use super::stick_slip::stick_slip;
use super::{FrictionSign, StaticPeak, Stroke, StrokeDirection, StrokeOptions, StrokeRecord};
use std::ops::Range;

/// A stroke that the record cuts off is complete if it has this share of the others' median.
const COMPLETE: f64 = 0.9;

/// A record with what is needed to measure its strokes.
pub(super) struct Measured<'a> {
    record: &'a StrokeRecord,
    path: Option<&'a [f64]>,
    middle: f64,
    noise: f64,
}

impl<'a> Measured<'a> {
    pub(super) fn new(
        record: &'a StrokeRecord,
        path: Option<&'a [f64]>,
        options: &StrokeOptions,
        noise: f64,
    ) -> Self {
        Self {
            record,
            path,
            middle: options.middle,
            noise,
        }
    }

    /// The sign of the friction, all strokes, and the friction that resists, row by row.
    pub(super) fn all(&self, spans: &[Span]) -> (FrictionSign, Vec<Stroke>, Vec<f64>) {
        let middles: Vec<Range<usize>> = spans.iter().map(|span| self.steady(&span.rows)).collect();
        let (sign, factors) = self.factors(spans, &middles);
        let mut resistance = vec![f64::NAN; self.record.friction.len()];
        let mut strokes = Vec::with_capacity(spans.len());
        for ((span, factor), number) in spans.iter().zip(factors).zip(1..) {
            let resisting = self.fill(&mut resistance, span, factor);
            let start = span.rows.start + rows_before_sliding(resisting);
            let steady = self.steady(&(start..span.rows.end));
            let mut stroke = self.stroke(span, steady, resisting);
            stroke.number = number;
            stroke.static_peak = self.peak(span, &stroke.steady_rows, sign, factor);
            strokes.push(stroke);
        }
        mark_cut_off(&mut strokes, spans);
        (sign, strokes, resistance)
    }

    /// Writes the friction of a stroke, positive where it resists.
    fn fill<'r>(&self, resistance: &'r mut [f64], span: &Span, factor: f64) -> &'r [f64] {
        let friction = self.record.friction.get(span.rows.clone());
        let place = resistance.get_mut(span.rows.clone()).unwrap_or_default();
        for (to, from) in place.iter_mut().zip(friction.unwrap_or_default()) {
            *to = factor * from;
        }
        place
    }

    fn time(&self, row: usize) -> f64 {
        self.record.times.get(row).copied().unwrap_or(0.0)
    }

    /// Rows of the middle share of the way, or of the time.
    fn steady(&self, rows: &Range<usize>) -> Range<usize> {
        let along = |row: usize| match self.path {
            Some(path) => path.get(row).copied().unwrap_or(0.0),
            None => self.time(row),
        };
        let first = along(rows.start);
        let whole = (along(rows.end - 1) - first).abs();
        let reached = |share: f64| {
            let mut all = rows.clone();
            let found = all.find(|row| (along(*row) - first).abs() >= share * whole);
            found.unwrap_or(rows.end - 1)
        };
        let margin = 0.5 * (1.0 - self.middle);
        let low = reached(margin);
        low..(reached(1.0 - margin) + 1).max(low + 1)
    }

    /// The sign of the friction and the factor of each stroke that makes it positive.
    fn factors(&self, spans: &[Span], steady: &[Range<usize>]) -> (FrictionSign, Vec<f64>) {
        let mean = |wanted: f64| {
            let mine = spans
                .iter()
                .zip(steady)
                .filter(|(span, _)| span.sign == wanted);
            let rows = mine.filter_map(|(_, rows)| self.record.friction.get(rows.clone()));
            let (sum, count) = rows
                .flatten()
                .fold((0.0, 0.0), |(s, n), f| (s + f, n + 1.0));
            (count > 0.0).then(|| sum / count)
        };
        let (forward, backward) = (mean(1.0), mean(-1.0));
        let (sign, turn) = match (forward, backward) {
            (Some(forward), Some(backward)) if forward * backward > 0.0 => {
                (FrictionSign::Unsigned, forward)
            }
            (forward, backward) => {
                let along = forward.unwrap_or(0.0) - backward.unwrap_or(0.0);
                let sign = match along < 0.0 {
                    true => FrictionSign::Against,
                    false => FrictionSign::Along,
                };
                (sign, along)
            }
        };
        let turn = if turn < 0.0 { -1.0 } else { 1.0 };
        let factor = |span: &Span| match sign {
            FrictionSign::Unsigned => turn,
            _ => turn * span.sign,
        };
        (sign, spans.iter().map(factor).collect())
    }

    fn stroke(&self, span: &Span, steady_rows: Range<usize>, resisting: &[f64]) -> Stroke {
        let Range { start, end } = span.rows;
        let inside = steady_rows.start - start..steady_rows.end - start;
        let (mean, deviation) = mean_and_deviation(resisting.get(inside).unwrap_or_default());
        let duration = self.time(end - 1) - self.time(start);
        let length = self.path.map(|path| {
            let at = |row: usize| path.get(row).copied().unwrap_or(0.0);
            (at(end - 1) - at(start)).abs()
        });
        let times = self.record.times.get(start..end).unwrap_or_default();
        Stroke {
            number: 0,
            rows: span.rows.clone(),
            steady_rows,
            start: self.time(start),
            duration,
            direction: match span.sign > 0.0 {
                true => StrokeDirection::Forward,
                false => StrokeDirection::Backward,
            },
            length,
            mean_speed: length
                .filter(|_| duration > 0.0)
                .map(|length| length / duration),
            static_peak: None,
            mean,
            deviation,
            stick_slip: stick_slip(times, resisting, mean, self.noise),
            is_cut_off: false,
        }
    }

    /// The largest friction between the middle of the rest before a stroke and its steady part; friction
    /// without a sign is that of the stroke before until this one begins.
    fn peak(
        &self,
        span: &Span,
        steady: &Range<usize>,
        sign: FrictionSign,
        factor: f64,
    ) -> Option<StaticPeak> {
        if span.begins_in_motion {
            return None;
        }
        let start = span.rows.start;
        let first = match sign {
            FrictionSign::Unsigned => start,
            _ => start - (start - span.rest) / 2,
        };
        let rows = first..steady.start.max(start + 1);
        let resisting: Vec<f64> = self
            .record
            .friction
            .get(rows)?
            .iter()
            .map(|f| factor * f)
            .collect();
        let highest = (0..resisting.len())
            .map(|i| (i, median_of_three(&resisting, i)))
            .reduce(|best, next| if next.1 > best.1 { next } else { best });
        highest.map(|(i, value)| StaticPeak {
            value,
            time: self.time(first + i),
        })
    }
}

/// Rows before friction first reaches half of its median over the second half of the stroke: as long as the
/// springs of the machine turn round.
fn rows_before_sliding(resisting: &[f64]) -> usize {
    const REACHED: f64 = 0.5;
    let late = resisting.get(resisting.len() / 2..).unwrap_or_default();
    let level = REACHED * median(late.to_vec());
    let reached = resisting.iter().position(|f| *f >= level);
    reached.unwrap_or(0)
}

/// Marks strokes that the record cuts off.
fn mark_cut_off(strokes: &mut [Stroke], spans: &[Span]) {
    let extent = |stroke: &Stroke| stroke.length.unwrap_or(stroke.duration);
    let inner = strokes.iter().zip(spans);
    let inner = inner.filter(|(_, span)| !(span.begins_in_motion || span.ends_in_motion));
    let usual = median(inner.map(|(stroke, _)| extent(stroke)).collect());
    for (stroke, span) in strokes.iter_mut().zip(spans) {
        let touches = span.begins_in_motion || span.ends_in_motion;
        stroke.is_cut_off = touches && extent(stroke) < COMPLETE * usual;
    }
}

/// Mean and standard deviation, NaN of fewer than two values.
pub(super) fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares = values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>();
    let variance = squares / (count - 1.0);
    let deviation = if values.len() > 1 {
        variance.sqrt()
    } else {
        f64::NAN
    };
    (mean, deviation)
}
