//! The contact plane: two tangents and a normal, and what moves in it.

use nalgebra::Vector2;
use rapier3d::prelude::*;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Right-handed axes of a contact, the normal pointing from the ground to the foot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) normal: Vector,
    first: Vector,
    second: Vector,
}

impl Frame {
    /// Axes with the first along the projection of `along`; any axes if that has none.
    pub(crate) fn new(normal: Vector, along: Option<Vector>) -> Self {
        let flat = along.map(|along| along - normal * normal.dot(along));
        let first = match flat {
            // A direction within a hundredth of the normal tells nothing.
            Some(flat) if flat.length_squared() > 1e-4 => flat.normalize(),
            _ => normal.any_orthonormal_vector(),
        };
        Self {
            normal,
            first,
            second: normal.cross(first),
        }
    }

    /// The part of a motion in the plane.
    pub(crate) fn twist(&self, linear: Vector, angular: Vector) -> Twist<f32> {
        Twist::new(
            linear.dot(self.first),
            linear.dot(self.second),
            angular.dot(self.normal),
        )
    }

    /// The part of a force and a torque in the plane.
    pub(crate) fn wrench(&self, force: Vector, torque: Vector) -> Wrench<f32> {
        Wrench {
            force: Vector2::new(force.dot(self.first), force.dot(self.second)),
            torque: torque.dot(self.normal),
        }
    }

    /// A vector of the plane in the world.
    pub(crate) fn world(&self, [x, y]: [f32; 2]) -> Vector {
        self.first * x + self.second * y
    }
}

/// Velocities of a body.
pub(crate) fn motion(body: &RigidBody) -> [Vector; 2] {
    [body.linvel(), body.angvel()]
}

/// What moves against what: the foot's share of a common impulse, and the reduced body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduced {
    pub(crate) body: PlanarBody<f32>,
    /// 1/mass and 1/inertia of the foot and of the ground, in the plane.
    inverse: [[f32; 2]; 2],
}

impl Reduced {
    /// `None` if neither can be moved.
    pub(crate) fn new(foot: &RigidBody, ground: &RigidBody, frame: &Frame) -> Option<Self> {
        let inverse = [foot, ground].map(|body| {
            if !body.is_dynamic() {
                return [0.0; 2];
            }
            let properties = body.mass_properties();
            let turn = properties.effective_world_inv_inertia * frame.normal;
            [1.0 / body.mass(), turn.dot(frame.normal)]
        });
        let [[m1, i1], [m2, i2]] = inverse;
        let body = PlanarBody::new(1.0 / (m1 + m2), 1.0 / (i1 + i2)).ok()?;
        Some(Self { body, inverse })
    }

    /// Shares a change of the relative twist: changes of the foot's and the ground's velocities.
    pub(crate) fn shared(&self, change: &Twist<f32>, frame: &Frame) -> [[Vector; 2]; 2] {
        let [[m1, i1], [m2, i2]] = self.inverse;
        let (m, i) = (m1 + m2, i1 + i2);
        let linear = frame.world([change.velocity.x, change.velocity.y]);
        let angular = frame.normal * change.spin;
        [
            [linear * (m1 / m), angular * (i1 / i)],
            [linear * -(m2 / m), angular * -(i2 / i)],
        ]
    }
}
