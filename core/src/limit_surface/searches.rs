//! A limit surface under loads: gauges, normals and projections of one wrench, or of several side by side.

use super::meridian::{Alone, Meridian, NormalAndPoint, RayNormal};
use super::polar::{AxisymmetricPair, is_ordinary, pair};
use super::ratio_search::Curve;
use super::{Projection, Region, collar};
use crate::coupling::DryReducedFriction;
use crate::lanes::{Lanes, Numbers};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// The set of one curve and radius under each lane's force limit.
#[derive(Debug)]
pub(super) struct ScaledCurve<'a, R, C, L> {
    pub meridian: &'a Meridian<R, C>,
    pub force_limit: L,
    pub radius: R,
}

/// Points of the surface and outward normals there: the nearest ones of wrenches outside.
pub(super) struct Projected<L> {
    pub wrench: [L; 3],
    pub normal: [L; 3],
    /// 1 inside, −1 outside, 0 next to the surface, where the gauge is to decide.
    pub side: L,
}

impl<R: Real, C: DryReducedFriction<R>, L: Numbers<Real = R>> ScaledCurve<'_, R, C, L> {
    /// Force and torque/radius.
    #[inline(always)]
    pub fn lengths(&self, pair: &AxisymmetricPair<L>) -> [L; 2] {
        [pair.planar, pair.normal / L::repeat(self.radius)]
    }

    /// True of wrenches so far inside that no search is needed, by the inscribed quadrangle; never of one whose
    /// gauge would be found on the surface or outside.
    #[inline(always)]
    pub fn is_deep_inside(&self, lengths: [L; 2]) -> L::Mask {
        let bound = self.meridian.gauge_bound(lengths);
        bound.below(self.force_limit * L::repeat(R::ONE - R::TWO * collar()))
    }

    /// *Domain*: lengths that are [`is_ordinary`], not both zero.
    #[inline(always)]
    pub fn gauge(&self, curve: &impl Curve<L>, lengths: [L; 2]) -> L {
        self.meridian.ray(curve, lengths).gauge / self.force_limit
    }

    /// The outward normal along the ray of a wrench with these lengths, in any unit.
    #[inline(always)]
    pub fn motion(
        &self,
        curve: &impl Curve<L>,
        pair: &AxisymmetricPair<L>,
        lengths: [L; 2],
    ) -> [L; 3] {
        let RayNormal { normal, .. } = self.meridian.ray(curve, lengths);
        self.unit_twist(pair, normal)
    }

    /// A normal in the quarter plane, of which the larger part is 1, as a twist of length 1.
    #[inline(always)]
    fn unit_twist(&self, pair: &AxisymmetricPair<L>, [slide, rim]: [L; 2]) -> [L; 3] {
        let (one, ratio) = (L::splat(1.0), slide * rim);
        let share = one / (one + ratio * ratio).sqrt();
        pair.vector([slide * share, rim * share / L::repeat(self.radius)])
    }

    /// A point of the curve as a wrench.
    #[inline(always)]
    pub fn surface_wrench(&self, pair: &AxisymmetricPair<L>, [force, torque]: [L; 2]) -> [L; 3] {
        let limit = self.force_limit;
        pair.vector([limit * force, limit * L::repeat(self.radius) * torque])
    }

    /// The nearest wrench of the set. *Domain*: a wrench with a finite gauge, a positive force limit and length.
    #[inline(always)]
    pub fn project(
        &self,
        curve: &impl Curve<L>,
        pair: &AxisymmetricPair<L>,
        length: R,
    ) -> Projected<L> {
        let lever = length / self.radius;
        let point = self.lengths(pair).map(|part| part / self.force_limit);
        let NormalAndPoint {
            normal,
            at,
            power,
            beyond,
        } = self.meridian.nearest(curve, point, lever * lever);
        // Twice the collar: there the gauge is measured, whose rounding is its own.
        let width = L::repeat(R::TWO * collar()) * power;
        let is_inside = beyond.below(-width);
        let (one, none) = (L::splat(1.0), L::splat(0.0));
        let outside = L::select(width.below(beyond), -one, none);
        Projected {
            wrench: self.surface_wrench(pair, at),
            normal: self.unit_twist(pair, normal),
            side: L::select(is_inside, one, outside),
        }
    }
}

