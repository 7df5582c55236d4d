//! What a glance at the data tells of a law: the branch of steady sliding first, then the stiffness after reversals.

use super::super::support::nnls::Normal;
use super::super::{Measurements, Motion};
use nalgebra::DVector;

/// Scales of the data and a first guess of a joint's parameters.
#[derive(Clone, Debug)]
pub(in super::super) struct Guess {
    /// A slow and the fastest speed: one in a hundred points is slower, but the slowest of few.
    pub speeds: [f64; 2],
    /// Smallest and largest friction.
    pub forces: [f64; 2],
    /// Shortest distance between two points, and that of the whole record.
    pub slid: [f64; 2],
    /// Friction of fast sliding without its viscous part.
    pub coulomb: f64,
    /// What a Stribeck curve adds to it at rest.
    pub excess: f64,
    /// Speed of the Stribeck curve.
    pub stribeck_speed: f64,
    /// Slope of friction over a high speed.
    pub viscous: f64,
    /// Slope of friction over the distance after reversals.
    pub stiffness: f64,
}

/// Most points of the steady branch that a guess looks at.
const MOST: usize = 400;
/// Ridge of its least squares, of the largest eigenvalue.
const RIDGE: f64 = 1e-10;
/// Stribeck speeds that are tried.
const SPEEDS: usize = 12;
/// Most reversals that a guess looks at.
const REVERSALS: usize = 200;
/// Share of the slowest points that do not count, of many.
const SLOWEST: usize = 100;

impl Guess {
    /// Looks at the data.
    pub fn of(data: &Measurements) -> Self {
        let [slowest, fastest] = data.speeds();
        let mut guess = Self {
            speeds: [slow(data).max(slowest), fastest],
            forces: data.forces(),
            slid: [1.0, 1.0],
            coulomb: data.forces()[1],
            excess: 0.0,
            stribeck_speed: 0.0,
            viscous: 0.0,
            stiffness: 0.0,
        };
        guess.stribeck_speed = guess.middle_speed();
        if let Motion::Series { times, velocities } = data.motion() {
            guess.slid = distances(times, velocities);
        }
        guess.steady_branch(data);
        guess.stiffness = stiffness(data, guess.coulomb).unwrap_or({
            let [shortest, whole] = guess.slid;
            guess.coulomb / (shortest.sqrt() * whole.sqrt())
        });
        guess
    }

    /// Geometric mean of the slow and the fastest speed.
    pub fn middle_speed(&self) -> f64 {
        self.speeds[0].sqrt() * self.speeds[1].sqrt()
    }

    /// Fits the Stribeck curve of exponent 2 to steady points, over a grid of its speed.
    fn steady_branch(&mut self, data: &Measurements) {
        let points = steady_points(data);
        let sizes = points.iter().map(|&i| data.velocities()[i].abs());
        let speeds: Vec<f64> = sizes.map(|v| v / self.speeds[1]).collect();
        let along = |&i: &usize| data.per_load(i) * data.velocities()[i].signum() / self.forces[1];
        let forces: Vec<f64> = points.iter().map(along).collect();
        let slowest = self.speeds[0] / self.speeds[1];
        let mut least = f64::INFINITY;
        for k in 0..SPEEDS {
            let share = (k as f64 + 0.5) / SPEEDS as f64;
            let speed = libm::pow(slowest, 1.0 - share);
            let row = |v: f64| [1.0, libm::exp(-(v / speed) * (v / speed)), v];
            let mut normal = Normal::new(3);
            for (&v, &f) in speeds.iter().zip(&forces) {
                normal.add(&DVector::from_column_slice(&row(v)), f);
            }
            let Some(found) = normal.solve(RIDGE) else {
                continue;
            };
            let left = speeds.iter().zip(&forces).map(|(&v, f)| {
                let fitted: f64 = row(v).iter().zip(&found).map(|(a, x)| a * x).sum();
                (fitted - f) * (fitted - f)
            });
            let cost: f64 = left.sum();
            if cost < least {
                least = cost;
                self.coulomb = found[0] * self.forces[1];
                self.excess = found[1] * self.forces[1];
                self.stribeck_speed = speed * self.speeds[1];
                self.viscous = found[2] * self.forces[1] / self.speeds[1];
            }
        }
        // Friction of a rising law may leave nothing at rest.
        self.coulomb = self.coulomb.max(0.05 * self.forces[1]);
    }
}

