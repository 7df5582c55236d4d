//! Section 4.4.1: events, soft particles and contact dynamics on problems with known answers.

use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use tribos::statistics::straight_line;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};
use tribos_trials::{Ball, Column, Cooling, Method, Slope, Trial, TrialResult, run};

const TEXT: Text = Text(include_str!("section-4.4.1.md"));

/// Spheres of the column, and of the one with a heavy top.
const SPHERES: usize = 20;
const FEW_SPHERES: usize = 6;
/// Step of contact dynamics, in √(R/g), and largest motion of a step in the gas, in R.
const STEP: f64 = 0.1;
const MOTION: f64 = 0.05;
/// Collisions a sphere of the gas.
const COLLISIONS: f64 = 8.0;
/// First seed of the starts that give the gas' reference.
const OTHER_STARTS: u64 = 1001;
/// Spheres moved in the time of a collision of events, from the front "methods".
const A_COLLISION: &str = "25 to 90";
/// Speed that counts as none, in √(g R).
const STILL: f64 = 1e-7;
/// Names of the panels.
const TITLES: [&str; 5] = ["Column", "Heavy top", "Ball", "Slope", "Gas"];
/// What is judged in each panel, of the trials' quantities, and its name.
const JUDGED: [(usize, &str); 5] = [
    (0, "force on the floor [weight]"),
    (0, "force on the floor [weight]"),
    (1, "way [sliding length]"),
    (0, "creep [√(g R)]"),
    (0, "temperature [reference]"),
];
/// Errors below rounding are drawn at it.
const ROUNDING: f64 = 1e-16;

/// What is computed.
struct Extent {
    heavy: f64,
    times: [f64; 3],
    tolerances: &'static [f64],
    stiffnesses: &'static [f64],
    /// Stiffnesses under the heavy top and in the gas.
    heavy_stiffnesses: &'static [f64],
    gas_stiffnesses: &'static [f64],
    /// Spheres and starts of the gas, and starts of its reference.
    gas: (usize, [u64; 2]),
}

const QUICK: Extent = Extent {
    heavy: 1e4,
    times: [20.0, 5.0, 20.0],
    tolerances: &[1e-2, 1e-4, 1e-6],
    stiffnesses: &[1e2, 1e3, 1e4],
    heavy_stiffnesses: &[1e2],
    gas_stiffnesses: &[1e4],
    gas: (400, [4, 16]),
};
const FULL: Extent = Extent {
    heavy: 1e6,
    times: [40.0, 20.0, 100.0],
    tolerances: &[1e-2, 1e-4, 1e-6, 1e-9],
    stiffnesses: &[1e2, 1e3, 1e4, 1e5],
    heavy_stiffnesses: &[1e2, 1e3],
    gas_stiffnesses: &[1e3, 1e4, 1e5],
    gas: (1000, [8, 100]),
};

/// A method on the trial of a panel.
struct Point {
    panel: usize,
    method: Method,
    found: TrialResult,
}

/// Three methods on five problems.
pub fn section_4_4_1(runs: &Runs) -> Result<Exhibit> {
    let extent = match runs.effort() {
        Effort::Quick => QUICK,
        Effort::Full => FULL,
    };
    let points = measured(&extent)?;
    let rows = points.iter().map(|point| {
        let kind = match point.method {
            Method::Events => 0.0,
            Method::ContactDynamics { .. } => 1.0,
            Method::Soft { .. } => 2.0,
        };
        let parameter = match point.method {
            Method::Events => f64::NAN,
            Method::ContactDynamics {
                tolerance, step, ..
            } if point.panel != 2 => tolerance.min(step),
            Method::ContactDynamics { step, .. } => step,
            Method::Soft { stiffness, .. } => stiffness,
        };
        let TrialResult { errors, updates } = &point.found;
        vec![
            point.panel as f64,
            kind,
            parameter,
            errors[0],
            errors[1],
            *updates,
        ]
    });
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort())
            .with("spheres", SPHERES)
            .with("collision", A_COLLISION)
            .with("collisions", COLLISIONS),
        figure(&points),
        &[
            "trial",
            "method",
            "parameter",
            "error",
            "second_error",
            "updates",
        ],
        rows.collect(),
        claims(&points, &extent),
    )
    .seeded(1..=extent.gas.1[0]))
}

