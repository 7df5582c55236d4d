//! Derivatives of limit surfaces and of steps, row by row.

use super::part;
use super::smooth::{Ellipsoids, Family, Smooth, family};
use super::step::{AFTER, BY, STEP, StepGradient, moved};
use crate::arrays::{Numbers, Output, Rows, View, broadcast, refused};
use crate::model::{Sets, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::threads::fill;
use nalgebra::Matrix3;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use tribos_core::contact::TimeStep;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::Wrench;

/// Nanoseconds that a derivative takes, about.
const COST: usize = 1500;

/// Derivatives of the limit surfaces of a patch, and of steps on it.
#[pyclass(frozen, module = "tribos._native")]
pub struct SurfaceDerivatives {
    family: Box<dyn Family>,
}

impl SurfaceDerivatives {
    /// What `of` makes of the surface and of each row, as matrices or rows of `shape`.
    fn each<'py, const M: usize>(
        &self,
        (name, limits, rows): (&'static str, &Bound<'py, PyAny>, &Bound<'py, PyAny>),
        shape: &[usize],
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&dyn Smooth, [f64; 3]) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = rows.py();
        let rows = Rows::<3>::new(name, rows)?;
        let limits = Numbers::new("force limit", limits)?;
        let batch = broadcast(&[&rows, &limits])?;
        let (rows, limits) = (rows.over(&batch)?, limits.over(&batch)?);
        let (rows, limits) = (rows.view()?, limits.view()?);
        let mut output = Output::new(py, &batch, shape, out)?;
        fill(py, output.rows::<M>()?, COST, |from, piece| {
            if let View::One([limit]) = limits {
                return self.family.with(limit, &mut |surface| {
                    for (index, row) in (from..).zip(piece.iter_mut()) {
                        *row = of(surface, rows.at(index));
                    }
                });
            }
            for (index, row) in (from..).zip(piece.iter_mut()) {
                let [limit] = limits.at(index);
                let mut work = |surface: &dyn Smooth| *row = of(surface, rows.at(index));
                self.family.with(limit, &mut work)?;
            }
            Ok(())
        })?;
        output.finish()
    }

    /// Steps and derivatives of a batch.
    fn steps(
        &self,
        [twists, pushes]: [&Bound<'_, PyAny>; 2],
        [limits, mass, inertia, dt]: [&Bound<'_, PyAny>; 4],
    ) -> PyResult<(Vec<usize>, Vec<[f64; STEP]>)> {
        let py = twists.py();
        let limits = Numbers::new("load", limits)?;
        let twists = Rows::<3>::new("twists", twists)?;
        let pushes = Rows::<3>::new("pushes", pushes)?;
        let mass = Numbers::new("mass", mass)?;
        let inertia = Numbers::new("inertia", inertia)?;
        let dt = Numbers::new("dt", dt)?;
        let batch = broadcast(&[&twists, &pushes, &limits, &mass, &inertia, &dt])?;
        let (twists, pushes) = (twists.over(&batch)?, pushes.over(&batch)?);
        let (twists, pushes) = (twists.view()?, pushes.view()?);
        let (limits, mass) = (limits.over(&batch)?, mass.over(&batch)?);
        let (inertia, dt) = (inertia.over(&batch)?, dt.over(&batch)?);
        let (limits, mass, inertia, dt) =
            (limits.view()?, mass.view()?, inertia.view()?, dt.view()?);
        let mut rows = vec![[0.0; STEP]; batch.iter().product()];
        fill(py, &mut rows, COST, |from, piece| {
            for (index, row) in (from..).zip(piece.iter_mut()) {
                let ([mass], [inertia], [dt]) = (mass.at(index), inertia.at(index), dt.at(index));
                let [limit] = limits.at(index);
                let mut body = StepGradient {
                    body: PlanarBody::new(mass, inertia).map_err(refused)?,
                    dt: TimeStep::new(dt).map_err(refused)?,
                    twist: twist_of(twists.at(index)),
                    push: wrench_of(pushes.at(index)),
                    first: Wrench::ZERO,
                };
                if limit == 0.0 {
                    let twist = body.resisted();
                    let mut work = |unit: &dyn Smooth| body.first = unit.set().wrench(&twist);
                    self.family.with(1.0, &mut work)?;
                }
                self.family
                    .with(limit, &mut |surface| *row = moved(surface, &body))?;
            }
            Ok(())
        })?;
        Ok((batch, rows))
    }
}

/// A matrix as its rows.
fn by_rows(matrix: &Matrix3<f64>) -> [f64; 9] {
    let mut rows = [0.0; 9];
    rows.copy_from_slice(matrix.transpose().as_slice());
    rows
}

fn validated(length: Option<f64>) -> PyResult<()> {
    match length {
        Some(length) if !(length > 0.0 && length.is_finite()) => Err(refused(format!(
            "length must be > 0 and finite, not {length}"
        ))),
        _ => Ok(()),
    }
}

#[pymethods]
impl SurfaceDerivatives {
    #[new]
    fn new(patch: &Patch) -> PyResult<Self> {
        let family = family(&patch.0)?;
        Ok(Self { family })
    }

    /// Those of the ellipsoids with the same largest force and torque.
    #[staticmethod]
    fn of_ellipsoids(patch: &Patch) -> PyResult<Self> {
        let sets = Sets::new(&patch.0)?.ellipsoids()?;
        let turn = twist_of([0.0, 0.0, 1.0]);
        let arm = sets.with(1.0, |set| set.support(&turn))?;
        let family = Box::new(Ellipsoids { sets, arm });
        Ok(Self { family })
    }

    /// Gradients of the gauge at wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn gauge_gradient<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3], out, |surface, row| {
            twist_numbers(&surface.gauge_derivatives(&wrench_of(row)).0)
        })
    }

    /// Hessians of the gauge at wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn gauge_hessian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.gauge_derivatives(&wrench_of(row)).1)
        })
    }

    /// Derivatives of the normals above wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn normal_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.normal_jacobian(&wrench_of(row)))
        })
    }

    /// Derivatives of the nearest wrenches; None as length for the radius.
    #[pyo3(signature = (force_limit, wrenches, length=None, out=None))]
    fn project_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        length: Option<f64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        validated(length)?;
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            let length = length.unwrap_or(surface.set().radius());
            by_rows(&surface.project(&wrench_of(row), length).1)
        })
    }

    /// Hessians of the support function at twists.
    #[pyo3(signature = (force_limit, twists, out=None))]
    fn support_hessian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("twists", force_limit, twists);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.support_hessian(&twist_of(row)))
        })
    }

    /// Implicit steps of bodies: twists after, mean friction, 1 at rest or else 0, and the derivatives of
    /// the first two by twist, push, force limit, mass, inertia and time.
    fn planar_step_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        pushes: &Bound<'py, PyAny>,
        mass: &Bound<'py, PyAny>,
        inertia: &Bound<'py, PyAny>,
        dt: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let py = twists.py();
        let (rows, numbers) = ([twists, pushes], [force_limit, mass, inertia, dt]);
        let (batch, rows) = self.steps(rows, numbers)?;
        let parts = [
            part::<STEP, 3>(py, &batch, &[3], &rows, 0)?,
            part::<STEP, 3>(py, &batch, &[3], &rows, 3)?,
            part::<STEP, 1>(py, &batch, &[], &rows, 6)?,
            part::<STEP, { 6 * BY }>(py, &batch, &[6, BY], &rows, AFTER)?,
        ];
        PyTuple::new(py, parts)
    }
}
