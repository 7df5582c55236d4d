//! Friction that rises from rest and levels off, as of PTFE.

use super::error::{ordered, positive, validated_coefficient};
use super::limits::scaled;
use super::{LawError, LocalLaw};
use crate::real::Real;

/// Parameters of [`RisingLaw`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RisingLawParameters<R> {
    /// Coefficient μₛ at rest. *Domain*: 0 ≤ μₛ ≤ μ_f.
    pub mu_rest: R,
    /// Coefficient μ_f of fast sliding. *Domain*: 0 ≤ μ_f < ∞.
    pub mu_fast: R,
    /// Speed v_r over which friction rises. *Domain*: 0 < v_r < ∞.
    pub speed: R,
}

/// μ(v) = μ_f − (μ_f − μₛ) exp(−v/v_r).
///
/// A sliding bearing of PTFE on polished steel, as of isolators under buildings: friction rises with the
/// speed and levels off. Friction that falls instead is that of [`Stribeck`](super::Stribeck).
///
/// *Units*: v_r in speed, the rest dimensionless. *Accuracy*: 4 ulp of the friction.
/// *Special values*: μₛ at rest, μ_f at infinite speed.
/// *Source*: M. C. Constantinou, A. Mokha, A. M. Reinhorn, J. Struct. Eng. 116 (1990) 455, eq. 5, with
/// their constant a = 1/v_r.
///
/// ```
/// use tribos_core::law::{LocalLaw, RisingLaw, RisingLawParameters};
/// let ptfe = RisingLaw::new(RisingLawParameters {
///     mu_rest: 0.04_f64, mu_fast: 0.12, speed: 0.04, // m/s
/// })?;
/// assert_eq!(ptfe.friction(0.0), 0.04);
/// assert!((ptfe.friction(1.0) - 0.12).abs() < 1e-9);
/// assert!((ptfe.slope(0.0) - 0.08 / 0.04).abs() < 1e-14);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RisingLaw<R> {
    parameters: RisingLawParameters<R>,
}

impl<R: Real> RisingLaw<R> {
    /// *Domain*: that of [`RisingLawParameters`].
    pub fn new(parameters: RisingLawParameters<R>) -> Result<Self, LawError> {
        let p = &parameters;
        validated_coefficient(p.mu_rest)?;
        validated_coefficient(p.mu_fast)?;
        ordered(
            ("coefficient at rest", p.mu_rest),
            ("coefficient of fast sliding", p.mu_fast),
        )?;
        positive("speed of the rise", p.speed)?;
        Ok(Self { parameters })
    }

    /// μ_f − μₛ
    fn rise(&self) -> R {
        self.parameters.mu_fast - self.parameters.mu_rest
    }
}

impl<R: Real> LocalLaw<R> for RisingLaw<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        // Above μₛ by (μ_f − μₛ)(1 − exp(−x)), which keeps its digits where μₛ = 0 and x is small.
        let risen = -(-(speed / self.parameters.speed)).exp_m1();
        self.parameters.mu_rest + self.rise() * risen
    }
    /// (μ_f − μₛ) exp(−v/v_r)/v_r.
    #[inline]
    fn slope(&self, speed: R) -> R {
        let left = (-(speed / self.parameters.speed)).exp();
        scaled(self.rise(), left / self.parameters.speed)
    }
}
