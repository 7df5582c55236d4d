//! Rubber: friction that rises to a maximum over decades of speed, and falls again.

use super::error::{ordered, positive, validated_coefficient};
use super::limits::{ln_ratio, scaled};
use super::{LawError, LocalLaw};
use crate::real::Real;

/// Parameters of [`Savkoor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SavkoorParameters<R> {
    /// Coefficient μ₀ far from the maximum. *Domain*: 0 ≤ μ₀ ≤ μ_m.
    pub mu_base: R,
    /// Largest coefficient μ_m. *Domain*: 0 ≤ μ_m < ∞.
    pub mu_max: R,
    /// Speed v_m of the maximum. *Domain*: 0 < v_m < ∞.
    pub speed: R,
    /// Narrowness h of the maximum; its half width is 0.83/h e-folds of the speed. *Domain*:
    /// 0 < h < ∞.
    pub narrowness: R,
}

/// μ(v) = μ₀ + (μ_m − μ₀) exp(−h² ln²(v/v_m)).
///
/// A bell over the logarithm of the speed: rubber dissipates most where asperities excite it in the
/// middle of its relaxation times. Authors who take the decadic logarithm have an h larger by ln 10.
///
/// *Units*: v_m in speed, the rest dimensionless. *Accuracy*: 4 ulp of the friction.
/// *Special values*: μ₀ at rest and at infinite speed.
/// *Source*: A. R. Savkoor, Wear 9 (1966) 66, in the form that tyre models use.
///
/// ```
/// use tribos_core::law::{LocalLaw, Savkoor, SavkoorParameters};
/// let tread = Savkoor::new(SavkoorParameters {
///     mu_base: 0.6_f64, mu_max: 1.2, speed: 0.5, narrowness: 0.4, // m/s
/// })?;
/// assert_eq!(tread.friction(0.5), 1.2);
/// assert_eq!(tread.friction(0.0), 0.6);
/// assert!(tread.slope(0.1) > 0.0 && tread.slope(5.0) < 0.0);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Savkoor<R> {
    parameters: SavkoorParameters<R>,
}

impl<R: Real> Savkoor<R> {
    /// *Domain*: that of [`SavkoorParameters`].
    pub fn new(parameters: SavkoorParameters<R>) -> Result<Self, LawError> {
        let p = &parameters;
        validated_coefficient(p.mu_base)?;
        validated_coefficient(p.mu_max)?;
        ordered(
            ("base coefficient", p.mu_base),
            ("largest coefficient", p.mu_max),
        )?;
        positive("speed of the maximum", p.speed)?;
        positive("narrowness of the maximum", p.narrowness)?;
        Ok(Self { parameters })
    }

    /// x = h ln(v/v_m) and the bell exp(−x²).
    fn bell(&self, speed: R) -> (R, R) {
        let x = self.parameters.narrowness * ln_ratio(speed, self.parameters.speed);
        (x, (-(x * x)).exp())
    }

    /// μ_m − μ₀
    fn rise(&self) -> R {
        self.parameters.mu_max - self.parameters.mu_base
    }
}

impl<R: Real> LocalLaw<R> for Savkoor<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        let (_, bell) = self.bell(speed);
        self.parameters.mu_base + self.rise() * bell
    }
    /// −2 h x (μ_m − μ₀) exp(−x²)/v with x = h ln(v/v_m); 0 at rest.
    #[inline]
    fn slope(&self, speed: R) -> R {
        let (x, bell) = self.bell(speed);
        // The bell dies out faster than any power of the speed.
        if bell == R::ZERO {
            return R::ZERO;
        }
        let steepness = R::TWO * self.parameters.narrowness * x;
        scaled(-self.rise(), steepness * (bell / speed))
    }
}
