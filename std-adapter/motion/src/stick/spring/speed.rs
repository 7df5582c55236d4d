//! Friction that depends on the speed alone: rest is exact where the law holds, motion is integrated, and
//! the instant of rest is found as a root of the step's length.

use super::motion::{SpringIntegrator, SpringSample, spring_impulse};
use super::rosenbrock::{OdeSystem, StepSizeControl, trial};
use crate::stick::MotionError;
use tribos_core::law::LocalLaw;
use tribos_friction::AnyLaw;

/// A body under a law of the speed.
#[derive(Debug)]
pub(super) struct SpeedMotion {
    law: AnyLaw<f64>,
    mass: f64,
    stiffness: f64,
    load: f64,
    /// What friction holds at rest; 0 for laws that vanish there, which never hold.
    limit: f64,
    /// Speed below which a law that vanishes at rest is replaced by a viscous one.
    floor: f64,
    time: f64,
    pull: f64,
    position: f64,
    velocity: f64,
    force: f64,
    /// Direction of the motion; 0 at rest.
    sign: f64,
    pace: StepSizeControl,
    scale: [f64; 2],
}

/// The floor as a share of the speed of the pull.
const FLOOR: f64 = 1e-9;
/// Iterations of the search for the instant of rest; a dozen is usual.
const MOST_ITERATIONS: u32 = 200;

impl SpeedMotion {
    /// At rest with a relaxed spring. `speed` is that of the pull.
    pub fn new(
        law: AnyLaw<f64>,
        [mass, stiffness, load]: [f64; 3],
        speed: f64,
        tolerance: f64,
    ) -> Self {
        let limit = load * law.friction(0.0);
        let usual = load * law.friction(speed);
        let first = 1e-3 * (mass / stiffness).sqrt();
        let force = if limit > 0.0 { limit } else { usual };
        Self {
            law,
            mass,
            stiffness,
            load,
            limit,
            floor: FLOOR * speed,
            time: 0.0,
            pull: 0.0,
            position: 0.0,
            velocity: 0.0,
            force: 0.0,
            sign: 0.0,
            pace: StepSizeControl::new(first, tolerance),
            scale: [speed, force],
        }
    }

    fn flow(&self, speed: f64) -> SpeedFlow<'_> {
        SpeedFlow {
            body: self,
            speed,
            sign: self.sign,
        }
    }

    /// Waits at rest, until it lets go at most.
    fn wait(&mut self, speed: f64, left: f64) {
        let rate = self.stiffness * speed;
        let release = if rate == 0.0 {
            f64::INFINITY
        } else {
            (self.limit - self.force * rate.signum()) / rate.abs()
        };
        let lets_go = release <= left;
        let wait = if lets_go { release } else { left };
        self.force = if lets_go {
            self.limit.copysign(rate)
        } else {
            self.force + rate * wait
        };
        if lets_go {
            self.sign = rate.signum();
        }
        self.pull += speed * wait;
        self.time += wait;
    }

    /// Moves on by one step, to the instant of rest at most.
    fn slide(&mut self, speed: f64, left: f64) -> Result<(), MotionError> {
        let time = self.time;
        let lost = || MotionError::NotFiniteAt { time };
        let start = [self.velocity, self.force];
        let mut pace = self.pace.clone();
        let flow = self.flow(speed);
        let (mut end, mut step) = pace
            .step(&flow, &start, left, &self.scale)
            .ok_or_else(lost)?;
        let mut rests = false;
        if self.limit > 0.0 && self.sign * end[0] < 0.0 {
            (end, step) = self.rest(&flow, &start, step).ok_or_else(lost)?;
            end[0] = 0.0;
            rests = true;
        }
        self.pace = pace;
        [self.velocity, self.force] = end;
        if rests {
            let holds = self.force.abs() <= self.limit;
            self.sign = if holds { 0.0 } else { self.force.signum() };
        }
        self.pull += speed * step;
        self.position += speed * step - (end[1] - start[1]) / self.stiffness;
        self.time += step;
        Ok(())
    }

    /// The step that ends with velocity zero, shorter than `beyond`, by the Illinois rule.
    fn rest(&self, flow: &SpeedFlow<'_>, start: &[f64; 2], beyond: f64) -> Option<([f64; 2], f64)> {
        let at = |step: f64| trial(flow, start, step, &self.scale).0;
        let ahead = |end: &[f64; 2]| self.sign * end[0];
        let (mut low, mut high) = (0.0, beyond);
        let (mut left, mut right) = (ahead(start), ahead(&at(beyond)));
        // A body that has just been released moves before it rests.
        for _ in 0..MOST_ITERATIONS {
            if left > 0.0 {
                break;
            }
            let half = 0.5 * high;
            let moved = ahead(&at(half));
            if moved > 0.0 {
                (low, left) = (half, moved);
            } else {
                (high, right) = (half, moved);
            }
        }
        let mut side = 0;
        for _ in 0..MOST_ITERATIONS {
            let step = low + (high - low) * left / (left - right);
            let end = at(step);
            let value = ahead(&end);
            let is_found = value == 0.0 || step <= low || step >= high;
            if is_found || high - low <= f64::EPSILON * self.time.max(high) {
                return end.iter().all(|x| x.is_finite()).then_some((end, step));
            }
            if value > 0.0 {
                (low, left) = (step, value);
                right *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (high, right) = (step, value);
                left *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        None
    }
}

/// (v, F) while the direction of motion stays.
struct SpeedFlow<'a> {
    body: &'a SpeedMotion,
    speed: f64,
    sign: f64,
}

