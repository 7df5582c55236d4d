//! Results of the engine's solver at a contact.

use crate::pair::{Pair, Touching};
use rapier3d::parry::utils::PoseOpt;
use rapier3d::prelude::*;

/// The pair's contact after a step of length `dt`; `None` if nothing pushed.
pub(crate) fn touching(
    pair: &Pair,
    foot: &RigidBody,
    colliders: &ColliderSet,
    narrow_phase: &NarrowPhase,
    dt: f32,
) -> Option<Touching> {
    let contact = narrow_phase.contact_pair(pair.foot, pair.ground)?;
    let place = colliders.get(pair.foot)?.position();
    // The engine's normal points from the first collider to the second.
    let is_second = contact.collider1 == pair.ground;
    let mut impulse = Vector::ZERO;
    let mut moment = Vector::ZERO;
    // Parts of a shape share the solver's manifolds.
    for manifold in contact.solver_manifolds() {
        let (towards, part) = match is_second {
            true => (1.0, manifold.subshape_pos2()),
            false => (-1.0, manifold.subshape_pos1()),
        };
        let normal = manifold.data.normal * towards;
        let part = part.prepend_to(place);
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
            let arm = part.transform_point(local) - foot.center_of_mass();
            impulse += normal * point.data.impulse;
            moment += arm * point.data.impulse;
        }
    }
    let size = impulse.length();
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let normal = impulse / size;
    Some(Touching {
        load: size / dt,
        normal,
        depth: -moment.dot(normal) / size,
    })
}
