//! Figure 3.17: pipes that slide and spin on their end.

use crate::exhibit::{Exhibit, linear};
use anyhow::Result;
use tribos::slide::planar::{Arrival, Journey, Launch, Pipe};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Series};

const GRAVITY: f64 = 9.81;
/// The launches of the two pipes: m/s and rad/s, counterclockwise.
const FIRST: (f64, f64) = (1.74, 10.2);
const SECOND: (f64, f64) = (2.61, 10.6);
/// Coefficient, outer radius and height in m, inner over outer radius: ours.
const MU: f64 = 0.2;
const RADIUS: f64 = 0.05;
const HEIGHT: f64 = 0.15;
const INNER_RATIO: f64 = 0.92;
/// Times shown on each path.
const SHOWN: usize = 200;

fn pipe(height: f64) -> Pipe {
    Pipe {
        coefficient: MU,
        alpha: 0.0,
        radius: RADIUS,
        inner_ratio: INNER_RATIO,
        height,
        gradient: tribos::slide::planar::Gradient::AllRound,
    }
}

/// The path to rest, seen at `times`; it starts along x, as in the scenes.
fn journey(
    height: f64,
    (speed, spin): (f64, f64),
    times: &[f64],
) -> Result<(Arrival, Vec<[f64; 3]>)> {
    let body = pipe(height).body(GRAVITY)?;
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    let mut seen = Vec::new();
    let arrival = Journey::new(&body, &launch, 1e-9)?.follow(times, |point| {
        seen.push([point.time, point.position[0], point.position[1]]);
    })?;
    Ok((arrival, seen))
}

/// Where a pipe comes to rest.
fn rest(height: f64, launch: (f64, f64)) -> Result<[f64; 2]> {
    Ok(journey(height, launch, &[])?.0.point.position)
}

/// A path at equal steps of time.
fn path(launch: (f64, f64)) -> Result<Vec<[f64; 3]>> {
    let end = journey(HEIGHT, launch, &[])?.0.point.time;
    Ok(journey(HEIGHT, launch, &linear(0.0, end, SHOWN))?.1)
}

/// The two paths in the plane.
pub fn figure_3_17() -> Result<Exhibit> {
    let paths = [path(FIRST)?, path(SECOND)?];
    let labels = ["(a)", "(b)"];
    let mut rows = Vec::new();
    let mut figure = Figure::new(
        "Two pipes, launched along x, spinning counterclockwise",
        Axis::linear("x [m], forward").range(0.0, 2.0),
        Axis::linear("y [m], to the left (stretched)").range(-0.1, 0.01),
    )
    .legend(Legend::Below);
    let launches = [FIRST, SECOND];
    for (i, (path, (speed, spin))) in paths.iter().zip(launches).enumerate() {
        let line = path.iter().map(|[_, x, y]| (*x, *y)).collect();
        let label = format!("{} {speed} m/s, {spin} rad/s", labels[i]);
        figure = figure.series(Series::line(label, line));
        rows.extend(
            path.iter()
                .map(|[time, x, y]| vec![i as f64, *time, *x, *y]),
        );
    }
    let mut claims = shape(&paths)?;
    claims.extend(trends()?);
    claims.extend(unchecked());
    Ok(Exhibit {
        heading: "Figure 3.17: paths of sliding, spinning pipes".into(),
        text: vec![format!(
            "Penner's two launches. The thesis does not give dimensions and friction of the pipes: \
             μ = {MU}, radius {RADIUS} m, wall {:.0} mm and height {HEIGHT} m are ours, so that \
             side and trend can be compared, but not the lengths. The thesis draws its launches along \
             y; here x points forward and y to the left, as in the scenes of pipes. The pressure gradients along and \
             across the path are both followed.",
            1e3 * RADIUS * (1.0 - INNER_RATIO)
        )],
        film: None,
        caption: "Paths from the origin to rest, for a pipe of our dimensions.".into(),
        drawing: Box::new(figure.size(900, 460)),
        columns: vec!["pipe", "time", "x", "y"],
        rows,
        claims,
    })
}

