//! Two bodies as one: the mass and inertia with which a common impulse meets their relative motion.

use crate::frame::Frame;
use nalgebra::Vector2;
use rapier3d::prelude::*;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::push;
use tribos_feet::symmetric::solved;

/// Radius of gyration in metres of a pair that cannot turn; its inverse, of one that cannot shift.
const LOCKED: f32 = 1e3;

/// Cosine to the normal from which on an axis of the world counts as the normal.
const ALONG: f32 = 0.99;

/// A foot and its ground, reduced to one body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduced {
    /// The pair, if friction acted at the ground's centre of mass.
    pub(crate) body: PlanarBody<f32>,
    /// Inverse mass and inertia of the foot and of the ground.
    inverse: [[f32; 2]; 2],
    /// Vector from the ground's centre of mass to the foot's, in the plane.
    lever: [f32; 2],
    /// Whether friction moves the foot and the ground.
    pub(crate) moved: [bool; 2],
}

impl Reduced {
    /// `None` if neither can be moved.
    pub(crate) fn new(foot: &RigidBody, ground: Option<&RigidBody>, frame: &Frame) -> Option<Self> {
        let of_foot = inverse(foot, ground, frame);
        let of_ground = ground.map_or([0.0; 2], |ground| inverse(ground, Some(foot), frame));
        let sums = [0, 1].map(|i| of_foot[i] + of_ground[i]);
        // Locked motions get a large mass, so that friction acts only on the others.
        let [mass, inertia] = match sums.map(|sum| sum > 0.0) {
            [true, true] => sums.map(f32::recip),
            [true, false] => [sums[0].recip(), sums[0].recip() * (LOCKED * LOCKED)],
            [false, true] => [sums[1].recip() * (LOCKED * LOCKED), sums[1].recip()],
            [false, false] => return None,
        };
        let lever = ground.map_or([0.0; 2], |ground| {
            frame.plane(foot.center_of_mass() - ground.center_of_mass())
        });
        Some(Self {
            body: PlanarBody::new(mass, inertia).ok()?,
            inverse: [of_foot, of_ground],
            lever,
            moved: [of_foot, of_ground].map(|of| of != [0.0; 2]),
        })
    }

    /// The mass matrix of the relative motion if friction moves the ground.
    pub(crate) fn coupled(&self) -> Option<[f64; 6]> {
        self.moved[1].then(|| self.mass())
    }

    /// The mass matrix of the relative motion at the foot's centre of mass: xx, xy, yy, xn, yn, nn.
    fn mass(&self) -> [f64; 6] {
        let [mass, inertia] = [self.body.mass(), self.body.inertia()].map(f64::from);
        let [x, y] = self.lever.map(f64::from);
        let turn = f64::from(self.inverse[1][1]);
        if !self.moved[1] || turn == 0.0 {
            return [mass, 0.0, mass, 0.0, 0.0, inertia];
        }
        // A force on the ground rotates it, which moves points off its centre.
        let inverse = [
            1.0 / mass + turn * y * y,
            -(turn * x * y),
            1.0 / mass + turn * x * x,
            -(turn * y),
            turn * x,
            1.0 / inertia,
        ];
        let column = |right: [f64; 3]| solved(&inverse, &right);
        let [xx, xy, xn] = column([1.0, 0.0, 0.0]);
        let [_, yy, yn] = column([0.0, 1.0, 0.0]);
        let [_, _, nn] = column([0.0, 0.0, 1.0]);
        [xx, xy, yy, xn, yn, nn]
    }

    /// Changes of the foot's and the ground's velocities that together give a change of the relative twist.
    pub(crate) fn shared(&self, change: &Twist<f32>, frame: &Frame) -> [[Vector; 2]; 2] {
        let moved =
            |velocity: &Vector2<f32>, spin: f32| [frame.world(velocity), frame.normal * spin];
        let still = [Vector::ZERO; 2];
        let [foot, ground] = self.inverse;
        if !self.moved[1] {
            let free = foot.map(|inverse| f32::from(u8::from(inverse > 0.0)));
            return [
                moved(&(change.velocity * free[0]), change.spin * free[1]),
                still,
            ];
        }
        let Wrench { force, torque } = self.push(change, 1.0);
        let [x, y] = self.lever;
        let below = torque + (x * force.y - y * force.x);
        [
            moved(&(force * foot[0]), torque * foot[1]),
            moved(&(force * -ground[0]), below * -ground[1]),
        ]
    }

    /// The mean push that makes `change` of the relative twist in a time `dt`.
    pub(crate) fn push(&self, change: &Twist<f32>, dt: f32) -> Wrench<f32> {
        push(&self.body, self.coupled().as_ref(), change, dt)
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

/// Whether forces move a body.
pub(crate) fn is_free(body: &RigidBody) -> bool {
    body.is_dynamic() && body.is_enabled() && !body.is_sleeping()
}

/// Changes the velocities of a body except along locked axes, without waking it.
pub(crate) fn accelerate(body: &mut RigidBody, change: &[Vector; 2], sign: f32) {
    let free = body
        .mass_properties()
        .effective_inv_mass
        .cmpgt(Vector::ZERO);
    let shift = Vector::select(free, change[0] * sign, Vector::ZERO);
    body.set_linvel(body.linvel() + shift, false);
    body.set_angvel(body.angvel() + change[1] * sign, false);
}
