//! What updates of contacts cost, measured, and how long stable steps of springs are.

use super::{
    Bodies, Component, ContactKeys, Material, Method, Mixture, ModeSet, OptionalFeatures, Packing,
    PackingRunError, Springs, build_with,
};
use crate::packing::method::FrictionCoupling;
use nalgebra::Vector3;
use std::time::Instant;
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::{
    ContactSolver, IterationOrder, SolverMethod, StepLimits, StopRule, Wall, solid,
};
use tribos_contacts::soft::{self, StepLength};
use tribos_core::contact::{Cohesion, SphereBody};

/// Memory of a run per sphere, in bytes, including contacts, neighbours and exports: measured with
/// 3,000 and 12,000 spheres.
pub(crate) const BYTES_A_SPHERE: f64 = 5e3;
/// Time of a stable step of soft contacts per sphere, in s.
pub(crate) const SOFT_SECONDS: f64 = 0.25e-6;
/// Spheres along an edge of the block whose updates are timed, and their distance in radii, slightly less than a
/// diameter.
const EDGE: usize = 6;
const SPACING: f64 = 2.0 - 1e-6;
/// Shear of the block per layer in radii, which mixes normals and tangents.
const SHEAR: f64 = 0.05;
/// Sweeps of its step, so that the rest of the step is negligible.
const SWEEPS: usize = 50;
/// Sliding coefficient of a comparison with spheres without one: a dry friction coefficient.
const USUAL: f64 = 0.3;

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
    /// Counts unknowns, and times updates in a small block of spheres of the mean radius under a usual force of
    /// contacts; `contacts_a_sphere` are the usual contacts of a sphere.
    pub(crate) fn measured(
        keys: &ContactKeys,
        usual: (f64, f64),
        spheres: usize,
        contacts_a_sphere: impl Fn(ModeSet) -> [f64; 2],
    ) -> Result<Self, PackingRunError> {
        let material = keys.mixture.widest();
        // The same coefficient, or the usual one for smooth spheres.
        let plain = Material {
            sliding: if material.sliding > 0.0 {
                material.sliding
            } else {
                USUAL
            },
            rolling: 0.0,
            torsion: 0.0,
            coupling: FrictionCoupling::Independent,
            ..material
        };
        let blocks = [&material, &plain].map(|material| || block(material, &keys.method, usual));
        let [update_seconds, sliding_seconds] = update_seconds(blocks)?;
        let modes = material.carried().modes;
        let contacts = |share: f64| (share * spheres as f64).round() as usize;
        Ok(Self {
            spheres,
            contacts: contacts_a_sphere(modes).map(contacts),
            unknowns: modes.unknowns(),
            bytes: match keys.method {
                Method::ContactDynamics { .. } => modes.bytes(),
                Method::Soft(_) => modes.soft_bytes(),
            },
            update_seconds,
            sliding_seconds,
        })
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

/// Time of an update of a contact in each of two packings: the minimum over alternating rounds.
fn update_seconds(
    packings: [impl Fn() -> Result<Box<dyn Packing>, PackingRunError>; 2],
) -> Result<[f64; 2], PackingRunError> {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        for (packing, least) in packings.iter().zip(&mut least) {
            let mut packing = packing()?;
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

/// A block of equal spheres between a floor and a piston that presses each column with a force: each sphere touches
/// six others, walls included.
fn spheres(density: f64, (radius, force): (f64, f64)) -> Bodies {
    let width = EDGE as f64 * SPACING;
    let rise = (SPACING * SPACING - 2.0 * SHEAR * SHEAR).sqrt();
    let at = |index: usize| {
        let place = [index % EDGE, index / EDGE % EDGE, index / (EDGE * EDGE)];
        let [x, y, z] = place.map(|i| i as f64);
        let aside = |x: f64| (x * SPACING + z * SHEAR).rem_euclid(width);
        radius * Vector3::new(aside(x), aside(y), 1.0 + z * rise)
    };
    let (count, columns) = (EDGE.pow(3), EDGE.pow(2));
    let height = 2.0 + (EDGE - 1) as f64 * rise;
    let mass = count as f64 / solid(radius, density).inv_mass;
    let side = Some(radius * width);
    Bodies {
        space: PeriodicBox::new([side, side, None]).unwrap_or_default(),
        positions: (0..count).map(at).collect(),
        radii: vec![radius; count],
        walls: vec![
            Wall::fixed(Vector3::z(), 0.0),
            Wall::piston(
                -Vector3::z(),
                -radius * height,
                mass,
                columns as f64 * force,
            ),
        ],
        gravity: Vector3::zeros(),
    }
}

/// The block under the laws of a scene; a step has a fixed number of sweeps, or is one stable step of springs.
fn block(
    material: &Material,
    method: &Method,
    (radius, force): (f64, f64),
) -> Result<Box<dyn Packing>, PackingRunError> {
    let method = match *method {
        Method::ContactDynamics { step_limits, .. } => Method::ContactDynamics {
            solver: ContactSolver {
                method: SolverMethod::GaussSeidel {
                    order: IterationOrder::Fixed,
                    stop: StopRule::Fixed,
                },
                most_sweeps: SWEEPS,
                warm_start: 0.0,
            },
            step_limits,
            still_speed: 0.0,
        },
        Method::Soft(springs) => {
            let stable = stable_step_between((&springs, material), (radius, force), (&[], &[]));
            Method::Soft(Springs {
                step_limits: StepLimits {
                    longest: springs.step_limits.longest.min(stable),
                    ..springs.step_limits
                },
                ..springs
            })
        }
    };
    build_with(
        material,
        (
            spheres(material.density, (radius, force)),
            &OptionalFeatures::default(),
        ),
        &method,
        None,
    )
}

/// Length of the stable steps of spheres at rest, of a smallest radius before that of their material and under a force:
/// the lightest under any law.
pub(crate) fn stable_step(springs: &Springs, mixture: &Mixture, radius: f64, force: f64) -> f64 {
    let least = |of: fn(&Component) -> f64| mixture.drawn().map(of).fold(f64::INFINITY, f64::min);
    let radius = radius * least(|component| component.radius);
    let density = least(|component| component.alike.density);
    let of = |law: &Material| {
        let law = Material { density, ..*law };
        stable_step_between((springs, &law), (radius, force), (&[], &[]))
    };
    mixture.all().map(of).fold(f64::INFINITY, f64::min)
}

/// The same under one law between walls, each with a number of spheres that touch it.
pub(crate) fn stable_step_between(
    (springs, material): (&Springs, &Material),
    (radius, force): (f64, f64),
    (walls, touching): (&[Wall], &[usize]),
) -> f64 {
    let sphere = solid(radius, material.density);
    let damping = if material.restitution > 0.0 {
        soft::Stiffness::damping_ratio_of(material.restitution)
    } else {
        springs.damping
    };
    let stiffness = material.stiffness;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grains::scene::GrainsScene;
    use crate::powder::scene::PowderScene;

    /// Contacts of the block: three per sphere and two walls; the top layer has no layer above it.
    const TOUCHING: usize = 3 * EDGE.pow(3) + EDGE.pow(2);

    #[test]
    fn a_block_under_any_laws_sweeps_all_of_its_contacts() {
        let powder = |keys: &str| {
            let text = format!("body = \"powder\"\nwidth = 6\nheight = 8\n{keys}");
            let scene = PowderScene::parse("tiny.toml", &text, &[]).unwrap();
            (scene.contact_keys(), 1.0)
        };
        let beads = GrainsScene::default();
        for (keys, radius) in [
            powder("mu = 0"),
            powder(""),
            powder("mu_rolling = 1\nmu_torsion = 1\ncoupling = \"exact\""),
            powder("cohesion_range = 0"),
            (beads.contact_keys(), beads.radius),
        ] {
            let mut block = block(keys.mixture.first(), &keys.method, (radius, 0.01)).unwrap();
            let report = block.step().unwrap();
            let found = (report.iterations.sweeps, report.contacts);
            assert_eq!(found, (SWEEPS, TOUCHING), "{keys:?}");
        }
    }

    #[test]
    fn every_sphere_of_the_block_touches_six_and_nothing_is_crushed() {
        for radius in [1.0, 0.0025] {
            let block = spheres(1.0, (radius, 0.01));
            let near = |gap: f64| (-1e-5 * radius..0.0).contains(&gap);
            let mut touching = 0;
            for (i, a) in block.positions.iter().enumerate() {
                for b in &block.positions[..i] {
                    let gap = block.space.displacement(a, b).norm() - 2.0 * radius;
                    assert!(gap > 0.1 * radius || near(gap), "{gap}");
                    touching += usize::from(near(gap));
                }
                let walls = block.walls.iter();
                let height = |wall: &Wall| wall.outward.dot(a) - wall.place;
                touching += walls
                    .filter(|wall| (height(wall) - radius).abs() < 1e-5 * radius)
                    .count();
            }
            assert_eq!(touching, TOUCHING);
        }
    }
}
