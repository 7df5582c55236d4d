//! A run of grains.

use super::checkpoint::Checkpoint;
use super::error::GrainsError;
use super::layout::Layout;
use super::loads::Loads;
use super::measure::{COLUMNS, Line, Now, RESIDUAL};
use super::parts::packing;
use super::placement::start;
use crate::cd::StepReport;
use crate::packing::{Packing, Totals};
use crate::record::{ContactRow, Snapshot};
use crate::run::Simulation;
use crate::scene::GrainsScene;
use std::ops::ControlFlow;
use std::time::Instant;

/// Slow steps after which the grains count as at rest.
const SLOW_STEPS: u64 = 100;

/// Why a run ended.
///
/// ```
/// use tribos::grains::{Ending, Grains};
/// use tribos::run::drive;
/// # use tribos::scene::GrainsScene;
/// let scene = GrainsScene { count: 5, rest: Some(1e-3), duration: 10.0, ..Default::default() };
/// let mut beads = Grains::new(&scene)?;
/// assert_eq!(beads.ending(), None);
/// drive(&mut beads, |_, _| ())?;
/// assert_eq!(beads.ending(), Some(Ending::Rest)); // they fall and stay where they are
/// assert_eq!(Ending::Rest.name(), "rest");
/// # Ok::<(), tribos::grains::GrainsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The grains are at rest.
    Rest,
    /// The scene's duration elapsed.
    Time,
    /// The scene's number of steps was reached.
    Steps,
}

impl Ending {
    /// Name in summaries and checkpoints.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rest => "rest",
            Self::Time => "time",
            Self::Steps => "steps",
        }
    }

    pub(super) fn named(name: &str) -> Option<Self> {
        let mut all = [Self::Rest, Self::Time, Self::Steps].into_iter();
        all.find(|ending| ending.name() == name)
    }
}

/// Grains in a box, a run in progress.
///
/// [`GrainsScene`] has an example.
#[derive(Debug)]
pub struct Grains {
    scene: GrainsScene,
    layout: Layout,
    loads: Loads,
    packing: Box<dyn Packing>,
    contacts: Vec<ContactRow>,
    report: StepReport,
    totals: Totals,
    /// Number of steps for which the grains have been slow.
    slow: u64,
    series: Vec<Line>,
    ending: Option<Ending>,
    started: Instant,
}

