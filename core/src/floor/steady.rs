//! Motions that stay as they are: where friction of all feet balances a push.
//!
//! They are where the convex function Φ(t) − push·t is least. There is no such place if the push is more than all feet
//! carry together.

use super::group::Group;
use super::search::{Goal, Outcome, Units, about};
use super::{Feet, loaded, moved};
use crate::coupling::flat::PatchShape;
use crate::limit_surface::quadratic::dot;
use crate::limit_surface::search::Ended;
use crate::limit_surface::{FrictionSet, ShapeLimitSurface};
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::Vector3;

/// A motion under which friction balances a push.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyMotion<R: Real> {
    /// The twist of the body, about the origin of its coordinates.
    pub twist: Twist<R>,
    /// Friction of all feet, about the same point.
    pub friction: Wrench<R>,
    /// The first foot of those that rest on their surface, where some do: `twist` is that of the surface, to the last bit.
    pub carried_by: Option<usize>,
    /// How often friction of all feet was evaluated in the search.
    pub evaluations: usize,
}

/// How the search for a steady motion ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyState<R: Real> {
    /// Friction balances the push to rounding.
    Balanced(SteadyMotion<R>),
    /// The push is more than all feet carry together: the body gains speed without end.
    Accelerates,
    /// The search ended before friction balanced the push: the last motion, which is none of them.
    Missed(SteadyMotion<R>),
}

impl<R: Real, P: PatchShape<R>> Feet<'_, R, P> {
    /// The motion in which friction of the feet balances `push`, a wrench on the body about the origin of its
    /// coordinates.
    ///
    /// It is the one that a body comes to, because friction takes energy from every other motion against it.
    ///
    /// *Accuracy*: balanced to 1e-12 of all limits (f32: 5e-5), torques over the distance within which all feet lie; next
    /// to the motion of a surface to a few rounding errors of the twist over the distance from it.
    /// *Domain*: where single points among the feet of a surface rest and others slide, the search misses. *Cost*: 8 to
    /// 24 evaluations with Jacobian, 12 in the median of feet anywhere.
    ///
    /// ```
    /// use tribos_core::floor::{Feet, Foot, SteadyState};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::{Twist, Wrench};
    /// // A robot on two tracks of 0.6 by 0.1 m, 0.5 m apart, that run against each other at 0.2 m/s.
    /// let track = |y: f64| Polygon::new([[-0.3, y - 0.05], [0.3, y - 0.05], [0.3, y + 0.05], [-0.3, y + 0.05]]);
    /// let feet = [(0.25, -0.2), (-0.25, 0.2)].map(|(y, speed)| Foot {
    ///     patch: track(y).unwrap(), limit: 60.0, surface: Twist::new(speed, 0.0, 0.0), // N; m/s
    /// });
    /// let SteadyState::Balanced(turning) = Feet::new(&feet)?.steady_motion(&Wrench::ZERO) else {
    ///     panic!("no push is too large here")
    /// };
    /// // It turns about its middle, more slowly than wheels without width would make it: 0.8 rad/s.
    /// assert!(turning.twist.speed() < 1e-12 && (0.3..0.8).contains(&turning.twist.spin.abs()));
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn steady_motion(&self, push: &Wrench<R>) -> SteadyState<R> {
        let goal = Balance {
            push: self.scaled(push),
        };
        let units = self.spread();
        let (at, ended, evaluations) = match self.least(&units, &goal, |_| *push, false) {
            Outcome::Rests(index) => {
                let twist = self
                    .feet
                    .get(index)
                    .map_or(Twist::ZERO, |foot| foot.surface);
                return SteadyState::Balanced(SteadyMotion {
                    twist,
                    friction: -*push,
                    carried_by: Some(index),
                    evaluations: index + 1,
                });
            }
            Outcome::Slides {
                at,
                ended,
                evaluations,
                ..
            } => (at, ended, evaluations),
        };
        let twist = units.twist_about_origin(&at);
        let motion = SteadyMotion {
            twist,
            friction: self.wrench(&twist),
            carried_by: None,
            evaluations,
        };
        if ended != Ended::Missed {
            return SteadyState::Balanced(motion);
        }
        let all = ShapeLimitSurface::new(Group::of(self, None), self.limit);
        let gauge = all.map_or(R::NAN, |set| set.gauge(push));
        if gauge >= R::ONE {
            SteadyState::Accelerates
        } else {
            SteadyState::Missed(motion)
        }
    }

    /// A wrench about the common centre, over all limits.
    fn scaled(&self, push: &Wrench<R>) -> Vector3<R> {
        let (push, inv) = (about(push, &self.centre), R::ONE / self.limit);
        Vector3::new(
            push.force.x * inv,
            push.force.y * inv,
            push.torque * inv / self.radius,
        )
    }

    /// Mean of the surfaces' motions about the common centre, and the farthest of them from it as the unit of speed; of
    /// one surface any.
    fn spread(&self) -> Units<R> {
        let (at, arm) = (self.centre, self.radius);
        let mut zero = Twist::ZERO;
        for foot in loaded(self.feet) {
            zero += moved(&foot.surface, &at) * (foot.limit / self.limit);
        }
        let mut speed = R::ZERO;
        for foot in loaded(self.feet) {
            let from = moved(&foot.surface, &at) - zero;
            let size = from
                .velocity
                .x
                .hypot(from.velocity.y)
                .hypot(from.spin * arm);
            if size > speed {
                speed = size;
            }
        }
        let speed = if speed > R::ZERO { speed } else { R::ONE };
        Units {
            at,
            zero,
            arm,
            speed,
        }
    }
}

/// Φ(t) − push·t
struct Balance<R: Real> {
    push: Vector3<R>,
}

impl<R: Real> Goal<R> for Balance<R> {
    fn value(&self, at: &Vector3<R>, power: R) -> R {
        power - dot(&self.push, at)
    }
    fn gradient(&self, _: &Vector3<R>) -> Vector3<R> {
        -self.push
    }
    fn curvature(&self) -> Vector3<R> {
        Vector3::repeat(R::ZERO)
    }
}
