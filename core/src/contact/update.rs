//! One contact in one time step: relative velocity in, impulse out.

use super::block::Block;
use super::body::ContactBody;
use super::friction::{ContactFriction, TangentialLoad};
use super::geometry::ContactGeometry;
use super::modes::{AxialPart, ContactModes, ContactVector, PlanarPart};
use super::normal::{NormalLaw, NormalStep};
use super::prepared::PreparedContact;
use super::sliding_rolling::CoupledSlip;
use super::vector::{cross, tangential};
use crate::real::Real;
use nalgebra::Vector3;

/// A contact prepared for a step, with its impulse so far.
///
/// [`Contact::update`] is the local solution for everything else held fixed: sweeping it over all
/// contacts of a system is the non-linear Gauss–Seidel method (Jean 1999).
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::*;
/// # let still = Vector3::new(0.0, 0.0, 0.0);
/// # let spin = still;
/// # let mut ball = SphereBody { velocity: still, spin, inv_mass: 1.0, inv_inertia: 1000.0 };
/// # let mut table = WallBody { velocity: still, inv_mass: 0.0 };
/// // A ball of 1 kg that lies on a table, and sticks to it with 5 N.
/// let dt = 1e-3;
/// ball.velocity.z = -9.81 * dt;
/// let law = NormalLaw::new(Cohesion::new(5.0, 1e-6, Attraction::Pull)?, 0.0)?;
/// let touch = ContactGeometry::plate(0.05_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
/// let mut contact = Contact::new(&touch, &law, &ball, &table, dt);
/// contact.update(&IndependentFriction::sliding(0.3)?, &mut ball, &mut table);
/// // The table bears the weight; friction is bounded by weight and cohesion.
/// assert!((contact.impulse().normal - 9.81 * dt).abs() < 1e-16);
/// assert_eq!(contact.cohesion(), 5.0 * dt);
/// assert!((contact.bound() - 14.81 * dt).abs() < 1e-16);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<R: Real, M: ContactModes<R>> {
    normal: Vector3<R>,
    arms: [R; 2],
    lever: R,
    block: Block<R>,
    step: NormalStep<R>,
    impulse: ContactVector<R, M>,
}

impl<R: Real, M: ContactModes<R>> Contact<R, M> {
    /// Prepares the contact for a step of length `dt` > 0 from the bodies' velocities at its start.
    ///
    /// *Special values*: `dt` ≤ 0 or NaN makes the impulses NaN. Modes that neither body can follow
    /// take no impulse.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::contact::*;
    /// # let still = Vector3::new(0.0, 0.0, 0.0);
    /// # let spin = still;
    /// # let ball = SphereBody { velocity: still, spin, inv_mass: 1.0, inv_inertia: 1000.0 };
    /// # let table = WallBody { velocity: still, inv_mass: 0.0 };
    /// // A ball of 5 cm and 1 kg, 1 mm above a table, and a step of 1 ms.
    /// let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
    /// let touch = ContactGeometry::plate(0.051_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
    /// let contact = Contact::<f64, SlidingOnly>::new(&touch, &law, &ball, &table, 1e-3);
    /// // It may approach by 1 m/s before the table bears.
    /// assert!((contact.approach_limit() - 1.0).abs() < 1e-12 && !contact.holds_gap_open());
    /// assert_eq!(*contact.normal(), Vector3::new(0.0, 0.0, -1.0)); // from the ball to the table
    /// assert_eq!((contact.centre_distances(), contact.effective_radius()), ([0.051, 0.0], 0.05));
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn new(
        touch: &ContactGeometry<R>,
        law: &NormalLaw<R>,
        a: &impl ContactBody<R>,
        b: &impl ContactBody<R>,
        dt: R,
    ) -> Self {
        let mut contact = Self {
            normal: touch.normal,
            arms: touch.arms,
            lever: touch.lever,
            block: Block::new(touch, a, b),
            step: NormalStep::new(law, touch.gap, R::ZERO, dt),
            impulse: ContactVector::default(),
        };
        let approach = contact.velocity(a, b).normal;
        contact.step = NormalStep::new(law, touch.gap, approach, dt);
        contact
    }

