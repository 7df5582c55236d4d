//! The same search where points carry load.
//!
//! The dissipated power D has a kink where the centre of rotation lies on a point, and the limit surface
//! a flat facet with that rotation as its normal: the point's force is anything of its disc. Three
//! things are done beside Newton's steps.
//!
//! - *Facets*. Of the rotation about the point that moves least, its length along the ray of twists is
//!   known in closed form, and so is the force that the point would have to carry; if that is within its
//!   limit, the problem is solved, being convex.
//! - *Leaving a kink*. If it is not, the function falls steepest along that force.
//! - *Polar steps*. Next to a kink the velocity of the point turns by large angles within a step: its
//!   direction and its length are changed by themselves (Newton's step read in polar coordinates).
//!
//! Of all twists that were seen the one with the least value is kept.

use super::quadratic::{Factors, dot, norm};
use super::search::{Ended, Goal, Least, MOST_HALVINGS, Power, pivot, rough};
use crate::real::Real;
use nalgebra::Vector3;

/// A point of contact as the search sees it.
pub(super) struct Kink<R: Real> {
    /// The rotation about it: velocity of the origin, and spin · arm.
    pub(super) turn: Vector3<R>,
    /// Its limit, of the force limit.
    pub(super) share: R,
    /// Place over arm.
    pub(super) place: [R; 2],
}

/// Most steps, each with a look at the nearest point.
const MOST_STEPS: usize = 60;
/// What a facet's point may carry beyond its limit, in rounding errors of the force limit.
const FACET_ULPS: f64 = 32.0;
/// Largest residual that counts as rounding next to a kink, in units of the square root of a rounding
/// error.
const NEAR_KINK: f64 = 8.0;
/// Rounding errors of a residual.
const DONE_ULPS: f64 = 8.0;
/// Least decrease that makes leaving a kink worth it, in rounding errors.
const WORTH_ULPS: f64 = 64.0;
/// Least speed of a point beside the twist, in rounding errors: below, its direction is not known.
const SLOW_ULPS: f64 = 4e5;
/// What is added to the diagonal of Newton's matrix, of the residual.
const DAMPING: f64 = 1e-3;
/// Share of the linear decrease that a step must bring.
const ENOUGH: f64 = 1e-4;
/// Largest angle by which a point's velocity turns in a step.
const LARGEST_ANGLE: f64 = 1.5;

/// The twist at which `goal` is least, from `start` on.
pub(super) fn least<R: Real>(
    goal: &impl Goal<R>,
    start: Vector3<R>,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
    kink_at: impl Fn(&Vector3<R>) -> Option<Kink<R>>,
) -> Least<R> {
    let ulps = |count: f64| R::from_f64(count) * R::EPSILON;
    let mut at = start;
    let mut power = power_at(&at);
    let mut steps = 0;
    while steps < MOST_STEPS {
        let gradient = goal.gradient(&at, &power);
        let size = norm(&gradient);
        if size.is_nan() || size <= ulps(DONE_ULPS) {
            break;
        }
        steps += 1;
        let before = goal.value(&at, power.value);
        let kink = kink_at(&at);
        if let Some(kink) = &kink {
            match beside(goal, kink, &power_at) {
                Beside::Facet(mut found) => {
                    found.steps = steps;
                    return found;
                }
                Beside::Leaves(next, next_power) => {
                    let gain = before - goal.value(&next, next_power.value);
                    if gain > ulps(WORTH_ULPS) * (R::ONE + before.abs()) {
                        (at, power) = (next, next_power);
                        continue;
                    }
                }
                Beside::Nowhere => {}
            }
        }
        let way = Way::new(&at, kink.as_ref());
        // Rounding of the slowest point's direction.
        if let Some(slow) = &way.slow {
            let noise = slow.share * goal.reach(&power) * norm(&at) / slow.speed;
            let most = R::from_f64(NEAR_KINK) * rough::<R>();
            let known = ulps(DONE_ULPS) * noise;
            if size <= if known < most { known } else { most } {
                break;
            }
        }
        // Points in a line leave a direction without curvature.
        let mut matrix = goal.matrix(&power);
        let shift = R::from_f64(DAMPING) * size;
        matrix.m11 += shift;
        matrix.m22 += shift;
        matrix.m33 += shift;
        let step = Factors::of(&matrix, pivot()).solve(&gradient);
        let descent = dot(&gradient, &step);
        let mut factor = R::ONE;
        let mut next = way.along(&step, factor);
        let mut next_power = power_at(&next);
        let slack = ulps(DONE_ULPS) * (R::ONE + before.abs());
        for _ in 0..MOST_HALVINGS {
            let enough = before - R::from_f64(ENOUGH) * factor * descent;
            if goal.value(&next, next_power.value) <= enough + slack {
                break;
            }
            factor = R::HALF * factor;
            next = way.along(&step, factor);
            next_power = power_at(&next);
        }
        let after = goal.value(&next, next_power.value);
        let is_rounding =
            factor == R::ONE && size < rough() && norm(&goal.gradient(&next, &next_power)) >= size;
        if is_rounding || after > before + slack || after.is_nan() {
            break;
        }
        (at, power) = (next, next_power);
    }
    let ended = if steps < MOST_STEPS && !power.value.is_nan() {
        Ended::Rounding
    } else {
        Ended::Missed
    };
    power.gradient = goal.balanced(&at, power.value);
    Least {
        at,
        power,
        steps,
        ended,
        is_flat: false,
    }
}

