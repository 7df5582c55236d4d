//! The ratio of speeds at which an equation holds: Newton steps kept in a bracket, of one number or of several side by
//! side.
//!
//! A lane that has ended keeps its numbers while others go on, so that its bits are those of a search alone.

use super::curve_point::{CurvePoint, Equation};
use crate::lanes::Numbers;
use crate::real::Real;

/// More steps than any search needs: bisection alone gets from 1 to the rounding error.
const MAX_STEPS: u32 = 64;
/// Relative step, and width of a bracket, below which an end is known to rounding: noise of the couplings is
/// smaller, and a Newton step that small has squared it away.
const SETTLED_ULPS: f64 = 256.0;
/// Share of a rounding error that an end may be off.
const SHARE: f64 = 0.125;
/// The same of the square of a step, of which the next one is about a quarter at most.
const SQUARE_SHARE: f64 = 0.5;

/// A curve whose points are computed for numbers alone or side by side.
pub(super) trait Curve<L: Numbers> {
    fn point(&self, slides: L::Mask, ratio: L) -> CurvePoint<L>;
    /// A point from which a step leads next to the end, in half of the digits where they cost less; nothing where the
    /// start is near enough.
    fn first_point(&self, slides: L::Mask, ratio: L) -> Option<CurvePoint<L>>;
    /// True if a step leaves at most its square.
    fn is_smooth(&self) -> bool;
}

/// Where a search ended: the ratio, and the point of the curve there.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchEnd<L> {
    pub ratio: L,
    pub major: L,
    pub minor: L,
    /// The last ratio whose point was computed, next to the end, and the power M + h m there.
    pub before: L,
    pub power: L,
}

impl<L: Numbers> SearchEnd<L> {
    /// The last step moves the point along the curve: dM/dh = −h dm/dh.
    #[inline(always)]
    fn after(step: L, ratio: L, at: &CurvePoint<L>) -> Self {
        let change = at.rate * step;
        Self {
            before: ratio,
            power: at.major + ratio * at.minor,
            ratio: ratio + step,
            major: at.major - (ratio + L::splat(0.5) * step) * change,
            minor: at.minor + change,
        }
    }
}

/// True where a Newton step to this ratio is the last one; `before` is the step that led to where it starts.
#[inline(always)]
fn is_last<R: Real, L: Numbers<Real = R>>(
    is_smooth: bool,
    step: L,
    newton: L,
    before: L,
) -> L::Mask {
    let square = step * step;
    let is_short = square.at_most(L::repeat(R::from_f64(SQUARE_SHARE) * R::EPSILON));
    if is_smooth {
        return is_short;
    }
    // A step is the square of the one before times a constant, and so is the next one.
    let (next, share) = (step.abs() * square, R::from_f64(SHARE) * R::EPSILON);
    let is_next_none = next.at_most(L::repeat(share) * (before * before * newton));
    L::either(
        step.abs().at_most(settled(newton)),
        L::both(is_next_none, is_short),
    )
}

/// What is known to rounding of a ratio, of one beyond the normal numbers too.
#[inline(always)]
fn settled<R: Real, L: Numbers<Real = R>>(ratio: L) -> L {
    L::repeat(R::from_f64(SETTLED_ULPS) * R::EPSILON) * ratio + L::repeat(R::MIN_POSITIVE)
}

/// Bracket and next ratio of a search.
struct RatioSearch<L> {
    low: L,
    high: L,
    ratio: L,
    /// The Newton step that led there, 0 if none did.
    before: L,
    is_smooth: bool,
}

