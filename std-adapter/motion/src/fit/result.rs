//! From a minimum to a result: errors, intervals, and what to be careful of.

use super::caution::{Caution, cautions};
use super::data::Measurements;
use super::error::FitError;
use super::estimate::{Estimate, Fit};
use super::hints::hints;
use super::interval::{Profile, Profiled, student};
use super::jacobian::Order;
use super::linearised::Linearised;
use super::minimise::Minimum;
use super::parameter::Range;
use super::refine::{Paths, Refined};
use super::residual_tests::{ResidualTests, residual_tests};
use super::search::{Search, problem};
use super::standard_errors::Certainties;
use super::unknowns::Unknowns;

/// Steps of a record, times free parameters, up to which intervals come from profiles: beyond, errors are so small that
/// the law is linear within them.
const MOST_PROFILED: usize = 1_000_000;
/// Probability of the residuals' runs below which correlation over time enlarges the errors.
pub(super) const CORRELATED: f64 = 1e-4;

/// A result, or a smaller sum of squares that its intervals came upon.
pub(super) enum Certified {
    /// The result.
    Fit(Box<Fit>),
    /// Coordinates from which to search on.
    Lower(Vec<f64>),
}

impl Certified {
    /// The best of the refined minima with its certainty; the last one is not searched on.
    pub fn of(
        paths: &Paths<'_, '_>,
        search: &Search,
        refined: &Refined<'_>,
        is_last: bool,
    ) -> Result<Self, FitError> {
        let model = refined.model.as_deref().unwrap_or(paths.model);
        let unknowns = paths.unknowns.with(model);
        let (best, at_best) = refined.minima.first().ok_or(FitError::NoStart)?;
        let residuals = |q: &[f64]| paths.target.residuals(&unknowns, q);
        let problem = problem(&residuals, &unknowns, paths.target, paths.lengths);
        let values = unknowns.values(&best.q);
        let (data, unit) = (paths.data, paths.target.unit);
        let left = residuals(&best.q).ok_or(FitError::NoStart)?;
        let tests = data.times().and_then(|_| residual_tests(&left, None));
        let tests = tests.map(|tests| with_drift_along(tests, data, &left));
        let factor = tests.as_ref().map_or(1.0, growth);
        let points = left.len();
        drop(left);
        // Far out wider differences may leave the law's domain.
        let at = Linearised::at(&problem, &best.q, Order::finest(points))
            .or_else(|| Linearised::at(&problem, &best.q, Order::Second))
            .ok_or(FitError::NoStart)?;
        let freedoms = points - unknowns.sought.len();
        let own = at.deviation();
        // Without known deviations their size is estimated from the residuals.
        let (deviation, quantile) = match data.sigma() {
            Some(_) => (unit, student(f64::INFINITY)),
            None => (own, student(freedoms as f64 / (factor * factor))),
        };
        let certain = Certainties::of(&at, &unknowns, &values, deviation * factor);
        drop(at);
        let deviation = deviation * factor;
        let profile = |minimum: &Minimum| Profile {
            unknowns: &unknowns,
            target: paths.target,
            lengths: paths.lengths,
            values: unknowns.values(&minimum.q),
            cost: best.cost,
            above: minimum.cost - best.cost,
            deviation,
            quantile,
            grown: grown(&unknowns, &minimum.q),
        };
        let mut converged = best.converged;
        let steps = points * refined.path.steps as usize * unknowns.sought.len();
        let linear = || profile(best).linear(&certain.known);
        let intervals = if steps > MOST_PROFILED || best.cost <= problem.floor {
            linear()
        } else {
            let most = best.cost + quantile * quantile * deviation * deviation;
            let alike = refined.minima.iter().filter(|(end, _)| end.cost <= most);
            let mut joined: Option<Vec<[f64; 2]>> = None;
            for (minimum, _) in alike {
                match profile(minimum).intervals(&certain.known) {
                    Profiled::Intervals(own) => joined = Some(union(joined, own)),
                    Profiled::Lower(_) if is_last => converged = false,
                    Profiled::Lower(lower) => {
                        return Ok(Self::Lower(unknowns.coordinates(&lower)));
                    }
                }
            }
            joined.unwrap_or_else(linear)
        };
        let parameters = unknowns.model.parameters().iter();
        let parameters = parameters.enumerate().map(|(j, parameter)| Estimate {
            parameter: *parameter,
            value: values[j],
            known: certain.known[j].clone(),
            interval: intervals[j].map(unbounded),
        });
        let nothing = || vec![f64::NAN; points];
        let mut fit = Fit {
            parameters: parameters.collect(),
            covariance: certain.covariance,
            predictions: model.predict(&values).unwrap_or_else(nothing),
            cost: best.cost / unit / unit,
            deviation: own / unit,
            freedoms,
            is_weighted: data.sigma().is_some(),
            converged,
            starts: search.starts,
            at_best: *at_best,
            iterations: best.iterations,
            searched: search.searched,
            error_factor: factor,
            cautions: Vec::new(),
            path: refined.path,
        };
        let name = |shift: super::refine::Shift| {
            let name = fit.parameters[shift.parameter].parameter.name;
            (name, shift.change, shift.errors)
        };
        let left = [refined.by_steps.map(name), refined.by_course.map(name)];
        let mut all: Vec<Caution> = cautions(&fit, tests.as_ref(), left);
        let left = data.friction().iter().zip(&fit.predictions);
        let left: Vec<f64> = left.map(|(f, p)| f - p).collect();
        let has = |name: &str| fit.parameters.iter().any(|e| e.parameter.name == name);
        all.extend(hints(data, &left, factor, has));
        fit.cautions = all;
        Ok(Self::Fit(Box::new(fit)))
    }
}

