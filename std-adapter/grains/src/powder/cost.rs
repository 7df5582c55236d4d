//! Forecast of the cost of a compaction: spheres, contacts, unknowns, and the time of an update.

use super::deposit::Ballistic;
use super::start::start;
use crate::packing::PackingRunError;
use crate::packing::{self, Assembly, BYTES_A_SPHERE, Method, ModeSet, PackingCost, SOFT_SECONDS};
use crate::powder::scene::PowderScene;
use std::ops::ControlFlow;
use tribos_base::run::RunSize;

/// Contacts per sphere after compaction. The thesis' small system ends with 2.8 if smooth, with 2.1
/// under sliding friction, and with 1.5 and 1.0 for rolling and torsion coefficients of 0.1 and 1:
/// the more a contact can bear, the fewer are needed.
fn contacts_a_sphere(modes: ModeSet) -> [f64; 2] {
    match modes {
        ModeSet::Normal => [2.6, 3.0],
        ModeSet::Sliding | ModeSet::SlidingTorsion => [2.0, 2.6],
        ModeSet::SlidingRolling | ModeSet::All => [1.0, 2.0],
    }
}

/// Time per sphere until the thesis' systems of 470 to 4,193 spheres are blocked.
const SECONDS_A_SPHERE: f64 = 25e-3;
/// Time of a step per sphere, with the usual number of sweeps.
const SECONDS_A_STEP: f64 = 5e-6;
/// Time in the scene's unit until the thesis' small system of soft spheres is blocked.
const SOFT_TIME: f64 = 500.0;
/// Largest number of spheres for which the deposit is grown to count them.
const COUNTED: f64 = 2e5;

/// Rough cost of a run of the scene, before its deposit is grown.
///
/// *Accuracy*: a tenth for the spheres, a factor of 1.5 for the memory, the order of magnitude for
/// the time.
///
/// ```
/// use tribos::powder::size;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 20.0, height: 61.5, ..PowderScene::default() };
/// let small = size(&scene);
/// assert!((420.0..520.0).contains(&small.bodies) && (1.0..60.0).contains(&small.seconds));
/// ```
pub fn size(scene: &PowderScene) -> RunSize {
    let bodies = expected_spheres(scene);
    let [step, sphere] = match stable_step(scene) {
        None => [SECONDS_A_STEP, SECONDS_A_SPHERE],
        Some(stable) => [scene.max_time_step, SOFT_TIME].map(|time| time / stable * SOFT_SECONDS),
    };
    RunSize {
        bodies,
        bytes: bodies * BYTES_A_SPHERE,
        seconds: (bodies * scene.max_steps as f64 * step).min(bodies * sphere),
    }
}

/// Usual length of the stable steps of soft contacts, in the scene's unit of time; `None` for rigid ones.
///
/// ```
/// use tribos::powder::stable_step;
/// use tribos::scene::{ContactMethod, PowderScene};
/// let soft = PowderScene { method: ContactMethod::Soft, stiffness: 1e4, ..PowderScene::default() };
/// // 2 √(m/(2 k)) in 35 steps, with m = 4π/3.
/// assert!(stable_step(&soft).is_some_and(|dt| (dt / 8.27e-4 - 1.0).abs() < 1e-3));
/// assert_eq!(stable_step(&PowderScene::default()), None);
/// ```
pub fn stable_step(scene: &PowderScene) -> Option<f64> {
    match scene.contact_method() {
        Method::ContactDynamics { .. } => None,
        Method::Soft(springs) => {
            let radius = scene.least_radius();
            Some(packing::stable_step(
                &springs,
                &scene.mixture(),
                radius,
                0.0,
            ))
        }
    }
}

/// Number of spheres in the deposit; `None` if width and capture radius are incompatible.
fn expected_spheres(scene: &PowderScene) -> f64 {
    if let Some(path) = &scene.initial_state {
        return Assembly::read_as(path, scene.columns.as_ref())
            .map_or(0.0, |spheres| spheres.radii.len() as f64);
    }
    let spheres = |ballistic: Ballistic| ballistic.expected_spheres(scene.until());
    scene.ballistic().map_or(0.0, spheres)
}

/// Grows the deposit if it is not too large, and times updates in a small block of spheres under load.
///
/// *Accuracy*: about ten per cent for the times; the updates of spheres of two materials, or of gaps that a
/// resistance holds open, take longer.
pub fn cost(scene: &PowderScene) -> Result<PackingCost, PackingRunError> {
    scene.check()?;
    let expected = expected_spheres(scene);
    let spheres = if expected <= COUNTED {
        let (deposit, _) = start(scene, |_| ControlFlow::Continue(()))?;
        deposit.positions.len()
    } else {
        expected.round() as usize
    };
    // The load on a column of spheres of radius 1.
    let usual = (1.0, 4.0 * scene.pressure);
    PackingCost::measured(&scene.contact_keys(), usual, spheres, contacts_a_sphere)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packing::method::FrictionCoupling;

    fn scene(keys: &str) -> PowderScene {
        let text = format!("body = \"powder\"\nwidth = 6\nheight = 8\n{keys}");
        PowderScene::parse("tiny.toml", &text, &[]).unwrap()
    }

    #[test]
    fn contacts_carry_the_unknowns_of_the_modes_that_resist() {
        for (keys, unknowns, coupling) in [
            ("mu = 0", 1, FrictionCoupling::Independent),
            (
                "mu = 0\ncoupling = \"exact\"",
                1,
                FrictionCoupling::Independent,
            ),
            ("", 3, FrictionCoupling::Independent),
            ("mu_torsion = 0.1", 4, FrictionCoupling::Independent),
            (
                "mu_torsion = 0.1\ncoupling = \"exact\"",
                4,
                FrictionCoupling::Exact,
            ),
            (
                "mu_rolling = 0.1\ncoupling = \"ellipsoid\"",
                5,
                FrictionCoupling::Independent,
            ),
            (
                "rolling = 0.1\ntorsion = 0.1",
                6,
                FrictionCoupling::Independent,
            ),
            (
                "sliding = 0\nrolling = 0.1",
                6,
                FrictionCoupling::Independent,
            ),
            (
                "mu_rolling = 0.1\nmu_torsion = 0.1",
                6,
                FrictionCoupling::Independent,
            ),
            ("mu = 0\nmu_rolling = 0.1", 6, FrictionCoupling::Independent),
        ] {
            let carried = scene(keys).material().carried();
            assert_eq!(carried.modes.unknowns(), unknowns, "{keys}");
            assert_eq!(carried.coupling, coupling, "{keys}");
        }
    }
}
