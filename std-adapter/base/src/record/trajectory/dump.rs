//! A state as a frame of a LAMMPS text dump.

use super::xyz::{push, push_vector};
use super::{Column, State, Values};
use crate::record::number;

/// Time, step, number, box, and one line per body. Types are the materials, or the parts, counted from 1, or 1 for
/// all bodies.
pub(super) fn frame(state: &State) -> String {
    let flags = state
        .sides
        .map(|side| if side.is_periodic { "pp" } else { "ff" });
    let (tilt, is_tilted) = (shortest(state), state.tilt != 0.0);
    // A slanted box is told by the ends of what encloses it.
    let mut ends = state.sides.map(|side| [side.low, side.high]);
    ends[0] = [ends[0][0] + tilt.min(0.0), ends[0][1] + tilt.max(0.0)];
    let mut text = format!(
        "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}{}\n",
        number(state.time),
        state.step,
        state.places.len(),
        if is_tilted { "xy xz yz " } else { "" },
        flags.join(" ")
    );
    for (axis, [low, high]) in ends.into_iter().enumerate() {
        text += &format!("{} {}", number(low), number(high));
        if is_tilted {
            // xy, xz, yz.
            text += &format!(" {}", number(if axis == 1 { tilt } else { 0.0 }));
        }
        text.push('\n');
    }
    let is_extra = |column: &&Column| !["id", "material"].contains(&column.name);
    let extra = || state.columns.iter().filter(is_extra);
    let names: Vec<String> = extra().map(name).collect();
    text += &format!("ITEM: ATOMS id type x y z {}\n", names.join(" "));
    let types = state.integers("material");
    let parts = state.integers("part");
    let count = |number: i64| number + 1;
    for (body, place) in state.places.iter().enumerate() {
        let at = |all: Option<&[i64]>| all.and_then(|all| all.get(body).copied());
        let kind = at(types).or(at(parts).map(count)).unwrap_or(1);
        text += &format!("{} {kind}", body + 1);
        push_vector(&mut text, place);
        for column in extra() {
            push(&mut text, column, body);
        }
        text.push('\n');
    }
    text
}

/// The tilt of the same box that is at most half a period, as LAMMPS wants it.
fn shortest(state: &State) -> f64 {
    let length = state.sides[0].high - state.sides[0].low;
    if length > 0.0 {
        state.tilt - length * (state.tilt / length).round()
    } else {
        state.tilt
    }
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
