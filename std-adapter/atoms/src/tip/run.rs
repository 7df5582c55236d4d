//! A run of the tip: stages, series, checkpoints.

use super::build::{TipSystem, build};
use super::checkpoint::Checkpoint;
use super::forces::TipForces;
use super::loop_work::is_noted;
use super::monitor::{RunMonitor, interval};
use super::outcome::{Measured, TipSummary};
use super::shape::AtomRole;
use crate::md::eam::SUTTON_CHEN;
use crate::md::interaction::Evaluation;
use crate::md::observe::{heat_energy, temperature};
use crate::md::pair::LennardJonesError;
use crate::md::system::{System, SystemError};
use crate::md::thermostat::ThermostatError;
use crate::tip::scene::{DriveKind, TipScene};
use nalgebra::Vector3;
use tribos_base::golden::{Measure, Measurement, digest};
use tribos_base::record::CheckpointError;
use tribos_base::run::{Simulation, run_to_end};
use tribos_base::scene::InvalidScene;
use tribos_base::space::SpaceError;

/// First columns of the series.
const FIXED_COLUMNS: [&str; 7] = [
    "time",
    "angle",
    "resisting_torque",
    "height",
    "substrate_temperature",
    "tip_temperature",
    "potential_energy",
];

/// Further columns of a slid tip: position of the support, mean displacement of the driven layers
/// and force of the spring on them along the drive, force of all other atoms on them along z, work of
/// the support, heat that thermostats and damping took.
const SLID_COLUMNS: [&str; 6] = [
    "support",
    "tip",
    "lateral_force",
    "normal_force",
    "work",
    "heat",
];

/// Numbers that a line for averages has after those of the series: mean force on a driven atom.
const FORCE: usize = 3;

