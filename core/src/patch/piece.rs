//! Pieces of a polygon: what lies on one side of a straight border.

use super::edge::Edge;
use super::outline::{OutlineError, Polygon, PressureField};
use crate::real::Real;
use nalgebra::Vector2;

/// The half-plane to the left of a straight border: one surface of a floor that has several.
///
/// *Units*: length.
///
/// ```
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::patch::piece::{HalfPlane, PatchPiece};
/// let parcel = Polygon::new([[0.0_f64, 0.0], [0.3, 0.0], [0.3, 0.2], [0.0, 0.2]])?; // m
/// // Two belts meet at x = 0.1; one lies to the left of the line upwards.
/// let seam = HalfPlane::new([0.1, 0.0], [0.0, 1.0])?;
/// let left: Option<PatchPiece<f64, _>> = parcel.within(&seam, [Default::default(); 8])?;
/// let left = left.ok_or("nothing there")?;
/// assert!((left.share - 1.0 / 3.0).abs() < 1e-15 && (left.patch.area() - 0.02).abs() < 1e-16);
/// assert!((left.patch.centre().x - 0.05).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane<R: Real> {
    point: Vector2<R>,
    /// Direction of the border, of length 1.
    pub(crate) along: Vector2<R>,
}

impl<R: Real> HalfPlane<R> {
    /// Left of the line through `point` along `direction`.
    ///
    /// *Domain*: finite places; a direction of any finite length but zero.
    pub fn new(point: [R; 2], direction: [R; 2]) -> Result<Self, OutlineError> {
        let ([x, y], [u, v]) = (point, direction);
        let length = u.hypot(v);
        if !(x.is_finite() && y.is_finite()) {
            return Err(OutlineError::Position {
                in_loop: 0,
                corner: 0,
            });
        }
        if !(length > R::ZERO && length.is_finite()) {
            return Err(OutlineError::Repeated {
                in_loop: 0,
                corner: 0,
            });
        }
        Ok(Self {
            point: Vector2::new(x, y),
            along: Vector2::new(u / length, v / length),
        })
    }

    /// The other side of the border.
    pub fn other_side(&self) -> Self {
        Self {
            along: -self.along,
            ..*self
        }
    }

    /// Its image under a linear map that keeps the sense of rotation.
    pub(super) fn mapped(&self, map: impl Fn(Vector2<R>) -> Vector2<R>) -> Self {
        let along = map(self.along);
        let length = along.x.hypot(along.y);
        Self {
            point: map(self.point),
            along: Vector2::new(along.x / length, along.y / length),
        }
    }

    /// Distance of a place from the border, positive to the left of it.
    #[inline(always)]
    fn distance(&self, place: &Vector2<R>) -> R {
        let from = place - self.point;
        self.along.x * from.y - self.along.y * from.x
    }

    /// Distance of a place from the border, positive to the left of it.
    #[doc(hidden)]
    pub fn distance_of(&self, [x, y]: [R; 2]) -> R {
        self.distance(&Vector2::new(x, y))
    }

    /// Whether a place lies to the left of the border.
    pub fn contains(&self, [x, y]: [R; 2]) -> bool {
        self.distance(&Vector2::new(x, y)) > R::ZERO
    }

    /// Where the segment between two places meets the border, as a fraction of it from 0 to 1; `None` if both lie on
    /// the same side.
    pub fn crossing(&self, [from, to]: [[R; 2]; 2]) -> Option<R> {
        let [a, b] = [from, to].map(|[x, y]| self.distance(&Vector2::new(x, y)));
        ((a > R::ZERO) != (b > R::ZERO)).then(|| a / (a - b))
    }
}

/// A piece of a patch and what it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PatchPiece<R, P> {
    /// The piece, in the coordinates of the whole, about its own centre of pressure.
    pub patch: P,
    /// Its share of the load of the whole.
    pub share: R,
}

/// A piece of a polygon.
#[doc(hidden)]
pub type PolygonPiece<R, S, K> = PatchPiece<R, Polygon<R, S, K>>;

/// A piece of less than this many rounding errors of the whole is none.
const LEAST_ULPS: f64 = 64.0;

impl<R: Real, S: AsRef<[Edge<R>]>, K: PressureField<R>> Polygon<R, S, K> {
    /// What of the patch lies within a half-plane, under the same pressure; `None` if nothing does. The piece may have
    /// several parts.
    ///
    /// *Domain*: `memory` has room for as many edges as the patch has and half as many as cross the border; twice the
    /// number of the patch's edges is always enough. *Accuracy*: both pieces of a patch have its friction together to
    /// rounding. *Cost*: linear in the number of edges where few of them cross.
    pub fn within<T: AsRef<[Edge<R>]> + AsMut<[Edge<R>]>>(
        &self,
        side: &HalfPlane<R>,
        memory: T,
    ) -> Result<Option<PolygonPiece<R, T, K>>, OutlineError> {
        let cut = Cut {
            border: HalfPlane {
                point: (side.point - self.centre) * (R::ONE / self.radius),
                along: side.along,
            },
            edges: self.edges(),
        };
        let mut edges = memory;
        let count = cut.fill(edges.as_mut())?;
        let kept = edges.as_ref().get(..count).unwrap_or_default();
        let Some(found) = Content::of(kept, &self.pressure, self.reduced_area) else {
            return Ok(None);
        };
        let Content {
            area,
            mean,
            shift,
            radius,
        } = found;
        let mut longest = R::ZERO;
        for edge in edges.as_mut().iter_mut().take(count) {
            *edge = edge.about(&shift, radius);
            if edge.length() > longest {
                longest = edge.length();
            }
        }
        let [x, y] = self.pressure.slope();
        let at_centre = self.pressure.at_centre() + x * shift.x + y * shift.y;
        let inv_mean = R::ONE / mean;
        let patch = Polygon {
            edges,
            count,
            pressure: K::of_piece(
                at_centre * inv_mean,
                [x, y].map(|slope| slope * radius * inv_mean),
            ),
            centre: self.centre + shift * self.radius,
            radius: self.radius * radius,
            reduced_area: area / (radius * radius),
            longest_half: R::HALF * longest,
        };
        Ok(Some(PatchPiece {
            patch,
            share: mean * area / self.reduced_area,
        }))
    }
}

