//! What a scene of grains says of its packing: material, method, steps and first velocities.

use crate::grains::scene::GrainsScene;
pub(super) use crate::packing::export::volume;
use crate::packing::method::ContactMethod;
use crate::packing::{ContactKeys, Material, Method, Springs};
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_contacts::cd::{ContactSolver, SolverMethod as Sweeps, StepLimits};

/// Stream of the seed for the velocities of a sheared box.
const VELOCITIES: u64 = 3;
/// A share of the duration that no step exceeds.
const STEPS: f64 = 100.0;

impl GrainsScene {
    /// What the scene says of the contacts.
    pub(crate) fn contact_keys(&self) -> ContactKeys {
        ContactKeys {
            mixture: self.mixture(),
            method: self.contact_method(),
        }
    }

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
                    warm_start: 1.0,
                },
                step_limits,
                // Gravity and walls change in time, which would not wake grains that sleep.
                still_speed: 0.0,
            },
            ContactMethod::Soft => Method::Soft(Springs {
                damping: self.damping_ratio,
                steps_per_collision: self.steps_per_collision,
                step_limits,
            }),
        }
    }

    /// Random velocities of a sheared box, of the rate times the radius and without momentum: the places of the
    /// start lie in layers, which would pass each other.
    pub(super) fn agitation(&self, count: usize) -> Vec<Vector3<f64>> {
        let Some(rate) = self.sheared() else {
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
    #[doc(hidden)]
    pub fn longest_step(&self) -> f64 {
        let [_, strongest] = self.gravity.range();
        let fall = (2.0 * self.max_displacement * self.radius / strongest).sqrt();
        let longest = fall.min(self.duration / STEPS);
        self.max_time_step.unwrap_or(longest)
    }

    /// The first material of the grains.
    #[doc(hidden)]
    pub fn material(&self) -> Material {
        *self.mixture().first()
    }
}