    /// A contact prepared earlier, with its impulse so far.
    #[doc(hidden)]
    #[inline]
    pub fn resume(prepared: &PreparedContact<R>, impulse: &ContactVector<R, M>) -> Self {
        Self {
            normal: prepared.normal,
            arms: prepared.arms,
            lever: prepared.lever,
            block: prepared.block,
            step: NormalStep {
                cohesion: prepared.cohesion,
                allowance: prepared.allowance,
                rests_open: prepared.rests_open,
            },
            impulse: *impulse,
        }
    }

    /// All but the impulse, as plain numbers.
    #[doc(hidden)]
    #[inline]
    pub fn prepared(&self) -> PreparedContact<R> {
        PreparedContact {
            normal: self.normal,
            arms: self.arms,
            lever: self.lever,
            block: self.block,
            cohesion: self.step.cohesion,
            allowance: self.step.allowance,
            rests_open: self.step.rests_open,
        }
    }

    /// Distances of the centres from the contact point.
    pub fn centre_distances(&self) -> [R; 2] {
        self.arms
    }

    /// Unit normal, from the first body to the second.
    pub fn normal(&self) -> &Vector3<R> {
        &self.normal
    }

    /// r_eff
    pub fn effective_radius(&self) -> R {
        self.lever
    }

    /// Effective masses.
    #[doc(hidden)]
    pub fn block(&self) -> &Block<R> {
        &self.block
    }

    /// F_coh dt if the contact is within the range of cohesion, else 0.
    pub fn cohesion(&self) -> R {
        self.step.cohesion
    }

    /// Normal velocity, with its sign turned, at which the law takes the contact as closed:
    /// max(gap, 0)/dt, or minus the rebound speed.
    pub fn approach_limit(&self) -> R {
        self.step.allowance
    }

    /// True if cohesion is a resistance that lets the gap, now open, stay as it is.
    pub fn holds_gap_open(&self) -> bool {
        self.step.rests_open
    }

    /// The impulse on the second body so far.
    #[inline(always)]
    pub fn impulse(&self) -> &ContactVector<R, M> {
        &self.impulse
    }

    /// P = normal impulse + F_coh dt, what all friction is proportional to.
    #[inline(always)]
    pub fn bound(&self) -> R {
        self.impulse.normal + self.step.cohesion
    }

    /// Sets the impulse without applying it to the bodies. Components of sliding and rolling along the
    /// current normal are discarded.
    pub fn set_impulse(&mut self, impulse: &ContactVector<R, M>) {
        self.impulse = *impulse;
        if M::Sliding::PRESENT {
            let vector = tangential(&impulse.sliding(), &self.normal);
            self.impulse.sliding = M::Sliding::of(vector);
        }
        if M::Rolling::PRESENT {
            let vector = tangential(&impulse.rolling(), &self.normal);
            self.impulse.rolling = M::Rolling::of(vector);
        }
    }

    /// [`Contact::set_impulse`] for an impulse whose sliding and rolling lie in the contact plane already.
    #[inline(always)]
    pub fn set_impulse_in_plane(&mut self, impulse: &ContactVector<R, M>) {
        self.impulse = *impulse;
    }

    /// Replaces the impulse by the nearest one that cohesion and friction admit, without applying it
    /// to the bodies. For initial guesses, such as the impulse of the last step.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::contact::*;
    /// # let still = Vector3::new(0.0, 0.0, 0.0);
    /// # let spin = still;
    /// # let mut ball = SphereBody { velocity: still, spin, inv_mass: 1.0, inv_inertia: 1000.0 };
    /// # let mut table = WallBody { velocity: still, inv_mass: 0.0 };
    /// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
    /// # let touch = ContactGeometry::plate(0.05_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
    /// let mut contact = Contact::<_, SlidingOnly>::new(&touch, &law, &ball, &table, 1e-3);
    /// // The impulse of the last step, when the normal was another.
    /// contact.set_impulse(&ContactVector::new(1.0, Vector3::new(3.0, 4.0, 7.0), still, 0.0)); // N s
    /// assert_eq!(contact.impulse().sliding(), Vector3::new(3.0, 4.0, 0.0));
    /// contact.project_impulse(&IndependentFriction::sliding(0.5)?);
    /// assert!((contact.impulse().sliding() - Vector3::new(0.3, 0.4, 0.0)).amax() < 1e-15);
    /// // It is the table's; the ball takes the opposite.
    /// contact.apply(contact.impulse(), &mut ball, &mut table);
    /// assert!((ball.velocity - Vector3::new(-0.3, -0.4, 1.0)).amax() < 1e-15);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    #[inline]
    pub fn project_impulse<F: ContactFriction<R, Modes = M>>(&mut self, friction: &F) {
        if self.impulse.normal < -self.step.cohesion {
            self.impulse.normal = -self.step.cohesion;
        }
        let bound = self.bound();
        let load = TangentialLoad {
            sliding: self.impulse.sliding(),
            torsion: self.impulse.torsion(),
        };
        let held = friction.hold(&load, bound, self.lever, &self.block.masses());
        self.impulse.sliding = M::Sliding::of(held.sliding);
        self.impulse.torsion = M::Torsion::of(held.torsion);
        let rolling = self.impulse.rolling();
        self.impulse.rolling = M::Rolling::of(friction.hold_rolling(&rolling, bound, self.lever));
    }

