//! Friction that falls with speed, made finite at rest.

use super::error::{fraction, ordered, positive, validated_coefficient, validated_exponent};
use super::{LawError, LocalLaw};
use crate::real::Real;

/// Parameters of [`PlateauPowerLaw`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlateauPowerLawParameters<R> {
    /// Exponent α of fast sliding. *Domain*: −1 < α ≤ 0.
    pub alpha: R,
    /// Coefficient γ of fast sliding. *Units*: (time/length)^α. *Domain*: 0 ≤ γ < ∞.
    pub coefficient: R,
    /// Speed v_p below which friction is constant. *Domain*: 0 < v_p < ∞.
    pub plateau_speed: R,
    /// Speed v_d below which friction drops from the plateau. *Domain*: 0 < v_d ≤ v_p.
    pub drop_speed: R,
    /// Friction at rest as a share r of the plateau; 1 for no drop. *Domain*: 0 ≤ r ≤ 1.
    pub rest_share: R,
}

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
/// For ice on granite v_p is about 1e-4 m/s ([`PlateauPowerLaw::ICE_PLATEAU_SPEED`]) and friction is
/// constant for two decades below. With v_d = v_p/1000 it has lost (1 − r)/11 at v_p/100.
///
/// *Units*: γ carries (time/length)^α; v_p and v_d are speeds; r is dimensionless.
/// *Source*: eq. 3.39 and fig. 3.19; the closed form is ours.
///
/// ```
/// use tribos_core::law::{LocalLaw, PlateauPowerLaw, PlateauPowerLawParameters};
/// let curling = PlateauPowerLaw::new(PlateauPowerLawParameters {
///     alpha: -0.5, coefficient: 0.008, // speeds in m/s
///     plateau_speed: PlateauPowerLaw::<f64>::ICE_PLATEAU_SPEED, // 1e-4 m/s
///     drop_speed: 1e-7, rest_share: 0.5,
/// })?;
/// assert!((curling.friction(1.0) - 0.008).abs() < 1e-8);
/// assert!((curling.friction(0.0) - 0.4).abs() < 1e-14); // half of 0.008/sqrt(1e-4)
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlateauPowerLaw<R> {
    parameters: PlateauPowerLawParameters<R>,
}

impl<R: Real> PlateauPowerLaw<R> {
    /// Speed in m/s below which friction of ice on granite and glass is constant (fig. 3.19).
    pub const ICE_PLATEAU_SPEED: f64 = 1e-4;

    /// *Domain*: that of [`PlateauPowerLawParameters`].
    pub fn new(parameters: PlateauPowerLawParameters<R>) -> Result<Self, LawError> {
        let p = &parameters;
        validated_exponent(p.alpha.to_f64(), 0.0)?;
        positive("plateau speed", p.plateau_speed)?;
        positive("drop speed", p.drop_speed)?;
        ordered(
            ("drop speed", p.drop_speed),
            ("plateau speed", p.plateau_speed),
        )?;
        validated_coefficient(p.coefficient)?;
        fraction("share of friction at rest", p.rest_share)?;
        Ok(Self { parameters })
    }

    /// r + (1 − r) v/(v + v_d), in a form that has both limits.
    fn share(&self, speed: R) -> R {
        let p = &self.parameters;
        p.rest_share + (R::ONE - p.rest_share) / (R::ONE + p.drop_speed / speed)
    }

    /// γ (v² + v_p²)^(α/2)
    fn falling(&self, speed: R) -> R {
        let p = &self.parameters;
        p.coefficient * speed.hypot(p.plateau_speed).pow(p.alpha)
    }
}

impl<R: Real> LocalLaw<R> for PlateauPowerLaw<R> {
    /// *Special values*: r γ v_p^α at rest, 0 at infinite speed (γ if α = 0).
    #[inline]
    fn friction(&self, speed: R) -> R {
        self.falling(speed) * self.share(speed)
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        let p = &self.parameters;
        let length = speed.hypot(p.plateau_speed);
        // d ln(v² + v_p²)^½ / dv = v/(v² + v_p²)
        let cos = R::ONE / R::ONE.hypot(p.plateau_speed / speed);
        let fall = p.alpha * cos / length * self.share(speed);
        // (1 − r) v_d/(v + v_d)²
        let away = speed + p.drop_speed;
        let rise = (R::ONE - p.rest_share) * (p.drop_speed / away) / away;
        self.falling(speed) * (fall + rise)
    }
}
