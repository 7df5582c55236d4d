//! Parameters of laws from measurements, and pressures from pushes.

use crate::arrays::refused;
use crate::patch::Patch;
use crate::threads::detached;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribos::fit::support::{MeasuredPush, SupportFit, fit_support_within};
use tribos::fit::{
    Apparatus, Estimate, Fit, FitColumns, FitError, FitLaw, FitOptions, FittedLaw, Measurements,
    Uncertainty, Usage, UsageTarget, compare,
};
use tribos::friction::{Area, Flat};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::nodes::NodePatch;
use tribos_core::twist::{Twist, Wrench};

/// Names of the laws that can be fitted, and what is fitted.
#[pyfunction]
pub fn fit_laws() -> Vec<[&'static str; 2]> {
    FitLaw::ALL.map(|(_, name, help)| [name, help]).to_vec()
}

/// Columns by role: velocities, friction; times, standard deviations, accelerations and loads if there are any.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Columns {
    v: Vec<f64>,
    f: Vec<f64>,
    t: Option<Vec<f64>>,
    sigma: Option<Vec<f64>>,
    a: Option<Vec<f64>>,
    load: Option<Vec<f64>>,
    rest: f64,
    inertia: bool,
    offset: bool,
}

impl From<Columns> for FitColumns {
    fn from(columns: Columns) -> Self {
        Self {
            times: columns.t,
            velocities: columns.v,
            friction: columns.f,
            sigma: columns.sigma,
            acceleration: columns.a,
            load: columns.load,
            rest: columns.rest,
            has_offset: columns.offset,
            wants_acceleration: columns.inertia,
        }
    }
}

/// Inertia, offset and spring of the machine: whether they are fitted.
type Machine = (bool, bool, bool);

fn apparatus((inertia, offset, spring): Machine) -> Apparatus {
    Apparatus {
        inertia,
        offset,
        spring,
    }
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
    machine: Machine,
    fixed: Vec<(String, f64)>,
    starts: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let law: FitLaw = law.parse().map_err(refused)?;
    let found = detached(py, || {
        let prepared = FitColumns::from(columns).prepared(Some(law))?;
        let data = &prepared.data;
        let model = law.model_on(data, apparatus(machine))?;
        let fit = data.fit(model.as_ref(), &FitOptions { fixed, starts })?;
        Ok((
            fit,
            [prepared.resting, prepared.lifted],
            data.load().is_some(),
        ))
    })?;
    let (fit, left_out, is_per_load) = found.map_err(told)?;
    let answer = result(py, law, &fit, is_per_load)?;
    answer.set_item("left_out", left_out)?;
    Ok(answer)
}

/// Fits all laws: those that the data admit, the best first, and why others are left out.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "two lists")]
pub fn fit_all_laws<'py>(
    py: Python<'py>,
    columns: Columns,
    machine: Machine,
    fixed: Vec<(String, f64)>,
    starts: usize,
) -> PyResult<(Vec<Bound<'py, PyDict>>, Vec<(&'static str, String)>)> {
    let found = detached(py, || {
        let prepared = FitColumns::from(columns).prepared(None)?;
        let (data, options) = (&prepared.data, FitOptions { fixed, starts });
        let found = compare(data, apparatus(machine), &options, &mut |_, _| ());
        let per_load = found.0.iter();
        let per_load = per_load.map(|one| one.law.is_per_load(data, &one.fit));
        let per_load: Vec<bool> = per_load.collect();
        Ok((found, [prepared.resting, prepared.lifted], per_load))
    })?;
    let ((all, refusals), left_out, per_load) = found.map_err(told)?;
    let all = all.iter().zip(per_load).map(|(one, is_per_load)| {
        let answer = result(py, one.law, &one.fit, is_per_load)?;
        answer.set_item("left_out", left_out)?;
        answer.set_item("akaike", one.akaike)?;
        answer.set_item("foretold", one.foretold)?;
        answer.set_item("is_told_apart", one.is_told_apart)?;
        Ok(answer)
    });
    let refusals = refusals
        .into_iter()
        .map(|(law, why)| (law.name(), why.to_string()));
    Ok((all.collect::<PyResult<_>>()?, refusals.collect()))
}

