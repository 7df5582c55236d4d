//! The zero of a rising function of the ratio of speeds, by Newton steps kept in a bracket.

use super::curve_point::CurvePoint;
use crate::real::Real;

/// More steps than any search needs: bisection alone gets from 1 to the rounding error.
const MAX_STEPS: u32 = 64;
/// Relative step of a search below which its end is known to rounding: noise of the couplings is
/// smaller, and a Newton step that small has squared it away.
const SETTLED_ULPS: f64 = 256.0;
/// Share of a rounding error that an end may be off.
const SHARE: f64 = 0.125;
/// A step below this share of the root of the root of rounding leaves a stationary value known to rounding.
const STATIONARY: f64 = 0.125;

/// A Newton step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<R> {
    pub from: R,
    pub by: R,
    /// The Newton step before, 0 if there was none.
    before: R,
}

/// Where a search ended: the last point computed, and the step from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchEnd<R> {
    pub step: Step<R>,
    pub at: CurvePoint<R>,
}

impl<R: Real> Step<R> {
    #[inline]
    pub fn end(&self) -> R {
        self.from + self.by
    }

    /// True if the end is known to rounding.
    #[inline]
    pub fn is_settled(&self) -> bool {
        let end = self.end();
        let per_end = R::ONE / end;
        let [by, before] = [self.by, self.before].map(|step| (step * per_end).abs());
        // A step is the square of the one before times a constant, and so is the next one.
        let [next, least] = [by * by * by, by * by * (end * end)];
        let share = R::from_f64(SHARE) * R::EPSILON;
        by <= R::from_f64(SETTLED_ULPS) * R::EPSILON
            || next <= share * (before * before) && least <= share
    }

    /// True if a function that is stationary at the zero is known to rounding.
    #[inline]
    pub fn is_stationary(&self) -> bool {
        let end = self.end();
        let rest = R::ONE - end;
        let reach = if end < rest { end } else { rest };
        let share = R::from_f64(STATIONARY) * R::EPSILON.sqrt().sqrt();
        self.by.abs() <= share * reach || self.is_settled()
    }
}

impl<R: Real> SearchEnd<R> {
    #[inline]
    pub fn ratio(&self) -> R {
        self.step.end()
    }

    /// M and m there: dM/dh = −h dm/dh.
    #[inline]
    pub fn point(&self) -> [R; 2] {
        let Step { from, by, .. } = self.step;
        let at = &self.at;
        if by == R::ZERO {
            return [at.major, at.minor];
        }
        let change = at.rate * by;
        [at.major - (from + R::HALF * by) * change, at.minor + change]
    }
}

/// A search for the zero in [0, 1] of a function that rises through it, by Newton steps kept in the bracket;
/// bisection replaces a step that leaves it or has no slope.
#[derive(Clone, Copy, Debug)]
pub(super) struct MonotoneRoot<R> {
    low: R,
    high: R,
    /// Where the next point is to be computed.
    at: R,
    /// The Newton step that led there, 0 if none did.
    before: R,
    /// How many points may follow that one.
    left: u32,
}

impl<R: Real> MonotoneRoot<R> {
    /// *Domain*: any `start`.
    #[inline]
    pub fn new(start: R) -> Self {
        let (low, high) = (R::ZERO, R::ONE);
        Self {
            low,
            high,
            at: if start >= low && start <= high {
                start
            } else {
                high
            },
            before: R::ZERO,
            left: MAX_STEPS,
        }
    }

    /// Where the next point is to be computed.
    #[inline]
    pub fn at(&self) -> R {
        self.at
    }

    /// Goes on from the next point, where the function has this value and slope. The end is known at once on
    /// NaN, and after [`MAX_STEPS`] at the latest.
    #[inline]
    pub fn update(
        &mut self,
        point: CurvePoint<R>,
        [value, slope]: [R; 2],
        is_done: impl FnOnce(&Step<R>) -> bool,
    ) -> Option<SearchEnd<R>> {
        let from = self.at;
        if value < R::ZERO {
            self.low = from;
        } else {
            self.high = from;
        }
        let step = Step {
            from,
            by: -(value / slope),
            before: self.before,
        };
        let newton = step.end();
        // A value of zero or NaN is an end, and so is that of the last point.
        let is_open = value.abs() > R::ZERO && self.left > 0;
        let is_newton = slope.is_finite() && newton >= self.low && newton <= self.high;
        if is_open && is_newton && !is_done(&step) {
            (self.at, self.before) = (newton, step.by);
            self.left -= 1;
            return None;
        }
        let step = if is_open && is_newton {
            step
        } else if is_open {
            self.bisect();
            return None;
        } else {
            Step {
                by: R::ZERO,
                ..step
            }
        };
        Some(SearchEnd { step, at: point })
    }

    #[cold]
    fn bisect(&mut self) {
        let middle = R::HALF * (self.low + self.high);
        let least = R::from_f64(SETTLED_ULPS) * R::EPSILON * middle;
        let is_narrow = (middle - self.at).abs() <= least;
        self.left = if is_narrow { 0 } else { self.left - 1 };
        (self.at, self.before) = (middle, R::ZERO);
    }
}
