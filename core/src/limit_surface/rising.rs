//! The zero of a rising function of the ratio of speeds, by Newton steps kept in a bracket.

use super::meridian::Local;
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
pub(super) struct End<R> {
    pub step: Step<R>,
    pub at: Local<R>,
}

impl<R: Real> Step<R> {
    #[inline]
    fn none(from: R) -> Self {
        Self {
            from,
            by: R::ZERO,
            before: R::ZERO,
        }
    }

    #[inline]
    pub fn end(&self) -> R {
        self.from + self.by
    }

    /// True if the end is known to rounding.
    #[inline]
    pub fn is_settled(&self) -> bool {
        let end = self.end();
        let [by, before] = [self.by, self.before].map(|step| (step / end).abs());
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

impl<R: Real> End<R> {
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

/// The zero in [0, 1] of a function that rises through it, by Newton steps kept in the bracket;
/// bisection replaces a step that leaves it or has no slope.
///
/// *Domain*: any `start`. `function` gives value and slope from the point. Ends at once on NaN.
/// *Cost*: at most [`MAX_STEPS`] points.
#[inline]
pub(super) fn solve_rising<R: Real>(
    start: R,
    point: impl Fn(R) -> Local<R>,
    function: impl Fn(R, &Local<R>) -> [R; 2],
    is_done: impl Fn(&Step<R>, &Local<R>) -> bool,
) -> End<R> {
    let (mut low, mut high) = (R::ZERO, R::ONE);
    let mut from = if start >= low && start <= high {
        start
    } else {
        high
    };
    let mut before = R::ZERO;
    let mut at = point(from);
    for _ in 0..MAX_STEPS {
        let [value, slope] = function(from, &at);
        if value < R::ZERO {
            low = from;
        } else if value > R::ZERO {
            high = from;
        } else {
            break;
        }
        let step = Step {
            from,
            by: -(value / slope),
            before,
        };
        let newton = step.end();
        if slope.is_finite() && newton >= low && newton <= high {
            if is_done(&step, &at) {
                return End { step, at };
            }
            (from, before) = (newton, step.by);
        } else {
            let middle = R::HALF * (low + high);
            let is_narrow =
                (middle - from).abs() <= R::from_f64(SETTLED_ULPS) * R::EPSILON * middle;
            (from, before) = (middle, R::ZERO);
            if is_narrow {
                at = point(from);
                break;
            }
        }
        at = point(from);
    }
    End {
        step: Step::none(from),
        at,
    }
}
