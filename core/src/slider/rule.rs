//! The Gauss–Legendre rule of 16 points on [−1, 1], with running integrals.

use crate::real::Real;
use crate::special::legendre::HALF;
pub(super) use crate::special::legendre::POINTS;

/// Nodes, weights and what follows from them, computed by the compiler.
pub(super) struct Rule {
    /// Ascending.
    pub nodes: [f64; POINTS],
    /// They sum to 2.
    pub weights: [f64; POINTS],
    /// `running[j][i]`: weight of the value at node j in the integral from −1 to node i.
    pub running: [[f64; POINTS]; POINTS],
    /// `legendre[k][i]`: weight of the value at node i in the coefficient of P_k.
    pub legendre: [[f64; POINTS]; POINTS],
}

/// The rule.
pub(super) static RULE: Rule = Rule::new();

impl Rule {
    const fn new() -> Self {
        let (nodes, weights) = points();
        let mut running = [[0.0; POINTS]; POINTS];
        let mut legendre = [[0.0; POINTS]; POINTS];
        let mut j = 0;
        while j < POINTS {
            let at_j = polynomials(nodes[j]);
            let mut k = 0;
            while k < POINTS {
                legendre[k][j] = (k as f64 + 0.5) * weights[j] * at_j[k];
                k += 1;
            }
            let mut i = 0;
            while i < POINTS {
                running[j][i] = 0.5 * weights[j] * integrated(&at_j, nodes[i]);
                i += 1;
            }
            j += 1;
        }
        Self {
            nodes,
            weights,
            running,
            legendre,
        }
    }
}

/// All nodes, ascending, with their weights.
const fn points() -> ([f64; POINTS], [f64; POINTS]) {
    let (mut nodes, mut weights) = ([0.0; POINTS], [0.0; POINTS]);
    let mut i = 0;
    while i < POINTS / 2 {
        let [node, weight] = HALF[i];
        let (above, below) = (POINTS / 2 + i, POINTS / 2 - 1 - i);
        (nodes[above], nodes[below]) = (node, -node);
        (weights[above], weights[below]) = (weight, weight);
        i += 1;
    }
    (nodes, weights)
}

/// P₀ to P₁₆ at `x`.
const fn polynomials(x: f64) -> [f64; POINTS + 1] {
    let mut p = [1.0; POINTS + 1];
    p[1] = x;
    let mut k = 1;
    while k < POINTS {
        let n = k as f64;
        p[k + 1] = ((2.0 * n + 1.0) * x * p[k] - n * p[k - 1]) / (n + 1.0);
        k += 1;
    }
    p
}

/// Σ c_k (2k+1) ∫ P_k from −1 to `x`, which is Σ c_k (P_{k+1} − P_{k−1}) and c₀ (x + 1) for k = 0.
const fn integrated(c: &[f64; POINTS + 1], x: f64) -> f64 {
    let p = polynomials(x);
    let mut sum = c[0] * (x + 1.0);
    let mut k = 1;
    while k < POINTS {
        sum += c[k] * (p[k + 1] - p[k - 1]);
        k += 1;
    }
    sum
}

/// ∫ from −1 to 1.
pub(super) fn integral<R: Real>(values: &[R; POINTS]) -> R {
    weighted(values, &RULE.weights)
}

/// ∫ from −1 to every node.
pub(super) fn running<R: Real>(values: &[R; POINTS]) -> [R; POINTS] {
    let mut sums = [R::ZERO; POINTS];
    for (value, row) in values.iter().zip(&RULE.running) {
        for (sum, weight) in sums.iter_mut().zip(row) {
            *sum += *value * R::from_f64(*weight);
        }
    }
    sums
}

