//! The exact limit surface of a dry coupling.

use super::batch::under_one_load;
use super::meridian::{CurveNumbers, Meridian};
use super::polar::pair;
use super::searches::ScaledCurve;
use super::{FrictionSet, LimitEllipsoid, Projection, collar};
use crate::coupling::DryReducedFriction;
use crate::error::Error;
use crate::lanes::Numbers;
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
/// *Accuracy* (f64): gauge, surface points and projections 1e-15 of the limits, the motion's ratio along a ray
/// 1e-15 relative; f32: 3e-7 of the limits, 4e-7 for lengths below 0.3 R.
/// *Cost* in points of the coupling with their rates: gauge, normal and projection 2 or 3 (more for lengths far from the
/// radius), a projection deep inside none, within 128 roundings of the surface those of a gauge more. A search ends after
/// at most 66 points, without a number where that is not enough. A surface is prepared with 15, that of a uniform disk with 3.
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

    /// What is prepared of the curve of the surface.
    #[doc(hidden)]
    pub fn curve_numbers(&self) -> CurveNumbers<R> {
        self.meridian.numbers()
    }

    /// The largest torque, μN R T(0, 1).
    pub fn torque_limit(&self) -> R {
        let [_, torque] = self.limits_under(R::ONE);
        torque
    }

    /// The largest force and torque under a load times the force limit; no numbers for a negative load.
    pub(crate) fn limits_under(&self, load: R) -> [R; 2] {
        let load = if load >= R::ZERO { load } else { R::NAN };
        let force = self.force_limit * load;
        [force, force * self.radius * self.meridian.spin_torque]
    }

    /// The ellipsoid with the same largest force and torque, if its arm R T(0, 1) is a number above 0.
    pub fn ellipsoid(&self) -> Result<LimitEllipsoid<R>, Error> {
        LimitEllipsoid::new(self.force_limit, self.radius, self.meridian.spin_torque)
    }

    /// The set under each lane's load times the force limit; no number for a negative load.
    #[inline(always)]
    pub(super) fn loaded<L: Numbers<Real = R>>(&self, load: L) -> ScaledCurve<'_, R, C, L> {
        // A quotient by −0 would have the wrong sign.
        let force_limit = L::repeat(self.force_limit) * load + L::splat(0.0);
        ScaledCurve {
            meridian: &self.meridian,
            force_limit: L::select(
                L::splat(0.0).at_most(force_limit),
                force_limit,
                L::repeat(R::NAN),
            ),
            radius: self.radius,
        }
    }

    /// The set itself.
    #[inline]
    fn itself(&self) -> ScaledCurve<'_, R, C, R::Alone> {
        ScaledCurve {
            meridian: &self.meridian,
            force_limit: R::Alone::repeat(self.force_limit),
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
        if slide == R::ZERO {
            return self.force_limit * (rim * self.meridian.spin_torque);
        }
        let [force, torque] = self.meridian.point([slide, rim]);
        self.force_limit * (slide * force + rim * torque)
    }

    #[inline]
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        let pair = pair(&twist.velocity, twist.spin);
        let [[planar], [spin]] = [pair.planar, pair.normal].map(Numbers::to_array);
        let at = self.meridian.point([planar, spin * self.radius]);
        let push = self
            .itself()
            .surface_wrench(&pair, at.map(R::Alone::repeat));
        let [[x], [y], [torque]] = push.map(Numbers::to_array);
        -Wrench::new(x, y, torque)
    }

    #[inline]
    fn gauge(&self, wrench: &Wrench<R>) -> R {
        self.itself().gauge_of(wrench)
    }

    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        let set = self.itself();
        set.is_deep_inside(set.lengths(&pair(&wrench.force, wrench.torque)))
            || self.gauge(wrench) <= R::ONE + collar()
    }

    #[inline]
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        self.itself().motion_of(push)
    }

    #[inline]
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        self.itself().scale_to_surface(wrench)
    }

    #[inline]
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        self.itself().project_one(wrench, length)
    }

    fn project_each(&self, wrenches: &[Wrench<R>], length: R, projections: &mut [Projection<R>]) {
        self.project_groups(length, under_one_load(wrenches), projections);
    }
}
