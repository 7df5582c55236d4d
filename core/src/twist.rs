//! What goes into a contact and what comes out: motion and load in the contact plane.

mod conversions;

use crate::real::Real;
use nalgebra::{Matrix3, Vector2};

/// Motion of a rigid patch in its plane: velocity of the centre and spin about the normal.
///
/// *Units*: length/time and 1/time. Positive spin turns the first axis towards the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<R: Real> {
    /// Sliding velocity of the patch centre.
    pub velocity: Vector2<R>,
    /// Angular velocity about the normal.
    pub spin: R,
}

/// Force and torque on a patch in its plane.
///
/// *Units*: force, and force × length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<R: Real> {
    /// Force at the patch centre.
    pub force: Vector2<R>,
    /// Torque about the normal.
    pub torque: R,
}

/// ∂(force, torque)/∂(velocity, spin), rows and columns in the order (x, y, normal).
pub type WrenchJacobian<R> = Matrix3<R>;

impl<R: Real> Twist<R> {
    /// A twist from its components.
    #[inline]
    pub fn new(x: R, y: R, spin: R) -> Self {
        Self {
            velocity: Vector2::new(x, y),
            spin,
        }
    }

    /// Sliding speed |v|, without overflow on the way. *Accuracy*: 2 ulp.
    #[inline]
    pub fn speed(&self) -> R {
        self.velocity.x.hypot(self.velocity.y)
    }
}

impl<R: Real> Wrench<R> {
    /// No force and no torque.
    pub const ZERO: Self = Self {
        force: Vector2::new(R::ZERO, R::ZERO),
        torque: R::ZERO,
    };
}

#[cfg(feature = "defmt")]
mod logging {
    use super::{Real, Twist, Wrench};

    impl<R: Real + defmt::Format> defmt::Format for Twist<R> {
        fn format(&self, f: defmt::Formatter) {
            defmt::write!(
                f,
                "twist [{}, {}; {}]",
                self.velocity.x,
                self.velocity.y,
                self.spin
            );
        }
    }

    impl<R: Real + defmt::Format> defmt::Format for Wrench<R> {
        fn format(&self, f: defmt::Formatter) {
            defmt::write!(
                f,
                "wrench [{}, {}; {}]",
                self.force.x,
                self.force.y,
                self.torque
            );
        }
    }
}
