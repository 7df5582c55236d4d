//! Measurements on a system: energies, temperature, pressure, angles.
//!
//! ```
//! # use nalgebra::Vector3;
//! # use tribos::md::{atoms::Atoms, group::Group, thermostat::Noise};
//! # use tribos::md::pair::{LennardJones, Pairing, Shift};
//! # use tribos::md::system::{Integrator, Setup, System};
//! # use tribos::space::PeriodicBox;
//! use tribos::md::observe::{conserved_energy, kinetic_energies, pressure, temperature};
//! // Eight atoms out of each other's reach are an ideal gas: pV = N T, all energy is kinetic.
//! let place = |k: u8| Vector3::new(k % 2, k / 2 % 2, k / 4).map(|n| 5.0 * f64::from(n));
//! let mut atoms = Atoms::at((0..8).map(place).collect());
//! let mut noise = Noise::new(1, 0, 0);
//! atoms.velocities.fill_with(|| noise.vector());
//! # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
//! let system = System::new(Setup {
//!     atoms,
//!     space: PeriodicBox::new([Some(10.0); 3])?,
//! #   interaction: LennardJones::single(unit, Shift::None)?,
//! #   skin: 0.3,
//!     groups: vec![Group::default()],
//!     group_of: vec![0; 8],
//!     // ...
//! #   drive: None,
//! #   integrator: Integrator::VelocityVerlet,
//! #   time_step: 0.005,
//! #   seed: 1,
//! })?;
//! let kinetic = kinetic_energies(&system)[0];
//! let heat = temperature(kinetic, 3.0 * 8.0);
//! assert!((pressure(&system, 1000.0) * 1000.0 / (8.0 * heat) - 1.0).abs() < 1e-14);
//! assert_eq!(conserved_energy(&system), kinetic);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::group::ThermalFrame;
use super::interaction::Interaction;
use super::system::System;
use super::thermostat::Thermostat;
use nalgebra::Vector3;

/// Kinetic energy of each group, at the time of the positions.
pub fn kinetic_energies<I: Interaction>(system: &System<I>) -> Vec<f64> {
    let velocities = system.velocities_on_step();
    let atoms = system.atoms();
    let part = |&atom: &usize| 0.5 * atoms.mass(atom) * velocities[atom].norm_squared();
    (0..system.groups().len())
        .map(|group| system.members(group).iter().map(part).sum())
        .collect()
}

/// Kinetic energy of a group that counts as heat, at the time of the positions: without its mean
/// velocity along x and y where that is carried ([`ThermalFrame::Mean`](super::group::ThermalFrame)).
pub fn heat_energy<I: Interaction>(system: &System<I>, group: usize) -> f64 {
    let velocities = system.velocities_on_step();
    let atoms = system.atoms();
    let members = system.members(group);
    let mut common = Vector3::zeros();
    if system.groups()[group].frame == ThermalFrame::Mean {
        let all: f64 = members.iter().map(|&atom| atoms.mass(atom)).sum();
        for &atom in members {
            common += velocities[atom] * (atoms.mass(atom) / all);
        }
        common.z = 0.0;
    }
    let part = |&atom: &usize| 0.5 * atoms.mass(atom) * (velocities[atom] - common).norm_squared();
    members.iter().map(part).sum()
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

/// The rotation of some atoms about the vertical through their centre, relative to a reference state.
///
/// The angle is that of the best fit: Σ m r₀ × r over Σ m r₀ · r. It counts whole turns if it is
/// updated at least every half turn.
///
/// ```
/// use nalgebra::Vector3;
/// use std::f64::consts::TAU;
/// use tribos::md::observe::RotationAngle;
/// // Three atoms on a circle of radius 1, turned by an angle.
/// let corner = |angle: f64| Vector3::new(5.0 + angle.cos(), angle.sin(), 0.0);
/// let turned = |by: f64| [0.0, 1.0, 2.0].map(|third| corner(by + third * TAU / 3.0));
/// let mut ring = RotationAngle::new(vec![0, 1, 2], &turned(0.0));
/// for third in 1..=6 {
///     ring.update_angle(&turned(f64::from(third) * TAU / 3.0));
/// }
/// assert!((ring.angle() - 2.0 * TAU).abs() < 1e-12); // two whole turns
/// let mut resumed = RotationAngle::new(vec![0, 1, 2], &turned(0.0));
/// resumed.restore(ring.angle());
/// assert!((resumed.update_angle(&turned(0.1)) - (2.0 * TAU + 0.1)).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RotationAngle {
    atoms: Vec<usize>,
    /// Arms from the centre to each atom in the reference state.
    arms: Vec<[f64; 2]>,
    angle: f64,
}

impl RotationAngle {
    /// Takes the current positions of some atoms as the reference state.
    pub fn new(atoms: Vec<usize>, positions: &[Vector3<f64>]) -> Self {
        let arms = arms(&atoms, positions);
        Self {
            atoms,
            arms,
            angle: 0.0,
        }
    }

    /// The angle at the last update, in radians, positive from x to y.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Restores an angle from a checkpoint.
    pub fn restore(&mut self, angle: f64) {
        self.angle = angle;
    }

    /// Updates the angle from the current positions.
    pub fn update_angle(&mut self, positions: &[Vector3<f64>]) -> f64 {
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

/// Arms from the mean position, in the plane.
fn arms(atoms: &[usize], positions: &[Vector3<f64>]) -> Vec<[f64; 2]> {
    let places = || atoms.iter().map(|&atom| &positions[atom]);
    let count = atoms.len().max(1) as f64;
    let x: f64 = places().map(|place| place.x).sum::<f64>() / count;
    let y: f64 = places().map(|place| place.y).sum::<f64>() / count;
    places().map(|place| [place.x - x, place.y - y]).collect()
}
