//! Derivatives of the implicit planar step.
//!
//! Friction is the projection f = Π(a) of the wrench a = −(M u/τ + push) that would end the motion within
//! τ = θ Δt, with θ = ½ or 1 as the step decides, or a itself at rest. With the projection's Jacobian J,
//! length L = √(inertia/mass) and force limit s,
//!
//! ```text
//! df = J da + (f − J a)/s ds − J e 2 (a − f)_torque/L dL,     e the axis of torques
//! ```
//!
//! because Π grows in proportion to a and s together, and a − f = M t with the normal t.

use super::smooth::Smooth;
use crate::model::{numbers, twist_numbers};
use nalgebra::{Matrix3, SMatrix, Vector3};
use tribos_core::contact::TimeStep;
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};

/// Columns of the derivatives: twist, push, force limit, mass, inertia, time.
pub const BY: usize = 10;
/// Twist and friction, and whether at rest.
pub const AFTER: usize = 7;
/// The same, and the derivatives of the former two.
pub const STEP: usize = AFTER + 6 * BY;

type StepDerivative = SMatrix<f64, 3, BY>;

/// A body that moves and is pushed.
pub struct StepGradient {
    pub body: PlanarBody<f64>,
    pub dt: TimeStep<f64>,
    pub twist: Twist<f64>,
    pub push: Wrench<f64>,
    /// Friction at a force limit of 1, where there is none: it grows from zero along this wrench.
    pub first: Wrench<f64>,
}

impl StepGradient {
    /// The motion that friction opposes where it is too weak to change it.
    pub fn resisted(&self) -> Twist<f64> {
        let needed = self
            .body
            .stopping_wrench(&self.twist, &self.push, 0.5 * self.dt.dt());
        let arm = self.body.gyration();
        Twist::new(
            -needed.force.x,
            -needed.force.y,
            -needed.torque / (arm * arm),
        )
    }

    /// ∂a/∂… for friction that opposes the motion after the share `theta` of the step.
    fn needed_by(&self, theta: f64) -> StepDerivative {
        let tau = theta * self.dt.dt();
        let (mass, inertia) = (self.body.mass(), self.body.inertia());
        let [x, y, spin] = twist_numbers(&self.twist);
        let mut by = StepDerivative::zeros();
        for (row, rate) in [mass, mass, inertia].into_iter().enumerate() {
            by[(row, row)] = -rate / tau;
            by[(row, 3 + row)] = -1.0;
        }
        by[(0, 7)] = -x / tau;
        by[(1, 7)] = -y / tau;
        by[(2, 8)] = -spin / tau;
        let momentum = Vector3::new(mass * x, mass * y, inertia * spin);
        by.set_column(9, &(momentum * (theta / tau / tau)));
        by
    }

    /// ∂(u + Δt M⁻¹ (push + friction))/∂… with that of friction.
    fn after_by(&self, friction: &Vector3<f64>, by: &StepDerivative) -> StepDerivative {
        let dt = self.dt.dt();
        let (mass, inertia) = (self.body.mass(), self.body.inertia());
        let inv_mass = Vector3::new(1.0 / mass, 1.0 / mass, 1.0 / inertia);
        let rate = (friction + Vector3::from(self.push)).component_mul(&inv_mass);
        let mut impulse_by = *by;
        for row in 0..3 {
            impulse_by[(row, 3 + row)] += 1.0;
        }
        let mut after = Matrix3::from_diagonal(&(inv_mass * dt)) * impulse_by;
        for row in 0..3 {
            after[(row, row)] += 1.0;
        }
        after[(0, 7)] -= rate.x * dt / mass;
        after[(1, 7)] -= rate.y * dt / mass;
        after[(2, 8)] -= rate.z * dt / inertia;
        for row in 0..3 {
            after[(row, 9)] += rate[row];
        }
        after
    }
}

fn row(step: &PlanarStep<f64>) -> [f64; AFTER] {
    let [x, y, spin] = twist_numbers(&step.twist);
    let [force_x, force_y, torque] = numbers(&step.friction);
    let is_at_rest = f64::from(u8::from(step.is_at_rest));
    [x, y, spin, force_x, force_y, torque, is_at_rest]
}

/// The step and its derivatives.
pub fn moved(surface: &dyn Smooth, moved: &StepGradient) -> [f64; STEP] {
    let StepGradient {
        body,
        dt,
        twist,
        push,
        ..
    } = moved;
    let (step, instant) = body.step_and_instant(surface.set(), twist, push, *dt);
    let (after_by, friction_by) = match instant {
        // Held: friction balances push and momentum, whatever the limit is.
        None => (StepDerivative::zeros(), moved.needed_by(1.0)),
        Some(theta) => sliding(surface, moved, theta),
    };
    let mut all = [0.0; STEP];
    let (values, slopes) = all.split_at_mut(AFTER);
    values.copy_from_slice(&row(&step));
    let (of_twist, of_friction) = slopes.split_at_mut(3 * BY);
    of_twist.copy_from_slice(after_by.transpose().as_slice());
    of_friction.copy_from_slice(friction_by.transpose().as_slice());
    all
}

fn sliding(
    surface: &dyn Smooth,
    moved: &StepGradient,
    theta: f64,
) -> (StepDerivative, StepDerivative) {
    let StepGradient {
        body,
        dt,
        twist,
        push,
        first,
    } = moved;
    let (mass, inertia, arm) = (body.mass(), body.inertia(), body.gyration());
    let needed = body.stopping_wrench(twist, push, theta * dt.dt());
    let (friction, rate) = surface.project(&needed, arm);
    let (needed, friction) = (Vector3::from(needed), Vector3::from(friction));
    let mut by = rate * moved.needed_by(theta);
    // By the force limit.
    let limit = surface.set().force_limit();
    let by_limit = if limit == 0.0 {
        Vector3::from(*first)
    } else {
        (friction - rate * needed) / limit
    };
    by.set_column(6, &by_limit);
    // By the length √(inertia/mass).
    let by_length = rate.column(2) * (-2.0 * (needed.z - friction.z) / arm);
    let by_mass = by.column(7) - by_length * (0.5 * arm / mass);
    let by_inertia = by.column(8) + by_length * (0.5 * arm / inertia);
    by.set_column(7, &by_mass);
    by.set_column(8, &by_inertia);
    (moved.after_by(&friction, &by), by)
}
