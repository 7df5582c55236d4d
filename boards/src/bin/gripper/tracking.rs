//! Tracking an oscillation: error of the jaw with and without friction compensation.

use crate::PERIOD;
use crate::controller::{Command, Compensation, Controller, Reference};
use crate::cost::Cost;
use crate::joint::{FINE_STEPS, Joint};
use tribos_core::Real;
use tribos_core::law::LawError;

/// Half the stroke, m.
const AMPLITUDE: f32 = 5e-3;
/// rad/s; a period takes 2 s.
const FREQUENCY: f32 = core::f32::consts::PI;
/// Two periods.
const TICKS: u32 = 4000;

/// Tracking error of the jaw, m.
pub struct Tracking {
    pub rms: f32,
    pub worst: f32,
}

/// An oscillation by rotation of a vector, because a sine per tick would cost more than the controller.
struct Oscillation {
    turn: [f32; 2],
    now: [f32; 2],
}

impl Oscillation {
    fn new() -> Self {
        let angle = FREQUENCY * PERIOD;
        Self {
            turn: [Real::cos(angle), Real::sin(angle)],
            now: [1.0, 0.0],
        }
    }

    fn next(&mut self) -> Reference {
        let ([c, s], [x, y]) = (self.turn, self.now);
        self.now = [c * x - s * y, s * x + c * y];
        let [x, y] = self.now;
        Reference {
            position: AMPLITUDE * (1.0 - x),
            velocity: AMPLITUDE * FREQUENCY * y,
            acceleration: AMPLITUDE * FREQUENCY * FREQUENCY * x,
        }
    }
}

/// Follows the oscillation from rest.
pub fn follow(compensation: Compensation, cost: &mut Cost) -> Result<Tracking, LawError> {
    let mut joint = Joint::new(f32::INFINITY)?;
    let mut controller = Controller::new(compensation)?;
    let mut oscillation = Oscillation::new();
    let (mut sum, mut worst) = (0.0, 0.0);
    for _ in 0..TICKS {
        let wanted = oscillation.next();
        let mut motor = 0.0;
        let counts = joint.counts();
        cost.count(&mut || motor = controller.tick(&Command::Follow(wanted), counts));
        for _ in 0..FINE_STEPS {
            joint.advance(motor);
        }
        // The reference is the wanted position at the end of the tick.
        let error = (wanted.position - joint.position).abs();
        sum += error * error;
        worst = if error > worst { error } else { worst };
    }
    let rms = Real::sqrt(sum / TICKS as f32);
    Ok(Tracking { rms, worst })
}
