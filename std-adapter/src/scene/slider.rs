//! The scene of one sliding, spinning body.

use super::entries::Entries;
use super::key::{Domain, Key, Reader};
use super::problem::Problem;
use crate::friction::LARGEST_EXPONENT;
use crate::record::json_number;
use serde_json::{Map, Value};

/// Which units a scene is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Metres, seconds, kilograms.
    Si,
    /// Speeds in √(gR), times in √(R/g), lengths in R: gravity, radius and mass are 1.
    Dimensionless,
}

/// Which stepper follows the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stepper {
    /// Adaptive, stops exactly.
    Exact,
    /// The thesis' fixed-step Verlet method.
    Verlet,
}

/// A validated scene: every number is finite and in its domain.
///
/// ```
/// use tribos::{scene::{SliderScene, Stepper, Units, parse_slider}, slide::run};
/// let text = "units = \"dimensionless\"\nspeed = 1\nspin = 0\ncoefficient = 0.25\n\
///             alpha = 0\ninertia_ratio = 0.5";
/// let scene: SliderScene = parse_slider("disk.toml", text, &[])?;
/// assert_eq!((scene.units, scene.stepper), (Units::Dimensionless, Stepper::Exact));
/// assert_eq!([scene.gravity, scene.radius, scene.mass], [1.0; 3]);
/// let way = run(&scene, |_| ())?.outcome.distance; // in radii
/// assert!((way - 2.0).abs() < 1e-13); // v²/(2 mu g)
/// let values = scene.json();
/// let others = SliderScene::KEYS.iter().filter(|key| key.name != "body");
/// assert!(others.clone().all(|key| values.get(key.name).is_some()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderScene {
    /// Initial sliding speed, in m/s.
    pub speed: f64,
    /// Initial spin, in rad/s.
    pub spin: f64,
    /// Friction coefficient γ (μ for alpha = 0), in (s/m)^alpha.
    pub coefficient: f64,
    /// Exponent of the local law.
    pub alpha: f64,
    /// Gravity, in m/s².
    pub gravity: f64,
    /// Radius of the contact, in m.
    pub radius: f64,
    /// Mass, in kg.
    pub mass: f64,
    /// C = I/(M R²).
    pub inertia_ratio: f64,
    /// Units of all of the above.
    pub units: Units,
    /// Stepper.
    pub stepper: Stepper,
    /// Length of a step, in s; chosen from the motion if `None`.
    pub time_step: Option<f64>,
    /// End of the run, in s; rest if `None`.
    pub duration: Option<f64>,
    /// The run ends when both speeds are below this fraction of their start (alpha ≥ 1).
    pub stop_fraction: f64,
    /// Number of steps recorded when `time_step` is left out.
    pub samples: u32,
}

/// Below this fraction of its initial value a speed counts as rest where the motion never ends
/// (thesis, section 3.4.5).
pub(super) const STOP_FRACTION: f64 = 1e-4;
/// Steps recorded unless the scene says otherwise.
pub(super) const SAMPLES: f64 = 200.0;
/// Bounds of what a file can reasonably hold.
pub(super) const MOST_SAMPLES: f64 = 1_000_000.0;

