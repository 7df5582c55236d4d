//! Laws of friction as models of data: the kernel's own, and those of the trades beside them.

mod beginning;
mod bristles;
mod course;
mod curves;
mod elements;
mod form;
mod guess;
mod rate_state;
mod record;
mod spring;
mod steady;

use super::apparatus::{Apparatus, Mounted};
use super::error::FitError;
use super::estimate::Fit;
use super::parameter::Model;
use super::{Measurements, Motion};
use crate::stick::spring::StateEvolutionKind;
use record::Record;
use std::str::FromStr;
use steady::Steady;
use tribos_core::law::{AgeingLaw, LuGre, RateState, SlipLaw, SteadyRateState};
use tribos_friction::FrictionError;

/// A law that can be fitted.
///
/// ```
/// use tribos::fit::FitLaw;
/// assert_eq!("lugre".parse(), Ok(FitLaw::LuGre));
/// assert!(FitLaw::Dahl.has_memory() && !FitLaw::Stribeck.has_memory());
/// for (law, name, _) in FitLaw::ALL {
///     assert_eq!((name.parse(), law.name()), (Ok(law), name));
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitLaw {
    /// A constant coefficient.
    Coulomb,
    /// Coulomb friction with a viscous term.
    Viscous,
    /// Boundary and hydrodynamic lubrication.
    Stribeck,
    /// Friction without a jump at rest, by a hyperbolic tangent.
    Tanh,
    /// Friction without a jump at rest, by an arc tangent.
    Arctan,
    /// Friction that rises with the speed and levels off.
    Rising,
    /// A power of the speed.
    Power,
    /// Friction over the load, with an intercept.
    Amontons,
    /// A spring that yields.
    ElasticPlastic,
    /// Bristles that yield as they bend.
    Dahl,
    /// Bristles that first only bend.
    ElastoPlastic,
    /// Bristles with a Stribeck curve; steady, or over time with their deflection.
    LuGre,
    /// Three springs that yield one after the other.
    Maxwell,
    /// Rate and state with the ageing law of Dieterich; steady, or over time with its age.
    RateState,
    /// Rate and state with the slip law of Ruina; in steady sliding it equals `RateState`.
    RateStateSlip,
}

impl FitLaw {
    /// All laws that can be fitted, each with its name and what is fitted.
    pub const ALL: [(Self, &'static str, &'static str); 15] = [
        (Self::Coulomb, "coulomb", "A constant coefficient: mu"),
        (
            Self::Viscous,
            "viscous",
            "Coulomb friction with a viscous term: mu, k",
        ),
        (
            Self::Stribeck,
            "stribeck",
            "Boundary, then hydrodynamic lubrication: mu_s, mu_d, vs, delta, k",
        ),
        (
            Self::Tanh,
            "tanh",
            "No jump at rest, as in simulators: mu, vt",
        ),
        (Self::Arctan, "arctan", "The same by an arc tangent: mu, vt"),
        (
            Self::Rising,
            "rising",
            "Rising and saturating, as of PTFE: mu_s, mu_f, vr",
        ),
        (Self::Power, "power", "A power of the speed: gamma, alpha"),
        (
            Self::Amontons,
            "amontons",
            "Friction over the load with an intercept: mu, adhesion; needs a column of loads",
        ),
        (
            Self::ElasticPlastic,
            "elastic-plastic",
            "A spring that yields: fc, s0; over time",
        ),
        (
            Self::Dahl,
            "dahl",
            "Bristles that yield as they bend: fc, s0; over time",
        ),
        (
            Self::ElastoPlastic,
            "elasto-plastic",
            "Bristles that first only bend: fc, fs, vs, s2, s0, s1, zba; over time",
        ),
        (
            Self::LuGre,
            "lugre",
            "Bristles: fc, fs, vs, s2; over time s0 and s1 as well",
        ),
        (
            Self::Maxwell,
            "maxwell",
            "Three springs that yield one after the other: k1, f1 to k3, f3; over time",
        ),
        (
            Self::RateState,
            "rate-state",
            "Rate and state, ageing law: mu0, a, b, eta at a reference v0; over time dc as well",
        ),
        (
            Self::RateStateSlip,
            "rate-state-slip",
            "The same with the slip law",
        ),
    ];

