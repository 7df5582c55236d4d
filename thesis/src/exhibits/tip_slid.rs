//! Section 5.3: the experiments with the atomic force microscope, on the slid tip.

use super::tip_loads::{self, load_claims, repeated};
use super::tip_runs::{Line, Point, Row, RunResult, SEEDS, Slide, all, slid};
use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use tribos::statistics::mean_and_error;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, Series};

pub(super) const TEXT: Text = Text(include_str!("section-5.3.md"));

/// Speed, load on a driven atom and temperature of the row that is varied.
const SPEED: f64 = 0.2;
const LOAD: f64 = 1.0;
pub(super) const TEMPERATURE: f64 = 0.1;

/// Periods of the lateral force that count as the lattice's, in spacings: ours. A tip may jump over
/// more than one site.
const PERIODS: std::ops::RangeInclusive<f64> = 0.5..=2.0;

/// What is varied beside the load.
struct Plan {
    speeds: &'static [f64],
    temperatures: &'static [f64],
}

/// Each list contains the value of the row that is varied.
const QUICK: Plan = Plan {
    speeds: &[0.1, 0.2, 0.4],
    temperatures: &[0.01, 0.1, 0.3],
};
const FULL: Plan = Plan {
    speeds: &[0.025, 0.05, 0.1, 0.2, 0.4],
    temperatures: &[0.01, 0.03, 0.1, 0.2, 0.3],
};

/// The points at which the runs are, each once.
fn points(effort: Effort) -> Vec<[f64; 3]> {
    let plan = match effort {
        Effort::Quick => QUICK,
        Effort::Full => FULL,
    };
    let own = [LOAD, SPEED, TEMPERATURE];
    let others = |list: &'static [f64], own: f64| list.iter().copied().filter(move |&x| x != own);
    let speeds = others(plan.speeds, SPEED).map(|speed| [LOAD, speed, TEMPERATURE]);
    let heats = others(plan.temperatures, TEMPERATURE).map(|heat| [LOAD, SPEED, heat]);
    std::iter::once(own).chain(speeds).chain(heats).collect()
}

/// The friction loop, and friction over load, speed and temperature.
pub fn section_5_3(runs: &Runs) -> Result<Exhibit> {
    let at = points(runs.effort());
    let row = |&[load, speed, heat]: &[f64; 3]| slid(runs.effort(), speed, load, heat);
    let rows: Vec<Row> = at.iter().map(row).collect();
    let ran = all(runs, &rows)?;
    let points: Vec<Point> = at
        .into_iter()
        .zip(&ran)
        .map(|(at, ran)| Point::new(at, ran))
        .collect();
    let loads = tip_loads::points(runs)?;
    let of = |is_of: fn(&&Point) -> bool| points.iter().filter(is_of).collect::<Vec<_>>();
    let speeds = of(|point| point.temperature == TEMPERATURE);
    let heats = of(|point| point.speed == SPEED);
    let every: Vec<&Point> = loads.iter().chain(&points).collect();
    let mut claims = claims(rows[0].scene.spacing, &loads, &every);
    claims.extend(load_claims(&loads));
    claims.push(speed_claim(&speeds));
    claims.push(Claim::not_checkable(
        TEXT.said("temperature").with("frictions", list(&heats)),
    ));
    let seeds = format!("{SEEDS} seeds a row");
    let claims = claims.into_iter().map(|claim| claim.uncertain(&seeds));
    let claims = claims.chain([repeated(runs)?]).collect();
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()),
        figure(slowest(&rows, &ran), &loads, &speeds, &heats),
        &[
            "load",
            "speed",
            "temperature",
            "friction",
            "friction_error",
            "normal_force",
            "normal_force_error",
            "period",
            "period_error",
            "imbalance",
        ],
        every.into_iter().map(numbers).collect(),
        claims,
    )
    .seeded(1..=SEEDS)
    .kept("exhibits/tip_loads/runs.csv (loads of a quick report)"))
}

/// The first run of the slowest row.
fn slowest<'a>(rows: &[Row], ran: &'a [Vec<RunResult>]) -> Option<&'a RunResult> {
    let slower = |a: &(&Row, _), b: &(&Row, _)| {
        let [a, b] = [a, b].map(|(row, _)| row.scene.speed.unwrap_or_default());
        a.total_cmp(&b)
    };
    let (_, ran) = rows.iter().zip(ran).min_by(slower)?;
    ran.first()
}

