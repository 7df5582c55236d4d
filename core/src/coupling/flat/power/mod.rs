//! Friction γ|v|^α of flat patches with straight edges, exact to rounding for every α > −1.
//!
//! ```text
//! force = −γ ∫p |q|^(α−1) q dA,     torque = −γ ∫p |q|^(α−1) (x × q) dA,     q = v + ω × x
//! ```
//!
//! Force and torque are homogeneous functions about the centre of rotation, so that the divergence
//! theorem makes line integrals of them as it does of dry friction. One of these integrals along an edge
//! has no elementary form; it is a function of one variable for each exponent, which [`PolygonPowerLaw`]
//! prepares.

mod far;
mod fit;
mod near;
mod prepared;

pub use prepared::PolygonPowerLaw;

use super::pole_far::TranslatingMotion;
use super::{Hessian, Motion, PatchShape, Reduced, ShapeFriction, SplitMotion};
use crate::law::LawError;
use crate::patch::outline::{Edge, Polygon, PressureField};
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};
use nalgebra::{Matrix3, Vector2};

/// A patch of any shape under friction |v|^α.
///
/// Implemented by [`Polygon`] under uniform and under linear pressure.
pub trait PowerLawPatch<R: Real>: PatchShape<R> {
    /// Friction at a motion of the centre, whose rim speed or velocity counts as 1.
    #[doc(hidden)]
    fn of_power(&self, power: &PolygonPowerLaw<R>, motion: &SplitMotion<R>) -> Reduced<R>;

    /// The same with minus its derivatives.
    #[doc(hidden)]
    fn of_power_with_hessian(
        &self,
        power: &PolygonPowerLaw<R>,
        motion: &SplitMotion<R>,
    ) -> (Reduced<R>, Hessian<R>);
}

impl<R: Real, P: PowerLawPatch<R> + ?Sized> PowerLawPatch<R> for &P {
    #[inline]
    fn of_power(&self, power: &PolygonPowerLaw<R>, motion: &SplitMotion<R>) -> Reduced<R> {
        (**self).of_power(power, motion)
    }
    fn of_power_with_hessian(
        &self,
        power: &PolygonPowerLaw<R>,
        motion: &SplitMotion<R>,
    ) -> (Reduced<R>, Hessian<R>) {
        (**self).of_power_with_hessian(power, motion)
    }
}

impl<R: Real, S: AsRef<[Edge<R>]>, K: PressureField<R>> PowerLawPatch<R> for Polygon<R, S, K> {
    #[inline]
    fn of_power(&self, power: &PolygonPowerLaw<R>, motion: &SplitMotion<R>) -> Reduced<R> {
        let patch = (self.edges(), self.pressure());
        let whole = match motion {
            SplitMotion::Turns { centre, spin } => {
                near::friction(power, patch, centre, R::ONE.copysign(*spin))
            }
            SplitMotion::Slides {
                direction, turn, ..
            } => {
                let spin = *turn;
                let slide = TranslatingMotion { direction, spin };
                far::friction(&slide, power, patch, self.longest_half())
            }
        };
        whole.scaled(R::ONE / self.reduced_area())
    }

    fn of_power_with_hessian(
        &self,
        power: &PolygonPowerLaw<R>,
        motion: &SplitMotion<R>,
    ) -> (Reduced<R>, Hessian<R>) {
        let patch = (self.edges(), self.pressure());
        let (whole, hessian) = match motion {
            SplitMotion::Turns { centre, spin } => {
                near::friction_and_hessian(power, patch, centre, R::ONE.copysign(*spin))
            }
            SplitMotion::Slides {
                direction, turn, ..
            } => {
                let spin = *turn;
                let slide = TranslatingMotion { direction, spin };
                far::friction_and_hessian(&slide, power, patch, self.longest_half())
            }
        };
        let share = R::ONE / self.reduced_area();
        (whole.scaled(share), hessian.scaled(share))
    }
}

/// Friction γ|v|^α of a patch with straight edges, with its coefficient.
///
/// *Units*: any consistent set, γ in (time/length)^α; twist and wrench refer to the origin of the
/// patch's coordinates. *Domain*: load · γ · radius, spin · radius and the α-th power of the speeds are
/// zero or normal numbers.
///
/// *Accuracy*, of γN V^α and γN V^α R about the centre of pressure, V being the speed of the centre plus
/// the rim speed, for patches up to 10 times as long as wide: 5e-14 for −1/2 ≤ α ≤ 3, under linear pressure
/// 1e-13; 5e-13 for α down to −7/8 and up to 10 (f32, 0 ≤ α ≤ 3: 4e-6). The torque of a patch that hardly turns keeps that accuracy relative
/// to itself.
///
/// *Cost*: an edge takes two roots, three exponentials and logarithms, and two polynomials of 24
/// terms; where the centre of rotation is farther away than 2 radii, 4 to 16 points, each with
/// three polynomials of 28, 16 and 16 terms. An exponent within 1/4 of an even number takes two more
/// exponentials an edge.
///
/// *Special values*: zero at rest, also for α ≤ 0, where friction has no limit; NaN for infinite
/// and NaN twists.
///
/// ```
/// use tribos_core::coupling::flat::{PolygonPowerLaw, ShapePowerFriction};
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::twist::Twist;
/// let box_of_2_m = Polygon::new([[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])?;
/// let oiled = ShapePowerFriction::new(box_of_2_m, 0.5, PolygonPowerLaw::new(1.0)?)?; // 0.5 s/m
/// let wrench = oiled.wrench(10.0, &Twist::new(0.2, 0.0, 3.0)); // N; m/s, m/s, rad/s
/// // Viscous friction: γN v, and γN ω times the mean square of the distance, 2/3 m².
/// assert!((wrench.force.x + 0.5 * 10.0 * 0.2).abs() < 1e-14);
/// assert!((wrench.torque + 0.5 * 10.0 * 3.0 * 2.0 / 3.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShapePowerFriction<R, P> {
    flat: ShapeFriction<R, P>,
    power: PolygonPowerLaw<R>,
}

