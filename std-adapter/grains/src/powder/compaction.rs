//! Compaction of a deposit by a piston until it is blocked (thesis, sections 4.5 and 4.6).

use super::deposit::{BULK, Deposit, DepositError};
use super::error::CompactionError;
use super::outcome::{COLUMNS, PowderStopReason, PowderSummary};
use super::parts::packing;
use super::press::{PowderBody, PressMonitor, bounds, height};
use super::start::Start;
use crate::packing::volume_between;
use crate::packing::{
    ContactStatistics, FrameInfo, Limits, PackingCheckpoint, PackingDriver, origin,
};
use crate::powder::scene::PowderScene;
use std::ops::ControlFlow;
use tribos_base::golden::{Measure, Measurement};
use tribos_base::record::frames::{Bodies, Frame, Kind};
use tribos_base::record::{ContactRow, Snapshot};
use tribos_base::run::{Simulation, run_to_end};
use tribos_contacts::cd::StepReport;
use tribos_contacts::problem::GlobalProblem;

/// A compaction in progress.
///
/// ```
/// use tribos::powder::{COLUMNS, PowderSimulation};
/// use tribos::run::run_to_end;
/// use tribos::scene::PowderScene;
/// let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let mut compaction = PowderSimulation::new(&scene)?;
/// run_to_end(&mut compaction, |_, _| ())?;
/// let outcome = compaction.outcome();
/// assert!(outcome.porosity[1] < outcome.porosity[0]);
/// // Spheres keep their volume: the solid share grows as the height shrinks.
/// let solid = |porosity: f64, height: f64| (1.0 - porosity) * height;
/// let before = solid(outcome.porosity[0], compaction.deposit().height);
/// assert!((solid(compaction.porosity(), compaction.height()) / before - 1.0).abs() < 1e-12);
/// // The last line of the series is the end.
/// let column = COLUMNS.iter().position(|name| *name == "porosity");
/// let last = compaction.series().last().zip(column).map(|(line, column)| line[column]);
/// assert_eq!(last, Some(outcome.porosity[1]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct PowderSimulation {
    pub(super) drive: PackingDriver<PowderBody, { COLUMNS.len() }>,
    /// Contacts at the start.
    first_contacts: Vec<ContactRow>,
}

