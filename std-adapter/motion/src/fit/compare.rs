//! All laws on the same data: which describes them best, and which they cannot tell apart.

use super::apparatus::Apparatus;
use super::data::Measurements;
use super::error::FitError;
use super::estimate::{Fit, FitOptions, fit_watched};
use super::law::FitLaw;
use super::minimise::minimise;
use super::parameter::{Between, Model};
use super::sample::WeightedData;
use super::search::{FitProgress, problem};
use super::unknowns::Unknowns;

/// A law on data that it shares with others.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The law.
    pub law: FitLaw,
    /// Its fit to all points.
    pub fit: Fit,
    /// Akaike's criterion less that of the best law. Residuals that follow each other count as fewer points.
    pub akaike: f64,
    /// Root mean square of the residuals, over their deviations if these are known, of points that the fit has not seen: in five parts, each
    /// foretold from the other four. NaN where that would take too long.
    pub foretold: f64,
    /// Whether the data tell this law from the best one: Akaike's criterion differs by more than 10, or foretold errors by more
    /// than two standard errors between the parts.
    pub is_told_apart: bool,
    /// Mean square of the foretold residuals of each part.
    parts: Vec<f64>,
}

/// Parts of a cross-validation.
const PARTS: usize = 5;
/// Steps of a record up to which it is done.
const MOST_FORETOLD: usize = 100_000;
/// Difference of Akaike's criterion beyond which a law has no support (Burnham and Anderson 2002).
const NO_SUPPORT: f64 = 10.0;
/// Relative offset at which a part's fit ends.
const OFFSET: f64 = 1e-4;

/// Fits all laws that the data admit, the best first by Akaike's criterion; and the reasons of those that were not.
pub fn compare(
    data: &Measurements,
    apparatus: Apparatus,
    options: &FitOptions,
    watch: &mut (dyn FnMut(FitLaw, FitProgress) + Send),
) -> (Vec<Compared>, Vec<(FitLaw, FitError)>) {
    let (mut all, mut refused) = (Vec::new(), Vec::new());
    for (law, ..) in FitLaw::ALL {
        if is_covered(law, data) {
            continue;
        }
        let mut told = |progress| watch(law, progress);
        match compared(law, data, apparatus, options, &mut told) {
            Ok(one) => all.push(one),
            Err(error) => refused.push((law, error)),
        }
    }
    let points = data.friction().len() as f64;
    // The same number of independent points for all laws: that of the best.
    let best_fit = all.iter().min_by(|a, b| a.fit.cost.total_cmp(&b.fit.cost));
    let factor = best_fit.map_or(1.0, |best| best.fit.error_factor);
    // Residuals below it are rounding: laws without any other are alike.
    let floor = WeightedData::new(data).floor_of_squares();
    let rounding = floor.max(f64::MIN_POSITIVE);
    for one in &mut all {
        let free = points - one.fit.freedoms as f64;
        let independent = points / (factor * factor);
        let misfit = if one.fit.is_weighted {
            one.fit.cost / (factor * factor)
        } else {
            independent * libm::log(one.fit.cost.max(rounding) / points)
        };
        one.akaike = misfit + 2.0 * free;
    }
    all.sort_by(|a, b| a.akaike.total_cmp(&b.akaike));
    tell_apart(&mut all);
    (all, refused)
}

/// Whether another law says the same of these data: the slip law in steady sliding.
fn is_covered(law: FitLaw, data: &Measurements) -> bool {
    law == FitLaw::RateStateSlip && data.times().is_none()
}

fn compared(
    law: FitLaw,
    data: &Measurements,
    apparatus: Apparatus,
    options: &FitOptions,
    watch: &mut (dyn FnMut(FitProgress) + Send),
) -> Result<Compared, FitError> {
    let model = law.model_on(data, apparatus)?;
    // What is kept concerns the laws that have such a parameter.
    let has = |name: &str| model.parameters().iter().any(|p| p.name == name);
    let fixed = options.fixed.iter().filter(|(name, _)| has(name)).cloned();
    let options = FitOptions {
        fixed: fixed.collect(),
        ..options.clone()
    };
    let fit = fit_watched(model.as_ref(), data, &options, watch)?;
    let parts = foretold(model.as_ref(), data, &fit, &options).unwrap_or_default();
    Ok(Compared {
        law,
        akaike: f64::NAN,
        foretold: (parts.iter().sum::<f64>() / parts.len() as f64).sqrt(),
        is_told_apart: true,
        parts,
        fit,
    })
}

/// Mean squares of the residuals of each part, foretold from the others.
fn foretold(
    model: &dyn Model,
    data: &Measurements,
    fit: &Fit,
    options: &FitOptions,
) -> Option<Vec<f64>> {
    let points = data.friction().len();
    if points < 2 * PARTS * fit.parameters.len() || points * fit.path.steps as usize > MOST_FORETOLD
    {
        return None;
    }
    let other = (fit.path != Between::PLAIN).then(|| model.along(fit.path));
    let other = other.flatten();
    let unknowns = Unknowns::new(model, &options.fixed).ok()?;
    let unknowns = unknowns.with(other.as_deref().unwrap_or(model));
    let values: Vec<f64> = fit
        .parameters
        .iter()
        .map(|estimate| estimate.value)
        .collect();
    let q = unknowns.coordinates(&values);
    let lengths = unknowns.lengths(std::slice::from_ref(&q));
    let target = WeightedData::new(data);
    // Of a record stretches of time, of steady points every fifth.
    let is_record = data.times().is_some();
    let part_of = |point: usize| {
        if is_record {
            point * PARTS / points
        } else {
            point % PARTS
        }
    };
    let part = |part: usize| {
        let seen = target.without(|point| part_of(point) == part);
        let residuals = |q: &[f64]| seen.residuals(&unknowns, q);
        let mut problem = problem(&residuals, &unknowns, &seen, &lengths);
        problem.offset = OFFSET;
        let end = minimise(&problem, &q, &mut |_| ())?;
        let all = target.residuals(&unknowns, &end.q)?;
        let unseen = (0..points).filter(|&point| part_of(point) == part);
        let squares = unseen.map(|point| (all[point] / target.unit) * (all[point] / target.unit));
        let (sum, count) = squares.fold((0.0, 0.0), |(sum, n), square| (sum + square, n + 1.0));
        Some(sum / count)
    };
    (0..PARTS).map(part).collect()
}

/// Marks the laws that do as well as the best.
fn tell_apart(all: &mut [Compared]) {
    let Some((best, others)) = all.split_first_mut() else {
        return;
    };
    let least = best.akaike;
    for other in others {
        other.akaike -= least;
        let differ = differ(&best.parts, &other.parts).unwrap_or(false);
        other.is_told_apart = differ || other.akaike > NO_SUPPORT;
    }
    best.akaike = 0.0;
    best.is_told_apart = false;
}

/// Whether two lists of mean squares differ by more than two standard errors of their difference.
fn differ(one: &[f64], other: &[f64]) -> Option<bool> {
    if one.len() != PARTS || other.len() != PARTS {
        return None;
    }
    let differences: Vec<f64> = one.iter().zip(other).map(|(a, b)| b - a).collect();
    let mean = differences.iter().sum::<f64>() / PARTS as f64;
    let spread = differences
        .iter()
        .map(|d| (d - mean) * (d - mean))
        .sum::<f64>();
    let error = (spread / (PARTS * (PARTS - 1)) as f64).sqrt();
    Some(mean.abs() > 2.0 * error)
}
