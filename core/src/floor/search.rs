//! Where a convex function of the body's twist and of its feet's dissipated power is least.
//!
//! The power has an edge at the motion of each surface. All edges are looked at first: feet that rest on a surface carry
//! what the others leave, if that lies in their limit surface. If none rests, the search leaves the lowest edge along the
//! direction in which the function falls most steeply, which is what the limit surface does not carry, and goes on by
//! Newton's steps. It cannot end at an edge, because it only descends.

use super::group::{FromReference, Group};
use super::{Feet, FeetPower, Foot, loaded, moved, moved_back};
use crate::coupling::flat::{PatchShape, ShapeFriction};
use crate::limit_surface::quadratic::{Factors, dot, norm, stretched};
use crate::limit_surface::search::{Ended, pivot};
use crate::limit_surface::{FrictionSet, ShapeLimitSurface};
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use core::cell::Cell;
use nalgebra::{Matrix3, Vector2, Vector3};

/// The units of a search: places are twists from `zero` on, about a reference point.
pub(super) struct Units<R: Real> {
    pub(super) at: Vector2<R>,
    /// About the reference point.
    pub(super) zero: Twist<R>,
    pub(super) arm: R,
    pub(super) speed: R,
}

/// How a search ended.
pub(super) enum Outcome<R: Real> {
    /// The feet on the surface of the one with this index rest.
    Rests(usize),
    /// All feet slide.
    Slides {
        at: Vector3<R>,
        /// What is left of the gradient, over all limits.
        imbalance: R,
        ended: Ended,
        /// How often friction of all feet was evaluated.
        evaluations: usize,
    },
}

/// By how much a limit must be exceeded to be exceeded beyond all rounding.
const BEYOND: f64 = 1.01;
/// Length of the first step off an edge, in units of the search, and what later ones are of it.
const OFF: f64 = 0.5;
const SHORTER: f64 = 0.25;
/// Most steps off an edge.
const MOST_OFF: usize = 12;

impl<R: Real> Units<R> {
    /// The twist about the reference point.
    pub(super) fn twist(&self, q: &Vector3<R>) -> Twist<R> {
        self.zero
            + Twist::new(
                q.x * self.speed,
                q.y * self.speed,
                q.z * self.speed / self.arm,
            )
    }

    /// The same about the origin.
    pub(super) fn twist_about_origin(&self, q: &Vector3<R>) -> Twist<R> {
        moved_back(&self.twist(q), &self.at)
    }

    /// The place of a twist about the origin.
    fn place(&self, twist: &Twist<R>) -> Vector3<R> {
        self.direction(&(moved(twist, &self.at) - self.zero))
    }

    /// A difference of twists about the reference point.
    fn direction(&self, twist: &Twist<R>) -> Vector3<R> {
        let Twist { velocity, spin } = *twist;
        Vector3::new(
            velocity.x / self.speed,
            velocity.y / self.speed,
            spin * self.arm / self.speed,
        )
    }
}

impl<'a, R: Real, P: PatchShape<R>> Feet<'a, R, P> {
    /// Where `goal` is least, whose force on the body at a twist is `pull`; the search may begin at the zero of the units.
    pub(super) fn least(
        &self,
        units: &Units<R>,
        goal: &impl Goal<R>,
        pull: impl Fn(&Twist<R>) -> Wrench<R>,
        may_begin_at_zero: bool,
    ) -> Outcome<R> {
        let count = Cell::new(0);
        let place_at = |q: Vector3<R>| {
            count.set(count.get() + 1);
            SearchPlace::of(goal, self.scaled_power(units, &q), q)
        };
        let mut lowest: Option<(&Foot<R, P>, Wrench<R>, R)> = None;
        for (index, foot) in self.feet.iter().enumerate() {
            if !self.is_first(index) {
                continue;
            }
            count.set(count.get() + 1);
            let (friction, power) = self.others(foot);
            let wanted = about(&pull(&foot.surface), &self.centre) + friction;
            if self.carries(foot, &wanted) {
                return Outcome::Rests(index);
            }
            let power = power / (self.limit * units.speed);
            let value = goal.value(&units.place(&foot.surface), power);
            if lowest.is_none_or(|(_, _, least)| value < least) {
                lowest = Some((foot, wanted, value));
            }
        }
        let mut start = may_begin_at_zero.then(|| place_at(Vector3::repeat(R::ZERO)));
        if let Some((foot, wanted, lowest)) = lowest {
            let edge = units.place(&foot.surface);
            let along = self.steepest(units, foot, &wanted);
            let mut length = R::from_f64(OFF);
            for _ in 0..MOST_OFF {
                if start.as_ref().is_some_and(|place| place.value < lowest) {
                    break;
                }
                start = Some(place_at(edge + along * length));
                length *= R::from_f64(SHORTER);
            }
        }
        let start = start.unwrap_or_else(|| place_at(Vector3::repeat(R::ZERO)));
        let rounding = Group::of(self, None).rounding();
        let (found, ended) = descend(start, rounding, place_at);
        Outcome::Slides {
            at: found.at,
            imbalance: norm(&found.gradient),
            ended,
            evaluations: count.get(),
        }
    }

