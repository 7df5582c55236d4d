//! Measurements from a log.

use super::apparatus::Machine;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::{FitColumns, FitError, FitLaw, Measurements, Motion, Prepared};
use tribos::record::{LogOptions, LogRole, read_log};

/// The measurements of a file.
#[derive(Debug)]
pub struct Table {
    /// The measurements, checked.
    pub data: Measurements,
    /// What was understood of a file that is not as Tribos writes it, and which rows were left out.
    pub told: Vec<String>,
    /// Rows that were left out, by reason.
    pub dropped: Vec<(String, u64)>,
    /// Units in SI of friction and velocity, if the file has them.
    pub units: [Option<&'static str>; 2],
    name: PathBuf,
    /// Line of each point.
    lines: Vec<u64>,
}

const EXPECTED: &str = "(columns are v,f for steady sliding or t,v,f for a record over time, either with sigma; \
    --look shows what is understood of a file)";

/// Columns of measurements that a fit may read; those that it needs are marked.
pub const ROLES: [LogRole; 7] = [
    LogRole::TIME,
    LogRole::VELOCITY.needed(),
    LogRole::FRICTION.needed(),
    LogRole::DEVIATION,
    LogRole::POSITION,
    LogRole::ACCELERATION,
    LogRole::LOAD,
];

impl Table {
    /// Reads velocity and friction, and what else there is, for a law or for all of them.
    pub fn read(
        path: &Path,
        options: &LogOptions,
        machine: &Machine,
        law: Option<FitLaw>,
    ) -> Result<Self, Failure> {
        let explained = |failure| Failure::input(format!("{failure} {EXPECTED}"));
        let mut roles = vec![
            LogRole::TIME,
            LogRole::VELOCITY.needed(),
            LogRole::FRICTION.needed(),
            LogRole::DEVIATION,
            LogRole::POSITION,
            // Many logs hold a load beside a coefficient that is per load already: its own name counts, and what is asked for.
            match law {
                Some(FitLaw::Amontons) => LogRole::LOAD.needed(),
                _ => LogRole::LOAD.by_own_name(),
            },
        ];
        roles.extend(machine.inertia.then_some(LogRole::ACCELERATION));
        let mut log = read_log(path, &roles, options).map_err(explained)?;
        let friction = log.take("f").unwrap_or_default();
        let given = machine.load.map(|load| vec![load; friction.len()]);
        let column = log.take("load");
        if given.is_some() && column.is_some() {
            return Err(Failure::input(format!(
                "{}: the column load and --load are both given; leave one out, such as by --columns load=none",
                path.display()
            )));
        }
        let columns = FitColumns {
            times: log.take("t"),
            velocities: log.take("v").unwrap_or_default(),
            friction,
            sigma: log.take("sigma"),
            acceleration: log.take("a").filter(|_| machine.inertia),
            load: given.or(column),
            rest: machine.slowest,
            has_offset: machine.offset,
            wants_acceleration: machine.inertia,
        };
        let found = columns.prepared(law);
        let found = found.map_err(|error| refusal(path, &log.lines, &log.brief, error))?;
        let dropped = log
            .dropped
            .iter()
            .map(|(why, count)| (why.name().to_owned(), *count));
        let mut dropped: Vec<(String, u64)> = dropped.collect();
        let left_out = [("at rest", found.resting), ("without a load", found.lifted)];
        let left_out = left_out.into_iter().filter(|(_, count)| *count > 0);
        dropped.extend(left_out.map(|(why, count)| (why.to_owned(), count as u64)));
        Ok(Self {
            units: ["f", "v"].map(|role| log.unit(role)),
            told: told(log.brief, &found, law),
            dropped,
            name: path.to_path_buf(),
            lines: match found.rows {
                None => log.lines,
                Some(rows) => rows
                    .iter()
                    .filter_map(|&row| log.lines.get(row).copied())
                    .collect(),
            },
            data: found.data,
        })
    }

    /// A refusal with file and line, where it is about a line.
    pub fn refusal(&self, error: FitError) -> Failure {
        refusal(&self.name, &self.lines, &self.told, error)
    }

    /// Names and columns of the measurements: time if there is one, velocity, friction.
    pub fn columns(&self) -> Vec<(&'static str, &[f64])> {
        let times = self.data.times().map(|times| ("t", times));
        let rest = [("v", self.data.velocities()), ("f", self.data.friction())];
        let load = self.data.load().map(|load| ("load", load));
        times.into_iter().chain(rest).chain(load).collect()
    }

    /// Whether it is a record over time.
    pub fn is_record(&self) -> bool {
        matches!(self.data.motion(), Motion::Series { .. })
    }
}

/// Share of noise in accelerations that is told.
const NOISY: f64 = 0.3;

/// What the reader said, and what was made of the rows.
fn told(mut brief: Vec<String>, found: &Prepared, law: Option<FitLaw>) -> Vec<String> {
    let rows = |count: usize| {
        if count == 1 {
            "1 row".to_owned()
        } else {
            format!("{count} rows")
        }
    };
    if found.resting > 0 {
        brief.push(format!("{} at rest left out", rows(found.resting)));
    }
    if found.lifted > 0 {
        brief.push(format!("{} without a load left out", rows(found.lifted)));
    }
    if found.is_signed_by_velocity {
        brief.push("friction has no sign: taken along the velocity".into());
    }
    if found.acceleration_noise > NOISY {
        brief.push(format!(
            "accelerations are slopes of v, of which {:.0} % is noise: the inertia may come out too small; smooth v, or give a \
             column by --columns a=NAME",
            100.0 * found.acceleration_noise
        ));
    }
    if found.data.is_large() && law.is_some_and(FitLaw::is_of_coefficient) {
        let friction = found.data.friction().iter();
        let largest = friction.fold(0.0, |most: f64, f| most.max(f.abs()));
        brief.push(format!(
            "f reaches {}, much for a coefficient: parameters are in its unit; --load N or --columns load=NAME divides it",
            super::output::shown_value(largest)
        ));
    }
    brief
}

/// A refusal with file and line, and with what was understood of the file where it is about all of it.
pub fn refusal(path: &Path, lines: &[u64], told: &[String], error: FitError) -> Failure {
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
