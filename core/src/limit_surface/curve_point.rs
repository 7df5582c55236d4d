//! A point of the curve of a limit surface, and what the searches ask of it.

use crate::coupling::{DominantSpeed, DryReducedFriction};
use crate::real::Real;

/// Point and rate at one normal, the leading component first.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurvePoint<R> {
    pub major: R,
    pub minor: R,
    /// dm/dh
    pub rate: R,
}

impl<R: Real> CurvePoint<R> {
    #[inline]
    pub fn of(coupling: &impl DryReducedFriction<R>, lead: DominantSpeed, ratio: R) -> Self {
        let [major, minor, rate] = coupling.reduced_point(lead, ratio);
        Self { major, minor, rate }
    }

    /// A m − a M and its rate.
    #[inline]
    pub fn across_ray(&self, ratio: R, [major, minor]: [R; 2]) -> [R; 2] {
        [
            major * self.minor - minor * self.major,
            (major + minor * ratio) * self.rate,
        ]
    }

    /// (A − M) h − κ (a − m) and its rate.
    ///
    /// Products with a weight only overflow where the other component leads.
    #[inline]
    pub fn beside_normal(&self, ratio: R, [major, minor]: [R; 2], weight: R) -> [R; 2] {
        let ahead = major - self.major;
        [
            ahead * ratio - weight * (minor - self.minor),
            ahead + (ratio * ratio + weight) * self.rate,
        ]
    }
}
