//! Films of bodies that slide in the plane.

use super::Film;
use serde_json::{Value, json};

/// Pictures of a film, evenly spread in time.
const PICTURES: usize = 240;

/// What is drawn of a body in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct PathBody {
    /// As scenes call it.
    pub name: String,
    /// Radius of its outline.
    pub radius: f64,
    /// Whether numbers have SI units, or none.
    pub is_si: bool,
}

/// A row: time, x, y, angle, speed, spin, v_x, v_y.
pub type Row = [f64; 8];

/// A film of a path, rows in the order of time; between them it goes straight on.
pub fn path_film(title: &str, body: &PathBody, rows: &[Row]) -> Film {
    let end = rows.last().map_or(0.0, |row| row[0]);
    let begin = rows.first().map_or(0.0, |row| row[0]);
    let at = |k: usize| begin + (end - begin) * k as f64 / (PICTURES - 1) as f64;
    let frames: Vec<Value> = (0..PICTURES)
        .map(|k| json!({ "row": between(rows, at(k)) }))
        .collect();
    let units = if body.is_si {
        json!({ "length": "m", "time": "s", "speed": "m/s", "spin": "rad/s" })
    } else {
        json!({ "length": "R", "time": "√(R/g)", "speed": "√(gR)", "spin": "√(g/R)" })
    };
    let outline = if body.name == "pipe" || body.name == "curling" {
        "ring"
    } else {
        "disk"
    };
    let meta = json!({
        "title": title,
        "body": body.name,
        "units": units,
        "radius": body.radius,
        "outline": outline,
        "curves": body.name != "disk",
        "frames": frames,
    });
    Film { meta, data: None }
}

/// The row at a time.
fn between(rows: &[Row], time: f64) -> Row {
    let after = rows.partition_point(|row| row[0] < time);
    let Some(next) = rows.get(after) else {
        return rows.last().copied().unwrap_or_default();
    };
    let last = rows.get(after.wrapping_sub(1)).unwrap_or(next);
    let share = if next[0] > last[0] {
        (time - last[0]) / (next[0] - last[0])
    } else {
        1.0
    };
    std::array::from_fn(|at| last[at] + share * (next[at] - last[at]))
}
