//! The contact plane: two tangents and a normal, and motions in it.

use avian3d::dynamics::solver::solver_body::SolverBody;
use bevy::math::Vec3;
use tribos_core::twist::{Twist, Wrench};

/// Right-handed axes of a contact, the normal pointing from the ground to the foot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) normal: Vec3,
    first: Vec3,
    second: Vec3,
}

/// A change of a body's linear and angular velocity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    pub(crate) linear: Vec3,
    pub(crate) angular: Vec3,
}

impl Change {
    pub(crate) const ZERO: Self = Self {
        linear: Vec3::ZERO,
        angular: Vec3::ZERO,
    };

    /// The velocities of a body.
    pub(crate) fn velocity(body: &SolverBody) -> Self {
        Self {
            linear: body.linear_velocity,
            angular: body.angular_velocity,
        }
    }

    /// The part in a plane.
    pub(crate) fn within(&self, frame: &Frame) -> Self {
        Self {
            linear: frame.flat(self.linear),
            angular: frame.normal * frame.normal.dot(self.angular),
        }
    }

    /// Adds the change to a body's velocities.
    pub(crate) fn apply(&self, body: &mut SolverBody) {
        body.linear_velocity += self.linear;
        body.angular_velocity += self.angular;
    }
}

impl Frame {
    /// Axes with the first in any direction, the same for the same normal.
    pub(crate) fn new(normal: Vec3) -> Self {
        let first = normal.any_orthonormal_vector();
        Self {
            normal,
            first,
            second: normal.cross(first),
        }
    }

    /// Coordinates in the plane.
    pub(crate) fn plane(&self, vector: Vec3) -> [f32; 2] {
        [vector.dot(self.first), vector.dot(self.second)]
    }

    /// The part of a vector in the plane.
    pub(crate) fn flat(&self, vector: Vec3) -> Vec3 {
        vector - self.normal * self.normal.dot(vector)
    }

    /// The part of a motion in the plane.
    pub(crate) fn twist(&self, motion: &Change) -> Twist<f32> {
        let [x, y] = self.plane(motion.linear);
        Twist::new(x, y, motion.angular.dot(self.normal))
    }

    /// A motion in the plane as one of the world.
    pub(crate) fn motion(&self, twist: &Twist<f32>) -> Change {
        Change {
            linear: self.first * twist.velocity.x + self.second * twist.velocity.y,
            angular: self.normal * twist.spin,
        }
    }

    /// Force and torque of a wrench in the world.
    pub(crate) fn wrench(&self, wrench: &Wrench<f32>) -> [Vec3; 2] {
        let force = self.first * wrench.force.x + self.second * wrench.force.y;
        [force, self.normal * wrench.torque]
    }

    /// The part of a force and a torque in the plane.
    pub(crate) fn flat_wrench(&self, force: Vec3, torque: Vec3) -> Wrench<f32> {
        let [x, y] = self.plane(force);
        Wrench::new(x, y, torque.dot(self.normal))
    }
}

/// The motion of a foot relative to its ground at the foot's centre of mass, which is at `arm` from the
/// ground's centre of mass.
pub(crate) fn relative(foot: &Change, ground: &Change, arm: Vec3) -> Change {
    Change {
        linear: foot.linear - ground.linear - ground.angular.cross(arm),
        angular: foot.angular - ground.angular,
    }
}
