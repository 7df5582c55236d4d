//! Pairs across the border of a sheared cell: the second sphere takes part as an image that moves relative
//! to it.

use nalgebra::Vector3;
use tribos_core::contact::{ContactBody, SphereBody};

/// An image among the second spheres of a list of pairs: number of the pair, and velocity of the image
/// relative to its sphere.
pub type ImageVelocity = (u32, Vector3<f64>);

/// Images of a list of pairs that is read in ascending order.
pub(super) struct Images<'a>(&'a [ImageVelocity]);

impl<'a> Images<'a> {
    /// *Domain*: ascending numbers of pairs.
    pub fn new(images: &'a [ImageVelocity]) -> Self {
        Self(images)
    }

    /// Velocity of the image of a pair relative to its sphere; `None` if the sphere itself takes part.
    #[inline]
    pub fn of(&mut self, pair: usize) -> Option<Vector3<f64>> {
        let ((at, velocity), rest) = self.0.split_first()?;
        if *at as usize != pair {
            return None;
        }
        self.0 = rest;
        Some(*velocity)
    }
}

/// The sphere, or its image if that moves relative to it.
#[inline]
pub(super) fn seen(sphere: &SphereBody<f64>, image: Option<Vector3<f64>>) -> SphereBody<f64> {
    match image {
        None => *sphere,
        Some(velocity) => SphereBody {
            velocity: sphere.velocity + velocity,
            ..*sphere
        },
    }
}

/// The image of a sphere: it moves faster by a velocity, and what pushes it pushes the sphere.
#[derive(Debug)]
pub(super) struct Image<'a> {
    pub sphere: &'a mut SphereBody<f64>,
    pub velocity: Vector3<f64>,
}

impl ContactBody<f64> for Image<'_> {
    fn velocity(&self) -> Vector3<f64> {
        self.sphere.velocity + self.velocity
    }
    fn angular_velocity(&self) -> Vector3<f64> {
        self.sphere.spin
    }
    fn inv_mass_normal(&self) -> f64 {
        self.sphere.inv_mass_normal()
    }
    fn inv_mass_tangential(&self) -> f64 {
        self.sphere.inv_mass_tangential()
    }
    fn inv_inertia(&self) -> f64 {
        self.sphere.inv_inertia
    }
    fn apply_impulse(
        &mut self,
        sign: f64,
        impulse: &Vector3<f64>,
        along: f64,
        normal: &Vector3<f64>,
    ) {
        self.sphere.apply_impulse(sign, impulse, along, normal);
    }
    fn apply_angular_impulse(&mut self, factor: f64, angular: &Vector3<f64>) {
        self.sphere.apply_angular_impulse(factor, angular);
    }
}
