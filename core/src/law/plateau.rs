//! Friction that falls with speed, made finite at rest.

use super::error::{fraction, ordered, positive, validated_coefficient, validated_exponent};
use super::{LawError, LocalLaw};
use crate::real::Real;

/// γ|v|^α of fast sliding (α ≤ 0) with a plateau at low speed and a finite value at rest.
///
/// ```text
/// μ(v) = γ (v² + v_p²)^(α/2) · [ r + (1 − r) v/(v + v_d) ]
/// ```
///
/// | speed | friction | relative deviation from it |
/// |---|---|---|
/// | v ≫ v_p | γ v^α | \|α\|/2 (v_p/v)² + (1 − r) v_d/v at most |
/// | v_d ≪ v ≪ v_p | γ v_p^α, the plateau | \|α\|/2 (v/v_p)² + (1 − r) v_d/v at most |
/// | v → 0 | r γ v_p^α | linear in v/v_d |
///
/// For ice on granite v_p is about 1e-4 m/s ([`PlateauPower::ICE_PLATEAU_SPEED`]) and friction is
/// constant for two decades below. With v_d = v_p/1000 it has lost (1 − r)/11 at v_p/100.
///
/// *Units*: γ carries (time/length)^α; v_p and v_d are speeds; r is dimensionless.
/// *Source*: eq. 3.39 and fig. 3.19; the closed form is ours.
///
/// ```
/// use tribos_core::law::{LocalLaw, PlateauPower};
/// let plateau = PlateauPower::<f64>::ICE_PLATEAU_SPEED; // 1e-4 m/s
/// let curling = PlateauPower::new(-0.5, 0.008, plateau, 1e-7, 0.5)?;
/// assert!((curling.friction(1.0) - 0.008).abs() < 1e-8);
/// assert!((curling.friction(0.0) - 0.4).abs() < 1e-14); // half of 0.008/sqrt(1e-4)
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlateauPower<R> {
    alpha: R,
    coefficient: R,
    plateau: R,
    drop: R,
    rest: R,
}

impl<R: Real> PlateauPower<R> {
    /// Speed in m/s below which friction of ice on granite and glass is constant (fig. 3.19).
    pub const ICE_PLATEAU_SPEED: f64 = 1e-4;

    /// Exponent α and coefficient γ of fast sliding, plateau speed v_p, speed v_d of the drop
    /// below it, and the share r of the plateau that is left at rest.
    ///
    /// *Domain*: −1 < `alpha` ≤ 0; 0 ≤ `coefficient` < ∞; 0 < `drop_speed` ≤ `plateau_speed` < ∞;
    /// 0 ≤ `rest_share` ≤ 1 (1: no drop).
    pub fn new(
        alpha: R,
        coefficient: R,
        plateau_speed: R,
        drop_speed: R,
        rest_share: R,
    ) -> Result<Self, LawError> {
        validated_exponent(alpha.to_f64(), 0.0)?;
        positive("plateau speed", plateau_speed)?;
        positive("drop speed", drop_speed)?;
        ordered(("drop speed", drop_speed), ("plateau speed", plateau_speed))?;
        Ok(Self {
            alpha,
            coefficient: validated_coefficient(coefficient)?,
            plateau: plateau_speed,
            drop: drop_speed,
            rest: fraction("share of friction at rest", rest_share)?,
        })
    }

    /// r + (1 − r) v/(v + v_d), in a form that has both limits.
    fn share(&self, speed: R) -> R {
        self.rest + (R::ONE - self.rest) / (R::ONE + self.drop / speed)
    }

    /// γ (v² + v_p²)^(α/2)
    fn falling(&self, speed: R) -> R {
        self.coefficient * speed.hypot(self.plateau).pow(self.alpha)
    }
}

impl<R: Real> LocalLaw<R> for PlateauPower<R> {
    /// *Special values*: r γ v_p^α at rest, 0 at infinite speed (γ if α = 0).
    #[inline]
    fn friction(&self, speed: R) -> R {
        self.falling(speed) * self.share(speed)
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        let length = speed.hypot(self.plateau);
        // d ln(v² + v_p²)^½ / dv = v/(v² + v_p²)
        let cos = R::ONE / R::ONE.hypot(self.plateau / speed);
        let fall = self.alpha * cos / length * self.share(speed);
        // (1 − r) v_d/(v + v_d)²
        let away = speed + self.drop;
        let rise = (R::ONE - self.rest) * (self.drop / away) / away;
        self.falling(speed) * (fall + rise)
    }
}
