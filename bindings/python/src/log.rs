//! Logs of measurements: files, and columns of tables in memory.

use crate::arrays::refused;
use crate::threads::detached;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use tribos::record::{
    ColumnChoices, Log, LogOptions, LogRole, Rows, TableError, UnitChoices, log_of_columns, look,
    read_log, used_columns,
};

/// Names of roles, whether a log without them is refused, and whether only their own names count.
type WantedRoles = Vec<(String, bool, bool)>;
/// Columns and units by role, and lines to leave out.
type GivenOptions = (Vec<(String, String)>, Vec<(String, String)>, u64);

/// Columns of pushes.
const PUSHES: [&str; 6] = ["dx", "dy", "dtheta", "fx", "fy", "torque"];

fn roles(wanted: &WantedRoles) -> PyResult<Vec<LogRole>> {
    let role = |(name, is_needed, by_own_name): &(String, bool, bool)| {
        let known = LogRole::ALL.into_iter().find(|role| role.name == name);
        let known = known.ok_or_else(|| refused(format!("there is no role {name}")))?;
        let known = if *by_own_name {
            known.by_own_name()
        } else {
            known
        };
        Ok(if *is_needed { known.needed() } else { known })
    };
    wanted.iter().map(role).collect()
}

fn options((columns, units, skip): GivenOptions) -> LogOptions {
    LogOptions {
        columns: ColumnChoices::of(columns),
        units: UnitChoices(units),
        skip,
    }
}

/// A refusal that names Python's keywords in the place of the command's options.
fn told(error: TableError) -> PyErr {
    let text = error.to_string();
    let text = text
        .replace("by --skip N", "by skip=N")
        .replace("with --look", "with tribos.look");
    refused(
        text.replace("--columns ", "columns ")
            .replace("--columns", "columns")
            .replace("--units ", "units "),
    )
}

fn result<'py>(py: Python<'py>, log: Log) -> PyResult<Bound<'py, PyDict>> {
    let answer = PyDict::new(py);
    let columns = PyDict::new(py);
    for (name, column) in log.columns {
        columns.set_item(name, column)?;
    }
    answer.set_item("columns", columns)?;
    answer.set_item("lines", log.lines)?;
    answer.set_item("understood", log.understood)?;
    answer.set_item("brief", log.brief)?;
    let dropped = PyDict::new(py);
    for (reason, count) in log.dropped {
        dropped.set_item(reason.name(), count)?;
    }
    answer.set_item("dropped", dropped)?;
    Ok(answer)
}

/// Reads the columns of roles from a file.
#[pyfunction]
pub fn read_file<'py>(
    py: Python<'py>,
    path: PathBuf,
    wanted: WantedRoles,
    given: GivenOptions,
) -> PyResult<Bound<'py, PyDict>> {
    let (roles, options) = (roles(&wanted)?, options(given));
    let log = detached(py, || read_log(&path, &roles, &options))?;
    result(py, log.map_err(told)?)
}

/// Places of the columns that are read of a table with these names.
#[pyfunction]
pub fn log_places(
    names: Vec<String>,
    wanted: WantedRoles,
    given: GivenOptions,
) -> PyResult<Vec<usize>> {
    used_columns("data", &names, &roles(&wanted)?, &options(given)).map_err(told)
}

/// Takes the columns of roles from those of a table.
#[pyfunction]
pub fn log_columns<'py>(
    py: Python<'py>,
    columns: Vec<(String, Vec<f64>)>,
    wanted: WantedRoles,
    given: GivenOptions,
) -> PyResult<Bound<'py, PyDict>> {
    let (roles, options) = (roles(&wanted)?, options(given));
    let log = detached(py, || log_of_columns("data", &columns, &roles, &options))?;
    result(py, log.map_err(told)?)
}

/// A first look at a file: as text and as JSON.
#[pyfunction]
pub fn look_at(
    py: Python<'_>,
    path: PathBuf,
    wanted: WantedRoles,
    given: GivenOptions,
) -> PyResult<(String, String)> {
    let (roles, options) = (roles(&wanted)?, options(given));
    let seen = detached(py, || look(&path, &roles, &options))?.map_err(told)?;
    Ok((seen.text(), seen.json().to_string()))
}

/// Rows of pushes of a file.
#[pyfunction]
pub fn read_pushes(py: Python<'_>, path: PathBuf, given: GivenOptions) -> PyResult<Vec<[f64; 6]>> {
    let options = options(given);
    let rows = detached(py, || {
        Rows::with_options(&path, &options, |_| &PUSHES).and_then(|rows| rows.all(usize::MAX))
    })?;
    rows.map_err(told)
}
