//! Section 3.1's inverse sliding problem: the launch that brings a body to rest at a given pose.

use crate::exhibit::{Exhibit, linear};
use crate::reference_integration::{Points, to_rest};
use crate::text::Text;
use anyhow::{Context, Result};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::num::NonZeroU32;
use tribos::slide::inverse::{
    Launch, LaunchLimits, LaunchSolution, MotionError, Pose, RestMap, Turns,
};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::modes::{TerminalMode, TerminalMotion};
use tribos_core::patch::PowerPressure;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Color, Figure, Legend, Series};

const TEXT: Text = Text(include_str!("section-3.1-inverse.md"));

type Map = RestMap<RoundTable64>;

/// Distances in R and angles in rad that the map shows and that every body is sent to.
const DISTANCES: [f64; 5] = [0.5, 1.0, 2.0, 4.0, 8.0];
const ANGLES: [f64; 5] = [FRAC_PI_2, PI, TAU, 2.0 * TAU, 4.0 * TAU];
/// Limits that every pose of the map keeps, √(μgR) and √(μg/R).
const WIDE: f64 = 30.0;
/// Rest poses of the launches found, relative, as the library promises.
const ROUND_TRIP: f64 = 1e-12;
/// Relative error of the integration over points.
const DIRECT: f64 = 2e-3;

/// A body with γg = R = 1.
fn map(alpha: f64, pressure: PowerPressure, inertia: f64) -> Result<Map> {
    Ok(RestMap::new(
        RoundTable64::new(alpha, pressure)?,
        1.0,
        1.0,
        inertia,
    )?)
}

/// Names, exponents and bodies: C is that of even thickness.
fn bodies() -> Result<Vec<(f64, Map)>> {
    let mut bodies = Vec::new();
    for alpha in [0.0, 0.5, -0.5] {
        for pressure in [PowerPressure::UNIFORM, PowerPressure::RING] {
            bodies.push((alpha, map(alpha, pressure, pressure.mean_square_radius())?));
        }
    }
    Ok(bodies)
}

/// The launches to a place straight ahead after this total angle.
fn launches(map: &Map, distance: f64, angle: f64) -> Result<Vec<LaunchSolution>> {
    let target = Pose {
        x: distance,
        y: 0.0,
        angle,
    };
    Ok(map.launches(&target, Turns::Exact, &LaunchLimits::new(WIDE, WIDE)?)?)
}

/// The plane of launches with its curves of equal distance and of equal angle.
pub fn section_3_1_inverse() -> Result<Exhibit> {
    let disk = map(0.0, PowerPressure::UNIFORM, 0.5)?;
    let mut rows = Vec::new();
    let mut figure = Figure::new(
        "Where a disk must be launched: full, equal distance; dashed, equal angle",
        Axis::linear("speed v₀ [√(μgR)]").range(0.0, 4.5),
        Axis::linear("spin ω₀ [√(μg/R)]").range(0.0, 7.0),
    )
    .size(900, 560)
    .legend(Legend::Below);
    for (i, distance) in DISTANCES.into_iter().enumerate() {
        let curve = curve(&disk, &mut rows, squares(6.0), |angle| [distance, angle])?;
        let label = format!("distance {distance} R");
        figure = figure.series(Series::line(label, curve).color(Color::palette(i)));
    }
    for (i, angle) in ANGLES.into_iter().enumerate() {
        let curve = curve(&disk, &mut rows, squares(3.5), |distance| [distance, angle])?;
        let label = format!("turns: {}", angle / TAU);
        figure = figure.series(Series::dashed(label, curve).color(Color::palette(i)));
    }
    let claims = [found()?, behaviour(&disk)?].concat();
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &[
            "distance",
            "angle",
            "speed",
            "spin",
            "time",
            "energy_per_mass",
        ],
        rows,
        claims,
    ))
}

/// Up to the square of `most`, closer together at the beginning, where curves bend.
fn squares(most: f64) -> Vec<f64> {
    let roots = linear(0.0, most, 72).into_iter();
    roots.map(|root| root * root).collect()
}

/// The launches along a curve of poses.
fn curve(
    map: &Map,
    rows: &mut Vec<Vec<f64>>,
    along: Vec<f64>,
    pose: impl Fn(f64) -> [f64; 2],
) -> Result<Vec<(f64, f64)>> {
    let mut points = Vec::new();
    for at in along {
        let [distance, angle] = pose(at);
        let found = launches(map, distance, angle)?;
        let one = found.first().context("every pose has a launch")?;
        let spin = one.launch.spin;
        points.push((one.speed, spin));
        rows.push(vec![
            distance,
            angle,
            one.speed,
            spin,
            one.time,
            one.energy_per_mass,
        ]);
    }
    Ok(points)
}

