//! A wall of the box or of a container: which it is, and where it stands.

use crate::grains::scene::Axis;
use nalgebra::Vector3;
use tribos_contacts::cd::{Rectangle, Wall};

/// An end of an axis of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AxisEnd {
    Low,
    High,
}

/// Which wall of a scene one is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WallId {
    /// An end of the box.
    Side(Axis, AxisEnd),
    /// An inclined plane of a hopper.
    Slope,
    /// What closes a hopper.
    Lid,
    /// A facet of a drum with the unit vector along its motion.
    Facet(Vector3<f64>),
}

/// A wall at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct InitialWall {
    pub face: WallId,
    /// Unit normal into the space of the grains.
    pub inward: Vector3<f64>,
    /// Position along the normal.
    pub place: f64,
    /// The part of its plane that is there.
    pub edges: Option<Rectangle>,
}

impl InitialWall {
    /// A fixed wall.
    pub fn wall(&self) -> Wall {
        Wall {
            edges: self.edges,
            ..Wall::fixed(self.inward, self.place)
        }
    }
}

/// The plate above.
pub(super) const PLATE: WallId = WallId::Side(Axis::Z, AxisEnd::High);

impl Axis {
    /// Index of the coordinate.
    pub(super) fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }

    /// Unit vector along the axis.
    pub(super) fn unit(self) -> Vector3<f64> {
        match self {
            Self::X => Vector3::x(),
            Self::Y => Vector3::y(),
            Self::Z => Vector3::z(),
        }
    }
}

/// Unit normal of an end into the box.
pub(super) fn inward(axis: Axis, end: AxisEnd) -> Vector3<f64> {
    match end {
        AxisEnd::Low => axis.unit(),
        AxisEnd::High => -axis.unit(),
    }
}
