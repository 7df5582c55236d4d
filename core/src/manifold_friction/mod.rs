//! Friction of a contact manifold in a game engine: one projection in place of two clamps.
//!
//! Engines that keep one friction centre a manifold have a tangential impulse p, limited by F = μΣλ, and an
//! angular impulse t about the normal, limited by T = F r̄ with r̄ the mean distance of the contact from the
//! centre. Two clamps, one after the other, give a body that slides and spins both limits at once; friction of
//! an area has one budget for both: spin turns the friction of every element sideways, where it cancels. A box
//! thrown at 1 m/s and spun at 50 rad/s travels 2.7 times as far as two clamps let it.
//!
//! [`project_friction`] replaces both clamps. From the impulses that would stop the contact it gives the
//! nearest ones that friction can carry, in the metric k |dp|² + kt dt² of the inverse effective masses, which
//! makes it the solution of the contact's friction alone. The set is (|p|/F, |t|/T) within a limit
//! curve of the outline.
//!
//! ```
//! use tribos_core::manifold_friction::{
//!     ManifoldArea, FrictionLimits, FrictionImpulse, InverseEffectiveMasses, project_friction,
//! };
//! // When the manifold is made: its corners in the frame of the two tangents, in m.
//! let sole = ManifoldArea::of_corners(&[[-0.1, -0.025], [0.1, -0.025], [0.1, 0.025], [-0.1, 0.025_f32]]);
//! // In every iteration: the last impulses less relative velocity times effective mass.
//! let candidate = FrictionImpulse { tangential: [0.4, 0.0], angular: 0.01 }; // N s, N m s
//! let budget = FrictionLimits { impulse: 0.05, torsion_radius: sole.torsion_radius, dynamic_over_static: 1.0 }; // N s, m
//! let inverse = InverseEffectiveMasses { tangential: 2.0, angular: 500.0 }; // 1/kg, 1/(kg m²)
//! let carried = project_friction(&candidate, &budget, &inverse, &sole.outline);
//! assert!(carried.tangential[0] > 0.0 && carried.tangential[0] < 0.05);
//! assert!(carried.angular > 0.0 && carried.angular < 0.05 * sole.torsion_radius);
//! ```
//!
//! *Lanes*: the same function computes four or eight manifolds side by side, [`Lanes`]; every lane has the bits
//! of the scalar. Only + − × ÷ and square roots are used. The header `tribos_manifold_friction.h` is the same
//! function, to the bit, in C and C++.
//!
//! *What to keep of the engine*: warm starts (the candidate starts from the accumulated impulses, so no clamp
//! of its own is needed when the load falls); the order of its rows inside of the set. *Friction centre*: the
//! mean of the contact points, or, for sideways forces of bodies that tilt, their mean weighted by the last
//! normal impulses.

mod anisotropy;
mod area;
mod outline;
mod project;
mod rolling;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;

pub use crate::lanes::Lanes;
pub use anisotropy::AnisotropicFriction;
pub use area::ManifoldArea;
pub use outline::{Curve, DirectionalLimitCurve, IsotropicLimitCurve, LimitCurve};
pub use rolling::project_rolling;

/// Where denominators that may be zero end.
const TINY: f32 = 1e-30;

/// Impulses of friction of one manifold, or of several side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrictionImpulse<T> {
    /// Tangential impulse at the friction centre, along both tangents, in N s.
    pub tangential: [T; 2],
    /// Angular impulse about the normal, in N m s.
    pub angular: T,
}

/// What friction can carry.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrictionLimits<T> {
    /// F = μΣλ, the largest tangential impulse, in N s: with the dynamic coefficient. *Domain*: ≥ 0.
    pub impulse: T,
    /// r̄, the largest angular impulse over the largest tangential one, in m. *Domain*: ≥ 0; 0 for one point.
    pub torsion_radius: T,
    /// Dynamic over static coefficient: a candidate is held up to the limit curve over this ratio. *Domain*: (0, 1].
    pub dynamic_over_static: T,
}

/// Inverse effective masses of the two bodies at the manifold.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InverseEffectiveMasses<T> {
    /// k, of the tangential motion at the friction centre, in 1/kg: the one that made the candidate, the mean of both
    /// tangents if that was a matrix. *Domain*: > 0.
    pub tangential: T,
    /// kt, of the rotation about the normal, in 1/(kg m²). *Domain*: ≥ 0.
    pub angular: T,
}

/// The friction impulse nearest to `candidate` that the manifold can carry.
///
/// *Domain*: energies k F², kt T², k F |p| and kt T |t| between 1e-37 and 1e38 J in f32; |p| < 1e18 N s. Limits
/// of zero give zero. NaN gives NaN, also in impulses that could do without it; an infinite impulse gives NaN
/// or its limit.
///
/// *Accuracy*: distance from the nearest point of the set, in units of the limits, for k_t T²/(k F²) of
/// 0.01…100 and candidates up to 10⁴ limits away: area, points and ellipsoid 5e-4 (in three
/// Newton steps 1e-5), [`DirectionalLimitCurve`] in a given direction of planks up to 4 : 1 3e-4, of bars
/// that slide across themselves 3e-2. A heavy plank on a light one leaves that range: the distance grows to
/// 1.5e-2 for ratios of 10⁻³…10³, 5e-2 for 10⁻⁴…10⁴ and 9e-2 for 10⁻⁶…10⁶. The result is in the set to rounding
/// in every case, and no component exceeds the candidate's.
///
/// *Cost*: about 0.1 µs for one, 23 ns a manifold in four lanes of f32 (directed: 38 ns).
#[inline]
pub fn project_friction<T: Lanes, O: LimitCurve<T>>(
    candidate: &FrictionImpulse<T>,
    budget: &FrictionLimits<T>,
    inverse: &InverseEffectiveMasses<T>,
    outline: &O,
) -> FrictionImpulse<T> {
    project::project(candidate, budget, inverse, outline, O::STEPS)
}

/// [`project_friction`] with a number of Newton steps of the caller's: each squares the error or better,
/// and costs 6 ns a manifold in four lanes.
#[doc(hidden)]
#[inline]
pub fn manifold_friction_in<const STEPS: usize, T: Lanes, O: LimitCurve<T>>(
    candidate: &FrictionImpulse<T>,
    budget: &FrictionLimits<T>,
    inverse: &InverseEffectiveMasses<T>,
    outline: &O,
) -> FrictionImpulse<T> {
    project::project(candidate, budget, inverse, outline, STEPS)
}
