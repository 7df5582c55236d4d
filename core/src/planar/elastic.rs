//! The implicit step of a body on elastic bonds.
//!
//! With the bonds' displacement e, their stiffness S and damping C, the wrench t of the bonds, the
//! push w and the motion u⁺ after the step,
//!
//! ```text
//! M (u⁺ − u) = Δt (w − t),     e⁺ = e + Δt u⁺ − slip,     t = S e⁺ + C (e⁺ − e)/Δt ∈ K,     slip along K's normal at t
//! ```
//!
//! Without slip u⁺ follows at once, and t = t°. Otherwise S_d = S + C/Δt and A = S_d⁻¹ + Δt² M⁻¹, both
//! diagonal, leave slip = A (t° − t): t is the point of K nearest to t° in the norm √(t·A t), one
//! projection with the length √(A_t/A_θ). For S → ∞ this is the rule of [`super::step`] at the
//! end of the step. The damping acts on the bonds and not on the slip: all of friction is within K.
//!
//! With t·Δt u⁺ = t·(e⁺ − e) + t·slip and M(u⁺ − u)·u⁺ = Δ(u·M u/2) + Δu·M Δu/2 the balance of the step is
//!
//! ```text
//! w·Δt u⁺ = Δ(kinetic) + Δ(stored) + t·slip + Δe·C Δe/Δt + (Δu·M Δu + Δe·S Δe)/2
//! ```
//!
//! in which the last three terms are never negative: no step gains energy.

use super::PlanarBody;
use crate::contact::TimeStep;
use crate::law::StickSlip;
use crate::limit_surface::{FrictionSet, without_gain};
use crate::presliding::{Anchor, Axes, Pose, Presliding, Stiffness, not_below_zero};
use crate::real::Real;
use crate::twist::{Displacement, Twist, Wrench};

/// A body on elastic bonds: where it is, how it moves, and where its bonds are unstrained.
///
/// ```
/// use tribos_core::planar::ElasticState;
/// use tribos_core::presliding::Pose;
/// use tribos_core::twist::Twist;
/// let set_down = ElasticState::at_rest(Pose::new(0.5_f64, 0.0, 0.0)); // m, m, rad
/// assert_eq!(set_down.twist, Twist::ZERO);
/// assert_eq!(set_down.anchor.pose, set_down.pose);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticState<R: Real> {
    /// Pose of the patch, whose centre is below the centre of mass.
    pub pose: Pose<R>,
    /// Motion in the axes of the floor.
    pub twist: Twist<R>,
    /// The state of the bonds.
    pub anchor: Anchor<R>,
}

impl<R: Real> ElasticState<R> {
    /// A body at rest on unstrained bonds.
    pub const fn at_rest(pose: Pose<R>) -> Self {
        Self {
            pose,
            twist: Twist::ZERO,
            anchor: Anchor::at(pose),
        }
    }
}

/// The end of a step on elastic bonds, in the axes of the floor.
///
/// ```
/// use tribos_core::contact::TimeStep;
/// use tribos_core::limit_surface::LimitEllipsoid;
/// use tribos_core::planar::{ElasticState, ElasticStep, PlanarBody};
/// use tribos_core::presliding::{Pose, Presliding};
/// use tribos_core::twist::{Twist, Wrench};
/// let (book, bonds) = (PlanarBody::new(1.0_f64, 4e-3)?, Presliding::new(1e4, 50.0)?);
/// let (table, dt) = (LimitEllipsoid::new(3.0, 0.1, 0.6)?, TimeStep::new(0.01)?);
/// let slides = ElasticState { twist: Twist::new(1.0, 0.0, 0.0), ..ElasticState::at_rest(Pose::new(0.0, 0.0, 0.0)) };
/// let ElasticStep { state, friction, slip_heat, .. } =
///     book.step_elastic(&bonds, &table, &slides, &Wrench::ZERO, dt);
/// assert!((friction.force.x + 3.0).abs() < 1e-12 && (state.twist.velocity.x - 0.97).abs() < 1e-12);
/// // It slid by almost all that it moved: the bonds hold 0.3 mm of it.
/// assert!((slip_heat - 3.0 * (0.0097 - 0.0003)).abs() < 1e-12); // J
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticStep<R: Real> {
    /// Pose, motion and bonds after the step.
    pub state: ElasticState<R>,
    /// Friction on the body during the step. *Units*: force, force × length.
    pub friction: Wrench<R>,
    /// Displacement by which the bonds slipped; zero if they held.
    pub slip: Displacement<R>,
    /// Heat of slip. *Units*: force × length. Not negative.
    pub slip_heat: R,
    /// Heat of the bonds' damping. *Units*: force × length. Not negative.
    pub damping_heat: R,
    /// Energy that the implicit rule takes from vibrations; of second order in the step. *Units*: force ×
    /// length. Not negative.
    pub rule_loss: R,
    /// Whether the bonds held. They may hold a body that still vibrates.
    pub grip: StickSlip,
}

