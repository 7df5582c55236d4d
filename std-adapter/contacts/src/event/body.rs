//! A sphere in free flight: where it is, when it meets another one, when it leaves its cell.

use super::impact::Motion;
use nalgebra::Vector3;

/// Distance of the centres of two spheres that touch, squared.
pub(super) const DIAMETER_SQ: f64 = 4.0;

/// A sphere, at its own time: the time of its last collision.
///
/// The place is not wrapped between collisions; the cell counts on with it. Times of events are functions of
/// these numbers alone, so that they do not depend on when they are computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Body {
    pub place: Vector3<f64>,
    pub motion: Motion,
    pub time: f64,
    /// Time of the last collision; −∞ before the first.
    pub last: f64,
    pub cell: [i32; 3],
    /// Number of collisions, which tells events of the past.
    pub count: u32,
}

impl Body {
    /// Place at a time, in free flight.
    pub fn place_at(&self, time: f64) -> Vector3<f64> {
        self.place + self.motion.velocity * (time - self.time)
    }

    /// Time at which two spheres touch, if they do; `shift` is added to the way from `self` to `other`.
    ///
    /// The root c/(−b + √(b² − a c)) of |r + v t|² = 4 R² with a = v², b = r·v, c = r² − 4 R² keeps its digits
    /// where spheres almost touch. Spheres that overlap by rounding and approach collide at once.
    pub fn meeting(&self, other: &Self, shift: &Vector3<f64>) -> Option<f64> {
        let start = if self.time > other.time {
            self.time
        } else {
            other.time
        };
        let apart = other.place_at(start) - self.place_at(start) + shift;
        let velocity = other.motion.velocity - self.motion.velocity;
        let b = apart.dot(&velocity);
        if b >= 0.0 {
            return None;
        }
        let c = apart.norm_squared() - DIAMETER_SQ;
        if c <= 0.0 {
            return Some(start);
        }
        let discriminant = b * b - velocity.norm_squared() * c;
        (discriminant >= 0.0).then(|| start + c / (discriminant.sqrt() - b))
    }

    /// Time at which the sphere leaves its cell, the axis and the direction; none if it rests.
    pub fn crossing(&self, edge: f64) -> Option<(f64, usize, i32)> {
        let mut first: Option<(f64, usize, i32)> = None;
        for (axis, &cell) in self.cell.iter().enumerate() {
            let speed = self.motion.velocity[axis];
            if speed == 0.0 {
                continue;
            }
            let onward = i32::from(speed > 0.0);
            let face = f64::from(cell + onward) * edge;
            let time = self.time + (face - self.place[axis]) / speed;
            if first.is_none_or(|(earliest, ..)| time < earliest) {
                first = Some((time, axis, 2 * onward - 1));
            }
        }
        first
    }
}
