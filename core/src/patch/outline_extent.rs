//! Where the loops of an outline lie: centroid, radius and area.

use super::outline_check::{OutlineExtent, OutlineLoops, sides};
use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// Centroid, distance of the farthest corner from it, and area, in units of a [`OutlineExtent`].
pub(super) struct Frame<R: Real> {
    pub(super) centroid: Vector2<R>,
    pub(super) radius: R,
    pub(super) area: R,
}

impl<R: Real> Frame<R> {
    pub(super) fn of<'a>(
        loops: impl OutlineLoops<'a, R>,
        scale: &OutlineExtent<R>,
    ) -> Result<Self, OutlineError> {
        let (mut area, mut size) = (R::ZERO, R::ZERO);
        let mut moment = Vector2::new(R::ZERO, R::ZERO);
        for (in_loop, corners) in loops.clone().enumerate() {
            let twice = twice_area(corners, scale);
            if twice == R::ZERO {
                return Err(OutlineError::Flat { in_loop });
            }
            size += twice.abs();
            let sense = R::ONE.copysign(if in_loop == 0 { twice } else { -twice });
            for side in sides(corners) {
                let [a, b] = side.map(|corner| scale.at(corner));
                let part = sense * (a.x * b.y - a.y * b.x);
                area += part;
                moment += (a + b) * part;
            }
        }
        // Holes may leave nothing of it.
        if area <= area_tolerance(size) {
            return Err(OutlineError::Flat { in_loop: 0 });
        }
        let third = R::ONE / (R::from_f64(3.0) * area);
        let centroid = moment * third;
        let mut radius = R::ZERO;
        for corner in loops.flat_map(|corners| corners.iter()) {
            let from = scale.at(corner) - centroid;
            let distance = from.x.hypot(from.y);
            if distance > radius {
                radius = distance;
            }
        }
        Ok(Self {
            centroid,
            radius,
            area: R::HALF * area,
        })
    }
}

/// Twice the signed area of a loop; zero if it is not larger than its own rounding.
pub(super) fn twice_area<R: Real>(corners: &[[R; 2]], scale: &OutlineExtent<R>) -> R {
    let (mut area, mut size) = (R::ZERO, R::ZERO);
    for side in sides(corners) {
        let [a, b] = side.map(|corner| scale.at(corner));
        area += a.x * b.y - a.y * b.x;
        size += (a.x * b.y).abs() + (a.y * b.x).abs();
    }
    if area.abs() > area_tolerance(size) {
        area
    } else {
        R::ZERO
    }
}

/// Rounding of a sum of areas whose magnitudes add up to `size`, or of a number with few digits left.
fn area_tolerance<R: Real>(size: R) -> R {
    R::TWO * R::TWO * R::EPSILON * size + R::MIN_POSITIVE / R::EPSILON
}
