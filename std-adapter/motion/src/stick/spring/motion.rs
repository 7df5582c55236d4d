//! The state of a body on a spring, and what every way of following it answers.

use crate::stick::MotionError;

/// The body at one instant. *Units*: SI. Forces are positive forward, friction where it resists forward
/// motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SpringSample {
    /// Time.
    pub time: f64,
    /// Place of the pulled end of the spring.
    pub pull: f64,
    /// Place of the body.
    pub position: f64,
    /// Velocity of the body, zero to the bit while it sticks.
    pub velocity: f64,
    /// Force of the spring on the body.
    pub spring_force: f64,
    /// Force of friction against the body.
    pub friction: f64,
    /// What the contact remembers: time of rest or age in s, or the deflection of bristles in m.
    pub state: f64,
    /// Whether it slips: moves at all under laws that hold exactly, moves faster than a tenth of the
    /// pull under the others.
    pub slips: bool,
}

/// A body, its spring and its law, advanced in time.
pub(super) trait SpringIntegrator {
    /// The state now.
    fn moment(&self) -> SpringSample;

    /// Takes one step towards `until` while the end of the spring moves with `speed`; returns ∫F dt of the
    /// spring force.
    fn step(&mut self, speed: f64, until: f64) -> Result<f64, MotionError>;

    /// Whether it comes to rest to the bit.
    fn holds_exactly(&self) -> bool;

    /// Whether its speed has left all bounds.
    fn runs_away(&self) -> bool {
        false
    }
}

/// ∫F dt of the spring force over a step, from its ends: F' = k (V − v) makes it of fourth order.
pub(super) fn spring_impulse(before: &SpringSample, after: &SpringSample, stiffness: f64) -> f64 {
    let step = after.time - before.time;
    let rates = stiffness * (after.velocity - before.velocity);
    step * (0.5 * (before.spring_force + after.spring_force) + step * rates / 12.0)
}
