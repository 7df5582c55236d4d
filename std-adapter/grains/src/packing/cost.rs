//! What updates of contacts cost, measured, and how long stable steps of springs are.

use super::{ContactKeys, Material, Method, ModeSet, Packing, Springs};
use nalgebra::Vector3;
use std::time::Instant;
use tribos_contacts::cd::{Wall, WorldError, solid};
use tribos_contacts::soft::{self, StepLength};
use tribos_core::contact::{Cohesion, SphereBody};

/// Memory of a run per sphere, in bytes, including contacts, neighbours and exports: measured with
/// 3,000 and 12,000 spheres.
pub(crate) const BYTES_A_SPHERE: f64 = 5e3;
/// Time of a stable step of soft contacts per sphere, in s.
pub(crate) const SOFT_SECONDS: f64 = 0.25e-6;
/// Spheres along an edge of the block whose updates are timed.
pub(crate) const EDGE: usize = 6;
/// Sweeps of its step, so that the rest of the step is negligible.
pub(crate) const SWEEPS: usize = 50;
/// Sliding coefficient of a comparison with spheres without one: a dry friction coefficient.
pub(crate) const USUAL: f64 = 0.3;

/// Cost of a scene of spheres in contact. *Units*: times in s on one core of this machine.
///
/// ```
/// use tribos::powder::{PackingCost, cost};
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// // A small powder whose contacts slide with friction: a normal and two tangential unknowns.
/// let cost: PackingCost = cost(&scene)?;
/// assert_eq!(cost.unknowns, 3);
/// assert!(cost.memory() > cost.contacts[1] * cost.bytes); // and the spheres
/// assert!(cost.update_seconds > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PackingCost {
    /// Number of spheres; an estimate of a deposit from 200,000 on, which is not grown.
    pub spheres: usize,
    /// Lower and upper estimate of the number of contacts in a dense packing.
    pub contacts: [usize; 2],
    /// Unknowns per contact.
    pub unknowns: usize,
    /// Bytes per contact in the solver, or per pair of soft neighbours.
    pub bytes: usize,
    /// Time of one contact update.
    pub update_seconds: f64,
    /// Time of an update with sliding friction only, measured alternately with the other.
    pub sliding_seconds: f64,
}

impl PackingCost {
    /// The cost of spheres of one radius or of several, with so many contacts each; times of updates with and
    /// without the modes beside sliding.
    pub(crate) fn of(
        keys: &ContactKeys,
        (spheres, is_unequal): (usize, bool),
        contacts_a_sphere: impl Fn(ModeSet) -> [f64; 2],
        [update_seconds, sliding_seconds]: [f64; 2],
    ) -> Self {
        let modes = keys.material.carried().modes;
        let contacts = |share: f64| (share * spheres as f64).round() as usize;
        Self {
            spheres,
            contacts: contacts_a_sphere(modes).map(contacts),
            unknowns: modes.unknowns(),
            bytes: match keys.method {
                Method::ContactDynamics { .. } => modes.bytes()[usize::from(is_unequal)],
                Method::Soft(_) => modes.soft_bytes(),
            },
            update_seconds,
            sliding_seconds,
        }
    }

    /// Memory of the spheres and of the most contacts in the solver, in bytes, without neighbour lists.
    pub fn memory(&self) -> usize {
        // Place and radius; velocities and masses of the state, of the trial and without contacts.
        let sphere =
            size_of::<Vector3<f64>>() + size_of::<f64>() + 3 * size_of::<SphereBody<f64>>();
        self.spheres * sphere + self.contacts[1] * self.bytes
    }
}

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
