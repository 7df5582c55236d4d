//! Measurements from a CSV file.

use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::{FitError, Measurements, Motion};
use tribos::record::{Rows, TableError};

/// The measurements of a file.
#[derive(Debug)]
pub struct Table {
    /// The measurements, checked.
    pub data: Measurements,
    name: PathBuf,
    /// Line of each point.
    lines: Vec<u64>,
}

/// Headers that are understood; columns may come in any order.
const HEADERS: [&[&str]; 4] = [
    &["v", "f"],
    &["v", "f", "sigma"],
    &["t", "v", "f"],
    &["t", "v", "f", "sigma"],
];
const EXPECTED: &str =
    "(columns are v,f for steady sliding or t,v,f for a record over time, either with sigma)";

impl Table {
    /// Reads `v,f` or `t,v,f`, either with `sigma`; friction is divided by the load.
    pub fn read(path: &Path, load: Option<f64>) -> Result<Self, Failure> {
        let mut names: &[&str] = HEADERS[0];
        let explained = |failure: TableError| Failure::input(format!("{failure} {EXPECTED}"));
        let mut rows = Rows::asked_for(path, |header| {
            let [is_record, has_sigma] = ["t", "sigma"].map(|name| header.contains(&name));
            names = HEADERS[2 * usize::from(is_record) + usize::from(has_sigma)];
            names
        })
        .map_err(explained)?;
        let mut columns = vec![Vec::new(); names.len()];
        let mut row = vec![0.0; names.len()];
        let mut lines = Vec::new();
        while let Some(line) = rows.next(&mut row).map_err(explained)? {
            lines.push(line);
            for (column, value) in columns.iter_mut().zip(&row) {
                column.push(*value);
            }
        }
        let mut take = |name: &str| {
            let at = names.iter().position(|known| *known == name)?;
            columns.get_mut(at).map(std::mem::take)
        };
        let load = load.unwrap_or(1.0);
        let per_load = |values: Vec<f64>| values.into_iter().map(|f| f / load).collect::<Vec<_>>();
        let velocities = take("v").unwrap_or_default();
        let friction = per_load(take("f").unwrap_or_default());
        let sigma = take("sigma").map(per_load);
        let data = match take("t") {
            Some(times) => Measurements::series(times, velocities, friction, sigma),
            None => Measurements::steady(velocities, friction, sigma),
        };
        let data = data.map_err(|error| refusal(path, &lines, error))?;
        let name = path.to_path_buf();
        Ok(Self { data, name, lines })
    }

    /// A refusal with file and line, where it is about a line.
    pub fn refusal(&self, error: FitError) -> Failure {
        refusal(&self.name, &self.lines, error)
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

/// A refusal of measurements with the file, and the line where it is about one.
pub fn refusal(path: &Path, lines: &[u64], error: FitError) -> Failure {
    let name = path.display();
    match error {
        FitError::Point { point, message } => {
            let line = lines.get(point).copied().unwrap_or(1);
            Failure::input(format!("{name}:{line}: {message}"))
        }
        FitError::NoParameter { .. } | FitError::Range { .. } | FitError::NothingFree => {
            Failure::input(format!("--fix: {error}"))
        }
        error => Failure::input(format!("{name}: {error}")),
    }
}
