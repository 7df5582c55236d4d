//! Sliding and torsion under one threshold: what a contact of finite size can carry.
//!
//! Each element of the contact resists along its own velocity, so that a contact that slides
//! resists spinning less, and one that spins slides more easily. What it can carry at P is P times
//! a convex set, the limit surface (see [`crate::limit_surface`]). The set is symmetric about the
//! normal: the nearest point lies along the trial's own direction in the contact plane, and no axes
//! there are needed.

use super::block::Masses;
use super::disc::project_on_disc;
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::{AllModes, ContactModes, SlidingTorsion};
use super::vector::magnitude;
use crate::law::{LawError, validated_not_negative};
use crate::limit_surface::FrictionSet;
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use core::marker::PhantomData;
use nalgebra::Vector3;

/// Sliding and torsion in the set P·`S`; rolling, where there is any, under its own threshold.
///
/// `S` is the set for P = 1 and r_eff = 1: its force limit is μ, its radius R_c/r_eff. A ratio, like
/// the coefficients of [`IndependentFriction`](super::IndependentFriction), and for the same reason: it stays when a
/// packing is scaled. Its largest torque is that of a torsion coefficient μ_n = μ (R_c/r_eff) T₀,
/// with T₀ = 2/3 under uniform pressure. Take [`LimitSurface`](crate::limit_surface::RoundLimitSurface)
/// for the exact set, [`Ellipsoid`](crate::limit_surface::LimitEllipsoid) for the usual approximation; the
/// set of a polygon is not symmetric about the normal and does not belong here.
///
/// *Accuracy* of the projection: that of the set's, 1e-15 of the limits for the exact disk by
/// table in f64. Trials that stay inside are returned to the bit.
///
/// ```
/// use tribos_core::contact::CoupledFriction;
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::limit_surface::{LimitEllipsoid, FrictionSet, RoundLimitSurface};
/// let exact = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.5)?; // mu, R_c/r_eff
/// let billiard = CoupledFriction::sliding_torsion(exact);
/// let usual = LimitEllipsoid::new(0.3_f32, 0.5, 2.0 / 3.0)?;
/// let powder = CoupledFriction::all(usual, 0.1)?; // mu_rolling
/// assert!((billiard.mu_torsion() - 0.1).abs() < 1e-15);
/// assert_eq!([powder.mu(), powder.mu_rolling()], [powder.set().force_limit(), 0.1]);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CoupledFriction<R, S, M> {
    set: S,
    /// Largest torque for P = 1 and r_eff = 1.
    torsion: R,
    /// Inverses of the largest force and torque.
    inv_limits: [R; 2],
    rolling: R,
    modes: PhantomData<M>,
}

impl<R: Real, S: FrictionSet<R>, M> CoupledFriction<R, S, M> {
    fn new(set: S, rolling: R) -> Self {
        let spinning = set.wrench(&Twist::new(R::ZERO, R::ZERO, R::ONE));
        let torsion = spinning.torque.abs();
        Self {
            torsion,
            inv_limits: [R::ONE / set.force_limit(), R::ONE / torsion],
            set,
            rolling,
            modes: PhantomData,
        }
    }

    /// The set for P = 1 and r_eff = 1.
    pub fn set(&self) -> &S {
        &self.set
    }

    /// μ, a ratio of forces: the threshold of sliding without torsion.
    pub fn mu(&self) -> R {
        self.set.force_limit()
    }

    /// μ_t, a ratio of lengths: rolling torque over P r_eff.
    pub fn mu_rolling(&self) -> R {
        self.rolling
    }

    /// μ_n, a ratio of lengths: the threshold of torsion without sliding, over P r_eff.
    pub fn mu_torsion(&self) -> R {
        self.torsion
    }

    /// The nearest pair of magnitudes in the set for P = 1 and r_eff = 1; none for a pair inside.
    fn pulled_back(&self, [force, torque]: [R; 2], gyration: R) -> Option<[R; 2]> {
        let trial = Wrench::new(force, R::ZERO, torque);
        let nearest = self.set.project_with_length(&trial, gyration).wrench;
        (nearest != trial).then_some([nearest.force.x, nearest.torque])
    }
}

impl<R: Real, S: FrictionSet<R>> CoupledFriction<R, S, SlidingTorsion> {
    /// Sliding and torsion friction.
    pub fn sliding_torsion(set: S) -> Self {
        Self::new(set, R::ZERO)
    }
}

impl<R: Real, S: FrictionSet<R>> CoupledFriction<R, S, AllModes> {
    /// Sliding and torsion friction, and rolling friction with the coefficient `mu_rolling`.
    pub fn all(set: S, mu_rolling: R) -> Result<Self, LawError> {
        let rolling = validated_not_negative("rolling coefficient", mu_rolling)?;
        Ok(Self::new(set, rolling))
    }
}

impl<R, S, M> ContactFriction<R> for CoupledFriction<R, S, M>
where
    R: Real,
    S: FrictionSet<R> + Copy + Send + Sync,
    M: ContactModes<R>,
{
    type Modes = M;

    /// *Special values*: a pair that is infinite comes back as NaN, and so does one outside of a set
    /// whose limits over ε² are infinite. Where nothing can turn
    /// (gyration 0) the lever replaces it.
    #[inline]
    fn hold(
        &self,
        trial: &TangentialLoad<R>,
        bound: R,
        lever: R,
        masses: &Masses<R>,
    ) -> TangentialLoad<R> {
        let (force, torque) = (magnitude(&trial.sliding), trial.torsion.abs() / lever);
        // A convex set holds all between its poles.
        let [inv_force, inv_torque] = self.inv_limits;
        if force * inv_force + torque * inv_torque < bound {
            return *trial;
        }
        let reach = if self.torsion > self.set.force_limit() {
            self.torsion
        } else {
            self.set.force_limit()
        };
        if bound == R::ZERO || reach == R::ZERO {
            // NaN and infinity stay NaN.
            return TangentialLoad {
                sliding: trial.sliding * R::ZERO,
                torsion: trial.torsion * R::ZERO,
            };
        }
        // From far away the nearest point is where the direction says: nothing needs to overflow.
        let size = if force > torque { force } else { torque };
        let far = reach / R::EPSILON / R::EPSILON;
        let reduced_pair = if size / bound > far && size.is_finite() {
            [force / size * far, torque / size * far]
        } else {
            [force / bound, torque / bound]
        };
        let gyration = masses.gyration();
        let reduced = if gyration > R::ZERO {
            gyration / lever
        } else {
            R::ONE
        };
        match self.pulled_back(reduced_pair, reduced) {
            None => *trial,
            Some([held_force, held_torque]) => TangentialLoad {
                sliding: along(&trial.sliding, force, held_force * bound),
                torsion: (held_torque * bound * lever).copysign(trial.torsion),
            },
        }
    }

    #[inline(always)]
    fn hold_rolling(&self, trial: &Vector3<R>, bound: R, lever: R) -> Vector3<R> {
        project_on_disc(trial, self.rolling * (bound * lever))
    }
}

/// The direction of `q`, whose magnitude is given, with another magnitude.
fn along<R: Real>(q: &Vector3<R>, given: R, wanted: R) -> Vector3<R> {
    if given == R::ZERO {
        *q
    } else {
        q / given * wanted
    }
}
