//! What a support carries of which the load and the centre of pressure are known.

use crate::arrays::{Output, Rows, broadcast, refused};
use crate::model::{numbers, twist_of, wrench_of};
use crate::threads::fill;
use pyo3::prelude::*;
use tribos_core::limit_surface;

/// Nanoseconds that a support and a limit take, about.
const COST: usize = 300;
const COST_OF_LIMITS: usize = 100_000;

/// All wrenches that friction carries under any pressure with one centre.
#[pyclass(frozen, module = "tribos._native")]
pub struct AnyPressure(limit_surface::UnknownPressureSet<f64, Vec<[f64; 2]>>);

/// What `of` makes of each row, in rows of `shape`.
fn each<'py, const N: usize, const M: usize>(
    py: Python<'py>,
    rows: Rows<'py, N>,
    (shape, cost): (&[usize], usize),
    of: impl Fn([f64; N]) -> [f64; M] + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let batch = broadcast(&[&rows])?;
    let rows = rows.over(&batch)?;
    let rows = rows.view()?;
    let mut output = Output::new(py, &batch, shape, None)?;
    fill(py, output.rows::<M>()?, cost, |from, piece| {
        for (index, row) in (from..).zip(piece) {
            *row = of(rows.at(index));
        }
        Ok(())
    })?;
    output.finish()
}

#[pymethods]
impl AnyPressure {
    /// Corners and centre of pressure in m, force limit in N.
    #[new]
    fn new(corners: Vec<[f64; 2]>, centre: [f64; 2], force_limit: f64) -> PyResult<Self> {
        let made = limit_surface::UnknownPressureSet::new(corners, centre, force_limit);
        Ok(Self(made.map_err(refused)?))
    }

    /// Distance of the farthest corner from the centre of pressure, in m.
    fn radius(&self) -> f64 {
        self.0.radius()
    }

    /// Support function at twists, in W.
    fn support<'py>(
        &self,
        py: Python<'py>,
        twists: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = Rows::<3>::new("twists", twists)?;
        each(py, rows, (&[], COST), |row| {
            [self.0.support(&twist_of(row))]
        })
    }

    /// Friction under a pressure that dissipates most.
    fn wrench<'py>(
        &self,
        py: Python<'py>,
        twists: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = Rows::<3>::new("twists", twists)?;
        each(py, rows, (&[3], COST), |row| {
            numbers(&self.0.wrench(&twist_of(row)))
        })
    }

    /// Torques with forces: lowest and highest that are carried, then the outer limits; NaN where the force
    /// is not carried.
    fn torque_limits<'py>(
        &self,
        py: Python<'py>,
        forces: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = Rows::<2>::new("forces", forces)?;
        each(py, rows, (&[4], COST_OF_LIMITS), |force| {
            let Some(limits) = self.0.torque_limits(force) else {
                return [f64::NAN; 4];
            };
            let ([low, high], [lower, higher]) = (limits.certain, limits.possible);
            [low, high, lower, higher]
        })
    }

    /// Lower and upper bounds of the gauges of wrenches.
    fn gauge_bounds<'py>(
        &self,
        py: Python<'py>,
        wrenches: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = Rows::<3>::new("wrenches", wrenches)?;
        each(py, rows, (&[2], COST_OF_LIMITS), |row| {
            self.0.gauge_bounds(&wrench_of(row))
        })
    }
}
