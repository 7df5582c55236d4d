//! A fit: several searches, the best minimum, and how sure its parameters are.

use super::covariance::certainty;
use super::jacobian::Length;
use super::minimise::{Minimum, Problem, free, minimise};
use super::parameter::{Model, Parameter, Range};
use super::starts::halton;
use super::{Data, DataError};
use nalgebra::DMatrix;

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Parameters that keep these values.
    pub fixed: Vec<(String, f64)>,
    /// Number of starts, at least 1.
    pub starts: usize,
}

impl Default for Options {
    /// Nothing fixed, 16 starts.
    fn default() -> Self {
        Self {
            fixed: Vec::new(),
            starts: 16,
        }
    }
}

/// How a parameter is known.
#[derive(Clone, Debug, PartialEq)]
pub enum Known {
    /// From the data, with this standard error.
    StandardError(f64),
    /// It was fixed.
    Fixed,
    /// It is as small or as large as it may be.
    AtBound,
    /// The data determine only a combination with these others; with none, they say nothing of it.
    Undetermined(Vec<&'static str>),
}

/// One parameter of the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Which one.
    pub parameter: Parameter,
    /// Its value.
    pub value: f64,
    /// How it is known.
    pub known: Known,
}

/// A fitted model.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// All parameters, in the order of the model.
    pub parameters: Vec<Estimate>,
    /// Covariance of those with a standard error, in their order.
    pub covariance: DMatrix<f64>,
    /// Predicted friction of each point.
    pub predictions: Vec<f64>,
    /// Σ ((data − prediction)/σ)², with σ = 1 where it is not known.
    pub cost: f64,
    /// Points less parameters that were sought.
    pub freedoms: usize,
    /// Whether standard deviations of the points were known.
    pub is_weighted: bool,
    /// Whether the best search came to its end: nothing but rounding was left to gain.
    pub converged: bool,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// How many of them ended at the best minimum.
    pub at_best: usize,
    /// Steps of the best search.
    pub iterations: usize,
}

/// Why there is no fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A measurement.
    #[error(transparent)]
    Data(#[from] DataError),
    /// A parameter that the law does not have.
    #[error("there is no parameter `{name}`; the parameters are {}", known.join(", "))]
    NoParameter {
        /// What was given.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
    /// A fixed value out of its range.
    #[error("`{name}` must be {range}, not {given}")]
    Range {
        /// Which one.
        name: &'static str,
        /// What it may be.
        range: String,
        /// What was given.
        given: f64,
    },
    /// Fewer points than parameters.
    #[error(
        "{points} points cannot determine {free} parameters with an error; give more points or fix \
         parameters"
    )]
    TooFew {
        /// Points.
        points: usize,
        /// Parameters that are sought.
        free: usize,
    },
    /// All parameters are fixed.
    #[error("all parameters are fixed; nothing is left to fit")]
    NothingFree,
    /// The law refuses every start.
    #[error("the law refuses every start; check the fixed values against each other")]
    NoStart,
    /// A law without a form for such data.
    #[error("{0}")]
    Form(&'static str),
}

/// Costs that differ relatively by less belong to the same minimum.
const SAME: f64 = 1e-6;

/// Fits the model to the data.
pub fn fit(model: &dyn Model, data: &Data, options: &Options) -> Result<Fit, FitError> {
    let weights: Vec<f64> = match data.sigma() {
        Some(sigma) => sigma.iter().map(|s| 1.0 / s).collect(),
        None => vec![1.0; data.friction().len()],
    };
    let fixed = fixed(model, &options.fixed)?;
    let found = search(model, (data.friction(), &weights), &fixed, options.starts)?;
    Ok(found.judged(model, &weights, data.sigma().is_some(), &fixed))
}

/// Values of the parameters that are not sought.
fn fixed(model: &dyn Model, given: &[(String, f64)]) -> Result<Vec<Option<f64>>, FitError> {
    let all = model.parameters();
    let mut fixed: Vec<_> = (0..all.len()).map(|j| model.reference(j)).collect();
    for (name, value) in given {
        let Some(j) = all.iter().position(|parameter| parameter.name == name) else {
            return Err(FitError::NoParameter {
                name: name.clone(),
                known: all.iter().map(|parameter| parameter.name).collect(),
            });
        };
        if !all[j].range.admits(*value) {
            return Err(FitError::Range {
                name: all[j].name,
                range: all[j].range.describe(),
                given: *value,
            });
        }
        fixed[j] = Some(*value);
    }
    Ok(fixed)
}

