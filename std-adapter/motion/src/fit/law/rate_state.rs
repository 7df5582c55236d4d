//! Rate and state: steady, and with its age over time.

use super::super::Measurements;
use super::super::error::FitError;
use super::super::parameter::{FitParameter, Model, Range};
use super::{
    DataRange, Interval, between, distances, intervals, log_between, merged, picked, steady,
};
use std::borrow::Cow;
use std::marker::PhantomData;
use tribos_core::law::{RateState, RateStateParameters, StateEvolution};

const PARAMETERS: [FitParameter; 6] = [
    FitParameter {
        name: "mu0",
        unit: "-",
        meaning: "coefficient of steady sliding with v0",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "a",
        unit: "-",
        meaning: "direct effect of the speed",
        range: Range::Positive,
    },
    FitParameter {
        name: "b",
        unit: "-",
        meaning: "effect of the age",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "v0",
        unit: "m/s",
        meaning: "reference speed",
        range: Range::Positive,
    },
    FitParameter {
        name: "eta",
        unit: "s/m",
        meaning: "viscous term",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "dc",
        unit: "m",
        meaning: "memory length",
        range: Range::Positive,
    },
];
/// The first five describe steady sliding.
const STEADY: usize = 5;
/// Index of v₀, which only defines the speed to which μ₀ belongs.
const REFERENCE: usize = 3;
/// Effects of rate and age to start from, over the coefficient: of rock 0.01 of 0.6.
const EFFECTS: [f64; 2] = [3e-3, 0.1];

fn law<E: StateEvolution>(values: &[f64]) -> Option<RateState<f64, E>> {
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
fn steady_start(unit: &[f64], scales: &DataRange) -> Vec<f64> {
    let mu = between(unit[0], scales.forces);
    vec![
        mu,
        mu * log_between(unit[1], EFFECTS),
        mu * log_between(unit[2], EFFECTS),
        scales.middle_speed(),
        // Of the friction at the largest speed a tenth at most.
        0.1 * unit[4] * scales.forces[1] / scales.speeds[1],
    ]
}

/// Steady friction.
pub(super) struct Steady<'a> {
    pub speeds: Cow<'a, [f64]>,
    pub scales: DataRange,
}

impl Model for Steady<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS[..STEADY]
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        (parameter == REFERENCE).then_some(self.scales.middle_speed())
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = law::<tribos_core::law::AgeingLaw>(values)?.steady();
        Some(steady(&law, &self.speeds))
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        steady_start(unit, &self.scales)
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Steady {
            speeds: Cow::Owned(picked(&self.speeds, points)),
            scales: self.scales,
        }))
    }
}

/// A record over time.
pub(super) struct Series<'a, E> {
    velocities: Cow<'a, [f64]>,
    intervals: Vec<Interval>,
    scales: DataRange,
    slid: [f64; 2],
    evolution: PhantomData<E>,
}

impl<'a, E: StateEvolution> Series<'a, E> {
    /// Refuses backward motion and a start at rest, for which the age is unknown.
    pub fn new(
        data: &Measurements,
        times: &'a [f64],
        velocities: &'a [f64],
    ) -> Result<Self, FitError> {
        if velocities.first().is_some_and(|v| *v <= 0.0) {
            let message = "rate and state begins in steady sliding: the first velocity must be > 0";
            return Err(refused(0, message));
        }
        if let Some(point) = velocities.iter().position(|v| *v < 0.0) {
            return Err(refused(
                point,
                "rate and state knows no way back: velocities must be >= 0",
            ));
        }
        let intervals = intervals(times, velocities);
        Ok(Self {
            scales: DataRange::of(data),
            slid: distances(&intervals),
            velocities: Cow::Borrowed(velocities),
            intervals,
            evolution: PhantomData,
        })
    }
}

fn refused(point: usize, message: &str) -> FitError {
    FitError::Point {
        point,
        message: message.into(),
    }
}

impl<E: StateEvolution + 'static> Model for Series<'_, E> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        (parameter == REFERENCE).then_some(self.scales.middle_speed())
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = law::<E>(values)?;
        let first = *self.velocities.first()?;
        let mut age = law.steady_age(first);
        let mut friction = vec![law.coefficient(first, age)];
        for (&(dt, mean), &velocity) in self.intervals.iter().zip(&self.velocities[1..]) {
            age = law.advance(age, mean, dt);
            friction.push(law.coefficient(velocity, age));
        }
        Some(friction)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let mut start = steady_start(unit, &self.scales);
        start.push(log_between(unit[5], self.slid));
        start
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Series::<E> {
            velocities: Cow::Owned(picked(&self.velocities, points)),
            intervals: merged(&self.intervals, points),
            scales: self.scales,
            slid: self.slid,
            evolution: PhantomData,
        }))
    }
}
