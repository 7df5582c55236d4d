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

    /// A motion in the plane as one of the world.
    pub(crate) fn motion(&self, twist: &Twist<f32>) -> [Vector; 2] {
        [self.world(&twist.velocity), self.normal * twist.spin]
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
    let Some(ground) = ground else {
        return frame.twist(foot.linvel(), foot.angvel());
    };
    let below = ground.velocity_at_point(foot.center_of_mass());
    frame.twist(foot.linvel() - below, foot.angvel() - ground.angvel())
}

/// What the rotation of the ground asks of a foot that it carries through a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameMotion {
    /// Mean acceleration.
    pub(crate) acceleration: Vector,
    /// To be added to the velocity during the step: under that acceleration, the engine's displacement is then that of
    /// the ground below the foot.
    pub(crate) offset: Vector,
}

impl FrameMotion {
    /// What the turning ground asks of the foot in a step of so many substeps.
    ///
    /// *Derivation*: in a step dt the point r turns by θ, to
    /// r + (1 + s) a + (½ + c) b with a = θ × r, b = θ × a, s = sin(θ)/θ − 1, c = (1 − cos θ)/θ² − ½ (Rodrigues), and
    /// its velocity changes by ω times that displacement. The engine turns bodies in n substeps by an angle whose half
    /// has the tangent ω dt/(2n): ω dt = (1 + u) θ, u = θ²/(12n²). An acceleration makes dt²(n + 1)/(2n) in its
    /// substeps. What a foot that slides has beyond the ground's velocity turns to first order.
    pub(crate) fn over(foot: &RigidBody, ground: &RigidBody, dt: f32, substeps: usize) -> Self {
        let late = 0.5 / substeps as f32;
        let angle = ground.angvel() * dt;
        let u = angle.length_squared() * (late * late / 3.0);
        let angle = angle / (1.0 + u);
        let sq = angle.length_squared();
        let a = angle.cross(foot.center_of_mass() - ground.center_of_mass());
        let b = angle.cross(a);
        let [s, c] = [SINE, COSINE].map(|[x, y, z]| -sq * (x - sq * (y - sq * z)));
        // The change of the velocity in dt, beyond the part of first order.
        let more = b * (s - u) - a * (sq * (0.5 + c));
        let turned = ground.angvel().cross(foot.linvel() - ground.linvel());
        Self {
            acceleration: turned + more / (dt * dt),
            offset: (a * (s - u) + b * (c - u) - more * (0.5 + late)) / dt - turned * (late * dt),
        }
    }
}

/// Taylor's series of 1 − sin(θ)/θ and of ½ − (1 − cos θ)/θ², in θ²: 1e-5 of them at one radian.
const SINE: [f32; 3] = [1.0 / 6.0, 1.0 / 120.0, 1.0 / 5040.0];
const COSINE: [f32; 3] = [1.0 / 24.0, 1.0 / 720.0, 1.0 / 40320.0];
