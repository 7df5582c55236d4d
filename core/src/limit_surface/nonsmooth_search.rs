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
//! Of all twists that were seen the one with the least value is kept. Its wrench is a sum of forces of which
//! each lies within its own disc: it belongs to the set wherever the search ends, and as the friction of a
//! twist next to the right one it is as far from the right wrench as the balance is from zero, or nearer.

use super::quadratic::{Factors, dot, norm};
use super::search::{
    Ended, MOST_HALVINGS, Minimiser, Power, TwistObjective, ended_at, pivot, rounding_gradient,
};
use crate::real::Real;
use nalgebra::Vector3;

/// A point of contact as the search sees it.
pub(super) struct NonsmoothPoint<R: Real> {
    /// The rotation about it: velocity of the origin, and spin · arm.
    pub(super) turn: Vector3<R>,
    /// Its limit, of the force limit.
    pub(super) share: R,
    /// Place over arm.
    pub(super) place: [R; 2],
}

impl<R: Real> NonsmoothPoint<R> {
    /// A force at the point.
    fn wrench(&self, [fx, fy]: [R; 2]) -> Vector3<R> {
        let [x, y] = self.place;
        Vector3::new(fx, fy, x * fy - y * fx)
    }
}

/// Most steps, each with a look at the nearest point.
const MOST_STEPS: usize = 60;
/// What a facet's point may be asked for beyond its limit, in rounding errors of the balance.
const FACET_ULPS: f64 = 32.0;
/// Largest residual that counts as rounding next to a kink, in units of the square root of a rounding
/// error.
const NEAR_KINK: f64 = 8.0;
/// Rounding errors of a residual.
const DONE_ULPS: f64 = 8.0;
/// Least decrease that makes leaving a kink worth it, in rounding errors.
const WORTH_ULPS: f64 = 64.0;
/// Least speed of a point beside the twist, in rounding errors of double and of single precision: below,
/// its direction is not known.
const SLOW_ULPS: [f64; 2] = [4e5, 256.0];
/// Distance of a point from the centre of rotation below which it should rest and does not, in rounding
/// errors of the arm: the patch's own coordinates round by that much.
const RESTLESS_ULPS: f64 = 4096.0;
/// What is added to the diagonal of Newton's matrix, of the goal's own part of it and of a residual
/// below 1.
const DAMPING: f64 = 1e-3;
/// Share of the linear decrease that a step must bring.
const ENOUGH: f64 = 1e-4;
/// Speed of a point, in units of its share, up to which its direction is an unknown of its own: the bend of
/// its power over that of the goal's own part is 1/16 there.
const FELT: f64 = 16.0;
/// Largest angle by which a point's velocity turns in a step.
const LARGEST_ANGLE: f64 = 1.5;

/// The rotation about a point whose force lies on the rim of its disc.
struct Rim<R: Real> {
    at: Vector3<R>,
    power: Power<R>,
    /// What the point is asked for beyond its limit: all that the balance leaves.
    left: R,
}

