//! The controller of the jaw: it follows a position, or presses with a force.

use crate::PERIOD;
use crate::joint::{COUNT, MODEL};
use tribos_core::law::{Bristle, LawError, LuGre};

/// A motion to follow: m, m/s, m/s².
#[derive(Clone, Copy)]
pub struct Reference {
    pub position: f32,
    pub velocity: f32,
    pub acceleration: f32,
}

/// Task of the jaw in this tick.
#[derive(Clone, Copy)]
pub enum Command {
    /// Follow a motion.
    Follow(Reference),
    /// Press with this force, in N.
    Press(f32),
}

/// Whether the motor compensates friction.
#[derive(Clone, Copy)]
pub enum Compensation {
    /// By the LuGre model.
    LuGre,
    /// Not at all.
    Absent,
}

/// N/m and N s/m: critically damped at 20 Hz.
const STIFFNESS: f32 = 3200.0;
const DAMPING: f32 = 50.0;
/// Damping of the jaw while it presses, N s/m.
const CALMING: f32 = 60.0;

/// State of the controller: the model, its bristle and the last position.
pub struct Controller {
    friction: LuGre<f32>,
    bristle: Bristle<f32>,
    compensation: Compensation,
    counts: i32,
}

impl Controller {
    pub fn new(compensation: Compensation) -> Result<Self, LawError> {
        Ok(Self {
            friction: LuGre::new(MODEL.friction)?,
            bristle: Bristle::RELAXED,
            compensation,
            counts: 0,
        })
    }

    /// The force of the motor, N.
    pub fn tick(&mut self, command: &Command, counts: i32) -> f32 {
        let position = counts as f32 * COUNT;
        let velocity = counts.wrapping_sub(self.counts) as f32 * (COUNT / PERIOD);
        self.counts = counts;
        match command {
            // Friction is predicted from the commanded velocity, which has no noise.
            Command::Follow(wanted) => {
                STIFFNESS * (wanted.position - position)
                    + DAMPING * (wanted.velocity - velocity)
                    + MODEL.mass * wanted.acceleration
                    + self.friction(wanted.velocity)
            }
            Command::Press(force) => force - CALMING * velocity + self.friction(velocity),
        }
    }

    /// Friction in the next tick, N.
    fn friction(&mut self, velocity: f32) -> f32 {
        let (bristle, force) = self.friction.step(self.bristle, velocity, PERIOD);
        self.bristle = bristle;
        match self.compensation {
            Compensation::LuGre => force,
            Compensation::Absent => 0.0,
        }
    }
}