impl SpeedFlow<'_> {
    /// Friction against the motion and its slope.
    fn friction(&self, velocity: f64) -> [f64; 2] {
        let SpeedMotion {
            law,
            load,
            floor,
            limit,
            ..
        } = self.body;
        let size = velocity.abs();
        if *limit > 0.0 {
            // Beyond the instant of rest, where trials may look, friction is what it is at rest.
            let ahead = self.sign * velocity;
            let slope = |v: f64| load * law.slope(v);
            return if ahead > *floor {
                [self.sign * load * law.friction(ahead), slope(ahead)]
            } else {
                [self.sign * limit, slope(*floor)]
            };
        }
        if size > *floor {
            [
                load * law.friction(size) * velocity.signum(),
                load * law.slope(size),
            ]
        } else {
            let slope = load * law.friction(*floor) / floor;
            [slope * velocity, slope]
        }
    }
}

impl OdeSystem<2> for SpeedFlow<'_> {
    fn rate(&self, &[velocity, force]: &[f64; 2]) -> [f64; 2] {
        let [friction, _] = self.friction(velocity);
        let (mass, stiffness) = (self.body.mass, self.body.stiffness);
        [
            (force - friction) / mass,
            stiffness * (self.speed - velocity),
        ]
    }

    fn jacobian(&self, &[velocity, _]: &[f64; 2]) -> [[f64; 2]; 2] {
        let [_, slope] = self.friction(velocity);
        let (mass, stiffness) = (self.body.mass, self.body.stiffness);
        [[-slope / mass, 1.0 / mass], [-stiffness, 0.0]]
    }
}

impl SpringIntegrator for SpeedMotion {
    fn moment(&self) -> SpringSample {
        let is_at_rest = self.holds_exactly() && self.sign == 0.0;
        let friction = if is_at_rest {
            self.force
        } else {
            self.flow(0.0).friction(self.velocity)[0]
        };
        SpringSample {
            time: self.time,
            pull: self.pull,
            position: self.position,
            velocity: self.velocity,
            spring_force: self.force,
            friction,
            state: 0.0,
            slips: !is_at_rest,
        }
    }

    fn step(&mut self, speed: f64, until: f64) -> Result<f64, MotionError> {
        let before = self.moment();
        let left = until - self.time;
        if self.holds_exactly() && self.sign == 0.0 {
            self.wait(speed, left);
        } else {
            self.slide(speed, left)?;
        }
        if until - self.time <= f64::EPSILON * until.abs() {
            self.time = until;
        }
        let after = self.moment();
        Ok(spring_impulse(&before, &after, self.stiffness))
    }

    fn holds_exactly(&self) -> bool {
        self.limit > 0.0
    }
}
