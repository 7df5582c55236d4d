//! The exact limit surface of a dry coupling.

use super::meridian::{Aim, Meridian, Normal, Place, Radial};
use super::polar::Polar;
use super::{Ellipsoid, FrictionSet, Projection, Region, collar};
use crate::coupling::{DryCoupling, ReducedWrench};
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
/// use tribos_core::coupling::table::Coulomb;
/// use tribos_core::limit_surface::{FrictionSet, LimitSurface};
/// use tribos_core::twist::Twist;
/// let puck = LimitSurface::new(Coulomb, 0.51_f64, 0.04)?; // N, m
/// assert!((puck.torque_limit() - 0.51 * 0.04 * 2.0 / 3.0).abs() < 1e-17);
/// // The ellipsoid with the same limits holds wrenches that the puck cannot carry.
/// let usual = puck.ellipsoid()?;
/// assert!((usual.torque_limit() - puck.torque_limit()).abs() < 1e-17);
/// let friction = puck.wrench(&Twist::new(0.1, 0.0, 3.0)); // m/s, rad/s
/// assert!(usual.gauge(&friction) < 0.94 && (puck.gauge(&friction) - 1.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitSurface<R, C> {
    meridian: Meridian<R, C>,
    force_limit: R,
    radius: R,
}

/// A wrench on the quarter plane.
struct Scaled<R> {
    polar: Polar<R>,
    /// Force and torque/radius.
    lengths: ReducedWrench<R>,
    /// The larger of the two.
    size: R,
    /// The two in units of the larger one.
    unit: ReducedWrench<R>,
}

impl<R: Real, C: DryCoupling<R>> LimitSurface<R, C> {
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
    pub fn ellipsoid(&self) -> Result<Ellipsoid<R>, Error> {
        Ellipsoid::new(self.force_limit, self.radius, self.spin_torque())
    }

    fn spin_torque(&self) -> R {
        let Self { meridian, .. } = self;
        let spinning = Normal {
            slide: R::ZERO,
            rim: R::ONE,
        };
        meridian.point(spinning).torque
    }