/// A border across a patch, in radii about its centre.
struct Cut<'a, R: Real> {
    border: HalfPlane<R>,
    edges: &'a [Edge<R>],
}

impl<R: Real> Cut<'_, R> {
    /// Writes the edges of the piece, and says how many there are.
    fn fill(&self, memory: &mut [Edge<R>]) -> Result<usize, OutlineError> {
        let mut slots = Slots { memory, count: 0 };
        for edge in self.edges {
            let [from, to] = [edge.start(), edge.end()];
            let (a, b) = (self.border.distance(&from), self.border.distance(&to));
            match (a > R::ZERO, b > R::ZERO) {
                (true, true) => slots.push(*edge),
                (true, false) => slots.push_between(from, met([from, to], [a, b])),
                (false, true) => slots.push_between(met([from, to], [a, b]), to),
                (false, false) => {}
            }
        }
        // The border itself, from each place where the outline leaves to the one where it comes back.
        let mut rank = 0;
        while let (Some(from), Some(to)) = (self.ranked(rank, false), self.ranked(rank, true)) {
            slots.push_between(from, to);
            rank += 1;
        }
        let Slots { count, memory } = slots;
        if count > memory.len() {
            let room = memory.len();
            return Err(OutlineError::Room { given: count, room });
        }
        Ok(count)
    }

    /// Where the outline comes in, or goes out, for the `rank`th time along the border.
    fn ranked(&self, rank: usize, comes_in: bool) -> Option<Vector2<R>> {
        let crossings = || {
            self.edges
                .iter()
                .enumerate()
                .filter_map(move |(index, edge)| {
                    let [from, to] = [edge.start(), edge.end()];
                    let (a, b) = (self.border.distance(&from), self.border.distance(&to));
                    let crosses = (a > R::ZERO) != (b > R::ZERO) && (b > R::ZERO) == comes_in;
                    crosses.then(|| (index, met([from, to], [a, b])))
                })
        };
        let along = |at: &Vector2<R>| at.x * self.border.along.x + at.y * self.border.along.y;
        crossings()
            .find(|(index, at)| {
                let place = along(at);
                let before = crossings().filter(|(other, there)| {
                    let far = along(there);
                    far < place || far == place && other < index
                });
                before.count() == rank
            })
            .map(|(_, at)| at)
    }
}

/// Where a segment with these distances of its ends meets the border.
fn met<R: Real>([from, to]: [Vector2<R>; 2], [a, b]: [R; 2]) -> Vector2<R> {
    from + (to - from) * (a / (a - b))
}

/// Memory for edges, filled from its start; what has no room is counted.
struct Slots<'a, R> {
    memory: &'a mut [Edge<R>],
    count: usize,
}

impl<R: Real> Slots<'_, R> {
    fn push(&mut self, edge: Edge<R>) {
        if let Some(slot) = self.memory.get_mut(self.count) {
            *slot = edge;
        }
        self.count += 1;
    }

    fn push_between(&mut self, from: Vector2<R>, to: Vector2<R>) {
        let edge = Edge::new(from, to);
        if edge.length() > R::ZERO {
            self.push(edge);
        }
    }
}

/// What edges enclose, in radii of the whole patch about its centre.
struct Content<R: Real> {
    area: R,
    /// Mean pressure, of that of the whole.
    mean: R,
    /// Centre of pressure.
    shift: Vector2<R>,
    /// Distance of the farthest corner from there.
    radius: R,
}

impl<R: Real> Content<R> {
    fn of(edges: &[Edge<R>], pressure: &impl PressureField<R>, whole: R) -> Option<Self> {
        let ([x_slope, y_slope], at_centre) = (pressure.slope(), pressure.at_centre());
        let (mut area, mut load) = (R::ZERO, R::ZERO);
        let mut moment = Vector2::new(R::ZERO, R::ZERO);
        for edge in edges {
            let (a, b) = (edge.start(), edge.end());
            let twice = a.x * b.y - a.y * b.x;
            let [p, q] = [&a, &b].map(|at| x_slope * at.x + y_slope * at.y);
            let sum = a + b;
            area += twice;
            load += twice * (at_centre + (p + q) * R::from_f64(1.0 / 3.0));
            // ∫ x (g·x) over the triangle: its area times (a (2p + q) + b (p + 2q))/12.
            let bent = a * (p + p + q) + b * (p + q + q);
            moment += (sum * (at_centre * R::from_f64(1.0 / 3.0)) + bent * R::from_f64(1.0 / 12.0))
                * twice;
        }
        let (area, load) = (R::HALF * area, R::HALF * load);
        let least = R::from_f64(LEAST_ULPS) * R::EPSILON * whole;
        if !(area > least && load > least) {
            return None;
        }
        let shift = moment * (R::HALF / load);
        let mut radius = R::ZERO;
        for edge in edges {
            let from = edge.start() - shift;
            let distance = from.x.hypot(from.y);
            if distance > radius {
                radius = distance;
            }
        }
        Some(Self {
            area,
            mean: load / area,
            shift,
            radius,
        })
    }
}