/// Sizes of the Legendre coefficients in the middle and at the end of what sixteen values tell.
///
/// At twice the degree, which the rule integrates, a smooth function has end (end/middle)², since its coefficients
/// fall geometrically; next to a kink they fall like a power, and it has end²/middle.
pub(super) fn decay<R: Real>(values: &[R; POINTS]) -> [R; 2] {
    let size = |k: usize| match RULE.legendre.get(k) {
        Some(row) => weighted(values, row).abs(),
        None => R::ZERO,
    };
    [
        size(POINTS / 2 - 1) + size(POINTS / 2),
        size(POINTS - 2) + size(POINTS - 1),
    ]
}

/// The x in [−1, 1] to which the integral of the interpolated `values`, all positive, is `wanted`.
pub(super) fn inverse_integral<R: Real>(values: &[R; POINTS], wanted: R) -> R {
    let coefficients = RULE.legendre.each_ref().map(|row| weighted(values, row));
    let (mut low, mut high) = (-R::ONE, R::ONE);
    let mut x = R::ZERO;
    for _ in 0..MOST_BISECTIONS {
        let [value, sum] = series(&coefficients, x);
        if sum < wanted {
            low = x;
        } else {
            high = x;
        }
        let newton = x - (sum - wanted) / value;
        let next = if newton > low && newton < high {
            newton
        } else {
            R::HALF * (low + high)
        };
        let done = (next - x).abs() <= R::EPSILON;
        x = next;
        if done {
            break;
        }
    }
    x
}

/// Newton's method takes about six; each step that is none halves the interval.
const MOST_BISECTIONS: u32 = 60;

/// Σ c_k P_k and its integral from −1, at `x`.
fn series<R: Real>(coefficients: &[R; POINTS], x: R) -> [R; 2] {
    let (mut before, mut here) = (R::ONE, x);
    let (mut value, mut sum) = (R::ZERO, R::ZERO);
    let mut k = R::ZERO;
    for (index, c) in coefficients.iter().enumerate() {
        // P_{k−1} and P_k in `before` and `here` from k = 1 on.
        if index == 0 {
            value += *c;
            sum += *c * (x + R::ONE);
        } else {
            let odd = R::TWO * k + R::ONE;
            let next = (odd * x * here - k * before) / (k + R::ONE);
            value += *c * here;
            sum += *c * (next - before) / odd;
            (before, here) = (here, next);
        }
        k += R::ONE;
    }
    [value, sum]
}

fn weighted<R: Real>(values: &[R; POINTS], weights: &[f64; POINTS]) -> R {
    values
        .iter()
        .zip(weights)
        .fold(R::ZERO, |sum, (value, weight)| {
            sum + *value * R::from_f64(*weight)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_degree_31_are_integrated() {
        for degree in 0..32 {
            let wanted = if degree % 2 == 0 {
                2.0 / (f64::from(degree) + 1.0)
            } else {
                0.0
            };
            let values = RULE
                .nodes
                .map(|x: f64| (0..degree).fold(1.0, |power, _| power * x));
            // Sixteen roundings of sums up to 2.
            assert!((integral(&values) - wanted).abs() < 4e-15, "{degree}");
        }
    }

    #[test]
    fn running_integrals_and_their_inverse_are_those_of_the_exponential() {
        let values = RULE.nodes.map(|x: f64| libm::exp(x));
        let all = running(&values);
        for (x, sum) in RULE.nodes.iter().zip(all) {
            assert!(
                (sum - (libm::exp(*x) - libm::exp(-1.0))).abs() < 2e-15,
                "{x}"
            );
            assert!((inverse_integral(&values, sum) - x).abs() < 4e-15, "{x}");
        }
        let [middle, end] = decay(&values);
        assert!(end * (end / middle) < 1e-16);
        let kink = RULE.nodes.map(|x: f64| libm::fabs(x - 0.1));
        let exact = (1.1 * 1.1 + 0.9 * 0.9) / 2.0;
        let error = libm::fabs(integral(&kink) - exact);
        let [middle, end] = decay(&kink);
        assert!(
            end * (end / middle) > 0.3 * error && error > 1e-5,
            "{error}"
        );
    }
}