/// The twist at which `goal` is least, from `start` on.
pub(super) fn minimise<R: Real>(
    goal: &impl TwistObjective<R>,
    start: Vector3<R>,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
    kink_at: impl Fn(&Vector3<R>) -> Option<NonsmoothPoint<R>>,
) -> Minimiser<R> {
    let ulps = |count: f64| R::from_f64(count) * R::EPSILON;
    let mut at = start;
    let mut power = power_at(&at);
    let mut steps = 0;
    let mut rim: Option<Rim<R>> = None;
    while steps < MOST_STEPS {
        let gradient = goal.gradient(&at, &power);
        let size = norm(&gradient);
        if size.is_nan() || size <= ulps(DONE_ULPS) {
            break;
        }
        steps += 1;
        let before = goal.value(&at, power.value);
        // The twist may be short: of a wrench far outside that of the nearest wrench is, in units of that wrench.
        let terms = goal.terms(&at, power.value);
        let kink = kink_at(&at);
        if let Some(kink) = &kink {
            match beside(goal, kink, &power_at) {
                NonsmoothProbe::Facet(mut found) => {
                    found.steps = steps;
                    return found;
                }
                NonsmoothProbe::Leaves(from, next) => {
                    if rim.as_ref().is_none_or(|rim| from.left < rim.left) {
                        rim = Some(from);
                    }
                    if let Some((next, next_power)) = next {
                        let gain = before - goal.value(&next, next_power.value);
                        let worth = ulps(WORTH_ULPS) * terms;
                        let is_closer = norm(&goal.gradient(&next, &next_power)) < size;
                        if gain > worth || (gain >= -worth && is_closer) {
                            (at, power) = (next, next_power);
                            continue;
                        }
                    }
                }
                NonsmoothProbe::Nowhere => {}
            }
        }
        // A gradient that may be rounding: in units of the set's wrenches, but for what the wanted one rounds by.
        let reach = goal.reach(&power);
        let unit = if reach < R::ONE { reach } else { R::ONE };
        let rough = rounding_gradient::<R>() * unit + ulps(DONE_ULPS);
        let way = TwistLine::new(&at, kink.as_ref(), reach);
        // Rounding of the slowest point's direction.
        if let Some(slow) = &way.slow {
            let noise = slow.share * reach * norm(&at) / slow.speed;
            let most = R::from_f64(NEAR_KINK) * rough;
            let known = ulps(DONE_ULPS) * noise;
            if size <= if known < most { known } else { most } {
                break;
            }
        }
        // Points in a line leave a direction without curvature.
        let mut matrix = goal.matrix(&power);
        let shift = R::from_f64(DAMPING) * if size < R::ONE { size } else { R::ONE };
        matrix.m11 += shift;
        matrix.m22 += shift;
        matrix.m33 += shift * goal.spin_weight();
        let step = Factors::of(&matrix, pivot()).solve(&gradient);
        let descent = dot(&gradient, &step);
        let mut factor = R::ONE;
        let mut next = way.along(&step, factor);
        let mut next_power = power_at(&next);
        let slack = ulps(DONE_ULPS) * terms;
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
            factor == R::ONE && size < rough && norm(&goal.gradient(&next, &next_power)) >= size;
        if is_rounding || after > before + slack || after.is_nan() {
            break;
        }
        (at, power) = (next, next_power);
    }
    // Next to a kink the balance tells the force of a point better than its motion.
    let mut left = norm(&goal.gradient(&at, &power));
    if left > ulps(DONE_ULPS)
        && let Some(kink) = kink_at(&at)
        && let Some(gradient) = balanced(goal, &at, &power, &kink, &power_at)
    {
        let carried = Power { gradient, ..power };
        let closer = norm(&goal.gradient(&at, &carried));
        if closer < left {
            (power, left) = (carried, closer);
        }
    }
    if let Some(rim) = rim.filter(|rim| rim.left < left) {
        (at, power, left) = (rim.at, rim.power, rim.left);
    }
    let ended = ended_at(left);
    Minimiser {
        at,
        power,
        steps,
        ended,
        is_flat: false,
    }
}

/// The wrench of the surface at a twist next to the rotation about a point: that of all other points, and the
/// force on the rim of the point's disc that the balance asks for. `None` where the motion tells it better.
fn balanced<R: Real>(
    goal: &impl TwistObjective<R>,
    at: &Vector3<R>,
    power: &Power<R>,
    kink: &NonsmoothPoint<R>,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
) -> Option<Vector3<R>> {
    let [x, y] = velocity(at, &kink.place);
    let speed = x.hypot(y);
    let reach = goal.reach(power);
    // Rounding of the point's direction against that of the balance.
    let is_slow = kink.share * reach * norm(at) > speed * largest_term(goal, reach);
    if !(is_slow && speed > R::ZERO) {
        return None;
    }
    let spin = at.z.abs();
    let others = if speed <= rounding_gradient::<R>() * spin {
        let (_, turn) = rotation(kink, at.z, power_at)?;
        let (h, dx, dy) = (&turn.hessian, x / spin, y / spin);
        let by = |a, b| a * dx + b * dy;
        turn.gradient + Vector3::new(by(h.m11, h.m12), by(h.m21, h.m22), by(h.m31, h.m32))
    } else {
        power.gradient - kink.wrench([x / speed, y / speed]) * kink.share
    };
    let rest = Power {
        gradient: others,
        ..*power
    };
    let left = goal.gradient(at, &rest);
    let size = left.x.hypot(left.y);
    let force = [-(left.x / size), -(left.y / size)];
    (size > R::ZERO).then(|| others + kink.wrench(force) * kink.share)
}

/// What the balance rounds by, over the rounding error.
fn largest_term<R: Real>(goal: &impl TwistObjective<R>, reach: R) -> R {
    let wrench = norm(goal.wrench());
    if wrench > reach { wrench } else { reach }
}

/// The rotation about a point in the sense of `spin`, and the power of all others: the point itself rests and
/// adds nothing. `None` if it does not rest in the coordinates of its patch.
fn rotation<R: Real>(
    kink: &NonsmoothPoint<R>,
    spin: R,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
) -> Option<(Vector3<R>, Power<R>)> {
    let turn = kink.turn * R::ONE.copysign(spin);
    let power = power_at(&turn);
    let bend = power.hessian.m11 + power.hessian.m22;
    let least = R::from_f64(RESTLESS_ULPS) * R::EPSILON;
    (bend * least <= kink.share).then_some((turn, power))
}

