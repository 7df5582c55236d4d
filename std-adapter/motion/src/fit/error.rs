//! Fits that fail.

use super::DataError;

/// Why a fit failed.
///
/// ```
/// use tribos::fit::{Measurements, FitError, FitLaw, FitOptions, fit, law_model};
/// let data = Measurements::steady(vec![0.5], vec![0.3], None)?;
/// let model = law_model(FitLaw::Power, &data)?;
/// let refused = fit(model.as_ref(), &data, &FitOptions::default());
/// assert_eq!(refused, Err(FitError::TooFew { points: 1, free: 2 }));
/// let fixed = vec![("gamma".into(), 0.3), ("alpha".into(), 0.0)];
/// let refused = fit(model.as_ref(), &data, &FitOptions { fixed, ..FitOptions::default() });
/// assert_eq!(refused, Err(FitError::NothingFree));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A measurement is invalid.
    #[error(transparent)]
    Data(#[from] DataError),
    /// A parameter that the law does not have.
    #[error("there is no parameter `{name}`; the parameters are {}", known.join(", "))]
    NoParameter {
        /// The rejected value.
        name: String,
        /// Names of the law's parameters.
        known: Vec<&'static str>,
    },
    /// A fixed value out of its range.
    #[error("`{name}` must be {range}, not {given}")]
    Range {
        /// Name of the parameter.
        name: &'static str,
        /// Range of the parameter.
        range: String,
        /// The rejected value.
        given: f64,
    },
    /// Fewer points than parameters.
    #[error(
        "{points} points cannot determine {free} parameters with an error; give more points or fix \
         parameters"
    )]
    TooFew {
        /// Number of points.
        points: usize,
        /// Number of free parameters.
        free: usize,
    },
    /// All parameters are fixed.
    #[error("all parameters are fixed; nothing is left to fit")]
    NothingFree,
    /// The law refuses every start.
    #[error("the law refuses every start; check the fixed values against each other")]
    NoStart,
    /// The law has no form for such data.
    #[error("{0}")]
    Form(&'static str),
}
