//! Position of a foot in the plane of its group.

use crate::frame::Frame;
use crate::pair::Pair;
use rapier3d::prelude::*;

/// Position of a foot in the plane after half a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootPose {
    pub(crate) foot: ColliderHandle,
    pub(crate) ground: ColliderHandle,
    pub(crate) place: [f64; 2],
    /// Direction of the foot's own x.
    pub(crate) axis: [f64; 2],
}

impl FootPose {
    /// The current position of a foot in the plane.
    pub(crate) fn now(
        pair: &Pair,
        frame: &Frame,
        foot: &RigidBody,
        colliders: &ColliderSet,
    ) -> Option<Self> {
        let pose = colliders.get(pair.foot)?.position_wrt_parent()?;
        let arm = pose.transform_point(pair.patch.center()) - foot.local_center_of_mass();
        let along = *foot.rotation() * (pose.rotation * pair.patch.axis());
        let [c, s] = frame.plane(along).map(f64::from);
        let length = (c * c + s * s).sqrt();
        // A direction within a hundredth of the normal is undefined in the plane.
        let axis = match length > 1e-2 {
            true => [c / length, s / length],
            false => [1.0, 0.0],
        };
        Some(Self {
            foot: pair.foot,
            ground: pair.ground,
            place: frame.plane(*foot.rotation() * arm).map(f64::from),
            axis,
        })
    }

    pub(crate) fn is_of(&self, pair: &Pair) -> bool {
        self.foot == pair.foot && self.ground == pair.ground
    }

    /// The position rotated by an angle, given half of it in radians; accurate to third order.
    pub(crate) fn turned(self, half: f32) -> Self {
        let half = f64::from(half);
        let scale = 1.0 / (1.0 + half * half);
        let [cos, sin] = [(1.0 - half * half) * scale, 2.0 * half * scale];
        let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        Self {
            place: turn(self.place),
            axis: turn(self.axis),
            ..self
        }
    }
}
