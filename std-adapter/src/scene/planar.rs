//! The scene of a body that slides along a path in the plane.

use super::body::BODY;
use super::curling::{self, CURLING};
use super::entries::Entries;
use super::key::{Domain, Key, Reader};
use super::problem::Problem;
use super::slider::{MOST_SAMPLES, SAMPLES, STOP_FRACTION, key};
use crate::friction::LARGEST_EXPONENT;
use crate::record::json_number;
use crate::slide::curling::{CurlingModel, CurlingRock};
use crate::slide::planar::{Gradient, Pipe, TallCylinder};
use serde_json::{Map, Value};
use tribos_core::patch::PowerPressure;

/// What slides.
#[derive(Debug)]
pub enum PlanarBody {
    /// A tall cylinder.
    Cylinder(TallCylinder),
    /// A pipe on its end.
    Pipe(Pipe),
    /// A curling rock and the model of its ice.
    Curling(CurlingRock, Box<dyn CurlingModel>),
}

/// What happens where a body would tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tipping {
    /// The run is refused.
    Refuse,
    /// The pressure gradient is held at its limit.
    Clamp,
}

/// A validated scene, in SI units: every number is finite and in its domain.
///
/// ```
/// use tribos::scene::{PlanarBody, PlanarScene, Scene, Tipping, parse_scene, vocabulary};
/// let text = vocabulary("cylinder").ok_or("no cylinder")?.least_text();
/// let parsed = parse_scene("cylinder.toml", &text, &["tipping=clamp".into()])?;
/// let Scene::Planar(scene) = parsed else { unreachable!() };
/// assert_eq!(scene.tipping, Tipping::Clamp);
/// let PlanarBody::Cylinder(cylinder) = &scene.body else { unreachable!() };
/// assert_eq!(cylinder.inertia_ratio, 0.5); // solid, as no other is given
/// assert_eq!(scene.json()["inertia_ratio"], 0.5);
/// assert!(PlanarScene::keys("pipe").is_some_and(|keys| keys[0].name == "body"));
/// assert!(PlanarScene::keys("disk").is_none()); // its path is straight
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct PlanarScene {
    /// What slides.
    pub body: PlanarBody,
    /// Initial speed, along x, in m/s.
    pub speed: f64,
    /// Initial spin, positive counterclockwise, in rad/s.
    pub spin: f64,
    /// In m/s².
    pub gravity: f64,
    /// In kg.
    pub mass: f64,
    /// What happens where the body would tip.
    pub tipping: Tipping,
    /// The run ends when both speeds are below this fraction of their start (alpha ≥ 1).
    pub stop_fraction: f64,
    /// Number of intervals of time in the series.
    pub samples: u32,
    pub(super) values: Map<String, Value>,
    /// The model of a rock as it was read.
    pub(super) model_read: Option<String>,
}

