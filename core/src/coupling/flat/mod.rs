//! Friction of flat patches with straight edges, exact to rounding.
//!
//! Force and torque of dry friction,
//!
//! ```text
//! force = −μ ∫p q/|q| dA,     torque = −μ ∫p (x × q)/|q| dA,     q = v + ω × x
//! ```
//!
//! over any [`Polygon`] under uniform or linear pressure have one closed form for all motions, rotation about a
//! corner and translation included. The Jacobian, minus the Hessian of the dissipated power, follows from the same
//! integrals. Nothing is sampled on the area, so that the cost grows with the number of edges alone.
//!
//! [`ShapePowerFriction`] is the same for friction γ|q|^α, α > −1.

mod anisotropic;
mod arcs;
mod bar;
mod cone;
mod ellipse;
mod ellipse_closed;
pub(crate) mod feet;
mod linear;
mod mesh;
mod motion;
pub(super) mod moving_edge;
mod pair_of_numbers;
mod panels;
mod points;
mod pole_far;
mod pole_near;
mod power;
mod round;
mod steep_layer;
mod sums;
mod uniform;

use crate::law::{LawError, validated_coefficient};
use crate::patch::outline::{Edge, Polygon, PressureField};
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};
#[doc(hidden)]
pub use motion::{Motion, SplitMotion};
use nalgebra::{Matrix3, Vector2};
pub use power::{PolygonPowerLaw, PowerLawPatch, ShapePowerFriction};

/// Friction of a patch per limit μN, about its centre of pressure; the torque per radius.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<R: Real> {
    pub force: Vector2<R>,
    pub torque: R,
}

/// Second derivatives of the dissipated power per limit μN, in velocity and rim speed.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hessian<R> {
    pub xx: R,
    pub xy: R,
    pub yy: R,
    pub xn: R,
    pub yn: R,
    pub nn: R,
}

/// Area over boundary and radius below which a patch is slender: a square has 0.35, a strip of 4:1 0.23.
const COMPACT: f64 = 0.25;

/// A point of contact, with lengths in units of the patch's radius about its centre.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLoad<R: Real> {
    pub place: Vector2<R>,
    /// Its share of the load.
    pub share: R,
}

/// A patch of any shape under dry friction: its dissipated power and the derivatives of that.
///
/// Implemented by the patches with straight edges of [`crate::patch::outline`], by meshes
/// ([`crate::patch::mesh`]), ellipses ([`crate::patch::ellipse`]), points ([`crate::patch::points`]) and bodies on
/// several of them ([`crate::patch::feet`]).
pub trait PatchShape<R: Real> {
    /// The centre of pressure, in the coordinates that twist and wrench refer to.
    fn centre(&self) -> Vector2<R>;

    /// Distance of the farthest point from the centre of pressure.
    fn radius(&self) -> R;

    /// Rounding of its dissipated power, of the power: grows with the aspect ratio of thin walls.
    #[doc(hidden)]
    #[inline]
    fn rounding(&self) -> R {
        R::EPSILON
    }

    /// Friction at a motion of the centre.
    #[doc(hidden)]
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R>;

    /// The same with the power's second derivatives.
    #[doc(hidden)]
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>);

    /// The point of contact nearest to a place, if there are points: the limit surface has facets.
    #[doc(hidden)]
    #[inline]
    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        let _ = place;
        None
    }
}

impl<R: Real, P: PatchShape<R> + ?Sized> PatchShape<R> for &P {
    fn centre(&self) -> Vector2<R> {
        (**self).centre()
    }
    fn radius(&self) -> R {
        (**self).radius()
    }
    fn rounding(&self) -> R {
        (**self).rounding()
    }
    #[inline]
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        (**self).reduced(motion)
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        (**self).reduced_with_hessian(motion)
    }
    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        (**self).nearest_point(place)
    }
}

impl<R: Real, S: AsRef<[Edge<R>]>, K: PressureField<R>> PatchShape<R> for Polygon<R, S, K> {
    fn centre(&self) -> Vector2<R> {
        Polygon::centre(self)
    }

    fn radius(&self) -> R {
        Polygon::radius(self)
    }

