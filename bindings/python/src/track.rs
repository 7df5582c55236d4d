//! Friction, radius and launch of filmed bodies.

use crate::arrays::refused;
use crate::fit::entries;
use crate::threads::detached;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribos::fit::FitError;
use tribos::fit::track::{Track, TrackFit, TrackOptions, fit_track as fit};
use tribos::friction::Patch;

/// Times, x, y, and angles if there are any.
type Columns = (Vec<f64>, Vec<f64>, Vec<f64>, Option<Vec<f64>>);
/// Gravity, inertia ratio, and noise of positions and of angles where it is known.
type Surroundings = (f64, f64, Option<f64>, Option<f64>);
/// Frames that are skipped, first and last time, starts.
type Choice = (usize, Option<f64>, Option<f64>, usize);

/// Fits the motion of a filmed body.
#[pyfunction]
pub fn fit_track<'py>(
    py: Python<'py>,
    columns: Columns,
    law: &str,
    patch: &str,
    fixed: Vec<(String, f64)>,
    surroundings: Surroundings,
    choice: Choice,
) -> PyResult<Bound<'py, PyDict>> {
    let (times, x, y, angle) = columns;
    let (gravity, inertia_ratio, noise_position, noise_angle) = surroundings;
    let (skip, from, to, starts) = choice;
    let options = TrackOptions {
        law: law.parse().map_err(refused)?,
        patch: patch.parse::<Patch>().map_err(refused)?,
        gravity,
        inertia_ratio,
        fixed,
        starts,
        skip,
        from,
        to,
        noise_position,
        noise_angle,
    };
    let found = detached(py, || fit(&Track::new(times, x, y, angle)?, &options))?;
    let found = found.map_err(|error| match error {
        FitError::Point { point, message } => refused(format!("frame {point}: {message}")),
        other => refused(other),
    })?;
    result(py, &found)
}

fn result<'py>(py: Python<'py>, fit: &TrackFit) -> PyResult<Bound<'py, PyDict>> {
    let answer = PyDict::new(py);
    answer.set_item("estimates", entries(py, &fit.parameters)?)?;
    answer.set_item("law", &fit.law)?;
    answer.set_item("rms", fit.rms_position)?;
    answer.set_item("rms_angle", fit.rms_angle)?;
    answer.set_item("rows", fit.frames)?;
    answer.set_item("dropped", &fit.dropped)?;
    answer.set_item("freedoms", fit.freedoms)?;
    answer.set_item("converged", fit.converged)?;
    answer.set_item("starts", fit.starts)?;
    answer.set_item("at_best", fit.at_best)?;
    answer.set_item("residuals", &fit.residuals)?;
    answer.set_item("times", fit.track.times())?;
    answer.set_item("speeds", &fit.speeds)?;
    answer.set_item("ratio", fit.ratio)?;
    answer.set_item("rest_time", fit.rest_time)?;
    answer.set_item("warnings", &fit.warnings)?;
    Ok(answer)
}
