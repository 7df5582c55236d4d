//! Bodies on several feet, or on a floor of several surfaces that move.

use crate::arrays::{Output, Rows, broadcast, refused};
use crate::model::{numbers, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::threads::fill;
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use tribos::friction::{Area, Coefficients, FootOnFloor, Surface};
use tribos_core::contact::TimeStep;
use tribos_core::floor::SteadyState;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::Twist;

/// Feet on surfaces.
#[pyclass(frozen, module = "tribos._native")]
pub struct Floor(tribos::friction::Floor);

/// A border as two points, or the corners of a polygon, and the motion of the surface.
type SurfaceRow = (Vec<[f64; 2]>, [f64; 3]);
/// Patch, coefficient, load in N, place in m, angle in degrees, and the motion of the surface.
type FootRow<'py> = (PyRef<'py, Patch>, f64, f64, [f64; 2], f64, [f64; 3]);

/// Twist, friction, the foot that rests, evaluations.
type SteadyRow = ([f64; 3], [f64; 3], Option<usize>, usize);

/// Nanoseconds that a foot takes, about.
const COST: usize = 300;

fn surface((corners, twist): SurfaceRow) -> PyResult<Surface> {
    let twist = twist_of(twist);
    let made = match *corners.as_slice() {
        [from, to] => Surface::half_plane(from, [to[0] - from[0], to[1] - from[1]], twist),
        _ => Surface::polygon(&corners, twist),
    };
    made.map_err(refused)
}

impl Floor {
    /// What `of` makes of each twist, in rows of `shape`.
    fn each<'py, const N: usize>(
        &self,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
        shape: &[usize],
        of: impl Fn(&Twist<f64>) -> [f64; N] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, rows) = (twists.py(), Rows::<3>::new("twists", twists)?);
        let batch = broadcast(&[&rows])?;
        let rows = rows.over(&batch)?;
        let rows = rows.view()?;
        let mut output = Output::new(py, &batch, shape, out)?;
        let cost = COST * self.0.parts().len();
        fill(py, output.rows::<N>()?, cost, |from, piece| {
            for (index, row) in (from..).zip(piece) {
                *row = of(&twist_of(rows.at(index)));
            }
            Ok(())
        })?;
        output.finish()
    }
}

#[pymethods]
impl Floor {
    /// A patch cut along the borders of surfaces.
    #[staticmethod]
    fn under(patch: &Patch, mu: f64, load: f64, surfaces: Vec<SurfaceRow>) -> PyResult<Self> {
        let surfaces: Vec<Surface> = surfaces.into_iter().map(surface).collect::<PyResult<_>>()?;
        let mu = Coefficients::isotropic(mu).map_err(refused)?;
        let made = tribos::friction::Floor::under(&patch.0, &mu, load, &surfaces);
        Ok(Self(made.map_err(refused)?))
    }

    /// Several feet.
    #[staticmethod]
    fn feet(feet: Vec<FootRow<'_>>) -> PyResult<Self> {
        let feet: Vec<FootOnFloor<'_>> = feet
            .iter()
            .map(|(patch, mu, load, place, degrees, surface)| {
                Ok(FootOnFloor {
                    area: &patch.0,
                    mu: Coefficients::isotropic(*mu).map_err(refused)?,
                    load: *load,
                    place: *place,
                    degrees: *degrees,
                    surface: twist_of(*surface),
                })
            })
            .collect::<PyResult<_>>()?;
        let made = tribos::friction::Floor::feet(&feet);
        Ok(Self(made.map_err(refused)?))
    }

    /// All feet as one patch, which carries `limit`.
    fn patch(&self) -> PyResult<Patch> {
        Ok(Patch(Area::Flat(self.0.area().map_err(refused)?)))
    }

    /// What all feet carry together, in N.
    fn limit(&self) -> f64 {
        self.0.limit()
    }

    /// How many feet there are.
    fn count(&self) -> usize {
        self.0.parts().len()
    }

    /// Wrenches of twists.
    #[pyo3(signature = (twists, out=None))]
    fn wrench<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each(twists, out, &[3], |twist| numbers(&self.0.wrench(twist)))
    }

    /// Their derivatives; they are symmetric, so that columns are rows.
    #[pyo3(signature = (twists, out=None))]
    fn jacobian<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each::<9>(twists, out, &[3, 3], |twist| {
            let mut row = [0.0; 9];
            row.copy_from_slice(self.0.wrench_jacobian(twist).as_slice());
            row
        })
    }

    /// Twist, friction, the foot that rests and evaluations of the steady motion under a push; the name of what
    /// happens where there is none.
    fn steady_motion(&self, push: [f64; 3]) -> PyResult<SteadyRow> {
        match self.0.steady_motion(&wrench_of(push)) {
            SteadyState::Balanced(found) => Ok((
                twist_numbers(&found.twist),
                numbers(&found.friction),
                found.carried_by,
                found.evaluations,
            )),
            SteadyState::Accelerates => Err(refused(format!(
                "no motion is steady: the push is more than the {} N that friction carries, or turns harder",
                self.0.limit()
            ))),
            SteadyState::Missed(_) => Err(refused(
                "the search for the steady motion has missed it: give points a small area, such as tribos.disk",
            )),
        }
    }

    /// One time step of bodies of a mass in kg and an inertia in kg m² over a length in s: twists, friction, and whether feet rest.
    fn step<'py>(
        &self,
        twists: &Bound<'py, PyAny>,
        pushes: &Bound<'py, PyAny>,
        body: [f64; 3],
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<[Bound<'py, PyAny>; 3]> {
        let (py, [mass, inertia, dt]) = (twists.py(), body);
        let body = PlanarBody::new(mass, inertia).map_err(refused)?;
        let dt = TimeStep::new(dt).map_err(refused)?;
        let twists = Rows::<3>::new("twists", twists)?;
        let pushes = Rows::<3>::new("pushes", pushes)?;
        let batch = broadcast(&[&twists, &pushes])?;
        let (twists, pushes) = (twists.over(&batch)?, pushes.over(&batch)?);
        let (start, pushes) = (twists.view()?, pushes.view()?);
        let mut steps = vec![None; batch.iter().product()];
        let cost = 20 * COST * self.0.parts().len();
        fill(py, &mut steps, cost, |from, piece| {
            for (index, step) in (from..).zip(piece) {
                let (twist, push) = (twist_of(start.at(index)), wrench_of(pushes.at(index)));
                *step = self.0.step(&body, &twist, &push, dt);
            }
            Ok(())
        })?;
        let mut after = Output::new(py, &batch, &[3], out)?;
        let mut friction = Output::new(py, &batch, &[3], None)?;
        let rests = PyArrayDyn::<bool>::zeros(py, batch, false);
        let mut flags = rests.readwrite();
        let rows = after.rows::<3>()?.iter_mut().zip(friction.rows::<3>()?);
        for ((row, rest), step) in rows.zip(flags.as_slice_mut().map_err(refused)?).zip(steps) {
            let step = step.ok_or_else(|| refused("a floor needs feet"))?;
            *row.0 = twist_numbers(&step.twist);
            *row.1 = numbers(&step.friction);
            *rest = step.carried_by.is_some();
        }
        drop(flags);
        Ok([after.finish()?, friction.finish()?, rests.into_any()])
    }
}
