//! The ellipsoidal approximation of the limit surface, common in planners.

use super::round::RoundLimitSurface;
use super::{FrictionSet, Projection};
use crate::coupling::{DryReducedFriction, ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::error::Error;
use crate::law::validated_positive;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// (|force|/f_max)² + (torque/m_max)² ≤ 1 with f_max = μN and m_max = μN R T₀.
///
/// *Error* for the uniform disk (T₀ = 2/3): the exact surface lies inside, down to gauge 0.934 at
/// v/(ωR) = 0.766. See `docs/limit-surface.md` for forces and motions.
/// *Accuracy* as an ellipsoid: a few ulp.
/// *Source*: R. D. Howe and M. R. Cutkosky, Int. J. Robotics Research 15 (1996) 531.
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
    surface: RoundLimitSurface<R, Ellipse<R>>,
}

/// The coupling whose meridian is an ellipse: F = v/s, T = T₀² w/s, s² = v² + T₀² w².
///
/// Finite speeds only: it stays in this file.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ellipse<R> {
    spin_torque: R,
}

impl<R: Real> Ellipse<R> {
    /// v/s and T₀w/s, the cosine and sine of the ellipse's parameter, and s.
    #[inline]
    fn parameter(&self, slide: R, rim: R) -> [R; 3] {
        let (across, along) = (slide.abs(), self.spin_torque * rim.abs());
        let norm = across.hypot(along);
        if norm == R::ZERO {
            return [R::ZERO; 3];
        }
        [across / norm, along / norm, norm]
    }
}

impl<R: Real> ReducedFriction<R> for Ellipse<R> {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let [cos, sin, _] = self.parameter(slide, rim);
        ReducedWrench {
            force: cos,
            torque: self.spin_torque * sin,
        }
    }

    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let [cos, sin, norm] = self.parameter(slide, rim);
        let (rate, torque) = (R::ONE / norm, self.spin_torque);
        ReducedJacobian {
            force_per_slide: rate,
            force_slide: rate * sin * sin,
            mixed: -rate * torque * cos * sin,
            torque_rim: rate * torque * torque * cos * cos,
        }
    }
}

impl<R: Real> DryReducedFriction<R> for Ellipse<R> {}

impl<R: Real> LimitEllipsoid<R> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN), 0 < `radius` < ∞, 0 < `spin_torque` < ∞: the reduced
    /// torque T₀ = T(0, 1) of pure spinning, 2/3 for the uniform disk.
    pub fn new(force_limit: R, radius: R, spin_torque: R) -> Result<Self, Error> {
        let spin_torque = validated_positive("reduced torque of pure spinning", spin_torque)?;
        let surface = RoundLimitSurface::new(Ellipse { spin_torque }, force_limit, radius)?;
        Ok(Self { surface })
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
        self.surface.torque_limit()
    }
}

impl<R: Real> FrictionSet<R> for LimitEllipsoid<R> {
    #[inline]
    fn force_limit(&self) -> R {
        self.surface.force_limit()
    }
    #[inline]
    fn radius(&self) -> R {
        self.surface.radius()
    }
    #[inline]
    fn support(&self, twist: &Twist<R>) -> R {
        self.surface.support(twist)
    }
    #[inline]
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        self.surface.wrench(twist)
    }
    /// By the search that projects, so that both agree on what is inside.
    #[inline]
    fn gauge(&self, wrench: &Wrench<R>) -> R {
        self.surface.gauge(wrench)
    }
    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.surface.contains(wrench)
    }
    #[inline]
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        self.surface.twist_normal_to(push)
    }
    #[inline]
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        self.surface.scale_to_surface(wrench)
    }
    #[inline]
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        self.surface.project_with_length(wrench, length)
    }
    fn project_each(&self, wrenches: &[Wrench<R>], length: R, projections: &mut [Projection<R>]) {
        self.surface.project_each(wrenches, length, projections);
    }
}