    /// The direction of length 1 in which the function falls most steeply from the motion of a surface.
    fn steepest(&self, units: &Units<R>, foot: &Foot<R, P>, wanted: &Wrench<R>) -> Vector3<R> {
        let arm = self.radius;
        let mut left = *wanted;
        if let Some(set) = self.set(foot) {
            left = *wanted - set.project_with_length(wanted, arm).wrench;
        }
        let twist = Twist::new(left.force.x, left.force.y, left.torque / (arm * arm));
        let about_origin = moved_back(&twist, &self.centre);
        let along = units.direction(&moved(&about_origin, &units.at));
        let length = along.x.hypot(along.y).hypot(along.z);
        if length > R::ZERO && length.is_finite() {
            along * (R::ONE / length)
        } else {
            Vector3::new(R::ONE, R::ZERO, R::ZERO)
        }
    }

    /// Whether no loaded foot before this one, which is loaded, stands on the same surface.
    pub(super) fn is_first(&self, index: usize) -> bool {
        let Some(foot) = self.feet.get(index) else {
            return false;
        };
        let before = self.feet.get(..index).unwrap_or_default();
        foot.limit > R::ZERO && loaded(before).all(|other| other.surface != foot.surface)
    }

    /// Whether the feet on the surface of `foot` carry a wrench about the common centre.
    pub(super) fn carries(&self, foot: &Foot<R, P>, wanted: &Wrench<R>) -> bool {
        let beyond = R::from_f64(BEYOND) * Group::of(self, Some(foot.surface)).limit();
        let force = wanted.force.x.hypot(wanted.force.y);
        let is_near = force <= beyond && wanted.torque.abs() <= beyond * self.radius;
        is_near && self.set(foot).is_some_and(|set| set.contains(wanted))
    }

    /// What the feet on the surface of `foot` carry, about the common centre.
    fn set(&self, foot: &Foot<R, P>) -> Option<impl FrictionSet<R>> {
        let patch = Group::of(self, Some(foot.surface));
        let limit = patch.limit();
        let at = self.centre;
        ShapeLimitSurface::new(FromReference { patch, at }, limit).ok()
    }

    /// Friction of the feet on other surfaces while those on the surface of `foot` rest, about the common centre, and
    /// what they dissipate.
    fn others(&self, foot: &Foot<R, P>) -> (Wrench<R>, R) {
        let (mut sum, mut power) = (Wrench::ZERO, R::ZERO);
        for other in loaded(self.feet).filter(|other| other.surface != foot.surface) {
            let patch = FromReference {
                patch: &other.patch,
                at: self.centre,
            };
            if let Ok(friction) = ShapeFriction::new(patch, other.limit) {
                let sliding = moved(&(foot.surface - other.surface), &self.centre);
                let wrench = friction.wrench(R::ONE, &sliding);
                sum += wrench;
                power -= wrench.power(&sliding);
            }
        }
        (sum, power)
    }

    /// The power over all limits and the unit of speed, by places.
    fn scaled_power(&self, units: &Units<R>, q: &Vector3<R>) -> FeetPower<R> {
        let power = self.power(&units.at, &units.twist(q));
        let (inv, inv_arm) = (R::ONE / self.limit, R::ONE / units.arm);
        let scaled = |matrix| stretched(matrix, inv * units.speed, [inv_arm, inv_arm]);
        FeetPower {
            value: power.value * inv / units.speed,
            gradient: Vector3::new(
                power.gradient.x * inv,
                power.gradient.y * inv,
                power.gradient.z * inv * inv_arm,
            ),
            hessian: scaled(&power.hessian),
            bound: scaled(&power.bound),
        }
    }
}

