//! Stiffness and damping of the bonds.

use super::Anchor;
use super::pose::Pose;
use crate::law::{LawError, validated_not_negative, validated_positive};
use crate::real::Real;
use crate::twist::{Displacement, Wrench};

/// Bonds that are elastic up to the surface of a friction set, and slip on it.
///
/// See [`crate::presliding`] for the law. Bonds spread like the pressure p̂ with k_t in all have
/// k_θ = k_t ∫ p̂ r² dA, which is k_t R²/2 on a uniform disk.
///
/// ```
/// use tribos_core::presliding::Presliding;
/// let rubber = Presliding::new(1e4_f64, 0.5 * 1e4 * 0.005 * 0.005)?; // N/m, N m/rad
/// let calm = rubber.with_damping(20.0, 0.0)?; // N s/m, N m s/rad
/// assert_eq!([calm.stiffness(), calm.torsional_stiffness()], [1e4, 0.125]);
/// assert!(Presliding::new(-1e4, 0.125).is_err());
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Presliding<R> {
    stiffness: Stiffness<R>,
    damping: [R; 2],
}

/// A factor of displacements in sliding and in torsion, with the length that relates them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Stiffness<R> {
    pub(crate) sliding: R,
    pub(crate) torsion: R,
    /// √(torsion/sliding): in the norm of energy a torque over it counts as a force.
    pub(crate) length: R,
}

impl<R: Real> Stiffness<R> {
    /// Without a check: [`Presliding::new`] has one.
    #[inline]
    pub(crate) fn new(sliding: R, torsion: R) -> Self {
        Self {
            sliding,
            torsion,
            length: (torsion / sliding).sqrt(),
        }
    }

    /// S e
    #[inline]
    pub(crate) fn wrench(&self, strain: &Displacement<R>) -> Wrench<R> {
        Wrench {
            force: strain.shift * self.sliding,
            torque: strain.turn * self.torsion,
        }
    }

    /// S⁻¹ z
    #[inline]
    pub(crate) fn strain(&self, wrench: &Wrench<R>) -> Displacement<R> {
        Displacement::new(
            wrench.force.x / self.sliding,
            wrench.force.y / self.sliding,
            wrench.torque / self.torsion,
        )
    }

    /// e·S e/2
    #[inline]
    pub(crate) fn energy(&self, strain: &Displacement<R>) -> R {
        R::HALF * strain.work(&self.wrench(strain))
    }
}

impl<R: Real> Presliding<R> {
    /// Bonds with the stiffness k_t in sliding and k_θ in torsion.
    ///
    /// *Units*: force/length, and force × length per radian. *Domain*: both positive and finite, and
    /// so their ratio. Positions should resolve the displacement at which the bonds slip: k_t times
    /// the rounding of a position is the rounding of friction.
    pub fn new(stiffness: R, torsional_stiffness: R) -> Result<Self, LawError> {
        let sliding = validated_positive("stiffness", stiffness)?;
        let torsion = validated_positive("torsional stiffness", torsional_stiffness)?;
        let stiffness = Stiffness::new(sliding, torsion);
        validated_positive("ratio of the stiffnesses", stiffness.length)?;
        Ok(Self {
            stiffness,
            damping: [R::ZERO; 2],
        })
    }

    /// The same with viscous damping of the bonds' strain rate, for steps of a body with mass.
    ///
    /// It calms the vibration of a body that holds and is part of what the set limits: a body that
    /// slides steadily does not feel it. Poses in time do not tell their rate, so that
    /// [`Presliding::step`] has no use for it.
    ///
    /// *Units*: force × time/length, force × length × time per radian. *Domain*: 0 ≤ both < ∞.
    pub fn with_damping(self, damping: R, torsional_damping: R) -> Result<Self, LawError> {
        let damping = [
            validated_not_negative("damping", damping)?,
            validated_not_negative("torsional damping", torsional_damping)?,
        ];
        Ok(Self { damping, ..self })
    }

    /// The stiffness in sliding, k_t.
    pub fn stiffness(&self) -> R {
        self.stiffness.sliding
    }

    /// The stiffness in torsion, k_θ.
    pub fn torsional_stiffness(&self) -> R {
        self.stiffness.torsion
    }

    /// The damping in sliding and in torsion.
    pub fn damping(&self) -> [R; 2] {
        self.damping
    }

    /// Both stiffnesses.
    #[inline]
    pub(crate) fn factors(&self) -> &Stiffness<R> {
        &self.stiffness
    }

    /// Energy that the bonds of a patch in `pose` store, e·S e/2.
    ///
    /// *Units*: force × length. *Accuracy*: a few ulp of the strain's own.
    ///
    /// ```
    /// use tribos_core::presliding::{Anchor, Pose, Presliding};
    /// let bonds = Presliding::new(1e4_f64, 0.125)?; // N/m, N m/rad
    /// let touched = Anchor::at(Pose::new(0.0, 0.0, 0.0));
    /// let stored = bonds.stored_energy(&touched, &Pose::new(1e-3, 0.0, 0.0)); // m, m, rad
    /// assert!((stored - 5e-3).abs() < 1e-17); // J
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn stored_energy(&self, anchor: &Anchor<R>, pose: &Pose<R>) -> R {
        self.stiffness.energy(&anchor.deflection(pose))
    }

    /// Displacement from the anchor at which the bonds carry `push`, S⁻¹ push.
    ///
    /// *Units*: length, radians. *Domain*: a push that friction carries; the bonds of others slip.
    pub fn strain_under(&self, push: &Wrench<R>) -> Displacement<R> {
        self.stiffness.strain(push)
    }
}
