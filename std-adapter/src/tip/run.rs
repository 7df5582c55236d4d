//! A run of the tip: stages, series, checkpoints.

use super::build::{BuildError, TipSystem, build};
use super::checkpoint::Checkpoint;
use super::outcome::Outcome;
use super::shape::Part;
use crate::md::interaction::Wanted;
use crate::md::observe::{Torsion, kinetic_energies, temperature};
use crate::md::pair::LennardJones;
use crate::md::system::{System, SystemError};
use crate::record::CheckpointError;
use crate::run::Simulation;
use crate::scene::TipScene;

/// Columns of the series before the angles of the tip's layers.
const FIXED_COLUMNS: [&str; 7] = [
    "time",
    "angle",
    "resisting_torque",
    "height",
    "substrate_temperature",
    "tip_temperature",
    "potential_energy",
];

/// Why a run cannot start or go on.
#[derive(Debug, thiserror::Error)]
pub enum TipError {
    /// The scene makes no system.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The system cannot be set up, or blew up.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The checkpoint is of no use.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

/// The tip of a scene in motion.
///
/// ```
/// use tribos::run::Simulation;
/// use tribos::scene::{Scene, parse_scene};
/// use tribos::tip::{Part, TipError, TipRun, Verdict};
/// // A cold tip that is pushed for a moment: too short for the lattice to push back.
/// let text = "body = \"tip\"\nlambda = 0.01\ncolumns = 8\nrows = 8\nsubstrate_layers = 4\n\
///             tip_layers = 4\nside = 2\ntemperature = 0\nequilibration = 0\n\
///             drive_time = 0.04\nrest_time = 0\ntime_step = 0.005\nsamples = 4";
/// let Scene::Tip(scene) = parse_scene("tip.toml", text, &[])? else { unreachable!() };
/// let mut run = TipRun::new(&scene)?;
/// run.step()?; // four steps of 0.005, to the next line of the series
/// let free = 0.5 * scene.lambda * run.time() * run.time(); // angle = λt²/2
/// assert!((run.angle() / free - 1.0).abs() < 0.02);
/// assert_eq!(run.columns()[..2], ["time", "angle"]);
/// assert_eq!(run.series()[1][1], run.angle().to_degrees());
/// assert_eq!(run.outcome().verdict, Verdict::Open); // it is not over
/// // It can go on from a file, which keeps all that was.
/// let again = TipRun::resume(&scene, &run.checkpoint())?;
/// assert_eq!(again.series(), run.series());
/// assert!(matches!(TipRun::resume(&scene, "{}"), Err(TipError::Checkpoint(_))));
/// // Atoms, each with its layer and its part.
/// let last = run.system().atoms().len() - 1;
/// assert_eq!((run.layers()[last], Part::ALL[usize::from(run.parts()[last])]), (7, Part::Driven));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct TipRun {
    scene: TipScene,
    system: System<LennardJones>,
    layer_of: Vec<usize>,
    part_of: Vec<u8>,
    /// Driven atoms, then each layer of the tip from below.
    torsions: Vec<Torsion>,
    series: Vec<Vec<f64>>,
}

impl TipRun {
    /// From the crystal.
    pub fn new(scene: &TipScene) -> Result<Self, TipError> {
        let TipSystem { setup, layer_of } = build(scene)?;
        let torsions = torsions(scene, &layer_of, &setup.atoms.positions);
        let part_of = setup.group_of.clone();
        let mut run = Self {
            part_of,
            system: System::new(setup)?,
            scene: scene.clone(),
            layer_of,
            torsions,
            series: Vec::new(),
        };
        run.sample();
        Ok(run)
    }

    /// From a checkpoint of the same scene, to the same bits as without a break.
    pub fn resume(scene: &TipScene, text: &str) -> Result<Self, TipError> {
        let TipSystem { setup, layer_of } = build(scene)?;
        let mut torsions = torsions(scene, &layer_of, &setup.atoms.positions);
        let width = FIXED_COLUMNS.len() + scene.shape.tip_layers;
        let kept = Checkpoint::read(text, scene, layer_of.len(), width)?;
        for (torsion, angle) in torsions.iter_mut().zip(kept.angles) {
            torsion.restore(angle);
        }
        Ok(Self {
            part_of: setup.group_of.clone(),
            system: System::resume(setup, kept.state)?,
            scene: scene.clone(),
            layer_of,
            torsions,
            series: kept.series,
        })
    }

    /// What [`resume`](Self::resume) goes on from.
    pub fn checkpoint(&self) -> String {
        let kept = Checkpoint {
            state: self.system.state(),
            angles: self.torsions.iter().map(Torsion::angle).collect(),
            series: self.series.clone(),
        };
        kept.text(&self.scene)
    }

    /// The atoms in motion.
    pub fn system(&self) -> &System<LennardJones> {
        &self.system
    }

    /// Layer of each atom, from the lowest of the substrate.
    pub fn layers(&self) -> &[usize] {
        &self.layer_of
    }

    /// Part of each atom, as a number in [`Part::ALL`].
    pub fn parts(&self) -> &[u8] {
        &self.part_of
    }

