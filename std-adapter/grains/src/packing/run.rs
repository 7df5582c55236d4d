//! A run of a packing: start, steps, measurements, series, checkpoints, limits.
//!
//! A [`PackingBody`] says its spheres, its loads, its measures and when it ends; all else of a run is here.

use super::body::{MeasuredState, MeasurementSchedule, PackingBody, packing_of};
use super::checkpoint::{ORIGIN, PackingCheckpoint};
use super::last::put_report;
use super::{
    ContactStatistics, Kinds, Limits, PackingRunError, PackingStopReason, Shape, Stored, Totals,
    origin,
};
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::time::Instant;
use tribos_base::golden::{Digest, Measurement, contacts, digest};
use tribos_base::record::checkpoint::hex;
use tribos_base::record::frames::{Bodies, ContactStateFlags, Frame, FrameContact};
use tribos_base::record::{ContactRow, Snapshot, with_digest};
use tribos_base::run::{Cause, LongRun, Simulation, run_to_end};
use tribos_base::scene::Body as _;
use tribos_contacts::cd::StepReport;
use tribos_contacts::problem::GlobalProblem;

/// Overlap of rigid spheres over the smaller radius beyond which their packing is none: twice what a start may have.
const TOO_DEEP: f64 = 0.1;

/// A packing of spheres in motion: a [powder](crate::powder::PowderSimulation) or
/// [grains](crate::grains::GrainsSimulation).
///
/// `B` is the body, which a scene describes; `N` is the number of columns of its series.
///
/// ```
/// use tribos::powder::PowderSimulation;
/// use tribos::run::Simulation;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let mut whole = PowderSimulation::new(&scene)?;
/// for _ in 0..5 {
///     whole.step()?;
/// }
/// let kept = whole.checkpoint();
/// whole.step()?;
///
/// // Goes on with the same bits, forces included.
/// let mut broken = PowderSimulation::resume(&scene, &kept)?;
/// assert_eq!(broken.steps(), 5);
/// broken.step()?;
/// assert_eq!(broken.last_step(), whole.last_step());
/// assert_eq!(broken.contacts(), whole.contacts());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct PackingRun<B: PackingBody<N>, const N: usize> {
    pub(crate) body: B,
    pub(crate) watch: B::Monitor,
    pub(crate) seen: MeasuredState,
    kinds: Kinds,
    series: Vec<[f64; N]>,
    /// Why the run ended, if it has.
    ending: Option<PackingStopReason>,
    /// Digest of what the run began with.
    origin: String,
    totals: Totals,
    started: Instant,
}

