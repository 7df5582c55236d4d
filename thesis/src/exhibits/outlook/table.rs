//! Runs behind section 5.2: a kept table, or runs of this report.

use crate::runs::{Case, Run, Runs, System};
use anyhow::Result;
use std::path::Path;
use tribos::powder::PowderStopReason;
use tribos::record::{OtherColumns, Rows};
use tribos::scene::{BlockedCriterion, FrictionCoupling};

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("runs.csv");

/// Ratios of pressure to cohesion, P R²/F_coh: 1/1600 to 16/25.
pub const PRESSURES: [f64; 6] = [0.000_625, 0.0025, 0.01, 0.04, 0.16, 0.64];
/// Half the width of the distribution of radii, in mean radii.
pub const SPREADS: [f64; 4] = [0.0, 0.2, 0.4, 0.6];
/// The couplings of sliding and torsion, the one without first.
pub const COUPLINGS: [FrictionCoupling; 3] = [
    FrictionCoupling::Independent,
    FrictionCoupling::Ellipsoid,
    FrictionCoupling::Exact,
];
/// Rolling and torsion coefficients.
pub const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
/// Deposits of each width in a full report.
const SEEDS: u64 = 5;

/// What a compaction was made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompactionParameters {
    pub seed: u64,
    pub spread: f64,
    pub pressure: f64,
    /// μ_t and μ_n.
    pub corner: [f64; 2],
    pub coupling: FrictionCoupling,
}

/// A compaction and its end.
#[derive(Clone, Debug)]
pub struct Line {
    pub made: CompactionParameters,
    pub blocked: bool,
    pub porosity: f64,
    pub contacts: f64,
    pub steps: f64,
    pub unmet: f64,
    pub sweeps: f64,
    /// σ_zz⁻ in units of the pressure.
    pub pull: f64,
    /// Wall-clock time, in s.
    pub seconds: f64,
}

impl CompactionParameters {
    /// The case of the report's runs.
    pub fn case(&self) -> Case {
        let Self {
            pressure, spread, ..
        } = *self;
        let mut case = Case::new(System::Small, self.corner, self.seed)
            .with("blocked=piston", |scene| {
                scene.blocked_criterion = BlockedCriterion::Piston
            })
            .with(&format!("pressure={pressure}"), |scene| {
                scene.pressure = pressure
            })
            .with(&format!("radius_spread={spread}"), |scene| {
                scene.radius_spread = spread
            });
        if self.coupling != FrictionCoupling::Independent {
            let coupling = self.coupling;
            case = case.with(&format!("coupling={}", name(coupling)), |scene| {
                scene.coupling = coupling
            });
        }
        case
    }

    /// All that a full report makes.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for seed in 1..=SEEDS {
            for (spread, pressure) in cells() {
                for corner in CORNERS {
                    let couplings = if corner[1] > 0.0 {
                        &COUPLINGS[..]
                    } else {
                        &COUPLINGS[..1]
                    };
                    all.extend(couplings.iter().map(|&coupling| Self {
                        seed,
                        spread,
                        pressure,
                        corner,
                        coupling,
                    }));
                }
            }
        }
        all
    }
}

impl Line {
    /// Of a run of this report.
    pub fn of(made: CompactionParameters, run: &Run) -> Self {
        let outcome = &run.outcome;
        Self {
            made,
            blocked: outcome.ending == Some(PowderStopReason::Blocked),
            porosity: outcome.porosity_final,
            contacts: outcome.contacts as f64,
            steps: outcome.steps as f64,
            unmet: outcome.steps_unmet as f64,
            sweeps: outcome.iterations_total as f64,
            pull: outcome.stress_zz_minus,
            seconds: outcome.wall_seconds,
        }
    }
}

/// Widths and pressures, width by width.
pub fn cells() -> impl Iterator<Item = (f64, f64)> {
    SPREADS.into_iter().flat_map(|spread| {
        PRESSURES
            .into_iter()
            .map(move |pressure| (spread, pressure))
    })
}

/// Its word in scenes.
pub fn name(coupling: FrictionCoupling) -> &'static str {
    match coupling {
        FrictionCoupling::Independent => "independent",
        FrictionCoupling::Ellipsoid => "ellipsoid",
        FrictionCoupling::Exact => "exact",
    }
}

/// Everything, run now.
pub fn run(runs: &Runs) -> Result<Vec<Line>> {
    let all = CompactionParameters::all();
    let cases: Vec<Case> = all.iter().map(CompactionParameters::case).collect();
    let done = runs.of(&cases)?;
    Ok(all
        .into_iter()
        .zip(done)
        .map(|(made, run)| Line::of(made, &run))
        .collect())
}

/// The kept table.
pub fn kept() -> Result<Vec<Line>> {
    parse(KEPT)
}

/// Columns of the table that are numbers, then those that are words.
const NUMBERS: usize = 12;
const COLUMNS: [&str; NUMBERS + 2] = [
    "seed",
    "radius_spread",
    "pressure",
    "mu_rolling",
    "mu_torsion",
    "porosity_final",
    "contacts",
    "steps",
    "steps_unmet",
    "iterations_total",
    "stress_zz_minus",
    "wall_seconds",
    "coupling",
    "ending",
];

/// Lines of a table with these columns among others.
pub fn parse(text: &str) -> Result<Vec<Line>> {
    let (file, others) = (Path::new("runs.csv"), OtherColumns::Ignored);
    let mut rows = Rows::of(file, text.as_bytes(), others, |_| &COLUMNS)?;
    let (mut lines, mut row) = (Vec::new(), [0.0; NUMBERS]);
    while rows.next(&mut row)?.is_some() {
        let [
            seed,
            spread,
            pressure,
            rolling,
            torsion,
            porosity,
            contacts,
            steps,
            unmet,
            sweeps,
            pull,
            seconds,
        ] = row;
        let [coupling, ending] = rows.words() else {
            continue;
        };
        let known = COUPLINGS.into_iter().find(|&known| name(known) == coupling);
        lines.push(Line {
            made: CompactionParameters {
                seed: seed as u64,
                spread,
                pressure,
                corner: [rolling, torsion],
                coupling: known.ok_or_else(|| rows.refusal("unknown coupling"))?,
            },
            blocked: ending == "blocked",
            porosity,
            contacts,
            steps,
            unmet,
            sweeps,
            pull,
            seconds,
        });
    }
    Ok(lines)
}
