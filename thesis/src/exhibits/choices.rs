//! Section 4.6: which choices, stated or not, give the thesis' porosities and stresses together.

mod claims;
mod figure;

use super::stress::TABLE;
use crate::exhibit::Exhibit;
use crate::runs::Runs;
use crate::text::Text;
use anyhow::Result;
use claims::claims;
use figure::figure;
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::statistics::statistics;

const TEXT: Text = Text(include_str!("section-4.6-choices.md"));

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("choices/runs.csv");
const NUMBERS: usize = 8;
const COLUMNS: [&str; NUMBERS + 2] = [
    "mu",
    "pressure",
    "cohesion_range",
    "mu_rolling",
    "mu_torsion",
    "seed",
    "porosity_final",
    "stress_zz_plus",
    "wall_contact",
    "ending",
];

/// μ_t and μ_n of the corners, and the thesis' porosities there in per cent.
const CORNERS: [([f64; 2], f64); 4] = [
    ([0.0, 0.0], 54.0),
    ([0.0, 1.0], 62.0),
    ([1.0, 0.0], 72.0),
    ([1.0, 1.0], 82.0),
];
/// Pairs from saturation on and their corners: the thesis has the same porosity at both.
const SATURATED: [[[f64; 2]; 2]; 2] = [[[0.4, 0.0], [1.0, 0.0]], [[0.4, 0.4], [1.0, 1.0]]];
/// Fluctuation of the thesis' porosities, in points (section 4.6.1).
const FLUCTUATION: f64 = 2.0;
/// Scatter of our porosities from deposit to deposit, in points, where there is one.
const SCATTER: f64 = 1.0;
/// Half a unit of the last digit of table 4.1.
const HALF_DIGIT: f64 = 0.05;
/// χ² of four, six and eight numbers that is exceeded by chance in one case of twenty.
const LIMITS: [f64; 3] = [9.49, 12.59, 15.51];
/// The pressure that the thesis states, in F_coh/R².
const PRINTED_PRESSURE: f64 = 0.0025;
/// Choices of five deposits: what the thesis prints with our usual range and walls, at the corners alone, and three with all
/// pairs.
const JUDGED: [Choice; 4] = [
    Choice::new(0.3, 1.0, 1e-2, false),
    Choice::new(0.12, 1.0, 1e-4, true),
    Choice::new(0.2, 2.0, 1e-4, false),
    Choice::new(0.3, 2.0, 1e-4, true),
];
/// Ranges of cohesion, in R.
const RANGES: [f64; 3] = [1e-4, 1e-3, 1e-2];
/// Groups whose logarithms are this near count as equal.
const SAME_GROUP: f64 = 0.08;

/// What a compaction is made with beside its friction torques.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Choice {
    mu: f64,
    pressure: f64,
    range: f64,
    is_smooth: bool,
}

impl Choice {
    /// The pressure as a multiple of the printed one.
    const fn new(mu: f64, times: f64, range: f64, is_smooth: bool) -> Self {
        Self {
            mu,
            pressure: times * PRINTED_PRESSURE,
            range,
            is_smooth,
        }
    }

    /// μ F_coh/(P R²): what friction of a bond holds against the load on a square radius.
    fn group(&self) -> f64 {
        self.mu / self.pressure
    }

    fn words(&self) -> String {
        let walls = if self.is_smooth { "smooth" } else { "rough" };
        let times = (1e3 * self.pressure / PRINTED_PRESSURE).round() / 1e3;
        format!(
            "μ = {}, {times} P, d_c = {:e} R, {walls} walls",
            self.mu, self.range
        )
    }
}

/// The end of a compaction.
#[derive(Clone, Debug)]
struct Line {
    choice: Choice,
    /// μ_t and μ_n.
    pair: [f64; 2],
    seed: f64,
    /// In per cent.
    porosity: f64,
    /// σ_zz⁺ in units of the pressure.
    plus: f64,
    is_blocked: bool,
}

/// All lines.
struct Table(Vec<Line>);

impl Table {
    fn kept() -> Result<Self> {
        let (file, others) = (Path::new("runs.csv"), OtherColumns::Ignored);
        let mut rows = Rows::of(file, KEPT.as_bytes(), others, |_| &COLUMNS)?;
        let (mut lines, mut row) = (Vec::new(), [0.0; NUMBERS]);
        while rows.next(&mut row)?.is_some() {
            let [mu, pressure, range, rolling, torsion, seed, porosity, plus] = row;
            let [walls, ending] = rows.words() else {
                continue;
            };
            lines.push(Line {
                choice: Choice {
                    mu,
                    pressure,
                    range,
                    is_smooth: walls == "smooth",
                },
                pair: [rolling, torsion],
                seed,
                porosity: 100.0 * porosity,
                plus,
                is_blocked: ending == "blocked",
            });
        }
        Ok(Self(lines))
    }

    /// Every choice once.
    fn choices(&self) -> Vec<Choice> {
        let mut all: Vec<Choice> = Vec::new();
        for line in &self.0 {
            if !all.contains(&line.choice) {
                all.push(line.choice);
            }
        }
        all
    }

