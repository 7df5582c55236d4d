//! Where strokes begin and end: reversals and rests, with hysteresis.

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

/// Whether the gaps are the sticks of stick–slip and not rests between starts.
///
/// A stick loads the contact all the time: through the middle half of it friction rises by half of what it
/// rises in all. At a rest of the drive it is constant or relaxes, and rises when the next stroke begins. The gaps
/// are sticks if in most of them the middle half has a quarter of the rise or more.
pub(super) fn are_sticks(friction: &[f64], gaps: &[Range<usize>], noise: f64) -> bool {
    /// The smallest part of the rise in the middle half of a stick.
    const PART: f64 = 0.25;
    /// A rise that is no noise, in standard deviations.
    const CLEAR: f64 = 6.0;
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
