//! A limit surface under one load: gauge, normal and projection as searches that can go on side by side.

use super::meridian::{
    Meridian, NearestPointSearch, Normal, NormalAndPoint, NormalTolerance, RayNormal, RaySearch,
    Search, solved,
};
use super::polar::AxisymmetricPair;
use super::{Projection, Region, collar};
use crate::coupling::{DryReducedFriction, ReducedWrench};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// The set of one curve, force limit and radius.
#[derive(Debug)]
pub(super) struct ScaledCurve<'a, R, C> {
    pub meridian: &'a Meridian<R, C>,
    pub force_limit: R,
    pub radius: R,
}

/// An answer, or the search for it.
pub(super) enum AnswerOrSearch<T, S> {
    Known(T),
    Open(S),
}

/// A search whose answer is in units of the wrench.
pub(super) trait SurfaceSearch<R: Real> {
    type Answer;

    /// Computes one more point of the curve; the answer, if it is known then.
    fn advance<C: DryReducedFriction<R>>(&mut self, curve: &Meridian<R, C>)
    -> Option<Self::Answer>;
}

/// The search for a gauge.
pub(super) struct GaugeSearch<R> {
    /// The larger one of force and torque/radius, over the force limit.
    size: R,
    ray: RaySearch<R>,
}

/// The search for a normal.
pub(super) struct NormalSearch<R> {
    polar: AxisymmetricPair<R>,
    radius: R,
    ray: RaySearch<R>,
}

/// The search for the nearest point.
pub(super) struct ProjectionSearch<R> {
    polar: AxisymmetricPair<R>,
    force_limit: R,
    radius: R,
    offset: NearestPointSearch<R>,
}

/// A wrench on the quarter plane.
struct Scaled<R> {
    polar: AxisymmetricPair<R>,
    /// Force and torque/radius.
    lengths: ReducedWrench<R>,
    /// The larger of the two.
    size: R,
    /// The two in units of the larger one.
    unit: ReducedWrench<R>,
}

impl<R: Real> Scaled<R> {
    #[inline]
    fn is_zero(&self) -> bool {
        self.lengths.force == R::ZERO && self.lengths.torque == R::ZERO
    }

    /// True if infinite without being NaN.
    #[inline]
    fn is_infinite(&self) -> bool {
        let sum = self.lengths.force + self.lengths.torque;
        self.size == R::INFINITY && !sum.is_nan()
    }
}

impl<R: Real> SurfaceSearch<R> for GaugeSearch<R> {
    type Answer = R;

    #[inline]
    fn advance<C: DryReducedFriction<R>>(&mut self, curve: &Meridian<R, C>) -> Option<R> {
        let RayNormal { gauge, .. } = self.ray.advance(curve)?;
        Some(self.size * gauge)
    }
}

impl<R: Real> SurfaceSearch<R> for NormalSearch<R> {
    type Answer = Twist<R>;

    #[inline]
    fn advance<C: DryReducedFriction<R>>(&mut self, curve: &Meridian<R, C>) -> Option<Twist<R>> {
        let RayNormal { normal, gauge } = self.ray.advance(curve)?;
        // A direction that is not a number has no normal, though the search ends somewhere.
        let Normal { slide, rim } = normal;
        let known = R::ONE + R::ZERO * gauge;
        let normal = Normal {
            slide: slide * known,
            rim: rim * known,
        };
        Some(unit_twist(&self.polar, normal, self.radius))
    }
}

impl<R: Real> SurfaceSearch<R> for ProjectionSearch<R> {
    type Answer = Projection<R>;

    #[inline]
    fn advance<C: DryReducedFriction<R>>(
        &mut self,
        curve: &Meridian<R, C>,
    ) -> Option<Projection<R>> {
        let NormalAndPoint { normal, at } = self.offset.advance(curve)?;
        let limits = [self.force_limit, self.force_limit * self.radius];
        Some(Projection {
            wrench: surface_wrench(&self.polar, limits, at),
            region: Region::OnSurface {
                normal: unit_twist(&self.polar, normal, self.radius),
            },
        })
    }
}