/// All points.
fn measured(extent: &Extent) -> Result<Vec<Point>> {
    let [alone, heavy, slope] = extent.times;
    let column = |spheres, top, time| Column { spheres, top, time };
    let rigid = || extent.tolerances.iter().map(|&t| Method::rigid(t, STEP));
    let soft = |stiffnesses: &'static [f64]| stiffnesses.iter().map(|&k| Method::soft(k));
    let usual = || rigid().chain(soft(extent.stiffnesses)).collect::<Vec<_>>();
    let of_steps = [0.1, 0.01, 0.001].map(|step| Method::rigid(1e-6, step));
    let of_steps = of_steps.into_iter().chain(soft(extent.stiffnesses));
    let (count, [starts, others]) = extent.gas;
    let gas = Cooling {
        count,
        fraction: 0.05,
        restitution: 0.9,
        collisions: COLLISIONS,
        seeds: [1, starts],
        reference: f64::NAN,
    };
    let gas = gas.referred([OTHER_STARTS, others])?;
    let of_gas = [Method::Events, Method::rigid(1e-4, MOTION)].into_iter();
    let slope = Slope {
        mu: 0.5,
        mu_rolling: 0.2,
        slope: 0.1,
        time: slope,
    };
    let ball = Ball {
        mu: 0.2,
        speed: 2.0,
    };
    let heavy_methods = rigid().chain(soft(extent.heavy_stiffnesses)).collect();
    let trials: [(Box<dyn Trial>, Vec<Method>); 5] = [
        (Box::new(column(SPHERES, 1.0, alone)), usual()),
        (
            Box::new(column(FEW_SPHERES, extent.heavy, heavy)),
            heavy_methods,
        ),
        (Box::new(ball), of_steps.collect()),
        (Box::new(slope), usual()),
        (
            Box::new(gas),
            of_gas.chain(soft(extent.gas_stiffnesses)).collect(),
        ),
    ];
    let mut points = Vec::new();
    for (panel, (trial, methods)) in trials.iter().enumerate() {
        for &method in methods {
            let found = run(trial.as_ref(), method)?;
            points.push(Point {
                panel,
                method,
                found,
            });
        }
    }
    Ok(points)
}

fn figure(points: &[Point]) -> Panels {
    let mut panels = Panels::new("", 2).cell(540, 360);
    for (panel, (title, (judged, quantity))) in TITLES.into_iter().zip(JUDGED).enumerate() {
        let here = || points.iter().filter(move |point| point.panel == panel);
        let mut figure = Figure::new(title, Axis::log10("updates"), Axis::log10(quantity));
        for name in ["events", "contact dynamics", "soft particles"] {
            let of = here().filter(|point| point.method.name() == name);
            let place = |point: &Point| {
                let error = point.found.errors[judged].max(ROUNDING);
                (point.found.updates, error)
            };
            let places: Vec<(f64, f64)> = of.map(place).collect();
            if !places.is_empty() {
                figure = figure.series(Series::line_points(name, places));
            }
        }
        let scatter = here().find(|point| point.method == Method::Events);
        if let Some(point) = scatter {
            figure = figure.guide(ReferenceLine::horizontal(point.found.errors[1], "scatter"));
        }
        panels = panels.figure(figure);
    }
    panels
}

/// The sentences of the section.
fn claims(points: &[Point], extent: &Extent) -> Vec<Claim> {
    [
        gas_claims(points),
        soft_claims(points),
        rigid_claims(points, extent),
    ]
    .concat()
}

/// Points of a panel by one kind of method.
fn of<'a>(
    points: &'a [Point],
    panel: usize,
    kind: &'static str,
) -> impl Iterator<Item = &'a Point> {
    let here = move |point: &&Point| point.panel == panel && point.method.name() == kind;
    points.iter().filter(here)
}

const RIGID: &str = "contact dynamics";
const SOFT: &str = "soft particles";

