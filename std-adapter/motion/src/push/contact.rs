//! A pusher that touches a body at one point.

use super::PushError;
use super::error::{finite, not_negative};
use tribos_core::Real;
use tribos_core::nalgebra::Vector2;
use tribos_core::twist::{Twist, Wrench};

/// Where and how a pusher touches a body at one point: a finger at a flat side, or a flat pusher at a corner.
///
/// *Units*: m; the normal points into the body and is scaled to length 1. *Left* and *right* are those of
/// somebody who looks along it.
///
/// ```
/// use tribos::push::PointContact;
/// let finger = PointContact::new([0.1, 0.0], [-2.0, 0.0], 0.5)?;
/// assert_eq!(finger.normal().x, -1.0);
/// // Forces of length 1 at the edges of the friction cone: atan 0.5 off the normal.
/// let [right, left] = finger.edges();
/// assert!(right.y > 0.0 && (left.y + 0.5 / 1.25_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), tribos::push::PushError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointContact {
    position: Vector2<f64>,
    normal: Vector2<f64>,
    coefficient: f64,
}

impl PointContact {
    /// *Domain*: finite position; a normal with a direction; friction coefficient of the pusher ≥ 0.
    pub fn new(
        position: [f64; 2],
        inward_normal: [f64; 2],
        coefficient: f64,
    ) -> Result<Self, PushError> {
        let [x, y] = position;
        let [nx, ny] = inward_normal;
        let position = Vector2::new(finite("x of a contact", x)?, finite("y of a contact", y)?);
        let length = Real::hypot(finite("x of a normal", nx)?, finite("y of a normal", ny)?);
        if length == 0.0 || !length.is_finite() {
            return Err(PushError::Normal);
        }
        Ok(Self {
            position,
            normal: Vector2::new(nx / length, ny / length),
            coefficient: not_negative("the pusher's friction coefficient", coefficient)?,
        })
    }

    /// The same contact elsewhere along the side.
    pub(super) fn moved_to(self, position: Vector2<f64>) -> Self {
        Self { position, ..self }
    }

    /// Where it is.
    pub fn position(&self) -> Vector2<f64> {
        self.position
    }

    /// The inward normal, of length 1.
    pub fn normal(&self) -> Vector2<f64> {
        self.normal
    }

    /// The direction to the left, of length 1.
    pub fn tangent(&self) -> Vector2<f64> {
        Vector2::new(-self.normal.y, self.normal.x)
    }

    /// The friction coefficient between pusher and body.
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// Forces of length 1 at the right and the left edge of the friction cone.
    pub fn edges(&self) -> [Vector2<f64>; 2] {
        let length = Real::hypot(1.0, self.coefficient);
        [-1.0, 1.0]
            .map(|side| (self.normal + self.tangent() * (side * self.coefficient)) * (1.0 / length))
    }

    /// Force and its torque about the origin.
    pub fn wrench(&self, force: Vector2<f64>) -> Wrench<f64> {
        let torque = cross(&self.position, &force);
        Wrench { force, torque }
    }

    /// Velocity of the body at the contact.
    pub fn velocity(&self, twist: &Twist<f64>) -> Vector2<f64> {
        velocity_at(twist, &self.position)
    }
}

/// Velocity of a body at a place.
pub(super) fn velocity_at(twist: &Twist<f64>, place: &Vector2<f64>) -> Vector2<f64> {
    twist.velocity + Vector2::new(-place.y, place.x) * twist.spin
}

pub(super) fn cross(a: &Vector2<f64>, b: &Vector2<f64>) -> f64 {
    a.x * b.y - a.y * b.x
}
