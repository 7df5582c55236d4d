//! The data that all frames of a run share.

use crate::record::{digest, verified, with_digest};
use serde_json::{Map, Value, json};

/// The version of `bodies.json`.
const FORMAT: u64 = 3;

/// Kind of simulation.
///
/// ```
/// use tribos::record::frames::Kind;
/// let kinds = [Kind::Powder, Kind::Grains, Kind::Gas, Kind::Tip];
/// assert_eq!(kinds.map(Kind::name), ["powder", "grains", "gas", "tip"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Spheres under a piston. *Units*: R, F_coh, √(ρR⁴/F_coh).
    Powder,
    /// Grains in a box. *Units*: SI, or those of the scene.
    Grains,
    /// Atoms of a tip on a substrate. *Units*: σ, ε, σ√(m/ε).
    Tip,
    /// Spheres of a gas. *Units*: R, m, R√(m/T₀).
    Gas,
}

/// Bodies of a run, the same in all its frames.
///
/// ```
/// use tribos::record::frames::{Bodies, FrameFolder, Kind};
/// // Two atoms in two layers, one of which is to stand out; every tenth state may be kept.
/// let atoms = Bodies {
///     kind: Kind::Tip,
///     scene: serde_json::json!({"lambda": 0.02}),
///     limit: 100,
///     stride: 10,
///     sides: [8.0, 8.0],
///     periods: [Some(8.0), Some(8.0), None],
///     radii: vec![0.5; 2],
///     materials: Vec::new(),
///     densities: Vec::new(),
///     layers: vec![0, 1],
///     parts: vec![0, 1],
///     marked: vec![1],
/// };
/// # let home = tempfile::tempdir()?;
/// # let path = home.path().join("frames");
/// let film = FrameFolder::begin(&path, &atoms)?;
/// assert_eq!([film.wants(10), film.wants(15)], [true, false]);
/// assert_eq!(FrameFolder::bodies(&path)?, Some(atoms));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Bodies {
    /// Kind of simulation.
    pub kind: Kind,
    /// The scene of the run as JSON: frames belong to the run of one scene.
    pub scene: Value,
    /// Largest number of frames that are kept.
    pub limit: u64,
    /// Steps between states that may be kept, at least 1.
    pub stride: u64,
    /// Sides of the cell along x and y.
    pub sides: [f64; 2],
    /// Periods along x, y and z, `None` along an open axis.
    pub periods: [Option<f64>; 3],
    /// Radii.
    pub radii: Vec<f64>,
    /// Numbers of the materials, from 1; empty if there is one.
    pub materials: Vec<u8>,
    /// Densities; empty if they are not known.
    pub densities: Vec<f64>,
    /// Layer of each body from below; empty if there are none.
    pub layers: Vec<u16>,
    /// Part of each body, as an index into `tip::AtomRole::ALL`; empty if there are none.
    pub parts: Vec<u8>,
    /// Bodies that are drawn in another colour.
    pub marked: Vec<u32>,
}

impl Kind {
    const NAMES: [(Self, &str); 4] = [
        (Self::Powder, "powder"),
        (Self::Grains, "grains"),
        (Self::Tip, "tip"),
        (Self::Gas, "gas"),
    ];

    /// The kind of a name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let known = Self::NAMES.into_iter().find(|(_, known)| *known == name);
        known.map(|(kind, _)| kind)
    }

    /// Name of the kind in scenes.
    pub fn name(self) -> &'static str {
        match self {
            Self::Powder => Self::NAMES[0].1,
            Self::Grains => Self::NAMES[1].1,
            Self::Tip => Self::NAMES[2].1,
            Self::Gas => Self::NAMES[3].1,
        }
    }
}

