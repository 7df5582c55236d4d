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
    /// Second corner.
    end_x: R,
    end_y: R,
    /// Direction towards the second corner, of length 1.
    tangent_x: R,
    tangent_y: R,
    length: R,
}

impl<R: Real> Edge<R> {
    /// From one corner to another one, which differ.
    pub(crate) fn new(from: Vector2<R>, to: Vector2<R>) -> Self {
        let side = to - from;
        let length = side.x.hypot(side.y);
        let tangent = Vector2::new(side.x / length, side.y / length);
        Self::between([from, to], tangent, length)
    }

    #[inline(always)]
    pub(crate) fn between([from, to]: [Vector2<R>; 2], tangent: Vector2<R>, length: R) -> Self {
        Self {
            x: from.x,
            y: from.y,
            end_x: to.x,
            end_y: to.y,
            tangent_x: tangent.x,
            tangent_y: tangent.y,
            length,
        }
    }

    /// The same edge about another centre, in units of another radius.
    pub(crate) fn about(&self, centre: &Vector2<R>, radius: R) -> Self {
        let ends = [self.start(), self.end()].map(|end| {
            let from = end - centre;
            Vector2::new(from.x / radius, from.y / radius)
        });
        Self::between(ends, self.tangent(), self.length / radius)
    }

    #[inline(always)]
    pub(crate) fn start(&self) -> Vector2<R> {
        Vector2::new(self.x, self.y)
    }

    #[inline(always)]
    pub(crate) fn end(&self) -> Vector2<R> {
        Vector2::new(self.end_x, self.end_y)
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

    /// First corner · outward normal: distance of the centre to the left of the edge's line.
    #[inline(always)]
    pub(crate) fn offset(&self) -> R {
        self.x * self.tangent_y - self.y * self.tangent_x
    }

    /// First corner · tangent.
    #[inline(always)]
    pub(crate) fn along(&self) -> R {
        self.x * self.tangent_x + self.y * self.tangent_y
    }
}
