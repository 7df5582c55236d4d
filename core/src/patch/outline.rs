//! Patches bounded by straight edges: any polygon, with holes, under uniform or linear pressure.
//!
//! Lengths are stored in units of the *radius*, the distance of the farthest corner from the
//! *centre*, which is the centre of pressure. [`crate::coupling::flat`] gives their friction.

pub use super::edge::Edge;
pub use super::flat_pressure::{LinearPressure, PressureField, UniformPressure};
pub use super::outline_error::OutlineError;
#[doc(hidden)]
pub use super::polygon_parts::Parts;

use super::outline_check::{OutlineLoops, checked, sides};
use super::outline_extent::{Frame, twice_area};
use crate::real::Real;
use nalgebra::Vector2;

/// A patch bounded by straight edges, convex or not, with or without holes.
///
/// The storage `S` holds the edges: an array, or memory of the caller.
///
/// *Units*: length. *Size*: 7 numbers an edge and at most 9 more.
///
/// ```
/// use tribos_core::patch::outline::Polygon;
/// let sole = Polygon::new([[0.0_f64, 0.0], [0.24, 0.0], [0.24, 0.1], [0.0, 0.08]])?; // m
/// assert!((sole.area() - 0.24 * 0.09).abs() < 1e-16);
/// assert!(sole.centre().x > 0.12); // towards the broad end
/// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<R: Real, S, K = UniformPressure> {
    pub(super) edges: S,
    pub(super) count: usize,
    pub(super) pressure: K,
    pub(super) centre: Vector2<R>,
    pub(super) radius: R,
    /// Area in units of radius².
    pub(super) reduced_area: R,
    /// Half the length of the longest edge, in radii.
    pub(super) longest_half: R,
}

impl<R: Real, const N: usize> Polygon<R, [Edge<R>; N]> {
    /// The polygon with these corners, clockwise or counterclockwise, under uniform pressure.
    ///
    /// *Domain*: at least 3 finite corners; edges meet only at the corners that they share; the area
    /// is not lost in rounding.
    pub fn new(corners: [[R; 2]; N]) -> Result<Self, OutlineError> {
        Self::with_holes(&[&corners], [Edge::default(); N])
    }
}

impl<R: Real, S: AsRef<[Edge<R>]> + AsMut<[Edge<R>]>> Polygon<R, S> {
    /// The polygon with an outer loop of corners and further loops that are holes, each clockwise or
    /// counterclockwise, under uniform pressure; `memory` has room for an edge a corner.
    ///
    /// *Domain*: as [`Polygon::new`]; holes lie inside of the outer loop and outside of each other.
    /// *Cost*: the number of edges squared.
    ///
    /// ```
    /// use tribos_core::patch::outline::{Edge, Polygon};
    /// let square = |half: f64| [[-half, -half], [half, -half], [half, half], [-half, half]];
    /// let mut memory = [Edge::default(); 8];
    /// let frame = Polygon::with_holes(&[&square(0.1), &square(0.05)], &mut memory[..])?; // m
    /// assert!((frame.area() - 0.03).abs() < 1e-16);
    /// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
    /// ```
    pub fn with_holes(loops: &[&[[R; 2]]], memory: S) -> Result<Self, OutlineError> {
        Self::of_loops(loops.iter().copied(), memory)
    }

