//! Rate-and-state friction.

use core::marker::PhantomData;

use super::contact_age::{AgeingLaw, StateEvolution, StateVariable};
use super::error::{finite, not_negative, positive, validated_coefficient};
use super::limits::{ln_ratio, scaled};
use super::{LawError, SteadyRateState};
use crate::real::Real;

/// Parameters of [`RateState`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RateStateParameters<R> {
    /// Coefficient μ₀ of steady sliding with V₀.
    pub mu: R,
    /// Direct effect a of the speed.
    pub a: R,
    /// Effect b of the age, of either sign.
    pub b: R,
    /// Reference speed V₀.
    pub reference_speed: R,
    /// Memory length D_c.
    pub slip_distance: R,
    /// Viscous coefficient η, 0 for none.
    pub viscous: R,
}

/// Regularised rate-and-state friction with evolution law `E`.
///
/// ```text
/// μ(V, θ) = a asinh( V/q ) + η V,     q(θ) = 2V₀ exp(−(μ₀ + b ln(V₀θ/D_c))/a)
///         ≈ μ₀ + a ln(V/V₀) + b ln(V₀θ/D_c) + η V     for V ≫ q
/// ```
///
/// The second line is the original law, which fails at rest; the first vanishes there. The viscous
/// term gives the strengthening, inertial branch that Heslot et al. measured on paper.
///
/// *Units*: V, V₀ in speed, D_c in length, η in 1/speed, the rest dimensionless.
/// *Accuracy*: a few ulp times (μ₀ + b |ln(V₀θ/D_c)|)/a, the size of the exponent, whose rounding it multiplies.
/// *Source*: Dieterich 1979, Ruina 1983; asinh: Rice, Lapusta and Ranjith 2001; thesis 2.3.1.
///
/// ```
/// use tribos_core::law::{LocalLaw, RateState, RateStateParameters, SlipLaw};
/// let rock = RateState::<f64, SlipLaw>::new(RateStateParameters {
///     mu: 0.6, a: 0.010, b: 0.015,
///     reference_speed: 1e-6, slip_distance: 1e-5, viscous: 0.0, // m/s, m
/// })?;
/// let age = rock.steady_age(1e-6);
/// assert!((rock.coefficient(1e-6, age) - 0.6).abs() < 1e-12);
/// let jump = rock.coefficient(1e-5, age); // ten times as fast: up at once, then down
/// let later = rock.coefficient(1e-5, rock.advance(age, 1e-5, 100.0));
/// assert!(jump > 0.6 && later < 0.6);
/// assert!((rock.steady().friction(1e-5) - later).abs() < 1e-12); // after 100 D_c
///
/// // Far above q the original law holds, with the slope a/V.
/// assert!((rock.logarithmic(1e-5, age) - jump).abs() < 1e-12);
/// assert!((rock.slope(1e-5, age) - rock.parameters().a / 1e-5).abs() < 1e-9); // s/m
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RateState<R, E = AgeingLaw> {
    parameters: RateStateParameters<R>,
    evolution: PhantomData<E>,
}

/// ln(2V/q) above which asinh(V/q) = ln(2V/q) to rounding: the next term is e^(−40).
const LOGARITHMIC_FROM: f64 = 20.0;

impl<R: Real, E: StateEvolution> RateState<R, E> {
    /// *Domain*: 0 ≤ μ₀, η < ∞; 0 < a, V₀, D_c < ∞; b finite: below zero an older contact is weaker, as some clays are.
    pub fn new(parameters: RateStateParameters<R>) -> Result<Self, LawError> {
        validated_coefficient(parameters.mu)?;
        positive("direct effect a", parameters.a)?;
        finite("age effect b", parameters.b)?;
        positive("reference speed", parameters.reference_speed)?;
        positive("slip distance", parameters.slip_distance)?;
        not_negative("viscous coefficient", parameters.viscous)?;
        Ok(Self {
            parameters,
            evolution: PhantomData,
        })
    }

    /// The parameters.
    pub fn parameters(&self) -> &RateStateParameters<R> {
        &self.parameters
    }

    /// Friction per load at `speed` ≥ 0. *Special values*: 0 at rest.
    #[inline]
    pub fn coefficient(&self, speed: R, age: StateVariable<R>) -> R {
        let p = &self.parameters;
        let log_speed = ln_ratio(speed, p.reference_speed);
        regularised(p, log_speed + self.strength(age) / p.a) + scaled(p.viscous, speed)
    }

    /// ∂μ/∂V at constant age: a/√(V² + q²) + η.
    #[inline]
    pub fn slope(&self, speed: R, age: StateVariable<R>) -> R {
        let p = &self.parameters;
        p.a / speed.hypot(transition_speed(p, self.strength(age))) + p.viscous
    }

    /// The original law μ₀ + a ln(V/V₀) + b ln(V₀θ/D_c) + ηV.
    ///
    /// *Domain*: V ≫ q; negative below q/2, −∞ at rest.
    #[inline]
    pub fn logarithmic(&self, speed: R, age: StateVariable<R>) -> R {
        let p = &self.parameters;
        let rate = p.a * ln_ratio(speed, p.reference_speed);
        self.strength(age) + rate + scaled(p.viscous, speed)
    }

    /// The age after `dt` at constant `speed`, exact.
    #[must_use]
    #[inline]
    pub fn advance(&self, age: StateVariable<R>, speed: R, dt: R) -> StateVariable<R> {
        StateVariable {
            theta: E::evolved(age.theta, speed, self.parameters.slip_distance, dt),
        }
    }

    /// Age D_c/V of steady sliding.
    #[inline]
    pub fn steady_age(&self, speed: R) -> StateVariable<R> {
        StateVariable {
            theta: self.parameters.slip_distance / speed,
        }
    }

    /// Steady sliding as a law of the speed alone, the same for every evolution law.
    pub fn steady(&self) -> SteadyRateState<R> {
        SteadyRateState::of(self.parameters)
    }

    /// μ₀ + b ln(V₀θ/D_c)
    #[inline]
    fn strength(&self, age: StateVariable<R>) -> R {
        let p = &self.parameters;
        let log_age = ln_ratio(p.reference_speed, p.slip_distance) + age.theta.ln();
        p.mu + scaled(p.b, log_age)
    }
}

/// a asinh(V/q) from ln(2V/q), without overflow of the exponential.
#[inline]
pub(super) fn regularised<R: Real>(p: &RateStateParameters<R>, exponent: R) -> R {
    if exponent > R::from_f64(LOGARITHMIC_FROM) {
        p.a * exponent
    } else {
        p.a * (R::HALF * exponent.exp()).asinh()
    }
}

/// q = 2V₀ e^(−strength/a), below which the regularised law is linear in V.
#[inline]
pub(super) fn transition_speed<R: Real>(p: &RateStateParameters<R>, strength: R) -> R {
    R::TWO * p.reference_speed * (-strength / p.a).exp()
}
