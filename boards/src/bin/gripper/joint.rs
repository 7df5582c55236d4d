//! The jaw on its lead screw: a mass with friction that meets the pads of the object.

use crate::PERIOD;
use tribos_core::law::{Bristle, LawError, LuGre, LuGreParameters};

/// Parameters of a jaw.
pub struct Jaw {
    /// kg, the motor's inertia included
    pub mass: f32,
    /// N, N, m/s, N/m, N s/m, N s/m
    pub friction: LuGreParameters<f32>,
}

/// The identified parameters, which the controller uses.
pub const MODEL: Jaw = Jaw {
    mass: 0.2,
    friction: LuGreParameters {
        coulomb_force: 3.0,
        static_force: 4.0,
        stribeck_speed: 5e-3,
        stiffness: 1e5,
        bristle_damping: 100.0,
        viscous_damping: 8.0,
    },
};

/// The true parameters: warm, worn and a little heavier.
const PRESENT: Jaw = Jaw {
    mass: 0.21,
    friction: LuGreParameters {
        coulomb_force: 3.25,
        static_force: 4.2,
        stribeck_speed: 6e-3,
        stiffness: 0.9e5,
        bristle_damping: 110.0,
        viscous_damping: 7.0,
    },
};

/// Length of a count of the encoder in m: 14 bits on a turn of 5 mm.
pub const COUNT: f32 = 5e-3 / 16384.0;
/// Steps of the simulated jaw in a tick of the controller.
pub const FINE_STEPS: u32 = 10;
/// Their length, s.
pub const FINE: f32 = PERIOD / FINE_STEPS as f32;
/// Rubber of both pads in a row, N/m and N s/m.
const PAD_STIFFNESS: f32 = 2e4;
const PAD_DAMPING: f32 = 20.0;

/// The jaw, simulated.
pub struct Joint {
    friction: LuGre<f32>,
    bristle: Bristle<f32>,
    /// m
    pub position: f32,
    /// m/s
    velocity: f32,
    /// Position at which the pads meet the object, m.
    face: f32,
    /// N
    pub pad_force: f32,
}

impl Joint {
    /// At rest at 0, with an object at `face`, which may be infinitely far.
    pub fn new(face: f32) -> Result<Self, LawError> {
        Ok(Self {
            friction: LuGre::new(PRESENT.friction)?,
            bristle: Bristle::RELAXED,
            position: 0.0,
            velocity: 0.0,
            face,
            pad_force: 0.0,
        })
    }

    /// Reading of the encoder.
    pub fn counts(&self) -> i32 {
        (self.position / COUNT) as i32
    }

    /// Advances by a fine step under the force of the motor, in N.
    pub fn advance(&mut self, motor: f32) {
        let (bristle, friction) = self.friction.step(self.bristle, self.velocity, FINE);
        self.bristle = bristle;
        // Compressed rubber, which never pulls.
        let pressed = self.position - self.face;
        let pad = PAD_STIFFNESS * pressed + PAD_DAMPING * self.velocity;
        self.pad_force = if pressed > 0.0 && pad > 0.0 { pad } else { 0.0 };
        self.velocity += FINE / PRESENT.mass * (motor - friction - self.pad_force);
        self.position += FINE * self.velocity;
    }
}