/// Side and bend of the two paths.
fn shape(paths: &[Vec<[f64; 3]>; 2]) -> Result<Vec<Claim>> {
    let ends = [rest(HEIGHT, FIRST)?, rest(HEIGHT, SECOND)?];
    let mirrored = rest(HEIGHT, (FIRST.0, -FIRST.1))?;
    let straight = rest(HEIGHT, (FIRST.0, 0.0))?;
    // Each piece of the path lies to the right of the one before.
    let bends_right = |path: &Vec<[f64; 3]>| {
        path.windows(3).all(|p| {
            let [[_, x0, y0], [_, x1, y1], [_, x2, y2]] = [p[0], p[1], p[2]];
            (x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1) < 1e-12
        })
    };
    let row = |what: &str, shown: String, holds: bool, of: &str| {
        Claim::trend("3.5.1", what, shown, holds, of)
    };
    Ok(vec![
        row(
            "Counterclockwise spin: both pipes drift to the right",
            format!("{:.4} m and {:.4} m to the right", -ends[0][1], -ends[1][1]),
            ends.iter().all(|end| end[1] < 0.0),
            "side",
        ),
        row(
            "The path is curved: it bends to the right all the way",
            format!("at {} points of each", SHOWN + 1),
            paths.iter().all(bends_right),
            "sign of the curvature",
        ),
        row(
            "Clockwise spin: to the left",
            format!("{:.4} m to the left, launch (a) mirrored", mirrored[1]),
            (mirrored[1] + ends[0][1]).abs() < 1e-12 && (mirrored[0] - ends[0][0]).abs() < 1e-12,
            "side",
        ),
        row(
            "Without spin no lateral force: the pipe slides straight on",
            format!("{} m to the side", straight[1].abs()),
            straight[1] == 0.0,
            "symmetry",
        ),
    ])
}

/// "the lateral deflection increases with the initial angular velocity and the height".
fn trends() -> Result<Vec<Claim>> {
    let rises = |deflections: &[f64]| deflections.windows(2).all(|w| w[1] > w[0]);
    let shown = |deflections: &[f64]| {
        let texts: Vec<String> = deflections.iter().map(|x| format!("{x:.4}")).collect();
        texts.join(", ")
    };
    let by_spin = [2.0, 5.0, 10.2, 20.0]
        .map(|spin| rest(HEIGHT, (FIRST.0, spin)))
        .into_iter()
        .map(|end| Ok(0.0 - end?[1]))
        .collect::<Result<Vec<f64>>>()?;
    let by_height = [0.0, 0.05, 0.1, 0.15]
        .map(|height| rest(height, FIRST))
        .into_iter()
        .map(|end| Ok(0.0 - end?[1]))
        .collect::<Result<Vec<f64>>>()?;
    Ok(vec![
        Claim::trend(
            "3.5.1",
            "The deflection increases with the spin; 2, 5, 10.2, 20 rad/s",
            format!("{} m", shown(&by_spin)),
            rises(&by_spin),
            "monotony",
        ),
        Claim::trend(
            "3.5.1",
            "The deflection increases with the height; 0, 5, 10, 15 cm",
            format!("{} m", shown(&by_height)),
            rises(&by_height) && by_height[0] == 0.0,
            "monotony",
        ),
        fast_spin()?,
    ])
}

/// Shegelski et al.: ε ≪ 1.
fn fast_spin() -> Result<Claim> {
    let (speed, spin) = (0.5, 300.0);
    let [forward, left] = rest(HEIGHT, (speed, spin))?;
    Ok(Claim::not_checkable(
        "3.5.1",
        "Fast spin, ε ≪ 1: the deflection can be as large as the path forward, a spiral",
        &format!(
            "dimensions and launch are not in the thesis; our pipe at {speed} m/s and {spin} rad/s \
             comes {:.2} m to the right and {forward:.2} m forward",
            -left
        ),
    ))
}

/// Measurements, and theory with dimensions that are not given.
fn unchecked() -> Vec<Claim> {
    vec![Claim::not_checkable(
        "fig. 3.17",
        "The measured positions are very well in line with the theoretical paths",
        "neither the positions nor the pipes' dimensions and friction are in the thesis",
    )]
}
