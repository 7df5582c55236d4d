//! A rigid body on several feet, each on a surface that moves by itself: belts, treads, turntables, the wheels of a
//! robot that turns in place.
//!
//! A foot that moves with the twist t of the body slides over its surface with t − tᵢ. Its friction follows from its
//! dissipated power Dᵢ, so that that of all follows from one convex function of t,
//!
//! ```text
//! Φ(t) = Σ μᵢNᵢ D̂ᵢ(t − tᵢ),     wrench = −∂Φ/∂t,     Jacobian = −∂²Φ/∂t²
//! ```
//!
//! A patch that lies on several surfaces is cut along their borders into feet
//! ([`crate::patch::outline::Polygon::within`]). Wheels and treads that a body drives are surfaces too: under a tread
//! that runs backwards with the speed c the ground moves with −c relative to it, which is tᵢ = (c, 0, 0) for a foot on
//! the body. How the feet share the load is the caller's to know.
//!
//! Feet of one surface together hold what [`crate::patch::feet::CompoundPatch`] says.

mod group;
mod search;
mod steady;
mod step;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;

pub use steady::{SteadyMotion, SteadyState};
pub use step::FloorStep;

use crate::coupling::flat::{PatchShape, ShapeFriction};
use crate::law::{LawError, validated_not_negative};
use crate::limit_surface::quadratic::outer;
use crate::patch::PatchError;
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};
use group::FromReference;
use nalgebra::{Matrix3, Vector2, Vector3};

/// A foot: a patch in the coordinates of the body, the friction that it carries, and how its surface moves.
///
/// ```
/// use tribos_core::floor::Foot;
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::twist::Twist;
/// // A blade on a turntable of 2 rad/s, whose axis stands in the origin.
/// let blade = Bar::new([0.1_f64, 0.0], [0.3, 0.0])?; // m
/// let foot = Foot { patch: blade, limit: 4.0, surface: Twist::new(0.0, 0.0, 2.0) }; // μN in N; rad/s
/// assert!(foot.limit > 0.0);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Foot<R: Real, P> {
    /// The patch.
    pub patch: P,
    /// Its coefficient times its load. *Units*: force.
    pub limit: R,
    /// Motion of the surface under it, about the origin of the body's coordinates.
    pub surface: Twist<R>,
}

/// A body on feet whose surfaces move.
///
/// Feet of different kinds have a common type as `&dyn PatchShape`.
///
/// *Units*: those of the feet. *Accuracy*: that of [`crate::coupling::flat::ShapeFriction`] for each foot.
/// *Cost*: that of all feet.
///
/// ```
/// use tribos_core::floor::{Feet, Foot};
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::patch::piece::HalfPlane;
/// use tribos_core::twist::Twist;
/// // A box of 0.3 by 0.2 m and μN = 8 N whose halves lie on two belts that run against each other.
/// let parcel = Polygon::new([[-0.15_f64, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]])?;
/// let seam = HalfPlane::new([0.0, 0.0], [1.0, 0.0])?;
/// let halves = [(seam, 0.5), (seam.other_side(), -0.5)].map(|(side, speed)| {
///     let piece = parcel.within(&side, [Default::default(); 8]).unwrap().unwrap();
///     Foot { patch: piece.patch, limit: 8.0 * piece.share, surface: Twist::new(speed, 0.0, 0.0) }
/// });
/// // Held at rest it is turned by μN b/4.
/// let held = Feet::new(&halves)?.wrench(&Twist::ZERO);
/// assert!((held.torque + 8.0 * 0.2 / 4.0).abs() < 1e-15 && held.force.amax() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feet<'a, R: Real, P> {
    feet: &'a [Foot<R, P>],
    /// Sum of all limits.
    limit: R,
    /// Mean of the feet's centres by their limits.
    centre: Vector2<R>,
    /// Distance from there within which all feet lie.
    radius: R,
}

