//! What some bodies have beside material and walls: a shear, other materials, spheres that no force moves, a mesh.

use super::{Material, Mixture};
use nalgebra::Vector3;
use tribos_contacts::cd::{CellControl, MovingMesh, solid};
use tribos_core::contact::SphereBody;

/// What most bodies have nothing of.
#[derive(Clone, Debug, Default)]
pub struct OptionalFeatures {
    /// Rate of a simple shear, velocity along x over height along z.
    pub shear_rate: f64,
    /// How the periodic box is deformed.
    pub cell: Option<CellControl>,
    /// Materials with the index of that of each sphere, if they obey several laws.
    pub mixture: Option<(Mixture, Vec<u8>)>,
    /// Densities of the spheres; those of the material if there are none.
    pub densities: Vec<f64>,
    /// Velocities at the start, beside that of the shear; none if there are fewer than spheres.
    pub velocities: Vec<Vector3<f64>>,
    /// Spheres that no force moves, in ascending order.
    pub bound: Vec<usize>,
    /// A wall of triangles.
    pub mesh: Option<MovingMesh>,
}

impl OptionalFeatures {
    /// Density of a sphere.
    pub fn density(&self, first: &Material, sphere: usize) -> f64 {
        self.densities.get(sphere).copied().unwrap_or(first.density)
    }

    /// The spheres at rest.
    pub fn spheres(&self, first: &Material, radii: &[f64]) -> Vec<SphereBody<f64>> {
        let radii = radii.iter().enumerate();
        let mut spheres: Vec<_> = radii
            .map(|(i, &r)| solid(r, self.density(first, i)))
            .collect();
        for &sphere in &self.bound {
            (spheres[sphere].inv_mass, spheres[sphere].inv_inertia) = (0.0, 0.0);
        }
        spheres
    }

    /// The largest coefficients of any two spheres: which modes the contacts carry.
    pub fn widest(&self, first: &Material) -> Material {
        let mixture = self.mixture.as_ref();
        mixture.map_or(*first, |(mixture, _)| mixture.widest())
    }
}
