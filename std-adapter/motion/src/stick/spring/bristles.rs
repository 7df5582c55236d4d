//! LuGre's bristles under a body on a spring.

use super::motion::{SpringIntegrator, SpringSample, spring_impulse};
use super::rosenbrock::{OdeSystem, StepSizeControl};
use crate::stick::MotionError;
use tribos_core::law::{Bristle, LuGre};

/// A body on bristles.
#[derive(Debug)]
pub(super) struct BristleMotion {
    law: LuGre<f64>,
    mass: f64,
    stiffness: f64,
    time: f64,
    pull: f64,
    /// Velocity, deflection of the bristles, force of the spring.
    y: [f64; 3],
    pace: StepSizeControl,
    scale: [f64; 3],
    /// Speed from which the body counts as slipping.
    slow: f64,
}

impl BristleMotion {
    /// At rest with relaxed spring and bristles. `speed` is that of the pull.
    pub fn new(law: LuGre<f64>, [mass, stiffness]: [f64; 2], speed: f64, tolerance: f64) -> Self {
        let p = *law.parameters();
        let first = 1e-3 * (mass / (stiffness + p.stiffness)).sqrt();
        Self {
            law,
            mass,
            stiffness,
            time: 0.0,
            pull: 0.0,
            y: [0.0; 3],
            pace: StepSizeControl::new(first, tolerance),
            scale: [speed, law.largest_deflection(), p.static_force],
            slow: super::SLOW * speed,
        }
    }
}

/// (v, z, F).
struct BristleFlow<'a> {
    body: &'a BristleMotion,
    speed: f64,
}

impl OdeSystem<3> for BristleFlow<'_> {
    fn rate(&self, &[velocity, deflection, force]: &[f64; 3]) -> [f64; 3] {
        let BristleMotion {
            law,
            mass,
            stiffness,
            ..
        } = self.body;
        let bristle = Bristle { deflection };
        [
            (force - law.force(bristle, velocity)) / mass,
            law.rate(bristle, velocity),
            stiffness * (self.speed - velocity),
        ]
    }

    fn jacobian(&self, &[velocity, deflection, _]: &[f64; 3]) -> [[f64; 3]; 3] {
        let BristleMotion {
            law,
            mass,
            stiffness,
            ..
        } = self.body;
        let p = law.parameters();
        // z' = v − σ₀|v|z/g(v), with g' = −2v/vₛ² (g − F_c).
        let carried = law.steady_bristle_force(velocity);
        let fall =
            -2.0 * velocity / (p.stribeck_speed * p.stribeck_speed) * (carried - p.coulomb_force);
        let share = p.stiffness * deflection / carried;
        let by_speed = 1.0 - velocity.signum() * share + velocity.abs() * share * fall / carried;
        let by_bristle = -p.stiffness * velocity.abs() / carried;
        let slope = p.bristle_damping * by_speed + p.viscous_damping;
        let stretch = p.stiffness + p.bristle_damping * by_bristle;
        [
            [-slope / mass, -stretch / mass, 1.0 / mass],
            [by_speed, by_bristle, 0.0],
            [-stiffness, 0.0, 0.0],
        ]
    }
}

impl SpringIntegrator for BristleMotion {
    fn moment(&self) -> SpringSample {
        let [velocity, deflection, force] = self.y;
        SpringSample {
            time: self.time,
            pull: self.pull,
            position: self.pull - force / self.stiffness,
            velocity,
            spring_force: force,
            friction: self.law.force(Bristle { deflection }, velocity),
            state: deflection,
            slips: velocity.abs() > self.slow,
        }
    }

    fn step(&mut self, speed: f64, until: f64) -> Result<f64, MotionError> {
        let before = self.moment();
        let mut pace = self.pace.clone();
        let flow = BristleFlow { body: self, speed };
        let left = until - self.time;
        let (end, step) = pace
            .step(&flow, &self.y, left, &self.scale)
            .ok_or(MotionError::NotFiniteAt { time: self.time })?;
        (self.y, self.pace) = (end, pace);
        self.pull += speed * step;
        self.time = if step >= left {
            until
        } else {
            self.time + step
        };
        Ok(spring_impulse(&before, &self.moment(), self.stiffness))
    }

    fn holds_exactly(&self) -> bool {
        false
    }
}
