//! What goes into a contact and what comes out: motion and load in the contact plane.

use crate::real::Real;
use nalgebra::{Matrix3, Vector2, Vector3};

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

impl<R: Real> From<Vector3<R>> for Twist<R> {
    fn from(v: Vector3<R>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl<R: Real> From<Wrench<R>> for Vector3<R> {
    fn from(w: Wrench<R>) -> Self {
        Vector3::new(w.force.x, w.force.y, w.torque)
    }
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

#[cfg(feature = "glam")]
mod glam_vectors {
    use super::{Twist, Wrench};
    use glam::{DVec2, DVec3, Vec2, Vec3};

    impl From<Vec3> for Twist<f32> {
        fn from(v: Vec3) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }

    impl From<DVec3> for Twist<f64> {
        fn from(v: DVec3) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }

    impl From<Wrench<f32>> for (Vec2, f32) {
        fn from(w: Wrench<f32>) -> Self {
            (Vec2::new(w.force.x, w.force.y), w.torque)
        }
    }

    impl From<Wrench<f64>> for (DVec2, f64) {
        fn from(w: Wrench<f64>) -> Self {
            (DVec2::new(w.force.x, w.force.y), w.torque)
        }
    }
}

#[cfg(feature = "mint")]
mod mint_vectors {
    use super::{Real, Twist, Wrench};

    impl<R: Real> From<mint::Vector3<R>> for Twist<R> {
        fn from(v: mint::Vector3<R>) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }

    impl<R: Real> From<Wrench<R>> for mint::Vector3<R> {
        fn from(w: Wrench<R>) -> Self {
            mint::Vector3 {
                x: w.force.x,
                y: w.force.y,
                z: w.torque,
            }
        }
    }
}

#[cfg(all(test, feature = "glam", feature = "mint"))]
mod tests {
    use super::*;

    #[test]
    fn other_vectors_keep_their_components() {
        let twist = Twist::new(1.0_f32, 2.0, 3.0);
        assert_eq!(Twist::from(glam::Vec3::new(1.0, 2.0, 3.0)), twist);
        assert_eq!(
            Twist::from(mint::Vector3 {
                x: 1.0_f32,
                y: 2.0,
                z: 3.0
            }),
            twist
        );
        assert_eq!(Twist::from(Vector3::new(1.0_f32, 2.0, 3.0)), twist);
        let wrench = Wrench {
            force: Vector2::new(4.0_f64, 5.0),
            torque: 6.0,
        };
        assert_eq!(
            <(glam::DVec2, f64)>::from(wrench),
            (glam::DVec2::new(4.0, 5.0), 6.0)
        );
        assert_eq!(
            mint::Vector3::from(wrench),
            mint::Vector3 {
                x: 4.0,
                y: 5.0,
                z: 6.0
            }
        );
        assert_eq!(Vector3::from(wrench), Vector3::new(4.0, 5.0, 6.0));
    }
}
