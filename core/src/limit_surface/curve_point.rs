//! A point of the curve of a limit surface, and the equations that searches solve along it.

use crate::lanes::Numbers;

/// Point and rate at one normal, the leading component first.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurvePoint<L> {
    pub major: L,
    pub minor: L,
    /// dm/dh
    pub rate: L,
}

/// A function of the ratio that rises through one zero along the curve.
pub(super) trait Equation<L> {
    /// Its value and its rate.
    fn at(&self, ratio: L, point: &CurvePoint<L>) -> [L; 2];
    /// The rate of its rate, of d²m/dh².
    fn bend(&self, ratio: L, point: &CurvePoint<L>, bend: L) -> L;
}

/// A m − a M: the point (m, M) lies on the ray of (a, A).
#[derive(Clone, Copy, Debug)]
pub(super) struct OnRay<L> {
    pub given: [L; 2],
}

/// (A − M) h − κ (a − m): the displacement from the curve to (a, A) has the direction of the normal.
///
/// Products with a weight only overflow where the other component leads.
#[derive(Clone, Copy, Debug)]
pub(super) struct AlongNormal<L> {
    pub given: [L; 2],
    pub weight: L,
}

impl<L: Numbers> Equation<L> for OnRay<L> {
    #[inline(always)]
    fn at(&self, ratio: L, point: &CurvePoint<L>) -> [L; 2] {
        let [major, minor] = self.given;
        [
            major * point.minor - minor * point.major,
            (major + minor * ratio) * point.rate,
        ]
    }
    #[inline(always)]
    fn bend(&self, ratio: L, point: &CurvePoint<L>, bend: L) -> L {
        let [major, minor] = self.given;
        minor * point.rate + (major + minor * ratio) * bend
    }
}

impl<L: Numbers> Equation<L> for AlongNormal<L> {
    #[inline(always)]
    fn at(&self, ratio: L, point: &CurvePoint<L>) -> [L; 2] {
        let [major, minor] = self.given;
        let ahead = major - point.major;
        [
            ahead * ratio - self.weight * (minor - point.minor),
            ahead + (ratio * ratio + self.weight) * point.rate,
        ]
    }
    #[inline(always)]
    fn bend(&self, ratio: L, point: &CurvePoint<L>, bend: L) -> L {
        L::splat(3.0) * ratio * point.rate + (ratio * ratio + self.weight) * bend
    }
}
