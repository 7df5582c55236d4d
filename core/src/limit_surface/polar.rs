//! A planar vector and a normal component as magnitudes: the surface depends on nothing else.

use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::Vector2;

/// Magnitudes of a planar vector and its normal companion, with what they leave out.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisymmetricPair<R> {
    /// Length of the planar part.
    pub planar: R,
    /// Absolute value of the normal part.
    pub normal: R,
    axis: [R; 2],
    sign: R,
}

impl<R: Real> AxisymmetricPair<R> {
    /// A wrench or twist in parts; both units are left as they are.
    #[inline]
    pub fn new(vector: &Vector2<R>, normal: R) -> Self {
        let planar = length(vector);
        // Without length there is no axis, and none is needed.
        let axis = if planar == R::ZERO {
            [R::ZERO; 2]
        } else {
            [vector.x / planar, vector.y / planar]
        };
        Self {
            planar,
            normal: normal.abs(),
            axis,
            sign: R::ONE.copysign(normal),
        }
    }

    /// A wrench along the same axes.
    #[inline]
    pub fn wrench(&self, force: R, torque: R) -> Wrench<R> {
        let [x, y] = self.axis;
        Wrench::new(force * x, force * y, self.sign * torque)
    }

    /// A twist along the same axes.
    #[inline]
    pub fn twist(&self, speed: R, spin: R) -> Twist<R> {
        let [x, y] = self.axis;
        Twist::new(speed * x, speed * y, self.sign * spin)
    }
}

/// The length, from the squares where these are ordinary numbers. *Accuracy*: 2 ulp.
#[inline]
fn length<R: Real>(vector: &Vector2<R>) -> R {
    let square = vector.x * vector.x + vector.y * vector.y;
    let least = R::LEAST_SPEED * R::LEAST_SPEED;
    if square > least && square < R::ONE / least {
        square.sqrt()
    } else {
        vector.x.hypot(vector.y)
    }
}