/// A fitted law as a program, a scene or coefficients of a simulator.
#[pyfunction]
pub fn fit_usage(
    law: &str,
    parameters: Vec<(String, f64)>,
    is_per_load: bool,
    target: &str,
) -> PyResult<String> {
    const TARGETS: [(&str, UsageTarget); 7] = [
        ("rust", UsageTarget::Rust),
        ("c", UsageTarget::C),
        ("python", UsageTarget::Python),
        ("scene", UsageTarget::Scene),
        ("mujoco", UsageTarget::MuJoCo),
        ("newton", UsageTarget::Newton),
        ("gazebo", UsageTarget::Gazebo),
    ];
    let found = TARGETS.into_iter().find(|(name, _)| *name == target);
    let (_, target) = found.ok_or_else(|| {
        let names = TARGETS.map(|(name, _)| name).join(", ");
        refused(format!("there is no target `{target}`; there are {names}"))
    })?;
    let parameters = parameters
        .iter()
        .map(|(name, value)| (name.as_str(), *value));
    let parameters: Vec<(&str, f64)> = parameters.collect();
    let fitted = FittedLaw {
        law,
        parameters: &parameters,
        is_per_load,
    };
    match fitted.usage(target).map_err(refused)? {
        Usage::Text(text) => Ok(text),
        Usage::NotPossible(why) => Err(refused(why)),
    }
}

/// Fitted parameters, a dictionary each.
pub fn entries<'py>(py: Python<'py>, estimates: &[Estimate]) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let entries = estimates.iter().map(|estimate| {
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
        entry.set_item("interval", estimate.interval)?;
        entry.set_item("error", error)?;
        entry.set_item("state", state)?;
        entry.set_item("trades_with", others)?;
        Ok(entry)
    });
    entries.collect()
}

fn result<'py>(
    py: Python<'py>,
    law: FitLaw,
    fit: &Fit,
    is_per_load: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let count = fit.covariance.nrows();
    let covariance = (0..count).map(|i| (0..count).map(|j| fit.covariance[(i, j)]).collect());
    let answer = PyDict::new(py);
    answer.set_item("estimates", entries(py, &fit.parameters)?)?;
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
    answer.set_item("error_factor", fit.error_factor)?;
    let warnings = fit.cautions.iter().map(ToString::to_string);
    answer.set_item("warnings", warnings.collect::<Vec<_>>())?;
    let parameters = fit.parameters.iter();
    let parameters: Vec<(&str, f64)> = parameters
        .map(|estimate| (estimate.parameter.name, estimate.value))
        .collect();
    let fitted = FittedLaw {
        law: law.name(),
        parameters: &parameters,
        is_per_load,
    };
    answer.set_item("name", law.name())?;
    answer.set_item("is_per_load", is_per_load)?;
    answer.set_item("law", fitted.spec().map_err(refused)?)?;
    Ok(answer)
}

/// Friction of a law with these values at velocities, or along a record over time that begins in steady sliding.
#[pyfunction]
pub fn predict_law(
    py: Python<'_>,
    law: &str,
    velocities: Vec<f64>,
    times: Option<Vec<f64>>,
    values: Vec<f64>,
    spring: bool,
) -> PyResult<Vec<f64>> {
    let law: FitLaw = law.parse().map_err(refused)?;
    let predicted = detached(py, || {
        // Models take their places from the data alone: any friction along the motion serves.
        let friction = velocities.iter().map(|v| v.signum()).collect();
        let data = match times {
            Some(times) => Measurements::series(times, velocities, friction, None)?,
            None => Measurements::steady(velocities, friction, None)?,
        };
        let machine = apparatus((false, false, spring));
        Ok(law.model_on(&data, machine)?.foretell(&values))
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