fn gas_claims(points: &[Point]) -> Vec<Claim> {
    let all = || points.iter().filter(|point| point.panel == 4);
    let collisions = of(points, 4, "events").map(|point| point.found.updates);
    let collisions = collisions.fold(f64::NAN, f64::max);
    let moved = all().filter(|point| point.method != Method::Events);
    let moved = moved.map(|point| point.found.updates);
    let moved = moved.fold(f64::INFINITY, f64::min);
    let is_near = |point: &Point| {
        let [error, scatter] = [point.found.errors[0], point.found.errors[1]];
        error < 3.0 * scatter + 0.01
    };
    let told: Vec<String> = all()
        .map(|point| {
            format!(
                "{} {:.2} %",
                point.method.name(),
                100.0 * point.found.errors[0]
            )
        })
        .collect();
    vec![
        Claim::trend(
            TEXT.said("gas"),
            format!("{collisions:.0} collisions, {moved:.0} spheres moved"),
            collisions < 0.01 * moved,
        ),
        Claim::own_statement(TEXT.said("same-gas"), told.join(", "), all().all(is_near)),
    ]
}

fn soft_claims(points: &[Point]) -> Vec<Claim> {
    let stiffness = |point: &Point| match point.method {
        Method::Soft { stiffness, .. } => stiffness,
        _ => f64::NAN,
    };
    let logs: Vec<(f64, f64)> = of(points, 0, SOFT)
        .map(|point| (stiffness(point).ln(), point.found.updates.ln()))
        .collect();
    let (_, exponent) = straight_line(&logs);
    let hardest = of(points, 0, SOFT).last();
    let (k, depth) = hardest.map_or((f64::NAN, f64::NAN), |point| {
        (stiffness(point), point.found.errors[1])
    });
    let creep = of(points, 3, SOFT).map(|point| point.found.errors[0]);
    let creep = creep.fold(0.0, f64::max);
    let late: Vec<String> = of(points, 2, SOFT)
        .map(|point| {
            format!(
                "{:.1e} at k = {:e}",
                point.found.errors[0],
                stiffness(point)
            )
        })
        .collect();
    let rolls = |point: &Point| point.found.errors[0] < 2.0 / stiffness(point);
    vec![
        Claim::trend(
            TEXT.said("stiff"),
            format!("updates grow as k^{exponent:.2}"),
            (0.4..0.6).contains(&exponent),
        ),
        Claim::trend(
            TEXT.said("overlap").with("k", format!("{k:e}")),
            format!("{depth:.3e} R"),
            (depth * k - 1.0).abs() < 0.01,
        ),
        Claim::own_statement(
            TEXT.said("sticking"),
            format!("{creep:.1e} at most"),
            creep < STILL,
        ),
        Claim::own_statement(
            TEXT.said("ball"),
            late.join(", "),
            of(points, 2, SOFT).all(rolls),
        ),
    ]
}

fn rigid_claims(points: &[Point], extent: &Extent) -> Vec<Claim> {
    let tolerance = |point: &Point| match point.method {
        Method::ContactDynamics { tolerance, .. } => tolerance,
        _ => f64::NAN,
    };
    let told: Vec<String> = of(points, 0, RIGID)
        .map(|point| format!("{:.1e} at {:e}", point.found.errors[0], tolerance(point)))
        .collect();
    let errors: Vec<f64> = of(points, 0, RIGID)
        .map(|point| point.found.errors[0])
        .collect();
    let is_met = errors.last().is_some_and(|error| *error < 1e-3)
        && errors.windows(2).all(|pair| pair[1] <= pair[0]);
    let least = |kind| {
        let errors = of(points, 1, kind).map(|point| point.found.errors[0]);
        errors.fold(f64::INFINITY, f64::min)
    };
    let ratio = least(SOFT) / least(RIGID);
    vec![
        Claim::trend(
            TEXT.said("static").with("step", STEP),
            told.join(", "),
            is_met,
        ),
        Claim::own_statement(
            TEXT.said("heavy")
                .with("heavy", format!("{:e}", extent.heavy)),
            format!("{:.1e} and {:.1e}", least(SOFT), least(RIGID)),
            ratio > 10.0,
        ),
    ]
}
