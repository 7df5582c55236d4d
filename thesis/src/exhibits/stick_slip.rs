//! Section 2.3.1 as runs: a body on a spring under rate and state, over stiffness and speed of the pull.

use super::creep::PAPER;
use crate::exhibit::{Exhibit, geometric};
use crate::text::Text;
use anyhow::{Result, anyhow};
use std::f64::consts::PI;
use tribos::scene::{SpringFriction, SpringScene};
use tribos::stick::spring::{SpringSummary, StickSlipRegime, critical_stiffness};
use tribos_core::law::RateStateParameters;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

const TEXT: Text = Text(include_str!("section-2.3.md"));

/// Speeds of the pull, m/s, and stiffnesses per load, 1/m, of the phase diagram.
const SPEEDS: (f64, f64, usize) = (1e-7, 1e-2, 10);
const STIFFNESSES: (f64, f64, usize) = (2e3, 5e4, 7);
/// Errors of a step that no picture shows.
const TOLERANCE: f64 = 1e-6;

/// A run long enough for oscillations to grow or fade, in memory lengths, and for slips of a soft spring.
fn scene(stiffness: f64, speed: f64) -> SpringScene {
    // The viscous force comes over a way of its size over the stiffness.
    let viscous = PAPER.viscous * speed / stiffness;
    let lengths = 150.0 * PAPER.slip_distance + 1.5 / stiffness + 20.0 * viscous;
    SpringScene {
        friction_law: SpringFriction::RateState,
        mass: 0.0,
        load: 1.0,
        stiffness,
        pull_speed: speed,
        pull_time: lengths / speed,
        mu_reference: PAPER.mu,
        a: PAPER.a,
        b: PAPER.b,
        reference_speed: PAPER.reference_speed,
        slip_distance: PAPER.slip_distance,
        radiation_damping: PAPER.viscous,
        tolerance: TOLERANCE,
        samples: 40,
        ..SpringScene::default()
    }
}

fn outcome(stiffness: f64, speed: f64) -> Result<SpringSummary> {
    Ok(scene(stiffness, speed).run()?.outcome)
}

/// One run of the phase diagram.
struct Cell {
    stiffness: f64,
    speed: f64,
    outcome: SpringSummary,
}

/// Phase diagram and friction over the speed.
pub fn section_2_3() -> Result<Exhibit> {
    let cells = cells()?;
    let borders = borders()?;
    let rows = cells
        .iter()
        .map(|cell| {
            let end = &cell.outcome;
            let swings = if swings(end.regime) { 1.0 } else { 0.0 };
            let forces = [end.mean_force, end.least_force, end.most_force];
            let mut row = vec![cell.speed, cell.stiffness, swings];
            row.extend(forces);
            row
        })
        .collect();
    let claims = claims(&cells, &borders)?;
    Ok(Exhibit::new(
        TEXT.prose()
            .with("mu", PAPER.mu)
            .with("a", PAPER.a)
            .with("b", PAPER.b)
            .with("speed", format!("{:e}", PAPER.reference_speed))
            .with("length", format!("{:e}", PAPER.slip_distance))
            .with("viscous", PAPER.viscous),
        Panels::new("", 2)
            .figure(diagram(&cells, &borders))
            .figure(friction(&cells))
            .cell(560, 420),
        &["speed", "stiffness", "swings", "mean", "least", "most"],
        rows,
        claims,
    ))
}

/// Whether the force swings for good.
fn swings(regime: StickSlipRegime) -> bool {
    matches!(
        regime,
        StickSlipRegime::StickSlip | StickSlipRegime::Oscillates
    )
}

fn cells() -> Result<Vec<Cell>> {
    let mut cells = Vec::new();
    for speed in geometric(SPEEDS.0, SPEEDS.1, SPEEDS.2) {
        for stiffness in geometric(STIFFNESSES.0, STIFFNESSES.1, STIFFNESSES.2) {
            let outcome = outcome(stiffness, speed)?;
            cells.push(Cell {
                stiffness,
                speed,
                outcome,
            });
        }
    }
    Ok(cells)
}

