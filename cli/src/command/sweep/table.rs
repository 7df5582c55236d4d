//! Means, standard deviations and errors over the seeds of each combination.

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
    /// Mean of each quantity over the runs.
    means: Vec<Mean>,
}

/// Mean of a quantity over the runs of a combination.
#[derive(Clone, Copy, Debug)]
struct Mean {
    value: f64,
    /// Standard deviation of the runs; NaN of one run.
    deviation: f64,
    /// Standard error of a mean over time: from the errors of the runs, or from their deviation if that says more.
    error: Option<f64>,
}

impl Mean {
    /// The mean of values with their errors, if they are means over time.
    fn of(values: &[f64], errors: Option<&[f64]>) -> Self {
        let count = values.len() as f64;
        let (value, deviation) = match values {
            [] => (f64::NAN, f64::NAN),
            values => statistics(values),
        };
        let error = errors.map(|errors| {
            let squares: f64 = errors.iter().map(|error| error * error).sum();
            // The larger, or the one that is there.
            (squares.sqrt() / count).max(deviation / count.sqrt())
        });
        Self {
            value,
            deviation,
            error,
        }
    }

    /// What whiskers show: the error of a mean over time, else the deviation of the runs.
    fn whisker(&self) -> f64 {
        self.error.unwrap_or(self.deviation)
    }
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

    /// Mean of a quantity of a combination and its error, or the deviation of the runs.
    pub fn drawn(&self, quantity: usize, combination: usize) -> (f64, f64) {
        let row = self.rows.get(combination);
        row.map_or((f64::NAN, f64::NAN), |row| {
            let mean = row.means[quantity];
            (mean.value, mean.whisker())
        })
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
            let means = || rows().map(|row| row.means[at]);
            add(
                &mut columns,
                Column::numbers(name, means().map(|mean| mean.value)),
            );
            let deviations = means().map(|mean| mean.deviation);
            add(
                &mut columns,
                Column::numbers(&format!("{name}_std"), deviations),
            );
            if quantity.error.is_some() {
                let errors = means().map(|mean| mean.whisker());
                add(
                    &mut columns,
                    Column::numbers(&format!("{name}_error"), errors),
                );
            }
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
        // Flows end when their time is over, and none of them at rest.
        let never = self.kind.share[0] == "rest" && self.rows.iter().all(|row| row.share == 0.0);
        if !never {
            text += &format!("  {:>12}", self.kind.share[0]);
        }
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
            if !never {
                text += &format!("  {:>12}", format!("{share}/{}", row.runs));
            }
            for (at, _) in &shown_columns {
                let mean = row.means[*at];
                let cell = if mean.whisker().is_nan() {
                    shown(mean.value)
                } else {
                    format!("{} ± {}", shown(mean.value), shown(mean.whisker()))
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
            let number = |found: Option<&Value>| found.and_then(scalar).unwrap_or(f64::NAN);
            let values: Vec<f64> = done.iter().map(|run| number(quantity.of(run))).collect();
            let errors = done.iter().map(|run| number(quantity.error_of(run)));
            let errors: Option<Vec<f64>> = quantity.error.is_some().then(|| errors.collect());
            Mean::of(&values, errors.as_deref())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_over_time_has_the_larger_of_both_errors() {
        // Runs that agree within their errors, and runs that do not.
        let alike = Mean::of(&[1.0, 1.0, 1.0, 1.0], Some(&[0.5; 4]));
        assert_eq!(
            (alike.value, alike.deviation, alike.error),
            (1.0, 0.0, Some(0.25))
        );
        let apart = Mean::of(&[0.0, 2.0], Some(&[0.1; 2]));
        assert_eq!(apart.error, Some(1.0));
        let alone = Mean::of(&[3.0], Some(&[0.5]));
        assert!(alone.deviation.is_nan() && alone.whisker() == 0.5);
        // Without errors over time the deviation is shown.
        assert!((Mean::of(&[0.0, 2.0], None).whisker() - 2.0_f64.sqrt()).abs() < 1e-15);
    }
}
