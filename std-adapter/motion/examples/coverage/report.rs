//! What a study counts, and its table.

use crate::design::Record;
use std::collections::BTreeMap;
use tribos_motion::fit::{Caution, Fit, Uncertainty};

/// Relative excess of the sum of squares over that of a search from the truth that is another minimum.
const EXCESS: f64 = 1e-4;

/// Whether an interval covers the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Covers {
    /// Of a parameter with a standard error.
    Known(bool),
    /// Of one that is undetermined or at a bound.
    Open(bool),
    /// Given.
    Fixed,
}

/// The result of one record.
#[derive(Debug)]
pub struct Outcome {
    covers: Vec<Covers>,
    /// Whether a search from the truth found less.
    pub is_wrong: bool,
    rows: usize,
    time: f64,
    cautions: Vec<&'static str>,
}

impl Outcome {
    pub fn of(record: &Record, fit: &Fit, near: Option<&Fit>, time: f64) -> Self {
        let covers = fit
            .parameters
            .iter()
            .zip(&record.truth)
            .map(|(estimate, truth)| {
                let [low, high] = estimate.interval;
                // A truth at the very bound is covered by an interval that ends there.
                let slack = 1e-9 * truth.abs();
                let inside = low - slack <= *truth && *truth <= high + slack;
                match estimate.known {
                    Uncertainty::StandardError(_) => Covers::Known(inside),
                    Uncertainty::Fixed => Covers::Fixed,
                    _ => Covers::Open(inside),
                }
            });
        let is_wrong = near.is_some_and(|near| fit.cost > near.cost * (1.0 + EXCESS));
        Self {
            covers: covers.collect(),
            is_wrong,
            rows: fit.predictions.len(),
            time,
            cautions: fit.cautions.iter().map(kind).collect(),
        }
    }

    /// Whether the fit said that its search or the sampling left something open.
    fn is_told(&self) -> bool {
        const OPEN: [&str; 4] = ["course", "steps", "not-converged", "few-agree"];
        self.cautions.iter().any(|kind| OPEN.contains(kind))
    }

    /// Number of parameters whose interval misses the truth.
    pub fn misses(&self) -> usize {
        let is_miss = |c: &&Covers| matches!(c, Covers::Known(false) | Covers::Open(false));
        self.covers.iter().filter(is_miss).count()
    }
}

fn kind(caution: &Caution) -> &'static str {
    match caution {
        Caution::LargeResiduals { .. } => "large-residuals",
        Caution::FewAgree { .. } => "few-agree",
        Caution::NotConverged => "not-converged",
        Caution::Undetermined { .. } => "undetermined",
        Caution::AtBound { .. } => "at-bound",
        Caution::Entangled { .. } => "entangled",
        Caution::Correlated { .. } => "correlated",
        Caution::Offset { .. } => "offset",
        Caution::OneWay => "one-way",
        Caution::Inertia { .. } => "inertia",
        Caution::Curved => "curved",
        Caution::LoadPoint { .. } => "load-point",
        Caution::Drift { .. } => "drift",
        Caution::Outliers { .. } => "outliers",
        Caution::Steps { .. } => "steps",
        Caution::Course { .. } => "course",
    }
}

/// Heads of the columns.
pub const HEAD: &str = "| law | rows | fits | % covered, that without cautions of the search (open: covered/number) | wrong | s median, worst | cautions |\n|---|---|---|---|---|---|---|";

/// One line of the table.
pub fn line(name: &str, parameters: &[&str], all: &[Option<Result<Outcome, String>>]) -> String {
    let made: Vec<&Outcome> = all.iter().flatten().flatten().collect();
    for refused in all.iter().flatten().filter_map(|one| one.as_ref().err()) {
        eprintln!("{name}: {refused}");
    }
    let panicked = all.iter().filter(|one| one.is_none()).count();
    if panicked > 0 {
        eprintln!("{name}: {panicked} records panicked");
    }
    let covered = parameters.iter().enumerate().map(|(j, name)| {
        let count = |wanted: Covers| {
            made.iter()
                .filter(|o| o.covers.get(j) == Some(&wanted))
                .count()
        };
        let [hit, miss] = [true, false].map(|inside| count(Covers::Known(inside)));
        let [open_hit, open_miss] = [true, false].map(|inside| count(Covers::Open(inside)));
        let mut text = format!("{name} ");
        if hit + miss > 0 {
            text += &format!("{:.1}", 100.0 * hit as f64 / (hit + miss) as f64);
        }
        let untold = made.iter().filter(|o| !o.is_told());
        let untold: Vec<_> = untold.filter_map(|o| o.covers.get(j)).collect();
        let count = |inside| {
            untold
                .iter()
                .filter(|c| ***c == Covers::Known(inside))
                .count()
        };
        let [hit, miss] = [true, false].map(count);
        if hit + miss > 0 {
            text += &format!("|{:.1}", 100.0 * hit as f64 / (hit + miss) as f64);
        }
        if open_hit + open_miss > 0 {
            text += &format!(" ({open_hit}/{})", open_hit + open_miss);
        }
        text
    });
    let covered: Vec<String> = covered.collect();
    let mut cautions: BTreeMap<&str, usize> = BTreeMap::new();
    for kind in made.iter().flat_map(|o| &o.cautions) {
        *cautions.entry(kind).or_default() += 1;
    }
    let cautions: Vec<String> = cautions
        .iter()
        .map(|(kind, n)| format!("{kind} {n}"))
        .collect();
    let middle = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
    };
    let rows = middle(made.iter().map(|o| o.rows as f64).collect());
    let worst = made.iter().map(|o| o.time).fold(0.0, f64::max);
    let wrong = made.iter().filter(|o| o.is_wrong).count();
    format!(
        "| {name} | {rows} | {}/{} | {} | {wrong} | {:.2}, {worst:.2} | {} |",
        made.len(),
        all.len(),
        covered.join(", "),
        middle(made.iter().map(|o| o.time).collect()),
        cautions.join(", ")
    )
}
