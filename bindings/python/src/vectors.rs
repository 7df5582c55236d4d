//! Lists of vectors between numpy and the library.

use crate::arrays::Rows;
use nalgebra::Vector3;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// An argument of shape (n, 3).
pub fn vectors(name: &'static str, given: &Bound<'_, PyAny>) -> PyResult<Vec<Vector3<f64>>> {
    let rows = Rows::<3>::new(name, given)?;
    let shape: Vec<usize> = given.getattr("shape")?.extract()?;
    let &[count, _] = shape.as_slice() else {
        let text = format!("{name} must have shape (n, 3), not {shape:?}");
        return Err(PyValueError::new_err(text));
    };
    let column = rows.over(&[count])?;
    let view = column.view()?;
    Ok((0..count).map(|row| Vector3::from(view.at(row))).collect())
}

/// An array of shape (n, 3) with the components of vectors.
pub fn rows<'a, 'py>(
    py: Python<'py>,
    vectors: impl IntoIterator<Item = &'a Vector3<f64>>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let numbers: Vec<f64> = vectors.into_iter().flatten().copied().collect();
    let count = numbers.len() / 3;
    PyArray1::from_vec(py, numbers).reshape([count, 3])
}
