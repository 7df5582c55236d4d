//! Means and standard deviations over the seeds of each combination.

use super::frame::{Column, scalar};
use super::grid::Grid;
use super::kind::Kind;
use crate::command::deposit::curve::statistics;
use crate::command::digits::shown;
use serde_json::Value;
use tribos::record::number;

/// A line a combination.
#[derive(Debug)]
pub struct Table {
    kind: &'static Kind,
    names: Vec<String>,
    rows: Vec<Row>,
}

/// One combination.
#[derive(Debug)]
struct Row {
    values: Vec<String>,
    runs: usize,
    /// Share of the runs that ended with the kind's word.
    share: f64,
    /// Mean and deviation of each quantity; a deviation of one run is NaN.
    means: Vec<(f64, f64)>,
}

impl Table {
    /// Summaries in the order of the combinations, `seeds` of them each.
    pub fn new(kind: &'static Kind, grid: &Grid, summaries: &[Value], seeds: usize) -> Self {
        let rows = summaries.chunks(seeds).enumerate();
        Self {
            kind,
            names: grid.keys.iter().map(|swept| swept.key.clone()).collect(),
            rows: rows
                .map(|(combination, runs)| Row::new(kind, grid, combination, runs))
                .collect(),
        }
    }

    /// What the summaries are of.
    pub fn kind(&self) -> &'static Kind {
        self.kind
    }

    /// Mean of the drawn quantity of a combination and its deviation.
    pub fn drawn(&self, combination: usize) -> (f64, f64) {
        let row = self.rows.get(combination);
        row.map_or((f64::NAN, f64::NAN), |row| row.means[0])
    }

    /// Every number in its shortest form that keeps the bits.
    pub fn csv(&self) -> String {
        let mut text = self.names.join(",");
        if !self.names.is_empty() {
            text.push(',');
        }
        text += &format!("runs,{}", self.kind.share[0]);
        for (name, _) in self.kind.quantities {
            text += &format!(",{name},{name}_std");
        }
        text.push('\n');
        for row in &self.rows {
            let mut cells = row.values.clone();
            cells.push(row.runs.to_string());
            cells.push(number(row.share));
            for (mean, deviation) in &row.means {
                let (mean, deviation) = (*mean, *deviation);
                cells.extend([number(mean), number(deviation)]);
            }
            text += &cells.join(",");
            text.push('\n');
        }
        text
    }

    /// As columns, with the names and values of the CSV.
    pub fn columns(&self) -> Vec<Column> {
        let rows = || self.rows.iter();
        let key = |(at, name): (usize, &String)| {
            Column::given(name, rows().map(|row| row.values[at].clone()).collect())
        };
        let mut columns: Vec<Column> = self.names.iter().enumerate().map(key).collect();
        columns.push(Column::integers("runs", rows().map(|row| row.runs as i64)));
        columns.push(Column::numbers(
            self.kind.share[0],
            rows().map(|row| row.share),
        ));
        for (at, (name, _)) in self.kind.quantities.iter().enumerate() {
            columns.push(Column::numbers(name, rows().map(|row| row.means[at].0)));
            let deviation = format!("{name}_std");
            columns.push(Column::numbers(
                &deviation,
                rows().map(|row| row.means[at].1),
            ));
        }
        columns
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for name in &self.names {
            text += &format!("{name:>14}");
        }
        text += &format!("{:>14}", self.kind.share[0]);
        for column in self.kind.told {
            text += &format!("{:>24}", column.head);
        }
        text.push('\n');
        for row in &self.rows {
            for value in &row.values {
                text += &format!("{value:>14}");
            }
            let share = (row.share * row.runs as f64).round();
            text += &format!("{:>14}", format!("{share}/{}", row.runs));
            for column in self.kind.told {
                let (mean, deviation) = row.means[column.quantity];
                let [mean, deviation] = [mean, deviation].map(|x| column.factor * x);
                let cell = if deviation.is_nan() {
                    shown(mean)
                } else {
                    format!("{} ± {}", shown(mean), shown(deviation))
                };
                text += &format!("{cell:>24}");
            }
            text.push('\n');
        }
        text
    }
}

impl Row {
    fn new(kind: &Kind, grid: &Grid, combination: usize, runs: &[Value]) -> Self {
        let chosen = grid.keys.iter().zip(grid.indices(combination));
        let [_, place, word] = kind.share;
        let is_so = |run: &&Value| run.pointer(place).is_some_and(|found| found == word);
        let share = runs.iter().filter(is_so).count() as f64 / runs.len() as f64;
        let mean = |(_, place): &(&str, &str)| {
            let number = |run: &Value| run.pointer(place).and_then(scalar);
            let values: Vec<f64> = runs
                .iter()
                .map(|run| number(run).unwrap_or(f64::NAN))
                .collect();
            statistics(&values)
        };
        Self {
            values: chosen
                .map(|(swept, index)| swept.values[index].clone())
                .collect(),
            runs: runs.len(),
            share,
            means: kind.quantities.iter().map(mean).collect(),
        }
    }
}