    /// Name of the law.
    pub fn name(self) -> &'static str {
        let found = Self::ALL.into_iter().find(|(law, ..)| *law == self);
        found.map_or("", |(_, name, _)| name)
    }

    /// Friction as a formula, over time where the law has a memory and a record is fitted.
    pub fn formula(self, is_record: bool) -> &'static str {
        match self {
            Self::Coulomb => "mu",
            Self::Viscous => "mu + k v",
            Self::Stribeck => "mu_d + (mu_s - mu_d) exp(-(v/vs)^delta) + k v",
            Self::Tanh => "mu tanh(v/vt)",
            Self::Arctan => "(2/pi) mu atan(v/vt)",
            Self::Rising => "mu_f - (mu_f - mu_s) exp(-v/vr)",
            Self::Power => "gamma v^alpha",
            Self::Amontons => "mu N + adhesion",
            Self::ElasticPlastic => "s0 z, z' = v as far as |s0 z| <= fc",
            Self::Dahl => "s0 z, z' = v (1 - s0 z sgn(v)/fc)",
            Self::ElastoPlastic => {
                "s0 z + s1 z' + s2 v, z' = v (1 - alpha(z, v) s0 z sgn(v)/g(v)), alpha = 0 below zba"
            }
            Self::LuGre if is_record => {
                "s0 z + s1 z' + s2 v, z' = v - s0 |v| z/g(v), g = fc + (fs - fc) exp(-(v/vs)^2)"
            }
            Self::LuGre => "fc + (fs - fc) exp(-(v/vs)^2) + s2 v",
            Self::Maxwell => "the sum of springs k1, k2, k3 that yield at f1, f2, f3",
            Self::RateState if is_record => {
                "mu0 + a ln(v/v0) + b ln(v0 theta/dc) + eta v, theta' = 1 - v theta/dc"
            }
            Self::RateStateSlip if is_record => {
                "mu0 + a ln(v/v0) + b ln(v0 theta/dc) + eta v, theta' = -(v theta/dc) ln(v theta/dc)"
            }
            Self::RateState | Self::RateStateSlip => "mu0 + (a - b) ln(v/v0) + eta v",
        }
    }

    /// Whether friction depends on the motion before, so that only a record over time shows all of it.
    pub fn has_memory(self) -> bool {
        matches!(
            self,
            Self::ElasticPlastic
                | Self::Dahl
                | Self::ElastoPlastic
                | Self::LuGre
                | Self::Maxwell
                | Self::RateState
                | Self::RateStateSlip
        )
    }

    /// Whether parameters are coefficients of friction, where the others are forces.
    pub fn is_of_coefficient(self) -> bool {
        !self.has_memory() || self.has_age()
    }

    /// Whether fitted parameters are per load: the loads were known, or friction is small enough for a coefficient and no drive is
    /// in the fit.
    pub fn is_per_load(self, data: &Measurements, fit: &Fit) -> bool {
        let is_joint = fit.value("inertia").is_some() || data.is_large();
        data.load().is_some() || (self.is_of_coefficient() && !is_joint)
    }

    /// Whether friction depends on the age of the contact: rate and state.
    pub fn has_age(self) -> bool {
        matches!(self, Self::RateState | Self::RateStateSlip)
    }

    /// Whether friction at rest is unknown to the law, so that points without motion are left out.
    pub fn needs_motion(self) -> bool {
        !self.has_memory() && !matches!(self, Self::Tanh | Self::Arctan)
    }
}

impl FromStr for FitLaw {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let found = Self::ALL.into_iter().find(|(_, name, _)| *name == text);
        found.map(|(law, ..)| law).ok_or_else(|| {
            let names = Self::ALL.map(|(_, name, _)| name);
            let list = format!("there are {}", names.join(", "));
            FrictionError::unknown("law to fit", text, names, list)
        })
    }
}