impl<R: Real, P: PowerLawPatch<R>> ShapePowerFriction<R, P> {
    /// *Domain*: 0 ≤ `coefficient` < ∞.
    pub fn new(patch: P, coefficient: R, power: PolygonPowerLaw<R>) -> Result<Self, LawError> {
        Ok(Self {
            flat: ShapeFriction::new(patch, coefficient)?,
            power,
        })
    }

    /// The patch.
    pub fn patch(&self) -> &P {
        self.flat.patch()
    }

    /// The coefficient γ.
    pub fn coefficient(&self) -> R {
        self.flat.coefficient()
    }

    /// The prepared law.
    pub fn power(&self) -> &PolygonPowerLaw<R> {
        &self.power
    }

    /// The wrench on the patch, against its twist.
    ///
    /// `load` is taken as it is, so that a negative load (a contact that pulls) is the caller's to
    /// exclude.
    #[inline]
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        match Motion::new(self.patch(), twist) {
            Ok((motion, unit)) => {
                let motion = motion.split_for_power();
                let reduced = self.patch().of_power(&self.power, &motion);
                let pace = unit_speed_to(&motion, unit, self.power.alpha);
                self.flat.at_origin(load, &reduced.scaled(pace))
            }
            Err(unmoved) => Wrench::new(unmoved, unmoved, unmoved),
        }
    }

    /// The wrench and ∂wrench/∂twist, which is symmetric.
    ///
    /// It is negative semidefinite for α ≥ 0. For α < 0 friction weakens with the speed, and the
    /// Jacobian times the twist, α times the wrench, shows along the twist: the matrix is indefinite.
    ///
    /// *Accuracy*: the Jacobian 1e-13 of its largest entry, with the radius as the unit of length, for
    /// −1/2 ≤ α ≤ 3, under linear pressure 2.5e-13; 1e-12 for α down to −7/8 and up to 10 (f32, 0 ≤ α ≤ 3:
    /// 8e-6). For α < 0 the Jacobian changes with the α-th power of the distance between the centre of
    /// rotation and an edge. It is then that of a centre a rounding error ε away, which makes a difference
    /// of about ε^(1+α) where the centre lies on an edge.
    /// *Special values*: at rest constant for α = 1, otherwise zero, although it has no limit for α < 1.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::coupling::flat::{PolygonPowerLaw, ShapePowerFriction};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Twist;
    /// let triangle = Polygon::new([[0.0_f64, 0.0], [0.3, 0.0], [0.0, 0.2]])?; // m
    /// let friction = ShapePowerFriction::new(triangle, 0.4, PolygonPowerLaw::new(0.5)?)?; // (s/m)^0.5
    /// let twist = Twist::new(0.1, 0.2, 3.0); // m/s, m/s, rad/s
    /// let (wrench, jacobian) = friction.wrench_and_jacobian(10.0, &twist); // N
    /// assert_eq!(wrench, friction.wrench(10.0, &twist));
    /// // A motion that is faster by 1 % meets friction that is larger by 0.5 %.
    /// let rate = jacobian * Vector3::from(twist) - Vector3::from(wrench) * 0.5;
    /// assert!(rate.amax() < 1e-13);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn wrench_and_jacobian(&self, load: R, twist: &Twist<R>) -> (Wrench<R>, WrenchJacobian<R>) {
        let unmoved = match Motion::new(self.patch(), twist) {
            Ok((motion, unit)) => {
                let motion = motion.split_for_power();
                let (reduced, hessian) = self.patch().of_power_with_hessian(&self.power, &motion);
                let alpha = self.power.alpha;
                let pace = unit_speed_to(&motion, unit, alpha);
                let rate = unit_speed_to(&motion, unit, alpha - R::ONE);
                return (
                    self.flat.at_origin(load, &reduced.scaled(pace)),
                    self.flat.jacobian_at_origin(load, &hessian.scaled(rate)),
                );
            }
            Err(unmoved) => unmoved,
        };
        let wrench = Wrench::new(unmoved, unmoved, unmoved);
        if unmoved == R::ZERO && self.power.alpha == R::ONE {
            let turn = SplitMotion::Turns {
                centre: Vector2::new(R::ZERO, R::ZERO),
                spin: R::ONE,
            };
            let (_, hessian) = self.patch().of_power_with_hessian(&self.power, &turn);
            return (wrench, self.flat.jacobian_at_origin(load, &hessian));
        }
        (wrench, Matrix3::from_element(unmoved))
    }
}

/// A power of the speed that a reduced motion has as its unit.
#[inline(always)]
fn unit_speed_to<R: Real>(motion: &SplitMotion<R>, unit: R, exponent: R) -> R {
    let speed = match motion {
        SplitMotion::Turns { spin, .. } => spin.abs(),
        SplitMotion::Slides { speed, .. } => *speed,
    };
    if unit == R::ONE {
        speed.pow(exponent)
    } else {
        speed.pow(exponent) * unit.pow(-exponent)
    }
}
