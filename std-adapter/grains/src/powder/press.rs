//! What a piston does to a powder, step by step: its loads, its measures and when it ends.

use super::blocked::{Means, Window};
use super::deposit::Deposit;
use super::outcome::{COLUMNS, PowderStopReason};
use super::parts::PISTON;
use crate::packing::{
    self, Body, MeasuredState, MeasurementSchedule, Packing, RunLimits, Stress, branch, is_at,
};
use crate::powder::scene::PowderScene;
use nalgebra::Matrix3;
use serde_json::{Map, Value};
use std::f64::consts::PI;
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, hex, numbers};
use tribos_base::scene::Key;
use tribos_core::contact::SphereBody;

/// Numbers of a window in a checkpoint, and of a stress.
const WINDOW: usize = 24;
const TENSORS: usize = 18;

/// A powder under its piston.
#[derive(Debug)]
pub(super) struct PowderBody {
    pub scene: PowderScene,
    pub deposit: Deposit,
    /// Total volume of the spheres.
    solid: f64,
}

/// What is remembered from step to step.
#[derive(Debug)]
pub(super) struct PressMonitor {
    pub window: Window,
    /// The last complete window, with the piston's height at its end.
    pub complete: Option<(Window, f64)>,
    /// Stress after the last step.
    stress: Stress,
    /// Spheres before the last step.
    before: Vec<SphereBody<f64>>,
}

impl PowderBody {
    pub fn new(scene: &PowderScene, deposit: Deposit) -> Self {
        let volumes = deposit.radii.iter().map(|r| 4.0 / 3.0 * PI * r * r * r);
        Self {
            scene: scene.clone(),
            solid: volumes.sum(),
            deposit,
        }
    }

    pub fn area(&self) -> f64 {
        self.scene.width * self.scene.width
    }

    /// Porosity: free share of the volume below the piston (thesis, eq. 4.5).
    pub fn porosity(&self, seen: &MeasuredState) -> f64 {
        1.0 - self.solid / (self.area() * height(seen))
    }

    /// Means over the last complete window, or over the incomplete first one.
    pub fn means(&self, watch: &PressMonitor, seen: &MeasuredState) -> Means {
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
pub(super) fn height(seen: &MeasuredState) -> f64 {
    // Its normal points down.
    -seen.packing.walls()[PISTON as usize].place
}

impl PressMonitor {
    /// Nothing seen yet, with the piston at a height.
    pub fn starting(height: f64) -> Self {
        Self {
            window: Window::starting(height),
            complete: None,
            stress: Stress::default(),
            before: Vec::new(),
        }
    }

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

impl Body<{ COLUMNS.len() }> for PowderBody {
    type Monitor = PressMonitor;
    type Ending = PowderStopReason;

    const COLUMNS: [&'static str; COLUMNS.len()] = COLUMNS;
    const FORMAT: (&'static str, u64) = ("tribos_compaction", 4);
    const KEYS: &'static [Key] = PowderScene::KEYS;
    // A window has the stress of every step.
    const CADENCE: MeasurementSchedule = MeasurementSchedule::Steps;

    fn scene(&self) -> Value {
        self.scene.json()
    }

    fn bounds(&self) -> RunLimits {
        bounds(&self.scene)
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

    fn solid_fraction(&self, seen: &MeasuredState) -> f64 {
        1.0 - self.porosity(seen)
    }

    fn line(&self, watch: &PressMonitor, seen: &MeasuredState) -> [f64; COLUMNS.len()] {
        let (time, step) = seen.packing.clock();
        let energy = seen.packing.energy();
        [
            time,
            step as f64,
            height(seen),
            self.porosity(seen),
            seen.contacts.len() as f64,
            watch.stress.total().m33 / self.scene.pressure,
            seen.report.iterations.sweeps as f64,
            seen.report.residual.relative,
            energy.kinetic,
            energy.normal,
            energy.sliding,
            energy.rolling,
            energy.torsion,
            energy.cohesion,
            energy.work,
        ]
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

/// Limits of a run of a scene.
pub(super) fn bounds(scene: &PowderScene) -> RunLimits {
    RunLimits {
        duration: scene.duration.unwrap_or(f64::INFINITY),
        steps: scene.max_steps,
        samples: scene.sample_every,
    }
}

impl packing::Ending for PowderStopReason {
    const OVER: Self = Self::Blocked;
    const TIME: Self = Self::Time;
    const STEPS: Self = Self::Steps;

    fn name(self) -> &'static str {
        self.name()
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
