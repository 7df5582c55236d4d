//! Films of bodies that slide in the plane.

use super::Film;
use serde_json::{Value, json};

/// Pictures of a film, evenly spread in time.
const PICTURES: usize = 240;

/// Description of a body in the plane for drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct PathBody {
    /// Name of the body in scenes.
    pub name: String,
    /// Radius of the outline.
    pub radius: f64,
    /// Loops of corners about the centre at the angle 0, of a body that is not round.
    pub corners: Vec<Vec<[f64; 2]>>,
    /// Whether numbers have SI units, or none.
    pub is_si: bool,
    /// Mass, and moment of inertia about the upright axis.
    pub inertia: [f64; 2],
    /// Summary of the scene in one line.
    pub parameters: String,
}

/// A row: time, x, y, angle, speed, spin, v_x, v_y.
pub type Row = [f64; 8];

/// A row with force and torque on the body: F_x, F_y, T.
type PathRow = [f64; 11];

/// A film of a path, with rows in order of time and linear interpolation between them.
pub fn path_film(title: &str, body: &PathBody, rows: &[Row]) -> Film {
    let end = rows.last().map_or(0.0, |row| row[0]);
    let begin = rows.first().map_or(0.0, |row| row[0]);
    let at = |k: usize| begin + (end - begin) * k as f64 / (PICTURES - 1) as f64;
    let drawn = with_forces(rows, body.inertia);
    let frames: Vec<Value> = (0..PICTURES)
        .map(|k| json!({ "row": between(&drawn, at(k)) }))
        .collect();
    let units = if body.is_si {
        json!({ "length": "m", "time": "s", "speed": "m/s", "spin": "rad/s", "force": "N", "torque": "N m" })
    } else {
        json!({ "length": "R", "time": "√(R/g)", "speed": "√(gR)", "spin": "√(g/R)", "force": "m g", "torque": "m g R" })
    };
    let outline = if body.name == "pipe" || body.name == "curling" {
        "ring"
    } else {
        "disk"
    };
    let meta = json!({
        "title": title,
        "body": body.name,
        "parameters": body.parameters,
        "units": units,
        "radius": body.radius,
        "outline": outline,
        "corners": body.corners,
        "curves": body.name != "disk",
        "frames": frames,
    });
    Film { meta, data: None }
}

/// Rows with the force and the torque that change the motion from one to the next; a row inside has
/// the mean of both sides, weighted by their times.
fn with_forces(rows: &[Row], [mass, inertia]: [f64; 2]) -> Vec<PathRow> {
    let last = rows.len().saturating_sub(1);
    let drawn = rows.iter().enumerate().map(|(k, row)| {
        let (before, after) = (&rows[k.saturating_sub(1)], &rows[(k + 1).min(last)]);
        let time = after[0] - before[0];
        let rate = |at: usize| {
            if time > 0.0 {
                (after[at] - before[at]) / time
            } else {
                0.0
            }
        };
        let loads = [mass * rate(6), mass * rate(7), inertia * rate(5)];
        std::array::from_fn(|at| match at.checked_sub(row.len()) {
            None => row[at],
            Some(load) => loads[load],
        })
    });
    drawn.collect()
}

/// The row at a time.
fn between(rows: &[PathRow], time: f64) -> PathRow {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_are_those_that_brake() {
        // 2 kg that brake with 3 m/s², and 0.5 kg m² with 4 rad/s².
        let row = |t: f64| {
            let (v, spin) = (6.0 - 3.0 * t, 8.0 - 4.0 * t);
            [t, 0.0, 0.0, 0.0, v, spin, v, 0.0]
        };
        let rows: Vec<Row> = [0.0, 0.5, 0.6, 1.5, 2.0].map(row).to_vec();
        for row in with_forces(&rows, [2.0, 0.5]) {
            let [fx, fy, torque] = [row[8], row[9], row[10]];
            assert!((fx + 6.0).abs() < 1e-12 && fy == 0.0 && (torque + 2.0).abs() < 1e-12);
        }
        assert_eq!(with_forces(&rows[..1], [2.0, 0.5])[0][8..], [0.0; 3]);
        assert!(with_forces(&[], [1.0, 1.0]).is_empty());
    }
}
