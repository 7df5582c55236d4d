//! Cost of a tip: atoms, pairs, steps, and the time of an atom-step.

use super::build::{TipSystem, build};
use super::run::TipError;
use super::shape::{AtomRole, TipOutline};
use crate::md::interaction::Evaluation;
use crate::md::system::System;
use crate::tip::scene::{DrivenHold, StageSteps, ThermostatKind, TipScene};
use nalgebra::Vector3;
use std::time::Instant;
use tribos_base::run::RunSize;
use tribos_base::space::PeriodicBox;
use tribos_base::space::pairs::neighbours;

/// Size and cost of a scene. *Units*: times in s on one core of this machine.
#[derive(Clone, Debug, PartialEq)]
pub struct TipCost {
    /// Atoms of each part, in the order of [`AtomRole::ALL`].
    pub atoms: [usize; AtomRole::ALL.len()],
    /// Pairs within the cut-off in the crystal.
    pub pairs: usize,
    /// Steps before, with and after the drive.
    pub steps: StageSteps,
    /// Time of a step divided by the number of atoms.
    pub atom_step_seconds: f64,
}

/// Steps that warm the list up, and steps that are timed.
const WARM: usize = 2;
const TIMED: usize = 20;

impl TipScene {
    /// Number of groups of atoms that a thermostat holds at the temperature.
    pub fn thermostat_groups(&self) -> usize {
        match self.thermostat {
            ThermostatKind::None => 0,
            ThermostatKind::NoseHoover | ThermostatKind::Langevin => 2,
        }
    }

    /// Number of free coordinates of all atoms: none for the base, two for driven atoms of fixed or
    /// common height.
    pub fn freedoms(&self) -> usize {
        let of = |part: AtomRole| match part {
            AtomRole::Base => 0,
            AtomRole::Driven => 2,
            _ => 3,
        };
        let sites = self.shape().sites();
        let common = usize::from(self.driven_constraint == DrivenHold::Level);
        sites.iter().map(|site| of(site.part)).sum::<usize>() + common
    }
}

/// Bytes that a run needs per atom, including neighbours and exports: measured with 6,000 and 62,000
/// atoms.
const BYTES_AN_ATOM: f64 = 6.5e3;
/// Time of an atom-step with the default cut-off.
const SECONDS_AN_ATOM_STEP: f64 = 0.2e-6;

/// Estimated size of a run of the scene, before its atoms are placed.
///
/// *Accuracy*: atoms are exact except for disks, which have up to a fifth more; memory is within a
/// factor of 1.5, time within an order of magnitude.
///
/// ```
/// use tribos::scene::TipScene;
/// use tribos::tip::size;
/// assert_eq!(size(&TipScene::default()).bodies, 6330.0);
/// ```
pub fn size(scene: &TipScene) -> RunSize {
    let shape = scene.shape();
    let [columns, rows, layers] =
        [shape.columns, shape.rows, shape.substrate_layers].map(|count| count as f64);
    // A hexagon of n atoms a side has 3n(n - 1) + 1.
    let hexagon = |side: f64| 3.0 * side * (side - 1.0) + 1.0;
    let side = |below_top: usize| match shape.outline {
        TipOutline::Cone => shape.side.saturating_sub(below_top).max(1),
        TipOutline::Hexagon | TipOutline::Disk => shape.side,
    };
    let tip: f64 = (0..shape.tip_layers)
        .map(|layer| hexagon(side(layer) as f64))
        .sum();
    let bodies = columns * rows * layers + tip;
    let steps = scene.stage_steps().total() as f64;
    RunSize {
        bodies,
        bytes: bodies * BYTES_AN_ATOM,
        seconds: bodies * steps * SECONDS_AN_ATOM_STEP,
    }
}

