//! Which motion is reported of those that the frames allow, and its parameters.
//!
//! It is that of the least sum of squares, unless the film has no angle and allows a motion without spin. A body without
//! spin slows down nearly as one that spins under a larger coefficient, so that noise alone decides at which ratio of speed
//! to spin the least sum lies, and the coefficient there may be any. Where the sum at no spin is within the rise
//! that ends the interval of the ratio, the frames show no spin, and the simplest motion is reported: that without. Under
//! Coulomb's law its coefficient is about the least that the frames allow, since spin only weakens friction.

use super::super::estimate::{Estimate, Uncertainty};
use super::super::minimise::{Minimum, OFFSET};
use super::super::parameter::Model;
use super::super::unknowns::Unknowns;
use super::errors::Errors;
use super::weighted::Weighted;

/// The ratio v/(|ω|R) that stands for no spin, the last of a search: a rim this slow moves no frame.
const NO_SPIN: f64 = 1e3;

/// The motion that is reported.
pub(super) struct Shown<'a> {
    /// What was sought for it: without spin all but the ratio.
    unknowns: Unknowns<'a>,
    pub minimum: Minimum,
    errors: Errors,
    /// Whether it is the motion without spin.
    pub is_unspun: bool,
}

impl<'a> Shown<'a> {
    /// The motion without spin, searched from one that hardly spins; none where the ratio is not sought.
    pub fn unspun(film: &'a Weighted<'_>, place: &[f64], variance: f64) -> Option<Self> {
        let ratio = film.ratio()?;
        let held = *film.unknowns.sought.get(ratio)?;
        let unknowns = film.unknowns.keeping(held, NO_SPIN);
        let mut start = place.to_vec();
        start.remove(ratio);
        let minimum = film.minimum(&unknowns, &start, OFFSET)?;
        let errors = Errors::of(film, &unknowns, &minimum.q, variance)?;
        Some(Self {
            unknowns,
            minimum,
            errors,
            is_unspun: true,
        })
    }

    /// The motion of the least sum of squares.
    pub fn least(film: &'a Weighted<'_>, best: &Minimum, errors: Errors) -> Self {
        Self {
            unknowns: film.unknowns.with(film.model),
            minimum: best.clone(),
            errors,
            is_unspun: false,
        }
    }

    /// Values of all parameters.
    pub fn values(&self) -> Vec<f64> {
        self.unknowns.values(&self.minimum.q)
    }

    /// All parameters with their intervals, which reach `quantiles` standard errors where the motion is nearly linear; both
    /// are in the order of the film's unknowns.
    pub fn estimates(
        &self,
        film: &Weighted<'_>,
        intervals: &[[f64; 2]],
        quantiles: &[f64],
    ) -> Vec<Estimate> {
        let values = self.values();
        let place = |sought: &[usize], j: usize| sought.iter().position(|&other| other == j);
        let estimate = |(j, (&parameter, &value))| {
            let interval = place(&film.unknowns.sought, j);
            let known = match (interval, place(&self.unknowns.sought, j)) {
                (None, _) => Uncertainty::Fixed,
                (Some(_), None) => Uncertainty::AtBound,
                (Some(k), Some(own)) => {
                    let known = self.errors.known(&self.unknowns, own, &values);
                    if self.is_unspun {
                        widened(known, intervals[k], quantiles[k])
                    } else {
                        known
                    }
                }
            };
            Estimate {
                parameter,
                value,
                known,
                interval: interval.map_or([value; 2], |k| intervals[k]),
            }
        };
        let parameters = film.model.parameters().iter().zip(&values);
        parameters.enumerate().map(estimate).collect()
    }

    /// Pairs of parameters that the frames hardly tell apart, and their correlation.
    pub fn entangled(&self) -> Vec<(&'static str, &'static str, f64)> {
        self.errors.entangled(&self.unknowns)
    }
}

/// The certainty of a parameter at no spin, when spin is possible as well: its standard error is not below that of its
/// interval, and what has no interval on one side has none.
fn widened(known: Uncertainty, [low, high]: [f64; 2], quantile: f64) -> Uncertainty {
    let Uncertainty::StandardError(error) = known else {
        return known;
    };
    let half = 0.5 * (high - low);
    if half.is_finite() {
        Uncertainty::StandardError(error.max(half / quantile))
    } else {
        Uncertainty::Undetermined(vec!["ratio"])
    }
}