/// What is found at the rotation about a point.
enum Beside<R: Real> {
    /// The answer.
    Facet(Least<R>),
    /// A twist next to it with a lower value.
    Leaves(Vector3<R>, Power<R>),
    /// The rotation is of no use.
    Nowhere,
}

fn beside<R: Real>(
    goal: &impl Goal<R>,
    kink: &Kink<R>,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
) -> Beside<R> {
    let turn = if dot(goal.wrench(), &kink.turn) < R::ZERO {
        -kink.turn
    } else {
        kink.turn
    };
    // The point itself rests and adds nothing.
    let mut power = power_at(&turn);
    let length = goal.length_along(&turn, power.value);
    if !(length > R::ZERO && length.is_finite()) {
        return Beside::Nowhere;
    }
    let at = turn * length;
    power.value *= length;
    power.hessian *= R::ONE / length;
    let reach = goal.reach(&power);
    let left = goal.gradient(&at, &power);
    let (x, y) = (-(left.x / reach), -(left.y / reach));
    let force = x.hypot(y);
    if force <= kink.share + R::from_f64(FACET_ULPS) * R::EPSILON {
        power.gradient = goal.balanced(&at, power.value);
        return Beside::Facet(Least {
            at,
            power,
            steps: 0,
            ended: Ended::Level,
            is_flat: true,
        });
    }
    // Translation along the force that the point cannot carry.
    let [px, py] = kink.place;
    let (cx, cy) = (x / force, y / force);
    let along = Vector3::new(cx, cy, R::ZERO);
    power.gradient += Vector3::new(cx, cy, px * cy - py * cx) * kink.share;
    let before = goal.value(&at, power.value);
    let slope = (force - kink.share) * reach;
    let matrix = goal.matrix(&power);
    let bend = matrix.m11 * cx * cx + R::TWO * matrix.m12 * cx * cy + matrix.m22 * cy * cy;
    let mut by = slope / bend;
    for _ in 0..MOST_HALVINGS {
        let next = at + along * by;
        let next_power = power_at(&next);
        if goal.value(&next, next_power.value) < before - R::from_f64(ENOUGH) * by * slope {
            return Beside::Leaves(next, next_power);
        }
        by = R::HALF * by;
    }
    Beside::Nowhere
}

/// From a twist along a step, which changes the velocity of the slowest point in polar coordinates.
struct Way<R: Real> {
    at: Vector3<R>,
    slow: Option<Slow<R>>,
}

/// The slowest point.
struct Slow<R: Real> {
    place: [R; 2],
    share: R,
    speed: R,
    /// Direction of its velocity.
    direction: [R; 2],
    least: R,
}

impl<R: Real> Way<R> {
    fn new(at: &Vector3<R>, kink: Option<&Kink<R>>) -> Self {
        let slow = kink.and_then(|kink| {
            let [x, y] = velocity(at, &kink.place);
            let speed = x.hypot(y);
            (speed > R::ZERO).then(|| Slow {
                place: kink.place,
                share: kink.share,
                speed,
                direction: [x / speed, y / speed],
                least: R::from_f64(SLOW_ULPS) * R::EPSILON * norm(at),
            })
        });
        Self { at: *at, slow }
    }

    /// The twist less `factor` · `step`.
    fn along(&self, step: &Vector3<R>, factor: R) -> Vector3<R> {
        let Some(slow) = &self.slow else {
            return self.at - step * factor;
        };
        let [x, y] = velocity(step, &slow.place);
        let [cx, cy] = slow.direction;
        let (longer, turned) = (-(x * cx + y * cy), -(y * cx - x * cy) / slow.speed);
        let most = R::from_f64(LARGEST_ANGLE);
        let factor = if factor * turned.abs() > most {
            most / turned.abs()
        } else {
            factor
        };
        let mut speed = slow.speed + factor * longer;
        let shortest = R::from_f64(1.0 / 16.0) * slow.speed;
        if speed < shortest {
            speed = shortest;
        }
        if speed < slow.least {
            speed = slow.least;
        }
        let angle = factor * turned;
        let (c, s) = (angle.cos(), angle.sin());
        let (x, y) = (speed * (c * cx - s * cy), speed * (s * cx + c * cy));
        let turn = self.at.z - factor * step.z;
        let [px, py] = slow.place;
        Vector3::new(x + turn * py, y - turn * px, turn)
    }
}

/// Velocity of a point under a twist.
fn velocity<R: Real>(at: &Vector3<R>, [x, y]: &[R; 2]) -> [R; 2] {
    [at.x - at.z * *y, at.y + at.z * *x]
}
