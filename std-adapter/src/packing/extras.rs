//! What some bodies have beside material and walls: a shear, a second material.

use super::Material;
use nalgebra::Vector3;

/// A shear and a second material, of which most bodies have neither.
#[derive(Clone, Debug, Default)]
pub(crate) struct Extras {
    /// Rate of a simple shear, velocity along x over height along z.
    pub shear_rate: f64,
    pub second: Option<Second>,
    /// Velocities at the start, beside that of the shear; none if there are fewer than spheres.
    pub velocities: Vec<Vector3<f64>>,
}

/// A second material among the spheres.
#[derive(Clone, Debug)]
pub(crate) struct Second {
    /// One flag a sphere, true if it is of the second material.
    pub is_second: Vec<bool>,
    pub material: Material,
    /// What holds between spheres of the two; its density has no meaning.
    pub mixed: Material,
}

impl Extras {
    /// Density of a sphere.
    pub fn density(&self, first: &Material, sphere: usize) -> f64 {
        let second = self.second.as_ref();
        let of = second.filter(|second| second.is_second.get(sphere) == Some(&true));
        of.map_or(first.density, |second| second.material.density)
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
