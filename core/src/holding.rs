//! Whether a push moves a body at rest: what is certain, what is possible, and what lies between.
//!
//! At rest friction is not a function of the push. What a patch can carry depends on how its bonds
//! share the push, which no coefficient tells. Two sets of wrenches are known all the same.
//!
//! **Holds.** Let every element that moves meet at least the traction μ_d p against its own
//! velocity, as kinetic friction gives it, and let D_d(t) = μ_d N ∫ p̂ |v + ω × r| dA be the power
//! that this takes in the motion t. If push·t ≤ D_d(t) in every motion, the push lies in the set K_d
//! with the support function D_d, and the kinetic energy T obeys dT/dt ≤ push·t − D_d(t) ≤ 0: a body
//! at rest stays there. Nothing was assumed about friction at rest. (Bonds that are strained before
//! the push may give their stored energy in addition.)
//!
//! **Slips.** Let no element carry a traction beyond μ_s p. All tractions |f| ≤ μ_s p together give
//! the set K_s. A push outside of it is in balance with none of them: some motion t has
//! push·t > D_s(t), and the body starts. This is the upper-bound theorem of limit analysis.
//!
//! Between the two sets the sharing decides, and the answer is that it is undecided. Under one
//! coefficient the sets are one, and the exact limit surface answers every question.
//!
//! The set of the first statement may also be another one of which the user knows that it holds:
//! the first break of a declared bond law, or the set of a measured onset. Both statements are about
//! the pressure that the sets were made with.
//!
//! *Source*: D. C. Drucker, W. Prager, H. J. Greenberg, Quart. Appl. Math. 9 (1952) 381 (limit
//! analysis); S. Goyal, A. Ruina, J. Papadopoulos, Wear 143 (1991) 307 (limit surfaces);
//! J. J. Moreau, in: New Variational Techniques in Mathematical Physics (1974) 171 (dissipation as a
//! support function). The first statement is an energy balance; the derivation above is ours.

use crate::limit_surface::FrictionSet;
use crate::real::Real;
use crate::twist::Wrench;

/// What can be said about a push on a body at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Stiction {
    /// The body stays at rest, whatever friction at rest is like.
    Holds,
    /// The body starts: no friction within the declared coefficient balances the push.
    Slips,
    /// It depends on how the bonds share the push; also the answer to NaN.
    Undecided,
}

/// The answer, and how far away the others are.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::holding::{Stiction, StictionBounds};
/// use tribos_core::limit_surface::RoundLimitSurface;
/// use tribos_core::twist::Wrench;
/// // A fingertip: 10 N on a disk of 5 mm, with 0.5 in motion and at most 0.7 at rest.
/// let [certain, possible] = [0.5 * 10.0_f64, 0.7 * 10.0].map(|n| RoundLimitSurface::new(CoulombDisk, n, 5e-3));
/// let (certain, possible) = (certain?, possible?);
/// let ask = |pull| StictionBounds::of(&certain, &possible, &Wrench::new(pull, 0.0, 0.0)); // N
/// assert_eq!(ask(4.0).stiction, Stiction::Holds);
/// assert_eq!(ask(6.0).stiction, Stiction::Undecided);
/// assert_eq!(ask(8.0).stiction, Stiction::Slips);
/// // A quarter more would still hold for certain; at 7/4 of it nothing can hold.
/// assert!((ask(4.0).certain_scale() - 1.25).abs() < 1e-12);
/// assert!((ask(4.0).possible_scale() - 1.75).abs() < 1e-12);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StictionBounds<R> {
    /// What can be said.
    pub stiction: Stiction,
    /// Gauge of the push in the set that is certain to hold: at most 1 if it lies inside.
    pub certain_gauge: R,
    /// Gauge of the push in the set of all that is possible: above 1 if nothing can carry it.
    pub possible_gauge: R,
}

impl<R: Real> StictionBounds<R> {
    /// Judges `push` by the set that is `certain` to hold and the set of all that is `possible`.
    ///
    /// With kinetic coefficient μ_d and static coefficient μ_s these are the limit surfaces of the
    /// force limits μ_d N and μ_s N.
    ///
    /// *Domain*: the first set inside of the second; a push that is inside the first and outside
    /// the second is undecided. *Accuracy*: that of the gauges; a push on a surface within
    /// 64 rounding errors counts as inside. *Special values*: an infinite push slips, NaN is
    /// undecided, no push holds.
    pub fn of<C, P>(certain: &C, possible: &P, push: &Wrench<R>) -> Self
    where
        C: FrictionSet<R> + ?Sized,
        P: FrictionSet<R> + ?Sized,
    {
        let (certain_gauge, possible_gauge) = (certain.gauge(push), possible.gauge(push));
        let is_certain = certain.contains(push);
        let is_impossible = !possible.contains(push) && !possible_gauge.is_nan();
        let hold = match (is_certain, is_impossible) {
            (true, false) => Stiction::Holds,
            (false, true) => Stiction::Slips,
            _ => Stiction::Undecided,
        };
        Self {
            stiction: hold,
            certain_gauge,
            possible_gauge,
        }
    }

    /// Factor up to which the push may grow and is certain to be held: below 1 if it is too large.
    ///
    /// *Special values*: infinite without push.
    pub fn certain_scale(&self) -> R {
        R::ONE / self.certain_gauge
    }

    /// Factor beyond which nothing holds the push: below 1 if it is too large.
    ///
    /// *Special values*: infinite without push.
    pub fn possible_scale(&self) -> R {
        R::ONE / self.possible_gauge
    }
}
