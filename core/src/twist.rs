//! Planar twists and wrenches: motion and load in the contact plane.

mod conversions;

use crate::real::Real;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};
use nalgebra::{Matrix3, Vector2};

/// Motion of a rigid patch in its plane: velocity of the centre and spin about the normal.
///
/// *Units*: length/time and 1/time. Positive spin turns the first axis towards the second.
///
/// ```
/// use tribos_core::{Twist, nalgebra::Vector2};
/// let puck = Twist::new(3.0_f64, 4.0, 20.0); // m/s, m/s, rad/s
/// assert!((puck.speed() - 5.0).abs() < 2e-15);
/// let from_the_turntable = puck - Twist::new(0.0, 0.0, 3.5);
/// assert_eq!(from_the_turntable.spin, 16.5);
/// // One point is at rest, a speed over spin away from the centre and across the velocity.
/// let at = |x: f64, y: f64| puck.velocity + Vector2::new(-y, x) * puck.spin;
/// assert!(at(-4.0 / 20.0, 3.0 / 20.0).amax() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Twist<R: Real> {
    /// Sliding velocity of the patch centre.
    pub velocity: Vector2<R>,
    /// Angular velocity about the normal.
    pub spin: R,
}

/// Force and torque on a patch in its plane.
///
/// *Units*: force, and force × length.
///
/// ```
/// use tribos_core::prelude::*;
/// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?; // mu, radius in m
/// let twist = Twist::new(1.0, 0.0, 20.0); // m/s, m/s, rad/s
/// let friction = puck.wrench(1.7, &twist); // load in N
/// assert!(friction.power(&twist) < 0.0); // in W: friction dissipates
/// let push = Wrench::new(0.2, 0.0, 0.001); // N, N, N m
/// assert_eq!((push + friction).force.x, 0.2 + friction.force.x);
/// assert_eq!(puck.wrench(0.0, &twist), Wrench::ZERO); // without load
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<R: Real> {
    /// Force at the patch centre.
    pub force: Vector2<R>,
    /// Torque about the normal.
    pub torque: R,
}

/// Displacement of a rigid patch in its plane: of its centre, and about the normal.
///
/// *Units*: length, and radians. A wrench does the work F·shift + T turn along it.
///
/// ```
/// use tribos_core::twist::{Displacement, Twist, Wrench};
/// let moved = Displacement::along(&Twist::new(0.5_f64, 0.0, 4.0), 0.25); // m/s, rad/s; s
/// assert_eq!(moved, Displacement::new(0.125, 0.0, 1.0)); // m, rad
/// assert_eq!(moved.work(&Wrench::new(-8.0, 0.0, -0.5)), -1.5); // N, N m; J
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement<R: Real> {
    /// Displacement of the patch centre.
    pub shift: Vector2<R>,
    /// Angle about the normal.
    pub turn: R,
}

/// ∂(force, torque)/∂(velocity, spin), rows and columns in the order (x, y, normal).
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
/// use tribos_core::twist::{Twist, WrenchJacobian};
/// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?; // mu, radius in m
/// let twist = Twist::new(1.0, 0.5, 20.0);
/// let jacobian: WrenchJacobian<f64> = puck.wrench_jacobian(1.7, &twist);
/// // Symmetric, as second derivatives are; and twice as fast meets the same dry friction.
/// assert!((jacobian - jacobian.transpose()).amax() < 1e-15);
/// assert!((jacobian * Vector3::from(twist)).amax() < 1e-12);
/// # Ok::<(), tribos_core::Error>(())
/// ```
pub type WrenchJacobian<R> = Matrix3<R>;

impl<R: Real> Twist<R> {
    /// Sliding speed |v|, without overflow on the way. *Accuracy*: 2 ulp.
    #[inline]
    pub fn speed(&self) -> R {
        self.velocity.x.hypot(self.velocity.y)
    }
}

impl<R: Real> Wrench<R> {
    /// Power of this wrench on a body that moves with `twist`: F·v + T ω. Friction's is negative.
    ///
    /// *Units*: force × length/time. *Accuracy*: three rounded products and two rounded sums.
    #[inline(always)]
    pub fn power(&self, twist: &Twist<R>) -> R {
        self.force.x * twist.velocity.x + self.force.y * twist.velocity.y + self.torque * twist.spin
    }
}

impl<R: Real> Displacement<R> {
    /// What a patch that moves with `twist` does in the time `dt`.
    #[inline(always)]
    pub fn along(twist: &Twist<R>, dt: R) -> Self {
        Self::new(
            twist.velocity.x * dt,
            twist.velocity.y * dt,
            twist.spin * dt,
        )
    }

    /// Work of a constant `wrench` along it: F·shift + T turn.
    ///
    /// *Units*: force × length. *Accuracy*: three rounded products and two rounded sums.
    #[inline(always)]
    pub fn work(&self, wrench: &Wrench<R>) -> R {
        wrench.force.x * self.shift.x + wrench.force.y * self.shift.y + wrench.torque * self.turn
    }
}

/// Constructor, zero and arithmetic of a planar vector with a component about the normal.
macro_rules! planar_vector {
    ($name:ident, $planar:ident, $normal:ident) => {
        impl<R: Real> $name<R> {
            /// All components zero.
            pub const ZERO: Self = Self {
                $planar: Vector2::new(R::ZERO, R::ZERO),
                $normal: R::ZERO,
            };

            /// From the two components in the plane and the one about the normal.
            #[inline(always)]
            pub const fn new(x: R, y: R, $normal: R) -> Self {
                Self {
                    $planar: Vector2::new(x, y),
                    $normal,
                }
            }
        }

        impl<R: Real> Add for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self {
                    $planar: self.$planar + other.$planar,
                    $normal: self.$normal + other.$normal,
                }
            }
        }

        impl<R: Real> Sub for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self {
                    $planar: self.$planar - other.$planar,
                    $normal: self.$normal - other.$normal,
                }
            }
        }

        impl<R: Real> Neg for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self {
                    $planar: -self.$planar,
                    $normal: -self.$normal,
                }
            }
        }

        impl<R: Real> Mul<R> for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: R) -> Self {
                Self {
                    $planar: self.$planar * factor,
                    $normal: self.$normal * factor,
                }
            }
        }

        impl<R: Real> AddAssign for $name<R> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<R: Real> SubAssign for $name<R> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}

planar_vector!(Twist, velocity, spin);
planar_vector!(Wrench, force, torque);
planar_vector!(Displacement, shift, turn);
