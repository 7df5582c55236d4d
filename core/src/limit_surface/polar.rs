//! A planar vector and a normal component as magnitudes: the surface depends on nothing else.

use crate::lanes::Numbers;
use crate::real::Real;
use nalgebra::Vector2;

/// Magnitudes of a planar vector and its normal companion, with what they leave out.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisymmetricPair<L> {
    /// Length of the planar part.
    pub planar: L,
    /// Absolute value of the normal part.
    pub normal: L,
    axis: [L; 2],
    sign: L,
}

impl<L: Numbers> AxisymmetricPair<L> {
    /// A wrench or twist in parts, both units left as they are. *Domain*: planar parts that are [`is_ordinary`].
    #[inline(always)]
    pub fn of_ordinary([x, y, normal]: [L; 3]) -> Self {
        Self::of_length((x * x + y * y).sqrt(), [x, y, normal])
    }

    #[inline(always)]
    fn of_length(planar: L, [x, y, normal]: [L; 3]) -> Self {
        // Without length there is no axis, and none is needed.
        let zero = L::splat(0.0);
        let is_none = planar.at_most(zero);
        let along = |part: L| L::select(is_none, zero, part / planar);
        Self {
            planar,
            normal: normal.abs(),
            axis: [along(x), along(y)],
            sign: normal,
        }
    }

    /// A vector along the same axes.
    #[inline(always)]
    pub fn vector(&self, [planar, normal]: [L; 2]) -> [L; 3] {
        let [x, y] = self.axis;
        [planar * x, planar * y, normal.with_sign(self.sign)]
    }
}

/// True of a size whose square, quotients and reciprocal are normal numbers, and of none.
#[inline(always)]
pub(super) fn is_ordinary<R: Real, L: Numbers<Real = R>>(size: L) -> L::Mask {
    let (least, most) = (R::LEAST_SPEED, R::ONE / R::LEAST_SPEED);
    L::either(
        L::both(L::repeat(least).below(size), size.below(L::repeat(most))),
        size.abs().at_most(L::splat(0.0)),
    )
}

/// True of a planar vector whose squares give its length.
#[inline(always)]
pub(super) fn is_ordinary_planar<R: Real, L: Numbers<Real = R>>(x: L, y: L) -> L::Mask {
    let (zero, least) = (L::splat(0.0), R::LEAST_SPEED * R::LEAST_SPEED);
    let square = x * x + y * y;
    L::either(
        L::both(
            L::repeat(least).below(square),
            square.below(L::repeat(R::ONE / least)),
        ),
        (x.abs() + y.abs()).at_most(zero),
    )
}

/// A wrench or twist in parts. *Accuracy*: 2 ulp of the length.
#[inline]
pub(super) fn pair<R: Real>(vector: &Vector2<R>, normal: R) -> AxisymmetricPair<R::Alone> {
    let parts = [vector.x, vector.y, normal].map(R::Alone::repeat);
    let [x, y, _] = parts;
    if is_ordinary_planar::<R, R::Alone>(x, y) {
        AxisymmetricPair::of_ordinary(parts)
    } else {
        let length = vector.x.hypot(vector.y);
        AxisymmetricPair::of_length(R::Alone::repeat(length), parts)
    }
}
