//! The motion of a body under a pusher of given velocity.

use super::cone::{MotionCone, edge};
use super::contact::{PointContact, cross};
use super::error::{PushError, finite};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::nalgebra::Vector2;
use tribos_core::twist::{Twist, Wrench};

/// Secants of the search for a force; 14 were seen. Halvings follow until no number lies between both ends.
const MOST_SECANTS: usize = 100;
/// A contact velocity has the pusher's direction to this angle, in rad; one that is farther off at the end of the search
/// turns at once there, under a force at an edge of the set.
const PARALLEL: f64 = 1e-15;
const CORNER: f64 = 1e-9;
/// Part of the pusher's velocity that may be left at the contact: ten times what is left within a corner's angle.
const MOST_LEFT: f64 = 1e-8;

/// What a contact does while its pusher moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactMode {
    /// The pusher keeps its place on the body.
    Sticking,
    /// The pusher slides to the left along the body, which it drags to the left.
    SlidingLeft,
    /// The pusher slides to the right along the body, which it drags to the right.
    SlidingRight,
    /// The pusher moves away, or along the side; the body rests.
    Separating,
}

impl std::fmt::Display for ContactMode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Sticking => "sticking",
            Self::SlidingLeft => "sliding to the left",
            Self::SlidingRight => "sliding to the right",
            Self::Separating => "separating",
        })
    }
}

/// A quasi-static push.
///
/// ```
/// use tribos::friction::Area;
/// use tribos::nalgebra::Vector2;
/// use tribos::push::{ContactMode, PointContact};
/// let puck = Area::named(&"disk".parse()?, 0.05, None)?.limit_surface(1.0)?; // N, m
/// let slippery = PointContact::new([-0.05, 0.0], [1.0, 0.0], 0.1)?;
/// let moved = slippery.push(&*puck, [0.01, 0.02])?; // m/s
/// assert_eq!(moved.mode, ContactMode::SlidingLeft);
/// // What the pusher does not spend on the floor it spends at the contact.
/// let given = moved.wrench.force.dot(&Vector2::new(0.01, 0.02));
/// let rubbed = moved.wrench.force.dot(&moved.slip);
/// assert!((given - rubbed - puck.support(&moved.twist)).abs() < 1e-15 && rubbed > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuasiStaticPush {
    /// What the contact does.
    pub mode: ContactMode,
    /// Motion of the body. *Units*: m/s and rad/s.
    pub twist: Twist<f64>,
    /// Velocity of the body at the contact, in m/s.
    pub contact_velocity: Vector2<f64>,
    /// Velocity of the pusher past the body, in m/s.
    pub slip: Vector2<f64>,
    /// What the pusher exerts, about the origin: on the limit surface, or zero. *Units*: N and N m.
    pub wrench: Wrench<f64>,
}

impl PointContact {
    /// The motion of a body of this friction under a pusher that touches it here with this `velocity`.
    ///
    /// A pusher with no velocity along the inward normal leaves the body at rest, though a wedged one might drag it.
    /// *Errors*: [`PushError::NotFound`] if the motion that was found does not take the pusher's velocity.
    /// *Accuracy*: contact velocities 1e-14 of the pusher's, motions what the set's normals allow. *Cost*:
    /// about 8 normals if it sticks, 2 if not.
    pub fn push(
        &self,
        set: &dyn FrictionSet<f64>,
        velocity: [f64; 2],
    ) -> Result<QuasiStaticPush, PushError> {
        let [x, y] = velocity;
        let velocity = Vector2::new(
            finite("x of the pusher's velocity", x)?,
            finite("y of the pusher's velocity", y)?,
        );
        let cone = self.motion_cone(set)?;
        followed(within(set, &cone, velocity), velocity)
    }
}

/// The push, if the body at the contact and the slip take the pusher's velocity.
fn followed(push: QuasiStaticPush, velocity: Vector2<f64>) -> Result<QuasiStaticPush, PushError> {
    let left = (push.contact_velocity + push.slip - velocity).norm();
    match left <= MOST_LEFT * velocity.norm() && push.twist.spin.is_finite() {
        true => Ok(push),
        false => Err(PushError::NotFound { left }),
    }
}

