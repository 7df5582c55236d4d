//! The Gauss–Legendre rules of 16 and 8 points on [−1, 1], with running integrals.

use crate::real::{Real, to_single};
use crate::special::legendre::{FEW_HALF, HALF};
pub(super) use crate::special::legendre::{FEW_POINTS, POINTS};

/// Nodes, weights and what follows from them, for N points.
pub(super) struct Rule<R: 'static, const N: usize> {
    /// Ascending.
    pub nodes: &'static [R; N],
    /// They sum to 2.
    pub weights: &'static [R; N],
    /// `running[j][i]`: weight of the value at node j in the integral from −1 to node i.
    running: &'static [[R; N]; N],
    /// `legendre[k][i]`: weight of the value at node i in the coefficient of P_k.
    legendre: &'static [[R; N]; N],
}

/// The rule of N points, 16 or 8.
pub(super) fn rule<R: Real, const N: usize>() -> Rule<R, N> {
    let [nodes, weights] = R::pick(
        RuleConstants::<N>::POINTS_SINGLE,
        RuleConstants::<N>::POINTS,
    );
    Rule {
        nodes,
        weights,
        running: R::pick(
            RuleConstants::<N>::RUNNING_SINGLE,
            RuleConstants::<N>::RUNNING,
        ),
        legendre: R::pick(
            RuleConstants::<N>::LEGENDRE_SINGLE,
            RuleConstants::<N>::LEGENDRE,
        ),
    }
}

/// What the compiler computes; a program holds what it reads alone.
struct RuleConstants<const N: usize>;

impl<const N: usize> RuleConstants<N> {
    const POINTS: &'static [[f64; N]; 2] = &points();
    const RUNNING: &'static [[f64; N]; N] = &running_weights(Self::POINTS);
    const LEGENDRE: &'static [[f64; N]; N] = &coefficient_weights(Self::POINTS);
    const POINTS_SINGLE: &'static [[f32; N]; 2] = &to_single(Self::POINTS);
    const RUNNING_SINGLE: &'static [[f32; N]; N] = &to_single(Self::RUNNING);
    const LEGENDRE_SINGLE: &'static [[f32; N]; N] = &to_single(Self::LEGENDRE);
}

const fn coefficient_weights<const N: usize>([nodes, weights]: &[[f64; N]; 2]) -> [[f64; N]; N] {
    let mut legendre = [[0.0; N]; N];
    let mut i = 0;
    while i < N {
        let at_node = polynomials(nodes[i]);
        let mut k = 0;
        while k < N {
            legendre[k][i] = (k as f64 + 0.5) * weights[i] * at_node[k];
            k += 1;
        }
        i += 1;
    }
    legendre
}

const fn running_weights<const N: usize>([nodes, weights]: &[[f64; N]; 2]) -> [[f64; N]; N] {
    let mut running = [[0.0; N]; N];
    let mut j = 0;
    while j < N {
        let at_node = polynomials(nodes[j]);
        let mut i = 0;
        while i < N {
            running[j][i] = 0.5 * weights[j] * integrated(&at_node, N, nodes[i]);
            i += 1;
        }
        j += 1;
    }
    running
}

/// All nodes, ascending, and their weights.
const fn points<const N: usize>() -> [[f64; N]; 2] {
    let half: &[[f64; 2]] = if N == POINTS { &HALF } else { &FEW_HALF };
    let (mut nodes, mut weights) = ([0.0; N], [0.0; N]);
    let mut i = 0;
    while i < N / 2 {
        let [node, weight] = half[i];
        let (above, below) = (N / 2 + i, N / 2 - 1 - i);
        (nodes[above], nodes[below]) = (node, -node);
        (weights[above], weights[below]) = (weight, weight);
        i += 1;
    }
    [nodes, weights]
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

/// Σ c_k (2k+1) ∫ P_k from −1 to `x` for k < `count`, which is Σ c_k (P_{k+1} − P_{k−1}) and c₀ (x + 1) for k = 0.
const fn integrated(c: &[f64; POINTS + 1], count: usize, x: f64) -> f64 {
    let p = polynomials(x);
    let mut sum = c[0] * (x + 1.0);
    let mut k = 1;
    while k < count {
        sum += c[k] * (p[k + 1] - p[k - 1]);
        k += 1;
    }
    sum
}

/// ∫ from −1 to 1.
pub(super) fn integral<R: Real, const N: usize>(values: &[R; N]) -> R {
    weighted(values, rule::<R, N>().weights)
}

/// ∫ from −1 to every node.
pub(super) fn running<R: Real, const N: usize>(values: &[R; N]) -> [R; N] {
    let mut sums = [R::ZERO; N];
    for (value, row) in values.iter().zip(rule::<R, N>().running) {
        for (sum, weight) in sums.iter_mut().zip(row) {
            *sum += *value * *weight;
        }
    }
    sums
}

/// Sizes of the Legendre coefficients in the middle and at the end of what the values tell.
///
/// At twice the degree, which the rule integrates, a smooth function has end (end/middle)², since its coefficients
/// fall geometrically; next to a kink they fall like a power, and it has end²/middle.
pub(super) fn decay<R: Real, const N: usize>(values: &[R; N]) -> [R; 2] {
    let Rule { legendre, .. } = rule::<R, N>();
    let size = |k: usize| match legendre.get(k) {
        Some(row) => weighted(values, row).abs(),
        None => R::ZERO,
    };
    [size(N / 2 - 1) + size(N / 2), size(N - 2) + size(N - 1)]
}

/// The x in [−1, 1] to which the integral of the interpolated `values`, all positive, is `wanted`.
pub(super) fn inverse_integral<R: Real, const N: usize>(values: &[R; N], wanted: R) -> R {
    let coefficients = rule::<R, N>()
        .legendre
        .each_ref()
        .map(|row| weighted(values, row));
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
fn series<R: Real, const N: usize>(coefficients: &[R; N], x: R) -> [R; 2] {
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

fn weighted<R: Real, const N: usize>(values: &[R; N], weights: &[R; N]) -> R {
    values
        .iter()
        .zip(weights)
        .fold(R::ZERO, |sum, (value, weight)| sum + *value * *weight)
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
            let values = rule::<f64, POINTS>()
                .nodes
                .map(|x: f64| (0..degree).fold(1.0, |power, _| power * x));
            // Sixteen roundings of sums up to 2.
            assert!((integral(&values) - wanted).abs() < 4e-15, "{degree}");
        }
    }

    #[test]
    fn running_integrals_and_their_inverse_are_those_of_the_exponential() {
        let values = rule::<f64, POINTS>().nodes.map(|x: f64| libm::exp(x));
        let all = running(&values);
        for (x, sum) in rule::<f64, POINTS>().nodes.iter().zip(all) {
            assert!(
                (sum - (libm::exp(*x) - libm::exp(-1.0))).abs() < 2e-15,
                "{x}"
            );
            assert!((inverse_integral(&values, sum) - x).abs() < 4e-15, "{x}");
        }
        let [middle, end] = decay(&values);
        assert!(end * (end / middle) < 1e-16);
        let kink = rule::<f64, POINTS>()
            .nodes
            .map(|x: f64| libm::fabs(x - 0.1));
        let exact = (1.1 * 1.1 + 0.9 * 0.9) / 2.0;
        let error = libm::fabs(integral(&kink) - exact);
        let [middle, end] = decay(&kink);
        assert!(
            end * (end / middle) > 0.3 * error && error > 1e-5,
            "{error}"
        );
    }
}
