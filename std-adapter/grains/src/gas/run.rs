//! A gas from its start to its end.

use super::checkpoint::Checkpoint;
use super::engine::GasEngine;
use super::lattice::edge;
use super::outcome::{COLUMNS, GasLine, GasSummary, Row};
use super::start::start;
use super::state::GasState;
use super::time_stepped::DENSITY;
use crate::gas::scene::GasScene;
use crate::packing::PackingRunError;
use crate::packing::PackingStopReason;
use nalgebra::Vector3;
use std::ops::ControlFlow;
use std::time::Instant;
use tribos_base::golden::{Measure, Measurement, digest};
use tribos_base::record::Snapshot;
use tribos_base::run::{Simulation, run_to_end};
use tribos_base::space::PeriodicBox;
use tribos_contacts::event::{Advance, Impact, Temperatures, collision_rate};

/// A gas in progress.
///
/// ```
/// use tribos::gas::{COLUMNS, GasSimulation};
/// use tribos::run::run_to_end;
/// use tribos::scene::GasScene;
/// let scene = GasScene { count: 500, restitution: 0.95, collisions: 6.0, ..GasScene::default() };
/// let mut gas = GasSimulation::new(&scene)?;
/// run_to_end(&mut gas, |_, _| ())?;
/// // Haff's law: T = exp(-(1 - e²) C/3) after C collisions a sphere.
/// let end = gas.outcome();
/// assert!((end.temperature / (-0.195_f64).exp() - 1.0).abs() < 0.03);
/// assert!(end.momentum < 1e-10);
/// assert_eq!(gas.series().last().map(|row| row.len()), Some(COLUMNS.len()));
/// # Ok::<(), tribos::run::PackingRunError>(())
/// ```
#[derive(Debug)]
pub struct GasSimulation {
    scene: GasScene,
    law: Impact,
    length: f64,
    medium: GasEngine,
    steps: u64,
    series: Vec<Row>,
    ending: Option<PackingStopReason>,
    radii: Vec<f64>,
    wall_seconds: f64,
    started: Instant,
}

