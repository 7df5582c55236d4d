//! Rate-and-state friction of steady sliding: weakening, then strengthening.

use super::LocalLaw;
use super::limits::{ln_ratio, minimum_between, scaled};
use super::rate_state::{RateStateParameters, regularised, transition_speed};
use crate::real::Real;

/// [`RateState`](super::RateState) with the age θ = D_c/V that steady sliding keeps.
///
/// ```text
/// μ(V) = a asinh( V/q ) + η V,     q(V) = 2V₀ exp(−μ₀/a) (V/V₀)^(b/a)
///      ≈ μ₀ − (b − a) ln(V/V₀) + η V      for V ≫ q
/// ```
///
/// For b > a friction falls with the logarithm of the speed (the creep regime) and rises with the
/// speed itself beyond (b − a)/η (the inertial regime). It then diverges like −ln V at rest, which
/// a patch integrates without harm.
///
/// *Units*: as [`RateStateParameters`]. *Source*: Ruina 1983; Heslot et al. 1994, fig. 2.7 of the
/// thesis. *Accuracy*: as [`RateState`](super::RateState).
///
/// ```
/// use tribos_core::law::{AgeingLaw, RateState, RateStateParameters, SteadyRateState};
/// let paper: SteadyRateState<f64> = RateState::<_, AgeingLaw>::new(RateStateParameters {
///     mu: 0.35, a: 0.01, b: 0.03,
///     reference_speed: 1e-6, slip_distance: 1e-6, viscous: 200.0, // m/s, m, s/m
/// })?.steady();
/// let p = paper.parameters();
/// let slowest = (p.b - p.a) / p.viscous; // 1e-4 m/s
/// assert!(paper.minimum().is_some_and(|speed| (speed - slowest).abs() < 1e-12));
/// // Under 10 N softer springs stick and slip; the faster they pull, the softer they may be.
/// assert!((paper.critical_stiffness(10.0) - 2e5).abs() < 1e-6); // N/m
/// assert!((paper.critical_stiffness_at(10.0, slowest / 2.0) - 1e5).abs() < 1e-6);
/// assert!(paper.critical_stiffness_at(10.0, slowest).abs() < 1e-6);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SteadyRateState<R> {
    parameters: RateStateParameters<R>,
}

impl<R: Real> SteadyRateState<R> {
    /// For validated parameters.
    pub(super) fn of(parameters: RateStateParameters<R>) -> Self {
        Self { parameters }
    }

    /// The parameters.
    pub fn parameters(&self) -> &RateStateParameters<R> {
        &self.parameters
    }

    /// Speed of least friction, (b − a)/η as long as V ≫ q there; `None` without weakening (b ≤ a)
    /// or without strengthening (η = 0).
    ///
    /// *Accuracy*: where the computed slope changes sign.
    pub fn minimum(&self) -> Option<R> {
        let p = &self.parameters;
        if p.b <= p.a || p.viscous == R::ZERO {
            return None;
        }
        // The regularisation only weakens the fall: the minimum is not above (b − a)/η, whose
        // double is above its rounding too.
        Some(minimum_between(
            self,
            R::ZERO,
            R::TWO * (p.b - p.a) / p.viscous,
        ))
    }

    /// Stiffness N(b − a)/D_c below which a spring cannot pull a load N steadily: stick-slip. Zero
    /// for b ≤ a.
    ///
    /// *Units*: force/length. *Domain*: slow sliding, ηV ≪ b − a and V ≫ q; inertia left out.
    /// *Source*: Ruina 1983.
    pub fn critical_stiffness(&self, load: R) -> R {
        let p = &self.parameters;
        let weakening = if p.b > p.a { p.b - p.a } else { R::ZERO };
        load * weakening / p.slip_distance
    }

    /// The same at any speed: −(N/D_c) V dμ/dV, negative where friction strengthens and every
    /// spring pulls steadily.
    ///
    /// From θ' and the balance k(V t − x) = Nμ, linear around steady sliding; both evolution laws
    /// give this.
    pub fn critical_stiffness_at(&self, load: R, speed: R) -> R {
        -(load * speed * self.slope(speed)) / self.parameters.slip_distance
    }
}

impl<R: Real> LocalLaw<R> for SteadyRateState<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        let p = &self.parameters;
        // ln(2V/q)
        let log_speed = ln_ratio(speed, p.reference_speed);
        let exponent = scaled(R::ONE - p.b / p.a, log_speed) + p.mu / p.a;
        regularised(p, exponent) + scaled(p.viscous, speed)
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        let p = &self.parameters;
        let strength = p.mu - scaled(p.b, ln_ratio(speed, p.reference_speed));
        // d/dV of asinh(V/q) with q ∝ V^(b/a): (1 − b/a)/√(V² + q²).
        let steepness = R::ONE / speed.hypot(transition_speed(p, strength));
        scaled(p.a - p.b, steepness) + p.viscous
    }
}