impl Grains {
    /// Starts from the scene's placement, in which nothing touches.
    pub fn new(scene: &GrainsScene) -> Result<Self, GrainsError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](Grains::checkpoint) of a run of the same scene, with the same bits as
    /// without interruption.
    ///
    /// ```
    /// use tribos::grains::Grains;
    /// use tribos::run::Simulation;
    /// # let scene = tribos::scene::GrainsScene { count: 5, ..Default::default() };
    /// let mut whole = Grains::new(&scene)?;
    /// whole.step()?;
    /// let kept = whole.checkpoint();
    /// whole.step()?;
    /// let mut broken = Grains::resume(&scene, &kept)?;
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
        let kept = checkpoint.map(|text| Checkpoint::read(text, scene));
        let kept = kept.transpose()?;
        let start = start(scene, watch)?;
        let layout = Layout::of(scene, &start)?;
        let loads = Loads::of(scene, &layout);
        if let Some(kept) = &kept {
            kept.fits([start.radii.len(), layout.parts.len()], scene.samples)?;
        }
        let frozen = kept.as_ref().map(|kept| &kept.frozen);
        let packing = packing(scene, (&layout, &loads), start, frozen)?;
        let mut grains = Self {
            scene: scene.clone(),
            layout,
            loads,
            packing,
            contacts: Vec::new(),
            report: StepReport::default(),
            totals: Totals::default(),
            slow: 0,
            series: Vec::new(),
            ending: None,
            started: Instant::now(),
        };
        match kept {
            Some(kept) => grains.restore(kept)?,
            None => grains.series.push(grains.record()),
        }
        Ok(grains)
    }

    /// Takes over what a checkpoint has beside the packing.
    fn restore(&mut self, kept: Checkpoint) -> Result<(), GrainsError> {
        self.totals = kept.totals;
        self.slow = kept.slow;
        self.series = kept.series;
        self.ending = kept.ending;
        self.find_contacts()?;
        if let (Some(_), Some(last)) = (self.ending, self.series.last()) {
            self.report.residual.relative = last[RESIDUAL];
        }
        Ok(())
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        let checkpoint = Checkpoint {
            frozen: self.packing.freeze(),
            totals: Totals {
                wall_seconds: self.wall_seconds(),
                ..self.totals
            },
            slow: self.slow,
            series: self.series.clone(),
            ending: self.ending,
        };
        checkpoint.text(&self.scene)
    }

    /// The scene of the run.
    pub fn scene(&self) -> &GrainsScene {
        &self.scene
    }

    /// Report of the last step.
    pub fn last_step(&self) -> &StepReport {
        &self.report
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.packing.clock().1
    }

    /// Elapsed time.
    pub fn time(&self) -> f64 {
        self.packing.clock().0
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// Rows of the series so far, with the columns of [`COLUMNS`].
    pub fn series(&self) -> &[[f64; COLUMNS.len()]] {
        &self.series
    }

    /// Contacts after the last step with their forces.
    pub fn contacts(&self) -> &[ContactRow] {
        &self.contacts
    }

    /// The current state for measurements.
    pub(super) fn now(&self) -> Now<'_> {
        Now {
            scene: &self.scene,
            layout: &self.layout,
            loads: &self.loads,
            packing: &*self.packing,
            contacts: &self.contacts,
            report: &self.report,
        }
    }

    pub(super) fn totals(&self) -> &Totals {
        &self.totals
    }

    /// Low and high corner of a box that holds the grains, open ends included.
    pub(super) fn corners(&self) -> [[f64; 2]; 3] {
        let mut corners = self.layout.extents(self.packing.walls());
        if self.scene.is_flat() {
            let most = self.packing.radii().iter().copied().fold(0.0, f64::max);
            corners[1] = [-most, most];
        }
        for (x, radius) in self.packing.positions().iter().zip(self.packing.radii()) {
            let x = self.layout.space.wrap(x);
            for (axis, [low, high]) in corners.iter_mut().enumerate() {
                if self.layout.space.lengths()[axis].is_none() {
                    *low = low.min(x[axis] - radius);
                    *high = high.max(x[axis] + radius);
                }
            }
        }
        corners
    }

    /// Calls `export` with the current state.
    pub fn with_snapshot<T>(&self, export: impl FnOnce(&Snapshot<'_>) -> T) -> T {
        let spheres = self.packing.spheres();
        let velocities: Vec<_> = spheres.iter().map(|sphere| sphere.velocity).collect();
        let spins: Vec<_> = spheres.iter().map(|sphere| sphere.spin).collect();
        export(&Snapshot {
            time: self.time(),
            space: self.packing.space(),
            extents: self.corners(),
            positions: self.packing.positions(),
            radii: self.packing.radii(),
            velocities: Some(&velocities),
            spins: Some(&spins),
            species: None,
            contacts: &self.contacts,
        })
    }

    pub(super) fn wall_seconds(&self) -> f64 {
        self.totals.wall_seconds + self.started.elapsed().as_secs_f64()
    }

    fn find_contacts(&mut self) -> Result<(), GrainsError> {
        let step = self.steps();
        let contacts = self.packing.contacts();
        self.contacts = contacts.map_err(|cause| GrainsError::Touch { step, cause })?;
        Ok(())
    }

    /// The current line of the series, if all its values and the energy balance are finite.
    fn finite_record(&self) -> Result<Line, GrainsError> {
        let record = self.record();
        let named = COLUMNS.into_iter().zip(record);
        let balance = [("work", self.packing.energy().imbalance())];
        match named.chain(balance).find(|(_, value)| !value.is_finite()) {
            Some((column, value)) => Err(GrainsError::NotFinite {
                step: self.steps(),
                column,
                value,
            }),
            None => Ok(record),
        }
    }

    /// Counts slow steps and applies the scene's limits.
    fn judge(&mut self) -> Option<Ending> {
        let (time, steps) = self.packing.clock();
        let is_slow = self
            .scene
            .rest
            .is_some_and(|rest| self.now().speed() < rest);
        self.slow = if is_slow { self.slow + 1 } else { 0 };
        if self.slow >= SLOW_STEPS {
            Some(Ending::Rest)
        } else if time >= self.scene.duration {
            Some(Ending::Time)
        } else {
            (steps >= self.scene.steps).then_some(Ending::Steps)
        }
    }
}

impl Simulation for Grains {
    type Record = [f64; COLUMNS.len()];
    type Error = GrainsError;

    fn record(&self) -> Self::Record {
        self.now().line()
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, GrainsError> {
        if self.ending.is_some() {
            return Ok(false);
        }
        self.loads.apply(&self.layout, &mut *self.packing);
        self.report = self.packing.step()?;
        self.totals.add(&self.report);
        self.ending = self.judge();
        if self.ending.is_some() || self.steps().is_multiple_of(self.scene.samples) {
            self.find_contacts()?;
            let record = self.finite_record()?;
            self.series.push(record);
        }
        Ok(self.ending.is_none())
    }

    fn progress(&self) -> f64 {
        let (time, steps) = self.packing.clock();
        let of_time = time / self.scene.duration;
        of_time.max(steps as f64 / self.scene.steps as f64).min(1.0)
    }
}
