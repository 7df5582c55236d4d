//! Sums and differences of porosities over the map, deposit by deposit.

use super::table::{CompactionParameters, Line};
use tribos::scene::FrictionCoupling;
use tribos::statistics::{mean, mean_and_error};

/// Mean of some deposits, and what it is good to.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// One value a deposit.
    pub values: Vec<f64>,
}

/// Two-sided 95 % quantiles of Student's t with 1, 2, … degrees of freedom (Abramowitz and Stegun, table 26.10).
const STUDENT: [f64; 9] = [
    12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262,
];
/// The same for more than that: a bound on what follows, 2.23 to 1.96.
const STUDENT_BEYOND: f64 = 2.228;

impl Estimate {
    pub fn mean(&self) -> f64 {
        mean(&self.values)
    }

    /// Standard error of the mean; NaN of less than two.
    pub fn error(&self) -> f64 {
        mean_and_error(&self.values)[1]
    }

    /// Half the width of the 95 % interval of the mean; NaN of less than two.
    pub fn half_width(&self) -> f64 {
        let freedom = self.values.len().saturating_sub(2);
        self.error() * STUDENT.get(freedom).copied().unwrap_or(STUDENT_BEYOND)
    }

    /// Whether 0 lies outside of the 95 % interval.
    pub fn differs_from_zero(&self) -> bool {
        self.mean().abs() > self.half_width()
    }
}

/// The runs of a map.
#[derive(Debug)]
pub struct Map {
    lines: Vec<Line>,
    /// Seeds of all lines, each once.
    seeds: Vec<u64>,
}

/// A corner with its coupling, and its weight in a sum.
pub type Term = ([f64; 2], FrictionCoupling, f64);

impl Map {
    pub fn new(lines: Vec<Line>) -> Self {
        let mut seeds: Vec<u64> = lines.iter().map(|line| line.made.seed).collect();
        seeds.sort_unstable();
        seeds.dedup();
        Self { lines, seeds }
    }

    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    pub fn line(&self, made: CompactionParameters) -> Option<&Line> {
        self.lines.iter().find(|line| line.made == made)
    }

    /// Weighted sums over the terms in a cell, one of each deposit that has them all.
    pub fn sums(
        &self,
        (spread, pressure): (f64, f64),
        terms: &[Term],
        of: impl Fn(&Line) -> f64,
    ) -> Estimate {
        let sum = |&seed: &u64| {
            let parts = terms.iter().map(|&(corner, coupling, weight)| {
                let coupling = if corner[1] > 0.0 {
                    coupling
                } else {
                    FrictionCoupling::Independent
                };
                let made = CompactionParameters {
                    seed,
                    spread,
                    pressure,
                    corner,
                    coupling,
                };
                self.line(made).map(|line| weight * of(line))
            });
            parts.sum::<Option<f64>>()
        };
        let values = self.seeds.iter().filter_map(sum).collect();
        Estimate { values }
    }

    /// Porosity at a corner.
    pub fn porosity(
        &self,
        cell: (f64, f64),
        corner: [f64; 2],
        coupling: FrictionCoupling,
    ) -> Estimate {
        self.sums(cell, &[(corner, coupling, 1.0)], |line| line.porosity)
    }

    /// E₁(1,1) − E₁(1,0) − E₁(0,1): 0 if the contributions add up.
    pub fn excess(&self, cell: (f64, f64), coupling: FrictionCoupling) -> Estimate {
        let terms = [
            ([1.0, 1.0], coupling, 1.0),
            ([1.0, 0.0], coupling, -1.0),
            ([0.0, 1.0], coupling, -1.0),
            ([0.0, 0.0], coupling, 1.0),
        ];
        self.sums(cell, &terms, |line| line.porosity)
    }

    /// What a coupling adds to the porosity at a corner.
    pub fn coupled(
        &self,
        cell: (f64, f64),
        corner: [f64; 2],
        coupling: FrictionCoupling,
    ) -> Estimate {
        let terms = [
            (corner, coupling, 1.0),
            (corner, FrictionCoupling::Independent, -1.0),
        ];
        self.sums(cell, &terms, |line| line.porosity)
    }

    /// Geometric mean over all pairs of the cost of a coupling over that of independent limits.
    pub fn cost(&self, coupling: FrictionCoupling, of: impl Fn(&Line) -> f64) -> f64 {
        let pair = |line: &&Line| line.made.coupling == coupling;
        let ratios = self.lines.iter().filter(pair).filter_map(|line| {
            let made = CompactionParameters {
                coupling: FrictionCoupling::Independent,
                ..line.made
            };
            Some((of(line) / of(self.line(made)?)).ln())
        });
        let logarithms = Estimate {
            values: ratios.collect(),
        };
        logarithms.mean().exp()
    }
}