/// Values at a minimum with the positive parameters that are as good as zero at the size of a first guess.
fn grown(unknowns: &Unknowns<'_>, q: &[f64]) -> Option<Vec<f64>> {
    /// Share of the size.
    const NOTHING: f64 = 1e-3;
    let model = unknowns.model;
    let mut values = unknowns.values(q);
    let usual = model.start(&vec![0.5; values.len()]);
    let is_nothing = |j: &usize| {
        let is_positive = model.parameters()[*j].range == Range::Positive;
        is_positive && model.above(*j).is_none() && values[*j] < NOTHING * usual[*j]
    };
    let all: Vec<usize> = unknowns.sought.iter().copied().filter(is_nothing).collect();
    for &j in &all {
        values[j] = usual[j];
    }
    (!all.is_empty()).then_some(values)
}

/// The shortest intervals that include both, of all parameters.
fn union(some: Option<Vec<[f64; 2]>>, others: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let Some(some) = some else {
        return others;
    };
    let pairs = some.iter().zip(&others);
    pairs
        .map(|([a, b], [low, high])| [a.min(*low), b.max(*high)])
        .collect()
}

/// The tests with the drift of friction where that is clearer than the drift of the force: of a sample that moves to and fro.
fn with_drift_along(tests: ResidualTests, data: &Measurements, residuals: &[f64]) -> ResidualTests {
    let along = residuals.iter().zip(data.velocities());
    let along: Vec<f64> = along.map(|(r, v)| r * v.signum()).collect();
    match residual_tests(&along, None) {
        Some(other) if other.drift_p < tests.drift_p => ResidualTests {
            drift: other.drift,
            drift_z: other.drift_z,
            drift_p: other.drift_p,
            ..tests
        },
        _ => tests,
    }
}

/// An end of an interval at the ends of the numbers that a search may try: the data do not bound it there.
fn unbounded(end: f64) -> f64 {
    /// Logarithms of positive parameters go to ±700.
    const MOST: f64 = 1e290;
    match end {
        x if x.abs() > MOST => f64::INFINITY.copysign(x),
        x if x.abs() < 1.0 / MOST => 0.0,
        x => x,
    }
}

/// Factor of the standard errors for residuals that follow each other.
fn growth(tests: &ResidualTests) -> f64 {
    if tests.runs_p < CORRELATED {
        tests.error_factor.max(1.0)
    } else {
        1.0
    }
}
