//! Means and standard deviations over the seeds of each combination.

use super::frame::{Cells, Column, add, scalar};
use super::grid::Grid;
use super::refusal;
use crate::command::bodies::RunKind;
use crate::command::digits::shown;
use serde_json::Value;
use tribos::results::SweptQuantity;
use tribos::statistics::statistics;

/// A line a combination.
#[derive(Debug)]
pub struct Table {
    kind: RunKind,
    names: Vec<String>,
    rows: Vec<Row>,
}

/// One combination.
#[derive(Debug)]
struct Row {
    values: Vec<String>,
    /// Those with results, and those that were refused.
    runs: usize,
    refused: usize,
    /// Why the first of them was.
    reason: Option<String>,
    /// Share of the runs that ended with the kind's word.
    share: f64,
    /// Mean and deviation of each quantity; a deviation of one run is NaN.
    means: Vec<(f64, f64)>,
}

impl Table {
    /// Summaries in the order of the combinations, `seeds` of them each.
    pub fn new(kind: RunKind, grid: &Grid, summaries: &[Value], seeds: usize) -> Self {
        let rows = summaries.chunks(seeds).enumerate();
        Self {
            names: grid.keys.iter().map(|swept| swept.key.clone()).collect(),
            rows: rows
                .map(|(combination, runs)| Row::new(&kind, grid, combination, runs))
                .collect(),
            kind,
        }
    }

    /// What the summaries are of.
    pub fn kind(&self) -> &RunKind {
        &self.kind
    }

    /// Mean of the drawn quantity of a combination and its deviation.
    pub fn drawn(&self, combination: usize) -> (f64, f64) {
        let row = self.rows.get(combination);
        row.map_or((f64::NAN, f64::NAN), |row| row.means[self.kind.drawn])
    }

    /// Number of runs that were refused.
    pub fn refused(&self) -> usize {
        self.rows.iter().map(|row| row.refused).sum()
    }

    /// Number of runs that have results.
    pub fn runs(&self) -> usize {
        self.rows.iter().map(|row| row.runs).sum()
    }

    /// All columns, each with its own name.
    pub fn columns(&self) -> Vec<Column> {
        let rows = || self.rows.iter();
        let key = |(at, name): (usize, &String)| {
            Column::given(name, rows().map(|row| row.values[at].clone()).collect())
        };
        let mut columns: Vec<Column> = self.names.iter().enumerate().map(key).collect();
        let runs = Column::integers("runs", rows().map(|row| row.runs as i64));
        add(&mut columns, runs);
        if self.refused() > 0 {
            let refused = Column::integers("refused", rows().map(|row| row.refused as i64));
            add(&mut columns, refused);
        }
        let share = Column::numbers(self.kind.share[0], rows().map(|row| row.share));
        add(&mut columns, share);
        for (at, quantity) in self.kind.quantities.iter().enumerate() {
            let name = quantity.column;
            let means = Column::numbers(name, rows().map(|row| row.means[at].0));
            add(&mut columns, means);
            let deviations = rows().map(|row| row.means[at].1);
            add(
                &mut columns,
                Column::numbers(&format!("{name}_std"), deviations),
            );
        }
        if self.refused() > 0 {
            let name = refusal::REASON.to_owned();
            let cells = Cells::Words(rows().map(|row| row.reason.clone()).collect());
            add(&mut columns, Column { name, cells });
        }
        columns
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let quantities = self.kind.quantities.iter().enumerate();
        let head = |(at, quantity): (usize, &SweptQuantity)| {
            Some((at, quantity.labelled(quantity.label?)))
        };
        let shown_columns: Vec<(usize, String)> = quantities.filter_map(head).collect();
        let width = |at: usize, name: &String| {
            let values = self.rows.iter().map(|row| row.values[at].chars().count());
            values.fold(name.chars().count().max(12), usize::max)
        };
        let names = self.names.iter().enumerate();
        let widths: Vec<usize> = names.map(|(at, name)| width(at, name)).collect();
        for (name, width) in self.names.iter().zip(&widths) {
            text += &format!("  {name:>width$}");
        }
        text += &format!("  {:>12}", self.kind.share[0]);
        for (_, head) in &shown_columns {
            text += &format!("  {head:>22}");
        }
        text.push('\n');
        for row in &self.rows {
            for (value, width) in row.values.iter().zip(&widths) {
                text += &format!("  {value:>width$}");
            }
            if row.runs == 0 {
                let reason = row.reason.as_deref().unwrap_or_default();
                text += &format!("       refused: {reason}\n");
                continue;
            }
            let share = (row.share * row.runs as f64).round();
            text += &format!("  {:>12}", format!("{share}/{}", row.runs));
            for (at, _) in &shown_columns {
                let (mean, deviation) = row.means[*at];
                let cell = if deviation.is_nan() {
                    shown(mean)
                } else {
                    format!("{} ± {}", shown(mean), shown(deviation))
                };
                text += &format!("  {cell:>22}");
            }
            if let Some(reason) = &row.reason {
                let all = row.runs + row.refused;
                text += &format!("       {} of {all} refused: {reason}", row.refused);
            }
            text.push('\n');
        }
        text
    }
}

impl Row {
    fn new(kind: &RunKind, grid: &Grid, combination: usize, runs: &[Value]) -> Self {
        let chosen = grid.keys.iter().zip(grid.indices(combination));
        let [_, place, word] = kind.share;
        let done: Vec<&Value> = runs
            .iter()
            .filter(|run| refusal::reason(run).is_none())
            .collect();
        let is_so = |run: &&&Value| run.pointer(place).is_some_and(|found| found == word);
        let share = done.iter().filter(is_so).count() as f64 / done.len() as f64;
        let mean = |quantity: &SweptQuantity| {
            let number = |run: &&Value| quantity.of(run).and_then(scalar);
            let values: Vec<f64> = done
                .iter()
                .map(|run| number(run).unwrap_or(f64::NAN))
                .collect();
            match values.as_slice() {
                [] => (f64::NAN, f64::NAN),
                values => statistics(values),
            }
        };
        Self {
            values: chosen
                .map(|(swept, index)| swept.values[index].clone())
                .collect(),
            runs: done.len(),
            refused: runs.len() - done.len(),
            reason: runs.iter().find_map(refusal::reason).map(str::to_owned),
            share,
            means: kind.quantities.iter().map(mean).collect(),
        }
    }
}