/// The same with the motion cone at hand.
pub(super) fn within(
    set: &dyn FrictionSet<f64>,
    cone: &MotionCone,
    velocity: Vector2<f64>,
) -> QuasiStaticPush {
    let contact = &cone.contact;
    let approach = contact.normal().dot(&velocity);
    if approach <= 0.0 {
        return QuasiStaticPush {
            mode: ContactMode::Separating,
            twist: Twist::ZERO,
            contact_velocity: Vector2::zeros(),
            slip: velocity,
            wrench: Wrench::ZERO,
        };
    }
    // Forces are less than a right angle off the normal, and velocities off their forces: angles from the
    // normal never jump. An edge a right angle or more off it is beyond every pusher.
    let [right, left] = cone.angles();
    let angle = cone.angle(velocity);
    let (mode, at) = if angle > left {
        (ContactMode::SlidingLeft, cone.left)
    } else if angle < right {
        (ContactMode::SlidingRight, cone.right)
    } else {
        (ContactMode::Sticking, sticking(set, cone, velocity))
    };
    // The body takes the whole velocity, or its part along the normal.
    let factor = if mode == ContactMode::Sticking {
        velocity.dot(&at.contact_velocity) / at.contact_velocity.dot(&at.contact_velocity)
    } else {
        approach / contact.normal().dot(&at.contact_velocity)
    };
    let contact_velocity = at.contact_velocity * factor;
    let slip = if mode == ContactMode::Sticking {
        Vector2::zeros()
    } else {
        velocity - contact_velocity
    };
    QuasiStaticPush {
        mode,
        twist: at.twist * factor,
        contact_velocity,
        slip,
        wrench: at.wrench,
    }
}

