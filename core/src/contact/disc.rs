//! The nearest point of a disc.

use super::vector::{dot, length};
use crate::real::Real;
use nalgebra::Vector3;

/// Rounding of a projected vector's own square: within it a vector counts as inside, so that
/// projecting twice changes nothing. Root, reciprocal, two products, the components and the sum of
/// their squares each round by half a unit, all but the last counted twice in the square.
const COLLAR_ULPS: f64 = 8.0;

/// The vector of length ≤ `bound` nearest to `q`: dry friction that resists as much as it may.
///
/// *Special values*: `q` itself, to the bit, inside; NaN for a NaN in either. *Domain*:
/// `bound` ≥ 0. *Accuracy*: 4 ulp of the length.
#[inline(always)]
pub fn project_on_disc<R: Real>(q: &Vector3<R>, bound: R) -> Vector3<R> {
    let length_sq = dot(q, q);
    // A square that is rounded at full precision; a bound whose own square is not then decides as
    // 0 or infinity would, which is right.
    let in_range = length_sq > R::MIN_POSITIVE && length_sq < R::INFINITY;
    if !in_range {
        return project_extreme(q, bound);
    }
    let collar = R::ONE + R::from_f64(COLLAR_ULPS) * R::EPSILON;
    // bound/length, with root and reciprocal side by side.
    let scale = bound * (length_sq.sqrt() * (R::ONE / length_sq));
    // A quotient below the normal numbers has lost digits that its product with q has.
    if scale < R::MIN_POSITIVE && bound > R::ZERO {
        return project_extreme(q, bound);
    }
    q * if length_sq <= bound * bound * collar {
        R::ONE
    } else {
        scale
    }
}

/// Least bits by which the components and the length of a projected vector may round among the
/// subnormal numbers.
const LEAST_BITS: f64 = 3.0;

/// Vectors whose square, or whose quotient with the bound, leaves the normal numbers.
#[cold]
fn project_extreme<R: Real>(q: &Vector3<R>, bound: R) -> Vector3<R> {
    let length = length(q);
    let collar = R::ONE + R::from_f64(COLLAR_ULPS) * R::EPSILON;
    let least = R::MIN_POSITIVE * R::EPSILON;
    let inside = bound > R::ZERO && length <= bound * collar + R::from_f64(LEAST_BITS) * least;
    if length == R::ZERO || inside {
        return *q;
    }
    q / length * bound
}
