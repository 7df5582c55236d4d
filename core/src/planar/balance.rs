//! What is left of a wrench after the friction of many points: a smooth problem in three unknowns.
//!
//! With the torque in units of `length`, the remainder e = q − (nearest wrench of the foot) is the
//! smallest point of the convex function
//!
//! ```text
//! φ(e) = |e|²/2 − q·e + Σ cᵢ √(|uᵢ|² + σ²),     uᵢ = e's velocity at point i,  cᵢ = μ Nᵢ
//! ```
//!
//! as σ → 0 (it is the dual of the projection; Boyd & Vandenberghe, Convex Optimization, 5.1.6). Each
//! σ takes a few Newton steps, whose matrix 1 + Σ … is at least the unit matrix; then σ shrinks. A
//! wrench that the foot carries has e = 0, which σ reaches with it: φ ≥ 0 there tells it from a slow
//! motion, for which φ = −|e|²/2.
//!
//! All is done in double precision, whatever the scalar: near the kinks of φ the matrix spans more
//! than single precision holds.

use crate::patch::nodes::Node;
use crate::real::Real;
use nalgebra::Vector3;

/// The points, with lengths in units of the norm's own and their share of friction.
pub(super) struct Balance<'a, R: Real> {
    pub(super) nodes: &'a [Node<R>],
    /// 1/length
    pub(super) inv_length: f64,
    /// μN/(sum of weights)
    pub(super) unit: f64,
    /// The wrench q, its torque over the length.
    pub(super) wanted: Vector3<f64>,
}

/// The remainder, and σ at the end.
pub(super) struct Remainder {
    pub(super) left: Vector3<f64>,
    pub(super) smoothing: f64,
    pub(super) is_held: bool,
}

/// First σ in units of |q|.
const FIRST: f64 = 0.25;
/// From one σ to the next.
const SHRINK: f64 = 1.0 / 64.0;
/// A Newton step shorter than this share of e or σ is the last for its σ.
const CONVERGED: f64 = 1e-3;
/// σ/|e| at which points at rest count as such: σ is the width of their turning about.
const SHARP: f64 = 1e-9;
/// Rounding errors of |q| below which e counts as none.
const HELD_ULPS: f64 = 16.0;
/// Newton steps in all; fewer than 60 were seen.
const MOST_STEPS: usize = 120;
/// Halvings of a step.
const MOST_HALVINGS: usize = 40;
/// Rounding of φ, whose terms are of the size |q| |e|, in rounding errors.
const ROUNDING_ULPS: f64 = 32.0;
/// Share of the linear decrease that a step must bring.
const ENOUGH: f64 = 0.1;

/// Gradient and matrix of φ.
struct Model {
    gradient: Vector3<f64>,
    /// xx, xy, yy, xn, yn, nn
    matrix: [f64; 6],
}

