//! Gauss–Jacobi nodes for the weight (1 − s)^q on [0, 1], any number, without stored tables.
//!
//! With s = (r/R)² this is the load of the pressure p ∝ (1 − r²/R²)^q on a disk, so that n rings
//! integrate every polynomial in r² up to degree 2n − 1 exactly.
//!
//! The nodes are the eigenvalues of the symmetric tridiagonal matrix of the recurrence
//! π₍ₖ₊₁₎ = (s − aₖ) πₖ − bₖ π₍ₖ₋₁₎. Sturm's count finds each by bisection, which cannot fail for
//! any q > −1; the weight is Christoffel's 1/Σ πₖ²/(b₁…bₖ), a sum of positive terms.
//!
//! *Source*: Golub and Welsch, Math. Comp. 23 (1969) 221; the bisection instead of QR steps needs
//! no workspace.

use crate::real::Real;

/// Halvings of [0, 1]: the interval is then shorter than half a rounding of s = 1.
const HALVINGS: u32 = 54;

/// The rule with `count` nodes for exponent q > −1.
#[derive(Clone, Copy, Debug)]
pub(super) struct GaussJacobi {
    count: u32,
    q: f64,
}

/// A node s and its weight; all weights of a rule add up to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct GaussNode {
    pub s: f64,
    pub weight: f64,
}

impl GaussJacobi {
    pub(super) fn new(count: u32, q: f64) -> Self {
        Self { count, q }
    }

    /// All nodes in rising order.
    pub(super) fn nodes(self) -> impl Iterator<Item = GaussNode> {
        (0..self.count).map(move |index| {
            let s = self.root(index);
            GaussNode {
                s,
                weight: self.weight(s),
            }
        })
    }

    /// (aₖ, bₖ) of the monic recurrence on [0, 1].
    fn recurrence(self, k: u32) -> (f64, f64) {
        let (q, k) = (self.q, f64::from(k));
        let twice = 2.0 * k + q;
        if k == 0.0 {
            return (1.0 / (q + 2.0), 0.0);
        }
        let a = 0.5 * (1.0 - q * q / (twice * (twice + 2.0)));
        let product = k * (k + q) / twice;
        let b = product * product / ((twice + 1.0) * (twice - 1.0));
        (a, b)
    }

    /// The node with `index` smaller ones, by bisection.
    fn root(self, index: u32) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.count_below(middle) > index {
                high = middle;
            } else {
                low = middle;
            }
        }
        0.5 * (low + high)
    }

    /// How many nodes lie below `s`: positive pivots of s − matrix. A pivot of zero, always +0,
    /// counts as positive and makes the next one −∞.
    fn count_below(self, s: f64) -> u32 {
        let mut pivot = f64::INFINITY;
        let mut count = 0;
        for k in 0..self.count {
            let (a, b) = self.recurrence(k);
            pivot = (s - a) - b / pivot;
            count += u32::from(pivot >= 0.0);
        }
        count
    }

    /// Christoffel's weight at the node `s`.
    fn weight(self, s: f64) -> f64 {
        // Orthonormal polynomials pₖ = πₖ/√(b₁…bₖ).
        let (mut before, mut here, mut sum) = (0.0, 1.0, 0.0);
        let (mut a, mut root_b) = (self.recurrence(0).0, 0.0);
        for k in 1..=self.count {
            sum += here * here;
            let (next_a, next_b) = self.recurrence(k);
            let next_root = Real::sqrt(next_b);
            (before, here) = (here, ((s - a) * here - root_b * before) / next_root);
            (a, root_b) = (next_a, next_root);
        }
        1.0 / sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ s^k (1−s)^q ds · (q+1) = k!/((q+2)…(q+1+k)).
    fn moment(k: u32, q: f64) -> f64 {
        (1..=k).fold(1.0, |m, j| m * f64::from(j) / (q + 1.0 + f64::from(j)))
    }

    #[test]
    fn moments_are_exact_up_to_twice_the_count() {
        for q in [-0.99, -0.5, 0.0, 0.3, 0.5, 1.0, 4.0, 30.0] {
            for count in [1, 2, 3, 7, 16, 64] {
                let rule = GaussJacobi::new(count, q);
                for k in 0..2 * count {
                    let found: f64 = rule
                        .nodes()
                        .map(|n| n.weight * libm::pow(n.s, f64::from(k)))
                        .sum();
                    let expected = moment(k, q);
                    let error = (found - expected).abs();
                    // Near q = -1 the outermost node is as near to the rim as rounding sees.
                    let bound = if q < -0.9 { 1e-12 } else { 4e-14 };
                    assert!(error < bound, "q {q}, {count} nodes, s^{k}: {error:e}");
                }
                // One degree more is not exact for few nodes: the test can fail.
                if count <= 3 {
                    let found: f64 = rule
                        .nodes()
                        .map(|n| n.weight * libm::pow(n.s, f64::from(2 * count)))
                        .sum();
                    assert!((found - moment(2 * count, q)).abs() > 1e-9 * moment(2 * count, q));
                }
            }
        }
    }

    #[test]
    fn two_legendre_nodes_are_the_textbook_ones() {
        let [a, b] = {
            let mut nodes = GaussJacobi::new(2, 0.0).nodes();
            [nodes.next(), nodes.next()].map(|n| n.expect("two nodes"))
        };
        let offset = 0.5 / libm::sqrt(3.0);
        assert!((a.s - (0.5 - offset)).abs() < 4e-16 && (b.s - (0.5 + offset)).abs() < 4e-16);
        assert!((a.weight - 0.5).abs() < 1e-15 && (b.weight - 0.5).abs() < 1e-15);
    }
}
