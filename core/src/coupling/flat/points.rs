//! Friction of points.

use super::motion::{Motion, SplitMotion};
use super::pair_of_numbers::Pair2;
use super::pole_far::TranslatingMotion;
use super::sums::WrenchSums;
use super::{Hessian, PatchShape, PointLoad, Reduced};
use crate::patch::nodes::NodePatch;
use crate::patch::points::PointPatch;
use crate::real::Real;
use nalgebra::Vector2;

/// A point nearer to the centre of rotation than this many rounding errors of the radius rests: the
/// direction of its motion is not known.
const REST_ULPS: f64 = 64.0;

/// The same as a distance.
pub(super) fn rest<R: Real>() -> R {
    R::from_f64(REST_ULPS) * R::EPSILON
}

impl<R: Real, P: NodePatch<R>> PatchShape<R> for PointPatch<R, P> {
    fn centre(&self) -> Vector2<R> {
        PointPatch::centre(self)
    }

    fn radius(&self) -> R {
        PointPatch::radius(self)
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        summed::<R, false>(self, motion).0
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        summed::<R, true>(self, motion)
    }

    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        let loaded = || {
            let nodes = self
                .nodes()
                .nodes()
                .iter()
                .map(|node| self.reduced_node(node));
            nodes.filter(|(_, share)| *share > R::ZERO)
        };
        let mut nearest: Option<([R; 2], R)> = None;
        for ([x, y], _) in loaded() {
            let distance = (x - place.x).hypot(y - place.y);
            if nearest.is_none_or(|(_, least)| distance < least) {
                nearest = Some(([x, y], distance));
            }
        }
        let ([x, y], _) = nearest?;
        // Points that coincide are one.
        let mut share = R::ZERO;
        for ([other_x, other_y], part) in loaded() {
            if (other_x - x).hypot(other_y - y) <= rest() {
                share += part;
            }
        }
        let place = Vector2::new(x, y);
        Some(PointLoad { place, share })
    }
}

fn summed<R: Real, const WITH_HESSIAN: bool>(
    points: &PointPatch<R, impl NodePatch<R>>,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let mut sums = WrenchSums::new();
    let none = ([R::ONE, R::ZERO], R::ZERO);
    let pairs = points.nodes().nodes().chunks(2);
    match motion.split() {
        SplitMotion::Turns { centre, spin } => {
            for pair in pairs {
                let mut nodes = pair.iter().map(|node| {
                    let ([x, y], share) = points.reduced_node(node);
                    let (x, y) = (x - centre.x, y - centre.y);
                    let rests = x * x + y * y <= rest::<R>() * rest::<R>();
                    if rests { none } else { ([x, y], share) }
                });
                let lanes = [nodes.next().unwrap_or(none), nodes.next().unwrap_or(none)];
                let (at, share) = two(lanes);
                sums.turn::<WITH_HESSIAN>(at, share);
            }
            sums.turned(&centre, spin)
        }
        SplitMotion::Slides {
            direction,
            turn,
            speed,
        } => {
            let (direction, spin) = (&direction, turn);
            let slide = TranslatingMotion { direction, spin };
            for pair in pairs {
                let mut nodes = pair.iter().map(|node| {
                    let ([x, y], share) = points.reduced_node(node);
                    // One without load may be anywhere.
                    if share > R::ZERO {
                        (slide.turned(&Vector2::new(x, y)), share)
                    } else {
                        ([R::ZERO; 2], R::ZERO)
                    }
                });
                let middle = ([R::ZERO; 2], R::ZERO);
                let lanes = [
                    nodes.next().unwrap_or(middle),
                    nodes.next().unwrap_or(middle),
                ];
                let (at, share) = two(lanes);
                sums.slide::<WITH_HESSIAN>(Pair2::of(spin), at, share);
            }
            sums.slid(&slide, speed)
        }
    }
}

#[inline(always)]
fn two<R>(
    [([x, y], k), ([other_x, other_y], other_k)]: [([R; 2], R); 2],
) -> ([Pair2<R>; 2], Pair2<R>) {
    (
        [Pair2([x, other_x]), Pair2([y, other_y])],
        Pair2([k, other_k]),
    )
}