impl SliderScene {
    /// The vocabulary, in the order of the documentation.
    pub const KEYS: &'static [Key] = &[
        key("speed", "m/s", "initial sliding speed", Domain::NotNegative),
        key(
            "spin",
            "rad/s",
            "initial spin, of either sign",
            Domain::Finite,
        ),
        key(
            "coefficient",
            "(s/m)^alpha",
            "friction coefficient",
            Domain::Positive,
        ),
        key(
            "alpha",
            "-",
            "exponent of the local law |v|^alpha, 0 for Coulomb",
            Domain::Between {
                above: -1.0,
                up_to: LARGEST_EXPONENT,
            },
        ),
        key(
            "gravity",
            "m/s^2",
            "acceleration that presses the body down",
            Domain::Positive,
        ),
        key("radius", "m", "radius of the contact", Domain::Positive),
        key("mass", "kg", "mass of the body", Domain::Positive),
        key(
            "inertia_ratio",
            "-",
            "C = I/(M R^2), 0.5 for a disk",
            Domain::Positive,
        ),
        key(
            "units",
            "-",
            "unit system (default si)",
            Domain::OneOf(&["si", "dimensionless"]),
        ),
        key(
            "stepper",
            "-",
            "method (default exact)",
            Domain::OneOf(&["exact", "verlet"]),
        ),
        key(
            "time_step",
            "s",
            "length of a step (default: chosen)",
            Domain::Positive,
        ),
        key(
            "duration",
            "s",
            "end of the run (default: rest)",
            Domain::Positive,
        ),
        key(
            "stop_fraction",
            "-",
            "for alpha >= 1: speeds below this fraction of the start are rest (default 1e-4)",
            Domain::Between {
                above: 0.0,
                up_to: 0.5,
            },
        ),
        key(
            "samples",
            "-",
            "number of recorded steps (default 200)",
            Domain::Count {
                up_to: MOST_SAMPLES,
            },
        ),
        super::body::BODY,
    ];

    pub(super) fn from_entries(
        entries: Entries,
        problems: Vec<Problem>,
    ) -> Result<Self, Vec<Problem>> {
        let mut reader = Reader::new(Self::KEYS, entries, problems);
        let units = [Units::Si, Units::Dimensionless][reader.word("units").min(1)];
        let stepper = [Stepper::Exact, Stepper::Verlet][reader.word("stepper").min(1)];
        if reader.word("body") != 0 {
            let message = "only a disk is read here; this body has a vocabulary of its own";
            reader.object("body", message.into());
        }
        let [gravity, radius, mass] =
            ["gravity", "radius", "mass"].map(|name| scale(&mut reader, units, name));
        let scene = Self {
            speed: reader.required("speed"),
            spin: reader.required("spin"),
            coefficient: reader.required("coefficient"),
            alpha: reader.required("alpha"),
            gravity,
            radius,
            mass,
            inertia_ratio: reader.required("inertia_ratio"),
            units,
            stepper,
            time_step: reader.optional("time_step"),
            duration: reader.optional("duration"),
            stop_fraction: reader.optional("stop_fraction").unwrap_or(STOP_FRACTION),
            samples: reader.optional("samples").unwrap_or(SAMPLES) as u32,
        };
        if scene.speed == 0.0 && scene.spin == 0.0 {
            reader.object(
                "speed",
                "nothing moves: give `speed` or `spin` a value other than 0".into(),
            );
        }
        reader.finish(scene)
    }
}

impl SliderScene {
    /// The scene with everything that was left to defaults, as JSON.
    pub fn json(&self) -> Value {
        let mut map = Map::new();
        for (name, value) in [
            ("speed", self.speed),
            ("spin", self.spin),
            ("coefficient", self.coefficient),
            ("alpha", self.alpha),
            ("gravity", self.gravity),
            ("radius", self.radius),
            ("mass", self.mass),
            ("inertia_ratio", self.inertia_ratio),
            ("stop_fraction", self.stop_fraction),
        ] {
            map.insert(name.into(), json_number(value));
        }
        let optional = |value: Option<f64>| value.map_or(Value::Null, json_number);
        map.insert("time_step".into(), optional(self.time_step));
        map.insert("duration".into(), optional(self.duration));
        map.insert("samples".into(), self.samples.into());
        let units = match self.units {
            Units::Si => "si",
            Units::Dimensionless => "dimensionless",
        };
        map.insert("units".into(), units.into());
        let stepper = match self.stepper {
            Stepper::Exact => "exact",
            Stepper::Verlet => "verlet",
        };
        map.insert("stepper".into(), stepper.into());
        Value::Object(map)
    }
}

/// Gravity, radius and mass: needed in SI, 1 and not to be given in dimensionless scenes.
fn scale(reader: &mut Reader, units: Units, name: &str) -> f64 {
    match units {
        Units::Si => reader.required(name),
        Units::Dimensionless => {
            if reader.is_given(name) && reader.optional(name) != Some(1.0) {
                let message = format!("`{name}` is 1 in a dimensionless scene; leave it out");
                reader.object(name, message);
            }
            1.0
        }
    }
}

pub(super) const fn key(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    domain: Domain,
) -> Key {
    Key {
        name,
        unit,
        meaning,
        domain,
    }
}
