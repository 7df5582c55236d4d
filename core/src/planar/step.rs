//! The implicit time step.

use super::{PlanarBody, PointContacts};
use crate::contact::TimeStep;
use crate::limit_surface::{FrictionSet, without_gain};
use crate::patch::nodes::NodePatch;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// The end of a step.
///
/// ```
/// use tribos_core::contact::TimeStep;
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::limit_surface::RoundLimitSurface;
/// use tribos_core::planar::{PlanarBody, PlanarStep};
/// use tribos_core::twist::{Twist, Wrench};
/// let puck = PlanarBody::new(0.17_f64, 1.36e-4)?; // kg, kg m²
/// let ice = RoundLimitSurface::new(CoulombDisk, 0.05, 0.04)?; // N, m
/// let (motion, dt) = (Twist::new(2.0, 0.0, 0.0), TimeStep::new(0.01)?); // m/s, s
/// let PlanarStep { twist, friction, is_at_rest } = puck.step(&ice, &motion, &Wrench::ZERO, dt);
/// // Without spin friction is μN, and its impulse is what the momentum loses.
/// assert!(!is_at_rest && (friction.force.x + 0.05).abs() < 1e-15);
/// assert!((0.17 * (2.0 - twist.velocity.x) - 0.05 * 0.01).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarStep<R: Real> {
    /// The motion after the step.
    pub twist: Twist<R>,
    /// Friction, as its mean over the step. *Units*: force, force × length.
    pub friction: Wrench<R>,
    /// Friction holds the body: `twist` is zero, to the last bit.
    pub is_at_rest: bool,
}

