//! Products of vectors, written out: the scalar of the kernel has no more than four operations.

use crate::real::Real;
use nalgebra::Vector3;

/// a · b
#[inline(always)]
pub(crate) fn dot<R: Real>(a: &Vector3<R>, b: &Vector3<R>) -> R {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// a × b
#[inline(always)]
pub(crate) fn cross<R: Real>(a: &Vector3<R>, b: &Vector3<R>) -> Vector3<R> {
    Vector3::new(
        a.y * b.z - a.z * b.y,
        a.z * b.x - a.x * b.z,
        a.x * b.y - a.y * b.x,
    )
}

/// a + s b
#[inline(always)]
pub(crate) fn add_scaled<R: Real>(a: &Vector3<R>, s: R, b: &Vector3<R>) -> Vector3<R> {
    Vector3::new(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z)
}

/// The part of `a` in the plane whose unit normal is `normal`.
#[inline(always)]
pub(crate) fn tangential<R: Real>(a: &Vector3<R>, normal: &Vector3<R>) -> Vector3<R> {
    add_scaled(a, -dot(a, normal), normal)
}

/// |a| without overflow or underflow on the way; infinite or NaN with its components.
pub(crate) fn length<R: Real>(a: &Vector3<R>) -> R {
    a.x.hypot(a.y).hypot(a.z)
}

/// |a| as in [`length`], without divisions unless its square leaves the range of the scalar.
#[inline(always)]
pub(crate) fn magnitude<R: Real>(a: &Vector3<R>) -> R {
    let length_sq = dot(a, a);
    if length_sq > R::MIN_POSITIVE && length_sq < R::INFINITY {
        length_sq.sqrt()
    } else {
        length(a)
    }
}

/// The zero vector.
#[inline(always)]
pub(crate) fn zero<R: Real>() -> Vector3<R> {
    Vector3::new(R::ZERO, R::ZERO, R::ZERO)
}
