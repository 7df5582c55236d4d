//! Derivatives: of limit surfaces, of the planar step, of the way to rest.

mod slide;
mod smooth;
mod step;
mod surface;

pub use slide::RestMap;
pub use surface::SurfaceDerivatives;

use crate::arrays::Output;
use pyo3::prelude::*;

/// A part of every row as an array of its own, with rows of shape `row`.
fn part<'py, const N: usize, const M: usize>(
    py: Python<'py>,
    batch: &[usize],
    row: &[usize],
    rows: &[[f64; N]],
    from: usize,
) -> PyResult<Bound<'py, PyAny>> {
    let mut output = Output::new(py, batch, row, None)?;
    for (to, all) in output.rows::<M>()?.iter_mut().zip(rows) {
        to.copy_from_slice(&all[from..from + M]);
    }
    output.finish()
}