impl<R: Real> Balance<'_, R> {
    /// Finds the remainder of a wrench of the given `size` = |q|, finite and positive.
    pub(super) fn solve(&self, size: f64) -> Remainder {
        let mut left = self.wanted;
        let mut smoothing = FIRST * size;
        let none = HELD_ULPS * R::EPSILON.to_f64() * size;
        for _ in 0..MOST_STEPS {
            let (next, step) = self.newton(&left, smoothing);
            left = next;
            let length = norm(&left);
            if length <= none {
                break;
            }
            let unsettled = step > CONVERGED * length && step > CONVERGED * smoothing;
            if unsettled {
                continue;
            }
            if smoothing <= SHARP * length {
                if step <= HELD_ULPS * f64::EPSILON * size {
                    break;
                }
            } else {
                smoothing *= SHRINK;
            }
        }
        let moves = self.potential(&left, 0.0) < 0.0;
        let is_held = norm(&left) <= none || !moves;
        Remainder {
            left,
            smoothing,
            is_held,
        }
    }

    /// One damped step; returns where it leads and how long it is.
    fn newton(&self, from: &Vector3<f64>, smoothing: f64) -> (Vector3<f64>, f64) {
        let Model { gradient, matrix } = self.model(from, smoothing);
        let step = solved(&matrix, &(-gradient));
        let slope = gradient.x * step.x + gradient.y * step.y + gradient.z * step.z;
        let start = self.potential(from, smoothing);
        // Near the end φ falls by less than it rounds: then every step is taken.
        let rounding = ROUNDING_ULPS * f64::EPSILON * norm(&self.wanted) * norm(from);
        let mut share = 1.0;
        for _ in 0..MOST_HALVINGS {
            let enough = start + ENOUGH * share * slope + rounding;
            if self.potential(&(from + step * share), smoothing) <= enough {
                break;
            }
            share *= 0.5;
        }
        (from + step * share, norm(&step) * share)
    }

    /// A point in units of the norm's length.
    #[inline]
    fn place(&self, node: &Node<R>) -> [f64; 2] {
        [node.x, node.y].map(|x| x.to_f64() * self.inv_length)
    }

    /// Velocity of a point, and √(|u|² + σ²).
    #[inline]
    fn motion(&self, node: &Node<R>, e: &Vector3<f64>, smoothing: f64) -> [f64; 3] {
        let [x, y] = self.place(node);
        let u = [e.x - e.z * y, e.y + e.z * x];
        // By the trait's name: the method's could be that of the platform.
        let speed = Real::hypot(Real::hypot(u[0], u[1]), smoothing);
        [u[0], u[1], speed]
    }

    /// φ
    fn potential(&self, e: &Vector3<f64>, smoothing: f64) -> f64 {
        let [x, y, z] = [self.wanted.x, self.wanted.y, self.wanted.z];
        let own = 0.5 * (e.x * e.x + e.y * e.y + e.z * e.z);
        let mut sum = own - (x * e.x + y * e.y + z * e.z);
        for node in self.nodes {
            let [_, _, speed] = self.motion(node, e, smoothing);
            sum += self.unit * node.weight.to_f64() * (speed - smoothing);
        }
        sum
    }

    fn model(&self, e: &Vector3<f64>, smoothing: f64) -> Model {
        let mut gradient = e - self.wanted;
        let mut matrix = [1.0, 0.0, 1.0, 0.0, 0.0, 1.0];
        for node in self.nodes {
            let [ux, uy, speed] = self.motion(node, e, smoothing);
            if speed == 0.0 {
                continue;
            }
            let [x, y] = self.place(node);
            let rate = self.unit * node.weight.to_f64() / speed;
            let [fx, fy] = [rate * ux, rate * uy];
            gradient += Vector3::new(fx, fy, x * fy - y * fx);
            // rate (1 − u uᵀ/speed²), moved to the centre.
            let [cx, cy] = [ux / speed, uy / speed];
            let xx = rate * (1.0 - cx * cx);
            let xy = -(rate * cx * cy);
            let yy = rate * (1.0 - cy * cy);
            let [xn, yn] = [x * xy - y * xx, x * yy - y * xy];
            let entries = [xx, xy, yy, xn, yn, x * yn - y * xn];
            for (sum, entry) in matrix.iter_mut().zip(entries) {
                *sum += entry;
            }
        }
        Model { gradient, matrix }
    }

    /// Force of one point at the remainder `e`.
    pub(super) fn force(&self, node: &Node<R>, e: &Vector3<f64>, smoothing: f64) -> [R; 2] {
        let [ux, uy, speed] = self.motion(node, e, smoothing);
        if speed == 0.0 {
            return [R::ZERO; 2];
        }
        let rate = self.unit * node.weight.to_f64() / speed;
        [rate * ux, rate * uy].map(R::from_f64)
    }
}

/// |e| without overflow.
pub(super) fn norm<R: Real>(e: &Vector3<R>) -> R {
    e.x.hypot(e.y).hypot(e.z)
}

/// The solution of a symmetric system whose matrix is at least the unit matrix (L D Lᵀ).
fn solved([xx, xy, yy, xn, yn, nn]: &[f64; 6], right: &Vector3<f64>) -> Vector3<f64> {
    let (a, b) = (*xy / *xx, *xn / *xx);
    let second = *yy - a * *xy;
    let c = (*yn - a * *xn) / second;
    let third = *nn - b * *xn - c * c * second;
    let y = right.y - a * right.x;
    let z = right.z - b * right.x - c * y;
    let z = z / third;
    let y = y / second - c * z;
    Vector3::new(right.x / *xx - a * y - b * z, y, z)
}
