//! Vectors and matrices of three numbers, and symmetric systems of three equations.

use crate::real::Real;
use nalgebra::{Matrix3, Vector3};

/// L D Lᵀ of a symmetric, positive definite matrix.
pub(crate) struct Factors<R> {
    /// Below the diagonal: yx, zx, zy.
    below: [R; 3],
    diagonal: [R; 3],
}

impl<R: Real> Factors<R> {
    /// The factors; pivots that rounding has made too small are raised to `least` of the diagonal.
    pub(crate) fn of(m: &Matrix3<R>, least: R) -> Self {
        let raised = |pivot: R, diagonal: R| {
            let floor = least * diagonal;
            if pivot < floor { floor } else { pivot }
        };
        let x = m.m11;
        let (a, b) = (m.m12 / x, m.m13 / x);
        let y = raised(m.m22 - a * m.m12, m.m22);
        let c = (m.m23 - a * m.m13) / y;
        let z = raised(m.m33 - b * m.m13 - c * c * y, m.m33);
        Self {
            below: [a, b, c],
            diagonal: [x, y, z],
        }
    }

    /// The solution for one right side.
    pub(crate) fn solve(&self, right: &Vector3<R>) -> Vector3<R> {
        let ([a, b, c], [x, y, z]) = (self.below, self.diagonal);
        let second = right.y - a * right.x;
        let third = right.z - b * right.x - c * second;
        let n = third / z;
        let v = second / y - c * n;
        Vector3::new(right.x / x - a * v - b * n, v, n)
    }

    /// The inverse.
    pub(crate) fn inverse(&self) -> Matrix3<R> {
        let (one, zero) = (R::ONE, R::ZERO);
        let [x, y, z] = [
            Vector3::new(one, zero, zero),
            Vector3::new(zero, one, zero),
            Vector3::new(zero, zero, one),
        ]
        .map(|axis| self.solve(&axis));
        Matrix3::from_columns(&[x, y, z])
    }
}

pub(crate) fn dot<R: Real>(a: &Vector3<R>, b: &Vector3<R>) -> R {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// |a|·|b|, part by part: what a·b rounds by, over the rounding error.
pub(crate) fn dot_of_sizes<R: Real>(a: &Vector3<R>, b: &Vector3<R>) -> R {
    (a.x * b.x).abs() + (a.y * b.y).abs() + (a.z * b.z).abs()
}

pub(crate) fn norm<R: Real>(a: &Vector3<R>) -> R {
    a.x.hypot(a.y).hypot(a.z)
}

/// a/size, whose reciprocal may be out of range.
pub(crate) fn over<R: Real>(a: &Vector3<R>, size: R) -> Vector3<R> {
    Vector3::new(a.x / size, a.y / size, a.z / size)
}

/// g gᵀ
pub(crate) fn outer<R: Real>(g: &Vector3<R>) -> Matrix3<R> {
    let (x, y, z) = (g.x, g.y, g.z);
    Matrix3::new(
        x * x,
        x * y,
        x * z,
        x * y,
        y * y,
        y * z,
        x * z,
        y * z,
        z * z,
    )
}

/// `factor` · m with another unit of length in the last row and column.
pub(crate) fn stretched<R: Real>(m: &Matrix3<R>, factor: R, [row, column]: [R; 2]) -> Matrix3<R> {
    let (right, below) = (factor * column, factor * row);
    Matrix3::new(
        factor * m.m11,
        factor * m.m12,
        right * m.m13,
        factor * m.m21,
        factor * m.m22,
        right * m.m23,
        below * m.m31,
        below * m.m32,
        below * column * m.m33,
    )
}

/// A matrix times a symmetric one.
pub(crate) fn product<R: Real>(a: &Matrix3<R>, b: &Matrix3<R>) -> Matrix3<R> {
    let rows = |m: &Matrix3<R>| {
        [
            Vector3::new(m.m11, m.m12, m.m13),
            Vector3::new(m.m21, m.m22, m.m23),
            Vector3::new(m.m31, m.m32, m.m33),
        ]
    };
    let ([ax, ay, az], [bx, by, bz]) = (rows(a), rows(b));
    let row = |a: &Vector3<R>| [dot(a, &bx), dot(a, &by), dot(a, &bz)];
    let ([xx, xy, xz], [yx, yy, yz], [zx, zy, zz]) = (row(&ax), row(&ay), row(&az));
    Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz)
}

pub(crate) fn unit_matrix<R: Real>() -> Matrix3<R> {
    let (one, zero) = (R::ONE, R::ZERO);
    Matrix3::new(one, zero, zero, zero, one, zero, zero, zero, one)
}
