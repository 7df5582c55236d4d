//! Section 5.3: the experiments with the atomic force microscope, on the slid tip.

use super::tip_runs::{Line, Row, RunResult, SEEDS, all, slid};
use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use tribos::statistics::mean_and_error;
use tribos::tip::SlidingSummary;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, Series};

const TEXT: Text = Text(include_str!("section-5.3.md"));

/// Speed, load on a driven atom and temperature of the row that is varied.
const SPEED: f64 = 0.2;
const LOAD: f64 = 1.0;
const TEMPERATURE: f64 = 0.1;

/// Periods of the lateral force that count as the lattice's, in spacings: ours. A tip may jump over
/// more than one site.
const PERIODS: std::ops::RangeInclusive<f64> = 0.5..=2.0;
/// What a row may leave the line by where friction is called "rather linear": ours.
const RATHER: f64 = 0.2;

/// What is varied, in the order of the rows.
struct Plan {
    loads: &'static [f64],
    speeds: &'static [f64],
    temperatures: &'static [f64],
}

/// Each list contains the value of the row that is varied.
const QUICK: Plan = Plan {
    loads: &[0.0, 1.0, 2.0],
    speeds: &[0.1, 0.2, 0.4],
    temperatures: &[0.01, 0.1, 0.3],
};
const FULL: Plan = Plan {
    loads: &[0.0, 0.5, 1.0, 1.5, 2.0, 3.0],
    speeds: &[0.025, 0.05, 0.1, 0.2, 0.4],
    temperatures: &[0.01, 0.03, 0.1, 0.2, 0.3],
};

/// A row of runs with what it is at.
struct Point {
    load: f64,
    speed: f64,
    temperature: f64,
    ran: Vec<RunResult>,
}

impl Point {
    /// Mean and standard error of a number of the slid tips.
    fn of(&self, number: fn(&SlidingSummary) -> f64) -> [f64; 2] {
        let slid = self.ran.iter().filter_map(|ran| ran.outcome.slid.as_ref());
        mean_and_error(&slid.map(number).collect::<Vec<_>>())
    }

    fn friction(&self) -> [f64; 2] {
        self.of(|slid| slid.friction)
    }
}

/// The points at which the runs are, each once.
fn points(effort: Effort) -> Vec<[f64; 3]> {
    let plan = match effort {
        Effort::Quick => QUICK,
        Effort::Full => FULL,
    };
    let loads = plan.loads.iter().map(|&load| [load, SPEED, TEMPERATURE]);
    let others = |list: &'static [f64], own: f64| list.iter().copied().filter(move |&x| x != own);
    let speeds = others(plan.speeds, SPEED).map(|speed| [LOAD, speed, TEMPERATURE]);
    let heats = others(plan.temperatures, TEMPERATURE).map(|heat| [LOAD, SPEED, heat]);
    loads.chain(speeds).chain(heats).collect()
}

/// The friction loop, and friction over load, speed and temperature.
pub fn section_5_3(runs: &Runs) -> Result<Exhibit> {
    let at = points(runs.effort());
    let row = |&[load, speed, heat]: &[f64; 3]| slid(runs.effort(), speed, load, heat);
    let rows: Vec<Row> = at.iter().map(row).collect();
    let points: Vec<Point> = at
        .into_iter()
        .zip(all(runs, &rows)?)
        .map(|([load, speed, temperature], ran)| Point {
            load,
            speed,
            temperature,
            ran,
        })
        .collect();
    let usual = |point: &&Point| point.speed == SPEED && point.temperature == TEMPERATURE;
    let loads: Vec<&Point> = points.iter().filter(usual).collect();
    let at_load = |point: &&Point| point.load == LOAD;
    let speeds: Vec<&Point> = points
        .iter()
        .filter(|point| at_load(point) && point.temperature == TEMPERATURE)
        .collect();
    let heats: Vec<&Point> = points
        .iter()
        .filter(|point| at_load(point) && point.speed == SPEED)
        .collect();
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()),
        figure(&loads, &speeds, &heats),
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
        points.iter().map(numbers).collect(),
        claims(&rows[0], &loads, &speeds, &heats)
            .into_iter()
            .map(|claim| claim.uncertain(format!("{SEEDS} seeds a row")))
            .collect(),
    ))
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

