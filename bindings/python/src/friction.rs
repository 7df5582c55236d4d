//! Friction of a patch under a law.

use crate::arrays::{Numbers, Output, Rows, broadcast, refused};
use crate::law::Law;
use crate::model::{Batch, jacobians, loads_over, numbers, twist_of, wrenches};
use crate::patch::Patch;
use crate::threads::fill;
use pyo3::prelude::*;
use tribos::friction::{AnyFriction, AreaFriction, ContactRadius, Tier};
use tribos_core::coupling::LoadedFriction as Loaded;
use tribos_core::patch::elastic::LoadedRadius;
use tribos_core::twist::{Twist, Wrench};

/// Friction of a patch under a law.
#[pyclass(frozen, module = "tribos._native")]
pub struct Friction {
    friction: AreaFriction,
    /// Nanoseconds that a wrench takes, about.
    cost: usize,
}

/// What `work` makes of loads and twists, in rows of `shape`.
fn each<'py, const N: usize>(
    [twists, load]: [&Bound<'py, PyAny>; 2],
    out: Option<&Bound<'py, PyAny>>,
    (shape, cost): (&[usize], usize),
    work: impl Fn(Batch<'_>, usize, &mut [[f64; N]]) + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, rows) = (twists.py(), Rows::<3>::new("twists", twists)?);
    let loads = Numbers::new("load", load)?;
    let batch = broadcast(&[&rows, &loads])?;
    let (rows, loads) = (rows.over(&batch)?, loads_over(loads, &batch)?);
    let given = Batch {
        loads: loads.view()?,
        twists: rows.view()?,
    };
    let mut output = Output::new(py, &batch, shape, out)?;
    fill(py, output.rows::<N>()?, cost, |from, piece| {
        work(given, from, piece);
        Ok(())
    })?;
    output.finish()
}

#[pymethods]
impl Friction {
    #[new]
    #[pyo3(signature = (patch, law, tier=None))]
    fn new(patch: &Patch, law: &Law, tier: Option<&str>) -> PyResult<Self> {
        let tier: Option<Tier> = tier.map(|name| name.parse().map_err(refused)).transpose()?;
        let friction = AreaFriction::new(&patch.0, &law.0, tier).map_err(refused)?;
        let cost = if patch.0.is_round() { 30 } else { 200 };
        Ok(Self { friction, cost })
    }

    /// Wrenches, in N and N m, of twists in m/s and rad/s under loads in N.
    #[pyo3(signature = (twists, load, out=None))]
    fn wrench<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = (&[3][..], self.cost);
        each([twists, load], out, rows, |batch, from, piece| {
            wrenches(&self.friction, batch, from, piece);
        })
    }

    /// Their derivatives.
    #[pyo3(signature = (twists, load, out=None))]
    fn jacobian<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let rows = (&[3, 3][..], 3 * self.cost);
        each([twists, load], out, rows, |batch, from, piece| {
            jacobians(&self.friction, batch, from, piece);
        })
    }
}

/// Dry friction of a round patch whose radius follows the load.
#[pyclass(frozen, module = "tribos._native")]
pub struct LoadedFriction(Loaded<f64, AnyFriction, ContactRadius>);

impl LoadedFriction {
    fn each<'py>(
        &self,
        given: [&Bound<'py, PyAny>; 2],
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(f64, &Twist<f64>) -> Wrench<f64> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        each(given, out, (&[3], 100), |batch, from, piece| {
            for (index, row) in (from..).zip(piece) {
                let [load] = batch.loads.at(index);
                *row = numbers(&of(load, &twist_of(batch.twists.at(index))));
            }
        })
    }
}

#[pymethods]
impl LoadedFriction {
    /// Of a pressure such as `hertz`, a law, and a radius as text.
    #[new]
    fn new(pressure: &str, law: &Law, radius: &str) -> PyResult<Self> {
        let patch = pressure.parse().map_err(refused)?;
        let radius: ContactRadius = radius.parse().map_err(refused)?;
        let coupling = AnyFriction::new(&patch, &law.0, None).map_err(refused)?;
        let mu = coupling.coefficient();
        let made = Loaded::new(coupling, mu, radius).map_err(refused)?;
        Ok(Self(made))
    }

    /// The radius in m under a load in N, and d ln radius/d ln load.
    fn radius(&self, load: f64) -> [f64; 2] {
        [self.0.area().radius(load), self.0.area().growth(load)]
    }

    /// Wrenches, in N and N m, of twists in m/s and rad/s under loads in N.
    #[pyo3(signature = (twists, load, out=None))]
    fn wrench<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([twists, load], out, |load, twist| {
            self.0.wrench(load, twist)
        })
    }

    /// Their derivatives by the load.
    #[pyo3(signature = (twists, load, out=None))]
    fn slope_by_load<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        load: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([twists, load], out, |load, twist| {
            self.0.slope_by_load(load, twist)
        })
    }
}
