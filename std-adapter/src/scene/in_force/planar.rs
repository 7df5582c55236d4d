//! A scene of a body in the plane as its fields are.

use super::InForce;
use crate::record::json_number;
use crate::scene::curling::{self, model_text};
use crate::scene::planar::*;
use crate::scene::{PlanarBody, PlanarScene, Tipping};
use crate::slide::curling::{CurlingModel, CurlingRock};
use crate::slide::planar::{Gradient, Pipe, TallCylinder};
use serde_json::Value;
use tribos_core::patch::PowerPressure;

impl PlanarScene {
    /// The scene with everything that was left to defaults, as JSON: what its fields say.
    pub fn json(&self) -> Value {
        let mut put = InForce::from_read(&self.values);
        put.number(SPEED, self.speed);
        put.number(SPIN, self.spin);
        put.number(GRAVITY, self.gravity);
        put.number(MASS, self.mass);
        put.count(SAMPLE_COUNT, u64::from(self.samples));
        let is_rock = matches!(self.body, PlanarBody::Curling(..));
        // A rock is held at its limit, and its keys say neither.
        if !is_rock || self.tipping != Tipping::Clamp {
            put.word(TIPPING, self.tipping as usize);
        }
        if !is_rock || self.stop_fraction != super::super::slider::STOP_FRACTION {
            put.number(STOP, self.stop_fraction);
        }
        match &self.body {
            PlanarBody::Cylinder(body) => cylinder(&mut put, body),
            PlanarBody::Pipe(body) => pipe(&mut put, body),
            PlanarBody::Curling(body, model) => rock(&mut put, body, model.as_ref(), self),
        }
        put.json()
    }
}

fn cylinder(put: &mut InForce, body: &TallCylinder) {
    dry(
        put,
        [body.coefficient, body.alpha, body.radius, body.height],
    );
    gradient(put, body.gradient);
    put.number(INERTIA, body.inertia_ratio);
    let known = [
        PowerPressure::UNIFORM,
        PowerPressure::RING,
        PowerPressure::FLAT_PUNCH,
        PowerPressure::HERTZ,
        PowerPressure::PARABOLOID,
    ];
    match known.iter().position(|pressure| *pressure == body.pressure) {
        Some(index) => put.word(PRESSURE, index),
        None => put.beside("pressure", format!("{:?}", body.pressure).into()),
    }
}

fn pipe(put: &mut InForce, body: &Pipe) {
    dry(
        put,
        [body.coefficient, body.alpha, body.radius, body.height],
    );
    gradient(put, body.gradient);
    let read = put.value(INNER_RADIUS).unwrap_or(f64::NAN);
    if read / body.radius != body.inner_ratio {
        put.number(INNER_RADIUS, body.inner_ratio * body.radius);
        put.beside("inner_ratio", json_number(body.inner_ratio));
    }
}

/// What a cylinder and a pipe have in common.
fn dry(put: &mut InForce, numbers: [f64; 4]) {
    for (key, number) in [COEFFICIENT, ALPHA, RADIUS, HEIGHT]
        .into_iter()
        .zip(numbers)
    {
        put.number(key, number);
    }
}

fn gradient(put: &mut InForce, gradient: Gradient) {
    let index = match gradient {
        Gradient::AllRound => 0,
        Gradient::FrontBack => 1,
    };
    put.word(GRADIENT, index);
}

/// A model that is not the one that was read is told by its own text.
fn rock(put: &mut InForce, rock: &CurlingRock, model: &dyn CurlingModel, scene: &PlanarScene) {
    for (key, number) in curling::rock_numbers(rock) {
        put.number(key, number);
    }
    if rock.gravity != scene.gravity {
        put.beside("rock_gravity", json_number(rock.gravity));
    }
    if scene.model_read.as_deref() != Some(&model_text(model)) {
        put.beside("model", model.name().into());
        put.beside("model_parameters", model_text(model).into());
    }
}
