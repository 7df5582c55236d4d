//! Measurements from a CSV file.

use crate::command::columns;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::{Data, DataError};

/// The columns of a file.
#[derive(Debug)]
pub struct Table {
    /// The file.
    pub name: PathBuf,
    /// Line of each row.
    pub lines: Vec<u64>,
    times: Option<Vec<f64>>,
    velocities: Vec<f64>,
    friction: Vec<f64>,
    sigma: Option<Vec<f64>>,
}

impl Table {
    /// Reads `v,f` or `t,v,f`, either with `sigma`; friction is divided by the load.
    pub fn read(path: &Path, load: Option<f64>) -> Result<Self, Failure> {
        let text = columns::text(path)?;
        let header = columns::header(&text);
        let has = |name: &str| header.iter().any(|column| column == name);
        let names: &[&str] = match (has("t"), has("sigma")) {
            (false, false) => &["v", "f"],
            (false, true) => &["v", "f", "sigma"],
            (true, false) => &["v", "f", "t"],
            (true, true) => &["v", "f", "t", "sigma"],
        };
        let rows = match *names {
            [a, b] => widened(columns::parse(&text, [a, b])),
            [a, b, c] => widened(columns::parse(&text, [a, b, c])),
            _ => widened(columns::parse(&text, ["v", "f", "t", "sigma"])),
        }
        .map_err(|message| {
            Failure::input(format!(
                "{}:{message} (columns are v,f for steady sliding or t,v,f for a record over time, \
                 either with sigma)",
                path.display()
            ))
        })?;
        let column = |name: &str| -> Option<Vec<f64>> {
            let at = names.iter().position(|known| *known == name)?;
            rows.iter().map(|(_, row)| row.get(at).copied()).collect()
        };
        let load = load.unwrap_or(1.0);
        let per_load = |values: Vec<f64>| values.into_iter().map(|f| f / load).collect::<Vec<_>>();
        Ok(Self {
            name: path.to_path_buf(),
            lines: rows.iter().map(|(line, _)| *line).collect(),
            times: column("t"),
            velocities: column("v").unwrap_or_default(),
            friction: per_load(column("f").unwrap_or_default()),
            sigma: column("sigma").map(per_load),
        })
    }

    /// The measurements, checked.
    pub fn data(&self) -> Result<Data, DataError> {
        let (v, f, sigma) = (
            self.velocities.clone(),
            self.friction.clone(),
            self.sigma.clone(),
        );
        match &self.times {
            Some(times) => Data::series(times.clone(), v, f, sigma),
            None => Data::steady(v, f, sigma),
        }
    }

    /// Names and columns of the measurements: time if there is one, velocity, friction.
    pub fn columns(&self) -> Vec<(&'static str, &[f64])> {
        let times = self.times.as_deref().map(|times| ("t", times));
        let rest = [
            ("v", self.velocities.as_slice()),
            ("f", self.friction.as_slice()),
        ];
        times.into_iter().chain(rest).collect()
    }

    /// Whether it is a record over time.
    pub fn is_record(&self) -> bool {
        self.times.is_some()
    }

    /// Standard deviations, if known.
    pub fn sigma(&self) -> Option<&[f64]> {
        self.sigma.as_deref()
    }
}

/// A row with its line.
type Row = (u64, Vec<f64>);

fn widened<const N: usize>(rows: Result<Vec<(u64, [f64; N])>, String>) -> Result<Vec<Row>, String> {
    Ok(rows?
        .into_iter()
        .map(|(line, row)| (line, row.to_vec()))
        .collect())
}