impl GasSimulation {
    /// Starts from the scene's mixed state.
    pub fn new(scene: &GasScene) -> Result<Self, PackingRunError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](GasSimulation::checkpoint) of a run of the same scene, with the same bits as without
    /// interruption.
    ///
    /// ```
    /// use tribos::gas::GasSimulation;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::GasScene;
    /// # let scene = GasScene { count: 100, ..GasScene::default() };
    /// let mut whole = GasSimulation::new(&scene)?;
    /// whole.step()?;
    /// let mut broken = GasSimulation::resume(&scene, &whole.checkpoint())?;
    /// whole.step()?;
    /// broken.step()?;
    /// assert_eq!(broken.series(), whole.series());
    /// # Ok::<(), tribos::run::PackingRunError>(())
    /// ```
    pub fn resume(scene: &GasScene, checkpoint: &str) -> Result<Self, PackingRunError> {
        Self::begin(scene, Some(checkpoint), |_| ControlFlow::Continue(()))
    }

    /// Starts [anew](Self::new) or [resumes](Self::resume); `watch` can stop the mixing of the start.
    pub fn begin(
        scene: &GasScene,
        checkpoint: Option<&str>,
        mut watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, PackingRunError> {
        scene.check()?;
        let kept = checkpoint.map(|text| Checkpoint::read(text, scene));
        let (medium, steps, series, ending, wall_seconds) = match kept.transpose()? {
            Some(kept) => (
                GasEngine::thawed(scene, kept.medium)?,
                kept.steps,
                kept.series,
                kept.ending,
                kept.wall_seconds,
            ),
            None => {
                let bodies = start(scene, &mut watch)?;
                (GasEngine::new(scene, &bodies)?, 0, Vec::new(), None, 0.0)
            }
        };
        let mut gas = Self {
            scene: scene.clone(),
            law: scene.impact()?,
            length: edge(scene.count, scene.packing_fraction),
            medium,
            steps,
            series,
            ending,
            radii: vec![1.0; scene.count],
            wall_seconds,
            started: Instant::now(),
        };
        if gas.series.is_empty() {
            let first = gas.record();
            gas.series.push(first);
        }
        Ok(gas)
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        let checkpoint = Checkpoint {
            medium: self.medium.kept(),
            steps: self.steps,
            series: self.series.clone(),
            ending: self.ending,
            wall_seconds: self.wall_seconds(),
        };
        checkpoint.text(&self.scene)
    }

    /// The scene of the run.
    pub(super) fn scene(&self) -> &GasScene {
        &self.scene
    }

    /// Edge of the cube, in R.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Number of steps so far: of lines of the series with events, of time steps else.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Current time.
    pub fn time(&self) -> f64 {
        self.medium.time()
    }

    /// Collisions a sphere since the start; one of a pair counts for both.
    pub fn collisions(&self) -> f64 {
        2.0 * self.medium.collisions() as f64 / self.scene.count as f64
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<PackingStopReason> {
        self.ending
    }

    /// Rows of the series so far, with the columns of [`COLUMNS`].
    pub fn series(&self) -> &[[f64; COLUMNS.len()]] {
        &self.series
    }

    /// The current state.
    pub(super) fn state(&self) -> GasState {
        self.medium.state()
    }

    /// Calls `export` with the current state.
    pub fn with_snapshot<T>(
        &self,
        export: impl FnOnce(&Snapshot<'_>) -> T,
    ) -> Result<T, PackingRunError> {
        let state = self.state();
        let velocities: Vec<Vector3<f64>> = state.motions.iter().map(|m| m.velocity).collect();
        let spins: Vec<Vector3<f64>> = state.motions.iter().map(|m| m.spin).collect();
        Ok(export(&Snapshot {
            time: self.time(),
            space: PeriodicBox::new([Some(self.length); 3])?,
            extents: [[0.0, self.length]; 3],
            positions: &state.places,
            radii: &self.radii,
            velocities: Some(&velocities),
            spins: Some(&spins),
            species: None,
            materials: None,
            densities: Some(&vec![DENSITY; self.radii.len()]),
            contacts: &[],
        }))
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> GasSummary {
        let now = self.line();
        let first = self.series.first().map_or(now, |row| (*row).into());
        GasSummary {
            ending: self.ending,
            time: now.time,
            steps: self.steps,
            particles: self.scene.count,
            edge: self.length,
            collisions: now.collisions,
            temperature: now.temperature,
            temperature_rotational: now.temperature_rotational,
            theory: now.theory,
            theory_rotational: now.theory_rotational,
            haff: now.haff,
            energy_initial: first.energy,
            energy_final: now.energy,
            energy_lost: now.lost,
            momentum: now.momentum,
            density_variance_initial: first.density_variance,
            density_variance_final: now.density_variance,
            collisions_cured: self.medium.cured(),
            steps_unmet: self.medium.unmet(),
            wall_seconds: self.wall_seconds(),
        }
    }

    fn wall_seconds(&self) -> f64 {
        self.wall_seconds + self.started.elapsed().as_secs_f64()
    }

    /// Collisions of pairs for so many a sphere.
    fn pairs(&self, collisions: f64) -> u64 {
        (0.5 * collisions * self.scene.count as f64).ceil() as u64
    }

    /// Collisions of pairs at the next line of the series.
    fn next_line(&self) -> u64 {
        let line = self.series.len() as f64 * self.scene.sample_every;
        self.pairs(line.min(self.scene.collisions))
    }

    /// Mean-field temperatures, on from the last line.
    fn theory(&self, collisions: f64, measured: Temperatures) -> Temperatures {
        let Some(last) = self.series.last().map(|row| GasLine::from(*row)) else {
            return measured;
        };
        let then = Temperatures {
            translational: last.theory,
            rotational: last.theory_rotational,
        };
        let since = collisions - last.collisions;
        if since > 0.0 {
            then.after(since, &self.law)
        } else {
            then
        }
    }

    /// Haff's law of smooth spheres: T₀/(1 + t/τ)², 1/τ = (1 − e²)/6 of the collision rate at the start.
    fn haff(&self, time: f64, now: f64) -> f64 {
        let first = self.series.first().map(|row| GasLine::from(*row));
        let first = first.map_or(now, |line| line.temperature);
        let e = self.law.restitution();
        let rate = (1.0 - e * e) / 6.0 * collision_rate(self.scene.packing_fraction, first);
        let slowed = 1.0 + rate * time;
        first / (slowed * slowed)
    }

    /// The current line of the series.
    fn line(&self) -> GasLine {
        let state = self.state();
        let now = state.temperatures();
        let (time, collisions) = (self.time(), self.collisions());
        let theory = self.theory(collisions, now);
        GasLine {
            time,
            collisions,
            temperature: now.translational,
            temperature_rotational: now.rotational,
            theory: theory.translational,
            theory_rotational: theory.rotational,
            haff: self.haff(time, now.translational),
            enskog_rate: collision_rate(self.scene.packing_fraction, now.translational),
            energy: state.energy(),
            lost: self.medium.lost() / self.scene.count as f64,
            momentum: state.momentum().norm(),
            density_variance: state.density_variance(self.length),
        }
    }

    /// The current row, if all its values are finite.
    fn finite_record(&self) -> Result<Row, PackingRunError> {
        let record = self.record();
        let bad = COLUMNS.into_iter().zip(record);
        match bad.into_iter().find(|(_, value)| !value.is_finite()) {
            Some((column, value)) => Err(PackingRunError::NotFinite {
                step: self.steps,
                column,
                value,
            }),
            None => Ok(record),
        }
    }
}

impl Simulation for GasSimulation {
    type Record = Row;
    type Error = PackingRunError;

    fn record(&self) -> Row {
        self.line().values()
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, PackingRunError> {
        if self.ending.is_some() {
            return Ok(false);
        }
        let (next, all) = (self.next_line(), self.pairs(self.scene.collisions));
        let until = self.scene.duration.unwrap_or(f64::INFINITY);
        let stop = self.medium.advance(next, until)?;
        self.steps += 1;
        self.ending = match stop {
            Some(Advance::Time) => Some(PackingStopReason::Time),
            Some(Advance::Collapse) => Some(PackingStopReason::Collapse),
            Some(Advance::Rest) => Some(PackingStopReason::Rest),
            Some(Advance::Collisions) if self.medium.collisions() >= all => {
                Some(PackingStopReason::Collisions)
            }
            _ => None,
        };
        if stop.is_some() {
            let record = self.finite_record()?;
            self.series.push(record);
        }
        Ok(self.ending.is_none())
    }

    fn progress(&self) -> f64 {
        let of_time = self.scene.duration.map_or(0.0, |end| self.time() / end);
        of_time
            .max(self.collisions() / self.scene.collisions)
            .min(1.0)
    }
}

impl Measure for GasScene {
    type Error = PackingRunError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, PackingRunError> {
        let mut gas = GasSimulation::new(self)?;
        run_to_end(&mut gas, |_, _| watch())?;
        let rows = gas.series().iter().map(|row| row.to_vec());
        let summary = gas.outcome().json(self);
        let mut measurement = Measurement::new(&summary, &COLUMNS, rows);
        measurement.state = gas.with_snapshot(|end| {
            vec![
                ("positions", digest(end.positions)),
                ("velocities", digest(end.velocities.unwrap_or_default())),
                ("spins", digest(end.spins.unwrap_or_default())),
            ]
        })?;
        Ok(measurement)
    }
}
