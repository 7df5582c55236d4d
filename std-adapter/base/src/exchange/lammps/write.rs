//! Writing data and dump files; every number reads back to the same bits.

use crate::exchange::configuration::Configuration;
use crate::record::number;
use nalgebra::Vector3;
use std::fmt::Write as _;

/// What LAMMPS runs a scene from: a data file and an input script.
#[derive(Clone, Debug, PartialEq)]
pub struct Export {
    /// What runs, the stem of both files: `NAME.data` and `in.NAME`.
    pub name: &'static str,
    /// Bodies at the start.
    pub data: String,
    /// Laws, walls and the run; reads the data as `NAME.data`.
    pub script: String,
    /// What LAMMPS holds only approximately, a sentence each.
    pub notes: Vec<String>,
}

/// A data file. Positions are not wrapped into the box; velocities are omitted if all are 0. The
/// step, the periods and the forces are not written.
///
/// ```
/// use tribos::md::{configuration::read, lammps::{data_file, read_data}};
/// let atoms = read("2\nLattice=\"4 0 0 0 4 0 0 0 4\"\n1 0.1 0.2 0.3\n1 2 2 2\n")?;
/// assert_eq!(read_data(&data_file(&atoms))?, atoms); // 0.1 to the bit
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn data_file(configuration: &Configuration) -> String {
    let atoms = &configuration.atoms;
    let mut text = format!(
        "LAMMPS data file by tribos\n\n{} atoms\n{} atom types\n\n",
        atoms.len(),
        atoms.masses.len()
    );
    for (axis, ends) in ["x", "y", "z"].iter().zip(configuration.bounds) {
        let [low, high] = ends.map(number);
        let _ = writeln!(text, "{low} {high} {axis}lo {axis}hi");
    }
    text += "\nMasses\n\n";
    for (species, &mass) in atoms.masses.iter().enumerate() {
        let _ = writeln!(text, "{} {}", species + 1, number(mass));
    }
    text += "\nAtoms # atomic\n\n";
    for (index, id) in configuration.ids.iter().enumerate() {
        let species = atoms.species[index] + 1;
        let _ = writeln!(text, "{id} {species} {}", triple(&atoms.positions[index]));
    }
    if atoms.velocities.iter().flatten().any(|v| v.to_bits() != 0) {
        text += "\nVelocities\n\n";
        for (id, velocity) in configuration.ids.iter().zip(&atoms.velocities) {
            let _ = writeln!(text, "{id} {}", triple(velocity));
        }
    }
    text
}

/// Spheres as a data file has them; the box may lean along x over z.
#[derive(Clone, Copy, Debug)]
pub struct SphereRows<'a> {
    /// Low and high end of the box along each axis.
    pub bounds: [[f64; 2]; 3],
    /// Displacement along x of the images one period higher along z.
    pub tilt: f64,
    /// Centres in the box.
    pub positions: &'a [Vector3<f64>],
    /// Radii.
    pub radii: &'a [f64],
    /// Numbers of the materials from 1, the types, unless all are of one.
    pub materials: Option<&'a [u8]>,
    /// Densities.
    pub densities: &'a [f64],
    /// Velocities, if they are known.
    pub velocities: Option<&'a [Vector3<f64>]>,
    /// Angular velocities, if they are known.
    pub spins: Option<&'a [Vector3<f64>]>,
}

