//! Section 4.6: which choices, stated or not, give the thesis' porosities and stresses together.

mod claims;
mod figure;
mod shares;
mod table;

use crate::exhibit::Exhibit;
use crate::runs::{Runs, System};
use crate::text::Text;
use anyhow::{Context, Result};
use claims::claims;
use figure::figure;
use shares::Shares;
use table::{Choice, Line, Table};

const TEXT: Text = Text(include_str!("section-4.6-choices.md"));

/// μ_t and μ_n of the corners, and the thesis' porosities there in per cent.
const CORNERS: [([f64; 2], f64); 4] = [
    ([0.0, 0.0], 54.0),
    ([0.0, 1.0], 62.0),
    ([1.0, 0.0], 72.0),
    ([1.0, 1.0], 82.0),
];
/// Fluctuation of the thesis' porosities, in points (section 4.6.1).
const FLUCTUATION: f64 = 2.0;
/// Half a unit of the last digit of table 4.1.
const HALF_DIGIT: f64 = 0.05;
/// χ² of four, six, seven and eight numbers that is exceeded by chance in one case of twenty.
const LIMITS: [f64; 4] = [9.49, 12.59, 14.07, 15.51];
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

/// All kept runs.
struct KeptTables {
    small: Table,
    large: Table,
    shares: Shares,
}

impl KeptTables {
    fn read() -> Result<Self> {
        let [small, large] = [System::Small, System::Large].map(|system| system.size()[0]);
        Ok(Self {
            small: Table::kept(small)?,
            large: Table::kept(large)?,
            shares: Shares::kept()?,
        })
    }
}

/// Porosities in per cent and σ_zz⁺ of all kept deposits of a system this wide, made as printed with our usual range and
/// walls.
pub(super) fn printed(width: f64, pair: [f64; 2]) -> Result<Vec<[f64; 2]>> {
    let lines = Table::kept(width)?.0;
    let chosen = |line: &&Line| line.choice == JUDGED[0] && line.pair == pair;
    let values = |line: &Line| [line.porosity, line.plus];
    Ok(lines.iter().filter(chosen).map(values).collect())
}

/// The share of the last forces from which a blocked packing, solved anew, carries the pushing stresses of table 4.1.
pub(super) fn best_share() -> Result<f64> {
    let best = Shares::kept()?.best();
    Ok(best.context("no share gives table 4.1")?.0)
}

/// The set of choices.
pub fn section_4_6_choices(runs: &Runs) -> Result<Exhibit> {
    let kept = KeptTables::read()?;
    let table = &kept.small;
    let mut judged: Vec<(Choice, f64)> = Vec::new();
    for choice in table.choices() {
        judged.extend(table.misfit(&choice).map(|misfit| (choice, misfit)));
    }
    judged.sort_by(|a, b| a.1.total_cmp(&b.1));
    let rows = table
        .choices()
        .iter()
        .map(|choice| row(&kept, choice))
        .collect();
    let five = |(choice, _): &&(Choice, f64)| table.deposits_of(choice) >= 5.0;
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort())
            .with("choices", judged.len())
            .with("five", judged.iter().filter(five).count())
            .with("runs", table.0.len())
            .with("large", kept.large.0.len())
            .with("packings", kept.shares.deposits())
            .with("share", best_share()?),
        figure(&kept, &judged),
        &[
            "mu",
            "pressure",
            "cohesion_range",
            "smooth_walls",
            "group",
            "deposits",
            "porosity_00",
            "porosity_01",
            "porosity_10",
            "porosity_11",
            "chi_squared_4",
            "chi_squared_6",
            "chi_squared_stress_8",
        ],
        rows,
        claims(runs, &kept, &judged)?,
    )
    .seeded(1..=5)
    .kept("exhibits/choices/runs.csv and shares.csv"))
}

fn row(KeptTables { small: table, .. }: &KeptTables, choice: &Choice) -> Vec<f64> {
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
        table.deposits_of(choice),
    ];
    [&made[..], &[a, b, c, d, four, six, eight]].concat()
}
