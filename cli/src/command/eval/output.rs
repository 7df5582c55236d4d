//! What is written.

use super::potential::Potential;
use super::units::Units;
use crate::command::digits::shown;
use nalgebra::{Matrix3, Vector3};
use serde_json::{Map, Value};
use std::fmt::Write as _;
use std::path::Path;
use tribos::md::configuration::Configuration;
use tribos::md::interaction::Tally;
use tribos::record::{json_number, number};

/// `id,fx,fy,fz`, ids ascending.
pub fn forces_csv(ids: &[u64], forces: &[Vector3<f64>]) -> String {
    let mut rows: Vec<(&u64, &Vector3<f64>)> = ids.iter().zip(forces).collect();
    rows.sort_unstable_by_key(|&(id, _)| *id);
    let mut text = String::from("id,fx,fy,fz\n");
    for (id, force) in rows {
        let [x, y, z] = [force.x, force.y, force.z].map(number);
        let _ = writeln!(text, "{id},{x},{y},{z}");
    }
    text
}

/// Sums over all atoms.
#[derive(Clone, Copy, Debug)]
pub struct Summary {
    atoms: usize,
    energy: f64,
    kinetic_energy: f64,
    virial: Matrix3<f64>,
    pressure: Matrix3<f64>,
    volume: f64,
}

impl Summary {
    /// Of atoms with what acts between them.
    pub fn new(all: &Configuration, tally: &Tally, units: Units) -> Self {
        let mut motion = Matrix3::zeros();
        for (atom, velocity) in all.atoms.velocities.iter().enumerate() {
            let mass = units.energy_of_motion() * all.atoms.mass(atom);
            motion += velocity * velocity.transpose() * mass;
        }
        let volume = all.volume();
        Self {
            atoms: all.atoms.len(),
            energy: tally.energy,
            kinetic_energy: 0.5 * motion.trace(),
            virial: tally.virial,
            pressure: (tally.virial + motion) * (units.pressure_of_energy() / volume),
            volume,
        }
    }

    fn pressure(&self) -> f64 {
        self.pressure.trace() / 3.0
    }

    /// With the law and the units.
    pub fn json(&self, potential: &Potential, units: Units) -> Value {
        let mut map = Map::new();
        map.insert("potential".into(), potential.description().into());
        map.insert("units".into(), units.name().into());
        map.insert("atoms".into(), self.atoms.into());
        for (name, value) in [
            ("energy", self.energy),
            ("kinetic_energy", self.kinetic_energy),
            ("virial_trace", self.virial.trace()),
            ("pressure", self.pressure()),
            ("volume", self.volume),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("virial".into(), six(&self.virial));
        map.insert("pressure_tensor".into(), six(&self.pressure));
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }

    /// For the person at the terminal.
    pub fn text(&self, units: Units, out: &Path) -> String {
        let [energy, pressure] = match units {
            Units::Lj => ["", ""],
            Units::Metal => [" eV", " bar"],
        };
        format!(
            "atoms      {}\nenergy     {}{energy}\npressure   {}{pressure}\nwritten to {}\n",
            self.atoms,
            shown(self.energy),
            shown(self.pressure()),
            out.display()
        )
    }
}

/// xx, yy, zz, xy, xz, yz.
fn six(m: &Matrix3<f64>) -> Value {
    let parts = [m.m11, m.m22, m.m33, m.m12, m.m13, m.m23];
    parts.map(json_number).to_vec().into()
}