/// The force between the edges under which the contact moves in the pusher's direction.
///
/// The velocity turns with the force: a bracket of the friction's share, made smaller by the Illinois
/// variant of the secant (Dowell and Jarratt, BIT 11 (1971) 168). Sets with edges, such as those of points, have many
/// normals under one force: the motion is then the one between those of both ends of the bracket.
fn sticking(
    set: &dyn FrictionSet<f64>,
    cone: &MotionCone,
    velocity: Vector2<f64>,
) -> QuasiStaticPush {
    let contact = &cone.contact;
    let wanted = cone.angle(velocity);
    // From the pusher's velocity to the contact's.
    let off = |at: &QuasiStaticPush| cone.angle(at.contact_velocity) - wanted;
    let (mut low, mut high) = (-1.0, 1.0);
    let (mut below, mut above) = (off(&cone.right), off(&cone.left));
    let (mut at, mut ends) = (cone.left, [cone.right, cone.left]);
    if above <= PARALLEL {
        return at;
    }
    if below >= -PARALLEL {
        return cone.right;
    }
    let mut was_above = None;
    for step in 0_usize.. {
        let secant = (low * above - high * below) / (above - below);
        let share = if step < MOST_SECANTS && secant > low && secant < high {
            secant
        } else {
            0.5 * (low + high)
        };
        if share <= low || share >= high {
            break;
        }
        let side = share * contact.coefficient();
        let force = contact.normal() + contact.tangent() * side;
        at = edge(set, contact, force);
        let found = off(&at);
        if found.abs() <= PARALLEL {
            break;
        }
        // An end that stays twice counts half.
        let is_above = found > 0.0;
        if is_above {
            (high, above, ends[1]) = (share, found, at);
            if was_above == Some(true) {
                below *= 0.5;
            }
        } else {
            (low, below, ends[0]) = (share, found, at);
            if was_above == Some(false) {
                above *= 0.5;
            }
        }
        was_above = Some(is_above);
    }
    if off(&at).abs() > CORNER {
        let [right, left] = ends.map(|end| cross(&velocity, &end.contact_velocity).abs());
        let share = right / (right + left);
        at.twist = ends[0].twist * (1.0 - share) + ends[1].twist * share;
        at.contact_velocity = contact.velocity(&at.twist);
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::limit_surface::Projection;
    use tribos_core::limit_surface::ShapeLimitSurface;
    use tribos_core::patch::nodes::Node;
    use tribos_core::patch::points::PointPatch;
    use tribos_friction::OwnedNodes;

    /// A disk whose normals have this share of their spin.
    struct Astray(f64);

    impl Astray {
        fn disk(&self) -> Box<dyn FrictionSet<f64>> {
            tribos_friction::Area::named(&"disk".parse().unwrap(), 0.05, None)
                .unwrap()
                .limit_surface(1.0)
                .unwrap()
        }
    }

    impl FrictionSet<f64> for Astray {
        fn force_limit(&self) -> f64 {
            1.0
        }
        fn radius(&self) -> f64 {
            0.05
        }
        fn support(&self, twist: &Twist<f64>) -> f64 {
            self.disk().support(twist)
        }
        fn wrench(&self, twist: &Twist<f64>) -> Wrench<f64> {
            self.disk().wrench(twist)
        }
        fn gauge(&self, wrench: &Wrench<f64>) -> f64 {
            self.disk().gauge(wrench)
        }
        fn twist_normal_to(&self, push: &Wrench<f64>) -> Twist<f64> {
            let normal = self.disk().twist_normal_to(push);
            Twist::new(normal.velocity.x, normal.velocity.y, normal.spin * self.0)
        }
        fn scale_to_surface(&self, wrench: &Wrench<f64>) -> Wrench<f64> {
            self.disk().scale_to_surface(wrench)
        }
        fn project_with_length(&self, wrench: &Wrench<f64>, length: f64) -> Projection<f64> {
            self.disk().project_with_length(wrench, length)
        }
    }

    #[test]
    fn a_push_without_a_normal_is_an_error_and_ends_no_path() {
        use crate::push::{Pose, PushedSide, Pusher};
        let contact = PointContact::new([-0.05, 0.01], [1.0, 0.0], 0.3).unwrap();
        assert!(contact.push(&Astray(1.0), [0.01, 0.001]).is_ok());
        let lost = contact.push(&Astray(f64::NAN), [0.01, 0.001]);
        assert!(matches!(lost, Err(PushError::NotFound { .. })), "{lost:?}");
        let drive = Pusher {
            contact,
            side: PushedSide::Straight {
                right: 0.02,
                left: 0.02,
            },
            start: Pose::default(),
            velocity: [0.01, 0.0],
            duration: 1.0,
            samples: 3,
            tolerance: 1e-6,
        };
        assert!(drive.path(&Astray(1.0)).is_ok());
        let lost = drive.path(&Astray(f64::NAN));
        assert!(matches!(lost, Err(PushError::NotFound { .. })), "{lost:?}");
    }

    #[test]
    fn a_body_on_feet_that_sticks_follows_its_pusher() {
        let feet = [[0.1, 0.05, 1.0], [-0.1, 0.06, 2.0], [0.0, -0.05, 1.5]];
        let node = |[x, y, weight]: [f64; 3]| Node { x, y, weight };
        let nodes = OwnedNodes::new(feet.map(node).to_vec()).unwrap();
        let set = ShapeLimitSurface::new(PointPatch::new(nodes).unwrap(), 3.0).unwrap();
        let contact = PointContact::new([-0.12, 0.02], [1.0, 0.0], 2.0).unwrap();
        let cone = contact.motion_cone(&set).unwrap();
        let [right, left] = cone.angles();
        for i in 1..200 {
            let angle = right + (left - right) * f64::from(i) / 200.0;
            let velocity = Vector2::new(libm::cos(angle), libm::sin(angle));
            if velocity.x <= 0.0 {
                continue;
            }
            let push = within(&set, &cone, velocity);
            assert_eq!(push.mode, ContactMode::Sticking, "{angle}");
            let off = contact.velocity(&push.twist) - velocity;
            assert!(off.norm() < 1e-8, "{angle}: {push:?}");
            // The push is where the set is farthest along the motion.
            let spent = push.wrench.force.dot(&velocity);
            let dissipated = set.support(&push.twist);
            assert!((spent / dissipated - 1.0).abs() < 1e-8, "{angle}: {push:?}");
        }
    }
}
