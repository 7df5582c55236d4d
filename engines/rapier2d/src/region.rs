//! Parts of the floor with another coefficient of friction.

use rapier2d::parry::bounding_volume::Aabb;
use rapier2d::prelude::*;

/// A region of a floor.
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::Floor;
/// let mut floor = Floor::new(0.3, 9.81)?;
/// let ice = floor.add_region(SharedShape::ball(2.0), Pose::translation(5.0, 0.0), 0.02)?;
/// assert_eq!(floor.mu_at(Vector::new(5.0, 1.0)), 0.02);
/// assert!(floor.remove_region(ice));
/// assert_eq!(floor.mu_at(Vector::new(5.0, 1.0)), 0.3);
/// # Ok::<(), tribos_rapier2d::FloorError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct RegionId(pub(crate) u32);

/// A shape on the floor.
#[derive(Clone)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct Region {
    pub(crate) id: RegionId,
    shape: SharedShape,
    pose: Pose,
    bounds: Aabb,
    pub(crate) mu: f32,
}

impl Region {
    pub(crate) fn new(id: RegionId, shape: SharedShape, pose: Pose, mu: f32) -> Self {
        Self {
            id,
            bounds: shape.compute_aabb(&pose),
            shape,
            pose,
            mu,
        }
    }

    pub(crate) fn contains(&self, point: Vector) -> bool {
        self.bounds.contains_local_point(point) && self.shape.contains_point(&self.pose, point)
    }

    /// Whether a disk may reach into it.
    pub(crate) fn is_near(&self, middle: Vector, radius: f32) -> bool {
        let [least, most] = [self.bounds.mins, self.bounds.maxs];
        let nearest = middle.clamp(least, most);
        (nearest - middle).length() <= radius
    }
}

impl core::fmt::Debug for Region {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut region = f.debug_struct("Region");
        region.field("id", &self.id).field("mu", &self.mu).finish()
    }
}
