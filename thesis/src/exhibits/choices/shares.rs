//! What a blocked packing's contacts carry when they are solved anew, from a share of their last forces.

use super::super::stress::TABLE;
use super::table::stress_misfit;
use anyhow::{Context, Result};
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::statistics::statistics;

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("shares.csv");
const NUMBERS: usize = 6;
const COLUMNS: [&str; NUMBERS + 1] = [
    "mu_rolling",
    "mu_torsion",
    "porosity_initial",
    "porosity_final",
    "stress_zz",
    "stress_zz_plus",
    "warm_start",
];

/// One step of a packing at rest.
struct Solved {
    /// μ_t and μ_n.
    pair: [f64; 2],
    share: f64,
    /// Change of the porosity in the step, in points.
    sunk: f64,
    /// In units of the pressure.
    total: f64,
    plus: f64,
}

/// All of them.
pub(super) struct Shares(Vec<Solved>);

impl Shares {
    pub fn kept() -> Result<Self> {
        let (file, others) = (Path::new("shares.csv"), OtherColumns::Ignored);
        let mut rows = Rows::of(file, KEPT.as_bytes(), others, |_| &COLUMNS)?;
        let (mut all, mut row) = (Vec::new(), [0.0; NUMBERS]);
        while rows.next(&mut row)?.is_some() {
            let [rolling, torsion, before, after, total, plus] = row;
            let share = match rows.words() {
                [word] if word == "off" => 0.0,
                [word] if word == "on" => 1.0,
                words => words.concat().parse().context("no share")?,
            };
            all.push(Solved {
                pair: [rolling, torsion],
                share,
                sunk: 100.0 * (before - after),
                total,
                plus,
            });
        }
        Ok(Self(all))
    }

    /// From 0 to 1.
    pub fn each(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.0.iter().map(|solved| solved.share).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Packings of a line of the table, the fewest.
    pub fn deposits(&self) -> f64 {
        let counts = TABLE.map(|[rolling, torsion, ..]| {
            self.plus(1.0, [rolling, torsion])
                .map_or(0.0, |(.., count)| count)
        });
        counts.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Mean, scatter and number of σ_zz⁺ over the deposits.
    pub fn plus(&self, share: f64, pair: [f64; 2]) -> Option<(f64, f64, f64)> {
        let chosen = |solved: &&Solved| solved.share == share && solved.pair == pair;
        let values: Vec<f64> = self
            .0
            .iter()
            .filter(chosen)
            .map(|solved| solved.plus)
            .collect();
        let (mean, scatter) = statistics(&values);
        (!values.is_empty()).then_some((mean, scatter, values.len() as f64))
    }

    /// χ² of the eight lines with one share.
    pub fn misfit(&self, share: f64) -> Option<f64> {
        stress_misfit(|pair| self.plus(share, pair))
    }

    /// The share with the least χ², and that.
    pub fn best(&self) -> Option<(f64, f64)> {
        let all = self.each().into_iter();
        let misfits = all.filter_map(|share| Some((share, self.misfit(share)?)));
        misfits.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The share at which the mean is the thesis' number, by straight lines from share to share; nothing where none is.
    pub fn needed(&self, pair: [f64; 2], thesis: f64) -> Option<f64> {
        let all = self.each();
        all.windows(2).find_map(|ends| {
            let &[low, high] = ends else { return None };
            let [a, b] = [self.plus(low, pair)?.0, self.plus(high, pair)?.0];
            let part = (thesis - a) / (b - a);
            (0.0..=1.0)
                .contains(&part)
                .then_some(low + part * (high - low))
        })
    }

    /// Shares that each line asks for; `None` where no share gives its number.
    pub fn all_needed(&self) -> [Option<f64>; 8] {
        TABLE.map(|[rolling, torsion, plus, _]| self.needed([rolling, torsion], plus))
    }

    /// Largest error of the total stress over the pressure, and largest motion in points of porosity.
    pub fn unrest(&self) -> [f64; 2] {
        let each = self.0.iter();
        each.fold([0.0, 0.0], |[error, motion]: [f64; 2], solved| {
            [
                error.max((solved.total - 1.0).abs()),
                motion.max(solved.sunk.abs()),
            ]
        })
    }
}