    /// Integrals along opposite edges cancel each other but for the width between them.
    fn rounding(&self) -> R {
        let mut boundary = R::ZERO;
        for edge in self.edges() {
            boundary += edge.length();
        }
        let slender = R::from_f64(COMPACT) * boundary / self.reduced_area();
        R::EPSILON * if slender > R::ONE { slender } else { R::ONE }
    }

    #[inline]
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        let (edges, pressure, area) = (self.edges(), self.pressure(), self.reduced_area());
        if !K::IS_LINEAR {
            return uniform::friction(edges, area, motion);
        }
        linear::friction(edges, pressure, area, motion)
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let (edges, pressure, area) = (self.edges(), self.pressure(), self.reduced_area());
        if !K::IS_LINEAR {
            return uniform::friction_and_hessian(edges, area, motion);
        }
        linear::friction_and_hessian(edges, pressure, area, motion)
    }
}

impl<R: Real> Reduced<R> {
    /// That of a patch at rest.
    pub(super) fn none() -> Self {
        Self {
            force: Vector2::new(R::ZERO, R::ZERO),
            torque: R::ZERO,
        }
    }

    #[inline(always)]
    fn scaled(&self, factor: R) -> Self {
        Self {
            force: self.force * factor,
            torque: self.torque * factor,
        }
    }
}

impl<R: Real> Hessian<R> {
    /// That of a patch at rest.
    pub(super) fn none() -> Self {
        Self {
            xx: R::ZERO,
            xy: R::ZERO,
            yy: R::ZERO,
            xn: R::ZERO,
            yn: R::ZERO,
            nn: R::ZERO,
        }
    }

    /// That of a spin of 1 about `centre`, given the part in the velocities.
    #[inline(always)]
    fn about(centre: &Vector2<R>, [xx, xy, yy]: [R; 3]) -> Self {
        // D″ times the twist is 0, and velocity/spin is −z × centre.
        let (x, y) = (centre.x, centre.y);
        let (xn, yn) = (xy * x - xx * y, yy * x - xy * y);
        Self {
            xx,
            xy,
            yy,
            xn,
            yn,
            nn: yn * x - xn * y,
        }
    }

    #[inline(always)]
    fn scaled(&self, factor: R) -> Self {
        Self {
            xx: self.xx * factor,
            xy: self.xy * factor,
            yy: self.yy * factor,
            xn: self.xn * factor,
            yn: self.yn * factor,
            nn: self.nn * factor,
        }
    }
}

/// Coulomb friction of a patch of any shape, with its coefficient.
///
/// *Units*: any consistent set; twist and wrench refer to the origin of the patch's coordinates.
/// *Domain*: load · μ · radius and spin · radius are zero or normal numbers. *Accuracy*, of μN and
/// μN R about the centre of pressure, for patches and walls up to 10 times as long as wide: 6e-15 (up to 4
/// times: 3e-15), under linear pressure 8e-15, bars and points 2e-14 (f32: 2.5e-6, linear pressure 4e-6); one that
/// is longer loses its aspect ratio. The torque of a patch that hardly turns has that error times its rim speed over
/// its speed.
/// *Cost*: an edge takes two roots, a logarithm and five quotients, under linear pressure 1.4 times as much; where that
/// is steep across a thin patch 6 times, and 10 times with the centre of rotation away from it.
/// *Special values*: zero at rest; NaN for infinite and NaN twists.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::twist::Twist;
/// let box_of_2_m = Polygon::new([[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])?;
/// let friction = ShapeFriction::new(box_of_2_m, 0.5)?;
/// let wrench = friction.wrench(10.0, &Twist::new(0.0, 0.0, 3.0)); // N; m/s, m/s, rad/s
/// let arm = (2.0_f64.sqrt() + 1.0_f64.asinh()) / 3.0; // the mean distance from the centre, in m
/// assert!((wrench.torque + 0.5 * 10.0 * arm).abs() < 2e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShapeFriction<R, P> {
    patch: P,
    coefficient: R,
}

