//! Whether residuals in the order of time are noise: runs, correlation, drift, outliers.
//!
//! Standard errors of a fit hold for independent residuals. Residuals that are correlated over time, from a filter in
//! the instrument or from a law that lacks something, make the true errors larger by √(2τ), where τ is the
//! integrated [autocorrelation time](tribos_base::statistics::correlation) in rows.

use super::reduce::power_of_two;
use super::strokes::noise::{SIGMAS_PER_MEDIAN, median};
use std::f64::consts::FRAC_1_SQRT_2;
use tribos_base::statistics::correlation::{
    Autocorrelation, correlation_time, drift, error_factor,
};

/// Fewest residuals that are tested.
const FEWEST: usize = 8;
/// Robust standard deviations beyond which a residual is an outlier: one of two million normal ones is.
const OUTLIER: f64 = 5.0;

/// What residuals show, in the order of time.
///
/// ```
/// use tribos::fit::residual_tests;
/// // A slow oscillation that the law does not have.
/// let left: Vec<f64> = (0..1000).map(|i| f64::from(i % 100) - 49.5).collect();
/// let told = residual_tests(&left, None).ok_or("nothing to test")?;
/// assert!(told.runs_p < 1e-6 && told.lag_one > 0.9 && told.error_factor > 3.0);
/// assert_eq!(told.outliers, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResidualTests {
    /// Wald–Wolfowitz statistic of the runs of one sign: standard normal for independent residuals,
    /// negative for too few runs. Zeros are left out; 0 if all have one sign.
    pub runs_z: f64,
    /// Two-sided probability of such runs among independent residuals.
    pub runs_p: f64,
    /// Autocorrelation at lag 1.
    pub lag_one: f64,
    /// Integrated autocorrelation time τ in rows; ½ for independent residuals.
    pub correlation_time: f64,
    /// Factor √(2τ) by which the standard errors of independent residuals grow, at least 1.
    pub error_factor: f64,
    /// Slope of the residuals over their order, in their unit per row.
    pub drift: f64,
    /// The slope in its standard error, which the correlation about the slope enlarges.
    pub drift_z: f64,
    /// Two-sided probability of such a slope without drift.
    pub drift_p: f64,
    /// Number of residuals more than five robust standard deviations from their median.
    pub outliers: usize,
    /// Robust standard deviation: 1.4826 median absolute deviations from the median.
    pub robust_deviation: f64,
}

/// Tests residuals in the order of time, each divided by its standard deviation if that is given.
///
/// None for fewer than eight residuals, values that are not finite, or residuals that are all equal.
///
/// *Accuracy*: statistics agree with statsmodels and a direct sum to 1e-12; the correlation time to
/// 1e-12 where its window is below 65 rows, else within its statistical error. *Cost*: linear.
pub fn residual_tests(residuals: &[f64], sigma: Option<&[f64]>) -> Option<ResidualTests> {
    let mut scaled: Vec<f64> = match sigma {
        None => residuals.to_vec(),
        Some(sigma) if sigma.len() == residuals.len() => {
            residuals.iter().zip(sigma).map(|(r, s)| r / s).collect()
        }
        Some(_) => return None,
    };
    if scaled.len() < FEWEST || scaled.iter().any(|r| !r.is_finite()) {
        return None;
    }
    // Squares neither overflow nor vanish.
    let largest = scaled.iter().fold(0.0, |most: f64, r| most.max(r.abs()));
    let unit = power_of_two(largest);
    for r in &mut scaled {
        *r /= unit;
    }
    let lag_one = Autocorrelation::of(scaled.clone())?.at(1);
    let correlation_time = correlation_time(scaled.clone());
    let (runs_z, runs_p) = runs(&scaled);
    let (drift, drift_z) = drift(&scaled);
    let (outliers, robust) = outliers(&scaled);
    Some(ResidualTests {
        runs_z,
        runs_p,
        lag_one,
        correlation_time,
        error_factor: error_factor(correlation_time),
        drift: drift * unit,
        drift_z,
        drift_p: two_sided(drift_z),
        outliers,
        robust_deviation: robust * unit,
    })
}

impl ResidualTests {
    /// Sentences on what makes residuals other than independent noise; none if nothing does.
    ///
    /// Runs and drifts are told at a probability below 1 in 1000, correlation where it makes errors
    /// larger by a tenth or more beyond the chance of so many rows.
    pub fn notes(&self) -> Vec<String> {
        /// Probability below which a statistic is no chance.
        const RARE: f64 = 1e-3;
        /// Growth of the errors that is worth a sentence.
        const GROWTH: f64 = 1.1;
        let mut notes = Vec::new();
        if self.runs_p < RARE && self.error_factor > GROWTH {
            notes.push(format!(
                "residuals are correlated over {:.3} rows: true errors are {:.3} times those of \
                 independent rows, or the law lacks something",
                2.0 * self.correlation_time,
                self.error_factor
            ));
        }
        if self.drift_p < RARE {
            notes.push(format!(
                "residuals drift by {:.3e} from row to row, {:.1} standard errors from none",
                self.drift, self.drift_z
            ));
        }
        match self.outliers {
            0 => {}
            1 => notes.push("one residual is an outlier, beyond 5 robust deviations".to_owned()),
            count => notes.push(format!(
                "{count} residuals are outliers, beyond 5 robust deviations"
            )),
        }
        notes
    }
}

/// Probability that a standard normal number is farther from 0.
fn two_sided(z: f64) -> f64 {
    libm::erfc(z.abs() * FRAC_1_SQRT_2)
}

/// Statistic and probability of the number of runs (Wald and Wolfowitz 1940): of n₊ and n₋ signs in
/// random order there are 1 + 2 n₊ n₋/n runs, with the variance 2 n₊ n₋ (2 n₊ n₋ − n)/(n² (n − 1)).
fn runs(residuals: &[f64]) -> (f64, f64) {
    let signs = || residuals.iter().filter(|r| **r != 0.0).map(|r| *r > 0.0);
    let count = signs().count() as f64;
    let above = signs().filter(|is_above| *is_above).count() as f64;
    let changes = signs().zip(signs().skip(1)).filter(|(a, b)| a != b).count();
    let pairs = 2.0 * above * (count - above);
    let variance = pairs * (pairs - count) / (count * count * (count - 1.0));
    if variance.is_nan() || variance <= 0.0 {
        return (0.0, 1.0);
    }
    let z = (1.0 + changes as f64 - (1.0 + pairs / count)) / variance.sqrt();
    (z, two_sided(z))
}

/// Number of values far from the median, and the robust standard deviation.
fn outliers(values: &[f64]) -> (usize, f64) {
    let middle = median(values.to_vec());
    let away = || values.iter().map(|r| (r - middle).abs());
    let deviation = SIGMAS_PER_MEDIAN * median(away().collect());
    let far = away().filter(|r| deviation > 0.0 && *r > OUTLIER * deviation);
    (far.count(), deviation)
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
pub(in crate::fit) mod tests;
