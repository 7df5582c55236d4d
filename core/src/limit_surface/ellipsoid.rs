//! The ellipsoidal approximation of the limit surface, common in planners.

use super::round::RoundLimitSurface;
use super::{FrictionSet, Projection, Region};
use crate::coupling::{DryReducedFriction, ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::error::Error;
use crate::law::validated_positive;
use crate::patch::validated_radius;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// (|force|/f_max)² + (torque/m_max)² ≤ 1 with f_max = μN and m_max = μN R T₀.
///
/// *Error* for the uniform disk (T₀ = 2/3): the exact surface lies inside, down to gauge 0.934 at
/// v/(ωR) = 0.766. See `docs/limit-surface.md` for forces and motions.
/// *Accuracy* as an ellipsoid: a few ulp. A torque over the arm R T₀ that overflows has an infinite gauge.
/// *Source*: R. D. Howe and M. R. Cutkosky, Int. J. Robotics Research 15 (1996) 557.
///
/// ```
/// use tribos_core::limit_surface::{LimitEllipsoid, FrictionSet};
/// use tribos_core::twist::Twist;
/// let puck = LimitEllipsoid::new(0.51_f64, 0.04, 2.0 / 3.0)?; // N, m, uniform disk
/// let friction = puck.wrench(&Twist::new(0.0, 0.0, 2.0));
/// assert!((friction.torque + 0.51 * 0.04 * 2.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitEllipsoid<R> {
    /// A ball, whose radius is R T₀.
    ball: RoundLimitSurface<R, Circle>,
    radius: R,
}

/// The coupling whose meridian is a circle: F = v/s, T = w/s, s² = v² + w².
///
/// Finite speeds only: it stays in this file.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Circle;

/// v/s, w/s and s.
#[inline]
fn direction<R: Real>(slide: R, rim: R) -> [R; 3] {
    let (slide, rim) = (slide.abs(), rim.abs());
    let norm = slide.hypot(rim);
    if norm == R::ZERO {
        return [R::ZERO; 3];
    }
    [slide / norm, rim / norm, norm]
}

impl<R: Real> ReducedFriction<R> for Circle {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let [force, torque, _] = direction(slide, rim);
        ReducedWrench { force, torque }
    }

    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let [cos, sin, norm] = direction(slide, rim);
        let rate = R::ONE / norm;
        ReducedJacobian {
            force_per_slide: rate,
            force_slide: rate * sin * sin,
            mixed: -rate * cos * sin,
            torque_rim: rate * cos * cos,
        }
    }
}

impl<R: Real> DryReducedFriction<R> for Circle {
    #[inline]
    fn is_smooth(&self) -> bool {
        true
    }
}

impl<R: Real> LimitEllipsoid<R> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN), 0 < `radius` < ∞, 0 < `spin_torque` < ∞: the reduced
    /// torque T₀ = T(0, 1) of pure spinning, 2/3 for the uniform disk; 0 < R T₀ < ∞ as computed.
    pub fn new(force_limit: R, radius: R, spin_torque: R) -> Result<Self, Error> {
        let radius = validated_radius(radius)?;
        let spin_torque = validated_positive("reduced torque of pure spinning", spin_torque)?;
        let arm = validated_positive("arm of pure spinning", radius * spin_torque)?;
        let ball = RoundLimitSurface::new(Circle, force_limit, arm)?;
        Ok(Self { ball, radius })
    }

    /// The largest torque, μN R T₀.
    ///
    /// ```
    /// use tribos_core::limit_surface::{LimitEllipsoid, FrictionSet};
    /// use tribos_core::twist::Wrench;
    /// let puck = LimitEllipsoid::new(0.51_f64, 0.04, 2.0 / 3.0)?; // N, m
    /// // 60 % of the largest force leave 80 % of the largest torque.
    /// let torque = 0.8 * puck.torque_limit();
    /// let wrench = Wrench::new(0.6 * puck.force_limit(), 0.0, torque);
    /// assert!((puck.gauge(&wrench) - 1.0).abs() < 1e-15);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn torque_limit(&self) -> R {
        self.ball.torque_limit()
    }

    /// A normal of length 1 with the ball's radius as one with this radius.
    #[inline]
    fn unit(&self, normal: Twist<R>) -> Twist<R> {
        let length = normal.speed().hypot(normal.spin * self.radius);
        if length == R::ZERO {
            return normal;
        }
        Twist {
            velocity: normal.velocity / length,
            spin: normal.spin / length,
        }
    }

    #[inline]
    fn with_unit_normal(&self, projection: Projection<R>) -> Projection<R> {
        let region = match projection.region {
            Region::Inside => Region::Inside,
            Region::OnSurface { normal } => Region::OnSurface {
                normal: self.unit(normal),
            },
        };
        Projection {
            region,
            ..projection
        }
    }
}

impl<R: Real> FrictionSet<R> for LimitEllipsoid<R> {
    #[inline]
    fn force_limit(&self) -> R {
        self.ball.force_limit()
    }
    #[inline]
    fn radius(&self) -> R {
        self.radius
    }
    #[inline]
    fn support(&self, twist: &Twist<R>) -> R {
        self.ball.support(twist)
    }
    #[inline]
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        self.ball.wrench(twist)
    }
    #[inline]
    fn gauge(&self, wrench: &Wrench<R>) -> R {
        self.ball.gauge(wrench)
    }
    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.ball.contains(wrench)
    }
    #[inline]
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        self.unit(self.ball.twist_normal_to(push))
    }
    #[inline]
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        self.ball.scale_to_surface(wrench)
    }
    #[inline]
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        self.with_unit_normal(self.ball.project_with_length(wrench, length))
    }
    fn project_each(&self, wrenches: &[Wrench<R>], length: R, projections: &mut [Projection<R>]) {
        self.ball.project_each(wrenches, length, projections);
        for projection in projections {
            *projection = self.with_unit_normal(*projection);
        }
    }
}