impl PowderSimulation {
    /// Starts from the scene's deposit, with the piston touching its highest sphere.
    pub fn new(scene: &PowderScene) -> Result<Self, CompactionError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](PowderSimulation::checkpoint) of a run of the same scene, with the same
    /// bits as without interruption. A run that had ended remains ended and takes no more steps.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let mut whole = PowderSimulation::new(&scene)?;
    /// for _ in 0..5 {
    ///     whole.step()?;
    /// }
    /// let kept = whole.checkpoint();
    /// whole.step()?;
    ///
    /// let mut broken = PowderSimulation::resume(&scene, &kept)?;
    /// assert_eq!(broken.steps(), 5);
    /// broken.step()?;
    /// assert_eq!(broken.last_step(), whole.last_step());
    /// assert_eq!(broken.contacts(), whole.contacts()); // forces to the bit
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn resume(scene: &PowderScene, checkpoint: &str) -> Result<Self, CompactionError> {
        Self::begin(scene, Some(checkpoint), |_| ControlFlow::Continue(()))
    }

    /// Checks that a run of the scene can start, without growing its deposit: two spheres of it are enough.
    ///
    /// ```
    /// use tribos::powder::{PowderSimulation, CompactionError, deposit::DepositError};
    /// # use tribos::scene::PowderScene;
    /// # let flat = PowderScene {
    /// #     width: 6.0,
    /// #     height: 1.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// // A deposit that is cut at a height of half a sphere.
    /// let refused = PowderSimulation::check(&flat);
    /// assert!(matches!(refused, Err(CompactionError::Placement(DepositError::Empty))));
    /// ```
    pub fn check(scene: &PowderScene) -> Result<(), CompactionError> {
        let diameter = 2.0 * scene.least_radius();
        if scene.initial_state.is_none() && scene.count.is_none() && scene.height < diameter {
            return Err(DepositError::Empty.into());
        }
        if scene.initial_state.is_some() {
            return Self::new(scene).map(|_| ());
        }
        let two = PowderScene {
            count: Some(2),
            ..scene.clone()
        };
        Self::new(&two).map(|_| ())
    }

    /// Starts [anew](Self::new) or [resumes](Self::resume) from a checkpoint; `watch` receives the number of
    /// spheres deposited so far and can stop the growth.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use tribos::powder::{PowderSimulation, CompactionError, deposit::DepositError};
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let stopped = PowderSimulation::begin(&scene, None, |_spheres| ControlFlow::Break(()));
    /// assert!(matches!(stopped, Err(CompactionError::Placement(DepositError::Stopped))));
    /// ```
    pub fn begin(
        scene: &PowderScene,
        checkpoint: Option<&str>,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, CompactionError> {
        scene.check()?;
        let kept = PackingCheckpoint::read(checkpoint, &scene.json())?;
        let start = Start::of(scene, watch)?;
        let (deposit, kinds) = (start.deposit, start.kinds);
        let began_with = origin(&deposit.positions, &deposit.radii, &kinds);
        if let Some(kept) = &kept {
            kept.fits((deposit.positions.len(), 2), &began_with, bounds(scene))?;
        }
        let frozen = kept
            .as_ref()
            .map(|kept: &PackingCheckpoint<PowderBody, _>| &kept.frozen);
        let begun = (&deposit, &kinds);
        let packing = packing(scene, begun, frozen.or(start.frozen.as_ref()))?;
        let watch = PressMonitor::starting(deposit.height);
        let body = PowderBody::new(scene, deposit);
        let first_contacts = start.contacts;
        let drive = PackingDriver::begin(
            (body, watch),
            (packing, first_contacts.clone()),
            (kinds, began_with),
            kept,
        )?;
        Ok(Self {
            drive,
            first_contacts,
        })
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        self.drive.checkpoint()
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
        self.drive.state()
    }

    /// Current height of the piston.
    pub fn height(&self) -> f64 {
        height(&self.drive.seen)
    }

    /// Porosity: free share of the volume below the piston (thesis, eq. 4.5).
    pub fn porosity(&self) -> f64 {
        self.drive.body.porosity(&self.drive.seen)
    }

    /// Report of the last step.
    pub fn last_step(&self) -> &StepReport {
        &self.drive.seen.report
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.drive.steps()
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<PowderStopReason> {
        self.drive.ending
    }

    /// Rows of the series so far, with the columns of [`COLUMNS`].
    pub fn series(&self) -> &[[f64; COLUMNS.len()]] {
        &self.drive.series
    }

    /// The deposit, or the other spheres, from which the run started.
    pub fn deposit(&self) -> &Deposit {
        &self.drive.body.deposit
    }

    /// Contacts at the start: those of the deposit, or of the state from which the run started.
    #[doc(hidden)]
    pub fn first_contacts(&self) -> &[ContactRow] {
        &self.first_contacts
    }

    /// Contacts after the last step with their forces; before the first step, the contacts of the deposit.
    pub fn contacts(&self) -> &[ContactRow] {
        &self.drive.seen.contacts
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
        self.drive.problem()
    }

    /// Calls `export` with the current state.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// use tribos::record::extended_xyz;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let compaction = PowderSimulation::new(&scene)?;
    /// let frame = compaction.with_snapshot(extended_xyz)?;
    /// // A line a sphere, and two before them.
    /// assert_eq!(frame.lines().count(), compaction.deposit().positions.len() + 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_snapshot<T>(&self, export: impl FnOnce(&Snapshot<'_>) -> T) -> T {
        self.drive.with_snapshot(self.extents(), export)
    }

    /// Low and high coordinates of the box.
    fn extents(&self) -> [[f64; 2]; 3] {
        let side = [0.0, self.drive.body.scene.width];
        [side, side, [0.0, self.height()]]
    }

    /// Data common to all frames of the film, which keeps at most `limit` of them.
    pub fn bodies(&self, limit: u64) -> Bodies {
        let width = self.drive.body.scene.width;
        self.drive.bodies(Kind::Powder, [width; 2], limit)
    }

    /// The current state; before the first step the contacts of the deposit carry no force.
    ///
    /// ```
    /// use tribos::powder::PowderSimulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let compaction = PowderSimulation::new(&scene)?;
    /// let (bodies, first) = (compaction.bodies(100), compaction.frame());
    /// assert_eq!(first.places.len(), bodies.radii.len());
    /// assert_eq!((first.step, first.height), (0, compaction.height()));
    /// assert!(first.speeds.iter().all(|speed| *speed == 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn frame(&self) -> Frame {
        self.drive.frame(&FrameInfo {
            limits: &Limits::of(&self.drive.body.scene.material()),
            height: self.height(),
            measure: self.porosity(),
            extents: self.extents(),
        })
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> PowderSummary {
        let PackingDriver {
            body, seen, watch, ..
        } = &self.drive;
        let (scene, area, height) = (&body.scene, body.area(), self.height());
        let [low, high] = BULK.map(|share| share * height);
        let (positions, radii) = (seen.packing.positions(), seen.packing.radii());
        let bulk = volume_between(positions, radii, [low, high]);
        let totals = self.drive.totals();
        PowderSummary {
            ending: self.drive.ending,
            time: self.drive.time(),
            steps: self.steps(),
            particles: radii.len(),
            heights: [body.deposit.height, height],
            porosity: [body.deposit.porosity(), self.porosity()],
            bulk_porosity: 1.0 - bulk / (area * (high - low)),
            means: body.means(watch, seen),
            pressure: scene.pressure,
            area,
            statistics: ContactStatistics::of(
                &seen.contacts,
                radii,
                &Limits::of(&scene.material()),
            )
            .of_materials(self.drive.kinds.mixed().is_some())
            .since(totals.overlap),
            residual: seen.report.residual.relative,
            iterations: totals.iterations,
            unmet: totals.unmet,
            solver_unmet: totals.solver_unmet,
            handed_over: totals.handed_over,
            impacts_cut: totals.cut,
            impacts_unmet: totals.impacts_unmet,
            energy: *seen.packing.energy(),
            wall_seconds: totals.wall_seconds,
        }
    }
}

impl Simulation for PowderSimulation {
    type Record = [f64; COLUMNS.len()];
    type Error = CompactionError;

    fn record(&self) -> Self::Record {
        self.drive.line()
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, CompactionError> {
        self.drive.step()
    }

    fn progress(&self) -> f64 {
        self.drive.progress()
    }
}

impl Measure for PowderScene {
    type Error = CompactionError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, CompactionError> {
        let mut compaction = PowderSimulation::new(self)?;
        run_to_end(&mut compaction, |_, _| watch())?;
        let summary = compaction.outcome().json(self);
        Ok(compaction.drive.measurement(&summary))
    }
}
