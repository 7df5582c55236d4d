//! Spheres and plates in one list.

use crate::contact::{ContactBody, SphereBody, WallBody};
use crate::real::Real;
use nalgebra::Vector3;

/// A body of a manifold.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{ContactBody, WallBody, SphereBody};
/// use tribos_core::manifold::SystemBody;
/// let still = Vector3::new(0.0, 0.0, 0.0);
/// let ball = SphereBody { velocity: still, spin: still, inv_mass: 5.0, inv_inertia: 5000.0 };
/// let piston = WallBody { velocity: still, inv_mass: 0.1 };
/// // Pushed along the normal both give way; across it the piston is guided.
/// let members = [SystemBody::Sphere(ball), SystemBody::Plate(piston)];
/// assert_eq!(members.map(|body| body.inv_mass_normal()), [5.0, 0.1]);
/// assert_eq!(members.map(|body| body.inv_mass_tangential()), [5.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SystemBody<R> {
    /// Moves freely.
    Sphere(SphereBody<R>),
    /// Moves along its normal alone.
    Plate(WallBody<R>),
}

/// A body with what acts on it from outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoadedBody<R> {
    pub member: SystemBody<R>,
    pub force: Vector3<R>,
    pub torque: Vector3<R>,
}

impl<R: Real> LoadedBody<R> {
    pub fn new(member: SystemBody<R>) -> Self {
        let zero = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
        Self {
            member,
            force: zero,
            torque: zero,
        }
    }

    /// Lets gravity and the outer force act for a time.
    pub fn accelerate(&mut self, gravity: &Vector3<R>, dt: R) {
        match &mut self.member {
            SystemBody::Sphere(sphere) => {
                sphere.velocity += self.force * (sphere.inv_mass * dt);
                sphere.spin += self.torque * (sphere.inv_inertia * dt);
                if sphere.inv_mass != R::ZERO {
                    sphere.velocity += gravity * dt;
                }
            }
            SystemBody::Plate(plate) => plate.velocity += self.force * (plate.inv_mass * dt),
        }
    }

    /// A bound of the acceleration by gravity and the outer force: the sums of their components.
    pub fn most_acceleration(&self, gravity: &Vector3<R>) -> R {
        let sum = |v: &Vector3<R>| v.x.abs() + v.y.abs() + v.z.abs();
        let falls =
            matches!(&self.member, SystemBody::Sphere(sphere) if sphere.inv_mass != R::ZERO);
        let pushed = sum(&self.force) * self.member.inv_mass_normal();
        if falls { pushed + sum(gravity) } else { pushed }
    }
}

impl<R: Real> ContactBody<R> for SystemBody<R> {
    #[inline]
    fn velocity(&self) -> Vector3<R> {
        match self {
            Self::Sphere(sphere) => sphere.velocity(),
            Self::Plate(plate) => plate.velocity(),
        }
    }
    #[inline]
    fn angular_velocity(&self) -> Vector3<R> {
        match self {
            Self::Sphere(sphere) => sphere.angular_velocity(),
            Self::Plate(plate) => plate.angular_velocity(),
        }
    }
    #[inline]
    fn inv_mass_normal(&self) -> R {
        match self {
            Self::Sphere(sphere) => sphere.inv_mass_normal(),
            Self::Plate(plate) => plate.inv_mass_normal(),
        }
    }
    #[inline]
    fn inv_mass_tangential(&self) -> R {
        match self {
            Self::Sphere(sphere) => sphere.inv_mass_tangential(),
            Self::Plate(plate) => plate.inv_mass_tangential(),
        }
    }
    #[inline]
    fn inv_inertia(&self) -> R {
        match self {
            Self::Sphere(sphere) => sphere.inv_inertia(),
            Self::Plate(plate) => plate.inv_inertia(),
        }
    }
    #[inline(always)]
    fn apply_impulse(&mut self, sign: R, impulse: &Vector3<R>, along: R, normal: &Vector3<R>) {
        match self {
            Self::Sphere(sphere) => sphere.apply_impulse(sign, impulse, along, normal),
            Self::Plate(plate) => plate.apply_impulse(sign, impulse, along, normal),
        }
    }
    #[inline(always)]
    fn apply_angular_impulse(&mut self, factor: R, angular: &Vector3<R>) {
        match self {
            Self::Sphere(sphere) => sphere.apply_angular_impulse(factor, angular),
            Self::Plate(plate) => plate.apply_angular_impulse(factor, angular),
        }
    }
}
