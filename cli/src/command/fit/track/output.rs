//! What a fit of a film says and leaves behind.

use super::super::output::{line, parameter_json};
use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tribos::fit::track::{TrackFit, TrackOptions};
use tribos::fit::{Estimate, Uncertainty};
use tribos::record::{json_number, write_atomically, write_series};

/// For the person at the terminal.
pub fn text(fit: &TrackFit, options: &TrackOptions) -> String {
    let mut text = format!(
        "law           {} on a {}, I/(M R^2) = {}, g = {} m/s^2\n",
        options.law,
        options.patch,
        shown(options.inertia_ratio),
        shown(options.gravity)
    );
    for estimate in &fit.parameters {
        text += &line(estimate, estimate.parameter.unit);
    }
    let angle = fit.rms_angle.map_or(String::new(), |angle| {
        format!(", {} deg of the angle", shown(angle.to_degrees()))
    });
    text += &format!(
        "residuals     {} mm of a coordinate{angle}, over {} degrees of freedom of {} frames\n",
        shown(1e3 * fit.rms_position),
        fit.freedoms,
        fit.frames
    );
    text += &format!(
        "starts        {} of {} ended at the best minimum\n",
        fit.at_best, fit.starts
    );
    if let Some(time) = fit.rest_time {
        text += &format!("rest          at t = {} s by this fit\n", shown(time));
    }
    for warning in &fit.warnings {
        text += &format!("warning       {warning}\n");
    }
    text + &format!("as a law      {}\n", fit.law)
}

/// State of a parameter, and its standard error where it has one.
fn state(estimate: &Estimate) -> (&'static str, Option<f64>) {
    match &estimate.known {
        Uncertainty::StandardError(error) => ("fitted", Some(*error)),
        Uncertainty::Fixed => ("fixed", None),
        Uncertainty::AtBound => ("at its bound", None),
        Uncertainty::Undetermined(_) => ("not determined", None),
    }
}

/// The same for programs.
pub fn json(fit: &TrackFit, options: &TrackOptions) -> Value {
    let parameters = fit.parameters.iter();
    let parameters = parameters.map(|estimate| parameter_json(estimate, estimate.parameter.unit));
    json!({
        "law": fit.law,
        "patch": options.patch.to_string(),
        "parameters": parameters.collect::<Vec<_>>(),
        "ratio": json_number(fit.ratio),
        "rms": json_number(fit.rms_position),
        "rms_angle": fit.rms_angle.map(json_number),
        "rows": fit.frames,
        "dropped": fit.dropped.len(),
        "degrees_of_freedom": fit.freedoms,
        "starts": fit.starts,
        "starts_at_best": fit.at_best,
        "converged": fit.converged,
        "rest_time": fit.rest_time.map(json_number),
        "gravity": options.gravity,
        "inertia_ratio": options.inertia_ratio,
        "warnings": fit.warnings,
    })
}

/// Writes residuals.csv and, last, fit.toml.
pub fn write(fit: &TrackFit, options: &TrackOptions, out: &Path) -> Result<(), Failure> {
    let frames = fit.frames;
    let track = &fit.track;
    let mut columns: Vec<(&str, &[f64])> =
        vec![("t", track.times()), ("x", track.x()), ("y", track.y())];
    columns.extend(track.angle().map(|angle| ("angle", angle)));
    let mut parts = fit.residuals.chunks(frames.max(1));
    for name in ["residual_x", "residual_y", "residual_angle"] {
        columns.extend(parts.next().map(|part| (name, part)));
    }
    columns.push(("speed", &fit.speeds));
    let used: Vec<f64> = (0..frames)
        .map(|i| f64::from(u8::from(!fit.dropped.contains(&i))))
        .collect();
    columns.push(("used", &used));
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    let at = |i: usize| {
        columns
            .iter()
            .filter_map(move |(_, values)| values.get(i).copied())
    };
    let rows: Vec<Vec<f64>> = (0..frames).map(|i| at(i).collect()).collect();
    write_series(
        &out.join("residuals.csv"),
        &names,
        rows.iter().map(Vec::as_slice),
    )?;
    Ok(write_atomically(
        &out.join("fit.toml"),
        toml(fit, options).as_bytes(),
    )?)
}

fn toml(fit: &TrackFit, options: &TrackOptions) -> String {
    let mut text = format!(
        "# A fit of a film by `tribos fit --track`. `law` is for --law of `tribos wrench`.\n\
         law = \"{}\"\npatch = \"{}\"\ngravity = {:?}\ninertia_ratio = {:?}\nframes = {}\ndropped = {:?}\n\
         degrees_of_freedom = {}\nrms_position = {:?}\n",
        fit.law,
        options.patch,
        options.gravity,
        options.inertia_ratio,
        fit.frames,
        fit.dropped,
        fit.freedoms,
        fit.rms_position,
    );
    if let Some(angle) = fit.rms_angle {
        text += &format!("rms_angle = {angle:?}\n");
    }
    if let Some(time) = fit.rest_time {
        text += &format!("rest_time = {time:?}\n");
    }
    text += &format!(
        "converged = {}\nstarts = {}\nstarts_at_best = {}\nwarnings = {:?}\n",
        fit.converged, fit.starts, fit.at_best, fit.warnings
    );
    for estimate in &fit.parameters {
        let parameter = &estimate.parameter;
        let (known, error) = state(estimate);
        let error = error.map_or(String::new(), |error| {
            format!("standard_error = {error:?}\n")
        });
        text += &format!(
            "\n[parameters.{}]    # {}\nvalue = {:?}\nunit = \"{}\"\nknown = \"{known}\"\n{error}interval = {:?}\n",
            parameter.name, parameter.meaning, estimate.value, parameter.unit, estimate.interval
        );
    }
    text
}
