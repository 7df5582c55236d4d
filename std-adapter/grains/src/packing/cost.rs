//! What updates of contacts cost, measured, and how long stable steps of springs are.

use super::{Material, Packing, Springs};
use std::time::Instant;
use tribos_contacts::cd::{Wall, WorldError, solid};
use tribos_contacts::soft::{self, StepLength};
use tribos_core::contact::Cohesion;

/// Number of timings.
const ROUNDS: usize = 31;
/// Steps of a timing without sweeps.
const STEPS: usize = 50;

/// Time of an update of a contact in the packing of each of two scenes: the minimum over alternating rounds.
pub(crate) fn update_seconds<S, E: From<WorldError>>(
    scenes: [&S; 2],
    packing: impl Fn(&S) -> Result<Box<dyn Packing>, E>,
) -> Result<[f64; 2], E> {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        for (scene, least) in scenes.into_iter().zip(&mut least) {
            let mut packing = packing(scene)?;
            let start = Instant::now();
            let mut updates = 0;
            for _ in 0..STEPS {
                let report = packing.step()?;
                let sweeps = report.iterations.sweeps;
                // A step of soft contacts updates each of them once.
                updates += sweeps.max(1) * report.contacts.max(1);
                if sweeps > 0 {
                    break;
                }
            }
            *least = least.min(start.elapsed().as_secs_f64() / updates as f64);
        }
    }
    Ok(least)
}

/// Length of the stable steps of spheres at rest, of a smallest radius and under a force.
pub(crate) fn stable_step(springs: &Springs, material: &Material, radius: f64, force: f64) -> f64 {
    stable_step_between((springs, material), (radius, force), (&[], &[]))
}

/// The same between walls, each with a number of spheres that touch it.
pub(crate) fn stable_step_between(
    (springs, material): (&Springs, &Material),
    (radius, force): (f64, f64),
    (walls, touching): (&[Wall], &[usize]),
) -> f64 {
    let sphere = solid(radius, material.density);
    let damping = if material.restitution > 0.0 {
        soft::damping_ratio_of(material.restitution)
    } else {
        springs.damping
    };
    let stiffness = springs.stiffness;
    let laws = (stiffness, damping);
    // What the kernel refuses has no steps.
    let laws_of = material.normal_laws();
    let cohesion = laws_of.map_or(Cohesion::NONE, |[pairs, _]| *pairs.cohesion());
    let length = StepLength::of_spheres(
        laws,
        [1.0 / sphere.inv_mass, radius],
        cohesion,
        springs.steps_per_collision,
    );
    let overlap = stiffness.overlap(force, 0.5 * radius);
    length.next(&[], walls, overlap, touching)
}
