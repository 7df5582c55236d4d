//! Measurements from a log.

use super::log::ROLES;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::{FitError, Measurements, Motion};
use tribos::record::{LogOptions, read_log};

/// The measurements of a file.
#[derive(Debug)]
pub struct Table {
    /// The measurements, checked.
    pub data: Measurements,
    /// What was understood of a file that is not as Tribos writes it.
    pub told: Vec<String>,
    name: PathBuf,
    /// Line of each point.
    lines: Vec<u64>,
}

const EXPECTED: &str = "(columns are v,f for steady sliding or t,v,f for a record over time, either with sigma; \
    --look shows what is understood of a file)";

impl Table {
    /// Reads velocity and friction, and time and standard deviation if they are there; friction is divided by the load.
    pub fn read(path: &Path, options: &LogOptions, load: Option<f64>) -> Result<Self, Failure> {
        let explained = |failure| Failure::input(format!("{failure} {EXPECTED}"));
        let mut log = read_log(path, &ROLES, options).map_err(explained)?;
        let load = load.unwrap_or(1.0);
        let per_load = |values: Vec<f64>| values.into_iter().map(|f| f / load).collect::<Vec<_>>();
        let velocities = log.take("v").unwrap_or_default();
        let friction = per_load(log.take("f").unwrap_or_default());
        let sigma = log.take("sigma").map(per_load);
        let data = match log.take("t") {
            Some(times) => Measurements::series(times, velocities, friction, sigma),
            None => Measurements::steady(velocities, friction, sigma),
        };
        let data = data.map_err(|error| refusal(path, &log.lines, &log.brief, error))?;
        Ok(Self {
            data,
            told: log.brief,
            name: path.to_path_buf(),
            lines: log.lines,
        })
    }

    /// A refusal with file and line, where it is about a line.
    pub fn refusal(&self, error: FitError) -> Failure {
        refusal(&self.name, &self.lines, &self.told, error)
    }

    /// Names and columns of the measurements: time if there is one, velocity, friction.
    pub fn columns(&self) -> Vec<(&'static str, &[f64])> {
        let times = match self.data.motion() {
            Motion::Series { times, .. } => Some(("t", times.as_slice())),
            Motion::Steady { .. } => None,
        };
        let rest = [("v", self.data.velocities()), ("f", self.data.friction())];
        times.into_iter().chain(rest).collect()
    }

    /// Whether it is a record over time.
    pub fn is_record(&self) -> bool {
        matches!(self.data.motion(), Motion::Series { .. })
    }
}

/// A refusal with file and line, and with what was understood of the file where it is about all of it.
fn refusal(path: &Path, lines: &[u64], told: &[String], error: FitError) -> Failure {
    let name = path.display();
    match error {
        FitError::Point { point, message } => {
            let line = lines.get(point).copied().unwrap_or(1);
            Failure::input(format!("{name}:{line}: {message}"))
        }
        FitError::NoParameter { .. } | FitError::Range { .. } | FitError::NothingFree => {
            Failure::input(format!("--fix: {error}"))
        }
        error => {
            let told: String = told.iter().map(|line| format!("; {line}")).collect();
            Failure::input(format!("{name}: {error}{told}"))
        }
    }
}
