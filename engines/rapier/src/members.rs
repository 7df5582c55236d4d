//! The feet that take part in a step, and which of them are solved together.

use crate::pair::ContactLoad;
use rapier3d::prelude::*;

/// Least cosine of the angle between the normals of two feet on one plane.
const ONE_PLANE: f32 = 0.99;

/// A foot of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    /// Index of the pair.
    pub(crate) pair: usize,
    pub(crate) body: RigidBodyHandle,
    /// Body of the ground; a collider without body is at rest.
    pub(crate) ground: Option<RigidBodyHandle>,
    pub(crate) touching: ContactLoad,
    /// Number of its position among those of the feet that began the step.
    pub(crate) stand: Option<usize>,
    /// Belongs to a group that has been solved.
    pub(crate) is_done: bool,
}

impl Member {
    pub(crate) fn new(
        pair: usize,
        body: RigidBodyHandle,
        ground: Option<RigidBodyHandle>,
        touching: ContactLoad,
    ) -> Self {
        Self {
            pair,
            body,
            ground,
            touching,
            stand: None,
            is_done: false,
        }
    }
}

pub(crate) fn index(body: RigidBodyHandle) -> u32 {
    body.into_raw_parts().0
}

/// Puts the feet of each body next to each other.
pub(crate) fn by_body(members: &mut [Member]) {
    members.sort_unstable_by_key(|member| (index(member.body), member.pair));
}

/// Joins feet of one body on one plane: on grounds that friction does not move, or on the same one. Brings
/// those that go with the first one of `members` to the front, and returns their number.
///
/// Feet of one body lie next to each other.
pub(crate) fn prepare_groups(members: &mut [Member], bodies: &RigidBodySet) -> usize {
    let Some(body) = members.first().map(|first| first.body) else {
        return 0;
    };
    let mut size = 1;
    for at in 1..members.len() {
        let member = members[at];
        if member.body != body {
            break;
        }
        if members[..size]
            .iter()
            .all(|other| joins(&member, other, bodies))
        {
            bring_forward(members, at, &mut size);
        }
    }
    size
}

/// Appends a foot to the first `size` ones; the others keep their order.
pub(crate) fn bring_forward(members: &mut [Member], at: usize, size: &mut usize) {
    if at > *size {
        members[*size..=at].rotate_right(1);
    }
    *size += 1;
}

fn joins(one: &Member, other: &Member, bodies: &RigidBodySet) -> bool {
    share_motion(one.ground, other.ground, bodies)
        && is_one_plane(one.touching.normal, other.touching.normal)
}

/// Whether both grounds can be treated as one.
pub(crate) fn share_motion(
    one: Option<RigidBodyHandle>,
    other: Option<RigidBodyHandle>,
    bodies: &RigidBodySet,
) -> bool {
    let movable = |ground: Option<RigidBodyHandle>| {
        ground.filter(|&handle| bodies.get(handle).is_some_and(RigidBody::is_dynamic))
    };
    one == other || movable(one) == movable(other)
}

/// Whether feet with these normals stand on one plane.
pub(crate) fn is_one_plane(one: Vector, other: Vector) -> bool {
    one.dot(other) > ONE_PLANE
}
