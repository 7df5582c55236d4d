//! The surface in reduced units: one curve in the quarter plane f, t ≥ 0, and two searches on it.
//!
//! Rotation about the torque axis and mirror symmetry leave the curve (F, T)(v, w), v, w ≥ 0. The
//! twist (v, w) is its outward normal and runs once from the force's pole (1, 0) to the torque's
//! (0, T₀). Both searches look for the normal, as the ratio h ∈ [0, 1] of the smaller to the larger
//! speed: near either pole h keeps its relative accuracy. With capitals for the component
//! that leads and p = (A, a) the given point, the zeros of
//!
//! ```text
//! through the ray of p:    A m(h) − a M(h)                          (M, m) parallel to p
//! nearest to p:            (A − M(h)) h − κ (a − m(h))              p − (M, m) along the normal
//! ```
//!
//! are unique: along the curve both rise through zero, the second because a normal that points
//! inwards from the quarter plane never leaves the set. κ is the squared ratio of
//! the lever that weighs torque to the radius if spinning leads, its inverse if sliding leads.
//!
//! The curve depends on the ratio alone, so that dM/dh = −h dm/dh: the last step of a search moves the point
//! that it has computed instead of computing another.

use super::collar;
use super::curve_approximation::CurveApproximation;
use super::curve_point::CurvePoint;
use super::monotone_root::{MonotoneRoot, Step};
use crate::coupling::{DominantSpeed, DryReducedFriction, ReducedWrench};
use crate::real::Real;

/// What a gauge gains on the way from a normal to that of the ray, over the square of the step and the rate: ½ is
/// expected.
const SPREAD: f64 = 16.0;

/// The curve of one coupling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meridian<R, C> {
    pub coupling: C,
    /// Point at equal speeds, where the leading component changes.
    equal: ReducedWrench<R>,
    /// Where searches start: sliding leads, spinning leads.
    sketches: [CurveApproximation<R>; 2],
    /// Lines through the equal point and a pole, as α f + β t = 1: of the force's pole, of the torque's.
    chords: [[R; 2]; 2],
    /// 1/D of pure sliding, of pure spinning and of equal speeds.
    tangents: [R; 3],
}

/// An outward normal: the larger of the two speeds is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Normal<R> {
    pub slide: R,
    pub rim: R,
}

/// A normal and its point of the curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct NormalAndPoint<R> {
    pub normal: Normal<R>,
    pub at: ReducedWrench<R>,
}

/// A point's normal along its ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayNormal<R> {
    pub normal: Normal<R>,
    /// Gauge of the given point, over its size.
    pub gauge: R,
}

/// How closely the normal along a ray is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NormalTolerance<R> {
    /// The gauge: stationary in the normal, a quarter of its digits are enough.
    Gauge,
    /// The normal itself.
    Normal,
    /// FrameSelector side of 1 the gauge lies on, of a point of this size in units of the force limit. The gauge itself
    /// only in the collar.
    Side(R),
}

#[inline]
fn normal_of<R: Real>(lead: DominantSpeed, ratio: R) -> Normal<R> {
    let [slide, rim] = ordered(lead, R::ONE, ratio);
    Normal { slide, rim }
}

/// Force and torque, or the other way round: the leading component first; and back.
#[inline]
fn ordered<T>(lead: DominantSpeed, force: T, torque: T) -> [T; 2] {
    match lead {
        DominantSpeed::Sliding => [force, torque],
        DominantSpeed::Spinning => [torque, force],
    }
}

impl<R: Real, C: DryReducedFriction<R>> Meridian<R, C> {
    pub fn new(coupling: C) -> Self {
        let point = |slide, rim| coupling.reduced_wrench(slide, rim);
        let equal = point(R::ONE, R::ONE);
        let top = point(R::ONE, R::ZERO).force;
        let side = point(R::ZERO, R::ONE).torque;
        let chords = [
            [R::ONE / top, (R::ONE - equal.force / top) / equal.torque],
            [(R::ONE - equal.torque / side) / equal.force, R::ONE / side],
        ];
        Self {
            equal,
            chords,
            tangents: [top, side, equal.force + equal.torque].map(|power| R::ONE / power),
            sketches: [DominantSpeed::Sliding, DominantSpeed::Spinning]
                .map(|lead| CurveApproximation::of(&coupling, lead)),
            coupling,
        }
    }

    /// A bound from above of the gauge: the set is convex and holds its poles and the equal point.
    ///
    /// *Domain*: components ≥ 0; NaN gives NaN.
    #[inline]
    pub fn gauge_bound(&self, force: R, torque: R) -> R {
        let [[a, b], [c, d]] = self.chords;
        let [one, other] = [a * force + b * torque, c * force + d * torque];
        if one > other { one } else { other }
    }

    /// True if the gauge is more than `most`: the tangents at the poles and at the equal point leave the point
    /// outside.
    #[inline]
    pub fn is_beyond_tangents(&self, point: ReducedWrench<R>, most: R) -> bool {
        let ReducedWrench { force, torque } = point;
        let [slide, spin, equal] = self.tangents;
        force * slide > most || torque * spin > most || (force + torque) * equal > most
    }

    /// The point whose outward normal is given.
    #[inline]
    pub fn point(&self, normal: Normal<R>) -> ReducedWrench<R> {
        self.coupling.reduced_wrench(normal.slide, normal.rim)
    }