impl<R: Real, P: PatchShape<R>> ShapeFriction<R, P> {
    /// *Domain*: 0 ≤ `coefficient` < ∞.
    pub fn new(patch: P, coefficient: R) -> Result<Self, LawError> {
        Ok(Self {
            patch,
            coefficient: validated_coefficient(coefficient)?,
        })
    }

    /// The patch.
    pub fn patch(&self) -> &P {
        &self.patch
    }

    /// The coefficient μ.
    pub fn coefficient(&self) -> R {
        self.coefficient
    }

    /// The wrench on the patch, against its twist.
    ///
    /// `load` is taken as it is, so that a negative load (a contact that pulls) is the caller's to
    /// exclude.
    #[inline]
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        match Motion::new(&self.patch, twist) {
            Ok((motion, _)) => self.at_origin(load, &self.patch.reduced(&motion)),
            Err(unmoved) => Wrench::new(unmoved, unmoved, unmoved),
        }
    }

    /// The wrench and ∂wrench/∂twist, symmetric and negative semidefinite.
    ///
    /// *Accuracy*: the Jacobian 4e-14 of its largest entry, with the radius as the unit of length
    /// (linear pressure, bars and points 5e-14; f32 1e-5), for patches up to 10 times as long as wide; one that is
    /// longer loses its aspect ratio, under linear pressure from 1e4 on the square of it.
    /// *Special values*: zero at rest.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::coupling::flat::ShapeFriction;
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Twist;
    /// let triangle = Polygon::new([[0.0_f64, 0.0], [0.3, 0.0], [0.0, 0.2]])?; // m
    /// let friction = ShapeFriction::new(triangle, 0.4)?;
    /// let twist = Twist::new(0.1, 0.2, 3.0); // m/s, m/s, rad/s
    /// let (wrench, jacobian) = friction.wrench_and_jacobian(10.0, &twist); // N
    /// assert_eq!(wrench, friction.wrench(10.0, &twist));
    /// // Dry friction does not change with the speed.
    /// assert!((jacobian * Vector3::from(twist)).amax() < 1e-13);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn wrench_and_jacobian(&self, load: R, twist: &Twist<R>) -> (Wrench<R>, WrenchJacobian<R>) {
        match Motion::new(&self.patch, twist) {
            Ok((motion, unit)) => {
                let (reduced, hessian) = self.patch.reduced_with_hessian(&motion);
                let hessian = hessian.scaled(unit);
                (
                    self.at_origin(load, &reduced),
                    self.jacobian_at_origin(load, &hessian),
                )
            }
            Err(unmoved) => {
                let wrench = Wrench::new(unmoved, unmoved, unmoved);
                (wrench, Matrix3::from_element(unmoved))
            }
        }
    }

    /// Moves a wrench from the centre of pressure to the origin of the patch's coordinates.
    #[inline(always)]
    fn at_origin(&self, load: R, reduced: &Reduced<R>) -> Wrench<R> {
        let limit = self.coefficient * load;
        let centre = self.patch.centre();
        let force = reduced.force * limit;
        let torque = limit * self.patch.radius() * reduced.torque;
        Wrench {
            force,
            torque: torque + (centre.x * force.y - centre.y * force.x),
        }
    }

    fn jacobian_at_origin(&self, load: R, hessian: &Hessian<R>) -> WrenchJacobian<R> {
        let limit = -(self.coefficient * load);
        let (centre, radius) = (self.patch.centre(), self.patch.radius());
        let [xx, xy, yy] = [hessian.xx, hessian.xy, hessian.yy].map(|part| limit * part);
        let [xn, yn] = [hessian.xn, hessian.yn].map(|part| limit * radius * part);
        let nn = limit * radius * radius * hessian.nn;
        // The centre moves with (−y, x) for each unit of spin about the origin.
        let (x, y) = (centre.x, centre.y);
        let (from_x, from_y) = (xy * x - xx * y, yy * x - xy * y);
        let turned = nn + R::TWO * (yn * x - xn * y) + (from_y * x - from_x * y);
        let (xn, yn) = (xn + from_x, yn + from_y);
        Matrix3::new(xx, xy, xn, xy, yy, yn, xn, yn, turned)
    }
}
