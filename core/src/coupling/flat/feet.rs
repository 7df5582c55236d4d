//! Friction of several patches under one rigid body.
//!
//! Each foot moves with the velocity of its own centre and the common spin, and carries its share of the
//! load; forces add up, and torques with the moments of the forces about the common centre.

use super::motion::Motion;
use super::points::rest;
use super::{Hessian, PatchShape, PointLoad, Reduced};
use crate::patch::feet::{CompoundPatch, PlacedPatch};
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real, P: PatchShape<R>> PatchShape<R> for CompoundPatch<'_, R, P> {
    fn centre(&self) -> Vector2<R> {
        CompoundPatch::centre(self)
    }

    fn radius(&self) -> R {
        CompoundPatch::radius(self)
    }

    fn rounding(&self) -> R {
        rounding(self.placed())
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        reduced(self.placed(), motion)
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        reduced_with_hessian(self.placed(), motion)
    }

    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        nearest_point(self.placed(), place)
    }
}

/// Rounding of the power of several patches.
pub(crate) fn rounding<'a, R: Real, P: PatchShape<R> + 'a>(
    feet: impl Iterator<Item = PlacedPatch<'a, R, P>>,
) -> R {
    let mut most = R::EPSILON;
    for foot in feet {
        let own = foot.patch.rounding();
        if own > most {
            most = own;
        }
    }
    most
}

/// Friction of several patches that move as one.
pub(crate) fn reduced<'a, R: Real, P: PatchShape<R> + 'a>(
    feet: impl Iterator<Item = PlacedPatch<'a, R, P>>,
    motion: &Motion<R>,
) -> Reduced<R> {
    let mut sum = Reduced::none();
    for foot in feet {
        if let Some(part) = PartMotion::of(&foot, motion) {
            part.add(&foot.patch.reduced(&part.motion), &mut sum);
        }
    }
    sum
}

/// The same with the power's second derivatives.
pub(crate) fn reduced_with_hessian<'a, R: Real, P: PatchShape<R> + 'a>(
    feet: impl Iterator<Item = PlacedPatch<'a, R, P>>,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let (mut sum, mut hessian) = (Reduced::none(), Hessian::none());
    for foot in feet {
        if let Some(part) = PartMotion::of(&foot, motion) {
            let (reduced, own) = foot.patch.reduced_with_hessian(&part.motion);
            part.add(&reduced, &mut sum);
            part.add_hessian(&own, &mut hessian);
        }
    }
    (sum, hessian)
}

/// The point of several patches nearest to a place.
pub(crate) fn nearest_point<'a, R: Real, P: PatchShape<R> + 'a>(
    feet: impl Iterator<Item = PlacedPatch<'a, R, P>> + Clone,
    place: &Vector2<R>,
) -> Option<PointLoad<R>> {
    // The nearest point of each foot, in the units of all.
    let near = |place: &Vector2<R>| {
        let place = *place;
        feet.clone().filter_map(move |foot| {
            let PlacedPatch { at, scale, .. } = foot;
            let own = (place - at) * (R::ONE / scale);
            let point = foot.patch.nearest_point(&own)?;
            Some(PointLoad {
                place: at + point.place * scale,
                share: point.share * foot.share,
            })
        })
    };
    let distance = |point: &PointLoad<R>, place: &Vector2<R>| {
        (point.place.x - place.x).hypot(point.place.y - place.y)
    };
    let mut nearest: Option<(PointLoad<R>, R)> = None;
    for point in near(place) {
        let far = distance(&point, place);
        if nearest.is_none_or(|(_, least)| far < least) {
            nearest = Some((point, far));
        }
    }
    let (point, _) = nearest?;
    // Points of other feet at the same place carry with it.
    let mut share = R::ZERO;
    for other in near(&point.place) {
        if distance(&other, &point.place) <= rest() {
            share += other.share;
        }
    }
    let place = point.place;
    Some(PointLoad { place, share })
}

/// One foot: its motion, place, size and share, with lengths in radii of the whole.
struct PartMotion<R: Real> {
    motion: Motion<R>,
    at: Vector2<R>,
    scale: R,
    share: R,
}

impl<R: Real> PartMotion<R> {
    /// `None` for a foot that carries nothing or, alone, does not move.
    fn of<P>(foot: &PlacedPatch<'_, R, P>, motion: &Motion<R>) -> Option<Self> {
        let PlacedPatch {
            at, scale, share, ..
        } = *foot;
        if share == R::ZERO {
            return None;
        }
        let (velocity, turn) = (&motion.velocity, motion.rim);
        let motion = Motion {
            velocity: Vector2::new(velocity.x - turn * at.y, velocity.y + turn * at.x),
            rim: turn * scale,
        };
        if motion.is_rest() {
            return None;
        }
        Some(Self {
            motion,
            at,
            scale,
            share,
        })
    }

    fn add(&self, reduced: &Reduced<R>, sum: &mut Reduced<R>) {
        let force = reduced.force * self.share;
        sum.force += force;
        sum.torque +=
            self.share * self.scale * reduced.torque + (self.at.x * force.y - self.at.y * force.x);
    }

    fn add_hessian(&self, own: &Hessian<R>, sum: &mut Hessian<R>) {
        let Hessian {
            xx,
            xy,
            yy,
            xn,
            yn,
            nn,
        } = own.scaled(self.share);
        let (x, y) = (self.at.x, self.at.y);
        let [xn, yn] = [xn * self.scale, yn * self.scale];
        let nn = nn * self.scale * self.scale;
        // The foot's centre moves with (−y, x) for each unit of spin.
        let (from_x, from_y) = (xy * x - xx * y, yy * x - xy * y);
        sum.xx += xx;
        sum.xy += xy;
        sum.yy += yy;
        sum.xn += xn + from_x;
        sum.yn += yn + from_y;
        sum.nn += nn + R::TWO * (yn * x - xn * y) + (from_y * x - from_x * y);
    }
}
