//! Compaction of a deposit by a piston until it is blocked (thesis, sections 4.5 and 4.6).

use super::blocked::{Means, Window};
use super::checkpoint::Checkpoint;
use super::deposit::{BULK, Deposit, DepositError, volume_between};
use super::error::CompactionError;
use super::outcome::Outcome;
use super::parts::{PISTON, packing};
use super::start::Start;
use crate::cd::StepReport;
use crate::packing::{Limits, Packing, Shape, Statistics, Stored, Stress, Totals, branch, is_at};
use crate::record::{ContactRow, Snapshot};
use crate::run::Simulation;
use crate::scene::PowderScene;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Instant;
use tribos_core::contact::Sphere;

/// Columns of the series, in the units of the scene; `stress_zz` in units of the applied pressure.
pub const COLUMNS: [&str; 15] = [
    "time",
    "step",
    "piston_height",
    "porosity",
    "contacts",
    "stress_zz",
    "sweeps",
    "residual",
    "kinetic",
    "dissipated_normal",
    "dissipated_sliding",
    "dissipated_rolling",
    "dissipated_torsion",
    "dissipated_cohesion",
    "work",
];

/// Index of the residual among the columns.
const RESIDUAL: usize = 7;

/// Why a run ended.
///
/// ```
/// use tribos::powder::{Compaction, Ending};
/// use tribos::run::drive;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene {
/// #     width: 6.0,
/// #     height: 8.0,
/// #     pressure: 0.02,
/// #     steps: 10,
/// #     ..PowderScene::default()
/// # };
/// // A scene of ten steps: too few to be blocked.
/// let mut compaction = Compaction::new(&scene)?;
/// assert_eq!(compaction.ending(), None);
/// drive(&mut compaction, |_, _| ())?;
/// assert_eq!((compaction.ending(), compaction.steps()), (Some(Ending::Steps), 10));
/// assert_eq!(Ending::Steps.name(), "steps");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The packing is blocked.
    Blocked,
    /// The scene's duration elapsed.
    Time,
    /// The scene's number of steps was reached.
    Steps,
}

impl Ending {
    /// Name in summaries and checkpoints.
    pub fn name(self) -> &'static str {
        match self {
            Self::Blocked => "blocked",
            Self::Time => "time",
            Self::Steps => "steps",
        }
    }

    pub(super) fn named(name: &str) -> Option<Self> {
        let mut all = [Self::Blocked, Self::Time, Self::Steps].into_iter();
        all.find(|ending| ending.name() == name)
    }
}

/// A compaction in progress.
///
/// ```
/// use tribos::powder::{COLUMNS, Compaction};
/// use tribos::run::drive;
/// use tribos::scene::PowderScene;
/// let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// let mut compaction = Compaction::new(&scene)?;
/// drive(&mut compaction, |_, _| ())?;
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
pub struct Compaction {
    scene: PowderScene,
    deposit: Deposit,
    /// Contacts at the start.
    first_contacts: Vec<ContactRow>,
    packing: Box<dyn Packing>,
    /// Total volume of the spheres.
    solid: f64,
    contacts: Vec<ContactRow>,
    stress: Stress,
    report: StepReport,
    window: Window,
    complete: Option<(Window, f64)>,
    totals: Totals,
    series: Vec<[f64; COLUMNS.len()]>,
    ending: Option<Ending>,
    started: Instant,
}

impl Compaction {
    /// Starts from the scene's deposit, with the piston touching its highest sphere.
    pub fn new(scene: &PowderScene) -> Result<Self, CompactionError> {
        Self::begin(scene, None, |_| ControlFlow::Continue(()))
    }

