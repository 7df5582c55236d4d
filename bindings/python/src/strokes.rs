//! Strokes of a tribometer's record.

use crate::fit::told;
use crate::threads::detached;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribos::fit::FitError;
use tribos::fit::strokes::{Stroke, StrokeOptions, StrokeRecord, StrokeSummary, Strokes};

/// Times, friction, and velocities, positions and loads where there are any.
type Columns = (
    Vec<f64>,
    Vec<f64>,
    Option<Vec<f64>>,
    Option<Vec<f64>>,
    Option<Vec<f64>>,
);

fn record(
    (times, friction, velocities, positions, loads): Columns,
) -> Result<StrokeRecord, FitError> {
    let mut record = StrokeRecord::new(times, friction)?;
    if let Some(velocities) = velocities {
        record = record.with_velocities(velocities)?;
    }
    if let Some(positions) = positions {
        record = record.with_positions(positions)?;
    }
    match loads {
        Some(loads) => record.per_load(&loads),
        None => Ok(record),
    }
}

/// Takes a record apart: lists by the names of the quantities, the summary, and what was assumed.
#[pyfunction]
pub fn strokes_of<'py>(
    py: Python<'py>,
    columns: Columns,
    middle: f64,
    shortest_rest: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let options = StrokeOptions {
        middle,
        shortest_rest,
    };
    let found = detached(py, || Strokes::new(&record(columns)?, &options))?;
    let found = found.map_err(told)?;
    let lists = PyDict::new(py);
    for quantity in Stroke::QUANTITIES {
        let values = found.strokes.iter().map(quantity.value);
        lists.set_item(quantity.name, values.collect::<Vec<f64>>())?;
    }
    let rows = found.strokes.iter();
    let rows = rows.map(|stroke| (stroke.rows.start, stroke.rows.end));
    let summary = PyDict::new(py);
    for quantity in StrokeSummary::QUANTITIES {
        summary.set_item(quantity.name, (quantity.value)(&found.summary))?;
    }
    let answer = PyDict::new(py);
    answer.set_item("lists", lists)?;
    answer.set_item("rows", rows.collect::<Vec<(usize, usize)>>())?;
    answer.set_item("summary", summary)?;
    answer.set_item("resistance", found.resistance.as_slice())?;
    answer.set_item("noise", found.noise)?;
    answer.set_item("after", found.run_in.after())?;
    answer.set_item("run_in", found.run_in())?;
    answer.set_item("divided_by", found.divided_by())?;
    answer.set_item("notes", found.notes())?;
    Ok(answer)
}
