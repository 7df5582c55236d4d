//! A tip's scene as its fields are.

use super::InForce;
use crate::md::pair::Shift;
use crate::md::system::Integrator;
use crate::record::json_number;
use crate::scene::tip_keys::*;
use crate::scene::{Bath, Lift, TipScene};
use crate::tip::Shape;
use serde_json::Value;

impl TipScene {
    /// Keys and values in force, defaults included: what its fields say.
    pub fn json(&self) -> Value {
        let mut put = InForce::from_read(&self.values);
        shape(&mut put, &self.shape);
        put.number(LAMBDA, self.lambda);
        put.word(READING, self.reading as usize);
        lift(&mut put, self.lift);
        put.number(CUTOFF, self.cutoff);
        let shift = match self.shift {
            Shift::None => 0,
            Shift::Energy => 1,
            Shift::Force => 2,
        };
        put.word(SHIFT, shift);
        put.number(ADHESION, self.adhesion);
        put.number(TEMPERATURE, self.temperature);
        bath(&mut put, self.bath);
        put.number(DAMPING, self.damping);
        for (key, time) in [EQUILIBRATION, DRIVE, REST].into_iter().zip(self.stages) {
            put.number(key, time);
        }
        put.number(TIME_STEP, self.time_step);
        let integrator = match self.integrator {
            Integrator::LeapFrog => 0,
            Integrator::VelocityVerlet => 1,
        };
        put.word(INTEGRATOR, integrator);
        put.number(SKIN, self.skin);
        put.count(SEED, self.seed);
        put.count(SAMPLES, self.samples);
        put.json()
    }
}

/// Crystal and tip.
fn shape(put: &mut InForce, shape: &Shape) {
    put.number(SPACING, shape.spacing);
    put.number(RAISE, shape.raise);
    for (key, count) in [
        (COLUMNS, shape.columns),
        (ROWS, shape.rows),
        (SUBSTRATE_LAYERS, shape.substrate_layers),
        (TIP_LAYERS, shape.tip_layers),
        (SIDE, shape.side),
    ] {
        put.count(key, count as u64);
    }
    put.word(OUTLINE, shape.outline as usize);
    let degrees = put.value(ORIENTATION).unwrap_or(f64::NAN);
    if degrees.to_radians() != shape.orientation {
        put.number(ORIENTATION, shape.orientation.to_degrees());
        put.beside("orientation_radians", json_number(shape.orientation));
    }
}

/// How the driven layers are held; no load is none, written or not.
fn lift(put: &mut InForce, lift: Lift) {
    match lift {
        Lift::Fixed => {
            put.word(HOLD, 0);
            put.optional(LOAD, None);
        }
        Lift::Loaded(force) => {
            put.word(HOLD, 1);
            if put.value(LOAD).unwrap_or(0.0) != -force {
                put.number(LOAD, -force);
            }
        }
    }
}

/// The thermostat; rates of the other one stay as they were read.
fn bath(put: &mut InForce, bath: Bath) {
    match bath {
        Bath::NoseHoover {
            relaxation,
            spares_spin,
        } => {
            put.word(THERMOSTAT, 0);
            put.number(RELAXATION, relaxation);
            put.word(SPIN, usize::from(!spares_spin));
        }
        Bath::Langevin(rate) => {
            put.word(THERMOSTAT, 1);
            put.number(FRICTION, rate);
        }
        Bath::None => put.word(THERMOSTAT, 2),
    }
}