impl<T, S> AnswerOrSearch<T, S> {
    /// The search, or the answer put in its place.
    #[inline]
    pub fn open(self, answer: &mut T) -> Option<S> {
        match self {
            Self::Known(known) => {
                *answer = known;
                None
            }
            Self::Open(task) => Some(task),
        }
    }

    /// The answer, by a search of its own.
    #[inline]
    pub fn answer<R: Real, C: DryReducedFriction<R>>(self, curve: &Meridian<R, C>) -> T
    where
        S: SurfaceSearch<R, Answer = T>,
    {
        match self {
            Self::Known(answer) => answer,
            Self::Open(mut task) => loop {
                if let Some(answer) = task.advance(curve) {
                    return answer;
                }
            },
        }
    }
}

/// A normal in the quarter plane, of which the larger part is 1, as a twist of length 1.
#[inline]
fn unit_twist<R: Real>(polar: &AxisymmetricPair<R>, normal: Normal<R>, radius: R) -> Twist<R> {
    let ratio = normal.slide * normal.rim;
    let share = R::ONE / (R::ONE + ratio * ratio).sqrt();
    polar.twist(normal.slide * share, normal.rim * share / radius)
}

/// A point of the curve as a wrench, with what is 1 there of force and torque.
#[inline]
fn surface_wrench<R: Real>(
    polar: &AxisymmetricPair<R>,
    [force, torque]: [R; 2],
    at: ReducedWrench<R>,
) -> Wrench<R> {
    polar.wrench(force * at.force, torque * at.torque)
}

