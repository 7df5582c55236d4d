//! How corners can share a load whose centre is known.
//!
//! The shares λ ≥ 0 of the corners satisfy Σλ = 1 and Σλ d = 0, with d the places of the corners from the
//! centre of pressure. A sum Σλ φ(d) is greatest where at most three of them carry: a linear
//! programme with three equations. Its dual is the lowest plane above the points (d, φ) at the centre,
//! and the simplex method walks from triangle to triangle until no point is above the triangle's plane.

use crate::patch::PatchError;
use crate::real::Real;
use nalgebra::Vector2;

/// A share, or the distance of the centre from an edge in radii, that rounding may have made.
const ROUNDING_ULPS: f64 = 64.0;
/// Pivots for each corner before the rule that cannot cycle takes over.
const QUICK_PIVOTS: usize = 2;
/// Most pivots for each corner; 3 were seen. What they leave is known: [`Greatest::excess`].
const MOST_PIVOTS: usize = 8;

/// Corners about the centre of pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LoadSharing<R: Real, S> {
    corners: S,
    pub(super) centre: Vector2<R>,
    /// Distance of the farthest corner from the centre: the unit of length of all places here.
    pub(super) radius: R,
    kind: Kind<R>,
}

/// Whether the shares follow from the centre alone.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind<R: Real> {
    /// The centre lies on the boundary of the hull: two corners carry all.
    Fixed([CornerLoad<R>; 2]),
    /// The centre lies inside: a triangle of corners around it.
    Free(Tripod<R>),
}

/// A place and its part of the load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CornerLoad<R: Real> {
    pub(super) at: Vector2<R>,
    pub(super) part: R,
}

/// Shares with a sum that is greatest, or as near to it as is told.
pub(super) struct Greatest<R: Real> {
    pub(super) shares: [CornerLoad<R>; 3],
    /// A bound of what the greatest sum has more than theirs: how far a corner is above their plane. 0 where
    /// none is, to rounding.
    pub(super) excess: R,
}

/// Three corners around the centre.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tripod<R: Real> {
    index: [usize; 3],
    shares: [CornerLoad<R>; 3],
}

impl<R: Real, S: AsRef<[[R; 2]]>> LoadSharing<R, S> {
    pub(super) fn new(corners: S, centre: [R; 2]) -> Result<Self, PatchError> {
        let is_finite = |place: &[R; 2]| place.iter().all(|x| x.is_finite());
        if !is_finite(&centre) {
            return Err(PatchError::Centre);
        }
        if let Some(corner) = corners.as_ref().iter().position(|place| !is_finite(place)) {
            return Err(PatchError::CornerPosition { corner });
        }
        let [x, y] = centre;
        let nowhere = CornerLoad {
            at: Vector2::new(R::ZERO, R::ZERO),
            part: R::HALF,
        };
        let mut sharing = Self {
            corners,
            centre: Vector2::new(x, y),
            radius: R::ONE,
            kind: Kind::Fixed([nowhere; 2]),
        };
        let (mut farthest, mut radius) = (None, R::ZERO);
        for (index, corner) in sharing.corners.as_ref().iter().enumerate() {
            let at = sharing.place(corner);
            let distance = at.x.hypot(at.y);
            if !distance.is_finite() {
                return Err(PatchError::CornerDistance);
            }
            if farthest.is_none() || distance > radius {
                (farthest, radius) = (Some(index), distance);
            }
        }
        let Some(farthest) = farthest else {
            return Err(PatchError::NoCorners);
        };
        // All corners at the centre, or as near as numbers can be.
        if radius < R::MIN_POSITIVE / R::EPSILON {
            sharing.radius = R::ZERO;
            return Ok(sharing);
        }
        sharing.radius = radius;
        sharing.kind = sharing.around(farthest).ok_or(PatchError::CentreOutside)?;
        Ok(sharing)
    }

    /// A corner's place from the centre, in radii.
    fn place(&self, [x, y]: &[R; 2]) -> Vector2<R> {
        Vector2::new(
            (*x - self.centre.x) / self.radius,
            (*y - self.centre.y) / self.radius,
        )
    }

