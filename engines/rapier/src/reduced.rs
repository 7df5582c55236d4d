//! What friction moves: bodies that are free, along axes that are.

use crate::frame::Frame;
use rapier3d::prelude::*;
use tribos_feet::Reduced;

/// Cosine to the normal from which on an axis of the world counts as the normal.
const ALONG: f32 = 0.99;

/// A foot and its ground, reduced to one body. `None` if neither can be moved.
pub(crate) fn reduced(
    foot: &RigidBody,
    ground: Option<&RigidBody>,
    frame: &Frame,
) -> Option<Reduced> {
    let of_foot = inverse(foot, ground, frame);
    let of_ground = ground.map_or([0.0; 2], |ground| inverse(ground, Some(foot), frame));
    let lever = ground.map_or([0.0; 2], |ground| {
        frame.plane(foot.center_of_mass() - ground.center_of_mass())
    });
    Reduced::new([of_foot, of_ground], lever)
}

/// 1/mass and 1/inertia of a body in the plane; zero for one that `other` cannot move.
fn inverse(body: &RigidBody, other: Option<&RigidBody>, frame: &Frame) -> [f32; 2] {
    // Fixed and kinematic bodies dominate all others.
    let fixed = i16::from(i8::MAX) + 1;
    let rank = other.map_or(fixed, RigidBody::effective_dominance_group);
    if !is_free(body) || body.effective_dominance_group() > rank {
        return [0.0; 2];
    }
    let properties = body.mass_properties();
    // The patch has one mass for all directions: that along the axes that are free.
    let flat = frame.normal.abs().cmplt(Vector::splat(ALONG));
    let shift = Vector::select(flat, properties.effective_inv_mass, Vector::ZERO).max_element();
    let turn = properties.effective_world_inv_inertia * frame.normal;
    [shift, turn.dot(frame.normal)]
}

/// Whether forces move a body.
pub(crate) fn is_free(body: &RigidBody) -> bool {
    body.is_dynamic() && body.is_enabled() && !body.is_sleeping()
}

/// Changes the velocities of a body except along locked axes, without waking it.
pub(crate) fn accelerate(body: &mut RigidBody, change: &[Vector; 2], sign: f32) {
    if *change == [Vector::ZERO; 2] {
        return;
    }
    let free = body
        .mass_properties()
        .effective_inv_mass
        .cmpgt(Vector::ZERO);
    let shift = Vector::select(free, change[0] * sign, Vector::ZERO);
    body.set_linvel(body.linvel() + shift, false);
    body.set_angvel(body.angvel() + change[1] * sign, false);
}
