//! The limit surface: all wrenches that the dry friction of a patch can carry, as a convex set.
//!
//! A patch at rest carries any wrench of a closed convex set; a sliding patch resists with the
//! wrench of the set's surface that dissipates most (Goyal, Ruina, Papadopoulos, Wear 143 (1991)
//! 307). The set's support function is therefore the dissipated power D(twist), and the outward
//! normal of the surface is a twist:
//!
//! ```text
//! set = { x : x·twist ≤ D(twist) for every twist },      friction = −∂D/∂twist
//! ```
//!
//! [`RoundLimitSurface`] is this set for any [`crate::coupling::DryReducedFriction`] and [`ShapeLimitSurface`] for
//! polygons, bars, meshes, points and bodies on several of them; [`LimitEllipsoid`] is the usual approximation. All are a [`FrictionSet`].
//! [`ScaledSet`] makes any of them stronger or weaker.
//! [`UnknownPressureSet`] is the set where only corners, load and centre of pressure are known.
//!
//! *Sign*: friction opposes the motion. A *push* is the wrench that moves the patch against its
//! friction, and its motion is the outward normal. The set is symmetric: what it carries as
//! friction it carries as push.
//!
//! ```
//! use tribos_core::coupling::coulomb::CoulombDisk;
//! use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
//! use tribos_core::twist::{Twist, Wrench};
//!
//! let puck = RoundLimitSurface::new(CoulombDisk, 0.51_f64, 0.04)?; // μN in N, radius in m
//! // A motion, and the friction that it meets.
//! let friction = puck.wrench(&Twist::new(0.1, 0.0, 2.0));
//! assert!((puck.gauge(&friction) - 1.0).abs() < 1e-14);
//! // A push, and the motion that it causes: friction balances the push.
//! let motion = puck.twist_normal_to(&-friction);
//! assert!((motion.velocity.x / motion.spin - 0.1 / 2.0).abs() < 1e-13);
//! // More than friction can carry, brought back to the surface.
//! let carried = puck.project(&Wrench::new(1.0, 0.0, 0.02));
//! assert!(puck.contains(&carried.wrench));
//! # Ok::<(), tribos_core::Error>(())
//! ```
//!
//! # Which projection where
//!
//! The mathematics differs with the set, and so do speed and accuracy. Metrics: *masses* is the energy of what an
//! impulse changes, with a length for the arm; times are of f64 on one x86-64 core unless stated.
//!
//! | set | metric | accuracy | time | where |
//! |---|---|---|---|---|
//! | round patch, exact | any length | 1e-15 of the limits; 5 ε of the surface | 7 ns inside, 145 ns; 2 and 38 to 41 ns in a batch (f32: 1.4 and 13) | [`RoundLimitSurface`] |
//! | ellipsoid | any length | rounding | 4 ns inside, 142 to 158 ns; 2.5 and 44 to 48 ns in a batch; next to the surface up to 200 and 100 ns where the length is three radii | [`LimitEllipsoid`] |
//! | polygons, bars, meshes, points, several bodies | any length | 1e-13 of the limits; for points 1e-8 of the wrench, in the set to 16 ε | about 5 wrenches with Jacobian | [`ShapeLimitSurface`] |
//! | discs, one for each mode, under a held bound | masses, which are equal along both tangents | 4 ulp of the length | 14 to 21 ns with the rest of a contact, four at a time | [`crate::contact::IndependentFriction`]; in lanes, to its bits, `cd/vectors` of `tribos-contacts` |
//! | disc of rolling; sliding with torsion in a round set | masses | that of the set | that of the set | [`crate::contact::CoupledFriction`] |
//! | discs of points that share a load | Euclidean | rounding | none beyond that of the points' balance | `planar/point_contacts` |
//! | curve fitted to an area, f32 | masses | 1e-6 to 3e-2 of the limits by steps and slenderness | 23 to 38 ns in four lanes, 88 to 150 ns alone | [`crate::manifold_friction::project_friction`] |
//! | cone of all modes, whose bound is the projected one | that of the problem's scaled unknowns | rounding; orthogonal to 1e-14 | – | `problem/solve/cone` of `tribos-contacts` |

