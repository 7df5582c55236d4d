//! Measurements of a run, independent of its records: turns and work at every step, averages from
//! lines whose interval depends only on the scene's stages.

use super::forces::TipForces;
use super::loop_work::{self, LoopWork, Totals};
use super::shape::AtomRole;
use crate::md::drive::TorqueDrive;
use crate::md::observe::{RotationAngle, kinetic_energies};
use crate::md::system::System;
use crate::tip::scene::{DriveKind, DrivenHold, StageSteps, TipScene};
use nalgebra::Vector3;

/// Time between the lines for averages, in τ.
const INTERVAL: f64 = 0.5;
/// Path of a support between the lines for averages, in spacings.
const PART: f64 = 0.05;
/// Least number of lines in the shortest stage, if it has as many steps.
const LINES: u64 = 40;

/// Steps between the lines for averages.
pub(super) fn interval(scene: &TipScene) -> u64 {
    let usual = (INTERVAL / scene.time_step).round() as u64;
    let StageSteps {
        before,
        driven,
        after,
    } = scene.stage_steps();
    let stages = [before, driven, after]
        .into_iter()
        .filter(|&steps| steps > 0);
    let shortest = stages.min().unwrap_or(u64::MAX);
    let sliding = match scene.speed {
        Some(speed) if scene.drive == DriveKind::Slide => {
            (PART * scene.spacings()[0] / (speed * scene.time_step)) as u64
        }
        _ => u64::MAX,
    };
    usual.min(shortest / LINES).min(sliding).max(1)
}

/// Number of lines after `steps` steps of a run: one at the start, one per interval, one at the end.
pub(super) fn lines(scene: &TipScene, steps: u64) -> u64 {
    let every = interval(scene);
    let last: u64 = scene.stage_steps().total();
    let is_extra = steps == last && !steps.is_multiple_of(every);
    1 + steps / every + u64::from(is_extra)
}

/// Turns, work and lines of a run.
#[derive(Debug)]
pub(super) struct RunMonitor {
    /// Rotation of the driven atoms, then of each layer of the tip from below.
    torsions: Vec<RotationAngle>,
    /// Work of the drive, in ε.
    work: f64,
    /// Heat that thermostats and damping took.
    heat: f64,
    /// Turning points of a slid tip.
    loops: LoopWork,
    /// Positions of the driven atoms before the step.
    places: Vec<Vector3<f64>>,
    /// Lines for averages.
    lines: Vec<Vec<f64>>,
}

impl RunMonitor {
    /// Takes the crystal as reference state.
    pub fn new(scene: &TipScene, layer_of: &[usize], positions: &[Vector3<f64>]) -> Self {
        Self {
            torsions: torsions(scene, layer_of, positions),
            work: 0.0,
            heat: 0.0,
            loops: LoopWork::default(),
            places: Vec::new(),
            lines: Vec::new(),
        }
    }

    /// Restores the state of a checkpoint.
    pub fn restore(
        &mut self,
        angles: &[f64],
        [work, heat]: [f64; 2],
        loops: LoopWork,
        lines: Vec<Vec<f64>>,
    ) {
        for (torsion, &angle) in self.torsions.iter_mut().zip(angles) {
            torsion.restore(angle);
        }
        (self.work, self.heat) = (work, heat);
        self.loops = loops;
        self.lines = lines;
    }

    /// Stores the positions of the driven atoms; call it before a step.
    pub fn before(&mut self, system: &System<TipForces>) {
        let positions = &system.atoms().positions;
        let driven = system.members(AtomRole::ALL.len() - 1);
        self.places.clear();
        self.places
            .extend(driven.iter().map(|&atom| positions[atom]));
    }

    /// Updates the angles and adds the work of the drive; call it after a step.
    pub fn after(&mut self, system: &System<TipForces>) {
        self.look(system);
        let exchange = system.exchange();
        self.heat += exchange.heat;
        self.work += exchange.work;
        // The drive acts in a step if it is on in its middle.
        let middle = system.time() - 0.5 * system.time_step();
        if let Some(drive) = system.drive().filter(|drive| drive.is_on(middle)) {
            self.work += self.work_of_step(system, drive);
        }
    }

    /// Updates the angles.
    pub fn look(&mut self, system: &System<TipForces>) {
        for torsion in &mut self.torsions {
            torsion.update_angle(&system.atoms().positions);
        }
    }

    /// Mean force of both ends times the displacement: a Σ m (r × r') for any motion of the atoms.
    fn work_of_step(&self, system: &System<TipForces>, drive: &TorqueDrive) -> f64 {
        let [x0, y0] = drive.axis;
        let atoms = system.atoms();
        let driven = system.members(AtomRole::ALL.len() - 1).iter();
        let swept = driven.zip(&self.places).map(|(&atom, from)| {
            let to = &atoms.positions[atom];
            atoms.mass(atom) * ((from.x - x0) * (to.y - y0) - (from.y - y0) * (to.x - x0))
        });
        drive.acceleration * swept.sum::<f64>()
    }

    /// Stores a line.
    pub fn keep(&mut self, line: Vec<f64>) {
        self.lines.push(line);
    }

    /// Angles of the driven atoms and of each layer of the tip, in radians.
    pub fn angles(&self) -> impl Iterator<Item = f64> {
        self.torsions.iter().map(RotationAngle::angle)
    }

    /// Work of the drive so far, in ε.
    pub fn work(&self) -> f64 {
        self.work
    }

    /// Heat that thermostats and damping took so far.
    pub fn heat(&self) -> f64 {
        self.heat
    }

    /// The turning points so far.
    pub fn loops(&self) -> &LoopWork {
        &self.loops
    }

    /// Notes an end of a slid tip's drive or a turning point if this step is one. The sums of the
    /// interaction must be known.
    pub fn note(&mut self, scene: &TipScene, system: &System<TipForces>) {
        let [ends, turns] = loop_work::counts(scene, system.steps());
        if self.loops.ends.len() as u64 != ends {
            self.loops.ends.push(Totals {
                work: self.work,
                heat: self.heat,
                energy: stored_energy(scene, system),
            });
        }
        if self.loops.turns.len() as u64 != turns {
            self.loops.turns.push(self.work);
        }
    }

    /// The lines so far.
    pub fn lines(&self) -> &[Vec<f64>] {
        &self.lines
    }
}

/// Energy of atoms, springs and load.
fn stored_energy(scene: &TipScene, system: &System<TipForces>) -> f64 {
    let kinetic: f64 = kinetic_energies(system).iter().sum();
    let lifted = match scene.driven_constraint {
        DrivenHold::Plane => 0.0,
        DrivenHold::Level => {
            let driven = system.members(AtomRole::ALL.len() - 1).iter();
            let heights = driven.map(|&atom| system.atoms().positions[atom].z);
            scene.lift() * heights.sum::<f64>()
        }
    };
    system.tally().energy + kinetic + system.support_energy() - lifted
}

/// Rotation of the driven atoms and of each layer of the tip.
fn torsions(
    scene: &TipScene,
    layer_of: &[usize],
    positions: &[Vector3<f64>],
) -> Vec<RotationAngle> {
    let shape = scene.shape();
    let of = |is_member: &dyn Fn(usize) -> bool| {
        let atoms = (0..layer_of.len()).filter(|&atom| is_member(layer_of[atom]));
        RotationAngle::new(atoms.collect(), positions)
    };
    let mut torsions = vec![of(&|layer| shape.part(layer) == AtomRole::Driven)];
    for layer in shape.substrate_layers..shape.layers() {
        torsions.push(of(&|other| other == layer));
    }
    torsions
}