    /// Mean, scatter and number of a quantity of all deposits; nothing without runs.
    fn of(
        &self,
        choice: &Choice,
        pair: [f64; 2],
        what: fn(&Line) -> f64,
    ) -> Option<(f64, f64, f64)> {
        let chosen = |line: &&Line| line.choice == *choice && line.pair == pair;
        let values: Vec<f64> = self.0.iter().filter(chosen).map(what).collect();
        let (mean, scatter) = statistics(&values);
        (!values.is_empty()).then_some((mean, scatter, values.len() as f64))
    }

    fn porosity(&self, choice: &Choice, pair: [f64; 2]) -> Option<(f64, f64, f64)> {
        let (mean, scatter, count) = self.of(choice, pair, |line| line.porosity)?;
        Some((
            mean,
            if scatter.is_nan() { SCATTER } else { scatter },
            count,
        ))
    }

    /// χ² of the four corners by both errors.
    fn misfit(&self, choice: &Choice) -> Option<f64> {
        let each = CORNERS.into_iter().map(|(pair, thesis)| {
            let (ours, scatter, count) = self.porosity(choice, pair)?;
            Some((ours - thesis).powi(2) / (FLUCTUATION.powi(2) + scatter * scatter / count))
        });
        each.sum()
    }

    /// Largest difference of E(1,1) between choices with one group and one kind of walls, and the span of all: ranges
    /// that the load of the piston's pressure does not close.
    fn collapse(&self, judged: &[(Choice, f64)]) -> [f64; 2] {
        let [.., (both, _)] = CORNERS;
        let far = judged
            .iter()
            .map(|(choice, _)| choice)
            .filter(|choice| choice.range > RANGES[0]);
        let all: Vec<(&Choice, f64)> = far
            .filter_map(|choice| Some((choice, self.porosity(choice, both)?.0)))
            .collect();
        let (mut apart, mut span) = (0.0_f64, 0.0_f64);
        for (a, one) in &all {
            for (b, other) in &all {
                let difference = (one - other).abs();
                span = span.max(difference);
                let is_same =
                    a.is_smooth == b.is_smooth && (a.group() / b.group()).ln().abs() < SAME_GROUP;
                apart = if is_same {
                    apart.max(difference)
                } else {
                    apart
                };
            }
        }
        [apart, span]
    }

    /// What the corners have more than the pairs from which on the thesis calls them saturated, in points.
    fn rises(&self, choice: &Choice) -> Option<[f64; 2]> {
        let rise = |[from, to]: [[f64; 2]; 2]| {
            Some(self.porosity(choice, to)?.0 - self.porosity(choice, from)?.0)
        };
        let [one, other] = SATURATED;
        Some([rise(one)?, rise(other)?])
    }

    /// χ² of the corners and both rises, of two fluctuations each.
    fn whole_misfit(&self, choice: &Choice) -> Option<f64> {
        let rises = self.rises(choice)?;
        let of_rises = rises
            .iter()
            .map(|rise| rise * rise / (2.0 * FLUCTUATION.powi(2)));
        Some(self.misfit(choice)? + of_rises.sum::<f64>())
    }

    /// χ² of σ_zz⁺ in the lines of table 4.1, each of one packing of the thesis that scatters as one of ours does.
    fn stress_misfit(&self, choice: &Choice) -> Option<f64> {
        let each = TABLE.into_iter().map(|[rolling, torsion, thesis, _]| {
            let (ours, scatter, count) = self.of(choice, [rolling, torsion], |line| line.plus)?;
            let variance = scatter * scatter * (1.0 + 1.0 / count) + HALF_DIGIT * HALF_DIGIT / 3.0;
            Some((ours - thesis).powi(2) / variance)
        });
        each.sum()
    }
}

/// The set of choices.
pub fn section_4_6_choices(runs: &Runs) -> Result<Exhibit> {
    let table = Table::kept()?;
    let mut judged: Vec<(Choice, f64)> = Vec::new();
    for choice in table.choices() {
        judged.extend(table.misfit(&choice).map(|misfit| (choice, misfit)));
    }
    judged.sort_by(|a, b| a.1.total_cmp(&b.1));
    let rows = table
        .choices()
        .iter()
        .map(|choice| row(&table, choice))
        .collect();
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort())
            .with("choices", judged.len())
            .with("runs", table.0.len()),
        figure(&table, &judged),
        &[
            "mu",
            "pressure",
            "cohesion_range",
            "smooth_walls",
            "group",
            "porosity_00",
            "porosity_01",
            "porosity_10",
            "porosity_11",
            "chi_squared_4",
            "chi_squared_6",
            "chi_squared_stress_8",
        ],
        rows,
        claims(runs, &table, &judged)?,
    ))
}

fn row(table: &Table, choice: &Choice) -> Vec<f64> {
    let porosity = |(pair, _)| {
        table
            .porosity(choice, pair)
            .map_or(f64::NAN, |found| found.0)
    };
    let [a, b, c, d] = CORNERS.map(porosity);
    let misfits = [
        table.misfit(choice),
        table.whole_misfit(choice),
        table.stress_misfit(choice),
    ];
    let [four, six, eight] = misfits.map(|misfit| misfit.unwrap_or(f64::NAN));
    let walls = f64::from(u8::from(choice.is_smooth));
    let made = [
        choice.mu,
        choice.pressure,
        choice.range,
        walls,
        choice.group(),
    ];
    [&made[..], &[a, b, c, d, four, six, eight]].concat()
}
