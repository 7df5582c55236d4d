//! Parameters of laws from measurements, and pressures from pushes.

use crate::arrays::refused;
use crate::patch::Patch;
use crate::threads::detached;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribos::fit::support::{MeasuredPush, SupportFit, fit_support_within};
use tribos::fit::{Fit, FitError, FitLaw, FitOptions, Measurements, Uncertainty};
use tribos::friction::{Area, Flat};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::nodes::NodePatch;
use tribos_core::twist::{Twist, Wrench};

/// Names of the laws that can be fitted, what is fitted, and their names in the catalogue: steady, over
/// time.
#[pyfunction]
pub fn fit_laws() -> Vec<[&'static str; 4]> {
    let row = |(law, name, help): (FitLaw, _, _)| [name, help, law.steady(), law.over_time()];
    FitLaw::ALL.map(row).to_vec()
}

/// Velocities, friction, and times and standard deviations if there are any.
type Columns = (Vec<f64>, Vec<f64>, Option<Vec<f64>>, Option<Vec<f64>>);

fn data((velocities, friction, times, sigma): Columns) -> Result<Measurements, FitError> {
    Ok(match times {
        None => Measurements::steady(velocities, friction, sigma)?,
        Some(times) => Measurements::series(times, velocities, friction, sigma)?,
    })
}

/// A refusal of measurements, with the point that it is about.
pub fn told(error: FitError) -> PyErr {
    match error {
        FitError::Point { point, message } => refused(format!("point {point}: {message}")),
        FitError::Push { push, message } => refused(format!("push {push}: {message}")),
        other => refused(other),
    }
}

/// Fits a law.
#[pyfunction]
pub fn fit_law<'py>(
    py: Python<'py>,
    law: &str,
    columns: Columns,
    fixed: Vec<(String, f64)>,
    starts: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let law: FitLaw = law.parse().map_err(refused)?;
    let found = detached(py, || {
        let data = data(columns)?;
        let model = law.model(&data)?;
        data.fit(model.as_ref(), &FitOptions { fixed, starts })
    })?;
    result(py, &found.map_err(told)?)
}

fn result<'py>(py: Python<'py>, fit: &Fit) -> PyResult<Bound<'py, PyDict>> {
    let estimates = fit.parameters.iter().map(|estimate| {
        let parameter = &estimate.parameter;
        let entry = PyDict::new(py);
        entry.set_item("name", parameter.name)?;
        entry.set_item("unit", parameter.unit)?;
        entry.set_item("meaning", parameter.meaning)?;
        entry.set_item("value", estimate.value)?;
        let (error, state, others) = match &estimate.known {
            Uncertainty::StandardError(error) => (*error, "determined", Vec::new()),
            Uncertainty::Fixed => (0.0, "fixed", Vec::new()),
            Uncertainty::AtBound => (f64::NAN, "at its bound", Vec::new()),
            Uncertainty::Undetermined(others) => (f64::NAN, "not determined", others.clone()),
        };
        entry.set_item("error", error)?;
        entry.set_item("state", state)?;
        entry.set_item("trades_with", others)?;
        Ok(entry)
    });
    let estimates: PyResult<Vec<_>> = estimates.collect();
    let count = fit.covariance.nrows();
    let covariance = (0..count).map(|i| (0..count).map(|j| fit.covariance[(i, j)]).collect());
    let answer = PyDict::new(py);
    answer.set_item("estimates", estimates?)?;
    answer.set_item("covariance", covariance.collect::<Vec<Vec<f64>>>())?;
    answer.set_item("predictions", &fit.predictions)?;
    answer.set_item("cost", fit.cost)?;
    answer.set_item("deviation", fit.deviation())?;
    answer.set_item("freedoms", fit.freedoms)?;
    answer.set_item("is_weighted", fit.is_weighted)?;
    answer.set_item("converged", fit.converged)?;
    answer.set_item("starts", fit.starts)?;
    answer.set_item("at_best", fit.at_best)?;
    answer.set_item("iterations", fit.iterations)?;
    answer.set_item("searched", fit.searched)?;
    Ok(answer)
}

/// Friction of a law with these values at speeds, or along a record over time.
#[pyfunction]
pub fn predict_law(
    py: Python<'_>,
    law: &str,
    velocities: Vec<f64>,
    times: Option<Vec<f64>>,
    values: Vec<f64>,
) -> PyResult<Vec<f64>> {
    let law: FitLaw = law.parse().map_err(refused)?;
    let predicted = detached(py, || {
        // Any friction along the motion serves: models take their places from the data alone.
        let friction = velocities.iter().map(|v| v.signum()).collect();
        let data = data((velocities, friction, times, None))?;
        Ok(law.model(&data)?.predict(&values))
    })?;
    let refusal = || refused("the law refuses these values");
    predicted.map_err(told)?.ok_or_else(refusal)
}

/// The limit surface of μN = 1 on a patch with straight edges.
fn unit_surface(area: &Area) -> PyResult<Box<dyn FrictionSet<f64>>> {
    const LIMIT: f64 = 1.0;
    match area {
        Area::Round(..) | Area::Flat(Flat::Points(_)) => Err(refused(
            "a support is a box, a polygon, a bar, a mesh or points",
        )),
        Area::Flat(flat) => {
            let surface = ShapeLimitSurface::new(flat.clone(), LIMIT);
            Ok(Box::new(surface.map_err(refused)?))
        }
    }
}

/// Fits the pressure under a foot to rows of motion and wrench; `loops` are the corners of the patch.
#[pyfunction]
pub fn fit_support<'py>(
    py: Python<'py>,
    pushes: Vec<[f64; 6]>,
    patch: Option<&Patch>,
    loops: Vec<Vec<[f64; 2]>>,
) -> PyResult<Bound<'py, PyDict>> {
    let push = |[x, y, turn, fx, fy, torque]: [f64; 6]| MeasuredPush {
        motion: Twist::new(x, y, turn),
        wrench: Wrench::new(fx, fy, torque),
    };
    let pushes: Vec<MeasuredPush> = pushes.into_iter().map(push).collect();
    let area = patch.map(|patch| &patch.0);
    let fit: PyResult<SupportFit> = detached(py, || {
        match area {
            None => SupportFit::new(&pushes, None),
            Some(Area::Flat(Flat::Points(points))) => {
                SupportFit::at(&pushes, points.nodes().nodes())
            }
            Some(area) => fit_support_within(&pushes, &loops, unit_surface(area)?),
        }
        .map_err(told)
    })?;
    let fit = fit?;
    let models = fit.models.iter();
    let models = models.map(|score| (score.name, score.median, score.mean));
    let pressure = fit
        .pressure
        .iter()
        .map(|node| [node.x, node.y, node.weight]);
    let answer = PyDict::new(py);
    answer.set_item("models", models.collect::<Vec<_>>())?;
    answer.set_item("pressure", pressure.collect::<Vec<_>>())?;
    answer.set_item("centre_of_pressure", fit.centre_of_pressure)?;
    answer.set_item("force_limit", fit.force_limit)?;
    answer.set_item("length", fit.length)?;
    Ok(answer)
}