    /// The polygon of loops that nothing is known of.
    pub(super) fn of_loops<'a>(
        loops: impl OutlineLoops<'a, R>,
        memory: S,
    ) -> Result<Self, OutlineError> {
        let mut edges = memory;
        let count = loops.clone().map(<[_]>::len).sum();
        let room = edges.as_ref().len();
        if count > room {
            return Err(OutlineError::Room { given: count, room });
        }
        let scale = checked(loops.clone())?;
        let Frame {
            centroid,
            radius,
            area,
        } = Frame::of(loops.clone(), &scale)?;
        let centre = scale.origin + centroid * scale.unit;
        if !(centre.x + centre.y + radius * scale.unit).is_finite() {
            return Err(OutlineError::Extent);
        }
        let mut slots = edges.as_mut().iter_mut();
        for (in_loop, corners) in loops.enumerate() {
            let reduced = |corner: &[R; 2]| {
                let at = scale.at(corner) - centroid;
                Vector2::new(at.x / radius, at.y / radius)
            };
            // The patch lies to the left of the outer loop's edges and outside of a hole.
            let is_backwards = (twice_area(corners, &scale) > R::ZERO) != (in_loop == 0);
            for (corner, (side, slot)) in sides(corners).zip(&mut slots).enumerate() {
                let [from, to] = side.map(reduced);
                *slot = if is_backwards {
                    Edge::new(to, from)
                } else {
                    Edge::new(from, to)
                };
                if slot.length() == R::ZERO {
                    return Err(OutlineError::Repeated { in_loop, corner });
                }
            }
        }
        let mut longest = R::ZERO;
        for edge in edges.as_ref().iter().take(count) {
            if edge.length() > longest {
                longest = edge.length();
            }
        }
        Ok(Self {
            edges,
            count,
            pressure: UniformPressure,
            centre,
            radius: radius * scale.unit,
            reduced_area: area / (radius * radius),
            longest_half: R::HALF * longest,
        })
    }

    /// The same area under linear pressure with its centre at `at`, in the corners' coordinates.
    ///
    /// *Domain*: the pressure is nowhere negative: in a rectangle of sides a and b,
    /// |Δx|/a + |Δy|/b ≤ 1/6 from its centre.
    ///
    /// ```
    /// use tribos_core::patch::outline::{OutlineError, Polygon};
    /// let sole = Polygon::new([[0.0_f64, 0.0], [0.24, 0.0], [0.24, 0.1], [0.0, 0.1]])?; // m
    /// assert!(sole.with_centre_of_pressure([0.14, 0.05]).is_ok());
    /// let tiptoe = sole.with_centre_of_pressure([0.17, 0.05]); // beyond the middle third
    /// assert!(matches!(tiptoe, Err(OutlineError::LiftOff { .. })));
    /// # Ok::<(), OutlineError>(())
    /// ```
    pub fn with_centre_of_pressure(
        self,
        at: [R; 2],
    ) -> Result<Polygon<R, S, LinearPressure<R>>, OutlineError> {
        let [x, y] = at;
        let shift = Vector2::new(
            (x - self.centre.x) / self.radius,
            (y - self.centre.y) / self.radius,
        );
        // ∫k x = S g for the pressure k = 1 + g·x about the centroid.
        let axis = self.principal_axis();
        let [xx, xy, yy] = self.second_moments(&axis);
        let determinant = xx * yy - xy * xy;
        let [x_shift, y_shift] = along(&axis, &shift);
        let slope = [
            (yy * x_shift - xy * y_shift) / determinant,
            (xx * y_shift - xy * x_shift) / determinant,
        ];
        self.about(shift, back(&axis, slope), Vector2::new(x, y))
    }

    /// The polygon under the pressure p₀ (1 + `slope`·(x − centroid)). *Units*: 1/length.
    ///
    /// *Domain*: the pressure is nowhere negative.
    ///
    /// ```
    /// use tribos_core::patch::outline::Polygon;
    /// let wedge = Polygon::new([[0.0_f64, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])?; // m
    /// let wedge = wedge.with_slope([20.0, 0.0])?; // no pressure at x = 0, twice the mean at 0.1 m
    /// assert!((wedge.centre().x - 0.1 * 2.0 / 3.0).abs() < 1e-16);
    /// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
    /// ```
    pub fn with_slope(
        self,
        slope: [R; 2],
    ) -> Result<Polygon<R, S, LinearPressure<R>>, OutlineError> {
        let slope = Vector2::new(slope[0] * self.radius, slope[1] * self.radius);
        let axis = self.principal_axis();
        let [xx, xy, yy] = self.second_moments(&axis);
        let [g, h] = along(&axis, &slope);
        let shift = back(&axis, [xx * g + xy * h, xy * g + yy * h]);
        let centre = self.centre + shift * self.radius;
        self.about(shift, slope, centre)
    }

    /// The polygon about its centre of pressure, given the pressure's slope about the centroid.
    fn about(
        mut self,
        shift: Vector2<R>,
        slope: Vector2<R>,
        centre: Vector2<R>,
    ) -> Result<Polygon<R, S, LinearPressure<R>>, OutlineError> {
        let is_finite = |v: &Vector2<R>| v.x.is_finite() && v.y.is_finite();
        if !(is_finite(&shift) && is_finite(&slope) && is_finite(&centre)) {
            return Err(OutlineError::Slope);
        }
        let collar = R::from_f64(LIFT_ULPS) * R::EPSILON;
        let mut radius = R::ZERO;
        for edge in self.edges().iter() {
            let corner = edge.start();
            let (by_x, by_y) = (slope.x * corner.x, slope.y * corner.y);
            let pressure = R::ONE + by_x + by_y;
            if pressure < -(collar * (R::ONE + by_x.abs() + by_y.abs())) {
                return Err(OutlineError::LiftOff {
                    lowest: pressure.to_f64(),
                });
            }
            let from = corner - shift;
            let distance = from.x.hypot(from.y);
            if distance > radius {
                radius = distance;
            }
        }
        for edge in self.edges.as_mut().iter_mut() {
            *edge = edge.about(&shift, radius);
        }
        let pressure = LinearPressure::new(
            R::ONE + slope.x * shift.x + slope.y * shift.y,
            [slope.x * radius, slope.y * radius],
        );
        Ok(Polygon {
            edges: self.edges,
            count: self.count,
            pressure,
            centre,
            radius: self.radius * radius,
            reduced_area: self.reduced_area / (radius * radius),
            longest_half: self.longest_half / radius,
        })
    }
}

