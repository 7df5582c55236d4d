//! The object between two pads: the load that they hold, and the motion of the object when it slips.

use crate::PERIOD;
use nalgebra::Vector2;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// A part of 0.4 kg with the inertia of a bar, gripped at its centre of mass.
const MASS: f32 = 0.4;
const INERTIA: f32 = 3.6e-4;
/// Radius of the flat round pads, which press uniformly: 1 cm.
const RADIUS: f32 = 0.01;
const PADS: f32 = 2.0;
/// Friction of the pads in the controller's model, and the true value.
pub const MU_MODEL: f32 = 0.6;
pub const MU_PRESENT: f32 = 0.57;
/// Permanent load of the pads: the weight, and the torque of a cable.
pub const LOAD: Wrench<f32> = Wrench::new(0.0, -MASS * 9.81, 0.01);
/// Smallest force of the pads in the model; a limit surface must not be empty.
const LEAST: f32 = 1e-3;

/// Limit surface of the pads if each presses with `grip` N.
fn pads(mu: f32, grip: f32) -> Option<RoundLimitSurface<f32, CoulombDisk>> {
    let grip = if grip > LEAST { grip } else { LEAST };
    RoundLimitSurface::new(CoulombDisk, PADS * mu * grip, RADIUS).ok()
}

/// The least grip force that holds a load, N: the surface grows in proportion to the force, so that
/// the gauge at 1 N is that force.
pub fn least_grip(load: &Wrench<f32>) -> Option<f32> {
    Some(pads(MU_MODEL, 1.0)?.gauge(load))
}

/// The object and its motion since it was gripped.
#[derive(Clone)]
pub struct Object {
    body: PlanarBody<f32>,
    mu: f32,
    dt: TimeStep<f32>,
    pub twist: Twist<f32>,
    pub is_at_rest: bool,
    /// m and rad
    pub place: Vector2<f32>,
    pub angle: f32,
}

impl Object {
    /// The object as the controller predicts it, tick by tick.
    pub fn foreseen() -> Option<Self> {
        Self::new(MU_MODEL, PERIOD)
    }

    /// At rest at its place, in steps of `dt` s.
    pub fn new(mu: f32, dt: f32) -> Option<Self> {
        Some(Self {
            body: PlanarBody::new(MASS, INERTIA).ok()?,
            mu,
            dt: TimeStep::new(dt).ok()?,
            twist: Twist::ZERO,
            is_at_rest: true,
            place: Vector2::new(0.0, 0.0),
            angle: 0.0,
        })
    }

    /// Advances by a step under the load, with `grip` N on each pad.
    pub fn advance(&mut self, grip: f32, load: &Wrench<f32>) {
        let Some(pads) = pads(self.mu, grip) else {
            return;
        };
        let step = self.body.step(&pads, &self.twist, load, self.dt);
        // The mean of both velocities makes the step second-order.
        let half = 0.5 * self.dt.dt();
        self.place += (self.twist.velocity + step.twist.velocity) * half;
        self.angle += (self.twist.spin + step.twist.spin) * half;
        (self.twist, self.is_at_rest) = (step.twist, step.is_at_rest);
    }

    /// m
    pub fn travel(&self) -> f32 {
        tribos_core::Real::hypot(self.place.x, self.place.y)
    }

    /// Whether the object never moved, to the last bit.
    pub fn has_not_moved(&self) -> bool {
        let Twist { velocity, spin } = self.twist;
        let motion = [velocity.x, velocity.y, spin];
        let way = [self.place.x, self.place.y, self.angle];
        motion == [0.0; 3] && way == [0.0; 3]
    }
}
