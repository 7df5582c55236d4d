//! Friction of a patch under a law.

use crate::arrays::{Numbers, Output, Rows, broadcast, refused};
use crate::law::Law;
use crate::model::loads_over;
use crate::model::{Batch, Model, model};
use crate::patch::{Patch, Shape};
use crate::threads::fill;
use pyo3::prelude::*;
use tribos::friction::Tier;

/// Friction of a patch under a law.
#[pyclass(frozen, module = "tribos._native")]
pub struct Friction {
    model: Box<dyn Model>,
    /// Nanoseconds that a wrench takes, about.
    cost: usize,
}

#[pymethods]
impl Friction {
    #[new]
    #[pyo3(signature = (patch, law, tier=None))]
    fn new(patch: &Patch, law: &Law, tier: Option<&str>) -> PyResult<Self> {
        let tier: Option<Tier> = tier.map(|name| name.parse().map_err(refused)).transpose()?;
        let model = model(&patch.0, &law.0, tier)?;
        let cost = match &patch.0 {
            Shape::Round(..) => 30,
            _ => 200,
        };
        Ok(Self { model, cost })
    }

    /// Wrenches, in N and N m, of twists in m/s and rad/s under loads in N.
    #[pyo3(signature = (twists, load, out=None))]
    fn wrench<'py>(
        &self,
        py: Python<'py>,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (twists, loads) = (
            Rows::<3>::new("twists", twists)?,
            Numbers::new("load", load)?,
        );
        let batch = broadcast(&[&twists, &loads])?;
        let (twists, loads) = (twists.over(&batch)?, loads_over(loads, &batch)?);
        let rows = Batch {
            loads: loads.view()?,
            twists: twists.view()?,
        };
        let mut output = Output::new(py, &batch, &[3], out)?;
        fill(py, output.rows::<3>()?, self.cost, |from, piece| {
            self.model.wrenches(rows, from, piece);
            Ok(())
        })?;
        output.finish()
    }

    /// Their derivatives.
    #[pyo3(signature = (twists, load, out=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (twists, loads) = (
            Rows::<3>::new("twists", twists)?,
            Numbers::new("load", load)?,
        );
        let batch = broadcast(&[&twists, &loads])?;
        let (twists, loads) = (twists.over(&batch)?, loads_over(loads, &batch)?);
        let rows = Batch {
            loads: loads.view()?,
            twists: twists.view()?,
        };
        let mut output = Output::new(py, &batch, &[3, 3], out)?;
        fill(py, output.rows::<9>()?, 3 * self.cost, |from, piece| {
            self.model.jacobians(rows, from, piece);
            Ok(())
        })?;
        output.finish()
    }
}
