//! Rate and state on the spring of a testing machine: the record holds the motion of the load point.

use super::super::parameter::{Between, FitParameter, Model, Range};
use super::super::{FitError, Measurements};
use super::beginning::after_jump;
use super::course::Motion;
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

/// Change of the instant of a jump for its effect, over the interval: far above the errors of the integration.
const CHANGE: f64 = 0.02;

/// A record of the load point.
pub(super) struct Sprung<'a> {
    motion: Motion<'a>,
    /// Friction as it was measured, per load.
    measured: Cow<'a, [f64]>,
    ages: StateEvolutionKind,
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
            motion: Motion::new(times, data.velocities()),
            measured: data.all_per_load(),
            ages,
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
        let velocities = &self.motion.velocities;
        let first = *velocities.first()?;
        let contact = LoadedContact::new(*law.parameters(), self.ages, stiffness, first)?;
        let moved = |contact: Option<LoadedContact>, [dt, mean]: [f64; 2]| {
            let mut contact = contact?;
            contact.advance(mean, dt).map(|()| contact)
        };
        let advance = |mut contact: Option<LoadedContact>, point: usize| {
            self.motion.steps(point, |dt, mean| {
                contact = moved(contact.take(), [dt, mean]);
            });
            contact
        };
        let misfit = |contact: &Option<LoadedContact>, point: usize| match contact {
            Some(contact) => contact.friction() - self.measured[point],
            None => f64::NAN,
        };
        let mut friction = vec![contact.friction()];
        let mut contact = Some(contact);
        for point in 1..velocities.len() {
            contact = if self.motion.jumps_before(point) {
                let jump = |share: f64| {
                    let mut contact = contact.clone();
                    self.motion.jump(point, share, |dt, velocity| {
                        contact = moved(contact.take(), [dt, velocity]);
                    });
                    contact
                };
                let end = self.motion.next_jump(point, velocities.len());
                let points = ([point, end], CHANGE);
                after_jump(points, &jump, &advance, &misfit)
            } else {
                advance(contact, point)
            };
            friction.push(contact.as_ref()?.friction());
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
        Some(Box::new(Sprung {
            motion: self.motion.at(points, true),
            measured: points.iter().map(|&i| self.measured[i]).collect(),
            ages: self.ages,
            guess: self.guess.clone(),
        }))
    }

    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(Sprung {
            motion: self.motion.along(path),
            measured: Cow::Borrowed(&self.measured),
            ages: self.ages,
            guess: self.guess.clone(),
        }))
    }
}
