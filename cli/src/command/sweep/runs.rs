//! One row a run: its keys, its seed and every single number of its summary.

use super::body::Body;
use super::frame::{Cells, Column, add};
use super::grid::Grid;
use super::jobs::Task;
use serde_json::{Map, Value};

/// Members of a summary that are no results: the input, and what differs from machine to machine.
const LEFT_OUT: [&str; 3] = ["scene", "version", "wall_seconds"];

/// The columns of all runs, `seeds` for each combination. Lists stay in the summaries.
pub fn columns(grid: &Grid, seeds: usize, tasks: &[Task], summaries: &[Value]) -> Vec<Column> {
    let mut columns: Vec<Column> = (0..grid.keys.len())
        .map(|at| {
            let swept = &grid.keys[at];
            let value = |run: usize| swept.values[grid.indices(run / seeds)[at]].clone();
            Column::given(&swept.key, (0..tasks.len()).map(value).collect())
        })
        .collect();
    let varied = grid.keys.iter().any(|swept| swept.key == "seed");
    let seed = |task: &Task| task.body.as_ref().ok().and_then(Body::seed);
    let numbers: Vec<Option<i64>> = tasks
        .iter()
        .map(|task| seed(task).map(|seed| seed as i64))
        .collect();
    if !varied && numbers.iter().any(Option::is_some) {
        columns.push(Column {
            name: "seed".into(),
            cells: Cells::Integers(numbers),
        });
    }
    let flat: Vec<Map<String, Value>> = summaries.iter().map(flat).collect();
    let mut names: Vec<&String> = Vec::new();
    for name in flat.iter().flat_map(Map::keys) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    for name in names {
        let values: Vec<Option<&Value>> = flat.iter().map(|run| run.get(name)).collect();
        add(&mut columns, Column::of(name, &values));
    }
    columns
}

/// The members of a summary that are single values; those of an object carry its name before theirs.
fn flat(summary: &Value) -> Map<String, Value> {
    let mut all = Map::new();
    let members = summary.as_object().into_iter().flatten();
    for (name, value) in members.filter(|(name, _)| !LEFT_OUT.contains(&name.as_str())) {
        match value {
            Value::Array(_) => {}
            Value::Object(_) => {
                for (inner, value) in flat(value) {
                    all.insert(format!("{name}_{inner}"), value);
                }
            }
            _ => {
                all.insert(name.clone(), value.clone());
            }
        }
    }
    all
}
