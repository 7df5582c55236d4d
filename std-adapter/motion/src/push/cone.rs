//! The motions that a contact can give without sliding.

use super::contact::{PointContact, cross};
use super::error::PushError;
use super::solve::{ContactMode, QuasiStaticPush};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::nalgebra::Vector2;

/// All motions of a body that a contact can cause without sliding: those between two edges.
///
/// ```
/// use tribos::friction::Area;
/// use tribos::push::PointContact;
/// let puck = Area::named(&"disk".parse()?, 0.05, None)?.limit_surface(1.0)?; // N, m
/// let finger = PointContact::new([-0.05, 0.0], [1.0, 0.0], 0.5)?;
/// let cone = finger.motion_cone(&*puck)?;
/// // The contact may move farther off the normal than the force: the body also turns.
/// let [right, left] = cone.angles();
/// assert!(left > 0.5_f64.atan() && (right + left).abs() < 1e-15); // rad
/// assert!(cone.left.twist.spin < 0.0 && cone.holds([1.0, 0.5].into()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionCone {
    /// The contact that it belongs to.
    pub contact: PointContact,
    /// The push under the largest friction to the right; its motion has length 1 as
    /// [`FrictionSet::twist_normal_to`] scales it.
    pub right: QuasiStaticPush,
    /// The same under the largest friction to the left.
    pub left: QuasiStaticPush,
}

impl PointContact {
    /// The motion cone of this contact with a body of this friction.
    ///
    /// *Accuracy*: that of the set's normals. *Cost*: two normals and two gauges.
    pub fn motion_cone(&self, set: &dyn FrictionSet<f64>) -> Result<MotionCone, PushError> {
        let limit = set.force_limit();
        if !(limit > 0.0 && limit.is_finite()) {
            return Err(PushError::Frictionless(limit));
        }
        let [right, left] = self.edges().map(|force| edge(set, self, force));
        Ok(MotionCone {
            contact: *self,
            right,
            left,
        })
    }
}

/// The motion under a force along this direction.
pub(super) fn edge(
    set: &dyn FrictionSet<f64>,
    contact: &PointContact,
    force: Vector2<f64>,
) -> QuasiStaticPush {
    let wrench = contact.wrench(force);
    let twist = set.twist_normal_to(&wrench);
    QuasiStaticPush {
        mode: ContactMode::Sticking,
        twist,
        contact_velocity: contact.velocity(&twist),
        slip: Vector2::zeros(),
        wrench: set.scale_to_surface(&wrench),
    }
}

impl MotionCone {
    /// Angles of the contact's velocities at the right and the left edge, counterclockwise from the inward
    /// normal. *Units*: rad.
    pub fn angles(&self) -> [f64; 2] {
        [&self.right, &self.left].map(|edge| self.angle(edge.contact_velocity))
    }

    /// Angle of a velocity, counterclockwise from the inward normal. *Units*: rad.
    pub fn angle(&self, velocity: Vector2<f64>) -> f64 {
        let normal = self.contact.normal();
        libm::atan2(cross(&normal, &velocity), normal.dot(&velocity))
    }

    /// True if a pusher with this velocity of the contact sticks.
    pub fn holds(&self, velocity: Vector2<f64>) -> bool {
        let [right, left] = self.angles();
        let angle = self.angle(velocity);
        self.contact.normal().dot(&velocity) > 0.0 && right <= angle && angle <= left
    }
}