/// A wrench about the origin, about another point.
pub(super) fn about<R: Real>(wrench: &Wrench<R>, to: &Vector2<R>) -> Wrench<R> {
    let Wrench { force, torque } = *wrench;
    Wrench {
        force,
        torque: torque - (to.x * force.y - to.y * force.x),
    }
}

/// A convex function of a place and of the feet's power there.
pub(super) trait Goal<R: Real> {
    fn value(&self, at: &Vector3<R>, power: R) -> R;
    /// The gradient of what is not power.
    fn gradient(&self, at: &Vector3<R>) -> Vector3<R>;
    /// The diagonal second derivatives of what is not power.
    fn curvature(&self) -> Vector3<R>;
}

/// A place that was looked at.
struct SearchPlace<R: Real> {
    at: Vector3<R>,
    value: R,
    gradient: Vector3<R>,
    hessian: Matrix3<R>,
    bound: Matrix3<R>,
}

impl<R: Real> SearchPlace<R> {
    fn of(goal: &impl Goal<R>, power: FeetPower<R>, at: Vector3<R>) -> Self {
        let own = goal.curvature();
        let mut with_own = [power.hessian, power.bound];
        for matrix in &mut with_own {
            matrix.m11 += own.x;
            matrix.m22 += own.y;
            matrix.m33 += own.z;
        }
        let [hessian, bound] = with_own;
        Self {
            value: goal.value(&at, power.value),
            gradient: goal.gradient(&at) + power.gradient,
            hessian,
            bound,
            at,
        }
    }
}

/// A gradient of this many rounding errors of all limits is none.
const DONE_ULPS: f64 = 8.0;
/// One that does not shrink and has at most so many is rounding.
const ROUGH_ULPS: f64 = 4096.0;
/// Most steps that are tried.
const MOST_STEPS: usize = 200;
/// Share of the decrease that a quadratic function would have, from which on a step is taken.
const ENOUGH: f64 = 0.1;
/// The same from which on the next step is bolder.
const GOOD: f64 = 0.5;
/// The least caution above none, and by what it changes.
const CAUTIOUS: f64 = 1.0 / 64.0;
const CHANGE: f64 = 4.0;

/// Goes down from `start` by Newton's steps, as far towards those of the bound as it takes to descend.
fn descend<R: Real>(
    start: SearchPlace<R>,
    rounding: R,
    place_at: impl Fn(Vector3<R>) -> SearchPlace<R>,
) -> (SearchPlace<R>, Ended) {
    let (noise, change) = (R::from_f64(DONE_ULPS) * rounding, R::from_f64(CHANGE));
    let (mut here, mut caution) = (start, R::ZERO);
    for _ in 0..MOST_STEPS {
        let size = norm(&here.gradient);
        if size <= noise {
            return (here, Ended::Level);
        }
        if size.is_nan() {
            break;
        }
        let step = Factors::of(&here.matrix(caution), pivot()).solve(&here.gradient);
        let decrease = R::HALF * dot(&here.gradient, &step);
        let trial = place_at(here.at - step);
        let slack = noise * (R::ONE + here.value.abs());
        let shrinks = norm(&trial.gradient) < R::HALF * size;
        let gain = here.value - trial.value;
        // Where rounding hides what a step gains, the gradient decides.
        let is_level = gain.abs() <= slack && shrinks;
        if gain >= R::from_f64(ENOUGH) * decrease || is_level {
            if gain >= R::from_f64(GOOD) * decrease || is_level {
                let bolder = caution / change;
                caution = if bolder < R::from_f64(CAUTIOUS) {
                    R::ZERO
                } else {
                    bolder
                };
            }
            here = trial;
        } else if decrease <= slack && !shrinks && size <= R::from_f64(ROUGH_ULPS) * rounding {
            return (here, Ended::Rounding);
        } else {
            let least = R::from_f64(CAUTIOUS);
            caution = if caution < least {
                least
            } else {
                caution * change
            };
        }
    }
    (here, Ended::Missed)
}

impl<R: Real> SearchPlace<R> {
    /// Newton's matrix without caution, that of the bound with a caution of 1, a multiple of it beyond.
    fn matrix(&self, caution: R) -> Matrix3<R> {
        if caution > R::ONE {
            self.bound * caution
        } else {
            self.hessian * (R::ONE - caution) + self.bound * caution
        }
    }
}
