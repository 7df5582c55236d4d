//! A state as a frame of extended XYZ.

use super::{Column, State, Values};
use crate::record::number;
use nalgebra::Vector3;
use std::fmt::Write as _;

/// Species without a name; chemistry programs know it as "no element".
const NAMELESS: &str = "X";

/// Number of bodies, header, and one line per body. Places and vectors have single precision.
pub(super) fn frame(state: &State) -> String {
    let mut text = format!("{}\n{}\n", state.places.len(), header(state));
    for (body, place) in state.places.iter().enumerate() {
        text += NAMELESS;
        push_vector(&mut text, place);
        for column in &state.columns {
            push(&mut text, column, body);
        }
        text.push('\n');
    }
    text
}

fn header(state: &State) -> String {
    let lengths = state.sides.map(|side| number(side.high - side.low));
    let [x, y, z] = lengths;
    let tilt = number(state.tilt);
    let origin = state.sides.map(|side| number(side.low)).join(" ");
    let flags = state
        .sides
        .map(|side| if side.is_periodic { "T" } else { "F" });
    let mut columns = String::from("species:S:1:pos:R:3");
    for column in &state.columns {
        let (kind, width) = match column.values {
            Values::Integers(_) => ("I", 1),
            Values::Numbers(_) => ("R", 1),
            Values::Vectors(_) => ("R", 3),
        };
        columns += &format!(":{}:{kind}:{width}", name(column));
    }
    format!(
        "Lattice=\"{x} 0 0 0 {y} 0 {tilt} 0 {z}\" Origin=\"{origin}\" pbc=\"{}\" Properties={columns} \
         Time={} Step={}",
        flags.join(" "),
        number(state.time),
        state.step
    )
}

/// Name of the column in OVITO.
fn name(column: &Column) -> &'static str {
    match column.name {
        "velocity" => "velo",
        "angular_velocity" => "omega",
        "coordination" => "n_neighb",
        other => other,
    }
}

/// The value of a body after a blank.
pub(super) fn push(text: &mut String, column: &Column, body: usize) {
    match &column.values {
        Values::Integers(values) => {
            let _ = write!(text, " {}", values.get(body).copied().unwrap_or_default());
        }
        Values::Numbers(values) => {
            let value = values.get(body).copied().unwrap_or(f64::NAN);
            let _ = write!(text, " {value:e}");
        }
        Values::Vectors(values) => {
            push_vector(text, &values.get(body).copied().unwrap_or_default());
        }
    }
}

pub(super) fn push_vector(text: &mut String, vector: &Vector3<f64>) {
    for axis in 0..3 {
        push_number(text, vector[axis]);
    }
}

/// The shortest digits that single precision needs.
fn push_number(text: &mut String, value: f64) {
    let _ = write!(text, " {:e}", value as f32);
}
