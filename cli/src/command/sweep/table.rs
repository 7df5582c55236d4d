//! Means and standard deviations over the seeds of each combination.

use super::grid::Grid;
use crate::command::deposit::curve::statistics;
use serde_json::Value;
use tribos::record::number;

/// Numbers of a summary that are averaged: column and place in the summary.
const QUANTITIES: [(&str, &str); 16] = [
    ("porosity_final", "/porosity_final"),
    ("porosity_bulk", "/porosity_bulk"),
    ("porosity_initial", "/porosity_initial"),
    ("particles", "/particles"),
    ("contacts", "/contacts"),
    ("coordination", "/statistics/mean_coordination"),
    ("stress_zz", "/stress_zz"),
    ("stress_zz_plus", "/stress_zz_plus"),
    ("stress_zz_minus", "/stress_zz_minus"),
    ("steps", "/steps"),
    ("iterations_total", "/iterations_total"),
    ("dissipation_normal", "/dissipation/normal"),
    ("dissipation_sliding", "/dissipation/sliding"),
    ("dissipation_rolling", "/dissipation/rolling"),
    ("dissipation_torsion", "/dissipation/torsion"),
    ("dissipation_cohesion", "/dissipation/cohesion"),
];

/// A line a combination.
#[derive(Debug)]
pub struct Table {
    names: Vec<String>,
    rows: Vec<Row>,
}

/// One combination.
#[derive(Debug)]
struct Row {
    values: Vec<String>,
    runs: usize,
    /// Share of the runs that were blocked.
    blocked: f64,
    /// Mean and deviation of each quantity; a deviation of one run is NaN.
    means: [(f64, f64); QUANTITIES.len()],
}

impl Table {
    /// Summaries in the order of the combinations, `seeds` of them each.
    pub fn new(grid: &Grid, summaries: &[Value], seeds: usize) -> Self {
        let rows = summaries.chunks(seeds).enumerate();
        Self {
            names: grid.keys.iter().map(|swept| swept.key.clone()).collect(),
            rows: rows
                .map(|(combination, runs)| Row::new(grid, combination, runs))
                .collect(),
        }
    }

    /// Mean final porosity of a combination and its deviation.
    pub fn porosity(&self, combination: usize) -> (f64, f64) {
        let row = self.rows.get(combination);
        row.map_or((f64::NAN, f64::NAN), |row| row.means[0])
    }

    /// With 17 digits.
    pub fn csv(&self) -> String {
        let mut text = self.names.join(",");
        if !self.names.is_empty() {
            text.push(',');
        }
        text += "runs,blocked";
        for (name, _) in QUANTITIES {
            text += &format!(",{name},{name}_std");
        }
        text.push('\n');
        for row in &self.rows {
            let mut cells = row.values.clone();
            cells.push(row.runs.to_string());
            cells.push(number(row.blocked));
            for (mean, deviation) in row.means {
                cells.extend([number(mean), number(deviation)]);
            }
            text += &cells.join(",");
            text.push('\n');
        }
        text
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for name in &self.names {
            text += &format!("{name:>14}");
        }
        text += "  blocked   porosity [%]   contacts a sphere   stress_zz  plus    minus\n";
        for row in &self.rows {
            for value in &row.values {
                text += &format!("{value:>14}");
            }
            let (porosity, deviation) = row.means[0];
            let spread = if deviation.is_nan() {
                String::new()
            } else {
                format!("± {:.2}", 100.0 * deviation)
            };
            let blocked = (row.blocked * row.runs as f64).round();
            text += &format!(
                "  {blocked:>3}/{:<3}   {:6.2} {spread:<7}  {:>10.2}  {:>14.3} {:>7.3} {:>7.3}\n",
                row.runs,
                100.0 * porosity,
                row.means[5].0,
                row.means[6].0,
                row.means[7].0,
                row.means[8].0,
            );
        }
        text
    }
}

impl Row {
    fn new(grid: &Grid, combination: usize, runs: &[Value]) -> Self {
        let chosen = grid.keys.iter().zip(grid.indices(combination));
        let blocked = runs.iter().filter(|run| run["ending"] == "blocked").count();
        let mean = |(_, place): (&str, &str)| {
            let number = |run: &Value| run.pointer(place).and_then(Value::as_f64);
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
            blocked: blocked as f64 / runs.len() as f64,
            means: QUANTITIES.map(mean),
        }
    }
}