/// One wrench of any size.
impl<R: Real, C: DryReducedFriction<R>> ScaledCurve<'_, R, C, R::Alone> {
    #[inline]
    fn limit(&self) -> R {
        let [limit] = self.force_limit.to_array();
        limit
    }

    #[inline]
    pub fn gauge_of(&self, wrench: &Wrench<R>) -> R {
        let lengths = self.lengths(&pair(&wrench.force, wrench.torque));
        let [[force], [torque]] = lengths.map(Numbers::to_array);
        if force == R::ZERO && torque == R::ZERO {
            return R::ZERO;
        }
        // Infinity over infinity is a direction lost, not a gauge.
        if is_infinite([force, torque]) {
            // None under a limit that is not a number.
            return R::INFINITY + self.limit();
        }
        let (size, unit) = in_range(lengths);
        let gauge = if size == R::ONE {
            self.gauge(&Alone(self.meridian), lengths)
        } else {
            let ray = self.meridian.ray(&Alone(self.meridian), unit);
            R::Alone::repeat(size) / self.force_limit * ray.gauge
        };
        let [gauge] = gauge.to_array();
        gauge
    }

    #[inline]
    pub fn motion_of(&self, push: &Wrench<R>) -> Twist<R> {
        if is_none(push) {
            return Twist::ZERO;
        }
        let pair = pair(&push.force, push.torque);
        let (_, unit) = in_range::<R>(self.lengths(&pair));
        twist(self.motion(&Alone(self.meridian), &pair, unit))
    }

    pub fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        if is_none(wrench) {
            return *wrench;
        }
        let pair = pair(&wrench.force, wrench.torque);
        let (_, unit) = in_range::<R>(self.lengths(&pair));
        let RayNormal { gauge, .. } = self.meridian.ray(&Alone(self.meridian), unit);
        let [[x], [y], [torque]] = self
            .surface_wrench(&pair, unit.map(|part| part / gauge))
            .map(Numbers::to_array);
        Wrench::new(x, y, torque)
    }

    #[inline]
    pub fn project_one(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let pair = pair(&wrench.force, wrench.torque);
        let lengths = self.lengths(&pair);
        if self.is_deep_inside(lengths) || is_none(wrench) {
            return inside(wrench);
        }
        let limit = self.limit();
        if limit == R::ZERO {
            return self.project_to_origin(wrench, length);
        }
        let has_length = length > R::ZERO && length.is_finite();
        let [[force], [torque]] = lengths.map(|part| (part / self.force_limit).to_array());
        if !(force.is_finite() && torque.is_finite()) {
            return no_projection();
        }
        self.searched(wrench, &pair, if has_length { Some(length) } else { None })
    }

    /// The projection of a wrench that is not deep inside; NaN for one outside where there is no length.
    #[inline(never)]
    fn searched(
        &self,
        wrench: &Wrench<R>,
        pair: &AxisymmetricPair<R::Alone>,
        length: Option<R>,
    ) -> Projection<R> {
        let Projected {
            wrench: nearest,
            normal,
            side,
        } = self.project(&Alone(self.meridian), pair, length.unwrap_or(self.radius));
        let [side] = side.to_array();
        if side > R::ZERO {
            return inside(wrench);
        }
        let [[x], [y], [torque]] = nearest.map(Numbers::to_array);
        let nearest = match length {
            Some(_) => Projection {
                wrench: Wrench::new(x, y, torque),
                region: Region::OnSurface {
                    normal: twist(normal),
                },
            },
            None => no_projection(),
        };
        if side < R::ZERO {
            nearest
        } else {
            self.beside_surface(wrench, nearest)
        }
    }

    /// The projection of a wrench next to the surface, of which `nearest` is that of one outside.
    #[cold]
    pub fn beside_surface(&self, wrench: &Wrench<R>, nearest: Projection<R>) -> Projection<R> {
        let gauge = self.gauge_of(wrench);
        if gauge < R::ONE - collar() {
            inside(wrench)
        } else if gauge <= R::ONE + collar() {
            Projection {
                wrench: *wrench,
                region: Region::OnSurface {
                    normal: self.motion_of(wrench),
                },
            }
        } else {
            nearest
        }
    }

    /// The projection onto {0}, the set without force limit.
    #[cold]
    fn project_to_origin(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let pair = pair(&wrench.force, wrench.torque);
        let [[planar], [turn]] = [pair.planar, pair.normal].map(Numbers::to_array);
        // Every twist is a normal of a point; this one lies along the displacement.
        let lever = length / self.radius;
        let (slide, rim) = (planar, turn / length / lever);
        let norm = slide.hypot(rim);
        if !(norm.is_finite() && length > R::ZERO) {
            return no_projection();
        }
        let normal = [slide / norm, rim / norm / self.radius].map(R::Alone::repeat);
        Projection {
            wrench: Wrench::ZERO,
            region: Region::OnSurface {
                normal: twist(pair.vector(normal)),
            },
        }
    }
}

/// A unit of lengths, and lengths in it whose products are normal numbers: 1 where they are so themselves, else the larger.
#[inline]
fn in_range<R: Real>(lengths: [R::Alone; 2]) -> (R, [R::Alone; 2]) {
    let [force, torque] = lengths;
    if is_ordinary::<R, R::Alone>(force) && is_ordinary::<R, R::Alone>(torque) {
        return (R::ONE, lengths);
    }
    let size = torque.larger(force);
    let [number] = size.to_array();
    (number, [force / size, torque / size])
}

#[inline]
fn is_none<R: Real>(wrench: &Wrench<R>) -> bool {
    wrench.force.x == R::ZERO && wrench.force.y == R::ZERO && wrench.torque == R::ZERO
}

/// True if infinite without being NaN.
#[inline]
fn is_infinite<R: Real>([force, torque]: [R; 2]) -> bool {
    let sum = force + torque;
    sum == R::INFINITY && (force == R::INFINITY || torque == R::INFINITY)
}

#[inline]
fn twist<R: Real>(parts: [R::Alone; 3]) -> Twist<R> {
    let [[x], [y], [spin]] = parts.map(Numbers::to_array);
    Twist::new(x, y, spin)
}

/// The answer to a wrench of the set.
#[inline]
pub(super) fn inside<R: Real>(wrench: &Wrench<R>) -> Projection<R> {
    Projection {
        wrench: *wrench,
        region: Region::Inside,
    }
}

/// The answer to a wrench that has no nearest point.
#[cold]
fn no_projection<R: Real>() -> Projection<R> {
    let nan = nalgebra::Vector2::new(R::NAN, R::NAN);
    Projection {
        wrench: Wrench {
            force: nan,
            torque: R::NAN,
        },
        region: Region::OnSurface {
            normal: Twist {
                velocity: nan,
                spin: R::NAN,
            },
        },
    }
}
