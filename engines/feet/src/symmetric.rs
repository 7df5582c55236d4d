//! Vectors of three numbers and symmetric matrices, given as xx, xy, yy, xn, yn, nn.

pub(crate) fn plus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A symmetric matrix times a vector.
pub fn times([xx, xy, yy, xn, yn, nn]: &[f64; 6], v: &[f64; 3]) -> [f64; 3] {
    [
        xx * v[0] + xy * v[1] + xn * v[2],
        xy * v[0] + yy * v[1] + yn * v[2],
        xn * v[0] + yn * v[1] + nn * v[2],
    ]
}

/// The solution of a system with a symmetric positive matrix (L D Lᵀ).
pub fn solved([xx, xy, yy, xn, yn, nn]: &[f64; 6], right: &[f64; 3]) -> [f64; 3] {
    let (a, b) = (xy / xx, xn / xx);
    let second = yy - a * xy;
    let c = (yn - a * xn) / second;
    let third = nn - b * xn - c * c * second;
    let y = right[1] - a * right[0];
    let z = (right[2] - b * right[0] - c * y) / third;
    let y = y / second - c * z;
    [right[0] / xx - a * y - b * z, y, z]
}
