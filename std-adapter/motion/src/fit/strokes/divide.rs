//! Where strokes begin and end: reversals and rests, with hysteresis.

use super::noise::noise_within;
use std::ops::Range;

/// Rows of one stroke, before anything is measured.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    /// Rows in motion.
    pub rows: Range<usize>,
    /// Direction, 1 or −1.
    pub sign: f64,
    /// Row after the last one of the stroke before: the rest lies between it and the first row.
    pub rest: usize,
    /// Whether the record begins within this stroke.
    pub begins_in_motion: bool,
    /// Whether the record ends within this stroke.
    pub ends_in_motion: bool,
}

/// Share of the threshold below which a stroke is over: the other side of the hysteresis.
const OVER: f64 = 0.25;

/// Fewest rows of a rest.
pub(super) const FEWEST_AT_REST: usize = 5;

/// Divides a signal, a velocity or a friction with a sign, into strokes.
///
/// A stroke is firm from the first to the last row whose magnitude reaches the threshold before the
/// direction changes or a rest ends it; `divides` says whether a gap of smaller values between two firm rows
/// of one direction is such a rest. The firm part is extended on both sides until the signal falls
/// below a quarter of the threshold.
pub(super) fn divide(
    signal: &[f64],
    threshold: f64,
    divides: impl Fn(Range<usize>) -> bool,
) -> Vec<Span> {
    let firm = firm_parts(signal, threshold, divides);
    let count = signal.len();
    let mut spans: Vec<Span> = Vec::with_capacity(firm.len());
    for (k, (rows, sign)) in firm.iter().enumerate() {
        let runs = |i: usize| signal.get(i).is_some_and(|x| sign * x > OVER * threshold);
        let rest = spans.last().map_or(0, |span: &Span| span.rows.end);
        let limit = firm.get(k + 1).map_or(count, |(next, _)| next.start);
        let back = (rest..rows.start).rev().take_while(|i| runs(*i)).count();
        let on = (rows.end..limit).take_while(|i| runs(*i)).count();
        spans.push(Span {
            rows: rows.start - back..rows.end + on,
            sign: *sign,
            rest,
            begins_in_motion: rows.start == 0,
            ends_in_motion: rows.end == count,
        });
    }
    spans
}

/// Divides a signal, and again without the strokes that are shorter than a twentieth of the usual one: a drive that
/// settles, or a sensor that creeps by a step, makes no stroke.
///
/// The usual extent is that of the strokes which, with all longer ones, cover half of the whole.
pub(super) fn divide_into_strokes(
    mut signal: Vec<f64>,
    threshold: f64,
    divides: impl Fn(Range<usize>) -> bool,
    extent: impl Fn(&Range<usize>) -> f64,
) -> Vec<Span> {
    /// The smallest share of the usual extent.
    const SHARE: f64 = 0.05;
    /// Strokes that grow together may be longer: the usual one is found anew so many times.
    const PASSES: usize = 3;
    let mut spans = divide(&signal, threshold, &divides);
    for _ in 0..PASSES {
        let mut extents: Vec<f64> = spans.iter().map(|span| extent(&span.rows)).collect();
        let shortest = SHARE * usual(&mut extents);
        let short = spans.iter().filter(|span| extent(&span.rows) < shortest);
        let short: Vec<Range<usize>> = short.map(|span| span.rows.clone()).collect();
        if short.is_empty() {
            break;
        }
        for rows in short {
            signal.get_mut(rows).unwrap_or_default().fill(0.0);
        }
        spans = divide(&signal, threshold, &divides);
    }
    spans
}

/// The extent of strokes that, with all longer ones, cover half of the whole.
fn usual(extents: &mut [f64]) -> f64 {
    extents.sort_unstable_by(|a, b| b.total_cmp(a));
    let half = 0.5 * extents.iter().sum::<f64>();
    let mut covered = 0.0;
    let found = extents.iter().find(|extent| {
        covered += **extent;
        covered >= half
    });
    found.copied().unwrap_or(0.0)
}

/// First to last firm row of each stroke, with its direction.
fn firm_parts(
    signal: &[f64],
    threshold: f64,
    divides: impl Fn(Range<usize>) -> bool,
) -> Vec<(Range<usize>, f64)> {
    let mut parts: Vec<(Range<usize>, f64)> = Vec::new();
    let firm = signal.iter().enumerate();
    for (i, value) in firm.filter(|(_, x)| x.abs() >= threshold) {
        let sign = 1.0_f64.copysign(*value);
        match parts.last_mut() {
            Some((rows, old)) if *old == sign && !divides(rows.end..i) => rows.end = i + 1,
            _ => parts.push((i..i + 1, sign)),
        }
    }
    parts
}

/// The rests between firm rows of one direction.
pub(super) fn gaps(
    signal: &[f64],
    threshold: f64,
    is_rest: impl Fn(Range<usize>) -> bool,
) -> Vec<Range<usize>> {
    let firm = firm_parts(signal, threshold, is_rest);
    let pairs = firm.windows(2).filter_map(|pair| match pair {
        [(before, one), (after, other)] if one == other => Some(before.end..after.start),
        _ => None,
    });
    pairs.collect()
}

/// Whether the gaps are the sticks of stick–slip and not rests between starts.
///
/// A stick loads the contact all the time: through the middle half of it friction rises by half of what it
/// rises in all. At a rest of the drive it is constant or relaxes, and rises when the next stroke begins. The gaps
/// are sticks if in most of them the middle half has a quarter of the rise or more.
pub(super) fn are_sticks(friction: &[f64], gaps: &[Range<usize>]) -> bool {
    /// The smallest part of the rise in the middle half of a stick.
    const PART: f64 = 0.25;
    /// A rise that is no noise, in standard deviations.
    const CLEAR: f64 = 6.0;
    let noise = noise_within(friction, gaps.iter().cloned());
    let loads = |gap: &&Range<usize>| {
        let quarter = gap.len() / 4;
        let at = |i: usize| friction.get(i).copied().unwrap_or(0.0);
        let (first, last) = (at(gap.start), at(gap.end - 1));
        let rise = (last - first).abs();
        let inside = (at(gap.end - 1 - quarter) - at(gap.start + quarter)).abs();
        // The start that follows may rise further than the rest.
        let after = friction.get(gap.end..(gap.end + gap.len()).min(friction.len()));
        let after = after.unwrap_or_default().iter();
        let whole = after.fold(rise, |most: f64, f| most.max((f - first).abs()));
        whole > CLEAR * noise && inside > PART * whole
    };
    2 * gaps.iter().filter(loads).count() > gaps.len()
}
