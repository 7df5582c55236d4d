//! The box: which walls it has, and its current lengths.

use super::container;
use super::wall::{AxisEnd, InitialWall, WallId, inward};
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene, SideBoundary};
use crate::packing::{InitialSpheres, Packing};
use std::array;
use tribos_base::space::{PeriodicBox, SpaceError};
use tribos_contacts::cd::Wall;

/// Walls of a box at its start.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub space: PeriodicBox,
    /// The walls, in the order of the packing's.
    pub parts: Vec<InitialWall>,
    /// Lengths at the start; along an open axis that of the grains.
    pub lengths: [f64; 3],
}

/// Height of the box: that of the scene, or as high as the free grains with those glued to the plate.
pub(super) fn height(scene: &GrainsScene, start: &InitialSpheres) -> f64 {
    let grains = start
        .positions
        .iter()
        .zip(&start.radii)
        .zip(&start.kinds.materials);
    let free = grains.filter(|(_, kind)| scene.holder(**kind).is_none());
    let top = free
        .map(|((x, radius), _)| x.z + radius)
        .fold(0.0, f64::max);
    let glued = scene.rough_lid.unwrap_or(0.0);
    scene.height.unwrap_or(top + glued)
}

impl Layout {
    /// The box of a scene around its grains.
    pub fn of(scene: &GrainsScene, start: &InitialSpheres) -> Result<Self, SpaceError> {
        let height = match scene.container {
            Container::Drum => scene.width,
            _ => height(scene, start),
        };
        let lengths = [scene.width, scene.box_depth(), height];
        let lengths = array::from_fn(|axis| start.periods[axis].unwrap_or(lengths[axis]));
        let is_drum = scene.container == Container::Drum;
        let repeats = [
            scene.boundary_x == SideBoundary::Periodic && !is_drum,
            scene.boundary_y == SideBoundary::Periodic && !scene.is_flat(),
            scene.boundary_z == EndBoundary::Periodic,
        ];
        let periods = [0, 1, 2].map(|axis: usize| repeats[axis].then_some(lengths[axis]));
        let side = |face: (Axis, AxisEnd)| InitialWall {
            face: WallId::Side(face.0, face.1),
            inward: inward(face.0, face.1),
            place: match face.1 {
                AxisEnd::Low => 0.0,
                AxisEnd::High => -lengths[face.0.index()],
            },
            edges: None,
        };
        let mut parts = Vec::new();
        match scene.boundary_z {
            _ if is_drum => {}
            EndBoundary::Floor => parts.push(side((Axis::Z, AxisEnd::Low))),
            EndBoundary::Walls => {
                parts.extend([AxisEnd::Low, AxisEnd::High].map(|end| side((Axis::Z, end))))
            }
            EndBoundary::Periodic => {}
        }
        for (axis, sides) in [(Axis::X, scene.boundary_x), (Axis::Y, scene.boundary_y)] {
            if sides == SideBoundary::Walls {
                parts.extend([AxisEnd::Low, AxisEnd::High].map(|end| side((axis, end))));
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
    pub fn wall(&self, face: WallId) -> Option<u32> {
        let found = self.parts.iter().position(|part| part.face == face);
        found.map(|wall| wall as u32)
    }

    /// Current coordinate of a face.
    fn coordinate(&self, walls: &[Wall], axis: Axis, end: AxisEnd) -> Option<f64> {
        let wall = walls.get(self.wall(WallId::Side(axis, end))? as usize)?;
        Some(match end {
            AxisEnd::Low => wall.place,
            AxisEnd::High => -wall.place,
        })
    }

    /// Low and high coordinates of the box; an open end is that of the start.
    pub fn extents(&self, packing: &dyn Packing) -> [[f64; 2]; 3] {
        let (walls, periods) = (packing.walls(), packing.space().lengths());
        [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            let length = periods[axis.index()].unwrap_or(self.lengths[axis.index()]);
            let low = self.coordinate(walls, axis, AxisEnd::Low);
            let high = self.coordinate(walls, axis, AxisEnd::High);
            [low.unwrap_or(0.0), high.unwrap_or(length)]
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