pub(super) const SPEED: Key = key(
    "speed",
    "m/s",
    "initial speed, along x",
    Domain::NotNegative,
);
pub(super) const SPIN: Key = key(
    "spin",
    "rad/s",
    "initial spin, > 0 counterclockwise",
    Domain::Finite,
);
pub(super) const SAMPLE_COUNT: Key = key(
    "samples",
    "-",
    "intervals of time in the series (default 200)",
    Domain::Count {
        up_to: MOST_SAMPLES,
    },
);
pub(super) const COEFFICIENT: Key = key(
    "coefficient",
    "(s/m)^alpha",
    "friction coefficient",
    Domain::Positive,
);
pub(super) const ALPHA: Key = key(
    "alpha",
    "-",
    "exponent of the local law |v|^alpha (default 0, Coulomb)",
    Domain::Between {
        above: -1.0,
        up_to: LARGEST_EXPONENT,
    },
);
pub(super) const GRAVITY: Key = key(
    "gravity",
    "m/s^2",
    "acceleration that presses the body down",
    Domain::Positive,
);
pub(super) const RADIUS: Key = key("radius", "m", "outer radius", Domain::Positive);
pub(super) const HEIGHT: Key = key(
    "height",
    "m",
    "height of the body; its centre of mass is half way up",
    Domain::NotNegative,
);
pub(super) const MASS: Key = key("mass", "kg", "mass of the body", Domain::Positive);
pub(super) const GRADIENT: Key = key(
    "gradient",
    "-",
    "which way the pressure may lean (default all-round)",
    Domain::OneOf(&["all-round", "front-back"]),
);
pub(super) const TIPPING: Key = key(
    "tipping",
    "-",
    "what to do where the body would tip (default refuse)",
    Domain::OneOf(&["refuse", "clamp"]),
);
pub(super) const STOP: Key = key(
    "stop_fraction",
    "-",
    "for alpha >= 1: speeds below this fraction of the start are rest (default 1e-4)",
    Domain::Between {
        above: 0.0,
        up_to: 0.5,
    },
);
pub(super) const INERTIA: Key = key(
    "inertia_ratio",
    "-",
    "C = I/(M R^2) (default: of the uniform body)",
    Domain::Positive,
);
pub(super) const PRESSURE: Key = key(
    "pressure",
    "-",
    "pressure at rest (default uniform)",
    Domain::OneOf(&["uniform", "ring", "flat-punch", "hertz", "paraboloid"]),
);
pub(super) const INNER_RADIUS: Key = key(
    "inner_radius",
    "m",
    "inner radius of the pipe; the outer one for a thin ring",
    Domain::NotNegative,
);

const CYLINDER: &[Key] = &[
    BODY,
    SPEED,
    SPIN,
    COEFFICIENT,
    ALPHA,
    GRAVITY,
    RADIUS,
    HEIGHT,
    MASS,
    INERTIA,
    PRESSURE,
    GRADIENT,
    TIPPING,
    STOP,
    SAMPLE_COUNT,
];
const PIPE: &[Key] = &[
    BODY,
    SPEED,
    SPIN,
    COEFFICIENT,
    ALPHA,
    GRAVITY,
    RADIUS,
    INNER_RADIUS,
    HEIGHT,
    MASS,
    GRADIENT,
    TIPPING,
    STOP,
    SAMPLE_COUNT,
];

/// Takes values and notes them as they are used.
pub(super) struct Taker {
    pub reader: Reader,
    pub values: Map<String, Value>,
}

impl Taker {
    /// A number that must be there.
    pub fn required(&mut self, key: Key) -> f64 {
        let value = self.reader.required(key.name);
        self.note(key, value)
    }

    /// A number with a default.
    pub fn or(&mut self, key: Key, default: f64) -> f64 {
        let value = self.reader.optional(key.name).unwrap_or(default);
        self.note(key, value)
    }

    /// A number that may be left out; null then.
    pub fn optional(&mut self, key: Key) -> Option<f64> {
        let value = self.reader.optional(key.name);
        let json = value.map_or(Value::Null, |value| shown(key, value));
        self.values.insert(key.name.into(), json);
        value
    }

    /// The index of a word.
    pub fn word(&mut self, key: Key) -> usize {
        let index = self.reader.word(key.name);
        if let Domain::OneOf(words) = key.domain {
            let word = words.get(index).copied().unwrap_or_default();
            self.values.insert(key.name.into(), word.into());
        }
        index
    }

    fn note(&mut self, key: Key, value: f64) -> f64 {
        self.values.insert(key.name.into(), shown(key, value));
        value
    }
}

/// A value as JSON: whole numbers for what is counted.
fn shown(key: Key, value: f64) -> Value {
    match key.domain {
        Domain::Count { .. } if key.domain.admits(value) => (value as u64).into(),
        _ => json_number(value),
    }
}