impl Bodies {
    /// The text of `bodies.json`.
    pub(super) fn text(&self) -> String {
        let mut value = json!({
            "format": FORMAT,
            "body": self.kind.name(),
            "scene": self.scene,
            "particles": self.radii.len(),
            "frames": self.limit,
            "stride": self.stride,
            "sides": self.sides,
            "periods": self.periods,
            "radii": one_or_all(&self.radii),
        });
        if !self.materials.is_empty() {
            value["materials"] = json!(self.materials);
        }
        if !self.densities.is_empty() {
            value["densities"] = one_or_all(&self.densities);
        }
        if !self.layers.is_empty() {
            value["layers"] = json!(self.layers);
            value["parts"] = json!(self.parts);
            value["marked"] = json!(self.marked);
        }
        match value {
            Value::Object(map) => with_digest(map),
            _ => with_digest(Map::new()),
        }
    }

    /// Digest of kind and scene, which identifies the frames of the run.
    pub(super) fn run(&self) -> u128 {
        let about = format!("{} {} {}", self.kind.name(), self.radii.len(), self.scene);
        digest(about.as_bytes())
    }

    /// Parses the text of `bodies.json`; `None` if it is invalid.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let value = verified(text)?;
        if value["format"].as_u64() != Some(FORMAT) {
            return None;
        }
        let name = value["body"].as_str()?;
        let kind = Kind::named(name)?;
        let count = usize::try_from(value["particles"].as_u64()?).ok()?;
        // Particles and walls must fit into 32-bit numbers.
        if u32::try_from(count).ok()? > u32::MAX / 2 {
            return None;
        }
        let numbers = |name: &str| match value[name].as_f64() {
            Some(one) => Some(vec![one; count]),
            None => list(&value[name], Value::as_f64),
        };
        let period = |value: &Value| match value {
            Value::Null => Some(None),
            period => period.as_f64().map(Some),
        };
        let small = |value: &Value| u16::try_from(value.as_u64()?).ok();
        let tiny = |value: &Value| u8::try_from(value.as_u64()?).ok();
        let index = |value: &Value| u32::try_from(value.as_u64()?).ok();
        let bodies = Self {
            kind,
            scene: value["scene"].clone(),
            limit: value["frames"].as_u64()?,
            stride: value["stride"].as_u64()?,
            sides: <[f64; 2]>::try_from(list(&value["sides"], Value::as_f64)?).ok()?,
            periods: <[_; 3]>::try_from(list(&value["periods"], period)?).ok()?,
            radii: numbers("radii")?,
            materials: list(&value["materials"], tiny)?,
            densities: numbers("densities")?,
            layers: list(&value["layers"], small)?,
            parts: list(&value["parts"], tiny)?,
            marked: list(&value["marked"], index)?,
        };
        bodies.is_sound().then_some(bodies)
    }

    fn is_sound(&self) -> bool {
        let positive = |x: &f64| *x > 0.0 && x.is_finite();
        let count = self.radii.len();
        let lengths = [
            self.layers.len(),
            self.parts.len(),
            self.materials.len(),
            self.densities.len(),
        ];
        let numbers = self.sides.iter().chain(self.periods.iter().flatten());
        let mut numbers = numbers.chain(&self.radii).chain(&self.densities);
        self.stride > 0
            && numbers.all(positive)
            && lengths.iter().all(|&given| given == 0 || given == count)
            && self.materials.iter().all(|&material| material > 0)
            && self.marked.iter().all(|&body| (body as usize) < count)
    }
}

/// One number if it is that of all, else all.
fn one_or_all(numbers: &[f64]) -> Value {
    match numbers {
        [one, rest @ ..] if rest.iter().all(|other| other == one) => json!(one),
        all => json!(all),
    }
}

/// A list of numbers, empty where it is missing.
fn list<T>(value: &Value, number: impl Fn(&Value) -> Option<T>) -> Option<Vec<T>> {
    match value {
        Value::Null => Some(Vec::new()),
        Value::Array(items) => items.iter().map(number).collect(),
        _ => None,
    }
}
