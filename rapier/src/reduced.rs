//! Two bodies as one: the mass and inertia with which a common impulse meets their relative motion.

use crate::frame::Frame;
use rapier3d::prelude::*;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Radius of gyration in metres of a pair that cannot turn; its inverse, of one that cannot shift.
const LOCKED: f32 = 1e3;

/// Cosine to the normal from which on an axis of the world counts as the normal.
const ALONG: f32 = 0.99;

/// What moves against what.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduced {
    pub(crate) body: PlanarBody<f32>,
    /// Shares of the foot and of the ground in a change of the relative velocity and spin.
    shares: [[f32; 2]; 2],
    /// Whether friction moves the foot, the ground.
    pub(crate) moved: [bool; 2],
}

impl Reduced {
    /// `None` if neither can be moved.
    pub(crate) fn new(foot: &RigidBody, ground: Option<&RigidBody>, frame: &Frame) -> Option<Self> {
        let of_foot = inverse(foot, ground, frame);
        let of_ground = ground.map_or([0.0; 2], |ground| inverse(ground, Some(foot), frame));
        let sums = [0, 1].map(|i| of_foot[i] + of_ground[i]);
        // What is locked is heavy, so that friction acts on the rest alone.
        let [mass, inertia] = match sums.map(|sum| sum > 0.0) {
            [true, true] => sums.map(f32::recip),
            [true, false] => [sums[0].recip(), sums[0].recip() * (LOCKED * LOCKED)],
            [false, true] => [sums[1].recip() * (LOCKED * LOCKED), sums[1].recip()],
            [false, false] => return None,
        };
        let share = |of: [f32; 2], sign: f32| {
            [0, 1].map(|i| match sums[i] > 0.0 {
                true => sign * (of[i] / sums[i]),
                false => 0.0,
            })
        };
        Some(Self {
            body: PlanarBody::new(mass, inertia).ok()?,
            shares: [share(of_foot, 1.0), share(of_ground, -1.0)],
            moved: [of_foot, of_ground].map(|of| of != [0.0; 2]),
        })
    }

    /// Changes of the foot's and the ground's velocities that make up a change of the relative twist.
    pub(crate) fn shared(&self, change: &Twist<f32>, frame: &Frame) -> [[Vector; 2]; 2] {
        let linear = frame.world(&change.velocity);
        let angular = frame.normal * change.spin;
        self.shares
            .map(|[shift, turn]| [linear * shift, angular * turn])
    }

    /// The mean push that makes `change` of the relative twist in a time `dt`.
    pub(crate) fn push(&self, change: &Twist<f32>, dt: f32) -> Wrench<f32> {
        Wrench {
            force: change.velocity * (self.body.mass() / dt),
            torque: change.spin * (self.body.inertia() / dt),
        }
    }
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

/// True for a body that forces move.
pub(crate) fn is_free(body: &RigidBody) -> bool {
    body.is_dynamic() && body.is_enabled() && !body.is_sleeping()
}

/// Changes the velocities of a body but along locked axes, without waking it.
pub(crate) fn accelerate(body: &mut RigidBody, change: &[Vector; 2], sign: f32) {
    let free = body
        .mass_properties()
        .effective_inv_mass
        .cmpgt(Vector::ZERO);
    let shift = Vector::select(free, change[0] * sign, Vector::ZERO);
    body.set_linvel(body.linvel() + shift, false);
    body.set_angvel(body.angvel() + change[1] * sign, false);
}
