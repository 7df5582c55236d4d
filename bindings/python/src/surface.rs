//! Limit surfaces.

use crate::arrays::{Numbers, Output, Rows, broadcast, refused};
use crate::model::{Sets, numbers, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::threads::fill;
use pyo3::prelude::*;
use tribos::friction::{FrictionError, SurfaceBatch};
use tribos_core::limit_surface::{FrictionSet, Projection, Region};
use tribos_core::twist::{Twist, Wrench};

/// All wrenches that dry friction of a patch carries.
#[pyclass(frozen, module = "tribos._native")]
pub struct LimitSurface {
    /// The surfaces for every force limit.
    pub sets: Sets,
    /// Nanoseconds that a projection takes, about.
    cost: usize,
}

impl LimitSurface {
    /// What `of` makes of force limits and the rows that are called `name`, piece by piece.
    fn pieces<'py, const N: usize, const M: usize>(
        &self,
        [limits, rows]: [&Bound<'py, PyAny>; 2],
        name: &'static str,
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&[f64], &[[f64; N]], &mut [[f64; M]]) -> Result<(), FrictionError> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, rows) = (rows.py(), Rows::<N>::new(name, rows)?);
        let limits = Numbers::new("force limit", limits)?;
        let batch = broadcast(&[&rows, &limits])?;
        let (rows, limits) = (rows.over(&batch)?, limits.over(&batch)?);
        let (rows, limits) = (rows.view()?, limits.view()?);
        // A number, not a row of one.
        let shape: &[usize] = if M == 1 { &[] } else { &[M] };
        let mut output = Output::new(py, &batch, shape, out)?;
        fill(py, output.rows::<M>()?, self.cost, |from, piece| {
            let of_piece = from..from + piece.len();
            let limits = limits.rows(of_piece.clone());
            of(limits.as_flattened(), &rows.rows(of_piece), piece).map_err(refused)
        })?;
        output.finish()
    }

    /// What `of` makes of the surface of a force limit and of each row.
    fn each<'py, const N: usize, const M: usize>(
        &self,
        given: [&Bound<'py, PyAny>; 2],
        name: &'static str,
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&dyn FrictionSet<f64>, [f64; N]) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.pieces(given, name, out, |limits, rows, piece| {
            let mut all = rows.iter().zip(piece);
            for (count, set) in self.sets.0.runs(limits)? {
                for (row, to) in all.by_ref().take(count) {
                    *to = of(&*set, *row);
                }
            }
            Ok(())
        })
    }

    /// What the batch `of` writes over `blank` elements for force limits and wrenches, as rows.
    fn batch<'py, T: Clone + Sync, const M: usize>(
        &self,
        given: [&Bound<'py, PyAny>; 2],
        out: Option<&Bound<'py, PyAny>>,
        blank: T,
        of: impl Fn(&SurfaceBatch<'_>, &[Wrench<f64>], &mut [T]) + Sync,
        row: impl Fn(&T) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.pieces(given, "wrenches", out, |limits, rows, piece| {
            let wrenches: Vec<_> = rows.iter().map(|row| wrench_of(*row)).collect();
            let mut found = vec![blank.clone(); piece.len()];
            of(&self.sets.0.under_each(limits)?, &wrenches, &mut found);
            for (to, found) in piece.iter_mut().zip(&found) {
                *to = row(found);
            }
            Ok(())
        })
    }
}

#[pymethods]
impl LimitSurface {
    #[new]
    fn new(patch: &Patch) -> PyResult<Self> {
        let sets = Sets::new(&patch.0)?;
        let cost = if patch.0.is_round() { 150 } else { 1_000 };
        Ok(Self { sets, cost })
    }

    /// The ellipsoids with the same largest force and torque.
    fn ellipsoid(&self) -> PyResult<Self> {
        let sets = self.sets.ellipsoids()?;
        Ok(Self { sets, cost: 50 })
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
        fill(py, output.rows::<2>()?, 10 * self.cost, |from, piece| {
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
        let of = |surfaces: &SurfaceBatch<'_>, wrenches: &[_], gauges: &mut [_]| {
            surfaces.gauge_batch(wrenches, gauges);
        };
        self.batch([force_limit, wrenches], out, 0.0, of, |gauge| [*gauge])
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
        let of = |surfaces: &SurfaceBatch<'_>, pushes: &[_], twists: &mut [_]| {
            surfaces.twist_normal_to_batch(pushes, twists);
        };
        self.batch([force_limit, wrenches], out, Twist::ZERO, of, twist_numbers)
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
        let blank = Projection {
            wrench: Wrench::ZERO,
            region: Region::Inside,
        };
        let of = |surfaces: &SurfaceBatch<'_>, wrenches: &[_], found: &mut [_]| {
            surfaces.project_batch(length, wrenches, found);
        };
        self.batch([force_limit, wrenches], out, blank, of, |found| {
            numbers(&found.wrench)
        })
    }
}
