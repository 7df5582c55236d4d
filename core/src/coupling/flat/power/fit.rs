//! Polynomials that are fitted when a law is prepared, and evaluated in four chains.

use crate::coupling::flat::pair_of_numbers::Pair2;
use crate::real::Real;

/// Most terms of a polynomial.
const MOST_TERMS: usize = 28;

/// A polynomial of 4 `GROUPS` terms in s = `scale` x − `shift` ∈ [−1, 1]; in single precision the
/// first 4 (1 + `GROUPS`/2) of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit<R, const GROUPS: usize> {
    groups: [[R; 4]; GROUPS],
    scale: R,
    shift: R,
}

impl<R: Real, const GROUPS: usize> Fit<R, GROUPS> {
    /// Groups that are taken in this precision.
    const TAKEN: usize = if R::IS_SINGLE { 1 + GROUPS / 2 } else { GROUPS };

    /// Interpolates `function` at the 28 Chebyshev nodes of an interval.
    pub(super) fn new([from, to]: [f64; 2], function: impl Fn(f64) -> f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut chebyshev = [0.0; MOST_TERMS];
        for node in 0..MOST_TERMS {
            // The cosine of a multiple of the node's angle, which stays below a full turn.
            let cosine = |multiple: usize| -> f64 {
                let step = (2 * node + 1) * multiple % (4 * MOST_TERMS);
                Real::cos(core::f64::consts::PI * step as f64 / (2.0 * MOST_TERMS as f64))
            };
            let value = function(middle + half * cosine(1)) * (2.0 / MOST_TERMS as f64);
            for (order, coefficient) in chebyshev.iter_mut().enumerate() {
                *coefficient += value * cosine(order);
            }
        }
        Self {
            groups: Self::grouped(&powers(&chebyshev, 4 * Self::TAKEN)),
            scale: R::from_f64(1.0 / half),
            shift: R::from_f64(middle / half),
        }
    }

    /// The polynomial in x with these coefficients.
    pub(super) fn of(coefficients: &[f64]) -> Self {
        Self {
            groups: Self::grouped(coefficients),
            scale: R::ONE,
            shift: R::ZERO,
        }
    }

    fn grouped(coefficients: &[f64]) -> [[R; 4]; GROUPS] {
        let mut groups = [[R::ZERO; 4]; GROUPS];
        let (fours, _) = coefficients.as_chunks::<4>();
        for (group, four) in groups.iter_mut().zip(fours) {
            *group = four.map(R::from_f64);
        }
        groups
    }

    #[inline(always)]
    pub(super) fn at(&self, x: R) -> R {
        let s = self.scale * x - self.shift;
        let (s_sq, mut sums) = (s * s, [R::ZERO; 4]);
        let four = s_sq * s_sq;
        for group in self.groups.iter().take(Self::TAKEN).rev() {
            for (sum, term) in sums.iter_mut().zip(group) {
                *sum = *sum * four + *term;
            }
        }
        let [a, b, c, d] = sums;
        (a + b * s) + s_sq * (c + d * s)
    }

    #[inline(always)]
    pub(super) fn at_two(&self, x: Pair2<R>) -> Pair2<R> {
        let s = Pair2::of(self.scale) * x - Pair2::of(self.shift);
        let (s_sq, mut sums) = (s * s, [Pair2::of(R::ZERO); 4]);
        let four = s_sq * s_sq;
        for group in self.groups.iter().take(Self::TAKEN).rev() {
            for (sum, term) in sums.iter_mut().zip(group) {
                *sum = *sum * four + Pair2::of(*term);
            }
        }
        let [a, b, c, d] = sums;
        (a + b * s) + s_sq * (c + d * s)
    }
}

/// Coefficients of 1, s, s², … from the first `taken` ones of a Chebyshev series, by Clenshaw's
/// recurrence on polynomials.
fn powers(chebyshev: &[f64; MOST_TERMS], taken: usize) -> [f64; MOST_TERMS] {
    let (mut first, mut second) = ([0.0; MOST_TERMS], [0.0; MOST_TERMS]);
    for (order, coefficient) in chebyshev.iter().enumerate().take(taken).rev() {
        // The last step has s and half of the coefficient in place of 2 s and the whole.
        let factor = if order == 0 { 1.0 } else { 2.0 };
        let mut below = 0.5 * factor * coefficient;
        let mut next = second;
        for (part, old) in next.iter_mut().zip(&first) {
            *part = below - *part;
            below = factor * old;
        }
        (first, second) = (next, first);
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_is_the_function_within_its_interval() {
        let double = Fit::<f64, 6>::new([-0.25, 0.5], libm::exp);
        let single = Fit::<f32, 3>::new([-0.25, 0.5], libm::exp);
        for step in 0..=100 {
            let x = -0.25 + 0.0075 * f64::from(step);
            // Two dozen coefficients, each rounded at most to 2e-16 and most of them far less.
            assert!((double.at(x) - libm::exp(x)).abs() < 3e-15, "{x}");
            let Pair2([a, b]) = double.at_two(Pair2([x, -0.25]));
            assert!(a == double.at(x) && b == double.at(-0.25));
            let error = f64::from(single.at(x as f32)) - libm::exp(f64::from(x as f32));
            assert!(error.abs() < 3e-7, "{x} {error}");
        }
    }
}
