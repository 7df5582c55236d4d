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
/// The same of the square of a step, of which the next one is about a quarter at most along a smooth curve.
const SQUARE_SHARE: f64 = 0.5;

/// A curve whose points are computed for numbers alone or side by side.
pub(super) trait Curve<L: Numbers> {
    fn point(&self, slides: L::Mask, ratio: L) -> CurvePoint<L>;
    /// Half of the digits; nothing where they cost as much as all.
    fn rough_point(&self, slides: L::Mask, ratio: L) -> Option<CurvePoint<L>>;
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

/// Bracket and next ratio of a search.
struct RatioSearch<L> {
    low: L,
    high: L,
    ratio: L,
    /// The Newton step that led there, 0 if none did; infinite on a smooth curve, whose steps need no such judge.
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
        let settled = L::repeat(R::from_f64(SETTLED_ULPS) * R::EPSILON);
        let is_below = value.below(zero);
        self.low = L::select(is_below, self.ratio, self.low);
        self.high = L::select(is_below, self.high, self.ratio);
        let step = -(value / rate);
        let newton = self.ratio + step;
        let is_newton = L::both(
            rate.abs().below(L::repeat(R::INFINITY)),
            newton.is_within(self.low, self.high),
        );
        // A step is the square of the one before times a constant, and so is the next one.
        let square = step * step;
        let next = step.abs() * square;
        let is_last = L::either(
            step.abs().at_most(settled * newton),
            L::both(
                next.at_most(
                    L::repeat(R::from_f64(SHARE) * R::EPSILON)
                        * (self.before * self.before * newton),
                ),
                square.at_most(L::repeat(R::from_f64(SQUARE_SHARE) * R::EPSILON)),
            ),
        );
        // Where a step leaves the bracket or has no rate, the middle comes next.
        let is_narrow = (self.high - self.low).at_most(settled * self.high);
        // A value of zero or NaN is an end.
        let is_end = L::not(zero.below(value.abs()));
        let takes = L::both(is_newton, L::not(is_end));
        let is_done = L::either(
            is_end,
            L::either(
                L::both(is_newton, is_last),
                L::both(L::not(is_newton), is_narrow),
            ),
        );
        let middle = L::splat(0.5) * (self.low + self.high);
        self.ratio = L::select(is_newton, newton, middle);
        if !self.is_smooth {
            self.before = L::select(is_newton, step, zero);
        }
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
    let mut ratio = L::select(start.is_within(zero, one), start, one);
    if let Some(at) = curve.rough_point(slides, ratio) {
        let [value, rate] = equation.at(ratio, &at);
        let next = ratio - value / rate;
        ratio = L::select(next.is_within(zero, one), next, ratio);
    }
    let is_smooth = curve.is_smooth();
    let mut search = RatioSearch {
        low: zero,
        high: one,
        ratio,
        before: if is_smooth {
            L::repeat(R::INFINITY)
        } else {
            zero
        },
        is_smooth,
    };
    let mut at = curve.point(slides, ratio);
    let (mut by, is_done) = search.advance(equation.at(ratio, &at));
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
    // The last step moves the point along the curve: dM/dh = −h dm/dh. None is taken after the last count.
    let moves = L::both(zero.below(by.abs()), L::not(is_open));
    let by = L::select(moves, by, zero);
    let change = L::select(moves, at.rate * by, zero);
    SearchEnd {
        before: ratio,
        power: at.major + ratio * at.minor,
        ratio: ratio + by,
        major: at.major - (ratio + L::splat(0.5) * by) * change,
        minor: at.minor + change,
    }
}