fn numbers(point: &Point) -> Vec<f64> {
    let [friction, normal, period] = [
        point.friction(),
        point.of(|slid| slid.normal_force),
        point.of(|slid| slid.period),
    ];
    let [imbalance, _] = point.of(|slid| slid.imbalance);
    let at = [point.load, point.speed, point.temperature];
    [&at[..], &friction, &normal, &period, &[imbalance]].concat()
}

/// Friction with its error over a number of each point.
fn curve(points: &[&Point], x: impl Fn(&Point) -> f64) -> Series {
    let mut all: Vec<(f64, [f64; 2])> = points
        .iter()
        .map(|point| (x(point), point.friction()))
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let line = all.iter().map(|(x, [mean, _])| (*x, *mean)).collect();
    let errors = all.iter().map(|(_, [_, error])| *error).collect();
    Series::line_points("", line).errors(errors)
}

fn figure(
    slowest: Option<&RunResult>,
    loads: &[Point],
    speeds: &[&Point],
    heats: &[&Point],
) -> Panels {
    let friction = || Axis::linear("friction [ε/σ]");
    let mut circuit = Figure::new(
        "Friction loop",
        Axis::linear("support [σ]"),
        Axis::linear("lateral force [ε/σ]"),
    );
    if let Some(ran) = slowest {
        circuit = circuit.series(Series::line("", ran.curve("support", "lateral_force")));
    }
    let normal = |point: &Point| point.of(|slid| slid.normal_force)[0];
    Panels::new("", 2)
        .figure(circuit)
        .figure(
            Figure::new("Load", Axis::linear("normal force [ε/σ]"), friction())
                .series(curve(&loads.iter().collect::<Vec<_>>(), normal)),
        )
        .figure(
            Figure::new("Speed", Axis::log10("speed [√(ε/m)]"), friction())
                .series(curve(speeds, |point| point.speed)),
        )
        .figure(
            Figure::new(
                "Temperature",
                Axis::linear("temperature [ε/k_B]"),
                friction(),
            )
            .series(curve(heats, |point| point.temperature)),
        )
}

/// What section 5.3 says of experiments and simulations of others.
fn claims(spacing: f64, loads: &[Point], every: &[&Point]) -> Vec<Claim> {
    let periods = loads
        .iter()
        .map(|point| point.of(|slid| slid.period)[0] / spacing);
    let [period, error] = mean_and_error(&periods.collect::<Vec<_>>());
    let all: Vec<Slide> = every.iter().flat_map(|point| point.slid.clone()).collect();
    let open = all.iter().filter(|slid| slid.loop_work > 0.0).count();
    let balance = all
        .iter()
        .map(|slid| slid.imbalance.abs())
        .fold(0.0, f64::max);
    vec![
        Claim::trend(
            TEXT.said("period"),
            format!("{period:.3} ± {error:.3} spacings"),
            PERIODS.contains(&period),
        ),
        Claim::trend(
            TEXT.said("loop"),
            format!("{open} of {} loops have a positive area", all.len()),
            open == all.len(),
        ),
        Claim::own_statement(
            TEXT.said("heat"),
            format!("{:.2} % of the work at most is missing", 100.0 * balance),
            balance < 0.05,
        ),
    ]
}

/// An increase with ln v that is larger than three of its errors, or none that shows.
fn speed_claim(speeds: &[&Point]) -> Claim {
    let all: Vec<(f64, f64)> = speeds
        .iter()
        .flat_map(|point| {
            point
                .slid
                .iter()
                .map(|slid| (point.speed.ln(), slid.friction))
        })
        .collect();
    let line = Line::through(&all);
    Claim::trend(
        TEXT.said("speed"),
        format!(
            "F rises by {:.2} ± {:.2} for each unit of ln v: {}",
            line.slope,
            line.error,
            list(speeds)
        ),
        line.slope > 2.0 * line.error,
    )
}

/// Frictions of a list of rows, by what is varied.
fn list(points: &[&Point]) -> String {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| {
        let by_speed = a.speed.total_cmp(&b.speed);
        by_speed.then(a.temperature.total_cmp(&b.temperature))
    });
    let is_of_speeds = points.iter().any(|point| point.speed != SPEED);
    let words = sorted.iter().map(|point| {
        let [friction, error] = point.friction();
        let (name, at) = if is_of_speeds {
            ("v", point.speed)
        } else {
            ("T", point.temperature)
        };
        format!("{friction:.2} ± {error:.2} at {name} = {at}")
    });
    words.collect::<Vec<_>>().join(", ")
}
