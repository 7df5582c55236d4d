//! Feet of one surface: together one patch.

use super::{Feet, Foot, loaded};
use crate::coupling::flat::{Hessian, Motion, PatchShape, PointLoad, Reduced, feet};
use crate::patch::feet::PlacedPatch;
use crate::real::Real;
use crate::twist::Twist;
use nalgebra::Vector2;

/// A patch in coordinates about another point.
#[derive(Clone, Copy)]
pub(super) struct FromReference<P, R: Real> {
    pub(super) patch: P,
    pub(super) at: Vector2<R>,
}

impl<R: Real, P: PatchShape<R>> PatchShape<R> for FromReference<P, R> {
    fn centre(&self) -> Vector2<R> {
        self.patch.centre() - self.at
    }
    fn radius(&self) -> R {
        self.patch.radius()
    }
    fn rounding(&self) -> R {
        self.patch.rounding()
    }
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        self.patch.reduced(motion)
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        self.patch.reduced_with_hessian(motion)
    }
    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        self.patch.nearest_point(place)
    }
}

/// All feet that stand on one surface, or all feet, as one patch.
pub(super) struct Group<'a, R: Real, P> {
    feet: &'a [Foot<R, P>],
    /// Common centre and radius of all feet.
    frame: (Vector2<R>, R),
    surface: Option<Twist<R>>,
    limit: R,
}

impl<'a, R: Real, P: PatchShape<R>> Group<'a, R, P> {
    /// Those of `feet` whose surface moves with this twist; all of them if none is given.
    pub(super) fn of(feet: &Feet<'a, R, P>, surface: Option<Twist<R>>) -> Self {
        let mut group = Self {
            feet: feet.feet,
            frame: (feet.centre, feet.radius),
            surface,
            limit: R::ZERO,
        };
        let mut limit = R::ZERO;
        for foot in group.members() {
            limit += foot.limit;
        }
        group.limit = limit;
        group
    }

    /// What its feet carry together.
    pub(super) fn limit(&self) -> R {
        self.limit
    }

    fn members(&self) -> impl Iterator<Item = &'a Foot<R, P>> + Clone {
        let surface = self.surface;
        let stands = move |foot: &&'a Foot<R, P>| surface.is_none_or(|own| foot.surface == own);
        loaded(self.feet).filter(stands)
    }

    fn placed(&self) -> impl Iterator<Item = PlacedPatch<'a, R, P>> + Clone {
        let (frame, limit) = (self.frame, self.limit);
        self.members()
            .map(move |foot| PlacedPatch::new(&foot.patch, frame, foot.limit / limit))
    }
}

impl<R: Real, P: PatchShape<R>> PatchShape<R> for Group<'_, R, P> {
    fn centre(&self) -> Vector2<R> {
        self.frame.0
    }
    fn radius(&self) -> R {
        self.frame.1
    }
    fn rounding(&self) -> R {
        feet::rounding(self.placed())
    }
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        feet::reduced(self.placed(), motion)
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        feet::reduced_with_hessian(self.placed(), motion)
    }
    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        feet::nearest_point(self.placed(), place)
    }
}
