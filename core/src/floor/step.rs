//! Time steps of a body whose feet stand on moving surfaces.
//!
//! As on one surface at rest ([`crate::planar`]): friction opposes the motion that it meets at half time, and where that
//! carries the body beyond the motion of a surface, the one at the end. Both are where
//!
//! ```text
//! (t − t₀)·M (t − t₀)/(2 Δt) + Φ(t),     t₀ = u + Δt M⁻¹ push
//! ```
//!
//! is least (Moreau, Eur. J. Mech. A 13 (1994) 93), where feet that rest on their surface do so in every bit.

use super::search::{Goal, Outcome, Units};
use super::{Feet, loaded};
use crate::contact::TimeStep;
use crate::coupling::flat::PatchShape;
use crate::limit_surface::quadratic::dot;
use crate::planar::PlanarBody;
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::{Vector2, Vector3};

/// The end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorStep<R: Real> {
    /// The motion after the step.
    pub twist: Twist<R>,
    /// Friction of all feet, as its mean over the step. *Units*: force, force × length.
    pub friction: Wrench<R>,
    /// The first foot of those that rest on their surface at the end, where some do: `twist` is that of the surface, to
    /// the last bit.
    pub carried_by: Option<usize>,
    /// What the search has left of the balance of momentum, over all limits: some rounding errors, unless points rest.
    pub imbalance: R,
}

/// Friction that is met at one instant.
struct Met<R: Real> {
    twist: Twist<R>,
    friction: Wrench<R>,
    carried_by: Option<usize>,
    imbalance: R,
}

impl<R: Real, P: PatchShape<R>> Feet<'_, R, P> {
    /// The motion of `body` after `dt` under the friction of its feet and a constant `push`; all refer to its centre of
    /// mass, which is the origin of the feet's coordinates.
    ///
    /// *Units*: velocity, 1/time; force, force × length; time. *Accuracy*: second order in `dt` while all feet slide,
    /// first order in steps in which some begin or end to. *Cost*: two searches of 4 to 12 evaluations with Jacobian.
    /// *Special values*: NaN for NaN.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::floor::{Feet, Foot};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::planar::PlanarBody;
    /// use tribos_core::twist::{Twist, Wrench};
    /// let parcel = Polygon::new([[-0.15_f64, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]])?; // m
    /// let belt = Twist::new(0.5, 0.0, 0.0); // m/s
    /// let feet = [Foot { patch: parcel, limit: 8.0, surface: belt }]; // N
    /// let (feet, body) = (Feet::new(&feet)?, PlanarBody::new(2.0, 0.02)?); // kg, kg m²
    /// let (mut twist, dt) = (Twist::ZERO, TimeStep::new(0.01)?); // s
    /// for _ in 0..20 {
    ///     twist = feet.step(&body, &twist, &Wrench::ZERO, dt).twist;
    /// }
    /// assert_eq!(twist, belt); // laid on a belt it is taken along after 0.125 s
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step(
        &self,
        body: &PlanarBody<R>,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> FloorStep<R> {
        let dt = dt.dt();
        let ended = self.met(body, twist, push, dt);
        let at_end = FloorStep {
            twist: ended.twist,
            friction: ended.friction,
            carried_by: ended.carried_by,
            imbalance: ended.imbalance,
        };
        if ended.carried_by.is_some() {
            return at_end;
        }
        let midway = self.met(body, twist, push, R::HALF * dt);
        let after = accelerated(body, twist, &(*push + midway.friction), dt);
        if self.turns_about(twist, &after) {
            return at_end;
        }
        FloorStep {
            twist: after,
            friction: midway.friction,
            carried_by: None,
            imbalance: midway.imbalance,
        }
    }

    /// The motion after `dt` under the friction that it meets itself.
    fn met(&self, body: &PlanarBody<R>, twist: &Twist<R>, push: &Wrench<R>, dt: R) -> Met<R> {
        let free = accelerated(body, twist, push, dt);
        let needed = |at: &Twist<R>| momentum(body, &(free - *at)) * (R::ONE / dt);
        let arm = self.reach();
        let units = Units {
            at: Vector2::new(R::ZERO, R::ZERO),
            zero: free,
            arm,
            speed: self.speed_beside(&free, arm),
        };
        let unit = units.speed / (dt * self.limit);
        let mass = body.mass() * unit;
        let goal = Momentum {
            mass: Vector3::new(mass, mass, body.inertia() * unit / (arm * arm)),
        };
        match self.least(&units, &goal, needed, true) {
            Outcome::Rests(index) => {
                let twist = self.feet.get(index).map_or(free, |foot| foot.surface);
                Met {
                    twist,
                    friction: -needed(&twist),
                    carried_by: Some(index),
                    imbalance: R::ZERO,
                }
            }
            Outcome::Slides { at, imbalance, .. } => {
                let twist = units.twist(&at);
                Met {
                    twist,
                    friction: -needed(&twist),
                    carried_by: None,
                    imbalance,
                }
            }
        }
    }

    /// Distance of the farthest point from the origin.
    fn reach(&self) -> R {
        self.radius + self.centre.x.hypot(self.centre.y)
    }

    /// The largest speed of a motion against a surface, at the reach of the feet.
    fn speed_beside(&self, twist: &Twist<R>, arm: R) -> R {
        let mut most = R::ZERO;
        for foot in loaded(self.feet) {
            let from = *twist - foot.surface;
            let size = from
                .velocity
                .x
                .hypot(from.velocity.y)
                .hypot(from.spin * arm);
            if size > most || size.is_nan() {
                most = size;
            }
        }
        most
    }

    /// True if the motion against a surface has turned about.
    fn turns_about(&self, before: &Twist<R>, after: &Twist<R>) -> bool {
        loaded(self.feet).any(|foot| {
            let (a, b) = (*before - foot.surface, *after - foot.surface);
            let sliding = a.velocity.x * b.velocity.x + a.velocity.y * b.velocity.y;
            sliding < R::ZERO || a.spin * b.spin < R::ZERO
        })
    }
}

/// u + Δt M⁻¹ push
fn accelerated<R: Real>(
    body: &PlanarBody<R>,
    twist: &Twist<R>,
    push: &Wrench<R>,
    dt: R,
) -> Twist<R> {
    let (rate, turn) = (dt / body.mass(), dt / body.inertia());
    *twist + Twist::new(rate * push.force.x, rate * push.force.y, turn * push.torque)
}

/// M u
fn momentum<R: Real>(body: &PlanarBody<R>, twist: &Twist<R>) -> Wrench<R> {
    let (mass, inertia) = (body.mass(), body.inertia());
    Wrench::new(
        mass * twist.velocity.x,
        mass * twist.velocity.y,
        inertia * twist.spin,
    )
}

/// The step's function of the change from the free motion.
struct Momentum<R: Real> {
    /// Mass, mass and inertia over the time step, in units of the search.
    mass: Vector3<R>,
}

impl<R: Real> Goal<R> for Momentum<R> {
    fn value(&self, at: &Vector3<R>, power: R) -> R {
        R::HALF * dot(&self.gradient(at), at) + power
    }
    fn gradient(&self, at: &Vector3<R>) -> Vector3<R> {
        self.mass.component_mul(at)
    }
    fn curvature(&self) -> Vector3<R> {
        self.mass
    }
}
