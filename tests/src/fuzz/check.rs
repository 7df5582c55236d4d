//! Properties that results must have.

use super::Source;
use tribos_core::real::Real;

/// A broken property, in words with the numbers.
pub type Broken = String;

/// Finite results of a mild input; any others pass.
pub fn finite<R: Real>(
    source: &Source,
    what: &str,
    values: impl IntoIterator<Item = R>,
) -> Result<(), Broken> {
    let values: Vec<R> = values.into_iter().collect();
    if !source.is_mild() || values.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Err(format!("{what} is not finite: {values:?}"))
}

/// Results that are numbers, whatever the input.
pub fn numbers<R: Real>(what: &str, values: impl IntoIterator<Item = R>) -> Result<(), Broken> {
    let values: Vec<R> = values.into_iter().collect();
    if values.iter().any(|x| x.is_nan()) {
        return Err(format!("{what} is NaN: {values:?}"));
    }
    Ok(())
}

/// NaN in, NaN out: every result is NaN.
pub fn all_nan<R: Real>(what: &str, values: impl IntoIterator<Item = R>) -> Result<(), Broken> {
    let values: Vec<R> = values.into_iter().collect();
    if values.iter().all(|x| x.is_nan()) {
        return Ok(());
    }
    Err(format!("{what} is a number for NaN: {values:?}"))
}

/// A condition, told with `values` if it does not hold.
pub fn holds<R: Real>(condition: bool, what: &str, values: &[R]) -> Result<(), Broken> {
    if condition {
        return Ok(());
    }
    Err(format!("{what} does not hold: {values:?}"))
}

/// `part` ≤ `whole` but for rounding of `scale`.
pub fn at_most<R: Real>(what: &str, part: R, whole: R, scale: R) -> Result<(), Broken> {
    let rounding = R::from_f64(ROUNDING) * R::EPSILON * scale.abs();
    holds(part <= whole + rounding, what, &[part, whole, scale])
}

/// Rounding errors that an inequality of sums and products may be missed by.
const ROUNDING: f64 = 256.0;