fn criterion(law: &RateStateParameters<f64>, speed: f64) -> f64 {
    critical_stiffness(law, 1.0, 0.0, speed)
}

/// Speeds with the stiffness at which a small disturbance neither grows nor fades.
fn borders() -> Result<Vec<(f64, f64)>> {
    let speeds = [1e-7, 1e-6, 1e-5, 1e-4, 5e-4];
    speeds
        .into_iter()
        .map(|speed| Ok((speed, border(speed)?)))
        .collect()
}

fn border(speed: f64) -> Result<f64> {
    let expected = criterion(&PAPER, speed);
    let (mut low, mut high) = (0.8 * expected, 1.25 * expected);
    while high / low > 1.002 {
        let middle = 0.5 * (low + high);
        let disturbed = SpringScene {
            start_speed: Some(0.999 * speed),
            pull_time: 160.0 * PAPER.slip_distance / speed,
            tolerance: 1e-9,
            ..scene(middle, speed)
        };
        if disturbed.run()?.outcome.swing_ratio > 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

fn diagram(cells: &[Cell], borders: &[(f64, f64)]) -> Figure {
    let of = |wanted: &dyn Fn(StickSlipRegime) -> bool| -> Vec<(f64, f64)> {
        let chosen = cells.iter().filter(|cell| wanted(cell.outcome.regime));
        chosen.map(|cell| (cell.speed, cell.stiffness)).collect()
    };
    let line = geometric(SPEEDS.0, 0.95e-3, 200)
        .into_iter()
        .map(|speed| (speed, criterion(&PAPER, speed)))
        .filter(|(_, stiffness)| *stiffness > STIFFNESSES.0)
        .collect();
    Figure::new(
        "Regimes",
        Axis::log10("speed of the pull [m/s]"),
        Axis::log10("stiffness per load [1/m]"),
    )
    .series(Series::points("stick–slip", of(&swings)))
    .series(Series::points(
        "creep",
        of(&|regime| regime == StickSlipRegime::Creeps),
    ))
    .series(Series::points(
        "inertial",
        of(&|regime| regime == StickSlipRegime::Steady),
    ))
    .series(Series::line("k_c", line))
    .series(Series::points("k_c by bisection", borders.to_vec()))
    .legend(Legend::Below)
}

fn friction(cells: &[Cell]) -> Figure {
    let along = |stiffest: bool, value: fn(&SpringSummary) -> f64| -> Vec<(f64, f64)> {
        let per_speed = STIFFNESSES.2 + 1;
        let columns = cells.chunks(per_speed);
        let chosen = columns.filter_map(|column| {
            if stiffest {
                column.last()
            } else {
                column.first()
            }
        });
        chosen
            .map(|cell| (cell.speed, value(&cell.outcome)))
            .collect()
    };
    Figure::new(
        "Friction",
        Axis::log10("speed of the pull [m/s]"),
        Axis::linear("spring force per load"),
    )
    .series(Series::line_points(
        "steady, mean",
        along(true, |end| end.mean_force),
    ))
    .series(Series::points(
        "soft, least",
        along(false, |end| end.least_force),
    ))
    .series(Series::points(
        "soft, largest",
        along(false, |end| end.most_force),
    ))
    .legend(Legend::Below)
}

fn claims(cells: &[Cell], borders: &[(f64, f64)]) -> Result<Vec<Claim>> {
    let deviation = borders
        .iter()
        .map(|(speed, found)| (found / criterion(&PAPER, *speed) - 1.0).abs())
        .fold(0.0, f64::max);
    // Cells next to the border take longer than these runs to decide.
    let decided = |cell: &&Cell| {
        let share = cell.stiffness / criterion(&PAPER, cell.speed);
        !(0.9..1.1).contains(&share)
    };
    let ordered = cells.iter().filter(decided).all(|cell| {
        let critical = criterion(&PAPER, cell.speed);
        swings(cell.outcome.regime) == (cell.stiffness < critical)
    });
    let counts = |wanted: &dyn Fn(StickSlipRegime) -> bool| {
        cells
            .iter()
            .filter(|cell| wanted(cell.outcome.regime))
            .count()
    };
    Ok(vec![
        Claim::own_statement(
            TEXT.said("bifurcation"),
            format!("{:.2} % at {} speeds", 100.0 * deviation, borders.len()),
            deviation < 0.01,
        ),
        Claim::trend(
            TEXT.said("regimes"),
            format!(
                "of {} runs {} stick and slip, {} creep, {} slide inertially; the border is k_c",
                cells.len(),
                counts(&swings),
                counts(&|regime| regime == StickSlipRegime::Creeps),
                counts(&|regime| regime == StickSlipRegime::Steady)
            ),
            ordered,
        ),
        creep_slope()?,
        inertial_slope()?,
        oscillation()?,
        amplitude()?,
        healing()?,
        Claim::not_checkable(TEXT.said("hysteresis")),
    ])
}

/// Mean friction under a spring that is always stiff enough.
fn steady(speed: f64) -> Result<f64> {
    Ok(outcome(STIFFNESSES.1, speed)?.mean_force)
}

fn creep_slope() -> Result<Claim> {
    let rise = (steady(1e-6)? - steady(1e-7)?) / 10f64.ln();
    let expected = PAPER.a - PAPER.b;
    Ok(Claim::trend(
        TEXT.said("creep"),
        format!(
            "slope {} for each e-fold, −(b − a) = {}",
            short(rise),
            short(expected)
        ),
        (rise / expected - 1.0).abs() < 0.01,
    ))
}

fn inertial_slope() -> Result<Claim> {
    let rise = (steady(1e-1)? - steady(5e-2)?) / 5e-2;
    Ok(Claim::trend(
        TEXT.said("inertial"),
        format!(
            "slope {} s/m between 0.05 and 0.1 m/s, of {}",
            short(rise),
            PAPER.viscous
        ),
        (rise / PAPER.viscous - 1.0).abs() < 0.02,
    ))
}

fn oscillation() -> Result<Claim> {
    let speed = 1e-6;
    let dry = RateStateParameters {
        viscous: 0.0,
        ..PAPER
    };
    let swinging = SpringScene {
        radiation_damping: 0.0,
        start_speed: Some(0.999 * speed),
        pull_time: 160.0 * PAPER.slip_distance / speed,
        tolerance: 1e-9,
        ..scene(criterion(&dry, speed), speed)
    };
    let found = swinging.run()?.outcome.period;
    let found = found.ok_or_else(|| anyhow!("nothing oscillates"))?;
    let expected = 2.0 * PI * PAPER.slip_distance / speed * (PAPER.a / (PAPER.b - PAPER.a)).sqrt();
    Ok(Claim::own(
        TEXT.said("oscillation"),
        found,
        expected,
        1e-3 * expected,
    ))
}

fn amplitude() -> Result<Claim> {
    let speed = 1e-6;
    let swing = |share: f64| -> Result<f64> {
        let end = outcome(share * criterion(&PAPER, speed), speed)?;
        Ok(end.most_force - end.least_force)
    };
    let all = [0.8, 0.5, 0.3, 0.1].map(swing);
    let all = all.into_iter().collect::<Result<Vec<_>>>()?;
    let told: Vec<String> = all.iter().map(|swing| format!("{swing:.4}")).collect();
    Ok(Claim::own_statement(
        TEXT.said("amplitude"),
        format!("{} per load", told.join(", ")),
        all.windows(2).all(|pair| pair[0] < pair[1]),
    ))
}

fn healing() -> Result<Claim> {
    let held = SpringScene {
        stiffness: 1e6,
        pull_speed: 1e-5,
        pull_time: 10.0,
        hold_time: Some(100.0),
        hold_count: 4,
        radiation_damping: 0.0,
        ..scene(1e6, 1e-5)
    };
    let found = held.run()?.outcome.healing;
    let found = found.ok_or_else(|| anyhow!("no holds"))?;
    Ok(Claim::own(
        TEXT.said("healing"),
        found,
        PAPER.b,
        0.02 * PAPER.b,
    ))
}
