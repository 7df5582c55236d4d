//! What a packing of grains is made of: material, bodies and method of its scene.

use super::error::GrainsError;
use super::layout::Layout;
use super::loads::Loads;
use super::placement::Start;
use super::wall::InitialWall;
use crate::grains::scene::GrainsScene;
use crate::packing::method::ContactMethod;
use crate::packing::{
    Bodies, Material, Method, OptionalFeatures, Packing, SecondMaterial, SecondMaterialKeys,
    Springs, WorldSnapshot, build_with,
};
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_base::random::Random;
use tribos_contacts::cd::{ContactSolver, SolverMethod as Sweeps, StepLimits, Wall};

/// Stream of the seed for the velocities of a sheared box.
const VELOCITIES: u64 = 3;
/// A share of the duration that no step exceeds.
const STEPS: f64 = 100.0;

/// The packing of a scene, at its start or from a stored state.
pub(super) fn packing(
    scene: &GrainsScene,
    (layout, loads): (&Layout, &Loads),
    start: Start,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, GrainsError> {
    let material = scene.material();
    let extras = OptionalFeatures {
        shear_rate: scene.shear_rate.unwrap_or(0.0),
        second: SecondMaterial::beside(&material, &scene.differences(), start.kinds.is_second()),
        densities: start.kinds.densities,
        velocities: scene.agitation(start.radii.len()),
    };
    let mass = scene.piston_mass.unwrap_or_else(|| {
        let grains = start.radii.iter().enumerate();
        grains
            .map(|(grain, radius)| extras.density(&material, grain) * volume(*radius))
            .sum()
    });
    let wall = |(wall, part): (usize, &InitialWall)| {
        let mass = if loads.is_piston(wall) {
            mass
        } else {
            f64::INFINITY
        };
        Wall {
            edges: part.edges,
            ..Wall::piston(part.inward, part.place, mass, 0.0)
        }
    };
    let bodies = Bodies {
        space: layout.space,
        positions: start.positions,
        radii: start.radii,
        walls: layout.parts.iter().enumerate().map(wall).collect(),
        gravity: loads.gravity(0.0),
    };
    let method = scene.contact_method();
    let mut packing = build_with(&material, (bodies, &extras), &method, frozen)?;
    // A stored state has its walls where they were.
    if frozen.is_none() {
        loads.apply(layout, &mut *packing);
    }
    Ok(packing)
}

/// Volume of a sphere.
pub(super) fn volume(radius: f64) -> f64 {
    4.0 / 3.0 * PI * radius * radius * radius
}

impl GrainsScene {
    /// How the contacts of a step are found and solved.
    pub(super) fn contact_method(&self) -> Method {
        let step_limits = StepLimits {
            motion: self.max_displacement * self.radius,
            longest: self.longest_step(),
        };
        match self.method {
            ContactMethod::ContactDynamics => Method::ContactDynamics {
                solver: ContactSolver {
                    method: Sweeps::Accelerated {
                        tolerance: self.tolerance,
                    },
                    most_sweeps: self.max_iterations,
                    warm_start: true,
                },
                step_limits,
                // Gravity and walls change in time, which would not wake grains that sleep.
                still_speed: 0.0,
            },
            ContactMethod::Soft => Method::Soft(Springs {
                stiffness: self.spring(),
                damping: self.damping_ratio,
                steps_per_collision: self.steps_per_collision,
                step_limits,
            }),
        }
    }

    /// Random velocities of a sheared box, of the rate times the radius and without momentum: the places of the
    /// start lie in layers, which would pass each other.
    fn agitation(&self, count: usize) -> Vec<Vector3<f64>> {
        let Some(rate) = self.shear_rate else {
            return Vec::new();
        };
        let mut random = Random::new(self.seed, VELOCITIES);
        let mut part = || rate * self.radius * (2.0 * random.unit() - 1.0);
        let flat = self.is_flat();
        let mut all: Vec<_> = (0..count)
            .map(|_| Vector3::new(part(), if flat { 0.0 } else { part() }, part()))
            .collect();
        let mean = all.iter().sum::<Vector3<f64>>() / count.max(1) as f64;
        all.iter_mut().for_each(|velocity| *velocity -= mean);
        all
    }

    /// Longest time step.
    pub(super) fn longest_step(&self) -> f64 {
        let [_, strongest] = self.gravity.range();
        let fall = (2.0 * self.max_displacement * self.radius / strongest).sqrt();
        let longest = fall.min(self.duration / STEPS);
        self.max_time_step.unwrap_or(longest)
    }

    /// What the second material has of its own.
    pub(super) fn differences(&self) -> SecondMaterialKeys {
        SecondMaterialKeys {
            density: self.second_density,
            sliding: self.mu_second,
            sliding_mixed: self.mu_mixed,
        }
    }

    /// The material of the grains.
    #[doc(hidden)]
    pub fn material(&self) -> Material {
        Material {
            density: self.density,
            cohesion: self.cohesion,
            cohesion_range: self.cohesion_range,
            attraction: self.attraction,
            restitution: self.restitution,
            sliding: self.mu,
            rolling: self.mu_rolling,
            torsion: self.mu_torsion,
            coupling: self.coupling,
            wall: self.wall_contact,
        }
    }
}
