//! What a compaction's packing is made of: material, bodies and method of its scene.

use super::deposit::{Deposit, SUBSTRATE};
use crate::packing::method::ContactMethod;
use crate::packing::{
    Bodies, Kinds, Material, Method, OptionalFeatures, Packing, PackingError, SecondMaterial,
    SecondMaterialKeys, Springs, WorldSnapshot, build_with,
};
use crate::powder::scene::PowderScene;
use nalgebra::Vector3;
use tribos_contacts::cd::Wall;

/// Number of the piston among the walls.
///
/// ```
/// use tribos::powder::{PowderSimulation, PISTON};
/// use tribos::record::Partner;
/// use tribos::run::run_to_end;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// // In a packing that is blocked the spheres below the piston bear its load.
/// let mut compaction = PowderSimulation::new(&scene)?;
/// run_to_end(&mut compaction, |_, _| ())?;
/// let below = compaction.contacts().iter().filter(|row| row.b == Partner::Wall(PISTON));
/// let force: f64 = below.map(|row| row.force.z).sum();
/// assert!((force / scene.load() - 1.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const PISTON: u32 = 1;

const _: () = assert!(SUBSTRATE == 0 && PISTON == 1);

/// The packing of a scene, at its start or from a stored state.
pub(super) fn packing(
    scene: &PowderScene,
    (deposit, kinds): (&Deposit, &Kinds),
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingError> {
    let material = scene.material();
    let extras = OptionalFeatures {
        second: SecondMaterial::beside(&material, &scene.differences(), kinds.is_second()),
        densities: kinds.densities.clone(),
        ..OptionalFeatures::default()
    };
    let bodies = (bodies(scene, deposit), &extras);
    build_with(&material, bodies, &scene.contact_method(), frozen)
}

/// The deposit between substrate and piston.
fn bodies(scene: &PowderScene, deposit: &Deposit) -> Bodies {
    let up = Vector3::z();
    Bodies {
        space: deposit.space,
        positions: deposit.positions.clone(),
        radii: deposit.radii.clone(),
        // The order of SUBSTRATE and PISTON.
        walls: vec![
            Wall::fixed(up, 0.0),
            Wall::piston(-up, -deposit.height, scene.piston_mass, scene.load()),
        ],
        // Not -0.0 without gravity.
        gravity: Vector3::new(0.0, 0.0, 0.0 - scene.gravity),
    }
}

impl PowderScene {
    /// Materials and densities of spheres that no file has.
    pub(super) fn kinds(&self, count: usize) -> Kinds {
        let is_second = SecondMaterial::choose(self.seed, self.second_fraction, count);
        Kinds::of(&is_second, &self.material(), &self.differences())
    }

    /// What the second material has of its own.
    pub(super) fn differences(&self) -> SecondMaterialKeys {
        SecondMaterialKeys {
            density: self.second_density,
            sliding: self.mu_second,
            sliding_mixed: self.mu_mixed,
        }
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
                stiffness: self.spring(),
                damping: self.damping_ratio,
                steps_per_collision: self.steps_per_collision,
                step_limits: self.step_limits(),
            }),
        }
    }
}
