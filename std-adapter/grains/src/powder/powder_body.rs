//! What a piston does to a powder, step by step: its loads, its measures and when it ends.

use super::blocked::{Means, Window};
use super::deposit::{BULK, Deposit, SUBSTRATE};
use super::outcome::{COLUMNS, MeanStress, PistonBalance, PowderLine, PowderSummary};
use super::start::start;
use crate::packing::{
    Bodies, ContactKeys, Dissipation, InitialSpheres, MeasuredState, MeasurementSchedule,
    OptionalFeatures, Packing, PackingBody, PackingEnergy, PackingRun, PackingStopReason,
    RunLimits, Stress, branch, is_at, volume_between,
};
use crate::packing::{PackingRunError, PlacementError};
use crate::powder::scene::PowderScene;
use nalgebra::{Matrix3, Vector3};
use serde_json::{Map, Value};
use std::f64::consts::PI;
use std::ops::ControlFlow;
use tribos_base::golden::{Measure, Measurement};
use tribos_base::record::checkpoint::{damaged, hex, numbers};
use tribos_base::record::frames::Kind;
use tribos_base::record::{CheckpointError, ContactRow};
use tribos_contacts::cd::Wall;
use tribos_core::contact::SphereBody;

/// Numbers of a window in a checkpoint, and of a stress.
const WINDOW: usize = 24;
const TENSORS: usize = 18;

/// Number of the piston among the walls.
///
/// ```
/// use tribos::powder::{PowderSimulation, PISTON};
/// use tribos::record::Partner;
/// use tribos::run::run_to_end;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// // In a packing that is blocked the spheres below the piston bear its load.
/// let mut compaction = PowderSimulation::new(&scene)?;
/// run_to_end(&mut compaction, |_, _| ())?;
/// let below = compaction.contacts().iter().filter(|row| row.b == Partner::Wall(PISTON));
/// let force: f64 = below.map(|row| row.force.z).sum();
/// assert!((force / scene.load() - 1.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const PISTON: u32 = 1;

const _: () = assert!(SUBSTRATE == 0 && PISTON == 1);
/// Number of walls: substrate and piston.
const WALLS: usize = 2;

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
/// assert!(outcome.porosity_final < outcome.porosity_initial);
/// // Spheres keep their volume: the solid share grows as the height shrinks.
/// let solid = |porosity: f64, height: f64| (1.0 - porosity) * height;
/// let before = solid(outcome.porosity_initial, outcome.height_initial);
/// assert!((solid(compaction.porosity(), compaction.height()) / before - 1.0).abs() < 1e-12);
/// // The last line of the series is the end.
/// let column = COLUMNS.iter().position(|name| *name == "porosity");
/// let last = compaction.series().last().zip(column).map(|(line, column)| line[column]);
/// assert_eq!(last, Some(outcome.porosity_final));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type PowderSimulation = PackingRun<PowderBody, { COLUMNS.len() }>;

/// A powder under its piston.
#[derive(Debug)]
pub struct PowderBody {
    scene: PowderScene,
    deposit: Deposit,
    /// Contacts at the start.
    first_contacts: Vec<ContactRow>,
    /// Total volume of the spheres.
    solid: f64,
}

/// What is remembered from step to step.
#[derive(Debug)]
pub struct PressMonitor {
    window: Window,
    /// The last complete window, with the piston's height at its end.
    complete: Option<(Window, f64)>,
    /// Stress after the last step.
    stress: Stress,
    /// Spheres before the last step.
    before: Vec<SphereBody<f64>>,
}

impl PowderBody {
    fn area(&self) -> f64 {
        self.scene.width * self.scene.width
    }

    /// Means over the last complete window, or over the incomplete first one.
    fn means(&self, watch: &PressMonitor, seen: &MeasuredState) -> Means {
        match &watch.complete {
            Some((window, height)) => window.means(*height),
            None => watch.window.means(height(seen)),
        }
    }