    /// True of wrenches so far inside that no search is needed, by the inscribed quadrangle; never of one whose
    /// gauge would be found on the surface or outside.
    #[inline]
    fn is_deep_inside(&self, wrench: &Wrench<R>) -> bool {
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
        let polar = Polar::new(&wrench.force, wrench.torque);
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

    /// The gauge of a wrench of which the ray is known.
    #[inline]
    fn gauge_of(&self, scaled: &Scaled<R>, radial: &Radial<R>) -> R {
        // Infinity over infinity is a direction lost, not a gauge.
        if scaled.is_infinite() {
            return R::INFINITY;
        }
        scaled.size / self.force_limit * radial.gauge
    }

    /// A normal in the quarter plane as a twist of length 1.
    #[inline]
    fn twist(&self, polar: &Polar<R>, normal: Normal<R>) -> Twist<R> {
        let length = normal.slide.hypot(normal.rim);
        polar.twist(normal.slide / length, normal.rim / length / self.radius)
    }

    #[inline]
    fn surface_wrench(&self, polar: &Polar<R>, at: ReducedWrench<R>) -> Wrench<R> {
        let torque = self.force_limit * self.radius * at.torque;
        polar.wrench(self.force_limit * at.force, torque)
    }

    /// The nearest point for a wrench outside.
    #[inline]
    fn pulled_back(&self, wrench: &Wrench<R>, scaled: &Scaled<R>, length: R) -> Projection<R> {
        let lever = length / self.radius;
        let far = ReducedWrench {
            force: scaled.lengths.force / self.force_limit,
            torque: scaled.lengths.torque / self.force_limit,
        };
        let is_plain = self.meridian.gauge_bound(far.force, far.torque).is_finite();
        let is_near = is_plain || self.gauge(wrench).is_finite();
        if !(is_near && length > R::ZERO && length.is_finite()) {
            return nowhere();
        }
        let Place { normal, at } = self.meridian.nearest(far, lever * lever);
        Projection {
            wrench: self.surface_wrench(&scaled.polar, at),
            region: Region::OnSurface {
                normal: self.twist(&scaled.polar, normal),
            },
        }
    }

    /// The projection onto {0}, the set without force limit.
    #[cold]
    fn pulled_to_zero(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let polar = Polar::new(&wrench.force, wrench.torque);
        if polar.planar == R::ZERO && polar.normal == R::ZERO {
            return inside(wrench);
        }
        // Every twist is a normal of a point; this one lies along the displacement.
        let lever = length / self.radius;
        let (slide, rim) = (polar.planar, polar.normal / length / lever);
        let norm = slide.hypot(rim);
        if !(norm.is_finite() && length > R::ZERO) {
            return nowhere();
        }
        let normal = Normal {
            slide: slide / norm,
            rim: rim / norm,
        };
        Projection {
            wrench: Wrench::ZERO,
            region: Region::OnSurface {
                normal: self.twist(&polar, normal),
            },
        }
    }
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

/// The answer to a wrench of the set.
#[inline]
fn inside<R: Real>(wrench: &Wrench<R>) -> Projection<R> {
    Projection {
        wrench: *wrench,
        region: Region::Inside,
    }
}

/// The answer to a wrench that has no nearest point.
#[cold]
fn nowhere<R: Real>() -> Projection<R> {
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

impl<R: Real, C: DryCoupling<R>> FrictionSet<R> for LimitSurface<R, C> {
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
        let polar = Polar::new(&twist.velocity, twist.spin);
        let (slide, rim) = (polar.planar, polar.normal * self.radius);
        let ReducedWrench { force, torque } = self.meridian.point(Normal { slide, rim });
        let against = ReducedWrench {
            force: -force,
            torque: -torque,
        };
        self.surface_wrench(&polar, against)
    }

    fn gauge(&self, wrench: &Wrench<R>) -> R {
        let scaled = self.scaled(wrench);
        if scaled.is_zero() {
            return R::ZERO;
        }
        self.gauge_of(&scaled, &self.meridian.radial(scaled.unit, Aim::Gauge))
    }

    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.is_deep_inside(wrench) || self.gauge(wrench) <= R::ONE + collar()
    }

    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        let scaled = self.scaled(push);
        if scaled.is_zero() {
            return Twist::ZERO;
        }
        let Radial { normal, gauge } = self.meridian.radial(scaled.unit, Aim::Normal);
        // A direction that is not a number has no normal, though the search ends somewhere.
        let Normal { slide, rim } = normal;
        let known = R::ONE + R::ZERO * gauge;
        self.twist(
            &scaled.polar,
            Normal {
                slide: slide * known,
                rim: rim * known,
            },
        )
    }

    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        let scaled = self.scaled(wrench);
        if scaled.is_zero() {
            return *wrench;
        }
        let Radial { gauge, .. } = self.meridian.radial(scaled.unit, Aim::Gauge);
        let at = ReducedWrench {
            force: scaled.unit.force / gauge,
            torque: scaled.unit.torque / gauge,
        };
        self.surface_wrench(&scaled.polar, at)
    }

    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        if self.force_limit == R::ZERO {
            return self.pulled_to_zero(wrench, length);
        }
        if self.is_deep_inside(wrench) {
            return inside(wrench);
        }
        let scaled = self.scaled(wrench);
        if scaled.is_zero() {
            return inside(wrench);
        }
        // A tangent may tell what a search would.
        let most = self.force_limit * (R::ONE + R::TWO * collar());
        if self.meridian.is_beyond_tangents(scaled.lengths, most) {
            return self.pulled_back(wrench, &scaled, length);
        }
        let size = scaled.size / self.force_limit;
        let radial = self.meridian.radial(scaled.unit, Aim::Side(size));
        let gauge = self.gauge_of(&scaled, &radial);
        if gauge < R::ONE - collar() {
            inside(wrench)
        } else if gauge <= R::ONE + collar() {
            let normal = self.twist_normal_to(wrench);
            Projection {
                wrench: *wrench,
                region: Region::OnSurface { normal },
            }
        } else {
            self.pulled_back(wrench, &scaled, length)
        }
    }
}
