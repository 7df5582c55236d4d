//! Rate and state: steady, and with its age over time.

use super::super::parameter::{FitParameter, Range};
use super::form::{Form, around, log_between, parameter};
use super::guess::Guess;
use super::record::Memory;
use super::steady::Curve;
use tribos_core::law::{
    AgeingLaw, LocalLaw, RateState, RateStateParameters, StateEvolution, StateVariable,
    SteadyRateState,
};

pub(super) const PARAMETERS: &[FitParameter] = &[
    parameter(
        "mu0",
        "-",
        "coefficient of steady sliding with v0",
        Range::NotNegative,
    ),
    parameter("a", "-", "direct effect of the speed", Range::Positive),
    parameter("b", "-", "effect of the age", Range::Any),
    parameter("v0", "m/s", "reference speed", Range::Positive),
    parameter("eta", "s/m", "viscous term", Range::NotNegative),
    parameter("dc", "m", "memory length", Range::Positive),
];
/// Largest change of an age in one step of its search, in e-folds.
const MOST_FOLDS: f64 = 3.0;
/// The first five describe steady sliding.
const STEADY: usize = 5;

/// The law with these values.
pub(super) fn law<E: StateEvolution>(values: &[f64]) -> Option<RateState<f64, E>> {
    let &[mu, a, b, reference_speed, viscous, ref rest @ ..] = values else {
        return None;
    };
    RateState::new(RateStateParameters {
        mu,
        a,
        b,
        reference_speed,
        viscous,
        // Steady sliding does not depend on the memory length.
        slip_distance: rest.first().copied().unwrap_or(1.0),
    })
    .ok()
}

/// Starts of the parameters of steady sliding.
fn steady_start(guess: &Guess, unit: &[f64]) -> Vec<f64> {
    /// Effects of rate and age to start from, over the coefficient: of rock 0.01 of 0.6.
    const EFFECTS: [f64; 2] = [3e-3, 0.1];
    let mu = 0.5 * (guess.forces[0] + guess.forces[1]);
    vec![
        mu * around(unit[0], 1.2),
        mu * log_between(unit[1], EFFECTS),
        mu * log_between(unit[2], EFFECTS),
        guess.middle_speed(),
        // Of the friction at the largest speed a tenth at most.
        0.1 * unit[4] * guess.forces[1] / guess.speeds[1],
    ]
}

pub(super) fn start(guess: &Guess, unit: &[f64]) -> Vec<f64> {
    let mut start = steady_start(guess, unit);
    start.push(log_between(unit[5], guess.slid));
    start
}

impl Curve for SteadyRateState<f64> {
    const FORM: Form = Form {
        parameters: PARAMETERS.split_at(STEADY).0,
        linear: &["mu0", "b", "eta"],
        ordered: None,
        reference: Some("v0"),
        start: steady_start,
    };

    fn new(values: &[f64]) -> Option<Self> {
        Some(law::<AgeingLaw>(values)?.steady())
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        LocalLaw::friction(self, speed)
    }
}

impl<E: StateEvolution + Send + Sync + 'static> Memory for RateState<f64, E> {
    const FORM: Form = Form {
        parameters: PARAMETERS,
        linear: &["mu0", "a", "b", "eta"],
        ordered: None,
        reference: Some("v0"),
        start,
    };
    const FORGETS: bool = false;
    const BEGINS_STEADY: bool = true;
    type State = StateVariable<f64>;

    fn new(values: &[f64]) -> Option<Self> {
        law(values)
    }

    fn first(&self, velocity: f64, _: f64) -> StateVariable<f64> {
        self.steady_age(velocity)
    }

    // By e-folds.
    fn shifted(&self, state: StateVariable<f64>, _: usize, share: f64) -> StateVariable<f64> {
        let theta = state.theta * libm::exp(share.clamp(-MOST_FOLDS, MOST_FOLDS));
        StateVariable { theta }
    }

    fn advance(&self, state: StateVariable<f64>, velocity: f64, dt: f64) -> StateVariable<f64> {
        RateState::advance(self, state, velocity, dt)
    }

    fn friction(&self, state: StateVariable<f64>, velocity: f64) -> f64 {
        self.coefficient(velocity, state)
    }
}