    /// Continues from a [checkpoint](Compaction::checkpoint) of a run of the same scene, with the same
    /// bits as without interruption. A run that had ended remains ended and takes no more steps.
    ///
    /// ```
    /// use tribos::powder::Compaction;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let mut whole = Compaction::new(&scene)?;
    /// for _ in 0..5 {
    ///     whole.step()?;
    /// }
    /// let kept = whole.checkpoint();
    /// whole.step()?;
    ///
    /// let mut broken = Compaction::resume(&scene, &kept)?;
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
    /// use tribos::powder::{Compaction, CompactionError, deposit::DepositError};
    /// # use tribos::scene::PowderScene;
    /// # let flat = PowderScene {
    /// #     width: 6.0,
    /// #     height: 1.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// // A deposit that is cut at a height of half a sphere.
    /// let refused = Compaction::check(&flat);
    /// assert!(matches!(refused, Err(CompactionError::Deposit(DepositError::Empty))));
    /// ```
    pub fn check(scene: &PowderScene) -> Result<(), CompactionError> {
        let diameter = 2.0 * scene.least_radius();
        if scene.start.is_none() && scene.count.is_none() && scene.height < diameter {
            return Err(DepositError::Empty.into());
        }
        if scene.start.is_some() {
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
    /// use tribos::powder::{Compaction, CompactionError, deposit::DepositError};
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let stopped = Compaction::begin(&scene, None, |_spheres| ControlFlow::Break(()));
    /// assert!(matches!(stopped, Err(CompactionError::Deposit(DepositError::Stopped))));
    /// ```
    pub fn begin(
        scene: &PowderScene,
        checkpoint: Option<&str>,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, CompactionError> {
        scene.check()?;
        let kept = checkpoint.map(|text| Checkpoint::read(text, scene));
        let kept = kept.transpose()?;
        let Start {
            deposit,
            contacts,
            frozen,
        } = Start::of(scene, watch)?;
        if let Some(kept) = &kept {
            kept.fits(deposit.positions.len(), scene.samples.max(1))?;
        }
        let frozen = kept.as_ref().map(|kept| &kept.frozen).or(frozen.as_ref());
        let packing = packing(scene, &deposit, frozen)?;
        let solid = deposit
            .radii
            .iter()
            .map(|r| 4.0 / 3.0 * PI * r * r * r)
            .sum();
        let mut compaction = Self {
            scene: scene.clone(),
            window: Window::starting(deposit.height),
            contacts: contacts.clone(),
            first_contacts: contacts,
            deposit,
            packing,
            solid,
            stress: Stress::default(),
            report: StepReport::default(),
            complete: None,
            totals: Totals::default(),
            series: Vec::new(),
            ending: None,
            started: Instant::now(),
        };
        match kept {
            Some(kept) => {
                compaction.window = kept.window;
                compaction.complete = kept.complete;
                compaction.totals = kept.totals;
                compaction.series = kept.series;
                compaction.ending = kept.ending;
                compaction.look_again()?;
            }
            None => compaction.series.push(compaction.record()),
        }
        Ok(compaction)
    }

    /// The run as a checkpoint file.
    pub fn checkpoint(&self) -> String {
        let checkpoint = Checkpoint {
            frozen: self.packing.freeze(),
            window: self.window,
            complete: self.complete,
            totals: Totals {
                wall_seconds: self.wall_seconds(),
                ..self.totals
            },
            series: self.series.clone(),
            ending: self.ending,
        };
        checkpoint.text(&self.scene, &self.shape())
    }

    /// The current state as a file, from which a run of another scene can start: `start` names the file or its
    /// folder.
    ///
    /// ```
    /// use tribos::powder::Compaction;
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// let mut light = Compaction::new(&scene)?;
    /// for _ in 0..20 {
    ///     light.step()?;
    /// }
    /// # let home = tempfile::tempdir()?;
    /// # let file = home.path().join("state.json");
    /// std::fs::write(&file, light.state())?;
    /// let heavy = PowderScene { pressure: 0.04, start: Some(file), ..scene };
    /// let heavy = Compaction::new(&heavy)?;
    /// assert_eq!((heavy.steps(), heavy.height()), (0, light.height()));
    /// assert_eq!(heavy.contacts(), light.contacts());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn state(&self) -> String {
        let stored = Stored {
            scene: self.scene.json(),
            shape: self.shape(),
            frozen: self.packing.freeze(),
        };
        stored.text()
    }

    fn shape(&self) -> Shape {
        Shape {
            space: self.deposit.space,
            radii: self.packing.radii().to_vec(),
            outward: self
                .packing
                .walls()
                .iter()
                .map(|wall| wall.outward)
                .collect(),
            contacts: self.contacts.clone(),
        }
    }

    /// The scene of the run.
    pub(super) fn scene(&self) -> &PowderScene {
        &self.scene
    }

    /// Current height of the piston.
    pub fn height(&self) -> f64 {
        // Its normal points down.
        -self.packing.walls()[PISTON as usize].place
    }

    /// Porosity: free share of the volume below the piston (thesis, eq. 4.5).
    pub fn porosity(&self) -> f64 {
        1.0 - self.solid / (self.area() * self.height())
    }

    /// Report of the last step.
    pub fn last_step(&self) -> &StepReport {
        &self.report
    }

    /// Number of steps so far.
    pub fn steps(&self) -> u64 {
        self.packing.clock().1
    }

    /// Why the run has ended, if it has.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// Rows of the series so far, with the columns of [`COLUMNS`].
    pub fn series(&self) -> &[[f64; COLUMNS.len()]] {
        &self.series
    }

    /// The deposit, or the other spheres, from which the run started.
    pub fn deposit(&self) -> &Deposit {
        &self.deposit
    }

    /// Contacts at the start: those of the deposit, or of the state from which the run started.
    #[doc(hidden)]
    pub fn first_contacts(&self) -> &[ContactRow] {
        &self.first_contacts
    }

    /// Contacts after the last step with their forces; before the first step, the contacts of the deposit.
    pub fn contacts(&self) -> &[ContactRow] {
        &self.contacts
    }

    /// Calls `export` with the current state.
    ///
    /// ```
    /// use tribos::powder::Compaction;
    /// use tribos::record::extended_xyz;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
    /// let compaction = Compaction::new(&scene)?;
    /// let frame = compaction.with_snapshot(extended_xyz)?;
    /// // A line a sphere, and two before them.
    /// assert_eq!(frame.lines().count(), compaction.deposit().positions.len() + 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_snapshot<T>(&self, export: impl FnOnce(&Snapshot<'_>) -> T) -> T {
        let spheres = self.packing.spheres();
        let velocities: Vec<_> = spheres.iter().map(|sphere| sphere.velocity).collect();
        let spins: Vec<_> = spheres.iter().map(|sphere| sphere.spin).collect();
        let side = [0.0, self.scene.width];
        export(&Snapshot {
            time: self.packing.clock().0,
            space: self.deposit.space,
            extents: [side, side, [0.0, self.height()]],
            positions: self.packing.positions(),
            radii: self.packing.radii(),
            velocities: Some(&velocities),
            spins: Some(&spins),
            species: None,
            contacts: &self.contacts,
        })
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> Outcome {
        let height = self.height();
        let [low, high] = BULK.map(|share| share * height);
        let (positions, radii) = (self.packing.positions(), self.packing.radii());
        let bulk = volume_between(positions, radii, [low, high]);
        let scene = &self.scene;
        Outcome {
            ending: self.ending,
            time: self.packing.clock().0,
            steps: self.steps(),
            particles: radii.len(),
            heights: [self.deposit.height, height],
            porosity: [self.deposit.porosity(), self.porosity()],
            bulk_porosity: 1.0 - bulk / (self.area() * (high - low)),
            means: self.means(),
            pressure: scene.pressure,
            area: self.area(),
            statistics: Statistics::of(&self.contacts, radii, &Limits::of(&scene.material())),
            residual: self.report.residual.relative,
            iterations: self.totals.iterations,
            unmet: self.totals.unmet,
            solver_unmet: self.totals.solver_unmet,
            impacts_cut: self.totals.cut,
            impacts_unmet: self.totals.impacts_unmet,
            energy: *self.packing.energy(),
            wall_seconds: self.wall_seconds(),
        }
    }

    /// Means over the last complete window, or over the incomplete first one.
    fn means(&self) -> Means {
        match &self.complete {
            Some((window, height)) => window.means(*height),
            None => self.window.means(self.height()),
        }
    }

    fn area(&self) -> f64 {
        self.scene.width * self.scene.width
    }

    /// Mean σ_zz that bears the spheres' own weight: ∫ρgz dV over the volume.
    fn weight_stress(&self) -> f64 {
        let spheres = self.packing.spheres().iter();
        let lifted = spheres.zip(self.packing.positions());
        let moment: f64 = lifted.map(|(sphere, at)| at.z / sphere.inv_mass).sum();
        self.scene.gravity * moment / (self.area() * self.height())
    }

    fn wall_seconds(&self) -> f64 {
        self.totals.wall_seconds + self.started.elapsed().as_secs_f64()
    }

    /// Residual of the last step, computed from the stored forces; the last row of a run contains it.
    fn look_again(&mut self) -> Result<(), CompactionError> {
        let step = self.steps();
        if step > 0 {
            let contacts = self.packing.contacts();
            self.contacts = contacts.map_err(|cause| CompactionError::Touch { step, cause })?;
        }
        if let (Some(_), Some(last)) = (self.ending, self.series.last()) {
            self.report.residual.relative = last[RESIDUAL];
        }
        Ok(())
    }

    /// The current row of the series, if all its values and the energy balance are finite.
    fn finite_record(&self) -> Result<[f64; COLUMNS.len()], CompactionError> {
        let record = self.record();
        let named = COLUMNS.into_iter().zip(record);
        let balance = [("work", self.packing.energy().imbalance())];
        match named.chain(balance).find(|(_, value)| !value.is_finite()) {
            Some((column, value)) => Err(CompactionError::NotFinite {
                step: self.steps(),
                column,
                value,
            }),
            None => Ok(record),
        }
    }

    /// Updates contacts and stress after a step, and adds both to the window.
    fn measure(&mut self, before: &[Sphere<f64>]) -> Result<(), CompactionError> {
        let step = self.steps();
        let contacts = self.packing.contacts();
        self.contacts = contacts.map_err(|cause| CompactionError::Touch { step, cause })?;
        let radii = self.packing.radii();
        let volume = self.area() * self.height();
        self.stress = Stress::of(&self.contacts, |contact| branch(contact, radii), volume);
        let dt = self.report.dt;

        // Force on the piston, mean net force on a sphere, mean normal force of a contact.
        let at_piston = self.contacts.iter().filter(|row| is_at(row, PISTON));
        let piston = at_piston.map(|row| row.force.z).sum();
        let net: f64 = before
            .iter()
            .zip(self.packing.spheres())
            .map(|(old, new)| (new.velocity - old.velocity).norm() / (new.inv_mass * dt))
            .sum();
        let normal: f64 = self
            .contacts
            .iter()
            .map(|row| row.normal_force().abs())
            .sum();
        let forces = [
            piston,
            net / radii.len() as f64,
            normal / self.contacts.len().max(1) as f64,
        ];
        self.window.add(dt, &self.stress, forces);
        Ok(())
    }

    /// Closes a full window and applies the criterion; otherwise checks the scene's limits.
    fn judge(&mut self) -> Option<Ending> {
        let scene = &self.scene;
        let height = self.height();
        let mut blocked = false;
        if self.window.is_full(scene.piston_mass, scene.load()) {
            let means = self.window.means(height).less(self.weight_stress());
            blocked = means.is_blocked(scene.blocked, scene.pressure, self.area());
            self.complete = Some((self.window, height));
            self.window = Window::starting(height);
        }
        let (time, steps) = self.packing.clock();
        if blocked {
            Some(Ending::Blocked)
        } else if scene.duration.is_some_and(|end| time >= end) {
            Some(Ending::Time)
        } else {
            (steps >= scene.steps).then_some(Ending::Steps)
        }
    }
}

impl Simulation for Compaction {
    type Record = [f64; COLUMNS.len()];
    type Error = CompactionError;

    fn record(&self) -> Self::Record {
        let (time, step) = self.packing.clock();
        let energy = self.packing.energy();
        [
            time,
            step as f64,
            self.height(),
            self.porosity(),
            self.contacts.len() as f64,
            self.stress.total().m33 / self.scene.pressure,
            self.report.iterations.sweeps as f64,
            self.report.residual.relative,
            energy.kinetic,
            energy.normal,
            energy.sliding,
            energy.rolling,
            energy.torsion,
            energy.cohesion,
            energy.work,
        ]
    }

    /// A run that has ended takes no more steps.
    fn step(&mut self) -> Result<bool, CompactionError> {
        if self.ending.is_some() {
            return Ok(false);
        }
        let before = self.packing.spheres().to_vec();
        self.report = self.packing.step()?;
        self.totals.add(&self.report);
        self.measure(&before)?;
        let record = self.finite_record()?;
        self.ending = self.judge();
        if self.ending.is_some() || self.steps().is_multiple_of(self.scene.samples) {
            self.series.push(record);
        }
        Ok(self.ending.is_none())
    }

    fn progress(&self) -> f64 {
        let (time, steps) = self.packing.clock();
        let of_time = self.scene.duration.map_or(0.0, |end| time / end);
        of_time.max(steps as f64 / self.scene.steps as f64).min(1.0)
    }
}
