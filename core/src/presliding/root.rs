//! The zero of a falling function.

use crate::real::Real;

/// A place, and the value there.
#[derive(Clone, Copy, Debug)]
pub(super) struct BracketPoint<R> {
    at: R,
    value: R,
}

impl<R> BracketPoint<R> {
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
pub(super) fn falling_root<R: Real>(f: impl Fn(R) -> R, ends: [BracketPoint<R>; 2], scale: R) -> R {
    let none = R::from_f64(DONE_ULPS) * R::EPSILON * scale;
    let [mut low, mut high] = ends;
    let mut width = high.at - low.at;
    let mut was_low = None;
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
        // An end that stays for the second time counts half.
        let is_low = value > R::ZERO;
        let stays = if was_low == Some(is_low) {
            R::HALF
        } else {
            R::ONE
        };
        if is_low {
            low = BracketPoint::new(at, value);
            high.value *= stays;
        } else {
            high = BracketPoint::new(at, value);
            low.value *= stays;
        }
        was_low = Some(is_low);
    }
    R::HALF * (low.at + high.at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::cell::Cell;

    /// The zero by bisection to the last bit.
    fn bisected(f: &dyn Fn(f64) -> f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if f(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }

    #[test]
    fn the_zero_is_found_in_about_ten_evaluations() {
        let (mut evaluations, mut cases) = (0, 0);
        for exponent in [0.5, 1.0, 2.0, 8.0] {
            for power in -24..12_i32 {
                let driven = libm::exp2(f64::from(power));
                // Strain that is released as g grows, against the slip that g asks for.
                let f = |g: f64| (1.0 - g) * (1.5 - 0.5 * g) - driven * libm::pow(g, exponent);
                let count = Cell::new(0);
                let counted = |g| {
                    count.set(count.get() + 1);
                    f(g)
                };
                let ends = [BracketPoint::new(0.0, 1.5), BracketPoint::new(1.0, -driven)];
                let root = falling_root(counted, ends, 1.5 + driven);
                let scale = 1.5 + driven;
                let off = f(root).abs();
                assert!(
                    off <= 8.0 * f64::EPSILON * scale,
                    "{exponent} {power}: {off:e}"
                );
                assert!((root - bisected(&f)).abs() < 1e-9, "{root}");
                assert!(count.get() <= 40, "{exponent} {power}: {}", count.get());
                evaluations += count.get();
                cases += 1;
            }
        }
        assert!(evaluations < 12 * cases, "{evaluations} in {cases}");
    }
}
