//! Motion between the points of a record, and samples of a long one.

use super::super::parameter::{Between, VelocityCourse};

/// Length of an interval of a record in time, and the mean velocity in it.
pub(super) type Interval = (f64, f64);

/// Passes the steps from the point before to `point` on: their lengths in time and mean velocities.
///
/// On a straight course a reversal lies between two steps, never within one.
pub(super) fn velocity_steps(
    times: &[f64],
    velocities: &[f64],
    point: usize,
    path: Between,
    mut each: impl FnMut(f64, f64),
) {
    let dt = times[point] - times[point - 1];
    let [from, to] = [velocities[point - 1], velocities[point]];
    let steps = f64::from(path.steps);
    let mut part = |length: f64, mean: &dyn Fn(f64) -> f64| {
        for k in 0..path.steps {
            each(length / steps, mean((f64::from(k) + 0.5) / steps));
        }
    };
    match path.course {
        VelocityCourse::JumpsMidway => {
            each(0.5 * dt, from);
            each(0.5 * dt, to);
        }
        VelocityCourse::JumpsAtOnce => each(dt, to),
        VelocityCourse::JumpsLate => each(dt, from),
        VelocityCourse::Straight if from * to < 0.0 => {
            let turn = from / (from - to);
            part(dt * turn, &|share| from * (1.0 - share));
            part(dt * (1.0 - turn), &|share| to * share);
        }
        VelocityCourse::Straight => part(dt, &|share| from + (to - from) * share),
        VelocityCourse::Smooth => {
            let slope = |i: usize| {
                let (before, after) = (i.saturating_sub(1), (i + 1).min(times.len() - 1));
                dt * (velocities[after] - velocities[before]) / (times[after] - times[before])
            };
            let [leaves, arrives] = [slope(point - 1), slope(point)];
            // The cubic of Hermite.
            part(dt, &|x| {
                let (rest, rise) = (1.0 - x, to - from);
                from + rise * x * x * (3.0 - 2.0 * x) + x * rest * (leaves * rest - arrives * x)
            });
        }
    }
}

/// Intervals between selected points of a record, with the same durations and distances.
pub(super) fn merged(times: &[f64], velocities: &[f64], points: &[usize]) -> Vec<Interval> {
    let between = points.windows(2).map(|pair| {
        let (mut time, mut distance) = (0.0, 0.0);
        for i in pair[0] + 1..=pair[1] {
            let dt = times[i] - times[i - 1];
            time += dt;
            distance += 0.5 * dt * (velocities[i] + velocities[i - 1]);
        }
        (time, distance / time)
    });
    between.collect()
}

/// Points of a piece of a record.
const PIECE: usize = 125;

/// About `count` points in pieces: half of these begin shortly before a reversal, the others are spread evenly.
pub(super) fn pieces(velocities: &[f64], count: usize) -> Vec<usize> {
    let all = velocities.len();
    let number = (count / PIECE).max(1);
    let turns: Vec<usize> = (1..all)
        .filter(|&i| velocities[i] * velocities[i - 1] <= 0.0)
        .collect();
    let spread = |k: usize, of: usize, range: usize| k * range / of.max(1);
    let mut begins: Vec<usize> = Vec::with_capacity(number + 1);
    let half = number / 2;
    if !turns.is_empty() {
        let before = PIECE / 4;
        begins
            .extend((0..half).map(|k| turns[spread(k, half, turns.len())].saturating_sub(before)));
    }
    let rest = number - begins.len();
    begins.extend((0..rest).map(|k| spread(k, rest, all.saturating_sub(PIECE))));
    let mut points: Vec<usize> = begins
        .into_iter()
        .flat_map(|begin| begin..(begin + PIECE).min(all))
        .chain([0])
        .collect();
    points.sort_unstable();
    points.dedup();
    points
}
