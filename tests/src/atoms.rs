//! Atoms of `tables/md/` with the forces and sums that LAMMPS computed.

use crate::tables::Table;
use nalgebra::Vector3;
use std::path::{Path, PathBuf};
use tribos::md::configuration::{Configuration, read};
use tribos::md::interaction::{Evaluation, Interaction, Tally, evaluate};
use tribos::md::neighbours::VerletList;
use tribos::md::pair::{LennardJones, Mixing, Pairing, Shift};

/// Path of a file of `tables/md/`.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tables/md")
        .join(name)
}

/// Text of a file of `tables/md/`.
///
/// # Panics
/// If it cannot be read.
pub fn text(name: &str) -> String {
    let path = path(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The atoms of `NAME.data`, periodic along the given axes.
///
/// # Panics
/// If it cannot be read.
pub fn data(name: &str, is_periodic: [bool; 3]) -> Configuration {
    let mut all = read(&text(&format!("{name}.data"))).expect("a data file");
    all.is_periodic = is_periodic;
    all
}

/// Forces and sums computed by LAMMPS for one input.
#[derive(Clone, Debug)]
pub struct Expected {
    /// Forces by number of the atom, starting at 1.
    pub forces: Vec<Vector3<f64>>,
    /// Potential energy.
    pub energy: f64,
    /// Pressure, including the kinetic part.
    pub pressure: f64,
    /// Components xx, yy, zz, xy, xz, yz of the pressure.
    pub tensor: [f64; 6],
    /// Volume of the box.
    pub volume: f64,
}

impl Expected {
    /// Results for `in.NAME`.
    ///
    /// # Panics
    /// If there is no such table.
    pub fn read(name: &str) -> Self {
        let forces = Table::read(&format!("md/{name}.csv"));
        let axes = ["fx", "fy", "fz"];
        let force = |row: crate::tables::Row| axes.map(|axis| row.number(axis)).into();
        let totals = Table::read("md/totals.csv");
        let row = totals
            .rows()
            .find(|row| row.text("name") == name)
            .expect("totals");
        Self {
            forces: forces.rows().map(force).collect(),
            energy: row.number("pe"),
            pressure: row.number("press"),
            tensor: ["pxx", "pyy", "pzz", "pxy", "pxz", "pyz"].map(|at| row.number(at)),
            volume: row.number("vol"),
        }
    }

    /// Magnitude of the largest force.
    pub fn largest(&self) -> f64 {
        self.forces.iter().map(Vector3::norm).fold(0.0, f64::max)
    }
}

/// Forces by number of the atom, and sums.
///
/// # Panics
/// If the box is too small for the cut-off.
pub fn computed(all: &Configuration, law: &dyn Interaction) -> (Vec<Vector3<f64>>, Tally) {
    let space = all.space().expect("a box");
    let mut list = VerletList::new(space, law.cutoff(), 0.3).expect("a list");
    let mut forces = Vec::new();
    let tally =
        evaluate(law, &mut list, &all.atoms, &mut forces, Evaluation::Sums).expect("forces");
    let mut by_id = vec![Vector3::zeros(); forces.len()];
    for (&id, force) in all.ids.iter().zip(forces) {
        by_id[id as usize - 1] = force;
    }
    (by_id, tally)
}

/// Two species as in `in.binary500_…`: ε of 1 and 1/2, σ of 1 and 0.88, cut-off 2.5.
///
/// # Panics
/// Never with the numbers here.
pub fn binary(mixing: Mixing, shift: Shift) -> LennardJones {
    let like = [(1.0, 1.0), (0.5, 0.88)].map(|(epsilon, sigma)| Pairing {
        epsilon,
        sigma,
        cutoff: 2.5,
    });
    LennardJones::mixed(&like, mixing, shift).expect("two species")
}

/// One species in reduced units, cut-off 2.5.
///
/// # Panics
/// Never with the numbers here.
pub fn single(shift: Shift) -> LennardJones {
    let pairing = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: 2.5,
    };
    LennardJones::single(pairing, shift).expect("one species")
}
