//! What engines call their torsional friction, and what they make of it.

use super::torsion::Model;
use std::f64::consts::PI;

/// A parameter of an engine.
pub struct Engine {
    /// The engine, in one word.
    pub name: &'static str,
    /// What is set, and where.
    pub parameter: &'static str,
    /// How the value follows from l.
    pub value: Value,
    /// How the engine limits force and torque.
    pub model: Option<Model>,
}

/// The value of a parameter, for the length l = T₀/(μN) or another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// μ l, a length: largest torque over load.
    Length,
    /// The radius a of a Hertzian patch, torque 3π μ a N/16, beside the coefficient μ.
    PatchRadius,
    /// There is none.
    Absent,
}

/// Largest torque of a Hertzian patch per μ, load and radius.
const HERTZ_ARM: f64 = 3.0 * PI / 16.0;

impl Value {
    /// Its number.
    pub fn of(self, mu: f64, length: f64) -> Option<f64> {
        match self {
            Self::Length => Some(mu * length),
            Self::PatchRadius => Some(length / HERTZ_ARM),
            Self::Absent => None,
        }
    }
}

/// All engines.
pub const ENGINES: [Engine; 10] = [
    Engine {
        name: "mujoco",
        parameter: "geom friction[1], condim 4 or 6, cone elliptic",
        value: Value::Length,
        model: Some(Model::Ellipsoid),
    },
    Engine {
        name: "mujoco",
        parameter: "geom friction[1], condim 4 or 6, cone pyramidal",
        value: Value::Length,
        model: Some(Model::Pyramid),
    },
    Engine {
        name: "newton",
        parameter: "mu_torsional, SolverMuJoCo: as MuJoCo",
        value: Value::Length,
        model: Some(Model::Ellipsoid),
    },
    Engine {
        name: "newton",
        parameter: "mu_torsional of both shapes, SolverXPBD",
        value: Value::Length,
        model: Some(Model::Separate),
    },
    Engine {
        name: "gazebo",
        parameter: "torsional patch_radius, coefficient mu, ODE",
        value: Value::PatchRadius,
        model: Some(Model::Separate),
    },
    Engine {
        name: "gazebo",
        parameter: "torsional coefficient (ground 0), Bullet-Featherstone",
        value: Value::Length,
        model: Some(Model::Separate),
    },
    Engine {
        name: "gazebo",
        parameter: "torsional: DART leaves it out",
        value: Value::Absent,
        model: None,
    },
    Engine {
        name: "bullet",
        parameter: "spinningFriction, friction 1 on the other body",
        value: Value::Length,
        model: Some(Model::Separate),
    },
    Engine {
        name: "drake",
        parameter: "none at points; hydroelastic contact has the patch",
        value: Value::Absent,
        model: None,
    },
    Engine {
        name: "genesis",
        parameter: "none at points",
        value: Value::Absent,
        model: None,
    },
];
