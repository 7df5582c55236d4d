//! What goes into a contact and what comes out: motion and load in the contact plane.

mod conversions;

use crate::real::Real;
use nalgebra::{Matrix3, Vector2};

/// Motion of a rigid patch in its plane: velocity of the centre and spin about the normal.
///
/// *Units*: length/time and 1/time. Positive spin turns the first axis towards the second.
///
/// ```
/// use nalgebra::Vector2;
/// use tribos_core::twist::Twist;
/// let puck = Twist::new(3.0_f64, 4.0, 20.0); // m/s, m/s, rad/s
/// assert!((puck.speed() - 5.0).abs() < 2e-15);
/// // One point is at rest, a speed over spin away from the centre and across the velocity.
/// let at = |x: f64, y: f64| puck.velocity + Vector2::new(-y, x) * puck.spin;
/// assert!(at(-4.0 / 20.0, 3.0 / 20.0).amax() < 1e-15);
/// ```
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
///
/// ```
/// use tribos_core::coupling::{PatchFriction, table::Coulomb};
/// use tribos_core::twist::{Twist, Wrench};
/// let puck = PatchFriction::new(Coulomb, 0.3_f64, 0.04)?; // mu, radius in m
/// let twist = Twist::new(1.0, 0.0, 20.0); // m/s, m/s, rad/s
/// let Wrench { force, torque } = puck.wrench(1.7, &twist); // load in N
/// let power = force.dot(&twist.velocity) + torque * twist.spin; // W
/// assert!(power < 0.0); // friction only takes
/// assert_eq!(puck.wrench(0.0, &twist), Wrench::ZERO); // lifted
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<R: Real> {
    /// Force at the patch centre.
    pub force: Vector2<R>,
    /// Torque about the normal.
    pub torque: R,
}

/// ∂(force, torque)/∂(velocity, spin), rows and columns in the order (x, y, normal).
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::coupling::{PatchFriction, table::Coulomb};
/// use tribos_core::twist::{Twist, WrenchJacobian};
/// let puck = PatchFriction::new(Coulomb, 0.3_f64, 0.04)?; // mu, radius in m
/// let twist = Twist::new(1.0, 0.5, 20.0);
/// let jacobian: WrenchJacobian<f64> = puck.wrench_jacobian(1.7, &twist);
/// // Symmetric, as second derivatives are; and twice as fast meets the same dry friction.
/// assert!((jacobian - jacobian.transpose()).amax() < 1e-15);
/// assert!((jacobian * Vector3::from(twist)).amax() < 1e-12);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
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
