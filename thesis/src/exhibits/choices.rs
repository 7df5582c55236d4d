//! Section 4.6: which choices, stated or not, give the thesis' porosities and stresses together.

use super::stress::TABLE;
use crate::exhibit::Exhibit;
use crate::runs::{Case, Runs, System};
use crate::text::Text;
use anyhow::Result;
use std::path::Path;
use tribos::record::{OtherColumns, Rows};
use tribos::scene::WallLaw;
use tribos::statistics::statistics;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Panels, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-4.6-choices.md"));

/// The kept table with the commands that made it.
const KEPT: &str = include_str!("choices/runs.csv");
const NUMBERS: usize = 8;
const COLUMNS: [&str; NUMBERS + 3] = [
    "mu",
    "pressure",
    "cohesion_range",
    "mu_rolling",
    "mu_torsion",
    "seed",
    "porosity_final",
    "stress_zz_plus",
    "wall_contact",
    "warm_start",
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
/// Choices of which there are five deposits and all pairs: what the thesis prints with our usual range and walls first.
const JUDGED: [Choice; 4] = [
    Choice::new(0.3, 1.0, 1e-2, false),
    Choice::new(0.12, 1.0, 1e-4, true),
    Choice::new(0.2, 2.0, 1e-4, false),
    Choice::new(0.3, 2.0, 1e-4, true),
];
/// Shares of the last step's forces.
const SHARES: [f64; 3] = [1.0, 0.5, 0.0];

/// What a compaction is made with beside its friction torques.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Choice {
    mu: f64,
    pressure: f64,
    range: f64,
    is_smooth: bool,
    /// Share of the last step's forces that a step starts from.
    warm: f64,
}

impl Choice {
    /// The pressure as a multiple of the printed one.
    const fn new(mu: f64, times: f64, range: f64, is_smooth: bool) -> Self {
        Self {
            mu,
            pressure: times * PRINTED_PRESSURE,
            range,
            is_smooth,
            warm: 1.0,
        }
    }

    fn warm(self, warm: f64) -> Self {
        Self { warm, ..self }
    }

    /// μ F_coh/(P R²): what friction of a bond holds against the load on a square radius.
    fn group(&self) -> f64 {
        self.mu / self.pressure
    }