impl<R: Real> PlanarBody<R> {
    /// The motion after `dt` under the friction of `set` and a constant `push`.
    ///
    /// *Units*: velocity, 1/time; force, force × length; time. *Accuracy*: second order in `dt`
    /// while the body slides, first order in the step in which it starts, stops or turns about; rest
    /// is exact. *Passivity*, up to rounding: friction · (`twist` + twist after) ≤ 0 unless the body is
    /// brought to rest, whatever set and step. Without push the kinetic energy falls and the motion is not reversed:
    /// m v·v⁺ + I ω ω⁺ ≥ 0, and on a round patch both terms.
    /// *Cost*: a wrench, and one projection far from rest, two near it.
    /// *Special values*: NaN for NaN, and where momentum/`dt` overflows.
    pub fn step<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        self.step_and_instant(set, twist, push, dt).0
    }

    /// The same, and the share of `dt` after which friction opposes the motion; `None` at rest.
    ///
    /// Friction is the wrench of `set` nearest to [`PlanarBody::stopping_wrench`] in that time, so that
    /// the step's derivatives follow from the projection's.
    #[doc(hidden)]
    pub fn step_and_instant<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> (PlanarStep<R>, Option<R>) {
        let length = self.gyration;
        self.step_within(twist, push, dt, self.limits(set), |needed| {
            set.project_with_length(needed, length).wrench
        })
    }

    /// The largest force and torque of friction.
    pub(super) fn limits<S: FrictionSet<R> + ?Sized>(&self, set: &S) -> [R; 2] {
        // Power at unit spin is the largest torque.
        let torque_limit = set.support(&Twist::new(R::ZERO, R::ZERO, R::ONE));
        [set.force_limit(), torque_limit]
    }

    /// The same on a foot of many points.
    ///
    /// `foot` keeps the force of every point for the next step; [`PointContacts::release`] begins anew.
    /// *Cost*: [`PointContacts::nearest`] once far from rest, twice near it.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::planar::{PointContacts, PlanarBody};
    /// use tribos_core::twist::{Twist, Wrench};
    /// use nalgebra::Vector2;
    /// // A chair of 5 kg on four legs, with friction of up to 20 N in all.
    /// let legs = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]; // m
    /// let legs = Nodes::new(legs.map(|[x, y]| Node { x, y, weight: 1.0_f64 }))?;
    /// let (mut legs, chair) = (PointContacts::<_, _, 4>::new(legs, 20.0)?, PlanarBody::new(5.0, 0.4)?);
    /// let (rest, dt) = (Twist::ZERO, TimeStep::new(0.01)?);
    /// // Four legs 0.2 √2 m away resist a twist by 5.7 N m: 5 N m they hold, 6 N m they do not.
    /// let [held, turns] = [5.0, 6.0].map(|torque| {
    ///     let push = Wrench::new(0.0, 0.0, torque);
    ///     chair.step_on_points(&mut legs, &rest, &push, dt)
    /// });
    /// assert!(held.is_at_rest && held.friction.torque == -5.0);
    /// let left = 6.0 - 20.0 * 0.2 * 2.0_f64.sqrt();
    /// assert!((turns.twist.spin - left * 0.01 / 0.4).abs() < 1e-9);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_on_points<P: NodePatch<R>, const CAPACITY: usize>(
        &self,
        foot: &mut PointContacts<R, P, CAPACITY>,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        let length = self.gyration;
        let limits = [foot.force_limit(), R::INFINITY];
        let nearest = |needed: &Wrench<R>| foot.nearest(needed, length);
        self.step_within(twist, push, dt, limits, nearest).0
    }

    /// The step and the share of it after which friction opposes the motion, given bounds of force and
    /// torque of friction, and the wrench of friction nearest to the one needed for rest.
    pub(super) fn step_within(
        &self,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
        limits: [R; 2],
        mut nearest: impl FnMut(&Wrench<R>) -> Wrench<R>,
    ) -> (PlanarStep<R>, Option<R>) {
        // Friction that would end the step at rest, where it may.
        let at_end = self.stopping_wrench(twist, push, dt.dt());
        let ended = (!is_beyond(&at_end, limits))
            .then(|| without_gain(&nearest(&at_end), &at_end, self.gyration));
        self.step_found(twist, push, dt, [ended, None], nearest)
    }

    /// The same, with the wrenches of friction nearest to those needed for rest at the end and at half time as far as
    /// they are known; none for the end tells that it is surely out of reach.
    pub(super) fn step_found(
        &self,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
        [ended, midway]: [Option<Wrench<R>>; 2],
        mut nearest: impl FnMut(&Wrench<R>) -> Wrench<R>,
    ) -> (PlanarStep<R>, Option<R>) {
        let dt = dt.dt();
        // Friction takes power at the instant whose motion it opposes, whatever the search has missed.
        let mut nearest =
            |needed: &Wrench<R>| without_gain(&nearest(needed), needed, self.gyration);
        let at_end = self.stopping_wrench(twist, push, dt);
        if ended == Some(at_end) {
            let held = PlanarStep {
                twist: Twist::ZERO,
                friction: at_end,
                is_at_rest: true,
            };
            return (held, None);
        }
        // The motion at half time under the friction that it meets itself.
        let midway =
            midway.unwrap_or_else(|| nearest(&self.stopping_wrench(twist, push, R::HALF * dt)));
        let after = PlanarStep {
            twist: self.moved(twist, push, &midway, dt),
            friction: midway,
            is_at_rest: false,
        };
        if !turns_about(twist, &after.twist) {
            return (after, Some(R::HALF));
        }
        // The motion at the end under the friction that it meets there, if that takes power.
        let friction = ended.unwrap_or_else(|| nearest(&at_end));
        let at_last = PlanarStep {
            twist: self.moved(twist, push, &friction, dt),
            friction,
            is_at_rest: false,
        };
        if power(&friction, &mean(twist, &at_last.twist)) > R::ZERO {
            (after, Some(R::HALF))
        } else {
            (at_last, Some(R::ONE))
        }
    }

    /// The friction that brings the body to rest within `dt`, −(M u/Δt + push).
    #[doc(hidden)]
    #[inline]
    pub fn stopping_wrench(&self, twist: &Twist<R>, push: &Wrench<R>, dt: R) -> Wrench<R> {
        let (mass, inertia) = (self.mass / dt, self.inertia / dt);
        Wrench::new(
            -(mass * twist.velocity.x + push.force.x),
            -(mass * twist.velocity.y + push.force.y),
            -(inertia * twist.spin + push.torque),
        )
    }

    /// u + Δt M⁻¹ (push + friction)
    #[inline]
    fn moved(&self, twist: &Twist<R>, push: &Wrench<R>, friction: &Wrench<R>, dt: R) -> Twist<R> {
        let (rate, turn) = (dt / self.mass, dt / self.inertia);
        Twist::new(
            twist.velocity.x + rate * (push.force.x + friction.force.x),
            twist.velocity.y + rate * (push.force.y + friction.force.y),
            twist.spin + turn * (push.torque + friction.torque),
        )
    }
}

