//! Particles as extended XYZ, which OVITO and ASE read.

use super::{Snapshot, SnapshotError, number};
use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// Species without a name; chemistry programs read it as "no element".
const NAMELESS: &str = "X";

/// One frame of extended XYZ: species, id from 0, position in the cell, radius and coordination, then
/// material, density, velocity and angular velocity if present, in the shortest form that keeps the bits.
///
/// Columns have OVITO's names (`velo`, `omega`, `n_neighb`). Concatenated frames form a
/// trajectory. OVITO takes positions for fractions of the cell if all lie between 0 and 1.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::{Snapshot, extended_xyz};
/// # use tribos::space::PeriodicBox;
/// # let pair = Snapshot {
/// #     time: 0.0,
/// #     space: PeriodicBox::new([Some(10.0), None, None])?,
/// #     extents: [[0.0, 10.0], [0.0, 4.0], [0.0, 4.0]],
/// #     positions: &[Vector3::new(-0.5, 2.0, 2.0), Vector3::new(1.5, 2.0, 2.0)],
/// #     radii: &[1.0; 2],
/// #     velocities: None,
/// #     spins: None,
/// #     species: None,
/// #     materials: None,
/// #     densities: None,
/// #     contacts: &[],
/// # };
/// // Two spheres, the first just outside of a cell with sides of 10, periodic along x.
/// let text = extended_xyz(&pair)?;
/// let lines: Vec<&str> = text.lines().collect();
/// assert_eq!((lines.len(), lines[0]), (4, "2"));
/// assert!(lines[1].contains("pbc=\"T F F\""));
/// // Species, id, x: where its image in the cell is.
/// let x = lines[2].split(' ').nth(2).map(str::parse);
/// assert_eq!(x, Some(Ok(9.5)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn extended_xyz(snapshot: &Snapshot) -> Result<String, SnapshotError> {
    snapshot.check()?;
    let mut text = format!("{}\n{}\n", snapshot.positions.len(), header(snapshot));
    let coordination = snapshot.coordination();
    for (index, place) in snapshot.positions.iter().enumerate() {
        let species = snapshot.species.map_or(NAMELESS, |names| names[index]);
        let place = triple(&snapshot.space.wrap(place));
        let radius = number(snapshot.radii[index]);
        let contacts = coordination[index];
        text += &format!("{species} {index} {place} {radius} {contacts}");
        if let Some(materials) = snapshot.materials {
            text += &format!(" {}", materials[index]);
        }
        if let Some(densities) = snapshot.densities {
            text += &format!(" {}", number(densities[index]));
        }
        for vectors in [snapshot.velocities, snapshot.spins].into_iter().flatten() {
            text += " ";
            text += &triple(&vectors[index]);
        }
        text.push('\n');
    }
    Ok(text)
}

/// Cell, origin and periods as keys; a box that is open along an axis has these ends there.
pub fn cell_keys(space: &PeriodicBox, extents: &[[f64; 2]; 3]) -> String {
    let lengths = space.lengths();
    let mut lattice = [0.0; 9];
    let mut origin = Vector3::zeros();
    for (axis, [low, high]) in extents.iter().enumerate() {
        lattice[4 * axis] = lengths[axis].unwrap_or(high - low);
        origin[axis] = if lengths[axis].is_some() { 0.0 } else { *low };
    }
    // The third vector of a sheared box leans along x.
    lattice[6] = space.offset();
    let flag = |length: Option<f64>| if length.is_some() { "T" } else { "F" };
    format!(
        "Lattice=\"{}\" Origin=\"{}\" pbc=\"{}\"",
        lattice.map(number).join(" "),
        triple(&origin),
        lengths.map(flag).join(" ")
    )
}

/// Cell, periods and columns.
fn header(snapshot: &Snapshot) -> String {
    let mut columns = String::from("species:S:1:id:I:1:pos:R:3:radius:R:1:n_neighb:I:1");
    if snapshot.materials.is_some() {
        columns += ":material:I:1";
    }
    if snapshot.densities.is_some() {
        columns += ":density:R:1";
    }
    if snapshot.velocities.is_some() {
        columns += ":velo:R:3";
    }
    if snapshot.spins.is_some() {
        columns += ":omega:R:3";
    }
    format!(
        "{} Properties={columns} Time={}",
        cell_keys(&snapshot.space, &snapshot.extents),
        number(snapshot.time)
    )
}

fn triple(vector: &Vector3<f64>) -> String {
    let [x, y, z] = [vector.x, vector.y, vector.z].map(number);
    format!("{x} {y} {z}")
}
