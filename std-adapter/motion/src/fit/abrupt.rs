//! Where a record pauses, and where its velocity changes abruptly between two points.

/// Interval between two points over those before and after it that is a gap.
const GAP: f64 = 4.0;
/// Largest share of the points that are gaps; beyond, a record is sampled at random and has none.
const MOST_GAPS: f64 = 0.01;
/// Change of the velocity between two points that is abrupt: over the largest velocity, and that of a neighbour
/// over it.
const ABRUPT: [f64; 2] = [0.02, 0.25];
/// Largest share of the intervals that are abrupt; beyond, the velocity is noisy, and has no jumps.
const MOST: f64 = 0.1;
/// Share of the intervals of a record whose velocity stays, from which on it changes by jumps.
const STEADY: f64 = 0.8;
/// Change of the velocity that is a jump, and the largest that is none, over the velocity.
const JUMP: [f64; 2] = [0.2, 1e-3];

/// Points where a record begins, or begins anew after a gap.
pub(super) fn beginnings(times: &[f64]) -> Vec<usize> {
    let long = |i: &usize| {
        let dt = |i: usize| times.get(i).zip(times.get(i - 1)).map(|(b, a)| b - a);
        let around = [*i - 1, *i + 1].map(|i| if i == 0 { None } else { dt(i) });
        let [before, after] = around.map(|dt| dt.unwrap_or(0.0));
        // A point between two gaps tells nothing.
        after > 0.0 && before > 0.0 && dt(*i).is_some_and(|dt| dt > GAP * before.max(after))
    };
    let gaps: Vec<usize> = (1..times.len()).filter(long).collect();
    let first = std::iter::once(0);
    if gaps.len() as f64 > 1.0 + MOST_GAPS * times.len() as f64 {
        return first.collect();
    }
    first.chain(gaps).collect()
}

/// Whether the velocity stays but for jumps.
pub(super) fn is_stepped(velocities: &[f64]) -> bool {
    let stays = velocities.windows(2).filter(|pair| stays(pair));
    let has_jumps = velocities.windows(2).any(|pair| relative(pair) >= JUMP[0]);
    has_jumps && stays.count() as f64 >= STEADY * (velocities.len() - 1) as f64
}

/// Points before which the velocity changes much, but little before or after that: jumps, and the ends of ramps.
pub(super) fn jumps(velocities: &[f64]) -> Vec<usize> {
    if is_stepped(velocities) {
        let stays: Vec<bool> = velocities.windows(2).map(stays).collect();
        let is_end =
            |&i: &usize| !stays[i] && (i > 0 && stays[i - 1] || stays.get(i + 1) == Some(&true));
        return (0..stays.len()).filter(is_end).map(|i| i + 1).collect();
    }
    let [much, little] = ABRUPT;
    let largest = velocities
        .iter()
        .fold(0.0, |most: f64, v| v.abs().max(most));
    let change = |a: f64, b: f64| (b - a).abs();
    let is_abrupt = |v: &[f64]| match *v {
        [a, b, c, d] => {
            let size = change(b, c);
            size >= much * largest && change(a, b).min(change(c, d)) < little * size
        }
        _ => false,
    };
    let windows = velocities.windows(4).enumerate();
    let abrupt = windows.filter(|(_, window)| is_abrupt(window));
    let abrupt: Vec<usize> = abrupt.map(|(first, _)| first + 2).collect();
    if abrupt.len() as f64 > MOST * velocities.len() as f64 {
        return Vec::new();
    }
    abrupt
}

/// Whether the velocity is the same at two points.
fn stays(pair: &[f64]) -> bool {
    let change = relative(pair);
    change.is_nan() || change <= JUMP[1]
}

/// Change of the velocity over the larger one.
fn relative(pair: &[f64]) -> f64 {
    (pair[1] - pair[0]).abs() / pair[0].abs().max(pair[1].abs())
}
