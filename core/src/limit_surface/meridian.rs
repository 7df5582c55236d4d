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
//! are unique for a point outside: along the curve both rise through zero, the second because a normal that points
//! inwards from the quarter plane never leaves the set. κ is the squared ratio of
//! the lever that weighs torque to the radius if spinning leads, its inverse if sliding leads.
//!
//! The second search also tells the sides apart. At its zero p − (M, m) is λ times the normal, whose parts are ≥ 0.
//! Where λ > 0 the tangent plane leaves p outside. Where λ < 0 no part of p exceeds that of (M, m), and the set
//! holds with a point all that are nearer to both axes: p is inside, whichever of several zeros was found.

use super::curve_approximation::CurveApproximation;
use super::curve_point::{AlongNormal, CurvePoint, OnRay};
use super::ratio_search::{Curve, SearchEnd, solved};
use crate::coupling::{DominantSpeed, DryReducedFriction, ReducedWrench};
use crate::lanes::{Lanes, Numbers};
use crate::real::Real;

/// The curve of one coupling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meridian<R, C> {
    pub coupling: C,
    /// T₀, of pure spinning.
    pub spin_torque: R,
    /// Point at equal speeds, where the leading component changes.
    equal: ReducedWrench<R>,
    /// Where searches start: sliding leads, spinning leads.
    approximations: [CurveApproximation<R>; 2],
    /// Lines through the equal point and a pole, as α f + β t = 1: of the force's pole, of the torque's.
    chords: [[R; 2]; 2],
}

/// What is prepared of a curve, for programs in other languages; where sliding leads first.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CurveNumbers<R> {
    /// Torque of pure spinning.
    pub spin_torque: R,
    /// Force and torque at equal speeds.
    pub equal: [R; 2],
    /// Lines α f + β t = 1 through that point and the pole of the force, of the torque.
    pub chords: [[R; 2]; 2],
    /// The larger component at the pole.
    pub tops: [R; 2],
    /// The smaller component over the ratio of speeds, by powers of the ratio's square.
    pub powers: [[R; 6]; 2],
}

/// The points of a curve, one after the other.
pub(super) struct Alone<'a, R, C>(pub &'a Meridian<R, C>);

/// Several points of a curve at once.
pub(super) struct SideBySide<'a, R, C>(pub &'a Meridian<R, C>);

/// A point of the curve with its normal, of which the larger part is 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct NormalAndPoint<L> {
    /// Sliding and rim speed.
    pub normal: [L; 2],
    /// Force and torque.
    pub at: [L; 2],
    /// Normal · point.
    pub power: L,
    /// Normal · (given − point): above 0 outside, below 0 inside.
    pub beyond: L,
}

/// A normal along a ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayNormal<L> {
    pub normal: [L; 2],
    /// Gauge of the given point, in its unit.
    pub gauge: L,
}

fn curve_point<L>([major, minor, rate]: [L; 3]) -> CurvePoint<L> {
    CurvePoint { major, minor, rate }
}

impl<R: Real, C: DryReducedFriction<R>> Curve<R::Alone> for Alone<'_, R, C> {
    #[inline(always)]
    fn point(&self, slides: bool, ratio: R::Alone) -> CurvePoint<R::Alone> {
        let [ratio] = ratio.to_array();
        let point = self.0.coupling.reduced_point(lead(slides), ratio);
        curve_point(point.map(R::Alone::repeat))
    }
    #[inline(always)]
    fn first_point(&self, slides: bool, ratio: R::Alone) -> Option<CurvePoint<R::Alone>> {
        let [number] = ratio.to_array();
        match self.0.coupling.rough_point(lead(slides), number) {
            Some(point) => Some(curve_point(point.map(R::Alone::repeat))),
            None if R::IS_SINGLE && self.is_smooth() => None,
            None => Some(self.point(slides, ratio)),
        }
    }
    #[inline(always)]
    fn is_smooth(&self) -> bool {
        self.0.coupling.is_smooth()
    }
}

impl<R: Real, C: DryReducedFriction<R>> Curve<R::SideBySide> for SideBySide<'_, R, C> {
    #[inline(always)]
    fn point(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratio: R::SideBySide,
    ) -> CurvePoint<R::SideBySide> {
        curve_point(self.0.coupling.reduced_points(slides, ratio))
    }
    #[inline(always)]
    fn first_point(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratio: R::SideBySide,
    ) -> Option<CurvePoint<R::SideBySide>> {
        match self.0.coupling.rough_points(slides, ratio) {
            Some(point) => Some(curve_point(point)),
            None if R::IS_SINGLE && self.is_smooth() => None,
            None => Some(self.point(slides, ratio)),
        }
    }
    #[inline(always)]
    fn is_smooth(&self) -> bool {
        self.0.coupling.is_smooth()
    }
}

#[inline]
fn lead(slides: bool) -> DominantSpeed {
    if slides {
        DominantSpeed::Sliding
    } else {
        DominantSpeed::Spinning
    }
}

