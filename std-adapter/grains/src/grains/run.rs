//! A run of grains.

use super::error::GrainsError;
use super::from_scene::packing;
use super::grains_body::{GrainsBody, SlowStepCount, bounds};
use super::initial_grains::start;
use super::layout::Layout;
use super::loads::Loads;
use super::measure::{COLUMNS, PackingState};
use super::outcome::{GrainsStopReason, GrainsSummary};
use super::wall::AxisEnd;
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene};
use crate::packing::{
    ContactStatistics, FrameInfo, Limits, PackingCheckpoint, PackingDriver, origin,
};
use serde_json::Value;
use std::ops::ControlFlow;
use tribos_base::golden::{Measure, Measurement};
use tribos_base::record::frames::{Bodies, Frame, Kind};
use tribos_base::record::{ContactRow, Snapshot};
use tribos_base::run::{Simulation, run_to_end};
use tribos_contacts::cd::StepReport;
use tribos_contacts::problem::GlobalProblem;

/// Grains in a box, a run in progress.
///
/// [`GrainsScene`] has an example.
#[derive(Debug)]
pub struct GrainsSimulation {
    drive: PackingDriver<GrainsBody, { COLUMNS.len() }>,
}

impl GrainsSimulation {
    /// Starts from the scene's placement, in which nothing touches.
    pub fn new(scene: &GrainsScene) -> Result<Self, GrainsError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](GrainsSimulation::checkpoint) of a run of the same scene, with the same bits as
    /// without interruption.
    ///
    /// ```
    /// use tribos::grains::GrainsSimulation;
    /// use tribos::run::Simulation;
    /// # let scene = tribos::scene::GrainsScene { count: 5, ..Default::default() };
    /// let mut whole = GrainsSimulation::new(&scene)?;
    /// whole.step()?;
    /// let kept = whole.checkpoint();
    /// whole.step()?;
    /// let mut broken = GrainsSimulation::resume(&scene, &kept)?;
    /// broken.step()?;
    /// assert_eq!(broken.record(), whole.record());
    /// # Ok::<(), tribos::grains::GrainsError>(())
    /// ```
    pub fn resume(scene: &GrainsScene, checkpoint: &str) -> Result<Self, GrainsError> {
        Self::begin(scene, Some(checkpoint), |_| ControlFlow::Continue(()))
    }

    /// Checks that a run of the scene can start.
    pub fn check(scene: &GrainsScene) -> Result<(), GrainsError> {
        Self::new(scene).map(|_| ())
    }

    /// Starts [anew](Self::new) or [resumes](Self::resume) from a checkpoint; `watch` receives the number of
    /// grains placed so far and can stop the placement.
    pub fn begin(
        scene: &GrainsScene,
        checkpoint: Option<&str>,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, GrainsError> {
        scene.check()?;
        let kept = PackingCheckpoint::read(checkpoint, &scene.json())?;
        let start = start(scene, watch)?;
        let layout = Layout::of(scene, &start)?;
        let loads = Loads::of(scene, &layout);
        let kinds = start.kinds.clone();
        let began_with = origin(&start.positions, &start.radii, &kinds);
        if let Some(kept) = &kept {
            let counts = (start.radii.len(), layout.parts.len());
            kept.fits(counts, &began_with, bounds(scene))?;
        }
        let (contacts, frozen) = (start.contacts.clone(), start.frozen.clone());
        let kept_frozen = kept
            .as_ref()
            .map(|kept: &PackingCheckpoint<GrainsBody, _>| &kept.frozen);
        let frozen = kept_frozen.or(frozen.as_ref());
        let packing = packing(scene, (&layout, &loads), start, frozen)?;
        let body = GrainsBody {
            scene: scene.clone(),
            layout,
            loads,
        };
        let begun = (kinds, began_with);
        let drive =
            PackingDriver::begin((body, SlowStepCount(0)), (packing, contacts), begun, kept)?;
        Ok(Self { drive })
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        self.drive.checkpoint()
    }

    /// The current state as a file, from which a run of another scene can start: `initial_state` names the file or its
    /// folder.
    pub fn state(&self) -> String {
        self.drive.state()
    }

    /// The scene of the run.
    pub fn scene(&self) -> &GrainsScene {
        &self.drive.body.scene
    }

    /// Report of the last step.
    pub fn last_step(&self) -> &StepReport {
        &self.drive.seen.report
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.drive.steps()
    }

    /// Elapsed time.
    pub fn time(&self) -> f64 {
        self.drive.time()
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<GrainsStopReason> {
        self.drive.ending
    }

    /// Rows of the series so far, with the columns of [`COLUMNS`].
    pub fn series(&self) -> &[[f64; COLUMNS.len()]] {
        &self.drive.series
    }

    /// Contacts after the last step with their forces.
    pub fn contacts(&self) -> &[ContactRow] {
        &self.drive.seen.contacts
    }

    /// The contact problem of the last step as data, before any impact with restitution.
    ///
    /// Its contacts are pairs of spheres, then spheres at walls; bodies that sleep are not in it. `None` before
    /// the first step (also of a run that goes on), without contacts, with springs in place of rigid contacts, and
    /// where sliding and torsion share a limit surface that is no ellipsoid.
    pub fn problem(&self) -> Option<GlobalProblem> {
        self.drive.problem()
    }

    /// The current state for measurements.
    pub(super) fn now(&self) -> PackingState<'_> {
        self.drive.body.now(&self.drive.seen)
    }

    /// Low and high corner of the box: its walls, and the highest grain below an open top. All centres are inside.
    fn corners(&self) -> [[f64; 2]; 3] {
        let PackingState {
            layout,
            packing,
            scene,
            ..
        } = self.now();
        let mut corners = layout.extents(packing.walls());
        if scene.is_flat() {
            let most = packing.radii().iter().copied().fold(0.0, f64::max);
            corners[1] = [-most, most];
        }
        // Grains that press a wall reach beyond it by their overlap, and the box ends at the wall.
        let is_open = scene.boundary_z == EndBoundary::Floor && scene.container != Container::Drum;
        for (x, radius) in packing.positions().iter().zip(packing.radii()) {
            let x = layout.space.wrap(x);
            for (axis, [low, high]) in corners.iter_mut().enumerate() {
                if layout.space.lengths()[axis].is_none() {
                    let above = if is_open && axis == 2 { *radius } else { 0.0 };
                    *low = low.min(x[axis]);
                    *high = high.max(x[axis] + above);
                }
            }
        }
        corners
    }

    /// Calls `export` with the current state.
    pub fn with_snapshot<T>(&self, export: impl FnOnce(&Snapshot<'_>) -> T) -> T {
        self.drive.with_snapshot(self.corners(), export)
    }

    /// Data common to all frames of the film, which keeps at most `limit` of them.
    pub fn bodies(&self, limit: u64) -> Bodies {
        let sides = [self.scene().width, self.scene().box_depth()];
        self.drive.bodies(Kind::Grains, sides, limit)
    }

    /// The current state.
    pub fn frame(&self) -> Frame {
        let extents = self.now().extents();
        let lengths = extents.map(|[low, high]| high - low);
        self.drive.frame(&FrameInfo {
            limits: &Limits::of(&self.scene().material()),
            height: lengths[2],
            measure: 1.0 - self.now().solid_fraction(lengths),
            extents: self.corners(),
        })
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> GrainsSummary {
        let now = self.now();
        let radii = now.packing.radii();
        let limits = Limits::of(&self.scene().material());
        let spheres = now.packing.spheres().iter();
        let totals = self.drive.totals();
        GrainsSummary {
            ending: self.ending(),
            time: self.time(),
            steps: self.steps(),
            grains: radii.len(),
            mass: spheres.map(|grain| 1.0 / grain.inv_mass).sum(),
            floor_force: now.push(Axis::Z, AxisEnd::Low),
            surface_angles: now.surface_angles(),
            last: self.record(),
            statistics: ContactStatistics::of(self.contacts(), radii, &limits)
                .of_materials(self.drive.kinds.mixed().is_some())
                .since(totals.overlap),
            iterations: totals.iterations,
            unmet: totals.unmet,
            handed_over: totals.handed_over,
            energy: *now.packing.energy(),
            wall_seconds: totals.wall_seconds,
        }
    }

    /// The end of the run for golden files.
    pub(super) fn measurement(&self, summary: &Value) -> Measurement {
        self.drive.measurement(summary)
    }
}

impl Simulation for GrainsSimulation {
    type Record = [f64; COLUMNS.len()];
    type Error = GrainsError;

    fn record(&self) -> Self::Record {
        self.drive.line()
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, GrainsError> {
        self.drive.step()
    }

    fn progress(&self) -> f64 {
        self.drive.progress()
    }
}

impl Measure for GrainsScene {
    type Error = GrainsError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, GrainsError> {
        let mut grains = GrainsSimulation::new(self)?;
        run_to_end::<GrainsSimulation>(&mut grains, |_, _| watch())
            .map_err(|error: GrainsError| GrainsError::from(error))?;
        Ok(grains.measurement(&grains.outcome().json(self)))
    }
}