impl<'a, R: Real, P: PatchShape<R>> Feet<'a, R, P> {
    /// *Domain*: limits ≥ 0 with a finite, positive sum; finite surfaces and distances.
    pub fn new(feet: &'a [Foot<R, P>]) -> Result<Self, crate::Error> {
        let mut limit = R::ZERO;
        for (index, foot) in feet.iter().enumerate() {
            validated_not_negative("friction limit of a foot", foot.limit)?;
            limit += foot.limit;
            let Twist { velocity, spin } = foot.surface;
            if !(velocity.x + velocity.y + spin).is_finite() {
                let given = (velocity.x + velocity.y + spin).to_f64();
                let parameter = "motion of a surface";
                return Err(LawError::NotFinite { parameter, given }.into());
            }
            if !limit.is_finite() {
                let given = foot.limit.to_f64();
                return Err(PatchError::NodeWeight { index, given }.into());
            }
        }
        if limit == R::ZERO {
            return Err(PatchError::Unloaded.into());
        }
        let mut centre = Vector2::new(R::ZERO, R::ZERO);
        for foot in loaded(feet) {
            centre += foot.patch.centre() * (foot.limit / limit);
        }
        let mut radius = R::ZERO;
        for foot in loaded(feet) {
            let from = foot.patch.centre() - centre;
            let reach = from.x.hypot(from.y) + foot.patch.radius();
            if reach > radius || reach.is_nan() {
                radius = reach;
            }
        }
        if !(radius + centre.x + centre.y).is_finite() {
            let given = radius.to_f64();
            return Err(PatchError::Radius { given }.into());
        }
        Ok(Self {
            feet,
            limit,
            centre,
            radius,
        })
    }

    /// The feet.
    pub fn feet(&self) -> &'a [Foot<R, P>] {
        self.feet
    }

    /// The wrench on a body that moves with `twist`, about the origin of its coordinates.
    ///
    /// *Special values*: a foot that rests on its surface gives nothing; NaN for infinite and NaN twists.
    pub fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        let mut sum = Wrench::ZERO;
        for foot in loaded(self.feet) {
            if let Ok(friction) = ShapeFriction::new(&foot.patch, foot.limit) {
                sum += friction.wrench(R::ONE, &(*twist - foot.surface));
            }
        }
        sum
    }

    /// The wrench and ∂wrench/∂twist, symmetric and negative semidefinite.
    ///
    /// ```
    /// use tribos_core::floor::{Feet, Foot};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Twist;
    /// let sole = Polygon::new([[0.0_f64, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]])?; // m
    /// let feet = [Foot { patch: sole, limit: 9.0, surface: Twist::new(0.3, 0.0, 0.0) }]; // N; m/s
    /// let (wrench, jacobian) = Feet::new(&feet)?.wrench_and_jacobian(&Twist::new(0.1, 0.2, 0.5));
    /// assert!(wrench.force.x > 0.0 && jacobian == jacobian.transpose());
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn wrench_and_jacobian(&self, twist: &Twist<R>) -> (Wrench<R>, WrenchJacobian<R>) {
        let power = self.power(&Vector2::new(R::ZERO, R::ZERO), twist);
        let wrench = -power.gradient;
        (Wrench::new(wrench.x, wrench.y, wrench.z), -power.hessian)
    }

    /// What the feet dissipate at a twist about a reference point, with its derivatives.
    fn power(&self, at: &Vector2<R>, twist: &Twist<R>) -> FeetPower<R> {
        let zero = Matrix3::repeat(R::ZERO);
        let mut sum = FeetPower {
            value: R::ZERO,
            gradient: Vector3::repeat(R::ZERO),
            hessian: zero,
            bound: zero,
        };
        for foot in loaded(self.feet) {
            let patch = FromReference {
                patch: &foot.patch,
                at: *at,
            };
            if let Ok(friction) = ShapeFriction::new(patch, foot.limit) {
                let sliding = *twist - moved(&foot.surface, at);
                let (wrench, jacobian) = friction.wrench_and_jacobian(R::ONE, &sliding);
                let (power, pull) = (-wrench.power(&sliding), -Vector3::from(wrench));
                sum.value += power;
                sum.gradient += pull;
                sum.hessian -= jacobian;
                if power > R::ZERO {
                    sum.bound += outer(&pull) * (R::ONE / power);
                }
            }
        }
        sum.bound += sum.hessian;
        sum
    }
}

/// Dissipated power of several feet.
struct FeetPower<R: Real> {
    value: R,
    gradient: Vector3<R>,
    hessian: Matrix3<R>,
    /// The curvature that each foot's power would have as a root of a square: its own and that along its motion,
    /// which bounds how far the power can rise.
    bound: Matrix3<R>,
}

/// The feet that carry something.
fn loaded<R: Real, P>(feet: &[Foot<R, P>]) -> impl Iterator<Item = &Foot<R, P>> + Clone {
    feet.iter().filter(|foot| foot.limit > R::ZERO)
}

/// A twist about the origin, about another point.
fn moved<R: Real>(twist: &Twist<R>, to: &Vector2<R>) -> Twist<R> {
    let Twist { velocity, spin } = *twist;
    Twist::new(velocity.x - spin * to.y, velocity.y + spin * to.x, spin)
}

/// A twist about a point, about the origin.
fn moved_back<R: Real>(twist: &Twist<R>, from: &Vector2<R>) -> Twist<R> {
    moved(twist, &-*from)
}
