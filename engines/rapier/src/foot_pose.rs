//! Position of a foot in the plane of its group.

use crate::frame::Frame;
use crate::pair::Pair;
use rapier3d::prelude::*;
use tribos_feet::Stance;

/// Position of a foot in the plane after half a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootPose {
    pub(crate) foot: ColliderHandle,
    pub(crate) ground: ColliderHandle,
    pub(crate) stance: Stance,
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
        let place = frame.plane(*foot.rotation() * arm);
        let along = match pair.patch.footprint().is_round() {
            true => [1.0, 0.0],
            false => frame.plane(*foot.rotation() * (pose.rotation * pair.patch.axis())),
        };
        Some(Self {
            foot: pair.foot,
            ground: pair.ground,
            stance: Stance::new(place, along),
        })
    }

    pub(crate) fn is_of(&self, pair: &Pair) -> bool {
        self.foot == pair.foot && self.ground == pair.ground
    }

    /// The position rotated by an angle, given half of it in radians.
    pub(crate) fn turned(self, half: f32) -> Self {
        Self {
            stance: self.stance.turned(half),
            ..self
        }
    }
}