impl<R: Real> ElasticStep<R> {
    /// All energy that the step lost: the work of the push is the change of kinetic and stored energy, and
    /// this.
    ///
    /// *Units*: force × length. Not negative.
    pub fn lost_energy(&self) -> R {
        self.slip_heat + self.damping_heat + self.rule_loss
    }
}

/// Rounding errors of position and friction within which a body on its bonds rests.
///
/// Rounded positions can keep a vibration of about one of them going; four end it and are still far
/// below anything that a position shows.
const REST_ULPS: f64 = 4.0;

/// One direction of the step: m Δu = Δt (w − t) with stiffness k and damping c.
struct Mode<R> {
    /// Δt/m
    mobility: R,
    /// k
    stiffness: R,
    /// k + c/Δt
    stiffened: R,
    /// 1 + (k + c/Δt) Δt²/m
    inertia: R,
    /// Largest friction.
    limit: R,
}

impl<R: Real> Mode<R> {
    #[inline]
    fn new(mass: R, [stiffness, damping]: [R; 2], limit: R, dt: R) -> Self {
        let stiffened = stiffness + damping / dt;
        let mobility = dt / mass;
        Self {
            mobility,
            stiffness,
            stiffened,
            inertia: R::ONE + stiffened * dt * mobility,
            limit,
        }
    }

    /// Motion after the step if the bonds hold, from the `places` of patch and anchor.
    ///
    /// Zero where the push is balanced and nothing moves, as far as positions and friction resolve it.
    #[inline]
    fn held(&self, velocity: R, push: R, [place, anchor]: [R; 2], dt: R) -> R {
        let left = push - self.stiffness * (place - anchor);
        let after = (velocity + self.mobility * left) / self.inertia;
        let (place, anchor) = (place.abs(), anchor.abs());
        let farther = if place > anchor { place } else { anchor };
        let ulps = R::from_f64(REST_ULPS) * R::EPSILON;
        let resolved = ulps * (self.stiffness * farther + self.limit);
        let moved = after.abs() * dt * self.stiffness;
        if left.abs() <= resolved && moved <= resolved {
            return R::ZERO;
        }
        after
    }

    /// S_d⁻¹ + Δt²/m, as a multiple of S_d⁻¹.
    #[inline]
    fn compliance(&self) -> R {
        self.inertia / self.stiffened
    }
}

