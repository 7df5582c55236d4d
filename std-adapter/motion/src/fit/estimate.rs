//! Options and result of a fit.

use super::Measurements;
use super::caution::Caution;
use super::error::FitError;
use super::parameter::{Between, FitParameter, Model};
use super::refine::Paths;
use super::result::Certified;
use super::sample::WeightedData;
use super::search::{FitProgress, search};
use super::unknowns::Unknowns;
use nalgebra::DMatrix;
use std::sync::Mutex;

/// Searches that begin anew because a profile found a smaller sum of squares.
const MOST_RETURNS: usize = 4;

/// Options of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Parameters that keep these values.
    pub fixed: Vec<(String, f64)>,
    /// Number of starts, at least 1.
    pub starts: usize,
}

impl Default for FitOptions {
    /// Nothing fixed, 16 starts.
    fn default() -> Self {
        Self {
            fixed: Vec::new(),
            starts: 16,
        }
    }
}

/// Certainty of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Uncertainty {
    /// From the data, with this standard error.
    StandardError(f64),
    /// The parameter was fixed.
    Fixed,
    /// The parameter is at an end of its range.
    AtBound,
    /// The data determine only a combination with these other parameters, or, if the list is
    /// empty, nothing.
    Undetermined(Vec<&'static str>),
}

/// One parameter of the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Description of the parameter.
    pub parameter: FitParameter,
    /// Value of the parameter.
    pub value: f64,
    /// Certainty of the value.
    pub known: Uncertainty,
    /// Interval that covers the true value in 95 of 100 cases, from the profile of the sum of squares: other
    /// parameters follow while this one is moved. Infinite where the data do not bound it.
    pub interval: [f64; 2],
}

/// A fitted model.
///
/// ```
/// use tribos::fit::{Measurements, Estimate, Fit, Uncertainty, FitLaw, FitOptions};
/// // Friction over load at speeds that lie evenly about 1 m/s on a scale of ratios.
/// let data = Measurements::steady(vec![0.25, 0.5, 2.0, 4.0], vec![0.31, 0.29, 0.29, 0.31], None)?;
/// let found: Fit = data.fit(FitLaw::Power.model(&data)?.as_ref(), &FitOptions::default())?;
/// // By symmetry alpha is 0: gamma is the mean, its standard error s/√n, and they do not trade.
/// assert!(found.value("alpha").is_some_and(|alpha| alpha.abs() < 1e-6));
/// let s = (4.0 * 0.01_f64.powi(2) / 2.0).sqrt(); // two points more than parameters
/// assert!((found.deviation() - s).abs() < 1e-6);
/// let gamma: &Estimate = found.determined().next().ok_or("no gamma")?;
/// assert!((gamma.value - 0.30).abs() < 1e-6);
/// assert!(matches!(gamma.known, Uncertainty::StandardError(e) if (e - s / 2.0).abs() < 1e-6));
/// assert!(found.correlation(0, 1).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// All parameters, in the order of the model.
    pub parameters: Vec<Estimate>,
    /// Covariance of the parameters with a standard error, in their order.
    pub covariance: DMatrix<f64>,
    /// Predicted friction of each point.
    pub predictions: Vec<f64>,
    /// Σ ((data − prediction)/σ)², with σ = 1 if unknown; infinite beyond the largest f64.
    pub cost: f64,
    /// √(cost/freedoms), also where the cost itself overflows.
    pub(super) deviation: f64,
    /// Number of points minus number of free parameters.
    pub freedoms: usize,
    /// Whether standard deviations of the points were known.
    pub is_weighted: bool,
    /// Whether the best search converged, so that only rounding limited further descent.
    pub converged: bool,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// Number of starts that ended at the best minimum.
    pub at_best: usize,
    /// Steps of the best search.
    pub iterations: usize,
    /// Number of points on which the starts were searched: all, or a sample, whose best minima
    /// were refined on all points.
    pub searched: usize,
    /// Factor, at least 1, by which standard errors and intervals were enlarged because residuals follow each other over
    /// time.
    pub error_factor: f64,
    /// What to know before the numbers are used.
    pub cautions: Vec<Caution>,
    /// The motion between the points of a record.
    pub(super) path: Between,
}

impl Measurements {
    /// Fits the model to these data.
    ///
    /// *Cost*: with up to 4,000 points all starts use all points, with some 30 steps each. With more
    /// points, starts use a sample if the model can be [thinned](Model::subsample), and the few minima that
    /// are alike on it are refined on all points. The same data give the same bits.
    pub fn fit(&self, model: &dyn Model, options: &FitOptions) -> Result<Fit, FitError> {
        fit_watched(model, self, options, &mut |_| ())
    }
}

/// As [`Measurements::fit`]; `watch` is called before each step.
///
/// ```
/// use tribos::fit::{Measurements, FitProgress, FitLaw, FitOptions, fit_watched};
/// let data = Measurements::steady(vec![1.0, 2.0, 4.0], vec![0.3, 0.2, 0.1], None)?;
/// let model = FitLaw::Power.model(&data)?;
/// let mut last = None;
/// let options = FitOptions { starts: 5, ..FitOptions::default() };
/// fit_watched(model.as_ref(), &data, &options, &mut |progress| last = Some(progress))?;
/// let FitProgress { points, .. } = last.ok_or("no step")?;
/// assert_eq!(points, 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit_watched(
    model: &dyn Model,
    data: &Measurements,
    options: &FitOptions,
    watch: &mut (dyn FnMut(FitProgress) + Send),
) -> Result<Fit, FitError> {
    let unknowns = Unknowns::new(model, &options.fixed)?;
    let target = WeightedData::new(data);
    let watch = Mutex::new(watch);
    let watch = |progress| {
        if let Ok(mut watch) = watch.lock() {
            watch(progress);
        }
    };
    let found = search(&unknowns, data, &target, options.starts, &watch)?;
    let paths = Paths {
        model,
        unknowns: &unknowns,
        data,
        target: &target,
        lengths: &found.lengths,
        watch: &watch,
    };
    let refined = paths.refine(found.minima.clone());
    let mut refined = refined.ok_or(FitError::NoStart)?;
    let mut is_last = false;
    for returns in 0..=MOST_RETURNS {
        is_last |= returns == MOST_RETURNS;
        let lower = match Certified::of(&paths, &found, &refined, is_last)? {
            Certified::Fit(fit) => return Ok(*fit),
            Certified::Lower(place) => place,
        };
        match paths.lower(&refined, lower) {
            Some(lower) => refined = lower,
            None => is_last = true,
        }
    }
    Err(FitError::NoStart)
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
        all.filter(|estimate| matches!(estimate.known, Uncertainty::StandardError(_)))
    }

    /// √(cost/freedoms): the residuals' standard deviation, or with known deviations the square root
    /// of the reduced χ².
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    /// Correlation of two parameters of the covariance; 0 where an error is 0.
    pub fn correlation(&self, a: usize, b: usize) -> f64 {
        let c = &self.covariance;
        let scale = (c[(a, a)] * c[(b, b)]).sqrt();
        if scale > 0.0 { c[(a, b)] / scale } else { 0.0 }
    }
}
