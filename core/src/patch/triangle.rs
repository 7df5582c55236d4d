//! One triangle of a mesh, prepared for integrals over it.

use super::edge::Edge;
use super::flat_pressure::LinearPressure;
use crate::real::Real;
use nalgebra::Vector2;

/// A triangle under linear pressure.
///
/// Lengths are in units of the mesh's radius, positions relative to its centre, pressures such that
/// the mesh carries 1. A default triangle is room for one.
///
/// *Layout*: that of a C structure of 16 numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Triangle<R> {
    /// First corner, and from there to the others, counterclockwise: a small triangle that is far away
    /// keeps its shape.
    corner: [R; 2],
    second: [R; 2],
    third: [R; 2],
    /// At the corners.
    pressures: [R; 3],
    /// Squared distance of the farthest corner from the middle.
    size_sq: R,
    /// Lengths of the edges, each from one corner to the next one, and 1 over each.
    lengths: [R; 3],
    inv_lengths: [R; 3],
}

impl<R: Real> Triangle<R> {
    /// From the first corner, the sides to the others, which enclose an area, and pressures.
    pub(super) fn new(corner: Vector2<R>, sides: [Vector2<R>; 2], pressures: [R; 3]) -> Self {
        let ([b, c], [p, q, r]) = (sides, pressures);
        let ([b, c], pressures) = if cross(&b, &c) < R::ZERO {
            ([c, b], [p, r, q])
        } else {
            (sides, pressures)
        };
        let middle = (b + c) * R::from_f64(1.0 / 3.0);
        let mut size_sq = R::ZERO;
        for from in [middle, b - middle, c - middle] {
            let sq = from.x * from.x + from.y * from.y;
            if sq > size_sq {
                size_sq = sq;
            }
        }
        let lengths = [b, c - b, c].map(|side| side.x.hypot(side.y));
        Self {
            corner: [corner.x, corner.y],
            second: [b.x, b.y],
            third: [c.x, c.y],
            pressures,
            size_sq,
            lengths,
            inv_lengths: lengths.map(|length| R::ONE / length),
        }
    }

    /// Its first corner.
    #[inline(always)]
    pub(crate) fn corner(&self) -> Vector2<R> {
        let [x, y] = self.corner;
        Vector2::new(x, y)
    }

    /// From the first corner to the second and to the third one.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [Vector2<R>; 2] {
        [self.second, self.third].map(|[x, y]| Vector2::new(x, y))
    }

    /// Pressures at its corners.
    #[inline(always)]
    pub(crate) fn pressures(&self) -> [R; 3] {
        self.pressures
    }

    /// From the first corner to the mean of all.
    #[inline(always)]
    pub(crate) fn middle_from_corner(&self) -> Vector2<R> {
        let [b, c] = self.sides();
        (b + c) * R::from_f64(1.0 / 3.0)
    }

    /// Squared distance of the farthest corner from the middle.
    #[inline(always)]
    pub(crate) fn size_sq(&self) -> R {
        self.size_sq
    }

    /// Twice its area.
    #[inline(always)]
    pub(crate) fn twice_area(&self) -> R {
        let [b, c] = self.sides();
        cross(&b, &c)
    }

    /// Half the length of its longest edge.
    #[inline(always)]
    pub(crate) fn longest_half(&self) -> R {
        let [a, b, c] = self.lengths;
        let longer = if a > b { a } else { b };
        R::HALF * if longer > c { longer } else { c }
    }

    /// Slope of the pressure.
    #[inline(always)]
    pub(crate) fn slope(&self) -> [R; 2] {
        let ([b, c], [p, q, r]) = (self.sides(), self.pressures);
        let (second, third) = (q - p, r - p);
        let inv = R::ONE / cross(&b, &c);
        [
            (second * c.y - third * b.y) * inv,
            (third * b.x - second * c.x) * inv,
        ]
    }

    /// Load of a square of its size under its mean pressure and what the slope adds to that over its size: cones
    /// about a place so far away carry as much, and cancel each other but for the triangle.
    #[inline]
    pub(crate) fn load_of_cones(&self) -> R {
        let ([p, q, r], [x, y]) = (self.pressures, self.slope());
        let mean = R::from_f64(1.0 / 3.0) * (p + q + r);
        self.size_sq * (mean + x.hypot(y) * self.size_sq.sqrt())
    }

    /// Its pressure about the mesh's centre.
    #[inline(always)]
    pub(crate) fn pressure(&self) -> LinearPressure<R> {
        let (slope, [p, ..]) = (self.slope(), self.pressures);
        let [x, y] = slope;
        LinearPressure::new(p - x * self.corner().x - y * self.corner().y, slope)
    }

    /// Directions of its edges, their lengths, and 1 over these.
    #[inline(always)]
    pub(crate) fn directions(&self) -> [(Vector2<R>, R, R); 3] {
        let ([b, c], [l, m, n]) = (self.sides(), self.lengths);
        let [inv_l, inv_m, inv_n] = self.inv_lengths;
        [
            (b * inv_l, l, inv_l),
            ((c - b) * inv_m, m, inv_m),
            (c * -inv_n, n, inv_n),
        ]
    }

    /// Its edges, as line integrals need them.
    #[inline(always)]
    pub(crate) fn edges(&self) -> [Edge<R>; 3] {
        let (a, [b, c]) = (self.corner(), self.sides());
        let [first, second, third] = self.directions();
        let edge = |ends, (tangent, length, _)| Edge::between(ends, tangent, length);
        let (b, c) = (a + b, a + c);
        [
            edge([a, b], first),
            edge([b, c], second),
            edge([c, a], third),
        ]
    }
}

/// a × b
pub(super) fn cross<R: Real>(a: &Vector2<R>, b: &Vector2<R>) -> R {
    a.x * b.y - a.y * b.x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half of a square under the load 1, without pressure at one corner.
    fn load_of_cones<R: Real>(side: R) -> f64 {
        let (none, most) = (R::ZERO, R::from_f64(3.0) / (side * side));
        let sides = [Vector2::new(side, none), Vector2::new(none, side)];
        let half = Triangle::new(Vector2::new(none, none), sides, [none, most, most]);
        half.load_of_cones().to_f64()
    }

    #[test]
    fn slopes_whose_squares_overflow_count_as_those_of_a_larger_triangle() {
        let expected = (10.0 + 5.0 * libm::sqrt(10.0)) / 9.0;
        for found in [
            load_of_cones(1.0_f64),
            load_of_cones(1e-100_f64),
            load_of_cones(1e-12_f32),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-6, "{found}");
        }
    }
}
