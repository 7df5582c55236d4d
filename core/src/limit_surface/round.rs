//! The exact limit surface of a dry coupling.

use super::meridian::{Meridian, Normal};
use super::polar::AxisymmetricPair;
use super::searches::{ScaledCurve, inside};
use super::{FrictionSet, LimitEllipsoid, Projection, collar};
use crate::coupling::{DryReducedFriction, ReducedWrench};
use crate::error::Error;
use crate::law::validated_not_negative;
use crate::patch::validated_radius;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// All wrenches that the friction of a patch can carry, to rounding.
///
/// *Units*: any consistent set. The surface is the set of points force = μN F(v, ωR),
/// torque = μN R T(v, ωR) of the coupling.
///
/// The coupling's wrench must turn with its twist, without jumps, from (1, 0) in pure sliding to
/// (0, T₀) in pure spinning, as that of every axisymmetric patch does; slopes may be infinite.
///
/// *Accuracy* (f64, table tier): gauge, surface points and projections 1e-15 of the limits, the motion's ratio
/// 1e-15 relative; f32: 3e-7 of the limits.
/// *Cost* in points of the coupling with their rates, on the uniform disk: gauge 2, normal 2 or 3, projection
/// none deep inside, 1 to 3 next to the surface, 2 outside (more for lengths far from the radius). A projection's
/// two searches end after at most 64 points each. A surface is prepared with 9.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
/// use tribos_core::twist::Twist;
/// let puck = RoundLimitSurface::new(CoulombDisk, 0.51_f64, 0.04)?; // N, m
/// assert!((puck.torque_limit() - 0.51 * 0.04 * 2.0 / 3.0).abs() < 1e-17);
/// // The ellipsoid with the same limits holds wrenches that the puck cannot carry.
/// let usual = puck.ellipsoid()?;
/// assert!((usual.torque_limit() - puck.torque_limit()).abs() < 1e-17);
/// let friction = puck.wrench(&Twist::new(0.1, 0.0, 3.0)); // m/s, rad/s
/// assert!(usual.gauge(&friction) < 0.94 && (puck.gauge(&friction) - 1.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundLimitSurface<R, C> {
    meridian: Meridian<R, C>,
    force_limit: R,
    radius: R,
}

impl<R: Real, C: DryReducedFriction<R>> RoundLimitSurface<R, C> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN), 0 < `radius` < ∞. Without force limit the set is {0}.
    pub fn new(coupling: C, force_limit: R, radius: R) -> Result<Self, Error> {
        let force_limit = validated_not_negative("force limit", force_limit)?;
        Ok(Self {
            meridian: Meridian::new(coupling),
            // A quotient by −0 would have the wrong sign.
            force_limit: force_limit.abs(),
            radius: validated_radius(radius)?,
        })
    }

    /// The coupling whose wrenches make the surface.
    pub fn coupling(&self) -> &C {
        &self.meridian.coupling
    }

    /// The largest torque, μN R T(0, 1).
    pub fn torque_limit(&self) -> R {
        self.force_limit * self.radius * self.spin_torque()
    }

    /// The ellipsoid with the same largest force and torque.
    pub fn ellipsoid(&self) -> Result<LimitEllipsoid<R>, Error> {
        LimitEllipsoid::new(self.force_limit, self.radius, self.spin_torque())
    }

    fn spin_torque(&self) -> R {
        let Self { meridian, .. } = self;
        let spinning = Normal {
            slide: R::ZERO,
            rim: R::ONE,
        };
        meridian.point(spinning).torque
    }

    /// The curve in reduced units.
    #[inline]
    pub(super) fn meridian(&self) -> &Meridian<R, C> {
        &self.meridian
    }

    /// The set under `load` times the force limit; no number for a negative load.
    #[inline]
    pub(super) fn loaded(&self, load: R) -> ScaledCurve<'_, R, C> {
        // A quotient by −0 would have the wrong sign.
        let force_limit = self.force_limit * load + R::ZERO;
        ScaledCurve {
            force_limit: if force_limit >= R::ZERO {
                force_limit
            } else {
                R::NAN
            },
            ..self.itself()
        }
    }

    /// The projection of a wrench that is not deep inside.
    #[inline(never)]
    fn searched(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let projection = self.itself().project(wrench, length);
        projection.answer(&self.meridian)
    }

    /// The set itself.
    #[inline]
    fn itself(&self) -> ScaledCurve<'_, R, C> {
        ScaledCurve {
            meridian: &self.meridian,
            force_limit: self.force_limit,
            radius: self.radius,
        }
    }
}

impl<R: Real, C: DryReducedFriction<R>> FrictionSet<R> for RoundLimitSurface<R, C> {
    #[inline]
    fn force_limit(&self) -> R {
        self.force_limit
    }

    #[inline]
    fn radius(&self) -> R {
        self.radius
    }

    #[inline]
    fn support(&self, twist: &Twist<R>) -> R {
        let (slide, rim) = (twist.speed(), (twist.spin * self.radius).abs());
        let ReducedWrench { force, torque } = self.meridian.point(Normal { slide, rim });
        self.force_limit * (slide * force + rim * torque)
    }

    #[inline]
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        let polar = AxisymmetricPair::new(&twist.velocity, twist.spin);
        let (slide, rim) = (polar.planar, polar.normal * self.radius);
        let ReducedWrench { force, torque } = self.meridian.point(Normal { slide, rim });
        let against = ReducedWrench {
            force: -force,
            torque: -torque,
        };
        self.itself().surface_wrench(&polar, against)
    }

    #[inline]
    fn gauge(&self, wrench: &Wrench<R>) -> R {
        self.itself().gauge(wrench).answer(&self.meridian)
    }

    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.itself().is_deep_inside(wrench) || self.gauge(wrench) <= R::ONE + collar()
    }

    #[inline]
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        self.itself().twist_normal_to(push).answer(&self.meridian)
    }

    #[inline]
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        self.itself().scale_to_surface(wrench)
    }

    #[inline]
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let set = self.itself();
        if set.is_deep_inside(wrench) {
            return inside(wrench);
        }
        self.searched(wrench, length)
    }
}