impl<R: Real> PlanarBody<R> {
    /// The state after `dt` on elastic bonds under a constant `push`.
    ///
    /// `set` is in the axes of the patch, whose angle is that before the step; `push` and the results
    /// are in the axes of the floor.
    ///
    /// *Hold*: under a constant push within the set the body comes to the displacement S⁻¹ push and
    /// stays: its motion is zero and the bits of its pose and of its anchor do not change any more. It
    /// rests from where push and bonds balance, and the step moves it, by 4 rounding errors at most.
    /// *Units*: length, radians, velocity, 1/time; force, force × length; time.
    /// *Accuracy*: first order in `dt`; it damps vibrations that the step does not resolve, and never
    /// gains energy. *Cost*: one projection, a sine and a cosine. *Special values*: NaN for NaN and
    /// infinities.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::RoundLimitSurface;
    /// use tribos_core::planar::{ElasticState, PlanarBody};
    /// use tribos_core::presliding::{Pose, Presliding};
    /// use tribos_core::twist::Wrench;
    /// // A box of 1 kg on a slope that pulls with 3 N; friction carries 4 N.
    /// let body = PlanarBody::new(1.0_f64, 4e-3)?; // kg, kg m²
    /// let (slope, bonds) = (RoundLimitSurface::new(CoulombDisk, 4.0, 0.1)?, Presliding::new(1e5, 500.0)?);
    /// let (mut state, dt) = (ElasticState::at_rest(Pose::new(2.0, 0.0, 0.0)), TimeStep::new(0.01)?);
    /// let pull = Wrench::new(3.0, 0.0, 0.0); // N, N, N m
    /// for _ in 0..100 {
    ///     state = body.step_elastic(&bonds, &slope, &state, &pull, dt).state;
    /// }
    /// let still = body.step_elastic(&bonds, &slope, &state, &pull, dt).state;
    /// assert_eq!(still.pose, state.pose);
    /// assert!((still.pose.position.x - 2.0 - 3.0 / 1e5).abs() < 1e-14);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_elastic<S: FrictionSet<R> + ?Sized>(
        &self,
        bonds: &Presliding<R>,
        set: &S,
        state: &ElasticState<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> ElasticStep<R> {
        let dt = dt.dt();
        let (stiffness, [damping, torsional_damping]) = (bonds.factors(), bonds.damping());
        let torque_limit = set.force_limit() * set.radius();
        let sliding = [stiffness.sliding, damping];
        let sliding = Mode::new(self.mass, sliding, set.force_limit(), dt);
        let turning = [stiffness.torsion, torsional_damping];
        let turning = Mode::new(self.inertia, turning, torque_limit, dt);
        let (u, e) = (&state.twist, state.anchor.deflection(&state.pose));
        let (at, anchor) = (&state.pose, &state.anchor.pose);
        let x = [at.position.x, anchor.position.x];
        let y = [at.position.y, anchor.position.y];
        // The step of bonds that hold.
        let held = Twist::new(
            sliding.held(u.velocity.x, push.force.x, x, dt),
            sliding.held(u.velocity.y, push.force.y, y, dt),
            turning.held(u.spin, push.torque, [at.angle, anchor.angle], dt),
        );
        let stiffened = Stiffness::new(sliding.stiffened, turning.stiffened);
        let wanted = stiffness.wrench(&e) + stiffened.wrench(&Displacement::along(&held, dt));
        let length = (sliding.compliance() / turning.compliance()).sqrt();
        let axes = Axes::at(state.pose.angle);
        let trial = axes.wrench_to_patch(&wanted);
        let carried = set.project_with_length(&trial, length).wrench;
        if carried == trial {
            let pose = state.pose.moved(&Displacement::along(&held, dt));
            let after = ElasticState {
                pose,
                twist: held,
                anchor: state.anchor,
            };
            return self.ended(bonds, state, after, wanted, None, dt);
        }
        // Bonds that slip pull with what the set carries, and take power from the slip.
        let carried = without_gain(&carried, &trial, length);
        let pull = axes.wrench_to_floor(&carried);
        let twist = Twist::new(
            u.velocity.x + sliding.mobility * (push.force.x - pull.force.x),
            u.velocity.y + sliding.mobility * (push.force.y - pull.force.y),
            u.spin + turning.mobility * (push.torque - pull.torque),
        );
        let kept = Wrench {
            force: e.shift * (damping / dt),
            torque: e.turn * (torsional_damping / dt),
        };
        let strain = stiffened.strain(&(pull + kept));
        let moved = Displacement::along(&twist, dt);
        let pose = state.pose.moved(&moved);
        let after = ElasticState {
            pose,
            twist,
            anchor: Anchor::with_deflection(&pose, &strain),
        };
        let slip = e + moved - strain;
        self.ended(bonds, state, after, pull, Some(slip), dt)
    }

    /// The step from `before` to `after` with its losses, given the bonds' pull, and their slip if any.
    fn ended(
        &self,
        bonds: &Presliding<R>,
        before: &ElasticState<R>,
        after: ElasticState<R>,
        pull: Wrench<R>,
        slipped: Option<Displacement<R>>,
        dt: R,
    ) -> ElasticStep<R> {
        let (grip, slip) = match slipped {
            None => (StickSlip::Stick, Displacement::ZERO),
            Some(slip) => (StickSlip::Slip, slip),
        };
        let faster = after.twist - before.twist;
        let strained =
            after.anchor.deflection(&after.pose) - before.anchor.deflection(&before.pose);
        let [damping, torsional_damping] = bonds.damping();
        let rate = Wrench {
            force: strained.shift * (damping / dt),
            torque: strained.turn * (torsional_damping / dt),
        };
        let momentum = Wrench {
            force: faster.velocity * self.mass,
            torque: faster.spin * self.inertia,
        };
        ElasticStep {
            state: after,
            friction: -pull,
            slip,
            slip_heat: not_below_zero(slip.work(&pull)),
            damping_heat: strained.work(&rate),
            rule_loss: R::HALF * momentum.power(&faster) + bonds.factors().energy(&strained),
            grip,
        }
    }
}