    /// Mean σ_zz that bears the spheres' own weight: ∫ρgz dV over the volume.
    fn weight_stress(&self, seen: &MeasuredState) -> f64 {
        let spheres = seen.packing.spheres().iter();
        let lifted = spheres.zip(seen.packing.positions());
        let moment: f64 = lifted.map(|(sphere, at)| at.z / sphere.inv_mass).sum();
        self.scene.gravity * moment / (self.area() * height(seen))
    }
}

/// Current height of the piston.
fn height(seen: &MeasuredState) -> f64 {
    // Its normal points down.
    -seen.packing.walls()[PISTON as usize].place
}

impl PressMonitor {
    /// Force on the piston, mean net force on a sphere, mean normal force of a contact.
    fn forces(&self, seen: &MeasuredState) -> [f64; 3] {
        let at_piston = seen.contacts.iter().filter(|row| is_at(row, PISTON));
        let piston = at_piston.map(|row| row.force.z).sum();
        let dt = seen.report.dt;
        let spheres = self.before.iter().zip(seen.packing.spheres());
        let net = |(old, new): (&SphereBody<f64>, &SphereBody<f64>)| {
            (new.velocity - old.velocity).norm() / (new.inv_mass * dt)
        };
        let net: f64 = spheres.map(net).sum();
        let normal = seen.contacts.iter().map(|row| row.normal_force().abs());
        let normal: f64 = normal.sum();
        [
            piston,
            net / seen.packing.radii().len() as f64,
            normal / seen.contacts.len().max(1) as f64,
        ]
    }
}

impl PackingBody<{ COLUMNS.len() }> for PowderBody {
    type Scene = PowderScene;
    type Monitor = PressMonitor;

