//! One straight edge of a patch, prepared for line integrals.

use crate::real::Real;
use nalgebra::Vector2;

/// A straight edge. The patch lies to its left.
///
/// Lengths are in units of the patch's radius, positions relative to its centre. A default edge is
/// room for one.
///
/// *Layout*: that of a C structure of seven numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Edge<R> {
    /// First corner.
    x: R,
    y: R,
    /// Direction towards the second corner, of length 1.
    tangent_x: R,
    tangent_y: R,
    length: R,
    /// Distance of the centre to the left of the edge's line: first corner · outward normal.
    offset: R,
    /// First corner · tangent.
    along: R,
}

impl<R: Real> Edge<R> {
    /// From one corner to another one, which differ.
    pub(crate) fn new(from: Vector2<R>, to: Vector2<R>) -> Self {
        let side = to - from;
        let length = side.x.hypot(side.y);
        Self::towards(from, Vector2::new(side.x / length, side.y / length), length)
    }

    #[inline(always)]
    pub(crate) fn towards(from: Vector2<R>, tangent: Vector2<R>, length: R) -> Self {
        Self {
            x: from.x,
            y: from.y,
            tangent_x: tangent.x,
            tangent_y: tangent.y,
            length,
            offset: from.x * tangent.y - from.y * tangent.x,
            along: from.x * tangent.x + from.y * tangent.y,
        }
    }

    /// The same edge about another centre, in units of another radius.
    pub(crate) fn about(&self, centre: &Vector2<R>, radius: R) -> Self {
        let from = self.start() - centre;
        let from = Vector2::new(from.x / radius, from.y / radius);
        Self::towards(from, self.tangent(), self.length / radius)
    }

    #[inline(always)]
    pub(crate) fn start(&self) -> Vector2<R> {
        Vector2::new(self.x, self.y)
    }

    #[inline(always)]
    pub(crate) fn end(&self) -> Vector2<R> {
        self.start() + self.tangent() * self.length
    }

    #[inline(always)]
    pub(crate) fn tangent(&self) -> Vector2<R> {
        Vector2::new(self.tangent_x, self.tangent_y)
    }

    /// Out of the patch.
    #[inline(always)]
    pub(crate) fn normal(&self) -> Vector2<R> {
        Vector2::new(self.tangent_y, -self.tangent_x)
    }

    #[inline(always)]
    pub(crate) fn length(&self) -> R {
        self.length
    }

    /// First corner · outward normal.
    #[inline(always)]
    pub(crate) fn offset(&self) -> R {
        self.offset
    }

    /// First corner · tangent.
    #[inline(always)]
    pub(crate) fn along(&self) -> R {
        self.along
    }
}
