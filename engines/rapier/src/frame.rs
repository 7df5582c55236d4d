//! The contact plane: two tangents and a normal, and motions in it.

use nalgebra::Vector2;
use rapier3d::prelude::*;
use tribos_core::twist::Twist;

/// Right-handed axes of a contact, the normal pointing from the ground to the foot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) normal: Vector,
    first: Vector,
    second: Vector,
}

impl Frame {
    /// Axes with the first in any direction, the same for the same normal.
    pub(crate) fn new(normal: Vector) -> Self {
        let first = normal.any_orthonormal_vector();
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

    /// Coordinates in the plane.
    pub(crate) fn plane(&self, vector: Vector) -> [f32; 2] {
        [vector.dot(self.first), vector.dot(self.second)]
    }

    /// A vector of the plane in the world.
    pub(crate) fn world(&self, vector: &Vector2<f32>) -> Vector {
        self.first * vector.x + self.second * vector.y
    }

    /// The part of a vector in the plane.
    pub(crate) fn flat(&self, vector: Vector) -> Vector {
        vector - self.normal * self.normal.dot(vector)
    }
}

/// The motion of the foot relative to the ground, at the foot's centre of mass. A ground without
/// body is at rest.
pub(crate) fn relative(frame: &Frame, foot: &RigidBody, ground: Option<&RigidBody>) -> Twist<f32> {
    let (below, turn) = ground.map_or((Vector::ZERO, Vector::ZERO), |ground| {
        let below = ground.velocity_at_point(foot.center_of_mass());
        (below, ground.angvel())
    });
    frame.twist(foot.linvel() - below, foot.angvel() - turn)
}

/// Acceleration of the ground below the foot due to the ground's rotation.
pub(crate) fn carried(foot: &RigidBody, ground: Option<&RigidBody>) -> Vector {
    ground.map_or(Vector::ZERO, |ground| {
        ground.angvel().cross(foot.linvel() - ground.linvel())
    })
}
