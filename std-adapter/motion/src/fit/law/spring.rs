//! Rate and state on the spring of a testing machine: the record holds the motion of the load point.

use super::super::parameter::{Between, FitParameter, Model, Range};
use super::super::{FitError, Measurements};
use super::course::{Interval, merged, velocity_steps};
use super::form::{Form, around, parameter};
use super::guess::Guess;
use super::rate_state;
use crate::stick::spring::{LoadedContact, StateEvolutionKind};
use std::borrow::Cow;
use tribos_core::law::AgeingLaw;

/// Those of rate and state without its viscous term, and the spring.
const PARAMETERS: [FitParameter; 6] = [
    rate_state::PARAMETERS[0],
    rate_state::PARAMETERS[1],
    rate_state::PARAMETERS[2],
    rate_state::PARAMETERS[3],
    rate_state::PARAMETERS[5],
    parameter(
        "spring",
        "1/m",
        "stiffness of the machine, per load",
        Range::Positive,
    ),
];

const FORM: Form = Form {
    parameters: &PARAMETERS,
    linear: &["mu0"],
    ordered: None,
    reference: Some("v0"),
    start: |guess, unit| {
        let start = rate_state::start(guess, &[unit[0], unit[1], unit[2], 0.5, 0.0, unit[4]]);
        let &[mu, a, b, reference, _, dc] = start.as_slice() else {
            return start;
        };
        // A spring that gives way by the memory length changes friction by some a.
        let stiffness = a / dc * around(unit[5], 30.0);
        vec![mu, a, b, reference, dc, stiffness]
    },
};

/// A record of the load point.
pub(super) struct Sprung<'a> {
    times: Cow<'a, [f64]>,
    velocities: Cow<'a, [f64]>,
    means: Option<Vec<Interval>>,
    ages: StateEvolutionKind,
    path: Between,
    guess: Guess,
}

impl<'a> Sprung<'a> {
    /// Refuses a load point that turns back or rests at the start.
    pub fn new(
        data: &'a Measurements,
        times: &'a [f64],
        ages: StateEvolutionKind,
    ) -> Result<Self, FitError> {
        super::forward(data.velocities())?;
        Ok(Self {
            times: Cow::Borrowed(times),
            velocities: Cow::Borrowed(data.velocities()),
            means: None,
            ages,
            path: Between::PLAIN,
            guess: Guess::of(data),
        })
    }
}

impl Model for Sprung<'_> {
    fn parameters(&self) -> &[FitParameter] {
        FORM.parameters
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        FORM.reference(parameter, &self.guess)
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let &[mu, a, b, reference, dc, stiffness] = values else {
            return None;
        };
        let law = rate_state::law::<AgeingLaw>(&[mu, a, b, reference, 0.0, dc])?;
        let first = *self.velocities.first()?;
        let mut contact = LoadedContact::new(*law.parameters(), self.ages, stiffness, first)?;
        let mut friction = vec![contact.friction()];
        for point in 1..self.velocities.len() {
            let mut moved = Some(());
            let mut advance = |dt: f64, mean: f64| {
                moved = moved.and_then(|()| contact.advance(mean, dt));
            };
            match &self.means {
                Some(means) => {
                    let (dt, mean) = means[point - 1];
                    advance(dt, mean);
                }
                None => velocity_steps(&self.times, &self.velocities, point, self.path, advance),
            }
            moved?;
            friction.push(contact.friction());
        }
        Some(friction)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        (FORM.start)(&self.guess, unit)
    }

    fn is_linear(&self, parameter: usize) -> bool {
        FORM.is_linear(parameter)
    }

    fn limits(&self, parameter: usize) -> [f64; 2] {
        FORM.limits(parameter, &self.guess)
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model + '_>> {
        let of = |values: &[f64]| Cow::Owned(points.iter().map(|&i| values[i]).collect());
        Some(Box::new(Sprung {
            times: of(&self.times),
            velocities: of(&self.velocities),
            means: Some(merged(&self.times, &self.velocities, points)),
            ages: self.ages,
            path: self.path,
            guess: self.guess.clone(),
        }))
    }

    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(Sprung {
            times: Cow::Borrowed(&self.times),
            velocities: Cow::Borrowed(&self.velocities),
            means: self.means.clone(),
            ages: self.ages,
            path,
            guess: self.guess.clone(),
        }))
    }
}