/// A vector's parts along an axis of length 1 and across it.
fn along<R: Real>(axis: &Vector2<R>, v: &Vector2<R>) -> [R; 2] {
    [v.x * axis.x + v.y * axis.y, v.y * axis.x - v.x * axis.y]
}

/// The vector with these parts.
fn back<R: Real>(axis: &Vector2<R>, [x, y]: [R; 2]) -> Vector2<R> {
    Vector2::new(x * axis.x - y * axis.y, x * axis.y + y * axis.x)
}

/// Rounding of a pressure that is zero at a corner, of the terms that it is a sum of.
const LIFT_ULPS: f64 = 64.0;

impl<R: Real, S: AsRef<[Edge<R>]>, K: PressureField<R>> Polygon<R, S, K> {
    /// The edges, as line integrals need them.
    #[inline(always)]
    pub(crate) fn edges(&self) -> &[Edge<R>] {
        let edges = self.edges.as_ref();
        edges.get(..self.count).unwrap_or(edges)
    }

    /// How many edges it has.
    #[doc(hidden)]
    pub fn edge_count(&self) -> usize {
        self.edges().len()
    }

    /// How the pressure is spread.
    #[inline(always)]
    pub(crate) fn pressure(&self) -> &K {
        &self.pressure
    }

    /// Area over radius².
    #[inline(always)]
    pub(crate) fn reduced_area(&self) -> R {
        self.reduced_area
    }

    /// Half the length of the longest edge over the radius.
    #[inline(always)]
    pub(crate) fn longest_half(&self) -> R {
        self.longest_half
    }

    /// The centre of pressure, in the corners' coordinates.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farthest corner from the centre of pressure.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// Radius of gyration about the upright axis through the centre, of a plate of uniform thickness with
    /// this outline. *Units*: length. *Accuracy*: 1e-15, times the aspect ratio of a long patch.
    ///
    /// ```
    /// use tribos_core::patch::outline::Polygon;
    /// let tile = Polygon::new([[0.0_f64, 0.0], [0.4, 0.0], [0.4, 0.3], [0.0, 0.3]])?; // m
    /// assert!((tile.radius_of_gyration() - ((0.16 + 0.09) / 12.0_f64).sqrt()).abs() < 1e-16);
    /// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
    /// ```
    pub fn radius_of_gyration(&self) -> R {
        let [xx, _, yy] = self.second_moments(&Vector2::new(R::ONE, R::ZERO));
        let mean_sq = xx + yy;
        // Nothing but rounding makes it negative.
        let mean_sq = if mean_sq > R::ZERO { mean_sq } else { R::ZERO };
        self.radius * mean_sq.sqrt()
    }

    /// The direction in which the patch is longest: about it the second moments of a thin patch are apart,
    /// where along others they would cancel.
    fn principal_axis(&self) -> Vector2<R> {
        let [xx, xy, yy] = self.second_moments(&Vector2::new(R::ONE, R::ZERO));
        let half = R::HALF * (xx - yy);
        let size = half.hypot(xy);
        let (x, y) = if half >= R::ZERO {
            (size + half, xy)
        } else {
            (xy, size - half)
        };
        let length = x.hypot(y);
        if length > R::ZERO {
            Vector2::new(x / length, y / length)
        } else {
            Vector2::new(R::ONE, R::ZERO)
        }
    }

    /// Means of x², xy and y² about the centre, in units of radius², with x along an axis.
    fn second_moments(&self, axis: &Vector2<R>) -> [R; 3] {
        let mut sums = [R::ZERO; 3];
        for edge in self.edges() {
            let [[ax, ay], [bx, by]] =
                [edge.start(), edge.end()].map(|corner| along(axis, &corner));
            let area = edge.offset() * edge.length();
            let mixed = |p: R, q: R, r: R, s: R| p * (R::TWO * q + s) + r * (R::TWO * s + q);
            for (sum, [[p, q], [r, s]]) in sums.iter_mut().zip([
                [[ax, ax], [bx, bx]],
                [[ax, ay], [bx, by]],
                [[ay, ay], [by, by]],
            ]) {
                *sum += area * mixed(p, q, r, s);
            }
        }
        // Each triangle with the centre: its area times the sum over 12.
        let scale = R::ONE / (R::from_f64(24.0) * self.reduced_area);
        sums.map(|sum| sum * scale)
    }

    /// The area. *Special values*: zero or infinite where it leaves the range of numbers.
    pub fn area(&self) -> R {
        self.reduced_area * self.radius * self.radius
    }
}
