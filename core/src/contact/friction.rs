//! How much sliding, rolling and torsion friction a contact can carry.
//!
//! All thresholds are proportional to P = F_n + F_coh, so that they vanish when the contact opens
//! (thesis, eqs. 4.1–4.3).

use super::block::Masses;
use super::disc::project_on_disc;
use super::modes::{
    AllModes, ContactModes, Frictionless, SlidingOnly, SlidingRolling, SlidingTorsion,
};
use crate::law::{LawError, validated_not_negative};
use crate::real::Real;
use core::marker::PhantomData;
use nalgebra::Vector3;

/// A force across the normal and a torque about it, or the impulses of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentialLoad<R> {
    /// In the contact plane.
    pub sliding: Vector3<R>,
    /// About the normal.
    pub torsion: R,
}

/// The set of friction impulses that a contact can carry: [`IndependentFriction`] for each mode alone, or
/// [`CoupledFriction`](super::CoupledFriction) for sliding and torsion together.
pub trait ContactFriction<R: Real>: Copy + Send + Sync {
    /// The modes that friction resists.
    type Modes: ContactModes<R>;

    /// The admissible pair nearest to `trial`, in the metric that makes one contact's update exact:
    /// |Δsliding|² + (Δtorsion/[gyration](Masses::gyration))².
    ///
    /// `bound` is P in force or impulse; `lever` is r_eff.
    #[doc(hidden)]
    fn hold(
        &self,
        trial: &TangentialLoad<R>,
        bound: R,
        lever: R,
        masses: &Masses<R>,
    ) -> TangentialLoad<R>;

    /// The admissible rolling torque nearest to `trial`.
    #[doc(hidden)]
    fn hold_rolling(&self, trial: &Vector3<R>, bound: R, lever: R) -> Vector3<R>;

    /// The coefficients of sliding, rolling and torsion, if each of these has a threshold of its own.
    #[doc(hidden)]
    fn independent_limits(&self) -> Option<[R; 3]> {
        None
    }
}

/// Three independent thresholds, a product of sets: |F_t| ≤ μ P, |T_t| ≤ μ_t P r_eff,
/// |T_n| ≤ μ_n P r_eff. Modes without a threshold are not resisted and cost nothing.
///
/// ```
/// use tribos_core::contact::IndependentFriction;
/// let powder = IndependentFriction::all(0.3_f64, 0.1, 0.05)?; // sliding, rolling, torsion
/// assert_eq!([powder.mu(), powder.mu_rolling(), powder.mu_torsion()], [0.3, 0.1, 0.05]);
/// let billiard = IndependentFriction::sliding(0.2_f32)?;
/// assert!(size_of_val(&billiard) <= size_of_val(&powder));
/// assert_eq!(IndependentFriction::<f64, _>::none().mu(), 0.0);
/// assert!(IndependentFriction::sliding(-0.2).is_err());
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct IndependentFriction<R, M> {
    sliding: R,
    rolling: R,
    torsion: R,
    modes: PhantomData<M>,
}

impl<R: Real, M> IndependentFriction<R, M> {
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

impl<R: Real> IndependentFriction<R, Frictionless> {
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

impl<R: Real> IndependentFriction<R, SlidingOnly> {
    /// Sliding friction with coefficient μ ≥ 0.
    pub fn sliding(mu: R) -> Result<Self, LawError> {
        Self::validated(mu, R::ZERO, R::ZERO)
    }
}

impl<R: Real> IndependentFriction<R, SlidingTorsion> {
    /// Sliding and torsion friction, μ and μ_n.
    ///
    /// ```
    /// use tribos_core::contact::IndependentFriction;
    /// // A fingertip of r_eff = 25 mm that bears on a disk of 5 mm: μ_n = μ T₀ 5 mm/25 mm.
    /// let finger = IndependentFriction::sliding_torsion(0.9_f64, 0.9 * (2.0 / 3.0) * 0.2)?;
    /// assert!((finger.mu_torsion() - 0.12).abs() < 1e-15);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn sliding_torsion(mu: R, mu_torsion: R) -> Result<Self, LawError> {
        Self::validated(mu, R::ZERO, mu_torsion)
    }
}

impl<R: Real> IndependentFriction<R, SlidingRolling> {
    /// Sliding and rolling friction, μ and μ_t.
    ///
    /// ```
    /// use tribos_core::contact::IndependentFriction;
    /// let tyre = IndependentFriction::sliding_rolling(0.8_f64, 0.01)?;
    /// // Under P = 4000 N at r_eff = 0.3 m rolling is resisted by 12 N m.
    /// assert!((tyre.mu_rolling() * 4000.0 * 0.3 - 12.0).abs() < 1e-13);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn sliding_rolling(mu: R, mu_rolling: R) -> Result<Self, LawError> {
        Self::validated(mu, mu_rolling, R::ZERO)
    }
}

impl<R: Real> IndependentFriction<R, AllModes> {
    /// Sliding, rolling and torsion friction, μ, μ_t and μ_n.
    pub fn all(mu: R, mu_rolling: R, mu_torsion: R) -> Result<Self, LawError> {
        Self::validated(mu, mu_rolling, mu_torsion)
    }
}

impl<R: Real, M: ContactModes<R>> ContactFriction<R> for IndependentFriction<R, M> {
    type Modes = M;

    #[inline(always)]
    fn hold(
        &self,
        trial: &TangentialLoad<R>,
        bound: R,
        lever: R,
        _: &Masses<R>,
    ) -> TangentialLoad<R> {
        TangentialLoad {
            sliding: project_on_disc(&trial.sliding, self.sliding * bound),
            torsion: clamp(trial.torsion, self.torsion * (bound * lever)),
        }
    }

    #[inline(always)]
    fn hold_rolling(&self, trial: &Vector3<R>, bound: R, lever: R) -> Vector3<R> {
        project_on_disc(trial, self.rolling * (bound * lever))
    }

    #[inline(always)]
    fn independent_limits(&self) -> Option<[R; 3]> {
        Some([self.sliding, self.rolling, self.torsion])
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
