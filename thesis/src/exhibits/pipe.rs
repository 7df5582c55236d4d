//! Figure 3.17: pipes that slide and spin on their end.

use crate::exhibit::{Exhibit, linear};
use crate::text::Text;
use anyhow::Result;
use tribos::slide::planar::{Launch, Pipe, PlanarResult, PlanarSimulation};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Series};

const TEXT: Text = Text(include_str!("figure-3.17.md"));

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

fn pipe(height: f64, inner_ratio: f64) -> Pipe {
    Pipe {
        coefficient: MU,
        alpha: 0.0,
        radius: RADIUS,
        inner_ratio,
        height,
        gradient: tribos::slide::planar::Gradient::AllRound,
    }
}

/// The path to rest, seen at `times`; it starts along x, as in the scenes.
fn journey(
    pipe: &Pipe,
    (speed, spin): (f64, f64),
    times: &[f64],
) -> Result<(PlanarResult, Vec<[f64; 3]>)> {
    let body = pipe.body(GRAVITY)?;
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    let mut seen = Vec::new();
    let arrival = PlanarSimulation::new(&body, &launch, 1e-9)?.follow(times, |point| {
        seen.push([point.time, point.position[0], point.position[1]]);
    })?;
    Ok((arrival, seen))
}

/// Where a pipe comes to rest.
fn at_rest(pipe: &Pipe, launch: (f64, f64)) -> Result<[f64; 2]> {
    Ok(journey(pipe, launch, &[])?.0.point.position)
}

/// The same of our pipe with this height.
fn rest(height: f64, launch: (f64, f64)) -> Result<[f64; 2]> {
    at_rest(&pipe(height, INNER_RATIO), launch)
}

/// A path at equal steps of time.
fn path(launch: (f64, f64)) -> Result<Vec<[f64; 3]>> {
    let ours = pipe(HEIGHT, INNER_RATIO);
    let end = journey(&ours, launch, &[])?.0.point.time;
    Ok(journey(&ours, launch, &linear(0.0, end, SHOWN))?.1)
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
    Ok(Exhibit::new(
        TEXT.prose()
            .with("mu", MU)
            .with("radius", RADIUS)
            .with("wall", format!("{:.0}", 1e3 * RADIUS * (1.0 - INNER_RATIO)))
            .with("height", HEIGHT),
        figure.size(900, 460),
        &["pipe", "time", "x", "y"],
        rows,
        claims,
    ))
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
    let row = |id, shown: String, holds| Claim::trend(TEXT.said(id), shown, holds);
    Ok(vec![
        row(
            "drift",
            format!("{:.4} m and {:.4} m to the right", -ends[0][1], -ends[1][1]),
            ends.iter().all(|end| end[1] < 0.0),
        ),
        row(
            "curved",
            format!("at {} points of each", SHOWN + 1),
            paths.iter().all(bends_right),
        ),
        row(
            "clockwise",
            format!("{:.4} m to the left, launch (a) mirrored", mirrored[1]),
            (mirrored[1] + ends[0][1]).abs() < 1e-12 && (mirrored[0] - ends[0][0]).abs() < 1e-12,
        ),
        row(
            "straight",
            format!("{} m to the side", straight[1].abs()),
            straight[1] == 0.0,
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
            TEXT.said("by-spin"),
            format!("{} m", shown(&by_spin)),
            rises(&by_spin),
        ),
        Claim::trend(
            TEXT.said("by-height"),
            format!("{} m", shown(&by_height)),
            rises(&by_height) && by_height[0] == 0.0,
        ),
        fast_spin()?,
    ])
}

/// Shegelski et al.: ε ≪ 1.
///
/// A thin pipe on a ring slows down by d(ωR)/dt = −μg/C, and to the first order in ε its friction per
/// μN is q = −(ε/2) e_v + b e_z × q with b = μH/(2R), where the second term is the lean's. In the
/// complex plane d ln v/d ln ω = κ = (C/2)(1 + ib)/(1 + b²), so that v ∝ ω^κ and the whole way is in
/// proportion to 1/(1 + κ): the deflection is (C/2) b/(1 + b² + C/2) of the way forward.
fn fast_spin() -> Result<Claim> {
    /// Speed in m/s, spins in rad/s, heights in m: b = 0.3 and 0.7.
    const SPEED: f64 = 0.5;
    const SPINS: [f64; 2] = [300.0, 3000.0];
    const HEIGHTS: [f64; 2] = [0.15, 0.35];
    /// What ε of a few hundredths leaves of the formula.
    const FIRST_ORDER: f64 = 0.02;
    const THIN: f64 = 1.0;
    let (mut off, mut shown) = (0.0_f64, Vec::new());
    for height in HEIGHTS {
        let lean = MU * height / (2.0 * RADIUS);
        let formula = 0.5 * lean / (1.0 + lean * lean + 0.5);
        for spin in SPINS {
            let [forward, left] = at_rest(&pipe(height, THIN), (SPEED, spin))?;
            off = off.max((-left / forward / formula - 1.0).abs());
            shown.push(format!("{:.3}", -left / forward));
        }
    }
    // The largest over b, at b² = 1 + C/2 with C = 1.
    let most = 0.25 / f64::sqrt(1.5);
    Ok(Claim::contradiction(
        TEXT.said("spiral").with("most", format!("{most:.3}")),
        format!(
            "{} of the way; the formula within {off:.1e}",
            shown.join(", ")
        ),
        off < FIRST_ORDER,
    ))
}

/// Measurements, and theory with dimensions that are not given.
fn unchecked() -> Vec<Claim> {
    vec![Claim::not_checkable(TEXT.said("measured-paths"))]
}
