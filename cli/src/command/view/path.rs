//! A body in the plane from the series and the summary that its run left.

use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::friction::FlatPatch;
use tribos::record::{OtherColumns, Rows, TableError, read_text};
use tribos::run::folder::Manifest;
use tribos::scene::{Key, vocabulary};
use tribos::slide::planar::{Plate, Resistance};
use tribos_core::Real;
use tribos_core::coupling::flat::PatchShape;
pub use tribos_report::player::Row;
use tribos_report::player::{Film, PathBody, path_film};

/// Radius of the running band of a curling rock, in m, where the scene leaves it out.
const BAND: f64 = 0.065;

/// Bytes of a series at most: a million lines have some 200 MB.
const MOST_BYTES: u64 = 1 << 30;

/// What a film needs of the series of a body that turns aside, and of one that goes straight on.
const CURVED: [&str; 7] = ["time", "angle", "spin", "x", "y", "vx", "vy"];
const STRAIGHT: [&str; 5] = ["time", "angle", "spin", "distance", "speed"];

/// The film of a run.
pub fn film(folder: &Path, scene: &Value, run: &Manifest) -> Result<Film, Failure> {
    let name = scene["body"].as_str().unwrap_or("disk");
    let number = |key: &str| scene[key].as_f64();
    let outline = outline(scene)?;
    let radius = radius(scene)?;
    let is_si = scene["units"].as_str() != Some("dimensionless");
    let mass = number("mass").unwrap_or(1.0);
    // C = I/(M R²); of a pipe it follows from its radii.
    let ratio = number("inertia_ratio").unwrap_or_else(|| {
        if let Some(outline) = &outline {
            return (outline.gyration / radius).powi(2);
        }
        let inner = number("inner_radius").unwrap_or(0.0) / radius;
        0.5 * (1.0 + inner * inner)
    });
    let body = PathBody {
        name: name.into(),
        radius,
        corners: outline.map_or(Vec::new(), |outline| outline.corners),
        is_si,
        inertia: [mass, ratio * mass * radius * radius],
        parameters: parameters(name, scene, is_si),
    };
    let rows = rows(&folder.join("series.csv"), run)?;
    let title = vocabulary(name).map_or(name, |known| known.title);
    let kind = scene["model"].as_str();
    let title = kind.map_or(title.into(), |model| format!("{title}, model {model}"));
    Ok(path_film(&title, &body, &rows))
}

/// Every key of the body with its value: "speed 1 m/s, spin 5 rad/s, …".
fn parameters(body: &str, scene: &Value, is_si: bool) -> String {
    /// What says how a run is recorded, not what runs.
    const RECORDING: [&str; 4] = ["body", "units", "samples", "stop_fraction"];
    let keys = vocabulary(body).map_or(&[][..], |known| known.keys);
    let told = keys.iter().filter(|key| !RECORDING.contains(&key.name));
    let is_plain = scene["alpha"].as_f64() == Some(0.0);
    let part = |key: &Key| {
        let value = match &scene[key.name] {
            Value::Number(number) => shown(number.as_f64()?),
            Value::String(word) => word.clone(),
            _ => return None,
        };
        let unit = match key.unit {
            "-" => "",
            // Without a power of the speed it is a pure number.
            unit if !is_si || (is_plain && unit.contains("alpha")) => "",
            unit => unit,
        };
        Some(format!("{} {value} {unit}", key.name).trim_end().to_owned())
    };
    told.filter_map(part).collect::<Vec<_>>().join(", ")
}

/// The outline of a body that is not round.
struct Outline {
    /// About the centre, turned as at the launch.
    corners: Vec<Vec<[f64; 2]>>,
    radius: f64,
    gyration: f64,
}

fn outline(scene: &Value) -> Result<Option<Outline>, Failure> {
    let Some(patch) = scene["patch"].as_str() else {
        return Ok(None);
    };
    let patch: FlatPatch = patch.parse().map_err(Failure::input)?;
    let flat = patch.loaded::<f64>(None)?;
    let (centre, orientation) = (flat.centre(), scene["orientation"].as_f64().unwrap_or(0.0));
    let (sin, cos) = (Real::sin(orientation), Real::cos(orientation));
    let place = |[x, y]: [f64; 2]| {
        let [x, y] = [x - centre.x, y - centre.y];
        [cos * x - sin * y, sin * x + cos * y]
    };
    let mut corners = patch.loops()?;
    for corner in corners.iter_mut().flatten() {
        *corner = place(*corner);
    }
    let radius = flat.radius();
    let gyration = match scene["gyration_radius"].as_f64() {
        Some(radius) => radius,
        None => Plate::new(flat, 1.0, 1.0)?.radius(),
    };
    Ok(Some(Outline {
        corners,
        radius,
        gyration,
    }))
}

/// Radius of what touches the ground.
pub fn radius(scene: &Value) -> Result<f64, Failure> {
    if let Some(outline) = outline(scene)? {
        return Ok(outline.radius);
    }
    let number = |key: &str| scene[key].as_f64();
    Ok(number("radius").or(number("band_radius")).unwrap_or(BAND))
}

/// Rows of the series; a disk goes straight on.
pub fn rows(file: &Path, run: &Manifest) -> Result<Vec<Row>, Failure> {
    let named = |error: &dyn std::fmt::Display| {
        Failure::input(format!("{}: {error}; run the scene again", file.display()))
    };
    let text = read_text(file, MOST_BYTES).map_err(|error| named(&error))?;
    if !run.is_of("series.csv", text.as_bytes()) {
        return Err(named(&"changed after the run of this folder"));
    }
    let is_curved = text
        .lines()
        .next()
        .is_some_and(|head| head.split(',').any(|name| name == "vx"));
    let names = if is_curved { &CURVED[..] } else { &STRAIGHT };
    let broken = |error: TableError| Failure::input(format!("{error}; run the scene again"));
    let mut table =
        Rows::of(file, text.as_bytes(), OtherColumns::Ignored, |_| names).map_err(broken)?;
    let (mut rows, mut row) = (Vec::new(), [0.0; CURVED.len()]);
    while table
        .next(&mut row[..names.len()])
        .map_err(broken)?
        .is_some()
    {
        let [time, angle, spin, x, y, vx, vy] = row;
        let [x, y, vx, vy] = if is_curved {
            [x, y, vx, vy]
        } else {
            [x, 0.0, y, 0.0]
        };
        rows.push([time, x, y, angle, vx.hypot(vy), spin, vx, vy]);
    }
    Ok(rows)
}