    fn words(&self) -> String {
        let walls = if self.is_smooth { "smooth" } else { "rough" };
        let times = self.pressure / PRINTED_PRESSURE;
        format!(
            "μ = {}, {times:.3} P, d_c = {:e} R, {walls} walls",
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
            let [walls, warm, ending] = rows.words() else {
                continue;
            };
            let warm = match warm.as_str() {
                "on" => 1.0,
                "off" => 0.0,
                share => share.parse()?,
            };
            lines.push(Line {
                choice: Choice {
                    mu,
                    pressure,
                    range,
                    is_smooth: walls == "smooth",
                    warm,
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
    let warm = |choice: &Choice| choice.warm == 1.0;
    let mut judged: Vec<(Choice, f64)> = Vec::new();
    for choice in table.choices().into_iter().filter(warm) {
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
            "warm_start",
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
        choice.warm,
        choice.group(),
    ];
    [&made[..], &[a, b, c, d, four, six, eight]].concat()
}

/// The misfit over the group; porosities and stresses of the judged choices beside the thesis'.
fn figure(table: &Table, judged: &[(Choice, f64)]) -> Panels {
    let mut over = Figure::new(
        "Four porosities",
        Axis::log10("μ F_coh/(P R²)"),
        Axis::log10("χ²"),
    );
    for is_smooth in [true, false] {
        for range in [1e-4, 1e-3, 1e-2] {
            let of = |(choice, _): &&(Choice, f64)| {
                choice.is_smooth == is_smooth && choice.range == range
            };
            let points = judged
                .iter()
                .filter(of)
                .map(|(choice, misfit)| (choice.group(), *misfit));
            let walls = if is_smooth { "smooth" } else { "rough" };
            over = over.series(Series::points(
                format!("{range:e} R, {walls}"),
                points.collect(),
            ));
        }
    }
    let over = over.guide(ReferenceLine::horizontal(LIMITS[0], "95 %"));
    let porosities = beside(
        "Porosities",
        "final porosity [%]",
        &CORNERS.map(|(pair, thesis)| (pair, thesis)),
        |choice, pair| table.porosity(choice, pair).map(|found| found.0),
    );
    let lines = TABLE.map(|[rolling, torsion, plus, _]| ([rolling, torsion], plus));
    let stresses = beside(
        "Stress of pushing contacts",
        "σ_zz⁺/P",
        &lines,
        |choice, pair| {
            table
                .of(choice, pair, |line| line.plus)
                .map(|found| found.0)
        },
    );
    let shares = SHARES.into_iter().fold(
        Figure::new(
            "Shares of a warm start",
            names(&lines),
            Axis::linear("σ_zz⁺/P"),
        )
        .series(thesis(&lines)),
        |figure, share| {
            let choice = JUDGED[3].warm(share);
            let of = |pair| {
                table
                    .of(&choice, pair, |line| line.plus)
                    .map(|found| found.0)
            };
            figure.series(Series::line_points(
                format!("share {share}"),
                placed(&lines, of),
            ))
        },
    );
    Panels::new("", 2)
        .cell(620, 420)
        .figure(over)
        .figure(porosities)
        .figure(stresses)
        .figure(shares)
}

fn names(lines: &[([f64; 2], f64)]) -> Axis {
    let names = lines
        .iter()
        .map(|([rolling, torsion], _)| format!("({rolling}, {torsion})"));
    Axis::named("(μ_t, μ_n)", names.collect())
}

fn thesis(lines: &[([f64; 2], f64)]) -> Series {
    let points = lines
        .iter()
        .enumerate()
        .map(|(at, (_, value))| (1.0 + at as f64, *value));
    Series::line_points("thesis", points.collect())
}

fn placed(lines: &[([f64; 2], f64)], of: impl Fn([f64; 2]) -> Option<f64>) -> Vec<(f64, f64)> {
    let places = lines.iter().enumerate();
    places
        .filter_map(|(at, (pair, _))| Some((1.0 + at as f64, of(*pair)?)))
        .collect()
}

/// The thesis' numbers, and those of each judged choice.
fn beside(
    title: &str,
    label: &str,
    lines: &[([f64; 2], f64)],
    of: impl Fn(&Choice, [f64; 2]) -> Option<f64>,
) -> Figure {
    let figure = Figure::new(title, names(lines), Axis::linear(label)).legend(Legend::default());
    JUDGED
        .iter()
        .fold(figure.series(thesis(lines)), |figure, choice| {
            figure.series(Series::line_points(
                choice.words(),
                placed(lines, |pair| of(choice, pair)),
            ))
        })
}

/// "54.8 63.9 73.3 82.2 %".
fn corners(table: &Table, choice: &Choice) -> String {
    let shown = CORNERS.map(|(pair, _)| {
        table
            .porosity(choice, pair)
            .map_or(f64::NAN, |found| found.0)
    });
    format!(
        "{} %",
        shown.map(|porosity| format!("{porosity:.1}")).join(", ")
    )
}

fn claims(runs: &Runs, table: &Table, judged: &[(Choice, f64)]) -> Result<Vec<Claim>> {
    let [four, six, eight] = LIMITS;
    let compatible: Vec<&Choice> = judged
        .iter()
        .filter(|(_, misfit)| *misfit < four)
        .map(|(choice, _)| choice)
        .collect();
    let ends = |of: fn(&Choice) -> f64| {
        let values = compatible.iter().map(|choice| of(choice));
        values.fold([f64::INFINITY, 0.0_f64], |[least, most], x| {
            [least.min(x), most.max(x)]
        })
    };
    let [loosest, tightest] = ends(Choice::group);
    let [weakest, strongest] = ends(|choice| choice.mu);
    let [light, heavy] = ends(|choice| choice.pressure / PRINTED_PRESSURE);
    let is_printed = |choice: &Choice| choice.mu == 0.3 && choice.pressure == PRINTED_PRESSURE;
    let printed = judged.iter().find(|(choice, _)| is_printed(choice));
    let (nearest, misfit) = printed.map_or((JUDGED[0], f64::NAN), |found| *found);
    let mut claims = vec![
        Claim::own_statement(
            TEXT.said("printed"),
            format!(
                "χ² = {misfit:.0} at best, {}: {}",
                nearest.words(),
                corners(table, &nearest)
            ),
            misfit > four,
        ),
        Claim::own_statement(
            TEXT.said("compatible").with("limit", four),
            format!("{} of {}", compatible.len(), judged.len()),
            !compatible.is_empty() && compatible.iter().all(|choice| !is_printed(choice)),
        ),
        Claim::own_statement(
            TEXT.said("group"),
            format!("{loosest:.0} to {tightest:.0}"),
            tightest < 0.3 / PRINTED_PRESSURE && loosest > 0.2 * tightest,
        ),
        Claim::own_statement(
            TEXT.said("not-apart"),
            format!(
                "μ from {weakest} to {strongest}, pressures from {light} to {heavy} times the printed one"
            ),
            weakest < strongest && light < heavy,
        ),
    ];
    for choice in &JUDGED[1..] {
        let misfit = table.whole_misfit(choice).unwrap_or(f64::NAN);
        let rises = table.rises(choice).unwrap_or([f64::NAN; 2]);
        claims.push(
            Claim::own_statement(
                TEXT.said("whole")
                    .with("choice", choice.words())
                    .with("limit", six),
                format!(
                    "χ² = {misfit:.1}: {}; from 0.4 to 1 {:+.1} and {:+.1} points",
                    corners(table, choice),
                    rises[0],
                    rises[1]
                ),
                misfit < six,
            )
            .uncertain("five deposits"),
        );
    }
    let stresses = SHARES.map(|share| {
        table
            .stress_misfit(&JUDGED[3].warm(share))
            .unwrap_or(f64::NAN)
    });
    let shown = stresses.map(|misfit| format!("{misfit:.0}"));
    let least = stresses.into_iter().fold(f64::INFINITY, f64::min);
    claims.push(
        Claim::own_statement(
            TEXT.said("stress")
                .with("choice", JUDGED[3].words())
                .with("limit", eight),
            format!("χ² = {} with shares of 1, 0.5, 0", shown.join(", ")),
            least > eight,
        )
        .uncertain("five deposits"),
    );
    claims.extend(repeated(runs, table)?);
    Ok(claims)
}

/// A line of the table, run again.
fn repeated(runs: &Runs, table: &Table) -> Result<Option<Claim>> {
    let Choice {
        mu,
        pressure,
        range,
        ..
    } = JUDGED[3];
    let keys = format!("mu={mu},pressure={pressure},cohesion_range={range},wall=smooth");
    let case = Case::new(System::Small, [0.0; 2], 1).with(&keys, |scene| {
        (scene.mu, scene.pressure, scene.cohesion_range) = (mu, pressure, range);
        scene.wall_contact = WallLaw::Smooth;
    });
    let ours = 100.0 * runs.one(&case)?.outcome.porosity_final;
    let is_it =
        |line: &&Line| line.choice == JUDGED[3] && line.pair == [0.0; 2] && line.seed == 1.0;
    Ok(table
        .0
        .iter()
        .find(is_it)
        .map(|line| Claim::own(TEXT.said("repeated"), ours, line.porosity, 0.5)))
}