    /// The scene that runs.
    pub(super) fn scene(&self) -> &TipScene {
        &self.scene
    }

    /// Names of the columns: times in τ from the start of the drive, angles in degrees, those of
    /// the tip's layers from below.
    pub fn columns(&self) -> Vec<String> {
        let layers = 1..=self.scene.shape.tip_layers;
        let names = layers.map(|layer| format!("layer_{layer}"));
        FIXED_COLUMNS
            .map(String::from)
            .into_iter()
            .chain(names)
            .collect()
    }

    /// The lines so far.
    pub fn series(&self) -> &[Vec<f64>] {
        &self.series
    }

    /// Time since the drive was switched on, negative before.
    pub fn time(&self) -> f64 {
        let [before, _, _] = self.scene.stage_steps();
        (self.system.steps() as f64 - before as f64) * self.scene.time_step
    }

    /// Angle of the driven layers in radians.
    pub fn angle(&self) -> f64 {
        self.torsions[0].angle()
    }

    /// What came out.
    pub fn outcome(&self) -> Outcome {
        let columns = FIXED_COLUMNS.len();
        Outcome::of(&self.scene, &self.series, columns, self.drive_moment())
    }

    fn last_step(&self) -> u64 {
        self.scene.stage_steps().into_iter().sum()
    }

    /// Looks at the angles and adds a line to the series.
    fn sample(&mut self) {
        for torsion in &mut self.torsions {
            torsion.look(&self.system.atoms().positions);
        }
        let kinetic = kinetic_energies(&self.system);
        let heat = |part: Part| {
            let group = Part::ALL.iter().position(|&other| other == part);
            let group = group.unwrap_or_default();
            temperature(kinetic[group], self.system.heat_freedoms(group))
        };
        let degrees = self
            .torsions
            .iter()
            .map(|torsion| torsion.angle().to_degrees());
        let mut line = vec![
            self.time(),
            self.torsions[0].angle().to_degrees(),
            self.resisting_torque(),
            self.height(),
            heat(Part::SubstrateBath),
            heat(Part::TipBath),
            self.system.tally().energy,
        ];
        line.extend(degrees.skip(1));
        self.series.push(line);
    }

    /// Torque of all other atoms on the driven ones about the axis, positive against the drive.
    fn resisting_torque(&self) -> f64 {
        let [x0, y0] = self.scene.shape.axis();
        let driven = self.system.members(Part::ALL.len() - 1);
        let part = |&atom: &usize| {
            let (place, force) = (
                self.system.atoms().positions[atom],
                self.system.forces()[atom],
            );
            (place.x - x0) * force.y - (place.y - y0) * force.x
        };
        -driven.iter().map(part).sum::<f64>()
    }

    /// Moment of the drive about its axis.
    fn drive_moment(&self) -> f64 {
        let (atoms, drive) = (self.system.atoms(), self.system.drive());
        let Some(drive) = drive else { return 0.0 };
        let [x0, y0] = drive.axis;
        let part = |&atom: &usize| {
            let place = &atoms.positions[atom];
            let arm = [place.x - x0, place.y - y0];
            atoms.mass(atom) * (arm[0] * arm[0] + arm[1] * arm[1])
        };
        let driven = self.system.members(Part::ALL.len() - 1);
        drive.acceleration * driven.iter().map(part).sum::<f64>()
    }

    /// Mean height of the driven atoms.
    pub(super) fn height(&self) -> f64 {
        let driven = self.system.members(Part::ALL.len() - 1);
        let sum: f64 = driven
            .iter()
            .map(|&atom| self.system.atoms().positions[atom].z)
            .sum();
        sum / driven.len() as f64
    }
}

/// Rotation of the driven atoms and of each layer of the tip.
fn torsions(
    scene: &TipScene,
    layer_of: &[usize],
    positions: &[nalgebra::Vector3<f64>],
) -> Vec<Torsion> {
    let shape = &scene.shape;
    let of = |is_member: &dyn Fn(usize) -> bool| {
        let atoms = (0..layer_of.len()).filter(|&atom| is_member(layer_of[atom]));
        Torsion::new(atoms.collect(), positions)
    };
    let mut torsions = vec![of(&|layer| shape.part(layer) == Part::Driven)];
    for layer in shape.substrate_layers..shape.layers() {
        torsions.push(of(&|other| other == layer));
    }
    torsions
}

impl Simulation for TipRun {
    type Record = Vec<f64>;
    type Error = TipError;

    fn record(&self) -> Vec<f64> {
        self.series.last().cloned().unwrap_or_default()
    }

    /// Goes on to the next line of the series; at the end it does nothing.
    fn step(&mut self) -> Result<bool, TipError> {
        let last = self.last_step();
        if self.system.steps() >= last {
            return Ok(false);
        }
        let next = (self.system.steps() + self.scene.samples).min(last);
        while self.system.steps() < next {
            let wanted = if self.system.steps() + 1 == next {
                Wanted::Sums
            } else {
                Wanted::Forces
            };
            self.system.step(wanted)?;
        }
        self.sample();
        Ok(next < last)
    }

    fn progress(&self) -> f64 {
        self.system.steps() as f64 / (self.last_step().max(1)) as f64
    }
}