impl<B: PackingBody<N>, const N: usize> PackingRun<B, N> {
    /// Starts from the spheres of the scene: a deposit with the piston on it, grains that do not touch, or those
    /// of its `initial_state`.
    pub fn new(scene: &B::Scene) -> Result<Self, PackingRunError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](Self::checkpoint) of a run of the same scene, with the same bits as without
    /// interruption. A run that had ended remains ended and takes no more steps.
    pub fn resume(scene: &B::Scene, checkpoint: &str) -> Result<Self, PackingRunError> {
        Self::begin(scene, Some(checkpoint), |_| ControlFlow::Continue(()))
    }

    /// Checks that a run of the scene can start. A deposit is not grown for it: two spheres are enough.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::run::{PackingRunError, PlacementError};
    /// # use tribos::scene::PowderScene;
    /// # let flat = PowderScene { width: 6.0, height: 1.0, pressure: 0.02, ..PowderScene::default() };
    /// // A deposit that is cut at a height of half a sphere.
    /// let refused = PowderSimulation::check(&flat);
    /// assert!(matches!(refused, Err(PackingRunError::Placement(PlacementError::Empty))));
    /// ```
    pub fn check(scene: &B::Scene) -> Result<(), PackingRunError> {
        B::check(scene)
    }

    /// Starts [anew](Self::new) or [resumes](Self::resume) from a checkpoint; `watch` receives the number of
    /// spheres placed so far and can stop the placement.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use tribos::powder::PowderSimulation;
    /// use tribos::run::{PackingRunError, PlacementError};
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let stopped = PowderSimulation::begin(&scene, None, |_spheres| ControlFlow::Break(()));
    /// assert!(matches!(stopped, Err(PackingRunError::Placement(PlacementError::Stopped))));
    /// ```
    pub fn begin(
        scene: &B::Scene,
        checkpoint: Option<&str>,
        mut watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, PackingRunError> {
        scene.check()?;
        let kept = PackingCheckpoint::<B, N>::read(checkpoint, &scene.json())?;
        let (body, start) = B::place(scene, &mut watch)?;
        let corners = body.corners();
        let places = start.positions.iter().chain(&corners);
        let origin = origin(places, &start.radii, &start.kinds);
        if let Some(kept) = &kept {
            let numbers = (start.radii.len(), body.walls(), !corners.is_empty());
            kept.fits(numbers, &origin)?;
        }
        let frozen = kept.as_ref().map(|kept| &kept.frozen);
        let packing = packing_of(&body, &start, frozen.or(start.frozen.as_ref()))?;
        let mut run = Self {
            watch: body.monitor(),
            body,
            seen: MeasuredState {
                packing,
                contacts: start.contacts,
                report: StepReport::default(),
            },
            kinds: start.kinds,
            series: Vec::new(),
            ending: None,
            origin,
            totals: Totals::default(),
            started: Instant::now(),
        };
        match kept {
            Some(kept) => run.restore(kept)?,
            None => run.series.push(run.record()),
        }
        Ok(run)
    }

    /// Takes over what a checkpoint has beside the packing.
    fn restore(&mut self, kept: PackingCheckpoint<B, N>) -> Result<(), PackingRunError> {
        self.series = kept.series(self.body.bounds())?;
        self.watch = kept.watch;
        self.totals = kept.totals;
        self.ending = kept.ending;
        self.seen.report = kept.report;
        if self.steps() > 0 {
            self.find_contacts()?;
        }
        Ok(())
    }

    /// The scene of the run.
    pub fn scene(&self) -> &B::Scene {
        self.body.scene()
    }

    /// Elapsed time.
    pub fn time(&self) -> f64 {
        self.seen.packing.clock().0
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.seen.packing.clock().1
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<PackingStopReason> {
        self.ending
    }

    /// Rows of the series so far, with the columns of the body.
    pub fn series(&self) -> &[[f64; N]] {
        &self.series
    }

    /// Report of the last step.
    pub fn last_step(&self) -> &StepReport {
        &self.seen.report
    }

    /// Contacts after the last step with their forces; before the first step, those of the start.
    pub fn contacts(&self) -> &[ContactRow] {
        &self.seen.contacts
    }

    /// The contact problem of the last step as data, before any impact with restitution.
    ///
    /// Its contacts are pairs of spheres, then spheres at walls; bodies that sleep are not in it. `None` before
    /// the first step (also of a run that goes on), without contacts, with springs in place of rigid contacts, and
    /// where sliding and torsion share a limit surface that is no ellipsoid.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::problem::solve;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let mut compaction = PowderSimulation::new(&scene)?;
    /// compaction.step()?;
    /// let problem = compaction.problem().expect("rigid contacts after a step").reduced()?;
    /// assert_eq!(problem.contacts(), compaction.last_step().contacts);
    /// assert!(solve(&problem, &Default::default(), |_| ()).residual.meets(1e-8));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn problem(&self) -> Option<GlobalProblem> {
        let problem = self.seen.packing.problem();
        problem.filter(|problem| !problem.laws().is_empty())
    }

    /// Number of contacts between spheres now.
    pub(crate) fn pairs(&self) -> usize {
        let rows = self.seen.contacts.iter();
        rows.filter(|row| row.b.particle().is_some()).count()
    }

    /// Deepest overlap so far, a length; 0 if there was none.
    pub(crate) fn max_overlap(&self) -> f64 {
        let depths = self.seen.contacts.iter().map(|row| -row.gap);
        depths.fold(self.totals.overlap, f64::max)
    }

    /// Numbers and forces of the contacts now.
    pub(crate) fn statistics(&self) -> ContactStatistics {
        let mixture = self.body.contact_keys().mixture;
        let is_mixed = self.kinds.indices(&mixture).iter().any(|index| *index > 0);
        let limits = Limits::of(mixture.first());
        ContactStatistics::of(&self.seen.contacts, self.seen.packing.radii(), &limits)
            .of_materials(is_mixed)
    }

    /// Sums over the steps, with the time up to now.
    pub(crate) fn totals(&self) -> Totals {
        Totals {
            wall_seconds: self.totals.wall_seconds + self.started.elapsed().as_secs_f64(),
            ..self.totals
        }
    }

    /// Refuses a packing that rigid spheres cannot have, where the step began with such an overlap for the smallest.
    fn check_overlap(&mut self) -> Result<(), PackingRunError> {
        let radii = self.seen.packing.radii().iter();
        let smallest = radii.copied().fold(f64::INFINITY, f64::min);
        if self.seen.packing.is_rigid() && self.seen.report.overlap > TOO_DEEP * smallest {
            self.find_contacts()?;
            self.judge_overlap()?;
        }
        Ok(())
    }

    /// Refuses such a packing by its contacts.
    fn judge_overlap(&self) -> Result<(), PackingRunError> {
        let radii = self.seen.packing.radii();
        let radius = |body: Option<u32>| body.map_or(f64::INFINITY, |body| radii[body as usize]);
        let depth = |row: &ContactRow| -row.gap / radius(Some(row.a)).min(radius(row.b.particle()));
        let overlap = self.seen.contacts.iter().map(depth).fold(0.0, f64::max);
        if self.seen.packing.is_rigid() && overlap > TOO_DEEP {
            return Err(PackingRunError::Overlap {
                step: self.steps(),
                overlap,
                solid_fraction: 1.0 - self.body.porosity(&self.seen),
            });
        }
        Ok(())
    }

    /// Finds the contacts after a step and measures them.
    fn measure_step(&mut self) -> Result<(), PackingRunError> {
        self.find_contacts()?;
        self.body.measure(&mut self.watch, &self.seen);
        Ok(())
    }

    fn find_contacts(&mut self) -> Result<(), PackingRunError> {
        let step = self.steps();
        let contacts = self.seen.packing.contacts();
        self.seen.contacts = contacts.map_err(|cause| PackingRunError::Touch { step, cause })?;
        Ok(())
    }

    /// The current line, if all its values and the energy balance are finite.
    fn finite_line(&self) -> Result<[f64; N], PackingRunError> {
        let line = self.record();
        let named = B::COLUMNS.into_iter().zip(line);
        let balance = [("work", self.seen.packing.energy().imbalance())];
        match named.chain(balance).find(|(_, value)| !value.is_finite()) {
            Some((column, value)) => Err(PackingRunError::NotFinite {
                step: self.steps(),
                column,
                value,
            }),
            None => Ok(line),
        }
    }

    /// Contacts at the current places: between two lines of the series they are found anew.
    fn contacts_now(&self) -> Cow<'_, [ContactRow]> {
        let found = match B::CADENCE {
            MeasurementSchedule::Lines => self.seen.packing.contacts().ok(),
            MeasurementSchedule::Steps => None,
        };
        found.map_or(Cow::Borrowed(self.seen.contacts.as_slice()), Cow::Owned)
    }

    fn shape(&self) -> Shape {
        let walls = self.seen.packing.walls().iter();
        Shape {
            // Without the displacement of sheared images.
            space: self.seen.packing.space().sheared(0.0),
            radii: self.seen.packing.radii().to_vec(),
            kinds: self.kinds.clone(),
            outward: walls.map(|wall| wall.outward).collect(),
            contacts: self.contacts_now().into_owned(),
        }
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        let mut map = Map::new();
        map.insert(B::FORMAT.0.into(), B::FORMAT.1.into());
        map.insert("scene".into(), self.scene().json());
        // Read by runs that start from this state.
        self.shape().put(&mut map);
        self.seen.packing.snapshot().put(&mut map);
        self.totals().put(&mut map);
        put_report(&self.seen.report, &mut map);
        map.insert(ORIGIN.into(), self.origin.clone().into());
        B::write_checkpoint(&self.watch, &mut map);
        let series: Vec<f64> = self.series.iter().flatten().copied().collect();
        map.insert("series".into(), hex(&series).into());
        map.insert(
            "ending".into(),
            self.ending.map(PackingStopReason::name).into(),
        );
        with_digest(map)
    }

    /// The current state as a file, from which a run of another scene can start: `initial_state` names the file or its
    /// folder.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let mut light = PowderSimulation::new(&scene)?;
    /// for _ in 0..20 {
    ///     light.step()?;
    /// }
    /// # let home = tempfile::tempdir()?;
    /// # let file = home.path().join("state.json");
    /// std::fs::write(&file, light.state())?;
    /// let heavy = PowderScene { pressure: 0.04, initial_state: Some(file), ..scene };
    /// let heavy = PowderSimulation::new(&heavy)?;
    /// assert_eq!((heavy.steps(), heavy.height()), (0, light.height()));
    /// assert_eq!(heavy.contacts(), light.contacts());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn state(&self) -> String {
        let stored = Stored {
            scene: self.scene().json(),
            shape: self.shape(),
            frozen: self.seen.packing.snapshot(),
        };
        stored.text()
    }

    /// Calls `export` with the current state.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::record::extended_xyz;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let compaction = PowderSimulation::new(&scene)?;
    /// let frame = compaction.with_snapshot(extended_xyz)?;
    /// // A line a sphere, and two before them.
    /// assert_eq!(frame.lines().count(), compaction.deposit().positions.len() + 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_snapshot<T>(&self, export: impl FnOnce(&Snapshot<'_>) -> T) -> T {
        let packing = &self.seen.packing;
        let spheres = packing.spheres();
        let velocities: Vec<_> = spheres.iter().map(|sphere| sphere.velocity).collect();
        let spins: Vec<_> = spheres.iter().map(|sphere| sphere.spin).collect();
        export(&Snapshot {
            time: self.time(),
            space: packing.space(),
            extents: self.body.extents(&self.seen),
            positions: packing.positions(),
            radii: packing.radii(),
            velocities: Some(&velocities),
            spins: Some(&spins),
            species: None,
            materials: self.kinds.mixed(),
            densities: Some(&self.kinds.densities),
            contacts: &self.seen.contacts,
        })
    }

    /// Runs the scene to its end for golden files, with the summary of the end.
    pub(crate) fn measured(
        scene: &B::Scene,
        watch: &mut dyn FnMut(),
        summary: impl FnOnce(&Self) -> Value,
    ) -> Result<Measurement, PackingRunError> {
        let mut run = Self::new(scene)?;
        run_to_end(&mut run, |_, _| watch())?;
        let rows = run.series.iter().map(|row| row.to_vec());
        let mut measurement = Measurement::new(&summary(&run), &B::COLUMNS, rows);
        measurement.state = run.with_snapshot(|end| {
            vec![
                ("positions", digest(end.positions)),
                ("radii", Digest::of(end.radii.iter().copied())),
                ("velocities", digest(end.velocities.unwrap_or_default())),
                ("spins", digest(end.spins.unwrap_or_default())),
                ("contacts", contacts(end.contacts)),
            ]
        });
        Ok(measurement)
    }
}

