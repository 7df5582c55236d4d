//! The kept table of compactions, and its misfits with the thesis.

use super::super::stress::TABLE;
use super::{CORNERS, FLUCTUATION, HALF_DIGIT, PRINTED_PRESSURE, RANGES};
use anyhow::Result;
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::statistics::statistics;

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("runs.csv");
const NUMBERS: usize = 9;
const COLUMNS: [&str; NUMBERS + 2] = [
    "width",
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

/// Pairs from saturation on and their corners: the thesis has the same porosity at both.
const SATURATED: [[[f64; 2]; 2]; 2] = [[[0.4, 0.0], [1.0, 0.0]], [[0.4, 0.4], [1.0, 1.0]]];
/// Scatter of our porosities from deposit to deposit, in points, where there is one.
const SCATTER: f64 = 1.0;
/// Groups whose logarithms are this near count as equal.
const SAME_GROUP: f64 = 0.08;

/// What a compaction is made with beside its friction torques.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Choice {
    pub mu: f64,
    pub pressure: f64,
    pub range: f64,
    pub is_smooth: bool,
}

impl Choice {
    /// The pressure as a multiple of the printed one.
    pub const fn new(mu: f64, times: f64, range: f64, is_smooth: bool) -> Self {
        Self {
            mu,
            pressure: times * PRINTED_PRESSURE,
            range,
            is_smooth,
        }
    }

    /// μ F_coh/(P R²): what friction of a bond holds against the load on a square radius.
    pub fn group(&self) -> f64 {
        self.mu / self.pressure
    }

    pub fn words(&self) -> String {
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
pub(super) struct Line {
    pub choice: Choice,
    /// μ_t and μ_n.
    pub pair: [f64; 2],
    pub seed: f64,
    /// In per cent.
    pub porosity: f64,
    /// σ_zz⁺ in units of the pressure.
    pub plus: f64,
    pub is_blocked: bool,
}

/// Lines of one system.
pub(super) struct Table(pub Vec<Line>);

impl Table {
    /// Those of the system this wide, in R.
    pub fn kept(wide: f64) -> Result<Self> {
        let (file, others) = (Path::new("runs.csv"), OtherColumns::Ignored);
        let mut rows = Rows::of(file, KEPT.as_bytes(), others, |_| &COLUMNS)?;
        let (mut lines, mut row) = (Vec::new(), [0.0; NUMBERS]);
        while rows.next(&mut row)?.is_some() {
            let [
                width,
                mu,
                pressure,
                range,
                rolling,
                torsion,
                seed,
                porosity,
                plus,
            ] = row;
            let [walls, ending] = rows.words() else {
                continue;
            };
            if width != wide {
                continue;
            }
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

    /// The same of some deposits, by their seeds.
    pub fn deposits(&self, is_in: impl Fn(f64) -> bool) -> Self {
        let lines = self.0.iter().filter(|line| is_in(line.seed));
        Self(lines.cloned().collect())
    }

    /// Every choice once.
    pub fn choices(&self) -> Vec<Choice> {
        let mut all: Vec<Choice> = Vec::new();
        for line in &self.0 {
            if !all.contains(&line.choice) {
                all.push(line.choice);
            }
        }
        all
    }

    /// Mean, scatter and number of a quantity of all deposits; nothing without runs.
    pub fn of(
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

    pub fn porosity(&self, choice: &Choice, pair: [f64; 2]) -> Option<(f64, f64, f64)> {
        let (mean, scatter, count) = self.of(choice, pair, |line| line.porosity)?;
        Some((
            mean,
            if scatter.is_nan() { SCATTER } else { scatter },
            count,
        ))
    }

    /// Fewest deposits at a corner.
    pub fn deposits_of(&self, choice: &Choice) -> f64 {
        let counts =
            CORNERS.map(|(pair, _)| self.porosity(choice, pair).map_or(0.0, |(.., count)| count));
        counts.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// χ² of the four corners by both errors.
    pub fn misfit(&self, choice: &Choice) -> Option<f64> {
        let each = CORNERS.into_iter().map(|(pair, thesis)| {
            let (ours, scatter, count) = self.porosity(choice, pair)?;
            Some((ours - thesis).powi(2) / (FLUCTUATION.powi(2) + scatter * scatter / count))
        });
        each.sum()
    }

    /// Largest difference of E(1,1) between choices with one group and one kind of walls, and the span of all: ranges
    /// that the load of the piston's pressure does not close.
    pub fn collapse(&self, judged: &[(Choice, f64)]) -> [f64; 2] {
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
    pub fn rises(&self, choice: &Choice) -> Option<[f64; 2]> {
        let rise = |[from, to]: [[f64; 2]; 2]| {
            Some(self.porosity(choice, to)?.0 - self.porosity(choice, from)?.0)
        };
        let [one, other] = SATURATED;
        Some([rise(one)?, rise(other)?])
    }

    /// χ² of the corners and both rises, of two fluctuations each.
    pub fn whole_misfit(&self, choice: &Choice) -> Option<f64> {
        let rises = self.rises(choice)?;
        let of_rises = rises
            .iter()
            .map(|rise| rise * rise / (2.0 * FLUCTUATION.powi(2)));
        Some(self.misfit(choice)? + of_rises.sum::<f64>())
    }

    /// χ² of σ_zz⁺ in the lines of table 4.1.
    pub fn stress_misfit(&self, choice: &Choice) -> Option<f64> {
        stress_misfit(|pair| self.of(choice, pair, |line| line.plus))
    }
}

/// χ² of σ_zz⁺ in the lines of table 4.1, each of one packing of the thesis that scatters as one of ours does. `ours` has
/// mean, scatter and number of deposits.
pub(super) fn stress_misfit(ours: impl Fn([f64; 2]) -> Option<(f64, f64, f64)>) -> Option<f64> {
    let each = TABLE.into_iter().map(|[rolling, torsion, thesis, _]| {
        let (ours, scatter, count) = ours([rolling, torsion])?;
        let variance = scatter * scatter * (1.0 + 1.0 / count) + HALF_DIGIT * HALF_DIGIT / 3.0;
        Some((ours - thesis).powi(2) / variance)
    });
    each.sum()
}