mod any_pressure;
mod batch;
mod central_path;
mod curve_approximation;
mod curve_point;
mod ellipsoid;
mod load_sharing;
pub(crate) mod meridian;
mod nonsmooth_search;
mod polar;
pub(crate) mod quadratic;
mod ratio_search;
mod round;
mod scaled;
pub(crate) mod search;
mod searches;
mod shape;
mod torque_range;

pub use any_pressure::{TorqueLimits, UnknownPressureSet};
pub use ellipsoid::LimitEllipsoid;
pub use round::RoundLimitSurface;
pub use scaled::ScaledSet;
pub use shape::ShapeLimitSurface;

use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Half width of the surface in units of the type's rounding error: a wrench with
/// |gauge − 1| ≤ 64 [`Real::EPSILON`] counts as on the surface.
///
/// It covers the rounding of a surface point and of its gauge, for couplings that are themselves
/// right to about 30 units, so that no projection moves a projected wrench.
#[doc(hidden)]
pub const COLLAR_ULPS: f64 = 64.0;

/// A closed convex set of wrenches with a smooth surface that contains −x with every wrench x.
///
/// The surface of points has flat facets, at whose rims the normal turns quickly.
/// The set of a round patch is a solid of revolution about the axis of torques; that of a
/// [`ShapeLimitSurface`] need not be.
///
/// All methods are total. NaN in gives NaN out. A wrench is infinite here if its force magnitude,
/// its torque/radius or the ratio of these to the force limit overflows.
pub trait FrictionSet<R: Real> {
    /// The largest force, μN.
    fn force_limit(&self) -> R;

    /// The radius R of the patch, the lever that makes a speed of a spin.
    fn radius(&self) -> R;

    /// Support function: the largest wrench·twist of the set, which is the dissipated power.
    ///
    /// *Units*: power. *Special values*: 0 at rest.
    fn support(&self, twist: &Twist<R>) -> R;

    /// Friction on the patch that moves with `twist`: the surface point whose outward normal is
    /// −`twist`.
    ///
    /// *Special values*: zero at rest; NaN for an infinite twist.
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R>;

    /// The smallest λ ≥ 0 with `wrench`/λ in the set: below 1 inside, 1 on the surface.
    ///
    /// *Special values*: 0 for no wrench, infinite for an infinite one; with a force limit of zero
    /// infinite for every wrench but zero.
    fn gauge(&self, wrench: &Wrench<R>) -> R;

    /// The motion that `push` causes: outward normal where the ray of `push` meets the surface.
    ///
    /// Friction under it is −`push`/gauge. *Units*: length/time and 1/time, scaled such that
    /// |velocity|² + (spin·radius)² = 1. *Special values*: zero for no wrench, NaN for an infinite
    /// one.
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R>;

    /// The wrench along the same ray on the surface, `wrench`/gauge.
    ///
    /// *Special values*: the zero wrench has no ray and stays; NaN for an infinite one.
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R>;

    /// The nearest wrench of the set by the distance √(|Δforce|² + (Δtorque/`length`)²).
    ///
    /// The displacement is (velocity, `length`²·spin) of the normal times a factor ≥ 0. The result lies in
    /// the set to rounding, wherever the search for it ends.
    /// *Domain*: 0 < `length` < ∞, NaN otherwise for wrenches outside. *Special values*: NaN for
    /// an infinite wrench.
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R>;

    /// [`FrictionSet::project_with_length`] with the radius as length.
    #[inline]
    fn project(&self, wrench: &Wrench<R>) -> Projection<R> {
        self.project_with_length(wrench, self.radius())
    }

    /// [`FrictionSet::project_with_length`] of many wrenches, to the same bits.
    #[doc(hidden)]
    fn project_each(&self, wrenches: &[Wrench<R>], length: R, projections: &mut [Projection<R>]) {
        for (wrench, projection) in wrenches.iter().zip(projections) {
            *projection = self.project_with_length(wrench, length);
        }
    }

