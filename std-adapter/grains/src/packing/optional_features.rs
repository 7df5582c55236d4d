//! What some bodies have beside material and walls: a shear, a second material, spheres that no force moves, a mesh.

use super::Material;
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_contacts::cd::{CellControl, MovingMesh, solid};
use tribos_core::contact::SphereBody;

/// What most bodies have nothing of.
#[derive(Clone, Debug, Default)]
pub struct OptionalFeatures {
    /// Rate of a simple shear, velocity along x over height along z.
    pub shear_rate: f64,
    /// How the periodic box is deformed.
    pub cell: Option<CellControl>,
    pub second: Option<SecondMaterial>,
    /// Densities of the spheres; those of the material if there are none.
    pub densities: Vec<f64>,
    /// Velocities at the start, beside that of the shear; none if there are fewer than spheres.
    pub velocities: Vec<Vector3<f64>>,
    /// Spheres that no force moves, in ascending order.
    pub bound: Vec<usize>,
    /// A wall of triangles.
    pub mesh: Option<MovingMesh>,
}

/// A second material among the spheres.
#[derive(Clone, Debug)]
pub struct SecondMaterial {
    /// One flag a sphere, true if it is of the second material.
    pub is_second: Vec<bool>,
    /// Its law; spheres have their own densities.
    pub material: Material,
    /// What holds between spheres of the two.
    pub mixed: Material,
}

/// Stream of a seed for the spheres of the second material.
const STREAM: u64 = 2;

/// What a scene says of its second material; what it leaves out is that of the first, and between the two the
/// geometric mean.
#[derive(Clone, Copy, Debug)]
pub struct SecondMaterialKeys {
    pub density: Option<f64>,
    pub sliding: Option<f64>,
    pub sliding_mixed: Option<f64>,
}

impl SecondMaterial {
    /// Which of so many spheres are of the second material: a share of all, each choice as likely (Knuth's
    /// algorithm S).
    pub fn choose(seed: u64, share: f64, count: usize) -> Vec<bool> {
        let mut random = Random::new(seed, STREAM);
        let mut needed = (share * count as f64).round();
        let mut choose = |index: usize| {
            let is = needed > 0.0 && random.unit() * ((count - index) as f64) < needed;
            needed -= f64::from(u8::from(is));
            is
        };
        (0..count).map(&mut choose).collect()
    }

    /// The second material beside a first one; `None` if there is no sphere of it, or if its law is the first's.
    pub fn beside(
        first: &Material,
        other: &SecondMaterialKeys,
        is_second: Vec<bool>,
    ) -> Option<Self> {
        let sliding = other.sliding.unwrap_or(first.sliding);
        let mean = (first.sliding * sliding).sqrt();
        let is_other = other.sliding.is_some() || other.sliding_mixed.is_some();
        (is_other && is_second.contains(&true)).then(|| Self {
            is_second,
            material: Material { sliding, ..*first },
            mixed: Material {
                sliding: other.sliding_mixed.unwrap_or(mean),
                ..*first
            },
        })
    }
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
        let Some(second) = &self.second else {
            return *first;
        };
        let most =
            |of: fn(&Material) -> f64| of(first).max(of(&second.material)).max(of(&second.mixed));
        Material {
            sliding: most(|material| material.sliding),
            rolling: most(|material| material.rolling),
            torsion: most(|material| material.torsion),
            ..*first
        }
    }
}
