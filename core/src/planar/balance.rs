//! The remainder of a wrench after the friction of many points: a smooth problem in three unknowns.
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
//! φ has a kink where the foot turns about one of its points. There e is known in closed form but
//! for the point, and whether φ is least there is a question to the force that the point would have
//! to carry. Next to a kink the unknowns are the velocity of the point that moves least, and the
//! spin: of these the kink is a function of two alone, whatever is left of its σ, and neither the
//! matrix nor the differences of φ lose digits to it.
//!
//! All is done in double precision, whatever the scalar: near the kinks of φ the matrix spans more
//! than single precision holds.

use crate::patch::nodes::Node;
use crate::real::Real;
use nalgebra::Vector3;

/// The points, with lengths in units of the norm's own and their share of friction; forces in a unit that
/// makes the wrench one of order 1.
pub(super) struct Balance<'a, R: Real> {
    pub(super) nodes: &'a [Node<R>],
    /// 1/length
    pub(super) inv_length: f64,
    /// μN/(sum of weights)
    pub(super) unit: f64,
    /// The wrench q, its torque over the length.
    pub(super) wanted: Vector3<f64>,
}

/// The motion of the remainder, wherever the search ended.
pub(super) struct Remainder {
    pub(super) motion: Motion,
    /// False where the motion proves that the foot slides: φ < 0.
    pub(super) is_held: bool,
}

/// e as a motion: the velocity of one point and the spin, with σ.
pub(super) struct Motion {
    /// The point, in units of length.
    origin: [f64; 2],
    /// Its velocity and the spin.
    at: Vector3<f64>,
    smoothing: f64,
    /// Force on a point that does not move, of its limit.
    at_rest: [f64; 2],
}

impl Motion {
    /// e, whose planar part is the velocity at the centre.
    fn left(&self) -> Vector3<f64> {
        moved([-self.origin[0], -self.origin[1]], &self.at)
    }
}

/// A motion given at one point, at the point `by` away.
#[inline]
fn moved(by: [f64; 2], at: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(at.x - at.z * by[1], at.y + at.z * by[0], at.z)
}

