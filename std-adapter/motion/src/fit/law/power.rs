//! The power law γ|v|^α.

use super::super::Measurements;
use super::super::parameter::{FitParameter, Model, Range};
use super::{between, geometric_mean, picked, steady};
use std::borrow::Cow;
use tribos_core::law::PowerLaw;

const PARAMETERS: [FitParameter; 2] = [
    FitParameter {
        name: "gamma",
        unit: "(s/m)^alpha",
        meaning: "coefficient",
        range: Range::Positive,
    },
    FitParameter {
        name: "alpha",
        unit: "-",
        meaning: "exponent",
        range: Range::Between {
            above: -1.0,
            up_to: PowerLaw::<f64>::MAX_EXPONENT,
        },
    },
];
/// Exponents to start from.
const EXPONENTS: [f64; 2] = [-0.9, 3.0];

/// Steady friction.
pub(super) struct Steady<'a> {
    speeds: Cow<'a, [f64]>,
    /// Geometric means of the extremes.
    middle: [f64; 2],
}

impl<'a> Steady<'a> {
    pub fn new(data: &Measurements, speeds: &'a [f64]) -> Self {
        Self {
            speeds: Cow::Borrowed(speeds),
            middle: [data.speeds(), data.forces()].map(geometric_mean),
        }
    }
}

impl Model for Steady<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS
    }

    fn reference(&self, _: usize) -> Option<f64> {
        None
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = PowerLaw::new(values[1], values[0]).ok()?;
        Some(steady(&law, &self.speeds))
    }

    /// Curves through the middle of the data.
    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let alpha = between(unit[1], EXPONENTS);
        let [speed, force] = self.middle;
        let gamma = force / libm::pow(speed, alpha);
        vec![gamma * (0.5 + unit[0]), alpha]
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Steady {
            speeds: Cow::Owned(picked(&self.speeds, points)),
            middle: self.middle,
        }))
    }
}