    const COLUMNS: [&'static str; COLUMNS.len()] = COLUMNS;
    const FORMAT: (&'static str, u64) = ("tribos_compaction", 4);
    const KIND: Kind = Kind::Powder;
    // A window has the stress of every step.
    const CADENCE: MeasurementSchedule = MeasurementSchedule::Steps;
    const OVER: PackingStopReason = PackingStopReason::Blocked;

    fn place(
        scene: &PowderScene,
        watch: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<(Self, InitialSpheres), PackingRunError> {
        let (deposit, start) = start(scene, watch)?;
        let volumes = deposit.radii.iter().map(|r| 4.0 / 3.0 * PI * r * r * r);
        let body = Self {
            scene: scene.clone(),
            solid: volumes.sum(),
            deposit,
            first_contacts: start.contacts.clone(),
        };
        Ok((body, start))
    }

    fn check(scene: &PowderScene) -> Result<(), PackingRunError> {
        let diameter = 2.0 * scene.least_radius();
        if scene.initial_state.is_none() && scene.count.is_none() && scene.height < diameter {
            return Err(PlacementError::Empty.into());
        }
        let mut two = scene.clone();
        if scene.initial_state.is_none() {
            two.count = Some(2);
        }
        PowderSimulation::new(&two).map(|_| ())
    }

    fn scene(&self) -> &PowderScene {
        &self.scene
    }

    fn contact_keys(&self) -> ContactKeys {
        self.scene.contact_keys()
    }

    fn bounds(&self) -> RunLimits {
        RunLimits {
            duration: self.scene.duration.unwrap_or(f64::INFINITY),
            steps: self.scene.max_steps,
            samples: self.scene.sample_every,
        }
    }

    fn walls(&self) -> usize {
        WALLS
    }

    fn bodies(&self, start: &InitialSpheres, _: &OptionalFeatures) -> Bodies {
        let up = Vector3::z();
        Bodies {
            space: self.deposit.space,
            positions: start.positions.clone(),
            radii: start.radii.clone(),
            // The order of SUBSTRATE and PISTON.
            walls: vec![
                Wall::fixed(up, 0.0),
                Wall::piston(
                    -up,
                    -self.deposit.height,
                    self.scene.piston_mass,
                    self.scene.load(),
                ),
            ],
            // Not -0.0 without gravity.
            gravity: Vector3::new(0.0, 0.0, 0.0 - self.scene.gravity),
        }
    }

    /// Nothing seen yet.
    fn monitor(&self) -> PressMonitor {
        PressMonitor {
            window: Window::starting(self.deposit.height),
            complete: None,
            stress: Stress::default(),
            before: Vec::new(),
        }
    }

    fn prepare(&self, watch: &mut PressMonitor, packing: &mut dyn Packing) {
        watch.before.clear();
        watch.before.extend_from_slice(packing.spheres());
    }

    /// Updates the stress, and adds it and the forces to the window.
    fn measure(&self, watch: &mut PressMonitor, seen: &MeasuredState) {
        let radii = seen.packing.radii();
        let volume = self.area() * height(seen);
        watch.stress = Stress::of(&seen.contacts, |contact| branch(contact, radii), volume);
        let forces = watch.forces(seen);
        watch.window.add(seen.report.dt, &watch.stress, forces);
    }

    /// Free share of the volume below the piston (thesis, eq. 4.5).
    fn porosity(&self, seen: &MeasuredState) -> f64 {
        1.0 - self.solid / (self.area() * height(seen))
    }

    fn line(&self, watch: &PressMonitor, seen: &MeasuredState) -> [f64; COLUMNS.len()] {
        let (time, step) = seen.packing.clock();
        let energy = seen.packing.energy();
        let line = PowderLine {
            time,
            step: step as f64,
            piston_height: height(seen),
            porosity: self.porosity(seen),
            contacts: seen.contacts.len() as f64,
            stress_zz: watch.stress.total().m33 / self.scene.pressure,
            sweeps: seen.report.iterations.sweeps as f64,
            residual: seen.report.residual.relative,
            kinetic: energy.kinetic,
            dissipated_normal: energy.normal,
            dissipated_sliding: energy.sliding,
            dissipated_rolling: energy.rolling,
            dissipated_torsion: energy.torsion,
            dissipated_cohesion: energy.cohesion,
            work: energy.work,
        };
        line.values()
    }

    /// Closes a full window and applies the criterion of blocked packings.
    fn is_over(&self, watch: &mut PressMonitor, seen: &MeasuredState) -> bool {
        let scene = &self.scene;
        if !watch.window.is_full(scene.piston_mass, scene.load()) {
            return false;
        }
        let height = height(seen);
        let means = watch.window.means(height).less(self.weight_stress(seen));
        watch.complete = Some((watch.window, height));
        watch.window = Window::starting(height);
        means.is_blocked(scene.blocked_criterion, scene.pressure, self.area())
    }

    fn extents(&self, seen: &MeasuredState) -> [[f64; 2]; 3] {
        let side = [0.0, self.scene.width];
        [side, side, [0.0, height(seen)]]
    }

    fn sides(&self) -> [f64; 2] {
        [self.scene.width; 2]
    }

    fn height(&self, seen: &MeasuredState) -> f64 {
        height(seen)
    }

    fn write_checkpoint(watch: &PressMonitor, map: &mut Map<String, Value>) {
        let complete = watch
            .complete
            .iter()
            .flat_map(|(window, height)| window_numbers(window).into_iter().chain([*height]));
        let complete: Vec<f64> = complete.collect();
        map.insert("window".into(), hex(&window_numbers(&watch.window)).into());
        map.insert("complete_window".into(), hex(&complete).into());
        let stress = [&watch.stress.plus, &watch.stress.minus];
        let stress: Vec<f64> = stress.into_iter().flatten().copied().collect();
        map.insert("last_stress".into(), hex(&stress).into());
    }

    fn read(value: &Value) -> Result<PressMonitor, CheckpointError> {
        let read = |numbers: &[f64], name| window(numbers).ok_or_else(|| damaged(name));
        let complete = numbers(value, "complete_window")?;
        let stress = numbers(value, "last_stress")?;
        let stress = <&[f64; TENSORS]>::try_from(stress.as_slice());
        Ok(PressMonitor {
            window: read(&numbers(value, "window")?, "window")?,
            complete: match complete.split_last() {
                None => None,
                Some((height, numbers)) => Some((read(numbers, "complete_window")?, *height)),
            },
            stress: tensors(stress.map_err(|_| damaged("last_stress"))?),
            before: Vec::new(),
        })
    }
}

impl PowderSimulation {
    /// Current height of the piston.
    pub fn height(&self) -> f64 {
        height(&self.seen)
    }

    /// Porosity: free share of the volume below the piston (thesis, eq. 4.5).
    pub fn porosity(&self) -> f64 {
        self.body.porosity(&self.seen)
    }

    /// The deposit, or the other spheres, from which the run started.
    pub fn deposit(&self) -> &Deposit {
        &self.body.deposit
    }

    /// Contacts at the start: those of the deposit, or of the state from which the run started.
    #[doc(hidden)]
    pub fn first_contacts(&self) -> &[ContactRow] {
        &self.body.first_contacts
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> PowderSummary {
        let (body, seen) = (&self.body, &self.seen);
        let (scene, area, height) = (&body.scene, body.area(), self.height());
        let [low, high] = BULK.map(|share| share * height);
        let (positions, radii) = (seen.packing.positions(), seen.packing.radii());
        let bulk = volume_between(positions, radii, [low, high]);
        let (totals, means) = (self.totals(), body.means(&self.watch, seen));
        let rebounds = |count: u64| (scene.restitution > 0.0).then_some(count);
        let stress = MeanStress {
            total: means.stress.total(),
            plus: means.stress.plus,
            minus: means.stress.minus,
        };
        let energy = seen.packing.energy();
        PowderSummary {
            ending: self.ending(),
            porosity_initial: body.deposit.porosity(),
            porosity_final: self.porosity(),
            porosity_bulk: 1.0 - bulk / (area * (high - low)),
            height_initial: body.deposit.height,
            height_final: height,
            particles: radii.len(),
            contacts: self.pairs(),
            time: self.time(),
            steps: self.steps(),
            iterations_total: totals.iterations,
            steps_unmet: totals.unmet,
            steps_handed_over: Some(totals.handed_over).filter(|steps| *steps > 0),
            steps_solver_unmet: rebounds(totals.solver_unmet),
            steps_impacts_cut: rebounds(totals.cut),
            steps_impacts_unmet: rebounds(totals.impacts_unmet),
            stress_zz: stress.total.m33 / scene.pressure,
            stress_zz_plus: stress.plus.m33 / scene.pressure,
            stress_zz_minus: stress.minus.m33 / scene.pressure,
            residual_final: seen.report.residual.relative,
            max_overlap: self.max_overlap(),
            balance: PistonBalance {
                piston_moved: means.moved,
                piston_force: means.piston / (scene.pressure * area),
                net_force: means.net / means.contact,
            },
            stress,
            statistics: self.statistics(),
            dissipation: Dissipation::of(energy),
            energy: PackingEnergy {
                stilled: Some(energy.stilled),
                ..PackingEnergy::of(energy, &scene.contact_method())
            },
            wall_seconds: totals.wall_seconds,
        }
    }
}

impl Measure for PowderScene {
    type Error = PackingRunError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, PackingRunError> {
        PowderSimulation::measured(self, watch, |run| run.outcome().json(self))
    }
}

fn window_numbers(window: &Window) -> [f64; WINDOW] {
    let mut numbers = [0.0; WINDOW];
    let head = [window.steps as f64, window.time, window.start];
    let stress = [&window.stress.plus, &window.stress.minus];
    let all = head
        .into_iter()
        .chain(window.forces)
        .chain(stress.into_iter().flat_map(|tensor| tensor.iter().copied()));
    for (number, value) in numbers.iter_mut().zip(all) {
        *number = value;
    }
    numbers
}

fn window(numbers: &[f64]) -> Option<Window> {
    let numbers = <&[f64; WINDOW]>::try_from(numbers).ok()?;
    let (head, stress) = numbers.split_last_chunk::<TENSORS>()?;
    let &[steps, time, start, piston, net, normal] = head else {
        return None;
    };
    Some(Window {
        steps: steps as u64,
        time,
        start,
        forces: [piston, net, normal],
        stress: tensors(stress),
    })
}

/// The shares that push and that pull.
fn tensors(numbers: &[f64; TENSORS]) -> Stress {
    let (plus, minus) = numbers.split_at(TENSORS / 2);
    Stress {
        plus: Matrix3::from_column_slice(plus),
        minus: Matrix3::from_column_slice(minus),
    }
}
