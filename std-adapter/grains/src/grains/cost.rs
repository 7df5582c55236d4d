//! Forecast of the cost of a run: contacts, unknowns, time.

use super::from_scene::volume;
use crate::grains::scene::GrainsScene;
use crate::packing::PackingRunError;
use crate::packing::{self, Assembly, BYTES_A_SPHERE, Method, PackingCost, SOFT_SECONDS};
use tribos_base::run::RunSize;

/// Contacts per grain of a dense packing: isostatic with friction and without.
const CONTACTS: [f64; 2] = [2.0, 3.0];
/// Time of a step per grain, with some hundred sweeps, as dense beds need them.
const SECONDS_A_STEP: f64 = 100e-6;
/// Grains whose weight a usual contact bears.
const LAYERS: f64 = 10.0;
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
        bytes: bodies * BYTES_A_SPHERE,
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
            let (mixture, force) = (scene.mixture(), usual_force(scene));
            let smallest = scene.radius * scene.least_radius();
            Some(packing::stable_step(&springs, &mixture, smallest, force))
        }
    }
}

/// Number of grains; 0 if those of a start cannot be read.
fn count(scene: &GrainsScene) -> usize {
    match &scene.initial_state {
        Some(path) => {
            Assembly::read_as(path, scene.columns.as_ref()).map_or(0, |grains| grains.radii.len())
        }
        None => scene.count,
    }
}

/// Counts unknowns, and times updates in a small block of grains under load.
///
/// ```
/// use tribos::grains::cost;
/// // Beads that slide with friction: a normal and two tangential unknowns.
/// let cost = cost(&tribos::scene::GrainsScene::default())?;
/// assert_eq!((cost.spheres, cost.unknowns), (100, 3));
/// # Ok::<(), tribos::run::PackingRunError>(())
/// ```
pub fn cost(scene: &GrainsScene) -> Result<PackingCost, PackingRunError> {
    scene.check()?;
    PackingCost::measured(
        &scene.contact_keys(),
        (scene.radius, usual_force(scene)),
        count(scene),
        |_| CONTACTS,
    )
}

/// Force of a usual contact: the weight of the grains above it.
fn usual_force(scene: &GrainsScene) -> f64 {
    let [_, gravity] = scene.gravity.range();
    LAYERS * scene.density * volume(scene.radius) * gravity
}
