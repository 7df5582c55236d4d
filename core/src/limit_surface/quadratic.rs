//! Symmetric systems of three equations.

use crate::real::Real;
use nalgebra::{Matrix3, Vector3};

/// L D Lᵀ of a symmetric, positive definite matrix.
pub(super) struct Factors<R> {
    /// Below the diagonal: yx, zx, zy.
    below: [R; 3],
    diagonal: [R; 3],
}

impl<R: Real> Factors<R> {
    /// The factors; pivots that rounding has made too small are raised to `least` of the diagonal.
    pub(super) fn of(m: &Matrix3<R>, least: R) -> Self {
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
    pub(super) fn solve(&self, right: &Vector3<R>) -> Vector3<R> {
        let ([a, b, c], [x, y, z]) = (self.below, self.diagonal);
        let second = right.y - a * right.x;
        let third = right.z - b * right.x - c * second;
        let n = third / z;
        let v = second / y - c * n;
        Vector3::new(right.x / x - a * v - b * n, v, n)
    }

    /// The inverse.
    pub(super) fn inverse(&self) -> Matrix3<R> {
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