/// Launches exist, are unique, and end where they should.
fn found() -> Result<Vec<Claim>> {
    let (mut poses, mut single, mut worst) = (0, 0, 0.0_f64);
    let (mut crossings, mut between) = (0, 0);
    for (alpha, map) in bodies()? {
        let end = TerminalMotion::new(*map.profile(), map.inertia_ratio())?.terminal_mode(1.0);
        let TerminalMode::Together { ratio: end } = end else {
            anyhow::bail!("a body of even thickness with α = {alpha} has a common stop");
        };
        let ratios = rest_ratios(&map);
        for distance in DISTANCES {
            for angle in ANGLES.into_iter().chain(ANGLES.map(|angle| -angle)) {
                poses += 1;
                let found = launches(&map, distance, angle)?;
                single += usize::from(found.len() == 1);
                let one = found.first().context("every pose has a launch")?;
                let rest = map.rest(&one.launch).pose;
                worst = worst.max((rest.x / distance - 1.0).abs());
                worst = worst.max((rest.angle / angle - 1.0).abs());
                let pose = distance / angle.abs();
                let passes = |w: &&[f64]| (w[0] > pose) != (w[1] > pose);
                crossings += ratios.windows(2).filter(passes).count();
                let launch = one.speed / one.launch.spin.abs();
                between += usize::from((launch - pose) * (pose - end) >= 0.0);
            }
        }
    }
    Ok(vec![
        Claim::own_statement(
            TEXT.said("round-trip"),
            format!("{poses} poses, relative error below 1e-12"),
            worst < ROUND_TRIP,
        ),
        Claim::own_statement(
            TEXT.said("unique"),
            format!("{single} of {poses} poses have one launch"),
            single == poses && crossings == poses,
        ),
        Claim::own_statement(
            TEXT.said("between"),
            format!("{between} of {poses} poses"),
            between == poses,
        ),
        directly()?,
    ])
}

/// d/(R|θ|) at rest over the direction of the launch, from almost pure spin to almost pure slide.
fn rest_ratios(map: &Map) -> Vec<f64> {
    let directions = linear(1e-3, FRAC_PI_2 - 1e-3, 1000);
    let rest = |direction: f64| {
        let velocity = [direction.sin(), 0.0];
        let spin = direction.cos();
        let pose = map.rest(&Launch { velocity, spin }).pose;
        pose.x / pose.angle
    };
    directions.into_iter().map(rest).collect()
}

/// Launches found, carried out by points.
fn directly() -> Result<Claim> {
    let mut worst = 0.0_f64;
    for (pressure, points) in [
        (PowerPressure::RING, Points::ring(720)),
        (PowerPressure::UNIFORM, Points::disk(32, 32)),
    ] {
        let inertia = pressure.mean_square_radius();
        let map = map(0.0, pressure, inertia)?;
        for (distance, angle) in [(1.0, TAU), (4.0, FRAC_PI_2), (2.0, -PI)] {
            let found = launches(&map, distance, angle)?;
            let one = found.first().context("every pose has a launch")?;
            let launch = [one.speed, 0.0, one.launch.spin];
            let friction = |v| points.friction(v, 0.0, [0.0; 2]);
            let stop = to_rest(friction, 0.0, inertia, launch);
            for (ours, wanted) in [
                (stop.place[0], distance),
                (stop.angle, angle),
                (stop.time, one.time),
            ] {
                worst = worst.max((ours / wanted - 1.0).abs());
            }
        }
    }
    Ok(Claim::own_statement(
        TEXT.said("direct"),
        format!("relative deviation {worst:.0e} at most, 6 launches"),
        worst < DIRECT,
    ))
}

/// Orientation instead of turns, and laws under which nothing rests.
fn behaviour(disk: &Map) -> Result<Vec<Claim>> {
    let limits = LaunchLimits::new(4.0, 8.0)?;
    let target = Pose {
        x: 4.0,
        y: 0.0,
        angle: FRAC_PI_2,
    };
    let symmetry = NonZeroU32::MIN;
    let all = disk.launches(&target, Turns::Modulo { symmetry }, &limits)?;
    let mut one_by_one = 0;
    for turn in -50..=50 {
        let angle = target.angle + TAU * f64::from(turn);
        let exact = disk.launches(&Pose { angle, ..target }, Turns::Exact, &limits);
        one_by_one += exact.map_or(0, |found| found.len());
    }
    let never = RestMap::new(
        RoundTable64::new(1.0, PowerPressure::UNIFORM)?,
        1.0,
        1.0,
        0.5,
    );
    Ok(vec![
        Claim::own_statement(
            TEXT.said("orientation"),
            format!("{} launches", all.len()),
            all.len() == one_by_one && all.len() > 2,
        ),
        Claim::trend(
            TEXT.said("never"),
            "refused for α = 1",
            matches!(never, Err(MotionError::NeverRests { .. })),
        ),
        Claim::not_checkable(TEXT.said("robots")),
    ])
}
