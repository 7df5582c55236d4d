//! Texts that are no settings of grains.

/// A text that is no ramp in time, or no distribution of sizes.
///
/// ```
/// use tribos::{grains::Ramp, scene::{SettingError, SizeDistribution}};
/// let refused: Result<Ramp, SettingError> = "0:1, 0:2".parse();
/// assert!(refused.is_err_and(|error| error.to_string().contains("ascend")));
/// let wide: Result<SizeDistribution, SettingError> = "normal:0.5".parse();
/// assert!(matches!(wide, Err(SettingError::Width { given, .. }) if given == 0.5));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// A part of a ramp is no pair of numbers.
    #[error("`{0}` must be a number, or pairs TIME:VALUE such as \"0:0, 0.5:1e3, 1:0\"")]
    Ramp(String),
    /// A time of a ramp is negative, or a number is not finite.
    #[error("times must be finite and >= 0, values finite, not {0}:{1}")]
    RampRange(f64, f64),
    /// Times of a ramp do not ascend.
    #[error("times must ascend: {0} is followed by {1}")]
    RampOrder(f64, f64),
    /// The text has no types of grains.
    #[error("`{0}` must be types from 1 to 9 such as \"2, 3\"")]
    Types(String),
    /// The text has no three coordinates.
    #[error("`{0}` must be three numbers such as \"0, 0, 0.1\"")]
    Coordinates(String),
    /// An entry of a list is wrong.
    #[error("`{entry}`: {reason}")]
    Entry {
        /// The entry.
        entry: String,
        /// What is wrong, and what would be valid.
        reason: String,
    },
    /// The text names no distribution.
    #[error(
        "give \"uniform:0.2\", \"normal:0.1\", \"lognormal:0.3\" or \"table:FILE.csv\", not \"{0}\""
    )]
    Sizes(String),
    /// The width of a distribution is out of its domain.
    #[error("{name}: the width must be {valid}, not {given}")]
    Width {
        /// Name of the distribution.
        name: &'static str,
        /// Description of valid values.
        valid: &'static str,
        /// The rejected value.
        given: f64,
    },
    /// A table cannot be read.
    #[error("{file}: {reason}")]
    File {
        /// Name of the file.
        file: String,
        /// What is wrong, and what would be valid.
        reason: String,
    },
    /// A line of a table is wrong.
    #[error("{file}:{line}: {reason}")]
    Line {
        /// Name of the file.
        file: String,
        /// Line number, from 1.
        line: usize,
        /// What is wrong, and what would be valid.
        reason: String,
    },
}
