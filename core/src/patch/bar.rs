//! A straight line that carries load: a blade, a skate, the edge of a box.

use super::affine_image::AffineMap;
use super::edge::Edge;
use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// A straight bar under uniform pressure: the limit of a rectangle that becomes ever thinner.
///
/// *Units*: length.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::twist::Twist;
/// let blade = ShapeFriction::new(Bar::new([-0.1_f64, 0.0], [0.1, 0.0])?, 0.05)?; // m, mu
/// let pivoting = blade.wrench(700.0, &Twist::new(0.0, 0.0, 1.0)); // N; rad/s
/// assert!((pivoting.torque + 0.05 * 700.0 * 0.05).abs() < 1e-14); // mean distance: 5 cm
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar<R: Real> {
    /// In units of half the length, about the middle.
    edge: Edge<R>,
    centre: Vector2<R>,
    radius: R,
}

impl<R: Real> Bar<R> {
    /// The bar between two points.
    ///
    /// *Domain*: finite points a finite, positive distance apart.
    pub fn new(from: [R; 2], to: [R; 2]) -> Result<Self, OutlineError> {
        let ends = [from, to];
        for (corner, end) in ends.iter().enumerate() {
            if !end.iter().all(|part| part.is_finite()) {
                let in_loop = 0;
                return Err(OutlineError::Position { in_loop, corner });
            }
        }
        let [half_x, half_y] = [
            R::HALF * to[0] - R::HALF * from[0],
            R::HALF * to[1] - R::HALF * from[1],
        ];
        let radius = half_x.hypot(half_y);
        if radius == R::ZERO {
            let (in_loop, corner) = (0, 0);
            return Err(OutlineError::Repeated { in_loop, corner });
        }
        if !radius.is_finite() {
            return Err(OutlineError::Extent);
        }
        let end = Vector2::new(half_x / radius, half_y / radius);
        Ok(Self {
            edge: Edge::new(-end, end),
            centre: Vector2::new(from[0] + half_x, from[1] + half_y),
            radius,
        })
    }

    /// Both ends.
    pub fn ends(&self) -> [[R; 2]; 2] {
        [self.edge.start(), self.edge.end()].map(|end| {
            let at = self.centre + end * self.radius;
            [at.x, at.y]
        })
    }

    /// Its middle.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Half of its length.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// Its image under a linear map.
    pub(super) fn moved(&self, map: &AffineMap<R>) -> Self {
        let end = map.of_vector(&self.edge.end());
        let reach = end.x.hypot(end.y);
        let end = Vector2::new(end.x / reach, end.y / reach);
        Self {
            edge: Edge::new(-end, end),
            centre: map.of(&self.centre),
            radius: self.radius * reach,
        }
    }

    #[inline(always)]
    pub(crate) fn edge(&self) -> &Edge<R> {
        &self.edge
    }
}
