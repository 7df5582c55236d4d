//! Films of spheres and atoms.

use super::{Film, pack};
use crate::figure::Color;
use crate::solid::{ramp, svg_canvas::hex};
use serde_json::{Value, json};
use tribos::grains::plates;
use tribos::record::frames::{Bodies, Frame, Kind};
use tribos::tip::AtomRole;

/// Colours of a tip's parts (thesis, fig. 5.1), from the base to the driven layers.
pub const PART_COLORS: [Color; 6] = [
    Color(40, 40, 40),
    Color(60, 160, 75),
    Color(165, 165, 165),
    Color(55, 105, 190),
    Color(60, 160, 75),
    Color(205, 55, 50),
];
/// Colours on the scale.
const SHADES: usize = 64;

/// A film that cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MovieError {
    /// There are no frames.
    #[error("a film needs at least one frame")]
    Empty,
    /// A frame has other bodies.
    #[error("the frame of step {0} does not have as many bodies as the film")]
    Bodies(u64),
}

/// A film of bodies and their frames, in the order of their steps.
pub fn solid_film(title: &str, bodies: &Bodies, frames: &[Frame]) -> Result<Film, MovieError> {
    if frames.is_empty() {
        return Err(MovieError::Empty);
    }
    let count = bodies.radii.len();
    if let Some(other) = frames.iter().find(|frame| frame.places.len() != count) {
        return Err(MovieError::Bodies(other.step));
    }
    let bounds = pack::bounds(frames);
    let mut meta = json!({
        "title": title,
        "body": bodies.kind.name(),
        "units": units(bodies.kind),
        "particles": count,
        "periods": bodies.sides,
        "box": bounds,
        "radii": radii(&bodies.radii),
        "marked": bodies.marked,
        "ramp": (0..SHADES)
            .map(|at| hex(ramp::color(at as f64 / (SHADES - 1) as f64)))
            .collect::<Vec<_>>(),
        "frames": frames.iter().map(frame).collect::<Vec<_>>(),
    });
    if bodies.kind == Kind::Tip {
        meta["layers"] = json!(bodies.layers);
        meta["parts"] = json!(bodies.parts);
        meta["partKinds"] = AtomRole::ALL
            .iter()
            .zip(PART_COLORS)
            .map(|(part, color)| json!({ "name": part.name(), "color": hex(color) }))
            .collect();
    }
    surround(&mut meta, bodies, bounds);
    let data = Some(pack::packed(frames, &bounds));
    Ok(Film { meta, data })
}

/// What stands around the spheres: floor, plate above, the plates of a hopper or a drum.
fn surround(meta: &mut Value, bodies: &Bodies, bounds: [[f64; 3]; 2]) {
    let is_walled = bodies.scene["boundary_z"] == "walls";
    let is_drum = bodies.scene["container"] == "drum";
    let (floor, lid) = match bodies.kind {
        Kind::Powder => (true, true),
        Kind::Grains => (
            bodies.scene["boundary_z"] != "periodic" && !is_drum,
            is_walled,
        ),
        Kind::Gas | Kind::Tip => (false, false),
    };
    meta["floor"] = floor.into();
    meta["lid"] = lid.into();
    if bodies.kind == Kind::Grains {
        meta["plates"] = json!(plates(&bodies.scene, bounds));
    }
}

/// One radius for all, or one each.
fn radii(radii: &[f64]) -> Value {
    match radii {
        [one, rest @ ..] if rest.iter().all(|radius| radius == one) => json!(one),
        _ => json!(radii),
    }
}

/// Names of the units.
fn units(kind: Kind) -> Value {
    match kind {
        Kind::Powder => json!({
            "length": "R",
            "time": "√(ρR⁴/F_coh)",
            "speed": "√(F_coh/ρ)/R",
            "force": "F_coh",
        }),
        Kind::Grains => json!({
            "length": "m",
            "time": "s",
            "speed": "m/s",
            "force": "N",
        }),
        Kind::Gas => json!({
            "length": "R",
            "time": "R√(m/T₀)",
            "speed": "√(T₀/m)",
            "force": "T₀/R",
        }),
        Kind::Tip => json!({
            "length": "σ",
            "time": "σ√(m/ε)",
            "speed": "√(ε/m)",
            "force": "ε/σ",
        }),
    }
}

/// Numbers of a frame; numbers that are not finite are omitted.
fn frame(frame: &Frame) -> Value {
    json!({
        "step": frame.step,
        "time": frame.time,
        "height": frame.height,
        "measure": frame.measure,
        "contacts": frame.contacts.len(),
    })
}
