//! Forecast of the cost of a run: contacts, unknowns, time.

use super::error::GrainsError;
use super::from_scene::{self, volume};
use super::initial_grains::start;
use super::layout::Layout;
use super::loads::Loads;
use crate::grains::scene::{Container, EndBoundary, GrainsScene, SideBoundary};
use crate::packing::Assembly;
use crate::packing::method::{ContactMethod, FrictionCoupling};
use crate::packing::{self, Method, Packing};
use std::ops::ControlFlow;
use tribos_base::run::RunSize;
use tribos_core::contact::SphereBody;

/// Cost of a scene. *Units*: times in s on one core of this machine.
///
/// ```
/// use tribos::grains::cost;
/// // Beads that slide with friction: a normal and two tangential unknowns.
/// let cost = cost(&tribos::scene::GrainsScene::default())?;
/// assert_eq!((cost.grains, cost.unknowns), (100, 3));
/// assert!(cost.update_seconds > 0.0);
/// # Ok::<(), tribos::grains::GrainsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GrainsCost {
    /// Number of grains.
    pub grains: usize,
    /// Lower and upper estimate of the number of contacts in a dense packing.
    pub contacts: [usize; 2],
    /// Unknowns per contact.
    pub unknowns: usize,
    /// Bytes per contact in the solver.
    pub bytes: usize,
    /// Longest time step.
    pub longest_step: f64,
    /// Number of steps of this length in the duration; fast grains take shorter ones.
    pub steps: f64,
    /// Time of one contact update.
    pub update_seconds: f64,
    /// Time of an update with sliding friction only.
    pub sliding_seconds: f64,
}

/// Contacts per grain of a dense packing: isostatic with friction and without.
const CONTACTS: [f64; 2] = [2.0, 3.0];
/// Memory of a run per grain, in bytes, that of powders.
const BYTES_A_GRAIN: f64 = 5e3;
/// Time of a step per grain, with some hundred sweeps, as dense beds need them.
const SECONDS_A_STEP: f64 = 100e-6;
/// Time of a stable step of soft contacts per grain, that of powders.
const SOFT_SECONDS: f64 = 0.25e-6;
/// Grains whose weight a usual contact bears.
const LAYERS: f64 = 10.0;
/// Grains along an edge of the block whose updates are timed, and sweeps of its step.
const EDGE: usize = 6;
const SWEEPS: usize = 50;

/// Rough cost of a run of the scene: the order of magnitude.
///
/// ```
/// use tribos::grains::size;
/// let size = size(&tribos::scene::GrainsScene { count: 1000, ..Default::default() });
/// assert_eq!(size.bodies, 1000.0);
/// ```
pub fn size(scene: &GrainsScene) -> RunSize {
    let bodies = count(scene) as f64;
    let longest = scene.longest_step();
    let steps = (scene.duration / longest).min(scene.max_steps as f64);
    let step = match stable_step(scene) {
        None => SECONDS_A_STEP,
        Some(stable) => (longest / stable).ceil() * SOFT_SECONDS,
    };
    RunSize {
        bodies,
        bytes: bodies * BYTES_A_GRAIN,
        seconds: bodies * steps * step,
    }
}

/// Usual length of the stable steps of soft contacts; `None` for rigid ones.
///
/// ```
/// use tribos::grains::stable_step;
/// use tribos::scene::{ContactMethod, GrainsScene};
/// // 2 √(m/(2 k)) in 35 steps, with m = 1.3 g and k = 10 kN/m.
/// let soft = GrainsScene { method: ContactMethod::Soft, ..GrainsScene::default() };
/// assert!(stable_step(&soft).is_some_and(|dt| (dt / 1.462e-5 - 1.0).abs() < 0.01));
/// assert_eq!(stable_step(&GrainsScene::default()), None);
/// ```
pub fn stable_step(scene: &GrainsScene) -> Option<f64> {
    match scene.contact_method() {
        Method::ContactDynamics { .. } => None,
        Method::Soft(springs) => {
            let (material, [_, gravity]) = (scene.material(), scene.gravity.range());
            let mass = material.density * volume(scene.radius);
            let smallest = scene.radius * scene.least_radius();
            let force = LAYERS * mass * gravity;
            Some(packing::stable_step(&springs, &material, smallest, force))
        }
    }
}

