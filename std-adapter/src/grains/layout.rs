//! The box: which walls it has, and its current lengths.

use super::placement::Start;
use crate::cd::Wall;
use crate::scene::{Axis, Ends, GrainsScene, Sides};
use crate::space::{PeriodicBox, PeriodicBoxError};
use nalgebra::Vector3;

/// An end of an axis of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Low,
    High,
}

/// A wall's place in the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Face {
    pub axis: Axis,
    pub end: End,
}

/// The floor.
pub(super) const FLOOR: Face = Face {
    axis: Axis::Z,
    end: End::Low,
};
/// The plate above.
pub(super) const PLATE: Face = Face {
    axis: Axis::Z,
    end: End::High,
};

/// Walls of a box at its start.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub space: PeriodicBox,
    /// Faces of the walls, in the order of the packing's.
    pub faces: Vec<Face>,
    /// Lengths at the start; along an open axis that of the grains.
    pub lengths: [f64; 3],
}

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

impl Face {
    /// Unit normal into the box.
    pub fn inward(self) -> Vector3<f64> {
        match self.end {
            End::Low => self.axis.unit(),
            End::High => -self.axis.unit(),
        }
    }
}

impl Layout {
    /// The box of a scene around its grains.
    pub fn of(scene: &GrainsScene, start: &Start) -> Result<Self, PeriodicBoxError> {
        let grains = start.positions.iter().zip(&start.radii);
        let top = grains.map(|(x, radius)| x.z + radius).fold(0.0, f64::max);
        let height = scene.height.unwrap_or(top);
        let lengths = [scene.width, scene.box_depth(), height];
        let repeats = [
            scene.x == Sides::Periodic,
            scene.y == Sides::Periodic && !scene.is_flat(),
            scene.z == Ends::Periodic,
        ];
        let periods = [0, 1, 2].map(|axis: usize| repeats[axis].then_some(lengths[axis]));
        let mut faces = Vec::new();
        match scene.z {
            Ends::Floor => faces.push(FLOOR),
            Ends::Walls => faces.extend([FLOOR, PLATE]),
            Ends::Periodic => {}
        }
        for (axis, sides) in [(Axis::X, scene.x), (Axis::Y, scene.y)] {
            if sides == Sides::Walls {
                faces.extend([End::Low, End::High].map(|end| Face { axis, end }));
            }
        }
        Ok(Self {
            space: PeriodicBox::new(periods)?,
            faces,
            lengths,
        })
    }

    /// Position of a wall along its normal at the start.
    pub fn place(&self, face: Face) -> f64 {
        match face.end {
            End::Low => 0.0,
            End::High => -self.lengths[face.axis.index()],
        }
    }

    /// Number of a wall.
    pub fn wall(&self, face: Face) -> Option<u32> {
        let found = self.faces.iter().position(|other| *other == face);
        found.map(|wall| wall as u32)
    }

    /// Current coordinate of a face.
    fn coordinate(&self, walls: &[Wall], axis: Axis, end: End) -> Option<f64> {
        let wall = walls.get(self.wall(Face { axis, end })? as usize)?;
        Some(match end {
            End::Low => wall.place,
            End::High => -wall.place,
        })
    }

    /// Low and high coordinates of the box; an open end is that of the start.
    pub fn extents(&self, walls: &[Wall]) -> [[f64; 2]; 3] {
        [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            let low = self.coordinate(walls, axis, End::Low);
            let high = self.coordinate(walls, axis, End::High);
            [
                low.unwrap_or(0.0),
                high.unwrap_or(self.lengths[axis.index()]),
            ]
        })
    }

    /// Area of a wall in a box of these extents.
    pub fn area(extents: &[[f64; 2]; 3], axis: Axis) -> f64 {
        let mut area = 1.0;
        for (other, [low, high]) in extents.iter().enumerate() {
            if other != axis.index() {
                area *= high - low;
            }
        }
        area
    }
}
