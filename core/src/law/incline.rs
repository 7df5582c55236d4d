//! A body on an inclined plane.

use super::error::{not_negative, positive};
use super::{DryFriction, Grip, LawError, LocalLaw};
use crate::real::Real;

/// Euler's critical angle: the steepest incline on which a coefficient μ holds, atan μ.
///
/// *Units*: radians. *Domain*: μ ≥ 0. *Source*: thesis section 2.1, fig. 2.2.
#[inline]
pub fn critical_angle<R: Real>(mu: R) -> R {
    mu.atan()
}

/// An incline of angle θ, given by its rise and run: tan θ = rise/run.
///
/// Positive accelerations and speeds point downhill.
///
/// ```
/// use tribos_core::law::{DryFriction, Incline, critical_angle};
/// let wood = DryFriction::new(0.5_f64, 0.3)?;
/// let gravity = 9.81; // m/s^2
/// assert_eq!(Incline::new(0.49, 1.0)?.acceleration_at_rest(&wood, gravity), 0.0);
/// let steeper = critical_angle(0.5_f64) + 1e-9;
/// let incline = Incline::new(steeper.sin(), steeper.cos())?;
/// assert!(incline.acceleration_at_rest(&wood, gravity) > 1.7); // slides with a jump
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
///
/// Gravity pulls down the slope whichever way a body slides, friction against its motion:
///
/// ```
/// use tribos_core::law::{DryFriction, Incline};
/// let (wood, gravity) = (DryFriction::new(0.5_f64, 0.3)?, 9.81); // m/s^2
/// let slope = Incline::new(3.0_f64, 4.0)?; // sin 3/5, cos 4/5
/// assert!((slope.angle().tan() - slope.drive_per_load()).abs() < 1e-15); // both 3/4
/// let down = slope.acceleration_downhill(&wood, gravity, 1.0);
/// let up = slope.acceleration_uphill(&wood, gravity, 1.0);
/// assert!((up + down - 2.0 * gravity * 0.6).abs() < 1e-14);
/// assert!((up - down - 2.0 * gravity * 0.3 * 0.8).abs() < 1e-14);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Incline<R> {
    sin: R,
    cos: R,
}

impl<R: Real> Incline<R> {
    /// The incline that rises by `rise` over the horizontal distance `run`, in any one unit: a
    /// grade and 1, or sine and cosine of the angle.
    ///
    /// *Domain*: both finite and not negative, not both zero.
    pub fn new(rise: R, run: R) -> Result<Self, LawError> {
        not_negative("rise of the incline", rise)?;
        not_negative("run of the incline", run)?;
        // The larger one scales both, so that neither square leaves the number range.
        let larger = if rise > run { rise } else { run };
        positive("length of the incline", larger)?;
        let (rise, run) = (rise / larger, run / larger);
        let length = rise.hypot(run);
        Ok(Self {
            sin: rise / length,
            cos: run / length,
        })
    }

    /// The angle θ in radians, 0 to π/2.
    pub fn angle(&self) -> R {
        (self.sin / self.cos).atan()
    }

    /// Drive of a body at rest per load, tan θ: what static friction has to hold.
    pub fn drive_per_load(&self) -> R {
        self.sin / self.cos
    }

    /// Acceleration of a body released at rest: zero if it holds (tan θ ≤ μₛ), else
    /// g (sin θ − μ_d cos θ).
    ///
    /// *Units*: as `gravity`.
    #[inline]
    pub fn acceleration_at_rest(&self, law: &DryFriction<R>, gravity: R) -> R {
        match law.at_rest(self.drive_per_load()) {
            Grip::Stick => R::ZERO * gravity,
            Grip::Slip => gravity * (self.sin - law.mu_dynamic() * self.cos),
        }
    }

    /// Acceleration of a body that slides downhill with `speed` > 0: g (sin θ − μ(v) cos θ) for
    /// any local law. Negative if friction slows it.
    #[inline]
    pub fn acceleration_downhill(&self, law: &impl LocalLaw<R>, gravity: R, speed: R) -> R {
        gravity * (self.sin - law.friction(speed) * self.cos)
    }

    /// The same for a body that slides uphill with `speed` > 0: g (sin θ + μ(v) cos θ).
    #[inline]
    pub fn acceleration_uphill(&self, law: &impl LocalLaw<R>, gravity: R, speed: R) -> R {
        gravity * (self.sin + law.friction(speed) * self.cos)
    }
}