impl FitLaw {
    /// The law as a model of these data: of the speed alone, or with its state over time.
    ///
    /// Over time the state follows the kernel's exact step through each interval at a mean velocity; it begins as
    /// the first friction says, under rate and state in steady sliding at the first velocity.
    pub fn model(self, data: &Measurements) -> Result<Box<dyn Model + '_>, FitError> {
        self.model_on(data, Apparatus::default())
    }

    /// The same on an apparatus, whose parameters come after those of the law.
    pub fn model_on(
        self,
        data: &Measurements,
        apparatus: Apparatus,
    ) -> Result<Box<dyn Model + '_>, FitError> {
        let law = match (data.motion(), apparatus.spring) {
            (Motion::Series { times, .. }, true) => self.sprung(data, times)?,
            (Motion::Steady { .. }, true) => return Err(FitError::Form(NO_SPRING)),
            (Motion::Series { times, .. }, false) if self.has_memory() => {
                self.over_time(data, times)?
            }
            (_, false) => self.of_speed(data)?,
        };
        Mounted::of(law, data, apparatus)
    }

    /// Friction that depends on the speed alone.
    fn of_speed(self, data: &Measurements) -> Result<Box<dyn Model + '_>, FitError> {
        const STATES: &str =
            "this law is one of the motion before: give a record over time, with a column t";
        const LOADS: &str =
            "Amontons' law needs a column of loads that differ: --columns load=NAME";
        if self.needs_motion()
            && let Some(point) = data.velocities().iter().position(|v| *v == 0.0)
        {
            let message = "at rest friction is not that of sliding: leave this point out".into();
            return Err(FitError::Point { point, message });
        }
        Ok(match self {
            Self::Coulomb => Box::new(Steady::<curves::Coulomb>::new(data)),
            Self::Viscous => Box::new(Steady::<curves::Viscous>::new(data)),
            Self::Stribeck => Box::new(Steady::<curves::StribeckCurve>::new(data)),
            Self::Tanh => Box::new(Steady::<curves::Tanh>::new(data)),
            Self::Arctan => Box::new(Steady::<curves::Arctan>::new(data)),
            Self::Rising => Box::new(Steady::<curves::Rising>::new(data)),
            Self::Power => Box::new(Steady::<curves::Power>::new(data)),
            Self::Amontons if data.load().is_some() => {
                Box::new(Steady::<curves::Amontons>::new(data))
            }
            Self::Amontons => return Err(FitError::Form(LOADS)),
            Self::LuGre => Box::new(Steady::<curves::SteadyLuGre>::new(data)),
            Self::RateState | Self::RateStateSlip => {
                forward(data.velocities())?;
                Box::new(Steady::<SteadyRateState<f64>>::new(data))
            }
            Self::ElasticPlastic | Self::Dahl | Self::ElastoPlastic | Self::Maxwell => {
                return Err(FitError::Form(STATES));
            }
        })
    }

    /// Friction with its state over time.
    fn over_time<'a>(
        self,
        data: &'a Measurements,
        times: &'a [f64],
    ) -> Result<Box<dyn Model + 'a>, FitError> {
        Ok(match self {
            Self::ElasticPlastic => Box::new(Record::<elements::ElasticPlastic>::new(data, times)),
            Self::Dahl => Box::new(Record::<bristles::Dahl>::new(data, times)),
            Self::ElastoPlastic => Box::new(Record::<bristles::ElastoPlastic>::new(data, times)),
            Self::LuGre => Box::new(Record::<LuGre<f64>>::new(data, times)),
            Self::Maxwell => Box::new(Record::<elements::Maxwell>::new(data, times)),
            Self::RateState => {
                forward(data.velocities())?;
                Box::new(Record::<RateState<f64, AgeingLaw>>::new(data, times))
            }
            Self::RateStateSlip => {
                forward(data.velocities())?;
                Box::new(Record::<RateState<f64, SlipLaw>>::new(data, times))
            }
            _ => return self.of_speed(data),
        })
    }

    /// Rate and state on a spring.
    fn sprung<'a>(
        self,
        data: &'a Measurements,
        times: &'a [f64],
    ) -> Result<Box<dyn Model + 'a>, FitError> {
        let ages = match self {
            Self::RateState => StateEvolutionKind::Ageing,
            Self::RateStateSlip => StateEvolutionKind::Slip,
            _ => return Err(FitError::Form(NO_SPRING)),
        };
        Ok(Box::new(spring::Sprung::new(data, times, ages)?))
    }
}

/// The machine's spring counts where friction has a memory of its own.
const NO_SPRING: &str = "a spring belongs to a record over time under rate-state or rate-state-slip; leave --spring out";

/// Refuses backward motion and a start at rest, for which the age is unknown.
fn forward(velocities: &[f64]) -> Result<(), FitError> {
    let refused = |point: usize, message: &str| FitError::Point {
        point,
        message: message.into(),
    };
    if velocities.first().is_some_and(|v| *v <= 0.0) {
        let message = "rate and state begins in steady sliding: the first velocity must be > 0";
        return Err(refused(0, message));
    }
    velocities
        .iter()
        .position(|v| *v < 0.0)
        .map_or(Ok(()), |point| {
            let message = "rate and state knows no way back: velocities must be >= 0; smooth them, or give the set speed";
            Err(refused(point, message))
        })
}
