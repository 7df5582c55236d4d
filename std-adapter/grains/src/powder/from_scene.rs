//! What a scene of a powder says of its packing: kinds of spheres, material and method.

use crate::packing::method::ContactMethod;
use crate::packing::{ContactKeys, Kinds, Material, Method, Mixture, SecondMaterialKeys, Springs};
use crate::powder::scene::PowderScene;

impl PowderScene {
    /// Materials and densities of spheres that no file has.
    pub(super) fn kinds(&self, count: usize) -> Kinds {
        let mixture = self.mixture();
        Kinds::of(mixture.draw(self.seed, count), &mixture)
    }

    /// The material, and the second one.
    pub(crate) fn mixture(&self) -> Mixture {
        Mixture::of_two(
            self.material(),
            &SecondMaterialKeys {
                share: self.second_fraction,
                radius: 1.0,
                density: self.second_density,
                sliding: self.mu_second,
                sliding_mixed: self.mu_mixed,
            },
        )
    }

    /// The material of the spheres, in the units of the scene: cohesion and density are 1.
    #[doc(hidden)]
    pub fn material(&self) -> Material {
        Material {
            density: 1.0,
            cohesion: 1.0,
            cohesion_range: self.cohesion_range,
            attraction: self.attraction,
            restitution: self.restitution,
            sliding: self.mu,
            rolling: self.mu_rolling,
            torsion: self.mu_torsion,
            coupling: self.coupling,
            wall: self.wall_contact,
            stiffness: self.spring(),
        }
    }

    /// What the scene says of the contacts.
    pub(crate) fn contact_keys(&self) -> ContactKeys {
        ContactKeys {
            mixture: self.mixture(),
            method: self.contact_method(),
        }
    }

    /// How the contacts of a step are found and solved.
    pub(super) fn contact_method(&self) -> Method {
        match self.method {
            ContactMethod::ContactDynamics => Method::ContactDynamics {
                solver: self.contact_solver(),
                step_limits: self.step_limits(),
                still_speed: self.still_speed,
            },
            ContactMethod::Soft => Method::Soft(Springs {
                damping: self.damping_ratio,
                steps_per_collision: self.steps_per_collision,
                step_limits: self.step_limits(),
            }),
        }
    }
}