impl<L: Numbers> RatioSearch<L> {
    /// The step from the present ratio, where the equation has this value and rate, and where it is the last one.
    #[inline(always)]
    fn advance<R: Real>(&mut self, [value, rate]: [L; 2]) -> (L, L::Mask)
    where
        L: Numbers<Real = R>,
    {
        let zero = L::splat(0.0);
        let is_below = value.below(zero);
        self.low = L::select(is_below, self.ratio, self.low);
        self.high = L::select(is_below, self.high, self.ratio);
        let step = -(value / rate);
        let newton = self.ratio + step;
        let is_newton = L::both(
            rate.abs().below(L::repeat(R::INFINITY)),
            newton.is_within(self.low, self.high),
        );
        // Where a step leaves the bracket or has no rate, the middle comes next.
        let is_narrow = (self.high - self.low).at_most(settled(self.high));
        // A value of zero or NaN is an end.
        let is_end = L::not(zero.below(value.abs()));
        let takes = L::both(is_newton, L::not(is_end));
        let is_last = is_last(self.is_smooth, step, newton, self.before);
        let is_done = L::either(
            is_end,
            L::either(
                L::both(is_newton, is_last),
                L::both(L::not(is_newton), is_narrow),
            ),
        );
        let middle = L::splat(0.5) * (self.low + self.high);
        self.ratio = L::select(is_newton, newton, middle);
        self.before = L::select(is_newton, step, zero);
        (L::select(takes, step, zero), is_done)
    }
}

/// The zero in [0, 1] of an equation along the curve. *Domain*: any `start`.
#[inline(always)]
pub(super) fn solved<R: Real, L: Numbers<Real = R>>(
    curve: &impl Curve<L>,
    slides: L::Mask,
    start: L,
    equation: &impl Equation<L>,
) -> SearchEnd<L> {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let (mut ratio, mut before) = (L::select(start.is_within(zero, one), start, one), zero);
    if let Some(at) = curve.first_point(slides, ratio) {
        let [value, rate] = equation.at(ratio, &at);
        let step = -(value / rate);
        let next = ratio + step;
        let is_ratio = next.is_within(zero, one);
        ratio = L::select(is_ratio, next, ratio);
        before = L::select(is_ratio, step, zero);
    }
    let at = curve.point(slides, ratio);
    let equation_at = equation.at(ratio, &at);
    // Nearly always the next step is the last one, and needs no bracket.
    let is_smooth = curve.is_smooth();
    let [value, rate] = equation_at;
    let step = -(value / rate);
    let newton = ratio + step;
    let rises = L::both(zero.below(rate), rate.below(L::repeat(R::INFINITY)));
    let is_inside = L::both(rises, newton.is_within(zero, one));
    if L::all(L::both(is_inside, is_last(is_smooth, step, newton, before))) {
        return SearchEnd::after(step, ratio, &at);
    }
    let search = RatioSearch {
        low: zero,
        high: one,
        ratio,
        before,
        is_smooth,
    };
    bracketed(curve, slides, equation, search, (at, equation_at))
}

/// The same from a point, with its value and rate, in a bracket.
#[cold]
#[inline(never)]
fn bracketed<R: Real, L: Numbers<Real = R>>(
    curve: &impl Curve<L>,
    slides: L::Mask,
    equation: &impl Equation<L>,
    mut search: RatioSearch<L>,
    (mut at, equation_at): (CurvePoint<L>, [L; 2]),
) -> SearchEnd<L> {
    let mut ratio = search.ratio;
    let (mut by, is_done) = search.advance(equation_at);
    let mut is_open = L::not(is_done);
    let mut left = MAX_STEPS;
    while L::any(is_open) && left > 0 {
        let from = search.ratio;
        let point = curve.point(slides, from);
        let (step, is_done) = search.advance(equation.at(from, &point));
        ratio = L::select(is_open, from, ratio);
        by = L::select(is_open, step, by);
        at = CurvePoint {
            major: L::select(is_open, point.major, at.major),
            minor: L::select(is_open, point.minor, at.minor),
            rate: L::select(is_open, point.rate, at.rate),
        };
        is_open = L::both(is_open, L::not(is_done));
        left -= 1;
    }
    // None of length zero where there is no rate.
    let none = L::splat(0.0);
    let moves = none.below(by.abs());
    at.rate = L::select(moves, at.rate, none);
    let end = SearchEnd::after(L::select(moves, by, none), ratio, &at);
    // Steps that were too few have found nothing.
    let found = |number| L::select(is_open, L::repeat(R::NAN), number);
    SearchEnd {
        ratio: found(end.ratio),
        minor: found(end.minor),
        major: found(end.major),
        before: found(end.before),
        power: found(end.power),
    }
}
