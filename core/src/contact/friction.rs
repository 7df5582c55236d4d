//! How much sliding, rolling and torsion friction a contact can carry.
//!
//! All thresholds are proportional to P = F_n + F_coh, so that they vanish when the contact opens
//! (thesis, eqs. 4.1–4.3).

use super::block::Masses;
use super::disc::project_on_disc;
use super::modes::{AllModes, Frictionless, Modes, Sliding, SlidingRolling, SlidingTorsion};
use crate::law::{LawError, validated_not_negative};
use crate::real::Real;
use core::marker::PhantomData;
use nalgebra::Vector3;

/// A force across the normal and a torque about it, or the impulses of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grasp<R> {
    /// In the contact plane.
    pub sliding: Vector3<R>,
    /// About the normal.
    pub torsion: R,
}

/// The set of friction impulses that a contact can carry, for the modes that it has.
pub trait ContactFriction<R: Real>: Copy + Send + Sync {
    /// Which modes.
    type Modes: Modes<R>;

    /// The admissible pair nearest to `trial`, in the metric that makes one contact's update exact:
    /// |Δsliding|² + (Δtorsion/[gyration](Masses::gyration))².
    ///
    /// `bound` is P in force or impulse; `lever` is r_eff.
    fn hold(&self, trial: &Grasp<R>, bound: R, lever: R, masses: &Masses<R>) -> Grasp<R>;

    /// The admissible rolling torque nearest to `trial`.
    fn hold_rolling(&self, trial: &Vector3<R>, bound: R, lever: R) -> Vector3<R>;
}

/// Three independent thresholds, a product of sets: |F_t| ≤ μ P, |T_t| ≤ μ_t P r_eff,
/// |T_n| ≤ μ_n P r_eff. Modes without a threshold are not resisted and cost nothing.
///
/// ```
/// use tribos_core::contact::Thresholds;
/// let powder = Thresholds::all(0.3_f64, 0.1, 0.1)?; // sliding, rolling, torsion
/// let billiard = Thresholds::sliding(0.2_f32)?;
/// assert!(size_of_val(&billiard) <= size_of_val(&powder));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Thresholds<R, M> {
    sliding: R,
    rolling: R,
    torsion: R,
    modes: PhantomData<M>,
}

impl<R: Real, M> Thresholds<R, M> {
    fn validated(sliding: R, rolling: R, torsion: R) -> Result<Self, LawError> {
        Ok(Self {
            sliding: validated_not_negative("sliding coefficient", sliding)?,
            rolling: validated_not_negative("rolling coefficient", rolling)?,
            torsion: validated_not_negative("torsion coefficient", torsion)?,
            modes: PhantomData,
        })
    }

    /// μ, a ratio of forces.
    pub fn mu(&self) -> R {
        self.sliding
    }

    /// μ_t, a ratio of lengths: rolling torque over P r_eff.
    pub fn mu_rolling(&self) -> R {
        self.rolling
    }

    /// μ_n, a ratio of lengths: torsion torque over P r_eff.
    pub fn mu_torsion(&self) -> R {
        self.torsion
    }
}

impl<R: Real> Thresholds<R, Frictionless> {
    /// Smooth contacts.
    pub fn none() -> Self {
        Self {
            sliding: R::ZERO,
            rolling: R::ZERO,
            torsion: R::ZERO,
            modes: PhantomData,
        }
    }
}

impl<R: Real> Thresholds<R, Sliding> {
    /// Sliding friction with coefficient μ ≥ 0.
    pub fn sliding(mu: R) -> Result<Self, LawError> {
        Self::validated(mu, R::ZERO, R::ZERO)
    }
}

impl<R: Real> Thresholds<R, SlidingTorsion> {
    /// Sliding and torsion friction, μ and μ_n.
    pub fn sliding_torsion(mu: R, mu_torsion: R) -> Result<Self, LawError> {
        Self::validated(mu, R::ZERO, mu_torsion)
    }
}

impl<R: Real> Thresholds<R, SlidingRolling> {
    /// Sliding and rolling friction, μ and μ_t.
    pub fn sliding_rolling(mu: R, mu_rolling: R) -> Result<Self, LawError> {
        Self::validated(mu, mu_rolling, R::ZERO)
    }
}

impl<R: Real> Thresholds<R, AllModes> {
    /// Sliding, rolling and torsion friction, μ, μ_t and μ_n.
    pub fn all(mu: R, mu_rolling: R, mu_torsion: R) -> Result<Self, LawError> {
        Self::validated(mu, mu_rolling, mu_torsion)
    }
}

impl<R: Real, M: Modes<R>> ContactFriction<R> for Thresholds<R, M> {
    type Modes = M;

    #[inline(always)]
    fn hold(&self, trial: &Grasp<R>, bound: R, lever: R, _: &Masses<R>) -> Grasp<R> {
        Grasp {
            sliding: project_on_disc(&trial.sliding, self.sliding * bound),
            torsion: clamp(trial.torsion, self.torsion * (bound * lever)),
        }
    }

    #[inline(always)]
    fn hold_rolling(&self, trial: &Vector3<R>, bound: R, lever: R) -> Vector3<R> {
        project_on_disc(trial, self.rolling * (bound * lever))
    }
}

/// `x` limited to ±`bound`; NaN stays NaN.
#[inline(always)]
fn clamp<R: Real>(x: R, bound: R) -> R {
    let size = x.abs();
    // Two selections, no branch: torsion sticks here and slips there.
    let beyond = if size > bound { bound } else { R::NAN };
    let size = if size <= bound { size } else { beyond };
    size.copysign(x)
}