    /// Velocity of the second body relative to the first, mode by mode.
    #[inline(always)]
    pub fn velocity(
        &self,
        a: &impl ContactBody<R>,
        b: &impl ContactBody<R>,
    ) -> ContactVector<R, M> {
        let n = &self.normal;
        let drift = b.velocity() - a.velocity();
        let mut velocity = ContactVector {
            normal: super::vector::dot(&drift, n),
            ..ContactVector::default()
        };
        if M::Sliding::PRESENT {
            let turning = a.angular_velocity() * self.arms[0] + b.angular_velocity() * self.arms[1];
            let slip = drift - n * velocity.normal - cross(&turning, n);
            velocity.sliding = M::Sliding::of(slip);
        }
        if M::Rolling::PRESENT || M::Torsion::PRESENT {
            let turning = b.angular_velocity() - a.angular_velocity();
            let spin = super::vector::dot(&turning, n);
            velocity.torsion = M::Torsion::of(spin);
            velocity.rolling = M::Rolling::of(turning - n * spin);
        }
        velocity
    }

    /// Applies an impulse at this contact to both bodies.
    #[inline(always)]
    pub fn apply(
        &self,
        impulse: &ContactVector<R, M>,
        a: &mut impl ContactBody<R>,
        b: &mut impl ContactBody<R>,
    ) {
        let n = &self.normal;
        let force = impulse.linear(n);
        a.apply_impulse(-R::ONE, &force, impulse.normal, n);
        b.apply_impulse(R::ONE, &force, impulse.normal, n);
        if M::Sliding::PRESENT {
            let moment = cross(n, &impulse.sliding());
            a.apply_angular_impulse(-self.arms[0], &moment);
            b.apply_angular_impulse(-self.arms[1], &moment);
        }
        if M::Rolling::PRESENT || M::Torsion::PRESENT {
            let torque = impulse.angular(n);
            a.apply_angular_impulse(-R::ONE, &torque);
            b.apply_angular_impulse(R::ONE, &torque);
        }
    }

    /// Solves the contact with everything else held fixed, applies the change of its impulse to the
    /// bodies and returns it.
    ///
    /// The solution is in closed form, unless sliding and rolling are coupled and both slip, or the
    /// friction's set has no closed form. *Accuracy* where both slip, whatever the inertias: the laws
    /// hold for velocities that differ by 2e-15 (f32: 1e-6) of the speeds that meet.
    #[inline(always)]
    pub fn update<F: ContactFriction<R, Modes = M>>(
        &mut self,
        friction: &F,
        a: &mut impl ContactBody<R>,
        b: &mut impl ContactBody<R>,
    ) -> ContactVector<R, M> {
        let solve = |coupled: CoupledSlip<'_, R, F>| Some(coupled.solve());
        self.take(friction, (a, b), solve)
    }

    /// [`Contact::update`] for sweeps: sliding under the rolling torque so far, then rolling under the new
    /// sliding force. What one visit leaves over, where the two are coupled, the next ones find: the impulses that
    /// it does not change are those of `update`. It leaves k² m I of the distance where both stick, which is nearly all of it
    /// for bodies whose mass lies on an axle.
    #[doc(hidden)]
    #[inline(always)]
    pub fn take_turn<F: ContactFriction<R, Modes = M>>(
        &mut self,
        friction: &F,
        a: &mut impl ContactBody<R>,
        b: &mut impl ContactBody<R>,
    ) -> ContactVector<R, M> {
        self.take(friction, (a, b), |_| None)
    }