    #[inline]
    fn sketch(&self, lead: DominantSpeed) -> &CurveApproximation<R> {
        let [slide, rim] = &self.sketches;
        match lead {
            DominantSpeed::Sliding => slide,
            DominantSpeed::Spinning => rim,
        }
    }

    #[inline]
    fn local(&self, lead: DominantSpeed, ratio: R) -> CurvePoint<R> {
        CurvePoint::of(&self.coupling, lead, ratio)
    }

    /// The search for the normal where the ray of a point meets the curve.
    ///
    /// *Domain*: finite components ≥ 0 of which the larger is of order 1; NaN gives NaN.
    #[inline]
    pub fn ray(&self, point: ReducedWrench<R>, aim: NormalTolerance<R>) -> RaySearch<R> {
        let ReducedWrench { force, torque } = point;
        let lead = if force * self.equal.torque >= torque * self.equal.force {
            DominantSpeed::Sliding
        } else {
            DominantSpeed::Spinning
        };
        let given = ordered(lead, force, torque);
        let [major, minor] = given;
        let start = self.sketch(lead).on_ray(minor / major);
        RaySearch {
            lead,
            given,
            aim,
            search: MonotoneRoot::new(start),
        }
    }

    /// The search for the point of the curve nearest to one outside, in the norm √(f² + t²/`lever_sq`).
    #[inline]
    pub fn offset(&self, point: ReducedWrench<R>, lever_sq: R) -> NearestPointSearch<R> {
        let ReducedWrench { force, torque } = point;
        let equal = &self.equal;
        let lead = if torque - equal.torque <= lever_sq * (force - equal.force) {
            DominantSpeed::Sliding
        } else {
            DominantSpeed::Spinning
        };
        let given = ordered(lead, force, torque);
        let [weight, _] = ordered(lead, R::ONE / lever_sq, lever_sq);
        let start = self.sketch(lead).nearest(given, weight);
        NearestPointSearch {
            lead,
            given,
            weight,
            search: MonotoneRoot::new(start),
        }
    }
}

/// A search along the curve, one point of it after the other.
pub(super) trait Search<R: Real> {
    type Answer;

    /// Computes the next point; what is looked for, if that is known then.
    fn advance<C: DryReducedFriction<R>>(&mut self, curve: &Meridian<R, C>)
    -> Option<Self::Answer>;
}

/// What a search finds.
#[inline]
pub(super) fn solved<R: Real, C: DryReducedFriction<R>, S: Search<R>>(
    search: &mut S,
    curve: &Meridian<R, C>,
) -> S::Answer {
    loop {
        if let Some(found) = search.advance(curve) {
            return found;
        }
    }
}

/// The search for the normal on the ray of a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct RaySearch<R> {
    lead: DominantSpeed,
    given: [R; 2],
    aim: NormalTolerance<R>,
    search: MonotoneRoot<R>,
}

/// The search for the nearest point.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearestPointSearch<R> {
    lead: DominantSpeed,
    given: [R; 2],
    weight: R,
    search: MonotoneRoot<R>,
}

impl<R: Real> RaySearch<R> {
    /// The gauge by a normal: every one bounds it from below.
    #[inline]
    fn gauge(&self, ratio: R, [on_major, on_minor]: [R; 2]) -> R {
        let [major, minor] = self.given;
        (major + minor * ratio) / (on_major + on_minor * ratio)
    }

    /// True if the normal where a step starts tells on which side of 1 the gauge lies.
    #[inline]
    fn is_side_known(&self, step: &Step<R>, at: &CurvePoint<R>) -> bool {
        let NormalTolerance::Side(size) = self.aim else {
            return false;
        };
        let gauge = size * self.gauge(step.from, [at.major, at.minor]);
        let gain = R::from_f64(SPREAD) * at.rate * (step.by * step.by);
        gauge > R::ONE + R::TWO * collar() || gauge + gain < R::ONE - R::TWO * collar()
    }
}

impl<R: Real> Search<R> for RaySearch<R> {
    type Answer = RayNormal<R>;

    #[inline]
    fn advance<C: DryReducedFriction<R>>(
        &mut self,
        curve: &Meridian<R, C>,
    ) -> Option<RayNormal<R>> {
        let ratio = self.search.at();
        let at = curve.local(self.lead, ratio);
        let this = *self;
        let end = self
            .search
            .update(at, at.across_ray(ratio, self.given), |step| {
                match this.aim {
                    NormalTolerance::Normal => step.is_settled(),
                    _ => step.is_stationary() || this.is_side_known(step, &at),
                }
            })?;
        let gauge = if self.is_side_known(&end.step, &end.at) {
            self.gauge(end.step.from, [end.at.major, end.at.minor])
        } else {
            self.gauge(end.ratio(), end.point())
        };
        Some(RayNormal {
            normal: normal_of(self.lead, end.ratio()),
            gauge,
        })
    }
}

impl<R: Real> Search<R> for NearestPointSearch<R> {
    type Answer = NormalAndPoint<R>;

    #[inline]
    fn advance<C: DryReducedFriction<R>>(
        &mut self,
        curve: &Meridian<R, C>,
    ) -> Option<NormalAndPoint<R>> {
        let ratio = self.search.at();
        let at = curve.local(self.lead, ratio);
        let value = at.beside_normal(ratio, self.given, self.weight);
        let end = self.search.update(at, value, Step::is_settled)?;
        let [major, minor] = end.point();
        let [force, torque] = ordered(self.lead, major, minor);
        Some(NormalAndPoint {
            normal: normal_of(self.lead, end.ratio()),
            at: ReducedWrench { force, torque },
        })
    }
}
