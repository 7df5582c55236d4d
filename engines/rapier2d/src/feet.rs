//! What a body lies on.

use crate::refusal::FloorError;
use rapier2d::prelude::*;
use tribos_feet::Footprint;

/// An area on which a body lies.
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::{Floor, Footprint, PlacedFoot};
/// let mut world = PhysicsWorld::new();
/// let (sledge, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::cuboid(0.6, 0.25));
/// let runner = Footprint::bar(0.5)?;
/// let feet = [-0.2, 0.2].map(|y| PlacedFoot::new(runner.clone(), Pose::translation(0.0, y)));
/// let mut snow = Floor::new(0.05, 9.81)?;
/// snow.set_feet(sledge, feet.to_vec())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct PlacedFoot {
    /// The shape.
    pub footprint: Footprint,
    /// Position and orientation of the foot in the body's frame.
    pub pose: Pose,
    /// Share of the body's load, relative to the other feet.
    pub share: f32,
}

impl PlacedFoot {
    /// A foot at `pose` in the body's frame, with the same share of the load as the others.
    pub fn new(footprint: Footprint, pose: Pose) -> Self {
        Self {
            footprint,
            pose,
            share: 1.0,
        }
    }
}

/// Refuses feet that carry nothing.
pub(crate) fn checked(feet: &[PlacedFoot]) -> Result<(), FloorError> {
    if feet.is_empty() {
        return Err(FloorError::NoFeet);
    }
    let is_sound =
        |foot: &PlacedFoot| foot.share > 0.0 && foot.share.is_finite() && foot.pose.is_finite();
    match feet.iter().position(|foot| !is_sound(foot)) {
        Some(number) => Err(FloorError::Foot { number }),
        None => Ok(()),
    }
}
