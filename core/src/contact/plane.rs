//! Vectors of the contact plane in two axes of their own.

use super::vector::dot as dot_in_space;
use crate::real::Real;
use nalgebra::Vector3;

/// Coordinates in the contact plane.
pub(super) type Planar<R> = [R; 2];

/// Two axes e₁ and e₂ = n × e₁ of the plane across the unit vector n.
pub(super) struct PlaneAxes<R: Real>([Vector3<R>; 2]);

impl<R: Real> PlaneAxes<R> {
    /// Without a square root (Duff et al., J. Comput. Graph. Tech. 6 (2017) 1).
    #[inline(always)]
    pub(super) fn across(normal: &Vector3<R>) -> Self {
        let (x, y, z) = (normal.x, normal.y, normal.z);
        let sign = R::ONE.copysign(z);
        let a = -R::ONE / (sign + z);
        let b = x * y * a;
        Self([
            Vector3::new(R::ONE + sign * (x * x * a), sign * b, -sign * x),
            Vector3::new(b, sign + y * y * a, -y),
        ])
    }

    /// Coordinates of `v`.
    #[inline(always)]
    pub(super) fn coordinates(&self, v: &Vector3<R>) -> Planar<R> {
        let [first, second] = &self.0;
        [dot_in_space(first, v), dot_in_space(second, v)]
    }

    /// Coordinates of n × `v`.
    #[inline(always)]
    pub(super) fn turned_coordinates(&self, v: &Vector3<R>) -> Planar<R> {
        let [x, y] = self.coordinates(v);
        [-y, x]
    }

    /// The vector with these coordinates.
    #[inline(always)]
    pub(super) fn vector(&self, [x, y]: Planar<R>) -> Vector3<R> {
        let [first, second] = &self.0;
        first * x + second * y
    }

    /// The vector v in the plane whose n × v has these coordinates.
    #[inline(always)]
    pub(super) fn turned_vector(&self, [x, y]: Planar<R>) -> Vector3<R> {
        self.vector([y, -x])
    }
}

/// The direction of `a`, with root and reciprocal side by side; NaN if its square is out of range.
#[inline(always)]
pub(super) fn unit<R: Real>(a: Planar<R>) -> Planar<R> {
    let length_sq = dot(a, a);
    scaled(a, length_sq.sqrt() * (R::ONE / length_sq))
}

/// s a
#[inline(always)]
pub(super) fn scaled<R: Real>([x, y]: Planar<R>, s: R) -> Planar<R> {
    [x * s, y * s]
}

/// a + s b
#[inline(always)]
pub(super) fn add_scaled<R: Real>([ax, ay]: Planar<R>, s: R, [bx, by]: Planar<R>) -> Planar<R> {
    [ax + s * bx, ay + s * by]
}

/// a − b
#[inline(always)]
pub(super) fn minus<R: Real>([ax, ay]: Planar<R>, [bx, by]: Planar<R>) -> Planar<R> {
    [ax - bx, ay - by]
}

/// a · b
#[inline(always)]
pub(super) fn dot<R: Real>([ax, ay]: Planar<R>, [bx, by]: Planar<R>) -> R {
    ax * bx + ay * by
}

/// The component of a × b along the normal.
#[inline(always)]
pub(super) fn cross<R: Real>([ax, ay]: Planar<R>, [bx, by]: Planar<R>) -> R {
    ax * by - ay * bx
}
