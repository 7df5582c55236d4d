//! Outlines of pushed bodies: which side a pusher touches.

use tribos_core::Real;
use tribos_core::coupling::flat::PatchShape;
use tribos_friction::{FrictionError, Patch};

/// Corners of a polygon that stands for a circle in pictures.
const ROUND: u32 = 180;

/// The outline of a patch.
pub(super) struct Shape {
    /// The outer loop first.
    pub loops: Vec<Vec<[f64; 2]>>,
    /// Centre of a patch with straight edges.
    pub centroid: Option<[f64; 2]>,
    is_round: bool,
}

impl Shape {
    pub fn of(patch: &Patch, radius: f64) -> Result<Self, FrictionError> {
        if let Patch::Flat(flat) = patch {
            let centre = flat.loaded::<f64>(None)?.centre();
            return Ok(Self {
                loops: flat.loops()?,
                centroid: Some([centre.x, centre.y]),
                is_round: false,
            });
        }
        let corner = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(ROUND);
            [radius * Real::cos(angle), radius * Real::sin(angle)]
        };
        Ok(Self {
            loops: vec![(0..ROUND).map(corner).collect()],
            centroid: None,
            is_round: true,
        })
    }
}

/// The inward normal of the side nearest to a place of an outline with straight edges, and how far the ends of
/// that side are from there, to the right and to the left of somebody who looks inwards.
///
/// The outer loop comes first, in either sense; a loop of two corners is a bar.
#[doc(hidden)]
pub fn straight_side(loops: Vec<Vec<[f64; 2]>>, at: [f64; 2]) -> [[f64; 2]; 2] {
    let shape = Shape {
        loops,
        centroid: None,
        is_round: false,
    };
    nearest_side(&shape, at)
}

/// The inward normal of the side nearest to a place, and how far its ends are from there, to the right and
/// to the left of somebody who looks inwards.
pub(super) fn nearest_side(shape: &Shape, at: [f64; 2]) -> [[f64; 2]; 2] {
    let [x, y] = at;
    if shape.is_round {
        return [[-x, -y], [f64::INFINITY; 2]];
    }
    let mut nearest = (f64::INFINITY, [[0.0; 2]; 2]);
    for (number, corners) in shape.loops.iter().enumerate() {
        let next = corners.iter().cycle().skip(1);
        let twice: f64 = corners
            .iter()
            .zip(next.clone())
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum();
        // The body lies to the left of an outer loop that runs counterclockwise; a bar has two sides.
        let mut sense = if (twice >= 0.0) == (number == 0) {
            1.0
        } else {
            -1.0
        };
        for (a, b) in corners.iter().zip(next) {
            let along = [b[0] - a[0], b[1] - a[1]];
            let length = Real::hypot(along[0], along[1]);
            let unit = along.map(|part| part / length);
            let from = [x - a[0], y - a[1]];
            let place = from[0] * unit[0] + from[1] * unit[1];
            let off = unit[0] * from[1] - unit[1] * from[0];
            let beyond = (-place).max(place - length).max(0.0);
            let distance = Real::hypot(off, beyond);
            if distance < nearest.0 {
                if twice == 0.0 {
                    sense = if off > 0.0 { -1.0 } else { 1.0 };
                }
                let normal = [-unit[1] * sense, unit[0] * sense];
                // Looking along the normal, the way of the loop leads to the right.
                let ends = [length - place, place];
                let ends = if sense > 0.0 {
                    ends
                } else {
                    [ends[1], ends[0]]
                };
                nearest = (distance, [normal, ends]);
            }
        }
    }
    nearest.1
}
