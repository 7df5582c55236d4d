//! Laws by name.

use crate::arrays::{Numbers, Output, broadcast, refused};
use crate::threads::fill;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribos::friction;
use tribos_core::law::LocalLaw;

/// A law of the local speed.
#[pyclass(frozen, module = "tribos._native")]
pub struct Law(pub friction::Law);

#[pymethods]
impl Law {
    #[new]
    fn new(text: &str) -> PyResult<Self> {
        let law: friction::Law = text.parse().map_err(refused)?;
        law.build::<f64>().map_err(refused)?;
        Ok(Self(law))
    }

    /// The law as it is written.
    fn text(&self) -> String {
        self.0.to_string()
    }

    /// Friction per load at `speed`.
    #[pyo3(signature = (speed, out=None))]
    fn friction<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each(py, speed, out, |law, speed| law.friction(speed))
    }

    /// Its derivative.
    #[pyo3(signature = (speed, out=None))]
    fn slope<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each(py, speed, out, |law, speed| law.slope(speed))
    }
}

impl Law {
    fn each<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&friction::AnyLaw<f64>, f64) -> f64 + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let speed = Numbers::new("speed", speed)?;
        let batch = broadcast(&[&speed])?;
        let speed = speed.over(&batch)?;
        let view = speed.view()?;
        let mut output = Output::new(py, &batch, &[], out)?;
        let law = self.0.build::<f64>().map_err(refused)?;
        fill(py, output.rows::<1>()?, 20, |from, piece| {
            for (index, row) in piece.iter_mut().enumerate() {
                *row = [of(&law, view.at(from + index)[0].abs())];
            }
            Ok(())
        })?;
        output.finish()
    }
}

/// The catalogue of laws.
#[pyfunction]
pub fn laws(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    let entry = |law: &friction::LawEntry| {
        let entry = PyDict::new(py);
        entry.set_item("name", law.name)?;
        entry.set_item("summary", law.summary)?;
        entry.set_item("formula", law.formula)?;
        entry.set_item("source", law.source)?;
        entry.set_item("is_local", law.local.is_some())?;
        let parameters = law.parameters.iter().map(|parameter| {
            let made = PyDict::new(py);
            made.set_item("name", parameter.name)?;
            made.set_item("unit", parameter.unit)?;
            made.set_item("meaning", parameter.meaning)?;
            made.set_item("default", parameter.default)?;
            Ok(made)
        });
        let parameters: PyResult<Vec<_>> = parameters.collect();
        entry.set_item("parameters", parameters?)?;
        Ok(entry)
    };
    friction::LAWS.iter().map(entry).collect()
}
