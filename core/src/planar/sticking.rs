//! Steps of a body whose friction at rest is above that in motion.
//!
//! The kinetic set S carries what friction does while the body slides; at rest it is the static set s S with a strength
//! s = μ_s/μ_d ≥ 1. A body at rest stays there while −push lies in s S, and slides under S in the same step otherwise.
//!
//! A body that moves is caught where the kinetic step ends at rest, or where it would end with a motion u⁺ that is opposed
//! to the one before, u·M u⁺ < 0, while s S holds both the wrench that stops the body within the step and the push
//! itself. With q = M u/Δt + push, P the nearest point of S by kinetic energy and M u⁺ = Δt (q − P q), a
//! projection is monotone:
//!
//! ```text
//! u·M u⁺/Δt = u·(q − P q) ≥ u·(push − P push)
//! ```
//!
//! The right side is the power that the motion takes from the part of the push that sliding friction cannot balance. Where it
//! is positive the body slides along, and is not caught at any speed and in any step: not the body that has just begun to
//! slide, and not one that a push between μ_d and μ_s drives. A body that the static set has caught stays at rest under the same
//! push.

use super::step::is_beyond;
use super::{PlanarBody, PlanarStep, PointContacts};
use crate::contact::TimeStep;
use crate::law::{RestTime, StickSlip};
use crate::limit_surface::{FrictionSet, without_gain};
use crate::patch::nodes::NodePatch;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