    /// The motion that meets the friction `wrench`, scaled radially to the surface:
    /// −[`FrictionSet::twist_normal_to`].
    #[inline]
    fn twist_resisted_by(&self, wrench: &Wrench<R>) -> Twist<R> {
        self.twist_normal_to(&-*wrench)
    }

    /// True if friction can carry `wrench`: gauge ≤ 1, and the collar of [`COLLAR_ULPS`].
    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.gauge(wrench) <= R::ONE + collar()
    }
}

/// The half width of the surface.
#[inline]
fn collar<R: Real>() -> R {
    R::from_f64(COLLAR_ULPS) * R::EPSILON
}

/// The wrench that a projection of `wanted` carries, made so short that it does not oppose the displacement
/// from it to `wanted`, by the distance of [`FrictionSet::project_with_length`]: friction then gives no energy.
///
/// A nearest wrench is changed by rounding at most, because a convex set contains 0. No shorter one leaves the
/// set, wherever a search ended.
#[inline]
pub(crate) fn without_gain<R: Real>(
    carried: &Wrench<R>,
    wanted: &Wrench<R>,
    length: R,
) -> Wrench<R> {
    let rest = *wanted - *carried;
    let planar = carried.force.x * rest.force.x + carried.force.y * rest.force.y;
    let gain = planar * (length * length) + carried.torque * rest.torque;
    if gain > R::ZERO || carried == wanted {
        return *carried;
    }
    shortened(carried, wanted, length)
}

/// The same where the displacement opposes the wrench, vanishes, or has no square.
#[cold]
fn shortened<R: Real>(carried: &Wrench<R>, wanted: &Wrench<R>, length: R) -> Wrench<R> {
    let parts = |wrench: &Wrench<R>| [wrench.force.x, wrench.force.y, wrench.torque / length];
    let (own, given) = (parts(carried), parts(wanted));
    // In units of its own largest part no product leaves the range of numbers.
    let size = own.iter().fold(
        R::ZERO,
        |size, part| {
            if part.abs() > size { part.abs() } else { size }
        },
    );
    let along = |other: [R; 3]| {
        let products = own.iter().zip(other).map(|(a, b)| *a / size * (b / size));
        products.fold(R::ZERO, |sum, product| sum + product)
    };
    let reached = along(given) / along(own);
    if reached >= R::ONE || reached.is_nan() {
        *carried
    } else if reached > R::ZERO {
        *carried * reached
    } else {
        *carried * R::ZERO
    }
}

/// A wrench of the set nearest to a given one.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, Projection, Region};
/// use tribos_core::twist::Wrench;
/// let puck = RoundLimitSurface::new(CoulombDisk, 0.5_f64, 0.04)?; // N, m
/// let pull = |x| Wrench::new(x, 0.0, 0.0);
/// // A pull that friction balances, and one that is too strong.
/// let sticks = Projection { wrench: pull(0.3), region: Region::Inside };
/// assert_eq!(puck.project(&pull(0.3)), sticks);
/// assert!((puck.project(&pull(1.0)).wrench.force.x - 0.5).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Projection<R: Real> {
    /// The wrench. Bit for bit the given one if that was inside or on the surface.
    pub wrench: Wrench<R>,
    /// Where it lies.
    pub region: Region<R>,
}

/// Where a projected wrench lies.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, Region};
/// use tribos_core::twist::Wrench;
/// let puck = RoundLimitSurface::new(CoulombDisk, 0.5_f64, 0.04)?; // N, m
/// let push = Wrench::new(0.6, 0.8, 0.0);
/// // Pushed through its centre it slides along the push and does not turn.
/// let Region::OnSurface { normal } = puck.project(&push).region else {
///     panic!("1 N is more than 0.5 N")
/// };
/// assert!((normal.velocity - push.force).amax() < 1e-14 && normal.spin == 0.0);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Region<R: Real> {
    /// Gauge below 1: the contact sticks.
    Inside,
    /// Gauge 1: the contact slides.
    OnSurface {
        /// Outward normal, scaled as in [`FrictionSet::twist_normal_to`]. NaN with the wrench.
        normal: Twist<R>,
    },
}