/// Number of grains; 0 if those of a start cannot be read.
fn count(scene: &GrainsScene) -> usize {
    match &scene.initial_state {
        Some(path) => Assembly::read(path).map_or(0, |grains| grains.radii.len()),
        None => scene.count,
    }
}

/// Counts unknowns, and times updates in a small block of grains under load.
pub fn cost(scene: &GrainsScene) -> Result<GrainsCost, GrainsError> {
    scene.check()?;
    /// A dry friction coefficient.
    const USUAL: f64 = 0.3;
    let modes = scene.material().carried().modes;
    let mu = scene.mu;
    let plain = GrainsScene {
        mu: if mu > 0.0 { mu } else { USUAL },
        mu_rolling: 0.0,
        mu_torsion: 0.0,
        coupling: FrictionCoupling::Independent,
        ..scene.clone()
    };
    let [update_seconds, sliding_seconds] = packing::update_seconds([scene, &plain], block)?;
    let longest_step = scene.longest_step();
    let spread = scene.radius_spread > 0.0 || scene.size_distribution.is_some();
    let unequal = spread || scene.second_fraction > 0.0 || scene.initial_state.is_some();
    Ok(GrainsCost {
        grains: count(scene),
        contacts: CONTACTS.map(|share| (share * count(scene) as f64).round() as usize),
        unknowns: modes.unknowns(),
        bytes: match scene.method {
            ContactMethod::ContactDynamics => modes.bytes()[usize::from(unequal)],
            ContactMethod::Soft => modes.soft_bytes(),
        },
        longest_step,
        steps: scene.duration / longest_step,
        update_seconds,
        sliding_seconds,
    })
}

/// A cubic lattice of grains that just touch, under gravity along a diagonal.
fn block(scene: &GrainsScene) -> Result<Box<dyn Packing>, GrainsError> {
    let side = 2.0 * EDGE as f64 * scene.radius * (1.0 - 1e-9);
    let block = GrainsScene {
        width: side,
        depth: None,
        height: Some(side),
        boundary_x: SideBoundary::Periodic,
        boundary_y: SideBoundary::Periodic,
        boundary_z: EndBoundary::Periodic,
        dimension: 3,
        container: Container::Box,
        count: EDGE.pow(3),
        radius: 0.5 * side / EDGE as f64 / (1.0 + 1e-9),
        radius_spread: 0.0,
        size_distribution: None,
        initial_state: None,
        initial_spacing: 1.0 + 1e-12,
        max_iterations: SWEEPS,
        tolerance: f64::MIN_POSITIVE,
        restitution: 0.0,
        // One stable step of soft contacts; sweeps do not depend on it.
        max_time_step: stable_step(scene).or(scene.max_time_step),
        ..without_drives(scene)
    };
    let grains = start(&block, |_| ControlFlow::Continue(()))?;
    let layout = Layout::of(&block, &grains)?;
    let loads = Loads::of(&block, &layout);
    from_scene::packing(&block, (&layout, &loads), grains, None)
}

/// The scene without moving walls.
fn without_drives(scene: &GrainsScene) -> GrainsScene {
    GrainsScene {
        wall_stress_x: None,
        wall_stress_y: None,
        wall_stress_z: None,
        wall_velocity_x: None,
        wall_velocity_y: None,
        wall_velocity_z: None,
        lid_speed_x: 0.0.into(),
        shake_amplitude: 0.0,
        ..scene.clone()
    }
}

impl GrainsCost {
    /// Memory of the grains and of the most contacts in the solver, in bytes, without neighbour lists.
    pub fn memory(&self) -> usize {
        let grain = 4 * size_of::<f64>() + 3 * size_of::<SphereBody<f64>>();
        self.grains * grain + self.contacts[1] * self.bytes
    }
}
