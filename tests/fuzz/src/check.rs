//! Properties that results must have.

use super::Source;
use tribos_core::real::Real;

/// Description of a broken property, including the numbers.
pub type Broken = String;

/// Checks that the results of a mild input are finite; results of other inputs pass.
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

/// Checks that no result is NaN, whatever the input.
pub fn numbers<R: Real>(what: &str, values: impl IntoIterator<Item = R>) -> Result<(), Broken> {
    let values: Vec<R> = values.into_iter().collect();
    if values.iter().any(|x| x.is_nan()) {
        return Err(format!("{what} is NaN: {values:?}"));
    }
    Ok(())
}

/// Checks that every result is NaN.
pub fn all_nan<R: Real>(what: &str, values: impl IntoIterator<Item = R>) -> Result<(), Broken> {
    let values: Vec<R> = values.into_iter().collect();
    if values.iter().all(|x| x.is_nan()) {
        return Ok(());
    }
    Err(format!("{what} is a number for NaN: {values:?}"))
}

/// Checks a condition and reports `values` if it does not hold.
pub fn holds<R: Real>(condition: bool, what: &str, values: &[R]) -> Result<(), Broken> {
    if condition {
        return Ok(());
    }
    Err(format!("{what} does not hold: {values:?}"))
}

/// Checks `part` ≤ `whole` up to the rounding of `scale`.
pub fn at_most<R: Real>(what: &str, part: R, whole: R, scale: R) -> Result<(), Broken> {
    let rounding = R::from_f64(ROUNDING) * R::EPSILON * scale.abs();
    holds(part <= whole + rounding, what, &[part, whole, scale])
}

/// Rounding errors by which an inequality of sums and products may be violated.
const ROUNDING: f64 = 256.0;
