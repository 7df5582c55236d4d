//! Parameters of friction laws from measurements: nonlinear least squares.
//!
//! The laws are the kernel's own ([`tribos_core::law`]), steady or with their states, without a
//! second implementation. [`Measurements`] are speeds with friction, or friction over time; [`FitLaw::model`]
//! joins them with a law; [`Measurements::fit`] finds the parameters with the least sum of squared residuals,
//! each divided by its standard deviation if that is known:
//!
//! - Levenberg–Marquardt (Marquardt 1963; damping after Nielsen 1999), every step from a singular
//!   value decomposition of the scaled Jacobian, derivatives by differences of fourth order. The
//!   crate `levenberg-marquardt` 0.15 requires another version of nalgebra.
//! - Positive parameters are varied in their logarithms, others within their bounds; a parameter at
//!   its bound stays there while the descent points outwards.
//! - Several starts, spread by a fixed Halton sequence over the range that the data leave open. The
//!   number that ended at the best minimum is reported.
//! - With more than 4,000 points the starts use a sample; the minima that are alike on it are refined
//!   on all points.
//! - Parameters that the data do not determine are listed with those that they trade against, in
//!   place of a standard error.
//!
//! *Accuracy*: NIST's reference problems Misra1a, Thurber and MGH09 are reproduced to 8 digits of
//! the parameters and 6 of their standard deviations, from both of NIST's starts.
//!
//! ```
//! use tribos::fit::{FitLaw, FitOptions, Measurements};
//! use tribos_core::law::{LocalLaw, PowerLaw};
//! let law = PowerLaw::new(-0.5_f64, 0.008)?; // ice
//! let speeds: Vec<f64> = (1..=20).map(|k| 0.1 * f64::from(k)).collect();
//! let friction = speeds.iter().map(|&v| law.friction(v)).collect();
//! let data = Measurements::steady(speeds, friction, None)?;
//! let found = data.fit(FitLaw::Power.model(&data)?.as_ref(), &FitOptions::default())?;
//! assert!((found.parameters[0].value - 0.008).abs() < 1e-12);
//! assert!((found.parameters[1].value + 0.5).abs() < 1e-10);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod abrupt;
mod apparatus;
mod caution;
mod columns;
mod compare;
mod covariance;
mod data;
mod error;
mod estimate;
mod halton;
mod hints;
mod interval;
mod jacobian;
mod law;
mod linear;
mod linearised;
mod minimise;
mod outwards;
mod parameter;
mod reduce;
mod refine;
mod residual_tests;
mod result;
mod sample;
mod search;
mod slopes;
mod standard_errors;
pub mod strokes;
pub mod support;
pub mod track;
mod unknowns;
mod usage;

pub use apparatus::Apparatus;
pub use caution::Caution;
pub use columns::{FitColumns, Prepared};
pub use compare::{Compared, compare};
pub use data::Measurements;
#[doc(hidden)]
pub use data::Motion;
pub use error::FitError;
#[doc(hidden)]
pub use estimate::fit_watched;
pub use estimate::{Estimate, Fit, FitOptions, Uncertainty};
pub use law::FitLaw;
pub use parameter::FitParameter;
#[doc(hidden)]
pub use parameter::{Between, Model, Range, VelocityCourse};
pub use residual_tests::{ResidualTests, residual_tests};
#[doc(hidden)]
pub use search::FitProgress;
pub use usage::{FittedLaw, Usage, UsageError, UsageTarget};

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod hard_cases;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod nist;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod records;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