/// Why a tip cannot be built, started or continued, or a text is no potential of a tip.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TipError {
    /// The text is no potential.
    #[error(
        "must be \"lennard-jones\", \"sutton-chen:Cu\" or \"eam:FILE\" (\"eam:FILE,substrate=Cu,tip=Ni\"), got \"{0}\""
    )]
    Potential(String),
    /// The metal of a potential is not in the table.
    #[error("no parameters for \"{given}\"; the metals are {all}", all = SUTTON_CHEN.map(|metal| metal.name).join(", "))]
    Metal {
        /// The rejected name.
        given: String,
    },
    /// The file of a potential cannot be read.
    #[error("{file}: {reason}")]
    File {
        /// The file.
        file: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A crystal of the element does not hold together in the potential.
    #[error("{name} has no stable face-centred cubic crystal in this potential")]
    Unbound {
        /// The element.
        name: String,
    },
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The box.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// The parameters of the potential.
    #[error(transparent)]
    LennardJones(#[from] LennardJonesError),
    /// The thermostats.
    #[error(transparent)]
    Thermostat(#[from] ThermostatError),
    /// The system cannot be set up, or blew up.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The checkpoint cannot be used.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

/// The tip of a scene in motion.
///
/// ```
/// use tribos::run::Simulation;
/// use tribos::scene::TipScene;
/// use tribos::tip::{AtomRole, TipError, TipSimulation, Reversal};
/// // A cold tip that is pushed for a moment: too short for the lattice to push back.
/// let scene = TipScene {
///     lambda: 0.01,
///     substrate_columns: 8,
///     substrate_rows: 8,
///     substrate_layers: 4,
///     tip_layers: 4,
///     tip_side_atoms: 2,
///     temperature: 0.0,
///     equilibration: 0.0,
///     drive_time: 0.04,
///     rest_time: 0.0,
///     time_step: 0.005,
///     sample_every: 4,
///     ..TipScene::default()
/// };
/// let mut run = TipSimulation::new(&scene)?;
/// run.step()?; // four steps of 0.005, to the next line of the series
/// let free = 0.5 * scene.lambda * run.time() * run.time(); // angle = λt²/2
/// assert!((run.angle() / free - 1.0).abs() < 0.02);
/// assert_eq!(run.columns()[..2], ["time", "angle"]);
/// assert_eq!(run.series()[1][1], run.angle().to_degrees());
/// assert_eq!(run.outcome().verdict, Reversal::Open); // it is not over
/// // It can go on from a file, which keeps all that was.
/// let again = TipSimulation::resume(&scene, &run.checkpoint())?;
/// assert_eq!(again.series(), run.series());
/// assert!(matches!(TipSimulation::resume(&scene, "{}"), Err(TipError::Checkpoint(_))));
/// // Atoms, each with its layer and its part.
/// let last = run.system().atoms().len() - 1;
/// assert_eq!((run.layers()[last], AtomRole::ALL[usize::from(run.parts()[last])]), (7, AtomRole::Driven));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct TipSimulation {
    scene: TipScene,
    system: System<TipForces>,
    layer_of: Vec<usize>,
    part_of: Vec<u8>,
    watch: RunMonitor,
    series: Vec<Vec<f64>>,
}

impl TipSimulation {
    /// A run that starts from the crystal.
    pub fn new(scene: &TipScene) -> Result<Self, TipError> {
        let TipSystem {
            setup,
            support,
            layer_of,
        } = build(scene)?;
        let watch = RunMonitor::new(scene, &layer_of, &setup.atoms.positions);
        let part_of = setup.group_of.clone();
        let mut run = Self {
            part_of,
            system: System::new(setup)?,
            scene: scene.clone(),
            layer_of,
            watch,
            series: Vec::new(),
        };
        if let Some(support) = support {
            run.system.set_support(support);
        }
        run.watch.look(&run.system);
        run.watch.note(&run.scene, &run.system);
        run.write_lines();
        Ok(run)
    }

    /// Resumes from a checkpoint of the same scene, with the same bits as without interruption.
    pub fn resume(scene: &TipScene, text: &str) -> Result<Self, TipError> {
        let TipSystem {
            setup,
            support,
            layer_of,
        } = build(scene)?;
        let mut watch = RunMonitor::new(scene, &layer_of, &setup.atoms.positions);
        let width = first_columns(scene) + scene.tip_layers;
        let widths = [width + FORCE, width];
        let kept = Checkpoint::read(text, scene, layer_of.len(), widths)?;
        watch.restore(&kept.angles, [kept.work, kept.heat], kept.loops, kept.lines);
        let part_of = setup.group_of.clone();
        let mut system = System::resume(setup, kept.state)?;
        if let Some(support) = support {
            system.set_support(support);
        }
        Ok(Self {
            part_of,
            system,
            scene: scene.clone(),
            layer_of,
            watch,
            series: kept.series,
        })
    }

    /// The state from which [`resume`](Self::resume) continues.
    pub fn checkpoint(&self) -> String {
        let kept = Checkpoint {
            state: self.system.state(),
            angles: self.watch.angles().collect(),
            work: self.watch.work(),
            heat: self.watch.heat(),
            loops: self.watch.loops().clone(),
            lines: self.watch.lines().to_vec(),
            series: self.series.clone(),
        };
        kept.text(&self.scene)
    }

    /// The atoms in motion.
    pub fn system(&self) -> &System<TipForces> {
        &self.system
    }

    /// Layer of each atom, from the lowest of the substrate.
    pub fn layers(&self) -> &[usize] {
        &self.layer_of
    }

    /// Part of each atom, as a number in [`AtomRole::ALL`].
    pub fn parts(&self) -> &[u8] {
        &self.part_of
    }

    /// Scene of the run.
    pub(super) fn scene(&self) -> &TipScene {
        &self.scene
    }

    /// Names of the columns: times in τ from the start of the drive, angles in degrees, those of
    /// the tip's layers from below. A slid tip has more of them before the layers.
    ///
    /// `lateral_force` is the spring's on the tip along the drive, `normal_force` that of all other
    /// atoms on the driven layers along z, `support` and `tip` are their ways along the drive, `work`
    /// and `heat` sums since the start of the run.
    pub fn columns(&self) -> Vec<String> {
        let layers = 1..=self.scene.tip_layers;
        let names = layers.map(|layer| format!("layer_{layer}"));
        let slid: &[&str] = match self.scene.drive {
            DriveKind::Torque => &[],
            DriveKind::Slide => &SLID_COLUMNS,
        };
        let first = FIXED_COLUMNS.iter().chain(slid);
        first.map(|&name| name.into()).chain(names).collect()
    }

    /// The lines so far.
    pub fn series(&self) -> &[Vec<f64>] {
        &self.series
    }

    /// Time since the drive was switched on, negative before.
    pub fn time(&self) -> f64 {
        let before = self.scene.stage_steps().before;
        (self.system.steps() as f64 - before as f64) * self.scene.time_step
    }

    /// Angle of the driven layers in radians.
    pub fn angle(&self) -> f64 {
        self.watch.angles().next().unwrap_or_default()
    }

    /// The outcome, which does not depend on how often lines of the series are written.
    pub fn outcome(&self) -> TipSummary {
        let measured = Measured {
            lines: self.watch.lines(),
            layers: first_columns(&self.scene),
            loops: self.watch.loops(),
            work: self.watch.work(),
            samples: self.series.len(),
        };
        TipSummary::of(&self.scene, &measured)
    }

    /// Advances to a step and computes the sums of the interaction there.
    fn advance(&mut self, to: u64) -> Result<(), TipError> {
        while self.system.steps() < to {
            let next = self.system.steps() + 1;
            let is_noted = is_noted(&self.scene, next);
            let wanted = if next == to || is_noted {
                Evaluation::Sums
            } else {
                Evaluation::Forces
            };
            self.watch.before(&self.system);
            self.system.step(wanted)?;
            self.watch.after(&self.system);
            if is_noted {
                self.watch.note(&self.scene, &self.system);
            }
        }
        Ok(())
    }

    fn last_step(&self) -> u64 {
        self.scene.stage_steps().total()
    }

    /// Adds a line to the series and to the averages if they take one after this step.
    fn write_lines(&mut self) {
        let line = self.line();
        if self.wants_average() {
            let mut line = line.clone();
            line.extend(self.mean_force());
            self.watch.keep(line);
        }
        if self.wants_sample() {
            self.series.push(line);
        }
    }

    /// Whether the series has a line after this step.
    fn wants_sample(&self) -> bool {
        let steps = self.system.steps();
        steps.is_multiple_of(self.scene.sample_every) || steps == self.last_step()
    }

    /// Whether averages take a line after this step.
    fn wants_average(&self) -> bool {
        let steps = self.system.steps();
        steps.is_multiple_of(interval(&self.scene)) || steps == self.last_step()
    }

    /// The current state as a line.
    fn line(&self) -> Vec<f64> {
        let heat = |part: AtomRole| {
            let group = AtomRole::ALL.iter().position(|&other| other == part);
            let group = group.unwrap_or_default();
            let kinetic = heat_energy(&self.system, group);
            let energy = temperature(kinetic, self.system.heat_freedoms(group));
            energy / self.scene.potential.boltzmann()
        };
        let mut line = vec![
            self.time(),
            self.angle().to_degrees(),
            self.resisting_torque(),
            self.height(),
            heat(AtomRole::SubstrateBath),
            heat(AtomRole::TipBath),
            self.system.tally().energy,
        ];
        line.extend(self.slid().into_iter().flatten());
        line.extend(self.watch.angles().skip(1).map(f64::to_degrees));
        line
    }

    /// The further columns of a slid tip.
    fn slid(&self) -> Option<[f64; SLID_COLUMNS.len()]> {
        let support = self.system.support()?;
        let position = support.position(self.system.time());
        let ([x, y], [along_x, along_y]) = (self.system.support_force(), support.direction);
        let lateral = x * along_x + y * along_y;
        let driven = self.system.members(AtomRole::ALL.len() - 1).len() as f64;
        Some([
            position,
            position - lateral / self.scene.stiffness,
            lateral,
            self.mean_force()[2] * driven,
            self.watch.work(),
            self.watch.heat(),
        ])
    }

    /// Mean force of all other atoms on a driven one.
    fn mean_force(&self) -> [f64; FORCE] {
        let driven = self.system.members(AtomRole::ALL.len() - 1);
        let forces = driven.iter().map(|&atom| self.system.forces()[atom]);
        let count = driven.len() as f64;
        (forces.sum::<Vector3<f64>>() / count).into()
    }

    /// Torque of all other atoms on the driven ones about the axis, positive against the drive.
    fn resisting_torque(&self) -> f64 {
        let [x0, y0] = self.scene.shape().axis();
        let driven = self.system.members(AtomRole::ALL.len() - 1);
        let part = |&atom: &usize| {
            let (place, force) = (
                self.system.atoms().positions[atom],
                self.system.forces()[atom],
            );
            (place.x - x0) * force.y - (place.y - y0) * force.x
        };
        -driven.iter().map(part).sum::<f64>()
    }

    /// Mean height of the driven atoms.
    pub(super) fn height(&self) -> f64 {
        let driven = self.system.members(AtomRole::ALL.len() - 1);
        let sum: f64 = driven
            .iter()
            .map(|&atom| self.system.atoms().positions[atom].z)
            .sum();
        sum / driven.len() as f64
    }
}

/// Number of columns before the angles of the tip's layers.
fn first_columns(scene: &TipScene) -> usize {
    FIXED_COLUMNS.len()
        + match scene.drive {
            DriveKind::Torque => 0,
            DriveKind::Slide => SLID_COLUMNS.len(),
        }
}

impl Simulation for TipSimulation {
    type Record = Vec<f64>;
    type Error = TipError;

    fn record(&self) -> Vec<f64> {
        self.series.last().cloned().unwrap_or_default()
    }

    /// Advances to the next line of the series; at the end it does nothing.
    fn step(&mut self) -> Result<bool, TipError> {
        let last = self.last_step();
        if self.system.steps() >= last {
            return Ok(false);
        }
        // Lines are at multiples of their interval, and at the end.
        let until = |every: u64, steps: u64| (steps / every + 1).saturating_mul(every).min(last);
        let next = until(self.scene.sample_every, self.system.steps());
        while self.system.steps() < next {
            let steps = self.system.steps();
            let line = next.min(until(interval(&self.scene), steps));
            self.advance(line)?;
            self.write_lines();
        }
        Ok(next < last)
    }

    fn progress(&self) -> f64 {
        self.system.steps() as f64 / (self.last_step().max(1)) as f64
    }
}

impl Measure for TipScene {
    type Error = TipError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, TipError> {
        let mut run = TipSimulation::new(self)?;
        run_to_end(&mut run, |_, _| watch())?;
        let summary = run.outcome().json(self);
        let rows = run.series().iter().cloned();
        let mut measurement = Measurement::new(&summary, &run.columns(), rows);
        let atoms = run.system().atoms();
        measurement.state = vec![
            ("positions", digest(&atoms.positions)),
            ("velocities", digest(&atoms.velocities)),
        ];
        Ok(measurement)
    }
}