/// Builds the system and times its first steps.
///
/// ```
/// use tribos::scene::TipScene;
/// use tribos::tip::{TipCost, cost};
/// let scene = TipScene {
///     lambda: 0.01,
///     substrate_columns: 8,
///     substrate_rows: 8,
///     substrate_layers: 4,
///     tip_layers: 4,
///     tip_side_atoms: 2,
///     equilibration: 50.0,
///     drive_time: 1.0,
///     rest_time: 100.0,
///     time_step: 0.005,
///     ..TipScene::default()
/// };
/// let told: TipCost = cost(&scene)?;
/// // Two layers of 8 × 8 atoms a part below, two hexagons of 7 a part above.
/// assert_eq!(told.atoms, [128, 128, 0, 0, 14, 14]);
/// assert_eq!(told.steps.total(), 10_000 + 200 + 20_000);
/// assert_eq!(told.atom_steps(), 284.0 * 30_200.0);
/// assert_eq!(told.seconds(), told.atom_steps() * told.atom_step_seconds);
/// // Driven atoms move in a plane, those of the base not at all; two groups have a bath.
/// assert_eq!(scene.freedoms(), 3 * (128 + 14) + 2 * 14);
/// assert_eq!(scene.thermostat_groups(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Accuracy*: the time is within some ten per cent; later steps of a warmer system rebuild the
/// neighbour list more often.
pub fn cost(scene: &TipScene) -> Result<TipCost, TipError> {
    let TipSystem { setup, .. } = build(scene)?;
    let mut atoms = [0; AtomRole::ALL.len()];
    for &group in &setup.group_of {
        if let Some(count) = atoms.get_mut(usize::from(group)) {
            *count += 1;
        }
    }
    let pairs = pairs(&setup.atoms.positions, &setup.space, scene.reach());
    let mut system = System::new(setup)?;
    for _ in 0..WARM {
        system.step(Evaluation::Forces)?;
    }
    let start = Instant::now();
    for _ in 0..TIMED {
        system.step(Evaluation::Forces)?;
    }
    let all: usize = atoms.iter().sum();
    let atom_steps = (TIMED * all).max(1) as f64;
    Ok(TipCost {
        atoms,
        pairs,
        steps: scene.stage_steps(),
        atom_step_seconds: start.elapsed().as_secs_f64() / atom_steps,
    })
}

impl TipCost {
    /// All atoms times all steps.
    pub fn atom_steps(&self) -> f64 {
        let [atoms, steps] = [
            self.atoms.iter().sum::<usize>() as f64,
            self.steps.total() as f64,
        ];
        atoms * steps
    }

    /// Time of the whole run.
    pub fn seconds(&self) -> f64 {
        self.atom_steps() * self.atom_step_seconds
    }
}

/// Pairs closer than the cut-off. A box too small for them is refused with the scene.
fn pairs(positions: &[Vector3<f64>], space: &PeriodicBox, cutoff: f64) -> usize {
    let points = vec![0.0; positions.len()];
    neighbours(space, positions, &points, cutoff).map_or(0, |pairs| pairs.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tip::scene::TipScene;

    #[test]
    fn atoms_pairs_and_steps_are_those_of_the_crystal() {
        let keys = "body = \"tip\"\nlambda = 0.01\nsubstrate_columns = 10\nsubstrate_rows = 12\nsubstrate_layers = 4\n\
                    tip_layers = 4\ntip_side_atoms = 2\ncutoff = 1.2\ndrive_time = 1\n";
        let scene = TipScene::parse("tip.toml", keys, &[]).unwrap();
        let cost = cost(&scene).unwrap();
        // Two layers of 10 × 12 a part below, two hexagons of 7 atoms a part above.
        assert_eq!(cost.atoms, [240, 240, 0, 0, 14, 14]);
        assert_eq!(cost.steps.total(), 10_000 + 200 + 20_000);
        // Nearest neighbours: 3 a site within a periodic layer and 3 to the next one; a hexagon of 7
        // has 12 pairs, two stacked ones share 15, or 10 where the stacking goes back by two steps, and
        // 21 go down to the substrate.
        let substrate = 3 * 480 + 3 * 360;
        let tip = 4 * 12 + 2 * 15 + 10;
        assert_eq!(cost.pairs, substrate + tip + 21);
        assert_eq!(scene.thermostat_groups(), 2);
        assert_eq!(scene.freedoms(), 3 * 254 + 2 * 14);
        assert!(cost.seconds() > 0.0);
    }
}
