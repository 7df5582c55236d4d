//! Nodes of a patch inside loops of straight edges: strips between the heights of its corners, in which
//! it is a row of trapezoids, each with a product rule of Gauss and Legendre.

use tribos_core::patch::nodes::Node;
use tribos_core::real::Real;

/// Nodes along each side of a lone trapezoid, and the fewest of one among many.
const MOST_ALONG: usize = 24;
const FEWEST_ALONG: usize = 4;

/// Nodes of uniform pressure on the inside of `loops`, holes left out; the weights are areas.
pub(super) fn nodes(loops: &[Vec<[f64; 2]>]) -> Vec<Node<f64>> {
    let mut heights: Vec<f64> = loops.iter().flatten().map(|[_, y]| *y).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let strips: Vec<[f64; 2]> = heights.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let trapezoids: Vec<Trapezoid> = strips.iter().flat_map(|strip| cut(loops, *strip)).collect();
    let share = (MOST_ALONG as f64 / (trapezoids.len() as f64).sqrt()).ceil() as usize;
    let rule = legendre(share.clamp(FEWEST_ALONG, MOST_ALONG));
    trapezoids.iter().flat_map(|one| one.nodes(&rule)).collect()
}

/// A piece of a strip between two edges.
struct Trapezoid {
    heights: [f64; 2],
    /// Where the left and the right edge cross the lower and the upper height.
    left: [f64; 2],
    right: [f64; 2],
}

/// The pieces of one strip: between the first and the second edge that cross it, the third and the fourth, …
fn cut(loops: &[Vec<[f64; 2]>], [low, high]: [f64; 2]) -> Vec<Trapezoid> {
    let mut crossings: Vec<[f64; 2]> = Vec::new();
    for corners in loops {
        let after = corners.iter().cycle().skip(1);
        for (from, to) in corners.iter().zip(after) {
            let [below, above] = if from[1] < to[1] {
                [from, to]
            } else {
                [to, from]
            };
            if below[1] <= low && above[1] >= high && below[1] < above[1] {
                let at = |y: f64| {
                    let share = (y - below[1]) / (above[1] - below[1]);
                    below[0] + share * (above[0] - below[0])
                };
                crossings.push([at(low), at(high)]);
            }
        }
    }
    // Edges do not cross, so that their middles tell the order.
    crossings.sort_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
    let pairs = crossings.chunks_exact(2);
    pairs
        .map(|pair| Trapezoid {
            heights: [low, high],
            left: pair[0],
            right: pair[1],
        })
        .collect()
}

impl Trapezoid {
    fn nodes(&self, rule: &[[f64; 2]]) -> Vec<Node<f64>> {
        let [low, high] = self.heights;
        let mut nodes = Vec::with_capacity(rule.len() * rule.len());
        for [up, rows] in rule {
            let at = |ends: [f64; 2]| ends[0] + up * (ends[1] - ends[0]);
            let (left, width) = (at(self.left), at(self.right) - at(self.left));
            for [along, columns] in rule {
                nodes.push(Node {
                    x: left + along * width,
                    y: low + up * (high - low),
                    weight: rows * columns * width * (high - low),
                });
            }
        }
        nodes
    }
}

/// Nodes and weights of the Gauss–Legendre rule on [0, 1].
pub(super) fn legendre(count: usize) -> Vec<[f64; 2]> {
    let n = count as f64;
    let node = |i: usize| {
        // Newton's method from Tricomi's first guess, which is near enough for the counts in use.
        let mut x = Real::cos(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5));
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut before, mut value) = (1.0, x);
            for k in 2..=count {
                let k = k as f64;
                (before, value) = (
                    value,
                    ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
                );
            }
            slope = n * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        [0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..count).map(node).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Area and second moments about the origin.
    fn moments(nodes: &[Node<f64>]) -> [f64; 3] {
        let sum = |f: &dyn Fn(&Node<f64>) -> f64| nodes.iter().map(|n| n.weight * f(n)).sum();
        [sum(&|_| 1.0), sum(&|n| n.x * n.x), sum(&|n| n.y * n.y)]
    }

    fn is_near(found: [f64; 3], expected: [f64; 3]) {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }

    #[test]
    fn strips_have_the_moments_of_the_area() {
        let triangle = vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]];
        is_near(moments(&nodes(&triangle)), [0.5, 1.0 / 12.0, 1.0 / 12.0]);
        // A square of 4 m with a hole of 2 m turned by 45 degrees, either sense of rotation.
        let square = vec![[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]];
        let r = 2.0_f64.sqrt();
        let hole = vec![[0.0, -r], [r, 0.0], [0.0, r], [-r, 0.0]];
        let second = (256.0 - 16.0) / 12.0;
        is_near(
            moments(&nodes(&[square, hole].map(Vec::from))),
            [12.0, second, second],
        );
        // A U, which no corner sees whole.
        let u = [
            [0, 0],
            [3, 0],
            [3, 3],
            [2, 3],
            [2, 1],
            [1, 1],
            [1, 3],
            [0, 3],
        ];
        let u = u.map(|[x, y]| [f64::from(x), f64::from(y)]).to_vec();
        let [area, xx, _] = moments(&nodes(&[u]));
        assert!((area - 7.0).abs() < 1e-13);
        assert!((xx - (27.0 - 2.0 * 7.0 / 3.0)).abs() < 1e-12);
    }

    #[test]
    fn every_rule_in_use_is_exact_for_polynomials() {
        let along = FEWEST_ALONG..=MOST_ALONG;
        for count in along.chain([super::super::nodes::ON_BAR]) {
            let rule = legendre(count);
            let highest = 2 * count as u32 - 1;
            for power in [0, 1, 2, 7, highest] {
                let mean: f64 = rule
                    .iter()
                    .map(|[x, w]| w * Real::pow(*x, f64::from(power)))
                    .sum();
                assert!((mean - 1.0 / f64::from(power + 1)).abs() < 1e-14);
            }
        }
    }
}