impl<R: Real, C: DryReducedFriction<R>> ScaledCurve<'_, R, C> {
    /// True of wrenches so far inside that no search is needed, by the inscribed quadrangle; never of one whose
    /// gauge would be found on the surface or outside.
    #[inline]
    pub fn is_deep_inside(&self, wrench: &Wrench<R>) -> bool {
        // Squares of smaller numbers are lost.
        let least = R::MIN_POSITIVE / R::EPSILON;
        let square = wrench.force.x * wrench.force.x + wrench.force.y * wrench.force.y;
        let is_plain = square > least || (wrench.force.x == R::ZERO && wrench.force.y == R::ZERO);
        let torque = wrench.torque.abs() / self.radius;
        let bound = self.meridian.gauge_bound(square.sqrt(), torque);
        let most = self.force_limit * (R::ONE - R::TWO * collar());
        is_plain && self.force_limit > least && bound < most
    }

    #[inline]
    fn scaled(&self, wrench: &Wrench<R>) -> Scaled<R> {
        let polar = AxisymmetricPair::new(&wrench.force, wrench.torque);
        let (force, torque) = (polar.planar, polar.normal / self.radius);
        let size = if force > torque { force } else { torque };
        Scaled {
            polar,
            lengths: ReducedWrench { force, torque },
            size,
            unit: ReducedWrench {
                force: force / size,
                torque: torque / size,
            },
        }
    }

    #[inline]
    pub fn gauge(&self, wrench: &Wrench<R>) -> AnswerOrSearch<R, GaugeSearch<R>> {
        let scaled = self.scaled(wrench);
        if scaled.is_zero() {
            return AnswerOrSearch::Known(R::ZERO);
        }
        // Infinity over infinity is a direction lost, not a gauge.
        if scaled.is_infinite() {
            return AnswerOrSearch::Known(R::INFINITY);
        }
        AnswerOrSearch::Open(GaugeSearch {
            size: scaled.size / self.force_limit,
            ray: self.meridian.ray(scaled.unit, NormalTolerance::Gauge),
        })
    }

    #[inline]
    pub fn twist_normal_to(&self, push: &Wrench<R>) -> AnswerOrSearch<Twist<R>, NormalSearch<R>> {
        let scaled = self.scaled(push);
        if scaled.is_zero() {
            return AnswerOrSearch::Known(Twist::ZERO);
        }
        AnswerOrSearch::Open(NormalSearch {
            polar: scaled.polar,
            radius: self.radius,
            ray: self.meridian.ray(scaled.unit, NormalTolerance::Normal),
        })
    }

    pub fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        let scaled = self.scaled(wrench);
        if scaled.is_zero() {
            return *wrench;
        }
        let RayNormal { gauge, .. } = solved(
            &mut self.meridian.ray(scaled.unit, NormalTolerance::Gauge),
            self.meridian,
        );
        let at = ReducedWrench {
            force: scaled.unit.force / gauge,
            torque: scaled.unit.torque / gauge,
        };
        self.surface_wrench(&scaled.polar, at)
    }

    #[inline]
    pub fn surface_wrench(&self, polar: &AxisymmetricPair<R>, at: ReducedWrench<R>) -> Wrench<R> {
        let limits = [self.force_limit, self.force_limit * self.radius];
        surface_wrench(polar, limits, at)
    }

    /// The projection of a wrench that is not deep inside.
    #[inline]
    pub fn project(
        &self,
        wrench: &Wrench<R>,
        length: R,
    ) -> AnswerOrSearch<Projection<R>, ProjectionSearch<R>> {
        if self.force_limit == R::ZERO {
            return AnswerOrSearch::Known(self.project_to_origin(wrench, length));
        }
        let scaled = self.scaled(wrench);
        // A tangent may tell what a search would.
        let most = self.force_limit * (R::ONE + R::TWO * collar());
        if !self.meridian.is_beyond_tangents(scaled.lengths, most)
            && let Some(known) = self.not_outside(wrench, &scaled)
        {
            return AnswerOrSearch::Known(known);
        }
        self.project_outside(wrench, &scaled, length)
    }

    /// The projection of a wrench inside or on the surface; none for one outside or NaN.
    fn not_outside(&self, wrench: &Wrench<R>, scaled: &Scaled<R>) -> Option<Projection<R>> {
        if scaled.is_zero() {
            return Some(inside(wrench));
        }
        let size = scaled.size / self.force_limit;
        let mut ray = self.meridian.ray(scaled.unit, NormalTolerance::Side(size));
        let gauge = size * solved(&mut ray, self.meridian).gauge;
        if gauge < R::ONE - collar() {
            Some(inside(wrench))
        } else if gauge <= R::ONE + collar() {
            let normal = self.twist_normal_to(wrench).answer(self.meridian);
            Some(Projection {
                wrench: *wrench,
                region: Region::OnSurface { normal },
            })
        } else {
            None
        }
    }

    /// The nearest point for a wrench outside.
    #[inline]
    fn project_outside(
        &self,
        wrench: &Wrench<R>,
        scaled: &Scaled<R>,
        length: R,
    ) -> AnswerOrSearch<Projection<R>, ProjectionSearch<R>> {
        let lever = length / self.radius;
        let far = ReducedWrench {
            force: scaled.lengths.force / self.force_limit,
            torque: scaled.lengths.torque / self.force_limit,
        };
        let bound = self.meridian.gauge_bound(far.force, far.torque);
        let has_gauge = bound.is_finite() || self.has_gauge(wrench);
        if !(has_gauge && length > R::ZERO && length.is_finite()) {
            return AnswerOrSearch::Known(no_projection());
        }
        AnswerOrSearch::Open(ProjectionSearch {
            polar: scaled.polar,
            force_limit: self.force_limit,
            radius: self.radius,
            offset: self.meridian.offset(far, lever * lever),
        })
    }

    #[cold]
    fn has_gauge(&self, wrench: &Wrench<R>) -> bool {
        self.gauge(wrench).answer(self.meridian).is_finite()
    }

    /// The projection onto {0}, the set without force limit.
    #[cold]
    fn project_to_origin(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let polar = AxisymmetricPair::new(&wrench.force, wrench.torque);
        if polar.planar == R::ZERO && polar.normal == R::ZERO {
            return inside(wrench);
        }
        // Every twist is a normal of a point; this one lies along the displacement.
        let lever = length / self.radius;
        let (slide, rim) = (polar.planar, polar.normal / length / lever);
        let norm = slide.hypot(rim);
        if !(norm.is_finite() && length > R::ZERO) {
            return no_projection();
        }
        let normal = polar.twist(slide / norm, rim / norm / self.radius);
        Projection {
            wrench: Wrench::ZERO,
            region: Region::OnSurface { normal },
        }
    }
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
