//! The zero of a falling function.

use crate::real::Real;

/// A place, and the value there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<R> {
    at: R,
    value: R,
}

impl<R> Sample<R> {
    pub(super) const fn new(at: R, value: R) -> Self {
        Self { at, value }
    }
}

/// Most evaluations: bisection alone takes 53 (f64) in every third of them.
const MOST_STEPS: usize = 160;
/// Steps after which the bracket must have halved.
const PATIENCE: usize = 3;
/// A value of this many rounding errors of the scale is none.
const DONE_ULPS: f64 = 4.0;

/// Where `f` is zero between two ends with values ≥ 0 and ≤ 0; values are judged against `scale`.
///
/// Regula falsi in the Illinois form (Dowell & Jarratt, BIT 11 (1971) 168), with a bisection where it
/// does not halve the bracket in three steps.
pub(super) fn falling_root<R: Real>(f: impl Fn(R) -> R, ends: [Sample<R>; 2], scale: R) -> R {
    let none = R::from_f64(DONE_ULPS) * R::EPSILON * scale;
    let [mut low, mut high] = ends;
    let mut width = high.at - low.at;
    for step in 1..=MOST_STEPS {
        if low.value <= R::ZERO {
            return low.at;
        }
        if high.value >= R::ZERO {
            return high.at;
        }
        let between = high.at - low.at;
        let is_slow = step % PATIENCE == 0 && between > R::HALF * width;
        if step % PATIENCE == 0 {
            width = between;
        }
        let part = if is_slow {
            R::HALF
        } else {
            low.value / (low.value - high.value)
        };
        let at = low.at + part * between;
        if !(at > low.at && at < high.at) {
            return at;
        }
        let value = f(at);
        if value.abs() <= none || value.is_nan() {
            return at;
        }
        // The end that stays counts half.
        if value > R::ZERO {
            low = Sample::new(at, value);
            high.value = R::HALF * high.value;
        } else {
            high = Sample::new(at, value);
            low.value = R::HALF * low.value;
        }
    }
    R::HALF * (low.at + high.at)
}
