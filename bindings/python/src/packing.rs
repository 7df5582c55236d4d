//! Packings in files of any program: read, described, written in another format.

use crate::arrays::refused;
use crate::threads::detached;
use crate::vectors::rows;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use tribos::measure::{Assembly, PackingColumns, PackingFormat};
use tribos::record::{significant, write_atomically};

/// Digits of numbers in the description.
const DIGITS: usize = 6;

/// Spheres of a file.
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug)]
pub struct PackingFile(Assembly);

/// A refusal that names Python's keywords in the place of the command's options.
fn told(error: impl std::fmt::Display) -> PyErr {
    let text = error.to_string();
    refused(
        text.replace("--columns (key `columns`)", "columns")
            .replace("--columns ", "columns "),
    )
}

#[pymethods]
impl PackingFile {
    #[new]
    fn new(
        py: Python<'_>,
        path: PathBuf,
        columns: Option<&str>,
        periods: Option<[Option<f64>; 3]>,
    ) -> PyResult<Self> {
        let columns = columns
            .map(str::parse::<PackingColumns>)
            .transpose()
            .map_err(refused)?;
        let read = || {
            let read = Assembly::read_as(&path, columns.as_ref())?;
            match periods {
                Some(periods) => read.with_periods(&path.display().to_string(), periods),
                None => Ok(read),
            }
        };
        detached(py, read)?.map(Self).map_err(told)
    }

    /// The arrays by name; those that the file lacks are None.
    fn arrays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (all, spheres) = (PyDict::new(py), &self.0);
        all.set_item("positions", rows(py, &spheres.positions)?)?;
        all.set_item("radii", PyArray1::from_slice(py, &spheres.radii))?;
        all.set_item(
            "densities",
            spheres
                .densities
                .as_ref()
                .map(|all| PyArray1::from_slice(py, all)),
        )?;
        all.set_item(
            "materials",
            spheres
                .materials
                .as_ref()
                .map(|all| PyArray1::from_slice(py, all)),
        )?;
        for (name, vectors) in [
            ("velocities", &spheres.velocities),
            ("spins", &spheres.spins),
        ] {
            all.set_item(name, vectors.as_ref().map(|all| rows(py, all)).transpose()?)?;
        }
        all.set_item("periods", spheres.space.lengths())?;
        all.set_item("tilt", spheres.space.offset())?;
        all.set_item("bounds", spheres.bounds)?;
        Ok(all)
    }

    /// What is known of the spheres, a line for each part.
    fn about(&self) -> Vec<(&'static str, String)> {
        self.0.about(&|value| significant(value, DIGITS))
    }

    /// Writes a file in the format of its ending; what the format cannot hold.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<Vec<&'static str>> {
        let format = PackingFormat::written_as(&path).ok_or_else(|| {
            refused(format!(
                "{}: the ending says the format; give .xyz, .vtp, .data, .csv or .txt",
                path.display()
            ))
        })?;
        detached(py, || {
            let written = self.0.written(format).map_err(told)?.unwrap_or_default();
            write_atomically(&path, written.text.as_bytes()).map_err(told)?;
            Ok(written.lost)
        })?
    }
}
