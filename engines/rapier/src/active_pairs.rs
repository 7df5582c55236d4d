//! Pairs that the engine treats, and the results of its solver at a contact.

use crate::pair::ContactLoad;
use rapier3d::parry::utils::PoseOpt;
use rapier3d::prelude::*;

/// A pair whose foot is not asleep.
pub(crate) struct ActivePair<'a> {
    pub(crate) body: RigidBodyHandle,
    /// Body of the ground.
    pub(crate) ground: Option<RigidBodyHandle>,
    foot: &'a RigidBody,
    /// Position of the foot's collider.
    place: &'a Pose,
    contact: Option<&'a ContactPair>,
}

impl<'a> ActivePair<'a> {
    /// Of foot and ground.
    pub(crate) fn of(
        pair: [ColliderHandle; 2],
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        narrow_phase: &'a NarrowPhase,
    ) -> Option<Self> {
        let [collider, below] = colliders_of(pair, colliders)?;
        let (body, foot, ground) = bodies_of(collider, below, bodies)?;
        if foot.is_sleeping() {
            return None;
        }
        Some(Self {
            body,
            ground,
            foot,
            place: collider.position(),
            contact: narrow_phase.contact_pair(pair[0], pair[1]),
        })
    }

    /// Whether the engine resisted the sliding of this contact.
    pub(crate) fn has_friction(&self) -> bool {
        let manifolds = self
            .contact
            .into_iter()
            .flat_map(ContactPair::solver_manifolds);
        manifolds
            .into_iter()
            .any(|manifold| manifold.data.friction != 0.0)
    }

    /// The contact after a step of length `dt`; `None` if nothing pushed.
    pub(crate) fn touching(&self, ground: ColliderHandle, dt: f32) -> Option<ContactLoad> {
        // The engine's normal points from the first collider to the second.
        let is_second = self.contact?.collider1 == ground;
        let mut impulse = Vector::ZERO;
        let mut moment = Vector::ZERO;
        // Parts of a shape share the solver's manifolds.
        for manifold in self.contact?.solver_manifolds() {
            let (towards, part) = match is_second {
                true => (1.0, manifold.subshape_pos2()),
                false => (-1.0, manifold.subshape_pos1()),
            };
            let normal = manifold.data.normal * towards;
            let part = part.prepend_to(self.place);
            // Points that the solver did not treat keep the impulse of an earlier step.
            for solved in manifold.data.solver_contacts.iter() {
                let [index] = solved.contact_indices();
                let Some(point) = manifold.points.get(index as usize) else {
                    continue;
                };
                let local = if is_second {
                    point.local_p2
                } else {
                    point.local_p1
                };
                let arm = part.transform_point(local) - self.foot.center_of_mass();
                impulse += normal * point.data.impulse;
                moment += arm * point.data.impulse;
            }
        }
        let size = impulse.length();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let normal = impulse / size;
        Some(ContactLoad {
            load: size / dt,
            normal,
            depth: -moment.dot(normal) / size,
        })
    }
}

/// Foot and ground, if both exist.
pub(crate) fn colliders_of(
    [foot, ground]: [ColliderHandle; 2],
    colliders: &ColliderSet,
) -> Option<[&Collider; 2]> {
    Some([colliders.get(foot)?, colliders.get(ground)?])
}

/// The bodies of foot and ground, if the engine treats the pair and forces move the foot.
pub(crate) fn bodies_of<'a>(
    foot: &Collider,
    ground: &Collider,
    bodies: &'a RigidBodySet,
) -> Option<(RigidBodyHandle, &'a RigidBody, Option<RigidBodyHandle>)> {
    if !(foot.is_enabled() && ground.is_enabled()) {
        return None;
    }
    let handle = foot.parent()?;
    let body = bodies.get(handle)?;
    let below = ground.parent();
    let is_there = |below| bodies.get(below).is_some_and(RigidBody::is_enabled);
    let is_treated = body.is_enabled()
        && body.is_dynamic()
        && below.is_none_or(|below| below != handle && is_there(below));
    is_treated.then_some((handle, body, below))
}
