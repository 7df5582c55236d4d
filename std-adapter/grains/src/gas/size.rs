//! Rough cost of a run.

use super::soft_collision;
use crate::gas::scene::{GasMethod, GasScene};
use tribos_base::run::RunSize;
use tribos_contacts::event::collision_rate;

/// Memory a sphere, in bytes: places, events and exports.
const BYTES_A_SPHERE: f64 = 4e3;
/// Time of a collision, in s, and of a sphere's time step of contact dynamics and of soft particles.
const SECONDS_A_COLLISION: f64 = 3e-6;
const SECONDS_A_SPHERE_STEP: f64 = 0.5e-6;
const SECONDS_A_SOFT_STEP: f64 = 0.05e-6;
/// Mean free path times the packing fraction, in R, at low density.
const PATH: f64 = 0.24;

/// Rough cost of a run of the scene.
///
/// *Accuracy*: a factor of 3 for the time.
///
/// ```
/// use tribos::{gas::size, scene::GasScene};
/// let small = size(&GasScene::default());
/// assert!(small.bodies == 1000.0 && small.seconds < 1.0);
/// ```
pub fn size(scene: &GasScene) -> RunSize {
    let bodies = scene.count as f64;
    let events = 0.5 * bodies * (scene.mixing_collisions + scene.collisions);
    let seconds = match scene.method {
        GasMethod::Events => events * SECONDS_A_COLLISION,
        GasMethod::ContactDynamics => {
            let steps = 3.0 * PATH / (scene.packing_fraction * scene.max_displacement) + 1.0;
            bodies * scene.collisions * steps * SECONDS_A_SPHERE_STEP
        }
        GasMethod::Soft => {
            let step = soft_collision(scene).map_or(f64::INFINITY, |usual| usual.step);
            bodies * duration(scene) / step * SECONDS_A_SOFT_STEP
        }
    };
    RunSize {
        bodies,
        bytes: bodies * BYTES_A_SPHERE,
        seconds,
    }
}

/// Time in which a gas that stays homogeneous has its collisions, or less where the scene bounds it.
fn duration(scene: &GasScene) -> f64 {
    let rate = collision_rate(scene.packing_fraction, 1.0);
    // dC/dt = rate √T with T = exp(−(1 − e²) C/3).
    let slowing = (1.0 - scene.restitution * scene.restitution) / 6.0;
    let collisions = if slowing > 0.0 {
        libm::expm1(slowing * scene.collisions) / slowing
    } else {
        scene.collisions
    };
    (collisions / rate).min(scene.duration.unwrap_or(f64::INFINITY))
}
