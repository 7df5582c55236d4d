//! Pairs that cannot be given a patch.

use core::fmt;
use rapier3d::prelude::*;

/// Why a pair was refused.
///
/// ```
/// use rapier3d::prelude::*;
/// use tribos_rapier::{PairError, Patch, PatchContacts};
/// let mut world = PhysicsWorld::new();
/// let (_, table) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::cuboid(2.0, 0.1, 2.0));
/// let (puck, foot) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::cylinder(0.01, 0.08));
/// let grip = world.insert_collider(ColliderBuilder::ball(0.02), Some(puck));
/// let mut patches = PatchContacts::new();
/// let mut insert = |foot, ground| {
///     let patch = Patch::disk(0.3, 0.08).map_err(|error| error.to_string()).unwrap();
///     patches.insert(foot, ground, patch, &world.bodies, &mut world.colliders)
/// };
/// assert_eq!(insert(table, foot), Err(PairError::FootIsNotDynamic)); // the wrong order
/// assert_eq!(insert(foot, grip), Err(PairError::OneBody));
/// let nobody = ColliderHandle::invalid();
/// assert_eq!(insert(foot, nobody), Err(PairError::Missing { collider: nobody }));
/// assert_eq!(insert(foot, table), Ok(()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PairError {
    /// No collider has this handle.
    Missing {
        /// The handle.
        collider: ColliderHandle,
    },
    /// The foot's body is not dynamic: it has none, or a fixed or kinematic one. Often foot and
    /// ground were given in the wrong order.
    FootIsNotDynamic,
    /// Foot and ground are parts of one body.
    OneBody,
    /// A coefficient of friction of a ground is negative, infinite or NaN.
    Coefficient {
        /// The rejected value.
        given: f32,
    },
}

/// Refuses pairs that the adapter cannot handle.
pub(crate) fn check(
    foot: ColliderHandle,
    ground: ColliderHandle,
    bodies: &RigidBodySet,
    colliders: &ColliderSet,
) -> Result<(), PairError> {
    let parent = |collider: ColliderHandle| match colliders.get(collider) {
        Some(found) => Ok(found.parent()),
        None => Err(PairError::Missing { collider }),
    };
    let (body, below) = (parent(foot)?, parent(ground)?);
    let body = body.filter(|&body| bodies.get(body).is_some_and(RigidBody::is_dynamic));
    match body {
        None => Err(PairError::FootIsNotDynamic),
        Some(body) if below == Some(body) => Err(PairError::OneBody),
        Some(_) => Ok(()),
    }
}

impl fmt::Display for PairError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { collider } => write!(f, "there is no collider {collider:?}"),
            Self::FootIsNotDynamic => f.write_str(
                "the foot must belong to a dynamic body; the order is foot, then ground",
            ),
            Self::Coefficient { given } => write!(
                f,
                "the coefficient of friction must be finite and not negative, not {given}"
            ),
            Self::OneBody => f.write_str("foot and ground belong to one body"),
        }
    }
}

impl core::error::Error for PairError {}
