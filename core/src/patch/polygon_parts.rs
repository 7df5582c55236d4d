//! Polygons taken apart: how an interface to another language keeps them in plain memory.

use super::edge::Edge;
use super::flat_pressure::PressureField;
use super::outline::Polygon;
use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// What a polygon consists of besides its edges.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Parts<R, K> {
    /// How the pressure is spread.
    pub pressure: K,
    /// The centre of pressure, in the corners' coordinates.
    pub centre: [R; 2],
    /// Distance of the farthest corner from there.
    pub radius: R,
    /// Area in units of radius².
    pub reduced_area: R,
    /// Half the length of the longest edge, in radii.
    pub longest_half: R,
}

impl<R: Real, S: AsRef<[Edge<R>]> + AsMut<[Edge<R>]>> Polygon<R, S> {
    /// As [`Polygon::with_holes`], with the corners of all loops in a row and the number of each loop's.
    /// Corners that no number counts are left out.
    #[doc(hidden)]
    #[inline(always)]
    pub fn with_counts(
        corners: &[[R; 2]],
        counts: &[usize],
        memory: S,
    ) -> Result<Self, OutlineError> {
        let loops = counts.iter().scan(corners, |rest, &count| {
            let (first, others) = rest.split_at_checked(count).unwrap_or((*rest, &[]));
            *rest = others;
            Some(first)
        });
        Self::of_loops(loops, memory)
    }
}

impl<R: Real, S: AsRef<[Edge<R>]>, K: PressureField<R>> Polygon<R, S, K> {
    /// What there is besides the edges.
    #[doc(hidden)]
    #[inline(always)]
    pub fn parts(&self) -> Parts<R, K> {
        Parts {
            pressure: self.pressure,
            centre: self.centre.into(),
            radius: self.radius,
            reduced_area: self.reduced_area,
            longest_half: self.longest_half,
        }
    }

    /// The polygon of all of these edges. Parts that are not its own give numbers without a meaning,
    /// or NaN.
    #[doc(hidden)]
    #[inline(always)]
    pub fn of_parts(edges: S, parts: &Parts<R, K>) -> Self {
        let count = edges.as_ref().len();
        let [x, y] = parts.centre;
        Self {
            edges,
            count,
            pressure: parts.pressure,
            centre: Vector2::new(x, y),
            radius: parts.radius,
            reduced_area: parts.reduced_area,
            longest_half: parts.longest_half,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 2]; 7] = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 0.75],
        [0.0, 0.5],
        [0.25, 0.125],
        [0.5, 0.125],
        [0.25, 0.25],
    ];

    #[test]
    fn loops_in_a_row_are_those_in_a_list() {
        let (outer, hole) = CORNERS.split_at(4);
        let memory = [Edge::default(); 7];
        let counted = Polygon::with_counts(&CORNERS, &[4, 3], memory).unwrap();
        assert_eq!(Polygon::with_holes(&[outer, hole], memory), Ok(counted));
        let alone = Polygon::with_counts(&CORNERS, &[4], memory);
        assert_eq!(alone, Polygon::with_holes(&[outer], memory));
        assert!(Polygon::with_counts(&CORNERS, &[4, usize::MAX], memory).is_ok());
        let none = Err(OutlineError::Corners {
            in_loop: 2,
            given: 0,
        });
        assert_eq!(Polygon::with_counts(&CORNERS, &[4, 3, 3], memory), none);
    }

    #[test]
    fn a_polygon_is_its_edges_and_its_parts() {
        let frame = Polygon::with_counts(&CORNERS, &[4, 3], [Edge::default(); 7]).unwrap();
        assert_eq!(Polygon::of_parts(frame.edges, &frame.parts()), frame);
        let leaning = frame.with_slope([0.5, -0.25]).unwrap();
        assert_eq!(Polygon::of_parts(leaning.edges, &leaning.parts()), leaning);
    }
}