impl<B: PackingBody<N>, const N: usize> Simulation for PackingRun<B, N> {
    type Record = [f64; N];
    type Error = PackingRunError;

    fn record(&self) -> [f64; N] {
        self.body.line(&self.watch, &self.seen)
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, Self::Error> {
        if self.ending.is_some() {
            return Ok(false);
        }
        let (watch, seen) = (&mut self.watch, &mut self.seen);
        self.body.prepare(watch, &mut *seen.packing);
        seen.report = seen.packing.step()?;
        self.totals.add(&seen.report);
        self.check_overlap()?;
        if B::CADENCE == MeasurementSchedule::Steps {
            self.measure_step()?;
        }

        // Lines of the series; the last state is one of them.
        let bounds = self.body.bounds();
        let ending = if self.body.is_over(&mut self.watch, &self.seen) {
            Some(B::OVER)
        } else {
            bounds.reached(self.seen.packing.clock())
        };
        let is_line = ending.is_some() || self.steps().is_multiple_of(bounds.samples);
        if is_line && B::CADENCE == MeasurementSchedule::Lines {
            self.measure_step()?;
        }
        if is_line {
            self.judge_overlap()?;
        }
        if is_line || B::CADENCE == MeasurementSchedule::Steps {
            let line = self.finite_line()?;
            if is_line {
                self.series.push(line);
            }
        }
        self.ending = ending;
        Ok(ending.is_none())
    }

    fn progress(&self) -> f64 {
        self.body.bounds().progress(self.seen.packing.clock())
    }
}

impl<B: PackingBody<N>, const N: usize> LongRun for PackingRun<B, N> {
    type Scene = B::Scene;

