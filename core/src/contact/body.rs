//! The bodies of a contact: a sphere that moves freely, or a plate.

use super::vector::{add_scaled, zero};
use crate::real::Real;
use nalgebra::Vector3;

/// A rigid body, as far as contacts are concerned.
///
/// *Units*: any consistent set; inverse masses in 1/mass, inverse inertias in 1/(mass·length²).
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{ContactBody, WallBody, SphereBody};
/// let still = Vector3::new(0.0, 0.0, 0.0);
/// let mut ball = SphereBody { velocity: still, spin: still, inv_mass: 2.0, inv_inertia: 500.0 };
/// let mut wall = WallBody { velocity: still, inv_mass: 0.0 };
/// // An impulse and its opposite, in N s.
/// let (kick, normal) = (Vector3::new(0.0, 0.3, 0.4), Vector3::new(0.0, 0.0, 1.0));
/// ball.apply_impulse(1.0, &kick, 0.4, &normal);
/// wall.apply_impulse(-1.0, &kick, 0.4, &normal);
/// assert_eq!(ball.velocity(), kick * 2.0); // m/s
/// assert_eq!(wall.velocity(), still);
/// ball.apply_angular_impulse(1.0, &Vector3::new(0.0, 0.0, 0.01)); // N m s
/// assert_eq!(ball.angular_velocity().z, 0.01 * 500.0); // rad/s
/// ```
pub trait ContactBody<R: Real> {
    /// Velocity of the centre.
    fn velocity(&self) -> Vector3<R>;
    /// Angular velocity.
    fn angular_velocity(&self) -> Vector3<R>;
    /// Change of its velocity by a unit impulse along the normal.
    fn inv_mass_normal(&self) -> R;
    /// Change of its velocity by a unit impulse in the contact plane.
    fn inv_mass_tangential(&self) -> R;
    /// Change of its angular velocity by a unit angular impulse.
    fn inv_inertia(&self) -> R;
    /// Applies `sign` times an impulse at the centre; `along` is its component along `normal`.
    fn apply_impulse(&mut self, sign: R, impulse: &Vector3<R>, along: R, normal: &Vector3<R>);
    /// Applies `factor` times an angular impulse.
    fn apply_angular_impulse(&mut self, factor: R, angular: &Vector3<R>);
}

/// A sphere, free in all six directions. Infinite mass is an inverse of 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereBody<R> {
    /// Velocity of the centre.
    pub velocity: Vector3<R>,
    /// Angular velocity.
    pub spin: Vector3<R>,
    /// 1/m.
    pub inv_mass: R,
    /// 1/I about any axis through the centre.
    pub inv_inertia: R,
}

/// A plate that impulses move only along its normal: a wall (inverse mass 0) or a piston.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallBody<R> {
    /// Velocity. Its component in the plane is prescribed and does not change by impulses.
    pub velocity: Vector3<R>,
    /// 1/m, 0 for a wall.
    pub inv_mass: R,
}

impl<R: Real> ContactBody<R> for SphereBody<R> {
    #[inline(always)]
    fn velocity(&self) -> Vector3<R> {
        self.velocity
    }
    #[inline(always)]
    fn angular_velocity(&self) -> Vector3<R> {
        self.spin
    }
    #[inline(always)]
    fn inv_mass_normal(&self) -> R {
        self.inv_mass
    }
    #[inline(always)]
    fn inv_mass_tangential(&self) -> R {
        self.inv_mass
    }
    #[inline(always)]
    fn inv_inertia(&self) -> R {
        self.inv_inertia
    }
    #[inline(always)]
    fn apply_impulse(&mut self, sign: R, impulse: &Vector3<R>, _: R, _: &Vector3<R>) {
        self.velocity = add_scaled(&self.velocity, sign * self.inv_mass, impulse);
    }
    #[inline(always)]
    fn apply_angular_impulse(&mut self, factor: R, angular: &Vector3<R>) {
        self.spin = add_scaled(&self.spin, factor * self.inv_inertia, angular);
    }
}

impl<R: Real> ContactBody<R> for WallBody<R> {
    #[inline(always)]
    fn velocity(&self) -> Vector3<R> {
        self.velocity
    }
    #[inline(always)]
    fn angular_velocity(&self) -> Vector3<R> {
        zero()
    }
    #[inline(always)]
    fn inv_mass_normal(&self) -> R {
        self.inv_mass
    }
    #[inline(always)]
    fn inv_mass_tangential(&self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn inv_inertia(&self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn apply_impulse(&mut self, sign: R, _: &Vector3<R>, along: R, normal: &Vector3<R>) {
        self.velocity = add_scaled(&self.velocity, sign * self.inv_mass * along, normal);
    }
    #[inline(always)]
    fn apply_angular_impulse(&mut self, _: R, _: &Vector3<R>) {}
}