/// True if velocity or spin have another sense `after`.
fn turns_about<R: Real>(before: &Twist<R>, after: &Twist<R>) -> bool {
    let (u, v) = (&before.velocity, &after.velocity);
    u.x * v.x + u.y * v.y < R::ZERO || before.spin * after.spin < R::ZERO
}

/// The motion halfway between two others.
fn mean<R: Real>(a: &Twist<R>, b: &Twist<R>) -> Twist<R> {
    let half = R::HALF;
    Twist::new(
        half * a.velocity.x + half * b.velocity.x,
        half * a.velocity.y + half * b.velocity.y,
        half * a.spin + half * b.spin,
    )
}

/// What `wrench` gives a body that moves with `twist`.
fn power<R: Real>(wrench: &Wrench<R>, twist: &Twist<R>) -> R {
    wrench.force.x * twist.velocity.x
        + wrench.force.y * twist.velocity.y
        + wrench.torque * twist.spin
}

/// By how much friction must be exceeded to be exceeded beyond all rounding.
const BEYOND: f64 = 1.01;

/// True if friction with these largest force and torque can surely not be `wrench`.
pub(super) fn is_beyond<R: Real>(wrench: &Wrench<R>, [force, torque]: [R; 2]) -> bool {
    let beyond = R::from_f64(BEYOND);
    wrench.force.x.hypot(wrench.force.y) > beyond * force || wrench.torque.abs() > beyond * torque
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::coupling::coulomb::CoulombDisk;
    use crate::limit_surface::{LimitEllipsoid, RoundLimitSurface};

    const LIMIT: f64 = 0.5;
    const DT: f64 = 1.0 / 60.0;

    /// Motions from far away from rest to near it, and pushes from none to more than friction carries.
    fn cases() -> impl Iterator<Item = (Twist<f64>, Wrench<f64>)> {
        (0..2000).map(|i| {
            // Golden angles and their like spread evenly.
            let part = |k: f64| (f64::from(i) * k).fract() - 0.5;
            let scale = libm::exp(-10.0 * (part(0.618_033_988_75) + 0.5));
            let twist = Twist::new(
                4.0 * scale * part(0.754_877_666_25),
                4.0 * scale * part(0.569_840_290_99),
                100.0 * scale * part(0.819_172_513_4),
            );
            let push = Wrench {
                force: nalgebra::Vector2::new(part(0.671_043_606_7), part(0.549_700_477_9)) * 1.5,
                torque: 0.02 * part(0.445_041_867_9),
            };
            (twist, push)
        })
    }

    #[test]
    fn a_set_that_carries_more_torque_than_force_times_radius_holds_it() {
        let body = PlanarBody::new(0.17, 0.5 * 0.17 * 0.04 * 0.04).unwrap();
        let set = LimitEllipsoid::new(LIMIT, 0.04, 2.0).unwrap();
        let push = Wrench::new(0.0, 0.0, 1.9 * LIMIT * 0.04);
        let dt = TimeStep::new(DT).unwrap();
        let step = body.step(&set, &Twist::ZERO, &push, dt);
        assert!(step.is_at_rest, "{step:?}");
    }

    /// Compares one batch with a step for each of its bodies.
    fn assert_same<R: Real>(set: &impl FrictionSet<R>, of: impl Fn(f64) -> R) {
        let body = PlanarBody::new(of(0.17), of(0.5 * 0.17 * 0.04 * 0.04)).unwrap();
        let dt = TimeStep::new(of(DT)).unwrap();
        let odd = [f64::NAN, f64::INFINITY, 0.0, 1e-300, 1e300].map(|x| {
            let twist = Twist::new(x, 0.0, x);
            (twist, Wrench::new(0.0, x, 1.0))
        });
        let all: std::vec::Vec<_> = cases().chain(odd).collect();
        let twists: std::vec::Vec<_> = all
            .iter()
            .map(|(t, _)| Twist::new(of(t.velocity.x), of(t.velocity.y), of(t.spin)))
            .collect();
        let pushes: std::vec::Vec<_> = all
            .iter()
            .map(|(_, w)| Wrench::new(of(w.force.x), of(w.force.y), of(w.torque)))
            .collect();
        let one = |(twist, push)| body.step(set, twist, push, dt);
        let singly: std::vec::Vec<_> = twists.iter().zip(&pushes).map(one).collect();
        assert!(singly.iter().any(|step| step.is_at_rest));
        for count in [0, 1, 31, 40, all.len()] {
            let mut steps = std::vec![singly[0]; all.len() + 1];
            body.step_batch(set, &twists[..count], &pushes, dt, &mut steps);
            for (n, (step, single)) in steps.iter().zip(&singly).take(count).enumerate() {
                // NaN differs from itself, and is written the same.
                let [got, wanted] = [step, single].map(|step| std::format!("{step:?}"));
                assert_eq!(got, wanted, "{n} of {count}");
            }
            assert!(steps[count..].iter().all(|step| *step == singly[0]));
        }
    }

    #[test]
    fn a_batch_under_loads_has_the_bits_of_steps_on_surfaces_of_their_own() {
        let body = PlanarBody::new(0.17, 0.5 * 0.17 * 0.04 * 0.04).unwrap();
        let (dt, of) = (TimeStep::new(DT).unwrap(), |limit| {
            RoundLimitSurface::new(CoulombDisk, limit, 0.04).unwrap()
        });
        let (twists, pushes): (std::vec::Vec<_>, std::vec::Vec<_>) = cases().unzip();
        // None, little and much of what is usual.
        let loads = (0..twists.len()).map(|i| [0.0, 0.1, 1.0, 1.7, 30.0][i % 5]);
        let loads: std::vec::Vec<_> = loads.collect();
        let given = twists.iter().zip(&pushes).zip(&loads);
        let singly: std::vec::Vec<_> = given
            .map(|((twist, push), load)| body.step(&of(LIMIT * load), twist, push, dt))
            .collect();
        let rests = singly.iter().filter(|step| step.is_at_rest).count();
        assert!(rests > 100 && rests < singly.len() - 100);
        for count in [0, 1, 31, 40, loads.len()] {
            let mut steps = std::vec![singly[0]; loads.len()];
            let (loads, surface) = (&loads[..count], of(LIMIT));
            body.step_batch_under_loads(&surface, loads, &twists, &pushes, dt, &mut steps);
            assert_eq!(steps[..count], singly[..count]);
            assert!(steps[count..].iter().all(|step| *step == singly[0]));
        }
    }

    #[test]
    fn a_batch_of_steps_has_the_bits_of_single_steps() {
        let disk = RoundLimitSurface::new(CoulombDisk, LIMIT, 0.04).unwrap();
        assert_same(&disk, |x| x);
        assert_same(&LimitEllipsoid::new(LIMIT, 0.04, 0.5).unwrap(), |x| x);
        let disk = RoundLimitSurface::new(CoulombDisk, LIMIT as f32, 0.04).unwrap();
        assert_same(&disk, |x| x as f32);
    }

    #[test]
    fn friction_is_that_of_the_motion_at_half_time_or_holds() {
        let body = PlanarBody::new(0.17, 0.5 * 0.17 * 0.04 * 0.04).unwrap();
        let set = RoundLimitSurface::new(CoulombDisk, LIMIT, 0.04).unwrap();
        let dt = TimeStep::new(DT).unwrap();
        let [mut rests, mut slides] = [0, 0];
        for (twist, push) in cases() {
            let step = body.step(&set, &twist, &push, dt);
            assert!(set.gauge(&step.friction) <= 1.0 + 1e-9);
            // Newton's law over the step.
            let after = body.moved(&twist, &push, &step.friction, DT);
            let left = (after.velocity - step.twist.velocity).norm();
            assert!(left < 1e-12 && (after.spin - step.twist.spin).abs() < 1e-10);
            if step.is_at_rest {
                assert_eq!(step.twist, Twist::ZERO);
                rests += 1;
                continue;
            }
            let half = body.moved(&twist, &push, &step.friction, 0.5 * DT);
            let most = set.support(&half).min(set.support(&step.twist));
            // Largest dissipation at half time, or at the end where the body has turned about.
            let given = [half, step.twist].map(|at| set.support(&at) + step.friction.power(&at));
            let least = given[0].min(given[1]);
            assert!(
                least.abs() < 1e-7 * (1.0 + most),
                "{twist:?} {push:?} {given:?}"
            );
            slides += 1;
        }
        assert!(rests > 100 && slides > 1000, "{rests} {slides}");
    }
}