    fn begin(
        scene: &B::Scene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, Self::Error> {
        Self::begin(scene, checkpoint, growing)
    }

    fn cause(error: &Self::Error) -> Cause {
        error.cause()
    }

    fn checkpoint(&self) -> String {
        self.checkpoint()
    }

    fn steps(&self) -> u64 {
        self.steps()
    }

    /// Data common to all frames of the film, which keeps at most `limit` of them.
    fn bodies(&self, limit: u64) -> Bodies {
        Bodies {
            kind: B::KIND,
            scene: self.scene().json(),
            limit,
            stride: 1,
            sides: self.body.sides(),
            periods: self.seen.packing.space().lengths(),
            radii: self.seen.packing.radii().to_vec(),
            materials: self.kinds.mixed().unwrap_or_default().to_vec(),
            densities: self.kinds.densities.clone(),
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The current state; before the first step the contacts of the start carry no force.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::run::LongRun;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let compaction = PowderSimulation::new(&scene)?;
    /// let (bodies, first) = (compaction.bodies(100), compaction.frame());
    /// assert_eq!(first.places.len(), bodies.radii.len());
    /// assert_eq!((first.step, first.height), (0, compaction.height()));
    /// assert!(first.speeds.iter().all(|speed| *speed == 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn frame(&self) -> Frame {
        let packing = &self.seen.packing;
        let limits = Limits::of(self.body.contact_keys().mixture.first());
        let extents = self.body.extents(&self.seen);
        let (space, radii) = (packing.space(), packing.radii());
        let corner = |end: usize| extents.map(|ends| ends[end] as f32);
        let contact = |row: &ContactRow| FrameContact {
            a: row.a,
            b: row.b,
            normal_force: row.normal_force() as f32,
            hold: limits
                .reached(row, radii)
                .map_or(ContactStateFlags::OPEN, ContactStateFlags::of),
        };
        let rows = self.contacts_now();
        let across = |row: &ContactRow| (row.force - row.normal * row.normal_force()).cast::<f32>();
        let velocities = || packing.spheres().iter().map(|sphere| sphere.velocity);
        Frame {
            step: self.steps(),
            time: self.time(),
            height: self.body.height(&self.seen),
            measure: self.body.porosity(&self.seen),
            corners: [corner(0), corner(1)],
            tilt: space.offset(),
            places: packing.positions().iter().map(|x| space.wrap(x)).collect(),
            speeds: velocities().map(|v| v.norm() as f32).collect(),
            velocities: velocities().map(|v| v.cast()).collect(),
            contacts: rows.iter().map(contact).collect(),
            tangential: rows.iter().map(across).collect(),
        }
    }
}
