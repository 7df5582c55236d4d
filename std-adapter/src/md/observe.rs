//! What is read off a system: energies, temperature, pressure, angles.

use super::interaction::Interaction;
use super::system::System;
use super::thermostat::Thermostat;
use nalgebra::Vector3;

/// Kinetic energy of each group, at the time of the places.
pub fn kinetic_energies<I: Interaction>(system: &System<I>) -> Vec<f64> {
    let velocities = system.velocities_on_step();
    let atoms = system.atoms();
    let part = |&atom: &usize| 0.5 * atoms.mass(atom) * velocities[atom].norm_squared();
    (0..system.groups().len())
        .map(|group| system.members(group).iter().map(part).sum())
        .collect()
}

/// Temperature of a group: twice its kinetic energy over its freedoms, NaN without any.
pub fn temperature(kinetic: f64, freedoms: f64) -> f64 {
    2.0 * kinetic / freedoms
}

/// Energy of the interaction, of motion, and of the Nosé–Hoover thermostats: conserved if nothing
/// else does work (no noise, damping, load or drive). NaN after a step without sums.
pub fn conserved_energy<I: Interaction>(system: &System<I>) -> f64 {
    let kinetic: f64 = kinetic_energies(system).iter().sum();
    let thermostats: f64 = system
        .groups()
        .iter()
        .enumerate()
        .map(|(index, group)| match &group.thermostat {
            Thermostat::NoseHoover(thermostat) => thermostat.energy(system.heat_freedoms(index)),
            _ => 0.0,
        })
        .sum();
    system.tally().energy + kinetic + thermostats
}

/// Pressure in a volume: (2K + tr Σ r ⊗ F)/3V. NaN after a step without sums.
pub fn pressure<I: Interaction>(system: &System<I>, volume: f64) -> f64 {
    let kinetic: f64 = kinetic_energies(system).iter().sum();
    (2.0 * kinetic + system.tally().virial.trace()) / (3.0 * volume)
}

/// The rotation of some atoms about the vertical through their centre, from a first sight on.
///
/// The angle is that of the best fit: Σ m r₀ × r over Σ m r₀ · r. It counts whole turns if it is
/// looked at before half of one has passed.
#[derive(Clone, Debug, PartialEq)]
pub struct Torsion {
    atoms: Vec<usize>,
    /// From the centre, at first sight.
    arms: Vec<[f64; 2]>,
    angle: f64,
}

impl Torsion {
    /// First sight of some atoms.
    pub fn new(atoms: Vec<usize>, positions: &[Vector3<f64>]) -> Self {
        let arms = arms(&atoms, positions);
        Self {
            atoms,
            arms,
            angle: 0.0,
        }
    }

    /// The angle when it was last looked at, in radians, positive from x to y.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Puts back an angle: what a checkpoint keeps.
    pub fn restore(&mut self, angle: f64) {
        self.angle = angle;
    }

    /// Looks again.
    pub fn look(&mut self, positions: &[Vector3<f64>]) -> f64 {
        let (mut cross, mut dot) = (0.0, 0.0);
        for ([x0, y0], [x, y]) in self.arms.iter().zip(arms(&self.atoms, positions)) {
            cross += x0 * y - y0 * x;
            dot += x0 * x + y0 * y;
        }
        let turn = std::f64::consts::TAU;
        let plain = libm::atan2(cross, dot);
        self.angle = plain + turn * ((self.angle - plain) / turn).round();
        self.angle
    }
}

/// From the mean place, in the plane.
fn arms(atoms: &[usize], positions: &[Vector3<f64>]) -> Vec<[f64; 2]> {
    let places = || atoms.iter().map(|&atom| &positions[atom]);
    let count = atoms.len().max(1) as f64;
    let x: f64 = places().map(|place| place.x).sum::<f64>() / count;
    let y: f64 = places().map(|place| place.y).sum::<f64>() / count;
    places().map(|place| [place.x - x, place.y - y]).collect()
}