/// The best of several searches.
struct Search {
    best: Minimum,
    bounds: Vec<[f64; 2]>,
    lengths: Vec<Length>,
    /// √Σ (data/σ)²
    length: f64,
    starts: usize,
    at_best: usize,
}

fn search(
    model: &dyn Model,
    (measured, weights): (&[f64], &[f64]),
    fixed: &[Option<f64>],
    starts: usize,
) -> Result<Search, FitError> {
    let all = model.parameters();
    let sought: Vec<usize> = (0..all.len()).filter(|&j| fixed[j].is_none()).collect();
    if sought.is_empty() {
        return Err(FitError::NothingFree);
    }
    if measured.len() <= sought.len() {
        return Err(FitError::TooFew {
            points: measured.len(),
            free: sought.len(),
        });
    }
    let values = |q: &[f64]| whole(model, fixed, &sought, q);
    let residuals = |q: &[f64]| {
        let predicted = model.predict(&values(q))?;
        let pairs = measured.iter().zip(&predicted).zip(weights);
        Some(pairs.map(|((f, p), w)| (p - f) * w).collect())
    };
    let is_free: Vec<bool> = fixed.iter().map(Option::is_none).collect();
    let repair = |q: &mut [f64]| {
        let mut all_values = values(q);
        let before = all_values.clone();
        model.repair(&mut all_values, &is_free);
        for (x, &j) in q.iter_mut().zip(&sought) {
            // Untouched coordinates keep their bits.
            if all_values[j] != before[j] {
                *x = all[j].range.coordinate(all_values[j]);
            }
        }
    };
    let points: Vec<Vec<f64>> = (0..starts.max(1))
        .map(|index| {
            let start = model.start(&halton(index, all.len()));
            sought
                .iter()
                .map(|&j| all[j].range.coordinate(start[j]))
                .collect()
        })
        .collect();
    let weighted = measured.iter().zip(weights).map(|(f, w)| f * w);
    let length = weighted.map(|x| x * x).sum::<f64>().sqrt();
    let problem = Problem {
        residuals: &residuals,
        repair: &repair,
        bounds: sought.iter().map(|&j| all[j].range.bounds()).collect(),
        lengths: lengths(all, &sought, &points),
        floor: (f64::EPSILON * length).powi(2),
    };
    let ends: Vec<Minimum> = points
        .iter()
        .filter_map(|point| minimise(&problem, point))
        .collect();
    let best = ends
        .iter()
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
        .ok_or(FitError::NoStart)?
        .clone();
    let limit = best.cost * (1.0 + SAME) + problem.floor;
    Ok(Search {
        starts: ends.len(),
        at_best: ends.iter().filter(|end| end.cost <= limit).count(),
        bounds: problem.bounds,
        lengths: problem.lengths,
        length,
        best,
    })
}

/// All values from the coordinates of those that are sought.
fn whole(model: &dyn Model, fixed: &[Option<f64>], sought: &[usize], q: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = fixed
        .iter()
        .map(|value| value.unwrap_or(f64::NAN))
        .collect();
    for (&j, &x) in sought.iter().zip(q) {
        values[j] = model.parameters()[j].range.value(x);
    }
    values
}

/// Over which lengths predictions change: of what has no logarithm, a thousandth of the largest start
/// at least, as it may come near zero.
fn lengths(all: &[Parameter], sought: &[usize], points: &[Vec<f64>]) -> Vec<Length> {
    const SHARE: f64 = 1e-3;
    let largest = |k: usize| {
        points
            .iter()
            .map(|point| point[k].abs())
            .fold(0.0, f64::max)
    };
    let length = |(k, &j): (usize, &usize)| match all[j].range {
        Range::Positive => Length::Fold,
        _ if largest(k) > 0.0 => Length::Own {
            least: SHARE * largest(k),
        },
        _ => Length::Own { least: SHARE },
    };
    sought.iter().enumerate().map(length).collect()
}