fn figure(loads: &[&Point], speeds: &[&Point], heats: &[&Point]) -> Panels {
    let friction = || Axis::linear("friction [ε/σ]");
    let mut circuit = Figure::new(
        "Friction loop",
        Axis::linear("support [σ]"),
        Axis::linear("lateral force [ε/σ]"),
    );
    if let Some(ran) = speeds.first().and_then(|point| point.ran.first()) {
        circuit = circuit.series(Series::line("", ran.curve("support", "lateral_force")));
    }
    let normal = |point: &Point| point.of(|slid| slid.normal_force)[0];
    Panels::new("", 2)
        .figure(circuit)
        .figure(
            Figure::new("Load", Axis::linear("normal force [ε/σ]"), friction())
                .series(curve(loads, normal)),
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
fn claims(row: &Row, loads: &[&Point], speeds: &[&Point], heats: &[&Point]) -> Vec<Claim> {
    let at_own = |point: &&&Point| {
        (point.load, point.speed, point.temperature) != (LOAD, SPEED, TEMPERATURE)
    };
    let others = || speeds.iter().chain(heats).filter(at_own);
    let every = || loads.iter().chain(others());
    let slid = |point: &&&Point| -> Vec<SlidingSummary> {
        point
            .ran
            .iter()
            .filter_map(|ran| ran.outcome.slid)
            .collect()
    };
    let [period, error] = mean_and_error(
        &loads
            .iter()
            .map(|point| point.of(|slid| slid.period)[0] / row.scene.spacing)
            .collect::<Vec<_>>(),
    );
    let all: Vec<SlidingSummary> = every().flat_map(|point| slid(&point)).collect();
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
        load_claim(loads),
        Claim::not_checkable(TEXT.said("coefficient").with("mu", {
            let line = load_line(loads);
            format!("{:.4} ± {:.4}", line.slope, line.error)
        }))
        .printed("0.01"),
        speed_claim(speeds),
        Claim::own_statement(
            TEXT.said("heat"),
            format!("{:.2} % of the work at most is missing", 100.0 * balance),
            balance < 0.05,
        ),
        Claim::not_checkable(TEXT.said("temperature").with("frictions", list(heats))),
    ]
}

/// Friction of each run over its normal force.
fn load_line(loads: &[&Point]) -> Line {
    let of_run = |ran: &RunResult| {
        let slid = ran.outcome.slid?;
        Some((slid.normal_force, slid.friction))
    };
    let all: Vec<(f64, f64)> = loads
        .iter()
        .flat_map(|point| point.ran.iter().filter_map(of_run))
        .collect();
    Line::through(&all)
}

fn load_claim(loads: &[&Point]) -> Claim {
    let line = load_line(loads);
    // Means of the rows against the line, in their standard errors and in parts of the friction.
    let off = |size: fn([f64; 2]) -> f64| {
        let rows = loads.iter().map(|point| {
            let [normal, _] = point.of(|slid| slid.normal_force);
            let friction = point.friction();
            (friction[0] - line.intercept - line.slope * normal).abs() / size(friction)
        });
        rows.fold(0.0, f64::max)
    };
    let (errors, parts) = (off(|[_, error]| error), off(|[friction, _]| friction));
    Claim::trend(
        TEXT.said("load"),
        format!(
            "F = {:.2} + ({:.4} ± {:.4}) N; rows are within {errors:.1} standard errors or {:.0} % of it",
            line.intercept,
            line.slope,
            line.error,
            100.0 * parts
        ),
        line.slope > 3.0 * line.error && parts <= RATHER,
    )
}

/// An increase with ln v that is larger than three of its errors, or none that shows.
fn speed_claim(speeds: &[&Point]) -> Claim {
    let all: Vec<(f64, f64)> = speeds
        .iter()
        .flat_map(|point| {
            let slid = point.ran.iter().filter_map(|ran| ran.outcome.slid);
            slid.map(|slid| (point.speed.ln(), slid.friction))
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