impl<R: Real> PlanarBody<R> {
    /// [`PlanarBody::step`] with friction that is `strength` = μ_s/μ_d times that of `set` while the body rests.
    ///
    /// A body at rest, whose twist is exactly zero, keeps every bit of it while the push lies in `strength` × `set`;
    /// beyond, it slides under `set` in the same step. A body that moves is caught where the step would end at rest,
    /// and where it would reverse the motion (by kinetic energy, u·M u⁺ < 0) although the static set holds the body: never
    /// while push less friction drives the motion. A caught body stays under the same push if the static set holds that.
    ///
    /// *Units*: those of [`PlanarBody::step`]; `strength` is a ratio. *Domain*: 1 ≤ `strength`; less counts as 1, which has
    /// the bits of [`PlanarBody::step`]. `strength` may differ in each call: [`PlanarBody::step_ageing`] counts the time of rest for it.
    /// *Accuracy*: that of [`PlanarBody::step`]; the load at which the body lets go is that of the set, at any step.
    /// *Cost*: one projection at rest; near rest up to three more where the motion reverses.
    /// *Special values*: NaN for NaN.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::RoundLimitSurface;
    /// use tribos_core::planar::PlanarBody;
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = PlanarBody::new(0.17_f64, 1.36e-4)?; // kg, kg m²
    /// let table = RoundLimitSurface::new(CoulombDisk, 0.5, 0.04)?; // mu_d N in N, m
    /// let (dt, push) = (TimeStep::new(0.01)?, Wrench::new(0.6, 0.0, 0.0)); // s, N
    /// // mu_s = 1.5 mu_d holds 0.75 N at rest; in motion 0.1 N are left to speed it up.
    /// let held = puck.step_sticking(&table, 1.5, &Twist::ZERO, &push, dt);
    /// assert!(held.is_at_rest);
    /// let slides = puck.step_sticking(&table, 1.5, &Twist::new(1e-9, 0.0, 0.0), &push, dt);
    /// assert!((slides.twist.velocity.x - 0.1 / 0.17 * 0.01).abs() < 1e-8);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_sticking<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        strength: R,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        let length = self.gyration;
        self.step_within_static(strength, twist, push, dt, self.limits(set), |needed| {
            set.project_with_length(needed, length).wrench
        })
    }

    /// [`PlanarBody::step_sticking`] on a foot of many points.
    ///
    /// *Accuracy*: the load at which it lets go is within 1e-7, in f32 1e-5, as [`PointContacts::nearest`] has it.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::planar::{PointContacts, PlanarBody};
    /// use tribos_core::twist::{Twist, Wrench};
    /// use nalgebra::Vector2;
    /// // A chair of 5 kg on four legs; 20 N of friction in motion, 30 N at rest.
    /// let legs = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]; // m
    /// let legs = Nodes::new(legs.map(|[x, y]| Node { x, y, weight: 1.0_f64 }))?;
    /// let (mut legs, chair) = (PointContacts::<_, _, 4>::new(legs, 20.0)?, PlanarBody::new(5.0, 0.4)?);
    /// let dt = TimeStep::new(0.01)?;
    /// let [held, slides] = [29.0, 31.0].map(|force| {
    ///     let push = Wrench::new(force, 0.0, 0.0);
    ///     chair.step_sticking_on_points(&mut legs, 1.5, &Twist::ZERO, &push, dt)
    /// });
    /// assert!(held.is_at_rest && (slides.twist.velocity.x - 11.0 / 5.0 * 0.01).abs() < 1e-9);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_sticking_on_points<P: NodePatch<R>, const CAPACITY: usize>(
        &self,
        foot: &mut PointContacts<R, P, CAPACITY>,
        strength: R,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        let (length, limits) = (self.gyration, [foot.force_limit(), R::INFINITY]);
        let nearest = |needed: &Wrench<R>| foot.nearest(needed, length);
        self.step_within_static(strength, twist, push, dt, limits, nearest)
    }

    /// [`PlanarBody::step_sticking`] with a strength that grows with the time of rest, which `rest` counts.
    ///
    /// `strength` is asked for μ_s/μ_d at the time of rest before the step: zero wherever `twist` is not, whatever
    /// `rest` says. Afterwards `rest` is longer by `dt` if the body was at rest before and after, else zero. Nothing else
    /// needs to be counted: the body may also be stopped, set in motion and turned between steps.
    ///
    /// *Accuracy*: the time of rest misses the part of a step in which the body stops.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::law::{RestTime, StaticAgeing};
    /// use tribos_core::limit_surface::RoundLimitSurface;
    /// use tribos_core::planar::PlanarBody;
    /// use tribos_core::twist::{Twist, Wrench};
    /// let block = PlanarBody::new(1.0_f64, 4e-3)?; // kg, kg m²
    /// let (mu_d, load) = (0.4, 10.0); // N
    /// let bench = RoundLimitSurface::new(CoulombDisk, mu_d * load, 0.1)?; // N, m
    /// let wood = StaticAgeing::new(0.42, 0.03, 1.0)?; // 0.42 + 0.03 ln(t/1 s)
    /// let (mut twist, mut rest, dt) = (Twist::ZERO, RestTime::ZERO, TimeStep::new(0.1)?);
    /// let mut pushed = |force, rest: &mut RestTime<f64>| {
    ///     let push = Wrench::new(force, 0.0, 0.0);
    ///     let strength = |age| wood.mu_static(age) / mu_d;
    ///     let step = block.step_ageing(&bench, strength, rest, &twist, &push, dt);
    ///     twist = step.twist;
    ///     step.is_at_rest
    /// };
    /// // 5 N are more than a young contact holds, and less than one of 100 s: 5.58 N.
    /// assert!((0..1000).all(|_| pushed(0.0, &mut rest)));
    /// assert!((rest.time - 100.0).abs() < 1e-9 && pushed(5.0, &mut rest));
    /// assert!(!pushed(5.6, &mut rest) && rest == RestTime::ZERO);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_ageing<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        strength: impl FnOnce(RestTime<R>) -> R,
        rest: &mut RestTime<R>,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        let was_at_rest = *twist == Twist::ZERO;
        let age = if was_at_rest { *rest } else { RestTime::ZERO };
        let step = self.step_sticking(set, strength(age), twist, push, dt);
        let grip = if was_at_rest && step.is_at_rest {
            StickSlip::Stick
        } else {
            StickSlip::Slip
        };
        *rest = age.advance(dt.dt(), grip);
        step
    }

    /// [`PlanarBody::step_within`] with a static set.
    fn step_within_static(
        &self,
        strength: R,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
        [force, torque]: [R; 2],
        mut nearest: impl FnMut(&Wrench<R>) -> Wrench<R>,
    ) -> PlanarStep<R> {
        if strength.is_nan() {
            let unknown = Wrench::new(strength, strength, strength);
            let limits = [R::INFINITY; 2];
            return self.step_within(twist, push, dt, limits, |_| unknown).0;
        }
        let strength = if strength > R::ONE { strength } else { R::ONE };
        let at_end = self.stopping_wrench(twist, push, dt.dt());
        let held = PlanarStep {
            twist: Twist::ZERO,
            friction: at_end,
            is_at_rest: true,
        };
        let limits = [strength * force, strength * torque];
        if *twist == Twist::ZERO {
            let reduced = reduced(&at_end, strength);
            if nearest(&reduced) == reduced {
                return held;
            }
        } else if strength > R::ONE && !is_beyond(&at_end, limits) {
            // The kinetic step to its end has the momentum Δt (friction − the friction that rest needs).
            let ended = without_gain(&nearest(&at_end), &at_end, self.gyration);
            let is_reversed = (ended - at_end).power(twist) < R::ZERO;
            // The push comes last, such that a foot of points keeps the forces that carry it.
            let holds = is_reversed
                && [at_end, -*push].iter().all(|needed| {
                    let reduced = reduced(needed, strength);
                    nearest(&reduced) == reduced
                });
            if holds {
                return held;
            }
            return self
                .step_found(twist, push, dt, [Some(ended), None], nearest)
                .0;
        }
        self.step_within(twist, push, dt, [force, torque], nearest)
            .0
    }
}

/// The wrench of the kinetic set that is a wrench of the static set over its `strength`.
#[inline]
fn reduced<R: Real>(wrench: &Wrench<R>, strength: R) -> Wrench<R> {
    Wrench {
        force: wrench.force / strength,
        torque: wrench.torque / strength,
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
