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

use crate::patch::nodes::Node;
use crate::real::Real;
use nalgebra::Vector3;

/// The points, with lengths in units of the norm's own and their share of friction.
pub(super) struct Balance<'a, R: Real> {
    pub(super) nodes: &'a [Node<R>],
    /// 1/length
    pub(super) inv_length: R,
    /// μN/(sum of weights)
    pub(super) unit: R,
    /// The wrench q, its torque over the length.
    pub(super) wanted: Vector3<R>,
}

/// The remainder, and σ at the end.
pub(super) struct Remainder<R: Real> {
    pub(super) left: Vector3<R>,
    pub(super) smoothing: R,
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
struct Model<R: Real> {
    gradient: Vector3<R>,
    /// xx, xy, yy, xn, yn, nn
    matrix: [R; 6],
}

impl<R: Real> Balance<'_, R> {
    /// Finds the remainder of a wrench of the given `size` = |q|, finite and positive.
    pub(super) fn solve(&self, size: R) -> Remainder<R> {
        let real = R::from_f64;
        let mut left = self.wanted;
        let mut smoothing = real(FIRST) * size;
        let none = real(HELD_ULPS) * R::EPSILON * size;
        let sharp = if R::EPSILON > real(SHARP) {
            R::EPSILON
        } else {
            real(SHARP)
        };
        for _ in 0..MOST_STEPS {
            let (next, step) = self.newton(&left, smoothing);
            left = next;
            let length = norm(&left);
            if length <= none {
                break;
            }
            let unsettled = step > real(CONVERGED) * length && step > real(CONVERGED) * smoothing;
            if unsettled {
                continue;
            }
            if smoothing <= sharp * length {
                if step <= none {
                    break;
                }
            } else {
                smoothing *= real(SHRINK);
            }
        }
        let moves = self.potential(&left, R::ZERO) < R::ZERO;
        let is_held = norm(&left) <= none || !moves;
        Remainder {
            left,
            smoothing,
            is_held,
        }
    }

    /// One damped step; returns where it leads and how long it is.
    fn newton(&self, from: &Vector3<R>, smoothing: R) -> (Vector3<R>, R) {
        let Model { gradient, matrix } = self.model(from, smoothing);
        let step = solved(&matrix, &(-gradient));
        let slope = gradient.x * step.x + gradient.y * step.y + gradient.z * step.z;
        let start = self.potential(from, smoothing);
        // Near the end φ falls by less than it rounds: then every step is taken.
        let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON * norm(&self.wanted) * norm(from);
        let mut share = R::ONE;
        for _ in 0..MOST_HALVINGS {
            let enough = start + R::from_f64(ENOUGH) * share * slope + rounding;
            if self.potential(&(from + step * share), smoothing) <= enough {
                break;
            }
            share *= R::HALF;
        }
        (from + step * share, norm(&step) * share)
    }

    /// Velocity of a point, and √(|u|² + σ²).
    #[inline]
    fn motion(&self, node: &Node<R>, e: &Vector3<R>, smoothing: R) -> [R; 3] {
        let [x, y] = [node.x * self.inv_length, node.y * self.inv_length];
        let u = [e.x - e.z * y, e.y + e.z * x];
        let speed = u[0].hypot(u[1]);
        [u[0], u[1], speed.hypot(smoothing)]
    }

    /// φ
    fn potential(&self, e: &Vector3<R>, smoothing: R) -> R {
        let [x, y, z] = [self.wanted.x, self.wanted.y, self.wanted.z];
        let own = R::HALF * (e.x * e.x + e.y * e.y + e.z * e.z);
        let mut sum = own - (x * e.x + y * e.y + z * e.z);
        for node in self.nodes {
            let [_, _, speed] = self.motion(node, e, smoothing);
            sum += self.unit * node.weight * (speed - smoothing);
        }
        sum
    }

    fn model(&self, e: &Vector3<R>, smoothing: R) -> Model<R> {
        let mut gradient = e - self.wanted;
        let mut matrix = [R::ONE, R::ZERO, R::ONE, R::ZERO, R::ZERO, R::ONE];
        for node in self.nodes {
            let [ux, uy, speed] = self.motion(node, e, smoothing);
            if speed == R::ZERO {
                continue;
            }
            let [x, y] = [node.x * self.inv_length, node.y * self.inv_length];
            let rate = self.unit * node.weight / speed;
            let [fx, fy] = [rate * ux, rate * uy];
            gradient += Vector3::new(fx, fy, x * fy - y * fx);
            // rate (1 − u uᵀ/speed²), moved to the centre.
            let [cx, cy] = [ux / speed, uy / speed];
            let xx = rate * (R::ONE - cx * cx);
            let xy = -(rate * cx * cy);
            let yy = rate * (R::ONE - cy * cy);
            let [xn, yn] = [x * xy - y * xx, x * yy - y * xy];
            let entries = [xx, xy, yy, xn, yn, x * yn - y * xn];
            for (sum, entry) in matrix.iter_mut().zip(entries) {
                *sum += entry;
            }
        }
        Model { gradient, matrix }
    }

    /// Force of one point at the remainder `e`.
    pub(super) fn force(&self, node: &Node<R>, e: &Vector3<R>, smoothing: R) -> [R; 2] {
        let [ux, uy, speed] = self.motion(node, e, smoothing);
        if speed == R::ZERO {
            return [R::ZERO; 2];
        }
        let rate = self.unit * node.weight / speed;
        [rate * ux, rate * uy]
    }
}

/// |e| without overflow.
pub(super) fn norm<R: Real>(e: &Vector3<R>) -> R {
    e.x.hypot(e.y).hypot(e.z)
}

/// The solution of a symmetric system whose matrix is at least the unit matrix (L D Lᵀ).
fn solved<R: Real>([xx, xy, yy, xn, yn, nn]: &[R; 6], right: &Vector3<R>) -> Vector3<R> {
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