/// The speed that one in a hundred points does not reach.
fn slow(data: &Measurements) -> f64 {
    let mut speeds: Vec<f64> = data.velocities().iter().map(|v| v.abs()).collect();
    speeds.retain(|v| *v > 0.0);
    let place = speeds.len() / SLOWEST;
    if place >= speeds.len() {
        return 0.0;
    }
    *speeds.select_nth_unstable_by(place, f64::total_cmp).1
}

/// Points of steady sliding: all; of a record those farther from the last reversal than half of the points are.
fn steady_points(data: &Measurements) -> Vec<usize> {
    let velocities = data.velocities();
    let mut points: Vec<usize> = match data.times() {
        None => (0..velocities.len()).collect(),
        Some(times) => {
            let since = since_reversal(times, velocities);
            let mut sorted = since.clone();
            let half = sorted.len() / 2;
            let middle = *sorted.select_nth_unstable_by(half, f64::total_cmp).1;
            let is_far = |&i: &usize| since[i] >= middle && velocities[i] != 0.0;
            (0..velocities.len()).filter(is_far).collect()
        }
    };
    let stride = points.len().div_ceil(MOST).max(1);
    if stride > 1 {
        points = points.into_iter().step_by(stride).collect();
    }
    points
}

/// Distance slid since the velocity last changed its sign, at each point.
fn since_reversal(times: &[f64], velocities: &[f64]) -> Vec<f64> {
    let mut distance = 0.0;
    let mut since = vec![0.0; times.len()];
    for i in 1..times.len() {
        let turns = velocities[i] * velocities[i - 1] <= 0.0;
        let step = 0.5 * (velocities[i] + velocities[i - 1]).abs() * (times[i] - times[i - 1]);
        distance = if turns { step } else { distance + step };
        since[i] = distance;
    }
    since
}

/// Median slope of friction over the distance after reversals, until it has changed by the Coulomb force.
fn stiffness(data: &Measurements, coulomb: f64) -> Option<f64> {
    let (times, v) = (data.times()?, data.velocities());
    let mut slopes = Vec::new();
    let mut i = 1;
    while i < v.len() && slopes.len() < REVERSALS {
        if v[i] * v[i - 1] > 0.0 || v[i] == 0.0 {
            i += 1;
            continue;
        }
        // From the last point before the turn.
        let (from, mut distance) = (data.per_load(i - 1), 0.0);
        let sign = v[i].signum();
        while i < v.len() && v[i] * sign > 0.0 {
            let before = (v[i - 1] * sign).max(0.0);
            distance += 0.5 * (v[i].abs() + before) * (times[i] - times[i - 1]);
            let change = (data.per_load(i) - from) * sign;
            i += 1;
            if change >= coulomb {
                slopes.push(change / distance);
                break;
            }
        }
    }
    if slopes.is_empty() {
        return None;
    }
    let half = slopes.len() / 2;
    let median = *slopes.select_nth_unstable_by(half, f64::total_cmp).1;
    (median > 0.0 && median.is_finite()).then_some(median)
}

/// Shortest and whole distance slid in a record.
fn distances(times: &[f64], velocities: &[f64]) -> [f64; 2] {
    let (mut shortest, mut whole) = (f64::INFINITY, 0.0);
    for i in 1..times.len() {
        let step = 0.5 * (velocities[i] + velocities[i - 1]).abs() * (times[i] - times[i - 1]);
        whole += step;
        if step > 0.0 {
            shortest = step.min(shortest);
        }
    }
    // A record may pass a reversal between any two points.
    let even = whole / times.len().max(1) as f64;
    if shortest.is_finite() {
        [shortest.max(1e-3 * even), whole]
    } else {
        [1.0, 1.0]
    }
}