    /// [`Contact::take_turn`] where sliding and rolling both slip, [`Contact::update`] where one of them sticks: a
    /// body that a plate holds is held by one visit.
    #[doc(hidden)]
    #[inline(always)]
    pub fn hold_or_take_turn<F: ContactFriction<R, Modes = M>>(
        &mut self,
        friction: &F,
        a: &mut impl ContactBody<R>,
        b: &mut impl ContactBody<R>,
    ) -> ContactVector<R, M> {
        let hold = |coupled: CoupledSlip<'_, R, F>| coupled.solve_sticking().ok();
        self.take(friction, (a, b), hold)
    }

    /// Takes the impulse that obeys the contact's laws, applies its change to the bodies and returns it. Sliding and
    /// rolling, where they are coupled, are what `solve` finds; in turn where it finds nothing.
    #[inline(always)]
    fn take<F: ContactFriction<R, Modes = M>>(
        &mut self,
        friction: &F,
        (a, b): (&mut impl ContactBody<R>, &mut impl ContactBody<R>),
        solve: impl FnOnce(CoupledSlip<'_, R, F>) -> Option<(TangentialLoad<R>, Vector3<R>)>,
    ) -> ContactVector<R, M> {
        let velocity = self.velocity(a, b);
        let normal = self.normal_impulse(&velocity);
        let coupled = self.coupled(friction, &velocity, normal);
        let new = match coupled.and_then(solve) {
            Some((held, rolling)) => ContactVector {
                normal,
                sliding: M::Sliding::of(held.sliding),
                rolling: M::Rolling::of(rolling),
                torsion: M::Torsion::of(held.torsion),
            },
            None => self.solve_in_turn(friction, &velocity, normal),
        };
        let change = new.minus(&self.impulse);
        self.impulse = new;
        self.apply(&change, a, b);
        change
    }

    /// Sliding and rolling under a normal impulse, if the two are coupled.
    #[inline(always)]
    fn coupled<'a, F: ContactFriction<R, Modes = M>>(
        &'a self,
        friction: &'a F,
        velocity: &ContactVector<R, M>,
        normal: R,
    ) -> Option<CoupledSlip<'a, R, F>> {
        let place = (&self.block, &self.normal, self.lever);
        let bound = normal + self.step.cohesion;
        self.rolls_while_sliding()
            .then(|| CoupledSlip::new(friction, place, bound, &self.impulse, velocity))
    }

    /// The normal impulse that obeys its law.
    #[inline(always)]
    fn normal_impulse(&self, velocity: &ContactVector<R, M>) -> R {
        let mass = self.block.mass_normal;
        self.step
            .impulse(self.impulse.normal - mass * velocity.normal, mass)
    }

    /// Whether a sliding force changes the rolling velocity, and a rolling torque the sliding one.
    #[inline(always)]
    fn rolls_while_sliding(&self) -> bool {
        M::Sliding::PRESENT && M::Rolling::PRESENT && self.block.coupling != R::ZERO
    }

    /// Friction under a normal impulse: sliding and torsion, then rolling under the sliding force.
    #[inline(always)]
    fn solve_in_turn<F: ContactFriction<R, Modes = M>>(
        &self,
        friction: &F,
        velocity: &ContactVector<R, M>,
        normal: R,
    ) -> ContactVector<R, M> {
        let (block, old) = (&self.block, &self.impulse);
        let mut new = ContactVector {
            normal,
            ..ContactVector::default()
        };
        let bound = normal + self.step.cohesion;
        if M::Sliding::PRESENT || M::Torsion::PRESENT {
            let trial = TangentialLoad {
                sliding: old.sliding() - velocity.sliding() * block.mass_sliding,
                torsion: old.torsion() - block.inertia * velocity.torsion(),
            };
            let held = friction.hold(&trial, bound, self.lever, &block.masses());
            new.sliding = M::Sliding::of(held.sliding);
            new.torsion = M::Torsion::of(held.torsion);
        }
        if M::Rolling::PRESENT {
            let mut roll = velocity.rolling();
            if self.rolls_while_sliding() {
                let push = new.sliding() - old.sliding();
                roll += cross(&self.normal, &push) * block.coupling;
            }
            let trial = old.rolling() - roll * block.inertia;
            new.rolling = M::Rolling::of(friction.hold_rolling(&trial, bound, self.lever));
        }
        new
    }
}