/// Force and torque, or the other way round: the leading component first; and back.
#[inline(always)]
fn ordered<L: Numbers>(slides: L::Mask, [force, torque]: [L; 2]) -> [L; 2] {
    [
        L::select(slides, force, torque),
        L::select(slides, torque, force),
    ]
}

impl<R: Real, C: DryReducedFriction<R>> Meridian<R, C> {
    pub fn new(coupling: C) -> Self {
        let point = |slide, rim| coupling.reduced_wrench(slide, rim);
        let equal = point(R::ONE, R::ONE);
        let top = point(R::ONE, R::ZERO).force;
        let spin_torque = point(R::ZERO, R::ONE).torque;
        let chords = [
            [R::ONE / top, (R::ONE - equal.force / top) / equal.torque],
            [
                (R::ONE - equal.torque / spin_torque) / equal.force,
                R::ONE / spin_torque,
            ],
        ];
        Self {
            spin_torque,
            equal,
            chords,
            approximations: [
                CurveApproximation::of(
                    &coupling,
                    DominantSpeed::Sliding,
                    top,
                    [equal.force, equal.torque],
                ),
                CurveApproximation::of(
                    &coupling,
                    DominantSpeed::Spinning,
                    spin_torque,
                    [equal.torque, equal.force],
                ),
            ],
            coupling,
        }
    }

    /// What is prepared.
    pub fn numbers(&self) -> CurveNumbers<R> {
        let [sliding, spinning] = &self.approximations;
        CurveNumbers {
            spin_torque: self.spin_torque,
            equal: [self.equal.force, self.equal.torque],
            chords: self.chords,
            tops: [sliding.top, spinning.top],
            powers: [sliding.terms, spinning.terms],
        }
    }

    /// A bound from above of the gauge: the set is convex and holds its poles and the equal point.
    ///
    /// *Domain*: components ≥ 0; NaN gives NaN.
    #[inline(always)]
    pub fn gauge_bound<L: Numbers<Real = R>>(&self, [force, torque]: [L; 2]) -> L {
        let line = |[a, b]: [R; 2]| L::repeat(a) * force + L::repeat(b) * torque;
        let [one, other] = self.chords;
        line(other).larger(line(one))
    }

    /// Force and torque of the point whose outward normal is given.
    #[inline]
    pub fn point(&self, [slide, rim]: [R; 2]) -> [R; 2] {
        let ReducedWrench { force, torque } = self.coupling.reduced_wrench(slide, rim);
        [force, torque]
    }

    /// The normal where the ray of a point meets the curve, which has these points.
    ///
    /// *Domain*: components ≥ 0 whose products are normal numbers, in any unit; NaN gives NaN.
    #[inline(always)]
    pub fn ray<L: Numbers<Real = R>>(
        &self,
        curve: &impl Curve<L>,
        [force, torque]: [L; 2],
    ) -> RayNormal<L> {
        let equal = &self.equal;
        let slides = (torque * L::repeat(equal.force)).at_most(force * L::repeat(equal.torque));
        let given = ordered(slides, [force, torque]);
        let equation = OnRay { given };
        let start = CurveApproximation::chosen(&self.approximations, slides).on_ray(&equation);
        let SearchEnd {
            ratio,
            before,
            power,
            ..
        } = solved(curve, slides, start, &equation);
        // The gauge is stationary in the normal: what the last step would change is below rounding.
        let gauge = (given[0] + given[1] * before) / power;
        // A direction that is not a number has no normal, though the search ends somewhere.
        let known = L::splat(1.0) + L::splat(0.0) * gauge;
        RayNormal {
            normal: ordered(slides, [known, ratio * known]),
            gauge,
        }
    }

    /// The point of the curve nearest to one outside, in the norm √(f² + t²/`lever_sq`); for a point inside one that
    /// proves it.
    #[inline(always)]
    pub fn nearest<L: Numbers<Real = R>>(
        &self,
        curve: &impl Curve<L>,
        [force, torque]: [L; 2],
        lever_sq: R,
    ) -> NormalAndPoint<L> {
        let (one, equal) = (L::splat(1.0), &self.equal);
        let slides = (torque - L::repeat(equal.torque))
            .at_most(L::repeat(lever_sq) * (force - L::repeat(equal.force)));
        let given = ordered(slides, [force, torque]);
        let weight = L::select(slides, L::repeat(R::ONE / lever_sq), L::repeat(lever_sq));
        let equation = AlongNormal { given, weight };
        let start = CurveApproximation::chosen(&self.approximations, slides).nearest(&equation);
        let SearchEnd {
            ratio,
            major,
            minor,
            power,
            ..
        } = solved(curve, slides, start, &equation);
        NormalAndPoint {
            normal: ordered(slides, [one, ratio]),
            at: ordered(slides, [major, minor]),
            power,
            beyond: (given[0] - major) + ratio * (given[1] - minor),
        }
    }
}
