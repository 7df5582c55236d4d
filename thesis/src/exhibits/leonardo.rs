//! Section 2.1 as runs: blocks of any patch and load on an incline.

use crate::exhibit::{Exhibit, linear};
use crate::text::Text;
use anyhow::{Result, anyhow};
use tribos::friction::Patch;
use tribos::scene::InclineScene;
use tribos_core::Real;
use tribos_report::claim::Claim;
use tribos_report::digits::{brief, short};
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

const TEXT: Text = Text(include_str!("section-2.1.md"));

/// Patches of different breadths and lengths: edges and lengths in m; round ones by their radius.
const PATCHES: [(&str, f64); 7] = [
    ("disk", 0.05),
    ("disk", 0.001),
    ("ring", 0.2),
    ("hertz", 0.01),
    ("box:0.3x0.01", 0.05),
    ("box:0.1x0.1", 0.05),
    ("bar:0.2", 0.05),
];
/// Masses, kg: each twice the one before.
const MASSES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];
/// Rate at which the incline is raised, rad/s, and the coefficients of the first runs: ours.
const RATE: f64 = 0.05;
const MU_STATIC: f64 = 0.5;
const MU_DYNAMIC: f64 = 0.3;
const GRAVITY: f64 = 9.81;
/// Rounding of a slope.
const ROUNDING: f64 = 1e-13;

fn block(patch: (&str, f64), mass: f64, mu_static: f64) -> Result<InclineScene> {
    Ok(InclineScene {
        patch: patch.0.parse::<Patch>()?,
        radius: patch.1,
        mass,
        gravity: GRAVITY,
        mu_static,
        mu_dynamic: MU_DYNAMIC.min(mu_static),
        tilt_rate: RATE,
        end_angle: 1.5,
        duration: 30.0,
        samples: 60,
        ..InclineScene::default()
    })
}

/// Time and angle at which the block lets go.
fn release(scene: &InclineScene) -> Result<(f64, f64)> {
    let outcome = scene.run()?.outcome;
    let released = outcome.release_time.zip(outcome.release_angle);
    released.ok_or_else(|| anyhow!("the block holds"))
}

/// Slopes of release, and forces along the incline over loads on it.
pub fn section_2_1() -> Result<Exhibit> {
    let mut rows = Vec::new();
    for (index, patch) in PATCHES.into_iter().enumerate() {
        for mass in MASSES {
            for mu in linear(0.1, 1.1, 5) {
                let angle = release(&block(patch, mass, mu)?)?.1;
                let weight = mass * GRAVITY;
                let (drive, load) = (weight * angle.sin(), weight * angle.cos());
                rows.push(vec![
                    index as f64,
                    mass,
                    mu,
                    angle,
                    angle.tan(),
                    load,
                    drive,
                ]);
            }
        }
    }
    let slopes: Vec<_> = rows.iter().map(|row| (row[2], row[4])).collect();
    let angles = Figure::new(
        "Slope of release",
        Axis::linear("μ_s"),
        Axis::linear("tan α"),
    )
    .series(Series::points("all patches and loads", slopes))
    .series(Series::line("tan α = μ_s", vec![(0.1, 0.1), (1.1, 1.1)]))
    .legend(Legend::Below);
    let mut forces = Figure::new(
        "Force and load",
        Axis::linear("load on the incline [N]"),
        Axis::linear("force along it [N]"),
    )
    .legend(Legend::Below);
    for mu in [0.3, 0.5, 0.9] {
        let chosen = rows.iter().filter(|row| (row[2] - mu).abs() < 1e-9);
        let points = chosen.map(|row| (row[5], row[6])).collect();
        forces = forces.series(Series::points(format!("μ_s = {mu}"), points));
    }
    let claims = claims(&rows)?;
    let least = MASSES.first().map_or(f64::NAN, |mass| mass * GRAVITY);
    let most = MASSES.last().map_or(f64::NAN, |mass| mass * GRAVITY);
    Ok(Exhibit::new(
        TEXT.prose()
            .with("rate", RATE)
            .with("patches", PATCHES.len())
            .with("light", short(least))
            .with("heavy", short(most)),
        Panels::new("", 2)
            .figure(angles)
            .figure(forces)
            .cell(520, 380),
        &[
            "patch",
            "mass",
            "mu_static",
            "angle",
            "slope",
            "load",
            "force",
        ],
        rows,
        claims,
    ))
}