    /// All corners about the centre, with their numbers.
    fn places(&self) -> impl Iterator<Item = (usize, Vector2<R>)> + '_ {
        let corners = self.corners.as_ref().iter().enumerate();
        corners.map(|(index, corner)| (index, self.place(corner)))
    }

    /// Corners that the centre lies between, by a walk around the hull from its farthest corner on.
    fn around(&self, farthest: usize) -> Option<Kind<R>> {
        let first = self.places().nth(farthest)?;
        let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON;
        let mut best: Option<(R, Tripod<R>)> = None;
        let mut from = first;
        for _ in self.corners.as_ref() {
            let to = self.next_on_hull(&from)?;
            let (a, b) = (from.1, to.1);
            let edge = b - a;
            let length = edge.x.hypot(edge.y);
            let inside = cross(&a, &b) / length;
            if inside < -rounding {
                return None;
            }
            // On an edge of the hull nobody but its ends carries.
            let along = -(a.x * edge.x + a.y * edge.y) / length / length;
            if inside <= rounding && along >= -rounding && along <= R::ONE + rounding {
                let along = if along < R::ZERO {
                    R::ZERO
                } else if along > R::ONE {
                    R::ONE
                } else {
                    along
                };
                let part = |at, part| CornerLoad { at, part };
                return Some(Kind::Fixed([part(a, R::ONE - along), part(b, along)]));
            }
            // A fan of triangles from the first corner covers the hull.
            if let Some(tripod) = Tripod::new([first, from, to]) {
                let least = tripod.least();
                if best.as_ref().is_none_or(|(before, _)| least > *before) {
                    best = Some((least, tripod));
                }
            }
            from = to;
            if from.0 == first.0 {
                break;
            }
        }
        let (least, tripod) = best?;
        (least >= -rounding).then(|| Kind::Free(tripod.cleaned()))
    }

    /// The corner to which an edge of the hull leads, with all others to its left.
    fn next_on_hull(&self, (_, from): &(usize, Vector2<R>)) -> Option<(usize, Vector2<R>)> {
        let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON;
        let mut next: Option<(usize, Vector2<R>)> = None;
        for (index, at) in self.places() {
            let way = at - from;
            let length = way.x.hypot(way.y);
            if length <= rounding {
                continue;
            }
            let is_better = next.as_ref().is_none_or(|(_, best)| {
                let other = best - from;
                let far = other.x.hypot(other.y);
                let side = cross(&other, &way);
                // Of corners on one line the farther one.
                let on_line = side.abs() <= rounding * length * far;
                let ahead = other.x * way.x + other.y * way.y > R::ZERO;
                if on_line && ahead {
                    length > far
                } else {
                    side < R::ZERO
                }
            });
            if is_better {
                next = Some((index, at));
            }
        }
        next
    }

    /// Whether the shares follow from the centre alone.
    pub(super) fn is_fixed(&self) -> bool {
        matches!(self.kind, Kind::Fixed(_))
    }

    /// The shares of the triangle in whose coordinates [`LoadSharing::for_each`] counts.
    pub(super) fn base(&self) -> [R; 3] {
        match &self.kind {
            Kind::Fixed([one, other]) => [one.part, other.part, R::ZERO],
            Kind::Free(tripod) => tripod.shares.map(|share| share.part),
        }
    }

    /// Calls `each` with every corner that may carry, always in one order: its place in radii, and its
    /// coordinates in a triangle of corners around the centre.
    pub(super) fn for_each(&self, mut each: impl FnMut(&Vector2<R>, [R; 3])) {
        let (zero, one) = (R::ZERO, R::ONE);
        match &self.kind {
            Kind::Fixed([first, second]) => {
                each(&first.at, [one, zero, zero]);
                each(&second.at, [zero, one, zero]);
            }
            Kind::Free(tripod) => {
                for (_, at) in self.places() {
                    // Never flat: it has coordinates.
                    each(&at, tripod.coordinates(&at).unwrap_or([zero; 3]));
                }
            }
        }
    }

    /// The shares for which the sum of `height` is greatest.
    pub(super) fn greatest(&self, height: impl Fn(&Vector2<R>) -> R) -> Greatest<R> {
        let pivots = self.corners.as_ref().len().saturating_mul(MOST_PIVOTS);
        self.greatest_within(pivots, height)
    }

    /// The same after a number of pivots.
    fn greatest_within(&self, pivots: usize, height: impl Fn(&Vector2<R>) -> R) -> Greatest<R> {
        let mut tripod = match self.kind {
            Kind::Fixed([one, other]) => {
                let part = R::ZERO;
                return Greatest {
                    shares: [one, other, CornerLoad { part, ..one }],
                    excess: R::ZERO,
                };
            }
            Kind::Free(tripod) => tripod,
        };
        let quick = self.corners.as_ref().len().saturating_mul(QUICK_PIVOTS);
        for pivot in 0..pivots {
            let above = self.above(&tripod, &height, pivot < quick);
            let Some((_, entering)) = above else {
                let (shares, excess) = (tripod.shares, R::ZERO);
                return Greatest { shares, excess };
            };
            let Some(next) = tripod.exchanged(entering) else {
                break;
            };
            tripod = next;
        }
        // No place is above the plane lifted to the farthest corner.
        let excess = self.above(&tripod, &height, true);
        Greatest {
            shares: tripod.shares,
            excess: excess.map_or(R::ZERO, |(excess, _)| excess),
        }
    }

    /// The corner farthest above the plane through three, or the first one above it, and by how much it is.
    fn above(
        &self,
        tripod: &Tripod<R>,
        height: &impl Fn(&Vector2<R>) -> R,
        farthest: bool,
    ) -> Option<(R, (usize, Vector2<R>))> {
        let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON;
        let heights = tripod.shares.map(|share| height(&share.at));
        let [x, y, z] = heights;
        let (mut most, mut found) = (R::ZERO, None);
        for (index, at) in self.places() {
            if tripod.index.contains(&index) {
                continue;
            }
            let Some([a, b, c]) = tripod.coordinates(&at) else {
                continue;
            };
            let own = height(&at);
            let excess = own - (a * x + b * y + c * z);
            let size = own.abs() + (a * x).abs() + (b * y).abs() + (c * z).abs();
            if excess > rounding * size && excess > most {
                (most, found) = (excess, Some((excess, (index, at))));
                if !farthest {
                    break;
                }
            }
        }
        found
    }
}