impl Search {
    /// Standard errors at the best minimum.
    fn judged(
        self,
        model: &dyn Model,
        weights: &[f64],
        is_weighted: bool,
        fixed: &[Option<f64>],
    ) -> Fit {
        let all = model.parameters();
        let sought: Vec<usize> = (0..all.len()).filter(|&j| fixed[j].is_none()).collect();
        let best = &self.best;
        let values = whole(model, fixed, &sought, &best.q);
        let gradient: Vec<f64> = best
            .jacobian
            .column_iter()
            .map(|column| column.iter().zip(&best.residuals).map(|(a, b)| a * b).sum())
            .collect();
        // Coordinates at a bound have no error of their own.
        let inside = free(&best.q, &self.bounds, &gradient);
        let columns = DMatrix::from_fn(best.residuals.len(), inside.len(), |i, k| {
            best.jacobian[(i, inside[k])]
        });
        let sizes: Vec<f64> = inside.iter().map(|&k| self.lengths[k].least()).collect();
        let certain = certainty(&columns, &sizes, self.length);
        let freedoms = best.residuals.len() - sought.len();
        // Without known deviations the residuals tell how large they are.
        let variance = if is_weighted {
            1.0
        } else {
            best.cost / freedoms as f64
        };

        let mut known = vec![Known::Fixed; all.len()];
        for &j in &sought {
            known[j] = Known::AtBound;
        }
        let name = |k: usize| all[sought[inside[k]]].name;
        let mut determined = Vec::new();
        for (k, &coordinate) in inside.iter().enumerate() {
            let j = sought[coordinate];
            let loose = certain.loose.iter().filter(|group| group.contains(&k));
            let mut others: Vec<_> = loose
                .clone()
                .flatten()
                .filter(|&&other| other != k)
                .map(|&k| name(k))
                .collect();
            others.dedup();
            known[j] = if loose.count() > 0 {
                Known::Undetermined(others)
            } else {
                determined.push((k, j));
                let slope = all[j].range.derivative(values[j]);
                Known::StandardError((certain.covariance[(k, k)] * variance).sqrt() * slope)
            };
        }
        let slope = |j: usize| all[j].range.derivative(values[j]);
        let covariance = DMatrix::from_fn(determined.len(), determined.len(), |a, b| {
            let ((ka, ja), (kb, jb)) = (determined[a], determined[b]);
            certain.covariance[(ka, kb)] * variance * slope(ja) * slope(jb)
        });
        let estimates = all.iter().zip(&values).zip(known);
        Fit {
            parameters: estimates
                .map(|((parameter, &value), known)| Estimate {
                    parameter: *parameter,
                    value,
                    known,
                })
                .collect(),
            covariance,
            predictions: model
                .predict(&values)
                .unwrap_or_else(|| vec![f64::NAN; weights.len()]),
            cost: best.cost,
            freedoms,
            is_weighted,
            converged: best.converged,
            starts: self.starts,
            at_best: self.at_best,
            iterations: best.iterations,
        }
    }
}

impl Fit {
    /// The value of a parameter.
    pub fn value(&self, name: &str) -> Option<f64> {
        let mut all = self.parameters.iter();
        all.find(|estimate| estimate.parameter.name == name)
            .map(|estimate| estimate.value)
    }

    /// Parameters with a standard error, in the order of the covariance.
    pub fn determined(&self) -> impl Iterator<Item = &Estimate> {
        let all = self.parameters.iter();
        all.filter(|estimate| matches!(estimate.known, Known::StandardError(_)))
    }

    /// √(cost/freedoms): the residuals' standard deviation, or with known deviations the square root
    /// of the reduced χ².
    pub fn deviation(&self) -> f64 {
        (self.cost / self.freedoms as f64).sqrt()
    }

    /// Correlation of two parameters of the covariance; 0 where an error is 0.
    pub fn correlation(&self, a: usize, b: usize) -> f64 {
        let c = &self.covariance;
        let scale = (c[(a, a)] * c[(b, b)]).sqrt();
        if scale > 0.0 { c[(a, b)] / scale } else { 0.0 }
    }
}