/// A data file of spheres (`atom_style sphere`), with a section of velocities if any sphere moves. Which axes repeat is not
/// written.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::lammps::{SphereRows, read_spheres, sphere_data_file};
/// let text = sphere_data_file(&SphereRows {
///     bounds: [[0.0, 4.0]; 3],
///     tilt: 0.5,
///     positions: &[Vector3::new(0.1, 2.0, 2.0)],
///     radii: &[0.3],
///     materials: Some(&[2]),
///     densities: &[2500.0],
///     velocities: None,
///     spins: Some(&[Vector3::x()]),
/// });
/// let (atoms, spheres) = read_spheres(&text)?;
/// assert_eq!((atoms.atoms.positions[0].x, atoms.atoms.species[0]), (0.1, 1));
/// assert_eq!((spheres.radii, spheres.tilt), (Some(vec![0.3]), 0.5));
/// assert_eq!(spheres.spins, Some(vec![Vector3::x()]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sphere_data_file(rows: &SphereRows<'_>) -> String {
    let types = rows.materials.and_then(|all| all.iter().max()).copied();
    let mut text = format!(
        "LAMMPS data file by tribos\n\n{} atoms\n{} atom types\n\n",
        rows.radii.len(),
        types.unwrap_or(1)
    );
    for (axis, ends) in ["x", "y", "z"].iter().zip(rows.bounds) {
        let [low, high] = ends.map(|end| if end == 0.0 { "0".into() } else { number(end) });
        let _ = writeln!(text, "{low} {high} {axis}lo {axis}hi");
    }
    // The same box, with a tilt of at most half a period.
    let length = rows.bounds[0][1] - rows.bounds[0][0];
    if rows.tilt != 0.0 {
        let tilt = rows.tilt - length * (rows.tilt / length).round();
        let _ = writeln!(text, "0 {} 0 xy xz yz", number(tilt));
    }
    text += "\nAtoms # sphere\n\n";
    for (index, place) in rows.positions.iter().enumerate() {
        let kind = rows.materials.map_or(1, |all| all[index]);
        let (diameter, density) = (
            number(2.0 * rows.radii[index]),
            number(rows.densities[index]),
        );
        let _ = writeln!(
            text,
            "{} {kind} {diameter} {density} {}",
            index + 1,
            triple(place)
        );
    }
    let is_moving = |all: &[Vector3<f64>]| all.iter().flatten().any(|v| *v != 0.0);
    if [rows.velocities, rows.spins]
        .iter()
        .flatten()
        .any(|all| is_moving(all))
    {
        text += "\nVelocities\n\n";
        for index in 0..rows.positions.len() {
            let of =
                |all: Option<&[Vector3<f64>]>| all.map_or_else(Vector3::zeros, |all| all[index]);
            let _ = writeln!(
                text,
                "{} {} {}",
                index + 1,
                triple(&of(rows.velocities)),
                triple(&of(rows.spins))
            );
        }
    }
    text
}

/// One frame of a text dump: unwrapped positions, velocities, and forces if there are any.
/// Concatenated frames form a trajectory.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::{configuration::read, lammps::{dump_frame, frames}};
/// let start = read("1\nLattice=\"4 0 0 0 4 0 0 0 4\"\n1 3.9 2 2\n")?;
/// let mut later = start.clone();
/// later.step = 50;
/// later.atoms.positions[0].x = 4.1; // beyond the end of the period, and left there
/// later.forces = Some(vec![Vector3::new(0.0, 0.0, -1.0 / 3.0)]);
/// let trajectory = dump_frame(&start) + &dump_frame(&later);
/// let read_back: Vec<_> = frames(&trajectory).flatten().collect();
/// assert_eq!(read_back, [start, later]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn dump_frame(configuration: &Configuration) -> String {
    let atoms = &configuration.atoms;
    let flags = configuration
        .is_periodic
        .map(|is| if is { "pp" } else { "ff" });
    let mut text = format!(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}\n",
        configuration.step,
        atoms.len(),
        flags.join(" ")
    );
    for ends in configuration.bounds {
        let [low, high] = ends.map(number);
        let _ = writeln!(text, "{low} {high}");
    }
    text += "ITEM: ATOMS id type xu yu zu vx vy vz";
    let forces = configuration.forces.as_deref();
    text += if forces.is_some() {
        " fx fy fz\n"
    } else {
        "\n"
    };
    for (index, id) in configuration.ids.iter().enumerate() {
        let species = atoms.species[index] + 1;
        let (place, velocity) = (&atoms.positions[index], &atoms.velocities[index]);
        let _ = write!(
            text,
            "{id} {species} {} {}",
            triple(place),
            triple(velocity)
        );
        if let Some(forces) = forces {
            let _ = write!(text, " {}", triple(&forces[index]));
        }
        text.push('\n');
    }
    text
}

fn triple(vector: &Vector3<f64>) -> String {
    let [x, y, z] = [vector.x, vector.y, vector.z].map(number);
    format!("{x} {y} {z}")
}
