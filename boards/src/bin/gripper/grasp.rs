//! Close, press, let the object hang, push it: forces on the pads and motion of the object.

use crate::PERIOD;
use crate::controller::{Command, Compensation, Controller, Reference};
use crate::cost::Cost;
use crate::joint::{FINE, FINE_STEPS, Joint};
use crate::object::{LOAD, MU_PRESENT, Object};
use tribos_boards::stack_used;
use tribos_core::twist::Wrench;

/// Position at which the jaw meets the object, m, and speed of the approach, m/s.
const FACE: f32 = 2e-3;
const APPROACH: f32 = 0.01;
/// Rate of the grip force, N/s.
const RISE: f32 = 50.0;
/// Ticks of each phase.
const CLOSING: u32 = 600;
const HANGING: u32 = 1000;
const PUSHED: u32 = 30;
const AFTER: u32 = 500;
/// Additional load that pushes the object aside.
const PUSH: Wrench<f32> = Wrench::new(6.0, 0.0, 0.02);

/// Total load during the push.
pub fn pushed() -> Wrench<f32> {
    LOAD + PUSH
}

/// The firmware, called once per tick of 1 ms.
struct Firmware {
    controller: Controller,
    object: Object,
    /// The commanded grip force, N.
    grip: f32,
}

impl Firmware {
    /// The force of the motor, N; and the object, one tick on.
    fn tick(&mut self, command: &Command, counts: i32, load: Option<&Wrench<f32>>) -> f32 {
        if let Some(load) = load {
            self.object.advance(self.grip, load);
        }
        self.controller.tick(command, counts)
    }
}

/// The gripper, simulated, with its firmware.
pub struct Grasp {
    firmware: Firmware,
    joint: Joint,
    object: Object,
    wanted: f32,
    time: f32,
    /// Bytes of stack of the deepest measured tick.
    pub stack: usize,
}

/// Result of a phase.
#[derive(Default)]
pub struct Phase {
    /// Ticks after which the object was held, simulated and predicted.
    pub last_moving: [u32; 2],
    /// Distance in m, simulated and predicted.
    pub travel: [f32; 2],
    /// Rotation in rad, simulated and predicted.
    pub angle: [f32; 2],
    /// Whether the object has not moved since it was gripped.
    pub has_not_moved: [bool; 2],
    pub is_at_rest: [bool; 2],
}

impl Grasp {
    /// An open gripper that is to press with `wanted` N.
    pub fn new(compensation: Compensation, wanted: f32) -> Option<Self> {
        Some(Self {
            firmware: Firmware {
                controller: Controller::new(compensation).ok()?,
                object: Object::foreseen()?,
                grip: 0.0,
            },
            joint: Joint::new(FACE).ok()?,
            object: Object::new(MU_PRESENT, FINE)?,
            wanted,
            time: 0.0,
            stack: 0,
        })
    }

    /// Closes the jaw and presses; returns the force on the pads, N.
    pub fn close(&mut self, cost: &mut Cost) -> f32 {
        for _ in 0..CLOSING {
            self.tick(None, cost);
        }
        self.joint.pad_force
    }

    /// The object is lifted and hangs in the pads.
    pub fn hang(&mut self, cost: &mut Cost) -> Phase {
        self.go_through(&[(LOAD, HANGING)], cost)
    }

    /// Something pushes it for a moment.
    pub fn push(&mut self, cost: &mut Cost) -> Phase {
        self.go_through(&[(pushed(), PUSHED), (LOAD, AFTER)], cost)
    }

    /// The predicted motion, m and rad, with known friction and grip force.
    pub fn push_as_known(&self) -> Option<[f32; 2]> {
        let mut object = Object::new(MU_PRESENT, PERIOD)?;
        for (load, ticks) in [(pushed(), PUSHED), (LOAD, AFTER)] {
            for _ in 0..ticks {
                object.advance(self.joint.pad_force, &load);
            }
        }
        Some([object.travel(), object.angle])
    }

    fn go_through(&mut self, loads: &[(Wrench<f32>, u32)], cost: &mut Cost) -> Phase {
        let mut phase = Phase::default();
        let mut now = 0;
        for (load, ticks) in loads {
            for _ in 0..*ticks {
                self.tick(Some(load), cost);
                now += 1;
                for (last, object) in phase.last_moving.iter_mut().zip(self.both()) {
                    *last = if object.is_at_rest { *last } else { now };
                }
            }
        }
        let both = self.both();
        phase.travel = both.map(Object::travel);
        phase.angle = both.map(|object| object.angle);
        phase.has_not_moved = both.map(Object::has_not_moved);
        phase.is_at_rest = both.map(|object| object.is_at_rest);
        phase
    }

    /// The simulated and the predicted object.
    fn both(&self) -> [&Object; 2] {
        [&self.object, &self.firmware.object]
    }

    /// Moves the jaw to the object, then raises the force to the wanted one.
    fn command(&mut self) -> Command {
        self.time += PERIOD;
        if self.firmware.grip == 0.0 && self.joint.position < FACE {
            return Command::Follow(Reference {
                position: APPROACH * self.time,
                velocity: APPROACH,
                acceleration: 0.0,
            });
        }
        let next = self.firmware.grip + RISE * PERIOD;
        self.firmware.grip = if next < self.wanted {
            next
        } else {
            self.wanted
        };
        Command::Press(self.firmware.grip)
    }

    fn tick(&mut self, load: Option<&Wrench<f32>>, cost: &mut Cost) {
        let command = self.command();
        let counts = self.joint.counts();
        let mut motor = 0.0;
        let firmware = &mut self.firmware;
        let mut tick = || motor = firmware.tick(&command, counts, load);
        // Stack depth is measured where the object slides; a tick counts once.
        if self.object.is_at_rest {
            cost.count(&mut tick);
        } else {
            let mut counted = || cost.count(&mut tick);
            let depth = stack_used(&mut counted);
            self.stack = self.stack.max(depth);
        }
        for _ in 0..FINE_STEPS {
            self.joint.advance(motor);
            if let Some(load) = load {
                self.object.advance(self.joint.pad_force, load);
            }
        }
    }
}
