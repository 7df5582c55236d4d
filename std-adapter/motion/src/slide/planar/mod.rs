//! Bodies with lateral friction, which follow a curved path in the plane.
//!
//! A [`Resistance`] gives the deceleration of a body, a [`PlanarSimulation`] follows the body to rest. Bodies that are
//! ready, a cylinder, a pipe, a box or other plate, and a curling rock, are run from their
//! scenes; a body of your own implements [`Resistance`].

mod cylinder;
mod journey;
mod pipe;
mod plate;
mod tall;

pub use super::{Launch, SlideStopReason};
#[doc(hidden)]
pub use cylinder::TallCylinder;
pub use journey::{PlanarResult, PlanarSimulation, PlanarState};
#[doc(hidden)]
pub use pipe::Pipe;
#[doc(hidden)]
pub use plate::Plate;
pub use tall::Gradient;
#[doc(hidden)]
pub use tall::TallBody;

use std::fmt::Debug;

/// Deceleration of a body that slides and spins in the plane.
///
/// Velocities are three speeds, (v_x, v_y, w) with the rim speed w = ωR, positive
/// counterclockwise, so that all have the same unit.
///
/// ```
/// use tribos::slide::planar::{SlideStopReason, PlanarSimulation, Launch, Resistance};
/// /// A disk on a film of oil: velocity and spin fade with 2/s.
/// #[derive(Debug)]
/// struct Oiled;
/// impl Resistance for Oiled {
///     fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] { velocity.map(|v| 2.0 * v) }
///     fn exponent(&self) -> f64 { 1.0 }
///     fn inertia_ratio(&self) -> f64 { 0.5 }
///     fn radius(&self) -> f64 { 0.08 }
/// }
/// let launch = Launch { velocity: [1.0, 0.0], spin: 5.0 };
/// let end = PlanarSimulation::new(&Oiled, &launch, 1e-6)?.to_end()?;
/// assert_eq!(end.ending, SlideStopReason::Faded);
/// assert!((end.point.position[0] - 0.5).abs() < 1e-6); // v/k, but for the last millionth
/// assert!((end.point.angle - 2.5).abs() < 1e-5); // ω/k
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
pub trait Resistance: Debug {
    /// A of dV/dt = −A: force per mass, and torque/(C M R), in m/s². The power against the motion,
    /// V·A, must be positive.
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3];

    /// A for a body that has turned by `angle` since its launch, in rad; a round one resists alike at any angle.
    fn deceleration_at(&self, velocity: [f64; 3], _angle: f64) -> [f64; 3] {
        self.deceleration(velocity)
    }

    /// Whether the body is round: then it never spins up while it only slides, nor slides while it only spins,
    /// and each motion keeps its own relative accuracy.
    fn is_round(&self) -> bool {
        true
    }

    /// Exponent with which A scales in the common scale of all speeds towards rest.
    fn exponent(&self) -> f64;

    /// C = I/(M R²).
    fn inertia_ratio(&self) -> f64;

    /// Radius R, in m.
    fn radius(&self) -> f64;

    /// Relative accuracy of [`Resistance::deceleration`] if it is not an exact law; the steps of a journey are
    /// no finer than that.
    fn accuracy(&self) -> f64 {
        0.0
    }

    /// |l|, the pressure gradient that keeps the body upright; above 1 the body begins to tip.
    fn lean(&self, _velocity: [f64; 3]) -> f64 {
        0.0
    }
}

impl Resistance for Box<dyn Resistance> {
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] {
        (**self).deceleration(velocity)
    }
    fn deceleration_at(&self, velocity: [f64; 3], angle: f64) -> [f64; 3] {
        (**self).deceleration_at(velocity, angle)
    }
    fn is_round(&self) -> bool {
        (**self).is_round()
    }
    fn exponent(&self) -> f64 {
        (**self).exponent()
    }
    fn inertia_ratio(&self) -> f64 {
        (**self).inertia_ratio()
    }
    fn radius(&self) -> f64 {
        (**self).radius()
    }
    fn accuracy(&self) -> f64 {
        (**self).accuracy()
    }
    fn lean(&self, velocity: [f64; 3]) -> f64 {
        (**self).lean(velocity)
    }
}
