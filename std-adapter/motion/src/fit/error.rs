//! Fits that fail.

use tribos_friction::FrictionError;

/// Why a fit failed.
///
/// ```
/// use tribos::fit::{FitError, FitLaw, FitOptions, Measurements};
/// let data = Measurements::steady(vec![0.5], vec![0.3], None)?;
/// let model = FitLaw::Power.model(&data)?;
/// let refused = data.fit(model.as_ref(), &FitOptions::default());
/// assert_eq!(refused, Err(FitError::TooFew { points: 1, free: 2 }));
/// let fixed = vec![("gamma".into(), 0.3), ("alpha".into(), 0.0)];
/// let refused = data.fit(model.as_ref(), &FitOptions { fixed, ..FitOptions::default() });
/// assert_eq!(refused, Err(FitError::NothingFree));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A measurement cannot be used.
    #[error("{message}")]
    Point {
        /// Index of the point, from 0.
        point: usize,
        /// Description of the error and of valid values.
        message: String,
    },
    /// The columns of the measurements differ in length.
    #[error("columns have different lengths, {0} and {1}")]
    Lengths(usize, usize),
    /// The measurements cannot be used as a whole.
    #[error("{0}")]
    Whole(&'static str),
    /// A push cannot be used.
    #[error("{message}")]
    Push {
        /// Index of the push, from 0.
        push: usize,
        /// Description of the error and of valid values.
        message: String,
    },
    /// The pushes cannot be used as a whole.
    #[error("{0}")]
    Pushes(String),
    /// The frames of a film cannot be used, or not in this way.
    #[error("{0}")]
    Track(String),
    /// The known support is refused.
    #[error(transparent)]
    Support(#[from] FrictionError),
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
