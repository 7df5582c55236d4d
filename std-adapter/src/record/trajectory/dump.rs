//! A state as a frame of a LAMMPS text dump.

use super::xyz::{push, push_vector};
use super::{Column, State, Values};
use crate::record::number;

/// Time, step, number, box, and one line per body. Types are the parts, counted from 1, or 1 for all bodies.
pub(super) fn frame(state: &State) -> String {
    let flags = state
        .sides
        .map(|side| if side.is_periodic { "pp" } else { "ff" });
    let mut text = format!(
        "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}\n",
        number(state.time),
        state.step,
        state.places.len(),
        flags.join(" ")
    );
    for side in state.sides {
        text += &format!("{} {}\n", number(side.low), number(side.high));
    }
    let extra = || state.columns.iter().filter(|column| column.name != "id");
    let names: Vec<String> = extra().map(name).collect();
    text += &format!("ITEM: ATOMS id type x y z {}\n", names.join(" "));
    let parts = state.integers("part");
    for (body, place) in state.places.iter().enumerate() {
        let kind = parts
            .and_then(|parts| parts.get(body))
            .map_or(1, |part| part + 1);
        text += &format!("{} {kind}", body + 1);
        push_vector(&mut text, place);
        for column in extra() {
            push(&mut text, column, body);
        }
        text.push('\n');
    }
    text
}

/// Name of the column in LAMMPS.
fn name(column: &Column) -> String {
    match (column.name, &column.values) {
        ("velocity", _) => "vx vy vz".into(),
        ("angular_velocity", _) => "omegax omegay omegaz".into(),
        (name, Values::Vectors(_)) => format!("{name}[1] {name}[2] {name}[3]"),
        (name, _) => name.into(),
    }
}