fn claims(rows: &[Vec<f64>]) -> Result<Vec<Claim>> {
    let deviation = rows
        .iter()
        .map(|row| (row[4] / row[2] - 1.0).abs())
        .fold(0.0, f64::max);
    let quarter = release(&block(PATCHES[0], 1.0, 0.25)?)?.1.tan();
    Ok(vec![
        breadth(rows),
        double_weight(rows),
        Claim::formula(TEXT.said("euler"), deviation, ROUNDING),
        Claim::definition(
            TEXT.said("quarter"),
            short(quarter),
            (quarter - 0.25).abs() <= ROUNDING,
        )
        .printed("1/4"),
        larger_velocity()?,
        holds_exactly()?,
        ageing()?,
    ])
}

/// Forces at one load and coefficient, over all patches.
fn breadth(rows: &[Vec<f64>]) -> Claim {
    let per_patch = rows.len() / PATCHES.len();
    let (first, rest) = rows.split_at(per_patch);
    let differs = rest
        .chunks(per_patch)
        .flat_map(|chunk| chunk.iter().zip(first))
        .map(|(other, first)| (other[6] / first[6] - 1.0).abs())
        .fold(0.0, f64::max);
    Claim::definition(
        TEXT.said("breadth"),
        format!(
            "forces of {} patches differ by {} at most",
            PATCHES.len(),
            brief(differs)
        ),
        differs <= ROUNDING,
    )
}

/// Each mass is twice the one before.
fn double_weight(rows: &[Vec<f64>]) -> Claim {
    let coefficients = rows.len() / PATCHES.len() / MASSES.len();
    let differs = rows
        .chunks(coefficients * MASSES.len())
        .flat_map(|patch| patch.iter().zip(&patch[coefficients..]))
        .map(|(light, heavy)| (heavy[6] / light[6] - 2.0).abs())
        .fold(0.0, f64::max);
    Claim::definition(
        TEXT.said("double-weight"),
        format!("2, off by {} at most", brief(differs)),
        differs <= ROUNDING,
    )
}

fn larger_velocity() -> Result<Claim> {
    // Speed 0.1 s after the release.
    let speed = |mu_dynamic: f64| -> Result<f64> {
        let scene = InclineScene {
            mu_dynamic,
            ..block(PATCHES[0], 1.0, MU_STATIC)?
        };
        let duration = release(&scene)?.0 + 0.1;
        Ok(InclineScene { duration, ..scene }.run()?.outcome.speed)
    };
    let (two, one) = (speed(MU_DYNAMIC)?, speed(MU_STATIC)?);
    Ok(Claim::trend(
        TEXT.said("larger-velocity"),
        format!(
            "{} m/s with two coefficients, {} m/s with one",
            short(two),
            short(one)
        ),
        two > 10.0 * one,
    ))
}

fn holds_exactly() -> Result<Claim> {
    let scene = InclineScene {
        start_angle: Real::atan(MU_STATIC) - 1e-9,
        tilt_rate: 0.0,
        duration: 1e9,
        ..block(PATCHES[0], 1.0, MU_STATIC)?
    };
    let result = scene.run()?;
    let is_still = result.rows.iter().all(|row| row[2] == 0.0 && row[3] == 0.0);
    Ok(Claim::own_statement(
        TEXT.said("holds-exactly"),
        "1e9 s at 1e-9 rad below the angle",
        is_still && result.outcome.release_time.is_none(),
    ))
}

/// The slope of release with contacts that age, raised more and more slowly.
fn ageing() -> Result<Claim> {
    const GROWTH: f64 = 0.02;
    let slope = |rate: f64| -> Result<f64> {
        let scene = InclineScene {
            ageing_rate: GROWTH,
            tilt_rate: rate,
            duration: 2.0 / rate,
            ..block(PATCHES[0], 1.0, MU_STATIC)?
        };
        Ok(release(&scene)?.1.tan())
    };
    let [quick, slow, slowest] = [1e-2, 1e-4, 1e-6].map(slope);
    let [quick, slow, slowest] = [quick?, slow?, slowest?];
    // Two decades of the time each, 2 B ln 10 = 0.092, and a little for the larger angle.
    let rises = [slow - quick, slowest - slow];
    let expected = 2.0 * GROWTH * 10f64.ln();
    let holds = rises.iter().all(|rise| (rise / expected - 1.0).abs() < 0.1);
    Ok(Claim::trend(
        TEXT.said("ageing"),
        format!(
            "slope {} at 1e-2 rad/s, {} at 1e-4, {} at 1e-6",
            short(quick),
            short(slow),
            short(slowest)
        ),
        holds,
    ))
}