/// What is found at the rotation about a point.
enum NonsmoothProbe<R: Real> {
    /// The answer.
    Facet(Minimiser<R>),
    /// The rotation with the most that the point carries, and a twist next to it that is better.
    Leaves(Rim<R>, Option<(Vector3<R>, Power<R>)>),
    /// The rotation is of no use.
    Nowhere,
}

fn beside<R: Real>(
    goal: &impl TwistObjective<R>,
    kink: &NonsmoothPoint<R>,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
) -> NonsmoothProbe<R> {
    let sense = dot(goal.wrench(), &kink.turn);
    let Some((turn, mut power)) = rotation(kink, sense, &power_at) else {
        return NonsmoothProbe::Nowhere;
    };
    let length = goal.length_along(&turn, power.value);
    if !(length > R::ZERO && length.is_finite()) {
        return NonsmoothProbe::Nowhere;
    }
    let at = turn * length;
    power.value *= length;
    power.hessian *= R::ONE / length;
    let reach = goal.reach(&power);
    let left = goal.gradient(&at, &power);
    let (x, y) = (-(left.x / reach), -(left.y / reach));
    let force = x.hypot(y);
    // Rounding of the balance, in units of the force limit.
    let rounding = R::from_f64(FACET_ULPS) * R::EPSILON * largest_term(goal, reach) / reach;
    if force <= kink.share + rounding {
        let within = if force > kink.share {
            kink.share / force
        } else {
            R::ONE
        };
        power.gradient += kink.wrench([x, y]) * within;
        return NonsmoothProbe::Facet(Minimiser {
            at,
            power,
            steps: 0,
            ended: Ended::Level,
            is_flat: true,
        });
    }
    // Translation along the force that the point cannot carry.
    let (cx, cy) = (x / force, y / force);
    let along = Vector3::new(cx, cy, R::ZERO);
    power.gradient += kink.wrench([cx, cy]) * kink.share;
    let before = goal.value(&at, power.value);
    let slack = R::from_f64(DONE_ULPS) * R::EPSILON * goal.terms(&at, power.value);
    let slope = (force - kink.share) * reach;
    let matrix = goal.matrix(&power);
    let bend = matrix.m11 * cx * cx + R::TWO * matrix.m12 * cx * cy + matrix.m22 * cy * cy;
    let rim = Rim {
        at,
        power,
        left: slope,
    };
    let mut by = slope / bend;
    for _ in 0..MOST_HALVINGS {
        let next = at + along * by;
        let next_power = power_at(&next);
        let value = goal.value(&next, next_power.value);
        // Where rounding hides what the step gains, the slope at its end decides.
        let end = dot(&goal.gradient(&next, &next_power), &along);
        let is_level = value <= before + slack && end.abs() < R::HALF * slope;
        if is_level || value < before - R::from_f64(ENOUGH) * by * slope {
            return NonsmoothProbe::Leaves(rim, Some((next, next_power)));
        }
        by = R::HALF * by;
    }
    NonsmoothProbe::Leaves(rim, None)
}

/// From a twist along a step, which changes the velocity of the slowest point in polar coordinates.
struct TwistLine<R: Real> {
    at: Vector3<R>,
    slow: Option<SlowestPoint<R>>,
}

/// Least speed of a point beside the twist.
fn slowest<R: Real>() -> R {
    let [double, single] = SLOW_ULPS;
    R::from_f64(if R::IS_SINGLE { single } else { double }) * R::EPSILON
}

/// The slowest point.
struct SlowestPoint<R: Real> {
    place: [R; 2],
    share: R,
    speed: R,
    /// Direction of its velocity.
    direction: [R; 2],
    least: R,
}

impl<R: Real> TwistLine<R> {
    fn new(at: &Vector3<R>, kink: Option<&NonsmoothPoint<R>>, reach: R) -> Self {
        let slow = kink.and_then(|kink| {
            let [x, y] = velocity(at, &kink.place);
            let speed = x.hypot(y);
            // The wrench of a fast point hardly bends, and its goal's own part is straight.
            let is_felt = speed < R::from_f64(FELT) * kink.share * reach;
            (speed > R::ZERO && is_felt).then(|| SlowestPoint {
                place: kink.place,
                share: kink.share,
                speed,
                direction: [x / speed, y / speed],
                least: slowest::<R>() * norm(at),
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