impl PlanarScene {
    /// The vocabulary of a body, if there is one of that name.
    pub fn keys(body: &str) -> Option<&'static [Key]> {
        match body {
            "cylinder" => Some(CYLINDER),
            "pipe" => Some(PIPE),
            "curling" => Some(CURLING),
            _ => None,
        }
    }

    pub(super) fn from_entries(
        keys: &'static [Key],
        entries: Entries,
        problems: Vec<Problem>,
    ) -> Result<Self, Vec<Problem>> {
        let mut take = Taker {
            reader: Reader::new(keys, entries, problems),
            values: Map::new(),
        };
        let body = take.word(BODY);
        let (speed, spin) = (take.required(SPEED), take.required(SPIN));
        if speed == 0.0 && spin == 0.0 {
            let message = "nothing moves: give `speed` or `spin` a value other than 0";
            take.reader.object("speed", message.into());
        }
        let (body, gravity, mass, tipping) = match body {
            1 => dry_body(&mut take, cylinder),
            2 => dry_body(&mut take, pipe),
            _ => curling::body(&mut take),
        };
        let stop_fraction = if keys.contains(&STOP) {
            take.or(STOP, STOP_FRACTION)
        } else {
            STOP_FRACTION
        };
        let samples = take.or(SAMPLE_COUNT, SAMPLES) as u32;
        let model_read = match &body {
            PlanarBody::Curling(_, model) => Some(curling::model_text(model.as_ref())),
            PlanarBody::Cylinder(_) | PlanarBody::Pipe(_) => None,
        };
        take.reader.finish(Self {
            model_read,
            body,
            speed,
            spin,
            gravity,
            mass,
            tipping,
            stop_fraction,
            samples,
            values: take.values,
        })
    }
}

/// What a cylinder and a pipe have in common.
fn dry_body(
    take: &mut Taker,
    shape: fn(&mut Taker, Common) -> PlanarBody,
) -> (PlanarBody, f64, f64, Tipping) {
    let common = Common {
        coefficient: take.required(COEFFICIENT),
        alpha: take.or(ALPHA, 0.0),
        radius: take.required(RADIUS),
        height: take.required(HEIGHT),
        gradient: match take.word(GRADIENT) {
            0 => Gradient::AllRound,
            _ => Gradient::FrontBack,
        },
    };
    let body = shape(take, common);
    let tipping = match take.word(TIPPING) {
        0 => Tipping::Refuse,
        _ => Tipping::Clamp,
    };
    (body, take.required(GRAVITY), take.required(MASS), tipping)
}

struct Common {
    coefficient: f64,
    alpha: f64,
    radius: f64,
    height: f64,
    gradient: Gradient,
}

fn cylinder(take: &mut Taker, common: Common) -> PlanarBody {
    /// Solid and uniform.
    const SOLID: f64 = 0.5;
    let pressure = match take.word(PRESSURE) {
        0 => PowerPressure::UNIFORM,
        1 => PowerPressure::RING,
        2 => PowerPressure::FLAT_PUNCH,
        3 => PowerPressure::HERTZ,
        _ => PowerPressure::PARABOLOID,
    };
    PlanarBody::Cylinder(TallCylinder {
        coefficient: common.coefficient,
        alpha: common.alpha,
        radius: common.radius,
        height: common.height,
        inertia_ratio: take.or(INERTIA, SOLID),
        pressure,
        gradient: common.gradient,
    })
}

fn pipe(take: &mut Taker, common: Common) -> PlanarBody {
    let inner = take.required(INNER_RADIUS);
    if inner > common.radius {
        let message = format!("`inner_radius` must not exceed `radius`, {}", common.radius);
        take.reader.object("inner_radius", message);
    }
    PlanarBody::Pipe(Pipe {
        coefficient: common.coefficient,
        alpha: common.alpha,
        radius: common.radius,
        inner_ratio: inner / common.radius,
        height: common.height,
        gradient: common.gradient,
    })
}
