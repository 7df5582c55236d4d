//! The box: which walls it has, and its current lengths.

use super::container;
use super::placement::Start;
use crate::grains::scene::{Axis, Container, Ends, GrainsScene, Sides};
use nalgebra::Vector3;
use tribos_base::space::{PeriodicBox, PeriodicBoxError};
use tribos_contacts::cd::{Rectangle, Wall};

/// An end of an axis of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Low,
    High,
}

/// Which wall of a scene one is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Face {
    /// An end of the box.
    Side(Axis, End),
    /// An inclined plane of a hopper.
    Slope,
    /// What closes a hopper.
    Lid,
    /// A facet of a drum with the unit vector along its motion.
    Facet(Vector3<f64>),
}

/// A wall at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    pub face: Face,
    /// Unit normal into the space of the grains.
    pub inward: Vector3<f64>,
    /// Position along the normal.
    pub place: f64,
    /// The part of its plane that is there.
    pub edges: Option<Rectangle>,
}

impl Part {
    /// A fixed wall.
    pub fn wall(&self) -> Wall {
        Wall {
            edges: self.edges,
            ..Wall::fixed(self.inward, self.place)
        }
    }
}

/// The plate above.
pub(super) const PLATE: Face = Face::Side(Axis::Z, End::High);

/// Walls of a box at its start.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub space: PeriodicBox,
    /// The walls, in the order of the packing's.
    pub parts: Vec<Part>,
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

/// Unit normal of an end into the box.
pub(super) fn inward(axis: Axis, end: End) -> Vector3<f64> {
    match end {
        End::Low => axis.unit(),
        End::High => -axis.unit(),
    }
}

impl Layout {
    /// The box of a scene around its grains.
    pub fn of(scene: &GrainsScene, start: &Start) -> Result<Self, PeriodicBoxError> {
        let grains = start.positions.iter().zip(&start.radii);
        let top = grains.map(|(x, radius)| x.z + radius).fold(0.0, f64::max);
        let height = match scene.container {
            Container::Drum => scene.width,
            _ => scene.height.unwrap_or(top),
        };
        let lengths = [scene.width, scene.box_depth(), height];
        let is_drum = scene.container == Container::Drum;
        let repeats = [
            scene.boundary_x == Sides::Periodic && !is_drum,
            scene.boundary_y == Sides::Periodic && !scene.is_flat(),
            scene.boundary_z == Ends::Periodic,
        ];
        let periods = [0, 1, 2].map(|axis: usize| repeats[axis].then_some(lengths[axis]));
        let side = |face: (Axis, End)| Part {
            face: Face::Side(face.0, face.1),
            inward: inward(face.0, face.1),
            place: match face.1 {
                End::Low => 0.0,
                End::High => -lengths[face.0.index()],
            },
            edges: None,
        };
        let mut parts = Vec::new();
        match scene.boundary_z {
            _ if is_drum => {}
            Ends::Floor => parts.push(side((Axis::Z, End::Low))),
            Ends::Walls => parts.extend([End::Low, End::High].map(|end| side((Axis::Z, end)))),
            Ends::Periodic => {}
        }
        for (axis, sides) in [(Axis::X, scene.boundary_x), (Axis::Y, scene.boundary_y)] {
            if sides == Sides::Walls {
                parts.extend([End::Low, End::High].map(|end| side((axis, end))));
            }
        }
        parts.extend(container::walls(scene));
        Ok(Self {
            space: PeriodicBox::new(periods)?,
            parts,
            lengths,
        })
    }

    /// Number of a wall.
    pub fn wall(&self, face: Face) -> Option<u32> {
        let found = self.parts.iter().position(|part| part.face == face);
        found.map(|wall| wall as u32)
    }

    /// Current coordinate of a face.
    fn coordinate(&self, walls: &[Wall], axis: Axis, end: End) -> Option<f64> {
        let wall = walls.get(self.wall(Face::Side(axis, end))? as usize)?;
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
