//! A first guess from the film alone: short parabolas through its first half.

use super::body::Body;
use super::film::Track;
use nalgebra::{DMatrix, DVector};

/// Where a search begins.
#[derive(Clone, Debug)]
pub(super) struct Guess {
    pub mu: f64,
    pub radius: f64,
    pub place: [f64; 2],
    pub velocity: [f64; 2],
    pub angle: f64,
    pub spin: f64,
}

/// Share of the way over which the first parabola goes.
const SHARE: f64 = 0.6;
/// Fewest frames of a parabola.
const FEWEST: usize = 5;
/// Coefficient of a track that does not slow down visibly.
const LEAST_MU: f64 = 1e-3;
/// Torque of a body that slides and spins, over μ N R: between 0 and 2/3 for a disk.
const TORQUE: f64 = 0.4;
/// The radius is sought between these ratios of speed to spin.
const RADII: [f64; 2] = [0.02, 20.0];

impl Guess {
    pub fn of(track: &Track, body: &Body) -> Self {
        let frames = first_part(track);
        let times = track.times();
        let start = times.first().copied().unwrap_or(0.0);
        let times: Vec<f64> = times.iter().take(frames).map(|t| t - start).collect();
        let along = |column: &[f64]| parabola(&times, column);
        let [x, y] = [track.x(), track.y()].map(along);
        let turn = along(track.angle().unwrap_or_default());
        let velocity = [x[1], y[1]];
        let speed = libm::hypot(x[1], y[1]);
        let slowing = -2.0 * (x[2] * x[1] + y[2] * y[1]) / speed;
        // What stops within the film has the mean deceleration v²/2s at least.
        let at = |column: &[f64]| {
            column
                .last()
                .zip(column.first())
                .map_or(0.0, |(b, a)| b - a)
        };
        let way = libm::hypot(at(track.x()), at(track.y()));
        let overall = 0.5 * speed * speed / way;
        let slowing = if slowing > 0.1 * overall {
            slowing
        } else {
            overall
        };
        let mu = (slowing / body.gravity).clamp(LEAST_MU, 1.0 / LEAST_MU);
        let spin = turn[1];
        let spin_slowing = -2.0 * turn[2] * spin.signum();
        let unit = speed / spin.abs();
        let radius = mu * body.gravity * TORQUE / (body.inertia_ratio * spin_slowing);
        let [least, most] = RADII.map(|share| share * unit);
        let radius = match (radius > 0.0, unit.is_finite() && unit > 0.0) {
            (true, true) => radius.max(least).min(most),
            (false, true) => unit,
            _ => track.extent().max(f64::MIN_POSITIVE),
        };
        Self {
            mu: if mu.is_finite() { mu } else { LEAST_MU },
            radius: if radius.is_finite() { radius } else { 1.0 },
            place: [x[0], y[0]],
            velocity,
            angle: turn[0],
            spin,
        }
    }
}

/// Number of frames until this share of the way.
fn first_part(track: &Track) -> usize {
    let (x, y) = (track.x(), track.y());
    let from = [x, y].map(|column| column.first().copied().unwrap_or(0.0));
    let away: Vec<f64> = x
        .iter()
        .zip(y)
        .map(|(x, y)| libm::hypot(x - from[0], y - from[1]))
        .collect();
    let whole = away.last().copied().unwrap_or(0.0);
    let reached = away.iter().position(|s| *s > SHARE * whole);
    reached.unwrap_or(away.len()).max(FEWEST).min(away.len())
}

/// Coefficients of the parabola through points, by least squares; zeros where there are none.
pub(super) fn parabola(times: &[f64], values: &[f64]) -> [f64; 3] {
    let count = times.len().min(values.len());
    let end = times.last().copied().unwrap_or(0.0);
    let degree = match count {
        0 => return [0.0; 3],
        1 => return [values[0], 0.0, 0.0],
        2..FEWEST => 1,
        _ => 2,
    };
    let powers = DMatrix::from_fn(count, degree + 1, |i, k| {
        let t = times[i] / end;
        [1.0, t, t * t][k]
    });
    let wanted = DVector::from_fn(count, |i, _| values[i]);
    let found = powers.svd(true, true).solve(&wanted, f64::EPSILON);
    let found = found.unwrap_or_else(|_| DVector::zeros(degree + 1));
    let at = |k: usize| found.get(k).copied().unwrap_or(0.0);
    [at(0), at(1) / end, at(2) / (end * end)]
}