impl<R: Real> Tripod<R> {
    /// A triangle with the centre's coordinates in it; none if it is flat.
    fn new(corners: [(usize, Vector2<R>); 3]) -> Option<Self> {
        let places = corners.map(|(_, at)| at);
        let [a, b, c] = coordinates(&Vector2::new(R::ZERO, R::ZERO), &places)?;
        let [p, q, r] = places;
        let share = |at, part| CornerLoad { at, part };
        Some(Self {
            index: corners.map(|(index, _)| index),
            shares: [share(p, a), share(q, b), share(r, c)],
        })
    }

    fn least(&self) -> R {
        let mut least = R::INFINITY;
        for share in &self.shares {
            if share.part < least {
                least = share.part;
            }
        }
        least
    }

    /// Without the negative parts that rounding has left.
    fn cleaned(mut self) -> Self {
        let mut sum = R::ZERO;
        for share in &mut self.shares {
            if share.part < R::ZERO {
                share.part = R::ZERO;
            }
            sum += share.part;
        }
        for share in &mut self.shares {
            share.part /= sum;
        }
        self
    }

    fn coordinates(&self, at: &Vector2<R>) -> Option<[R; 3]> {
        coordinates(at, &self.shares.map(|share| share.at))
    }

    /// With a new corner in place of the one whose share ends first.
    fn exchanged(&self, entering: (usize, Vector2<R>)) -> Option<Self> {
        let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON;
        let weights = self.coordinates(&entering.1)?;
        let mut leaving: Option<(R, usize)> = None;
        for ((share, weight), index) in self.shares.iter().zip(weights).zip(self.index) {
            if weight <= rounding {
                continue;
            }
            let until = share.part / weight;
            let is_first = leaving
                .as_ref()
                .is_none_or(|(least, other)| until < *least || (until == *least && index < *other));
            if is_first {
                leaving = Some((until, index));
            }
        }
        let (_, leaving) = leaving?;
        let [p, q, r] = self.shares;
        let [i, j, k] = self.index;
        let kept = |index: usize, share: CornerLoad<R>| {
            if index == leaving {
                entering
            } else {
                (index, share.at)
            }
        };
        Self::new([kept(i, p), kept(j, q), kept(k, r)]).map(Self::cleaned)
    }
}

/// Barycentric coordinates in a triangle; none if it is flat.
fn coordinates<R: Real>(at: &Vector2<R>, [a, b, c]: &[Vector2<R>; 3]) -> Option<[R; 3]> {
    let twice = cross(&(b - a), &(c - a));
    if twice == R::ZERO {
        return None;
    }
    let [p, q, r] = [a - at, b - at, c - at];
    Some([
        cross(&q, &r) / twice,
        cross(&r, &p) / twice,
        cross(&p, &q) / twice,
    ])
}

/// The component about the normal of a × b.
pub(super) fn cross<R: Real>(a: &Vector2<R>, b: &Vector2<R>) -> R {
    a.x * b.y - a.y * b.x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 24 corners on a circle; that sums from complete walks are greatest is a test of `any_pressure`.
    #[test]
    fn a_walk_cut_short_tells_how_far_it_is_from_the_greatest_sum() {
        let corners: [[f64; 2]; 24] = core::array::from_fn(|i| {
            let angle = core::f64::consts::TAU * i as f64 / 24.0;
            [libm::cos(angle), libm::sin(angle)]
        });
        let sharing = LoadSharing::new(corners, [0.1, 0.05]).unwrap();
        // |d − c| of a place beside the centre.
        let height = |d: &Vector2<f64>| libm::hypot(d.x - 0.7, d.y + 0.4);
        let sum = |found: &Greatest<f64>| -> f64 {
            let shares = found.shares.iter();
            shares.map(|share| share.part * height(&share.at)).sum()
        };
        let greatest = sum(&sharing.greatest(height));
        let mut was_short = false;
        for pivots in 0..12 {
            let found = sharing.greatest_within(pivots, height);
            let own = sum(&found);
            assert!(own <= greatest + 1e-14 && own + found.excess >= greatest - 1e-14);
            was_short |= own < greatest - 1e-3;
        }
        assert!(was_short && sharing.greatest(height).excess == 0.0);
    }
}