/// First σ in units of |q|.
const FIRST: f64 = 0.25;
/// From one σ to the next.
const SHRINK: f64 = 1.0 / 64.0;
/// A Newton step shorter than this share of e or σ is the last for its σ.
const CONVERGED: f64 = 1e-3;
/// The same for the slowest point, of its velocity or σ.
const TRACKED: f64 = 0.1;
/// σ/|e| at which the point is chosen whose velocity is an unknown.
const ROUGH: f64 = 1e-5;
/// σ/|e| at the end.
const SHARP: f64 = 1e-20;
/// Rounding errors of |q| below which e counts as none.
const HELD_ULPS: f64 = 16.0;
/// Rounding errors of |q| that the forces may leave of a wrench that is held.
const BALANCED_ULPS: f64 = 32.0;
/// Share of |q| below which rounding may be all that they leave, and steps that leave no less before it counts as that.
const NEAR: f64 = 1e-8;
const MOST_STALLS: u32 = 8;
/// Newton steps in all; 60 to 150 were seen, and more only within 1e-10 of the limit.
const MOST_STEPS: usize = 200;
/// Halvings of a step.
const MOST_HALVINGS: usize = 40;
/// Rounding of a difference of φ, whose terms are of the size |q| times the step.
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
        let mut motion = Motion {
            origin: [0.0; 2],
            at: self.wanted,
            smoothing: FIRST * size,
            at_rest: [0.0; 2],
        };
        let mut is_rough = true;
        let none = HELD_ULPS * R::EPSILON.to_f64() * size;
        let enough = BALANCED_ULPS * R::EPSILON.to_f64() * size;
        let (mut least, mut stalls) = (f64::INFINITY, 0);
        for _ in 0..MOST_STEPS {
            let model = self.model(&motion);
            // Without e the forces alone must balance the wrench; σ tells them from each other.
            if norm(&motion.left()) <= none {
                let unbalanced = norm(&model.gradient);
                if unbalanced < least {
                    least = unbalanced;
                } else if unbalanced <= NEAR * size {
                    stalls += 1;
                }
                if unbalanced <= enough || stalls == MOST_STALLS {
                    break;
                }
            }
            let step = self.newton(&mut motion, &model);
            let length = norm(&motion.left());
            if length <= none {
                continue;
            }
            let whole = norm(&step);
            let is_unsettled = whole > CONVERGED * length && whole > CONVERGED * motion.smoothing;
            // The slowest point's velocity counts by its own size.
            let part = Real::hypot(step.x, step.y);
            let own = Real::hypot(Real::hypot(motion.at.x, motion.at.y), motion.smoothing);
            let is_turning = !is_rough && part > TRACKED * own && part > f64::EPSILON * size;
            if is_unsettled || is_turning {
                continue;
            }
            if motion.smoothing <= ROUGH * length {
                is_rough = false;
                self.recentre_on_slowest_point(&mut motion);
                if let Some(turn) = self.turning_about(motion.origin, size) {
                    motion = turn;
                    break;
                }
            }
            if motion.smoothing > SHARP * length {
                motion.smoothing *= SHRINK;
            } else if whole <= HELD_ULPS * f64::EPSILON * size {
                break;
            }
        }
        let left = motion.left();
        let is_held = norm(&left) <= none || !self.moves(&left);
        Remainder { motion, is_held }
    }

    /// Makes the velocity of the slowest point an unknown.
    fn recentre_on_slowest_point(&self, motion: &mut Motion) {
        let mut least = f64::INFINITY;
        let mut slowest = motion.origin;
        for node in self.nodes {
            let [ux, uy] = self.velocity(node, motion.origin, &motion.at);
            let speed = Real::hypot(ux, uy);
            if speed < least {
                least = speed;
                slowest = self.place(node);
            }
        }
        let by = [slowest[0] - motion.origin[0], slowest[1] - motion.origin[1]];
        motion.at = moved(by, &motion.at);
        motion.origin = slowest;
    }

    /// The motion about the point at `origin`, if that is where φ is least: its spin balances what is
    /// beyond the torque of all other points, and the force that is left is within the point's own.
    fn turning_about(&self, origin: [f64; 2], size: f64) -> Option<Motion> {
        let [ox, oy] = origin;
        // e = z d; along d every |uᵢ| is |z| times the distance from the point.
        let d = Vector3::new(oy, -ox, 1.0);
        let [mut own, mut torque] = [0.0; 2];
        let mut force = [self.wanted.x, self.wanted.y];
        let pull = self.wanted.x * d.x + self.wanted.y * d.y + self.wanted.z;
        let sense = 1.0_f64.copysign(pull);
        for node in self.nodes {
            let [x, y] = self.place(node);
            let [x, y] = [x - ox, y - oy];
            let (far, limit) = (Real::hypot(x, y), self.unit * node.weight.to_f64());
            if far == 0.0 {
                own += limit;
                continue;
            }
            torque += limit * far;
            force[0] += limit * sense * (y / far);
            force[1] -= limit * sense * (x / far);
        }
        let spin = sense * (pull.abs() - torque) / (d.x * d.x + d.y * d.y + 1.0);
        let force = [force[0] - spin * d.x, force[1] - spin * d.y];
        let rounding = HELD_ULPS * f64::EPSILON * size;
        let asked = Real::hypot(force[0], force[1]);
        let rests = asked <= own + rounding;
        let most = if asked > own { asked } else { own };
        (pull.abs() > torque && rests && own > 0.0).then_some(Motion {
            origin,
            at: Vector3::new(0.0, 0.0, spin),
            smoothing: 0.0,
            at_rest: force.map(|part| part / most),
        })
    }

    /// Takes one damped step.
    fn newton(&self, motion: &mut Motion, Model { gradient, matrix }: &Model) -> Vector3<f64> {
        let step = solved(matrix, &(-gradient));
        let slope = gradient.x * step.x + gradient.y * step.y + gradient.z * step.z;
        // Near the end φ falls by less than it rounds: then every step is taken.
        let rounding = ROUNDING_ULPS * f64::EPSILON * norm(&self.wanted) * norm(&step);
        let mut share = 1.0;
        for _ in 0..MOST_HALVINGS {
            let enough = (ENOUGH * slope + rounding) * share;
            if self.change(motion, &(step * share)) <= enough {
                break;
            }
            share *= 0.5;
        }
        let step = step * share;
        motion.at += step;
        step
    }

    /// A point in units of the norm's length.
    #[inline]
    fn place(&self, node: &Node<R>) -> [f64; 2] {
        [node.x, node.y].map(|x| x.to_f64() * self.inv_length)
    }

    /// Velocity of a point under a motion given at `origin`.
    #[inline]
    fn velocity(&self, node: &Node<R>, origin: [f64; 2], at: &Vector3<f64>) -> [f64; 2] {
        let [x, y] = self.place(node);
        let u = moved([x - origin[0], y - origin[1]], at);
        [u.x, u.y]
    }

    /// Velocity of a point, and √(|u|² + σ²).
    #[inline]
    fn speeds(&self, node: &Node<R>, motion: &Motion) -> [f64; 3] {
        let [ux, uy] = self.velocity(node, motion.origin, &motion.at);
        // By the trait's name: the method's could be that of the platform.
        let speed = Real::hypot(Real::hypot(ux, uy), motion.smoothing);
        [ux, uy, speed]
    }

    /// By how much φ changes with a step, each term from its own difference.
    fn change(&self, motion: &Motion, step: &Vector3<f64>) -> f64 {
        let by = [-motion.origin[0], -motion.origin[1]];
        let (from, more) = (moved(by, &motion.at), moved(by, step));
        let [x, y, z] = [0, 1, 2].map(|n| (from[n] - self.wanted[n] + 0.5 * more[n]) * more[n]);
        let mut sum = x + y + z;
        let after = Motion {
            at: motion.at + step,
            ..*motion
        };
        for node in self.nodes {
            let [ux, uy, before] = self.speeds(node, motion);
            let [.., after] = self.speeds(node, &after);
            let [dx, dy] = self.velocity(node, motion.origin, step);
            let both = before + after;
            if both > 0.0 {
                let along = dx / both * (2.0 * ux + dx) + dy / both * (2.0 * uy + dy);
                sum += self.unit * node.weight.to_f64() * along;
            }
        }
        sum
    }

    /// True if φ(e) < 0 without smoothing, as it is where the foot slides.
    fn moves(&self, e: &Vector3<f64>) -> bool {
        let [x, y, z] = [0, 1, 2].map(|n| (0.5 * e[n] - self.wanted[n]) * e[n]);
        let mut sum = x + y + z;
        for node in self.nodes {
            let [ux, uy] = self.velocity(node, [0.0; 2], e);
            sum += self.unit * node.weight.to_f64() * Real::hypot(ux, uy);
        }
        sum < 0.0
    }

    fn model(&self, motion: &Motion) -> Model {
        let [ox, oy] = motion.origin;
        // |e|²/2 − q·e in the velocity of the origin and the spin.
        let rest = motion.left() - self.wanted;
        let mut gradient = Vector3::new(rest.x, rest.y, rest.z + oy * rest.x - ox * rest.y);
        let mut matrix = [1.0, 0.0, 1.0, oy, -ox, 1.0 + ox * ox + oy * oy];
        for node in self.nodes {
            let [ux, uy, speed] = self.speeds(node, motion);
            if speed == 0.0 {
                continue;
            }
            let [x, y] = self.place(node);
            let [x, y] = [x - ox, y - oy];
            let rate = self.unit * node.weight.to_f64() / speed;
            let [fx, fy] = [rate * ux, rate * uy];
            gradient += Vector3::new(fx, fy, x * fy - y * fx);
            // rate (1 − u uᵀ/speed²), moved to the origin.
            let [cx, cy, s] = [ux, uy, motion.smoothing].map(|part| part / speed);
            let xx = rate * (cy * cy + s * s);
            let xy = -(rate * cx * cy);
            let yy = rate * (cx * cx + s * s);
            let [xn, yn] = [x * xy - y * xx, x * yy - y * xy];
            let entries = [xx, xy, yy, xn, yn, x * yn - y * xn];
            for (sum, entry) in matrix.iter_mut().zip(entries) {
                *sum += entry;
            }
        }
        Model { gradient, matrix }
    }

    /// What the points carry under a motion, each within its own disc; `tell` hears the force of each in turn.
    ///
    /// The direction of a point that hardly moves is rounding, and then the balance knows its force better.
    pub(super) fn carried(
        &self,
        motion: &Motion,
        mut tell: impl FnMut(usize, [f64; 2]),
    ) -> Vector3<f64> {
        let mut sum = Vector3::new(0.0, 0.0, 0.0);
        let mut slowest = None;
        let mut least = f64::INFINITY;
        for (index, node) in self.nodes.iter().enumerate() {
            let (force, wrench) = self.force(node, motion);
            tell(index, force);
            sum += wrench;
            let [.., speed] = self.speeds(node, motion);
            if speed < least {
                least = speed;
                slowest = Some((index, node, force));
            }
        }
        let Some((index, node, [fx, fy])) = slowest else {
            return sum;
        };
        let left = motion.left();
        let limit = self.unit * node.weight.to_f64();
        if limit * norm(&left) <= least * norm(&self.wanted) {
            return sum;
        }
        let rest = self.wanted - left - sum;
        let (x, y) = (fx + rest.x, fy + rest.y);
        let size = Real::hypot(x, y);
        let share = if size > limit { limit / size } else { 1.0 };
        let force = [x * share, y * share];
        tell(index, force);
        let [x, y] = self.place(node);
        let [dx, dy] = [force[0] - fx, force[1] - fy];
        sum + Vector3::new(dx, dy, x * dy - y * dx)
    }

    /// Force of one point under a motion, within its disc, and the wrench of it.
    fn force(&self, node: &Node<R>, motion: &Motion) -> ([f64; 2], Vector3<f64>) {
        let [ux, uy, speed] = self.speeds(node, motion);
        let limit = self.unit * node.weight.to_f64();
        let [x, y] = self.place(node);
        let [fx, fy] = if speed == 0.0 {
            motion.at_rest.map(|part| limit * part)
        } else {
            let rate = limit / speed;
            [rate * ux, rate * uy]
        };
        ([fx, fy], Vector3::new(fx, fy, x * fy - y * fx))
    }
}

/// |e| without overflow.
pub(super) fn norm<R: Real>(e: &Vector3<R>) -> R {
    e.x.hypot(e.y).hypot(e.z)
}

/// The solution of a symmetric system (L D Lᵀ) whose matrix exceeds |e|² in the unknowns: no pivot is
/// below 1 but by rounding.
fn solved([xx, xy, yy, xn, yn, nn]: &[f64; 6], right: &Vector3<f64>) -> Vector3<f64> {
    let at_least_one = |pivot: f64| if pivot < 1.0 { 1.0 } else { pivot };
    let (a, b) = (*xy / *xx, *xn / *xx);
    let second = at_least_one(*yy - a * *xy);
    let c = (*yn - a * *xn) / second;
    let third = at_least_one(*nn - b * *xn - c * c * second);
    let y = right.y - a * right.x;
    let z = right.z - b * right.x - c * y;
    let z = z / third;
    let y = y / second - c * z;
    Vector3::new(right.x / *xx - a * y - b * z, y, z)
}
