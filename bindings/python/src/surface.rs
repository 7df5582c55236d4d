//! Limit surfaces.

use crate::arrays::{Numbers, Output, Rows, View, broadcast, refused};
use crate::model::{Sets, numbers, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::threads::fill;
use pyo3::prelude::*;
use tribos_core::limit_surface::FrictionSet;

/// All wrenches that dry friction of a patch carries.
#[pyclass(frozen, module = "tribos._native")]
pub struct LimitSurface {
    /// The surfaces for every force limit.
    pub sets: Sets,
}

/// Nanoseconds that a projection takes, about.
const COST: usize = 500;

impl LimitSurface {
    /// What `of` makes of the surface of a force limit and of each row that is called `name`.
    fn each<'py, const N: usize, const M: usize>(
        &self,
        [limits, rows]: [&Bound<'py, PyAny>; 2],
        name: &'static str,
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&dyn FrictionSet<f64>, [f64; N]) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, rows) = (rows.py(), Rows::<N>::new(name, rows)?);
        let limits = Numbers::new("force limit", limits)?;
        let batch = broadcast(&[&rows, &limits])?;
        let (rows, limits) = (rows.over(&batch)?, limits.over(&batch)?);
        let (rows, limits) = (rows.view()?, limits.view()?);
        // A number, not a row of one.
        let shape: &[usize] = if M == 1 { &[] } else { &[M] };
        let mut output = Output::new(py, &batch, shape, out)?;
        fill(py, output.rows::<M>()?, COST, |from, piece| {
            if let View::One([limit]) = limits {
                return self.sets.with(limit, |set| {
                    for (index, row) in (from..).zip(piece.iter_mut()) {
                        *row = of(set, rows.at(index));
                    }
                });
            }
            for (index, row) in (from..).zip(piece.iter_mut()) {
                let [limit] = limits.at(index);
                *row = self.sets.with(limit, |set| of(set, rows.at(index)))?;
            }
            Ok(())
        })?;
        output.finish()
    }
}

#[pymethods]
impl LimitSurface {
    #[new]
    fn new(patch: &Patch) -> PyResult<Self> {
        let sets = Sets::new(&patch.0)?;
        Ok(Self { sets })
    }

    /// The ellipsoids with the same largest force and torque.
    fn ellipsoid(&self) -> PyResult<Self> {
        let sets = self.sets.ellipsoids()?;
        Ok(Self { sets })
    }

    /// The largest torque, in N m, for a force limit in N; the kernel's refusal of that limit.
    fn torque_limit(&self, force_limit: f64) -> PyResult<f64> {
        let turn = twist_of([0.0, 0.0, 1.0]);
        self.sets.with(force_limit, |set| set.support(&turn))
    }

    /// The lowest and the highest torque with each force.
    #[pyo3(signature = (force_limit, forces, out=None))]
    fn torque_limits<'py>(
        &self,
        py: Python<'py>,
        force_limit: &Bound<'py, PyAny>,
        forces: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let limits = Numbers::new("force limit", force_limit)?;
        let forces = Rows::<2>::new("forces", forces)?;
        let batch = broadcast(&[&forces, &limits])?;
        let (forces, limits) = (forces.over(&batch)?, limits.over(&batch)?);
        let (forces, limits) = (forces.view()?, limits.view()?);
        let mut output = Output::new(py, &batch, &[2], out)?;
        fill(py, output.rows::<2>()?, 10 * COST, |from, piece| {
            for (index, row) in (from..).zip(piece) {
                let [limit] = limits.at(index);
                let limits = self.sets.0.torque_limits(limit, forces.at(index));
                *row = limits.map_err(refused)?;
            }
            Ok(())
        })?;
        output.finish()
    }

    /// Gauges of wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn gauge<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([force_limit, wrenches], "wrenches", out, |set, row| {
            [set.gauge(&wrench_of(row))]
        })
    }

    /// Support function at twists: the dissipated power, in W.
    #[pyo3(signature = (force_limit, twists, out=None))]
    fn support<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([force_limit, twists], "twists", out, |set, row| {
            [set.support(&twist_of(row))]
        })
    }

    /// Friction at twists: points of the surface.
    #[pyo3(signature = (force_limit, twists, out=None))]
    fn wrench<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([force_limit, twists], "twists", out, |set, row| {
            numbers(&set.wrench(&twist_of(row)))
        })
    }

    /// Outward normals above wrenches: the motions that pushes cause.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn normal<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([force_limit, wrenches], "wrenches", out, |set, row| {
            twist_numbers(&set.twist_normal_to(&wrench_of(row)))
        })
    }

    /// The wrenches on the same rays on the surface.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn scale_to_surface<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each([force_limit, wrenches], "wrenches", out, |set, row| {
            numbers(&set.scale_to_surface(&wrench_of(row)))
        })
    }

    /// The nearest wrenches of the set, measured with `length`, in m; None for the radius.
    #[pyo3(signature = (force_limit, wrenches, length=None, out=None))]
    fn project<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        length: Option<f64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let Some(length) = length.filter(|length| !(*length > 0.0 && length.is_finite())) {
            return Err(refused(format!(
                "length must be > 0 and finite, not {length}"
            )));
        }
        self.each([force_limit, wrenches], "wrenches", out, |set, row| {
            let length = length.unwrap_or(set.radius());
            numbers(&set.project_with_length(&wrench_of(row), length).wrench)
        })
    }
}
