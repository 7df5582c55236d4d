//! Limit surfaces besides the disk's.

use super::points::four_nodes;
use super::stream::{Precision, Range, Stream};
use super::surfaces::{BATCH, feed_projection, feed_projections};
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::{Annulus, DryReducedFriction, RoundFriction};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, ShapeLimitSurface};
use tribos_core::patch::points::PointPatch;
use tribos_core::real::Real;
use tribos_core::twist::Wrench;

/// A push on a round patch with its load.
struct Case<R: Real> {
    coefficient: R,
    radius: R,
    load: R,
    wrench: Wrench<R>,
    length: R,
}

impl<R: Precision> Case<R> {
    fn feed<C: DryReducedFriction<R> + Copy>(&self, s: &mut Stream, coupling: Option<C>) {
        let set = coupling.and_then(|coupling| {
            RoundFriction::new(coupling, self.coefficient, self.radius).ok()?;
            RoundLimitSurface::new(coupling, self.coefficient * self.load, self.radius).ok()
        });
        self.feed_set(s, set.as_ref());
    }

    /// Many pushes, each with its load.
    fn feed_many<C: DryReducedFriction<R> + Copy>(
        &self,
        s: &mut Stream,
        coupling: Option<C>,
        (loads, pushes): (&[R; BATCH], &[Wrench<R>; BATCH]),
    ) {
        let set = coupling.and_then(|coupling| {
            RoundFriction::new(coupling, self.coefficient, self.radius).ok()?;
            RoundLimitSurface::new(coupling, self.coefficient, self.radius).ok()
        });
        feed_projections(s, set.ok_or(()), loads, pushes, self.length);
    }

    fn feed_set(&self, s: &mut Stream, set: Option<&impl FrictionSet<R>>) {
        s.result(set.map(|set| set.gauge(&self.wrench)).ok_or(()));
        let nearest = set.map(|set| {
            // In C a length of 0 represents the radius.
            let length = if self.length == R::ZERO {
                set.radius()
            } else {
                self.length
            };
            set.project_with_length(&self.wrench, length)
        });
        feed_projection(s, nearest);
    }
}

pub fn all<R: Precision>(s: &mut Stream, range: Range) {
    let [coefficient, radius, load, length, inner]: [R; 5] = s.draws(Range::Fit);
    let x: [R; 12] = s.draws(Range::Mild);
    let case = Case {
        coefficient,
        radius,
        load,
        wrench: s.wrench(range),
        length,
    };
    case.feed(s, Annulus::new(CoulombDisk, inner / R::TWO).ok());
    case.feed(s, Some(CoulombHertz));
    case.feed(s, Some(CoulombRing));
    case.feed(s, Some(CoulombPunch));
    let loads = s.draws(range);
    let pushes = [(); BATCH].map(|()| s.wrench(range));
    let many = (&loads, &pushes);
    case.feed_many(s, Annulus::new(CoulombDisk, inner / R::TWO).ok(), many);
    case.feed_many(s, Some(CoulombHertz), many);
    case.feed_many(s, Some(CoulombRing), many);
    case.feed_many(s, Some(CoulombPunch), many);
    let points = four_nodes(&x).and_then(PointPatch::new).ok();
    let points = points.and_then(|points| ShapeLimitSurface::new(points, coefficient).ok());
    case.feed_set(s, points.as_ref());
}
