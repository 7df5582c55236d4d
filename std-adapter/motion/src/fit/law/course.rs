//! Motion between the points of a record, and samples of a long one.

use super::super::abrupt::jumps;
use super::super::parameter::{Between, VelocityCourse};
use std::borrow::Cow;

/// Length of an interval of a record in time, and the mean velocity in it.
type Interval = (f64, f64);

/// Share of its interval at which a jump lies unless it is sought.
pub(super) const MIDWAY: f64 = 0.5;

/// The motion of a record, or of a sample of one.
pub(super) struct Motion<'a> {
    pub times: Cow<'a, [f64]>,
    pub velocities: Cow<'a, [f64]>,
    /// Means of a sample of points that are far apart.
    means: Option<Vec<Interval>>,
    path: Between,
    /// Points before which the velocity jumps.
    jumps: Vec<usize>,
    /// Slopes of a smooth course at the points.
    slopes: Vec<f64>,
}

impl<'a> Motion<'a> {
    pub fn new(times: &'a [f64], velocities: &'a [f64]) -> Self {
        Self {
            times: Cow::Borrowed(times),
            velocities: Cow::Borrowed(velocities),
            means: None,
            path: Between::PLAIN,
            jumps: Vec::new(),
            slopes: Vec::new(),
        }
    }

    /// The same with another motion between the points.
    pub fn along(&self, path: Between) -> Motion<'_> {
        let has_jumps = path.course == VelocityCourse::Jumps && self.means.is_none();
        Motion {
            times: Cow::Borrowed(&self.times),
            velocities: Cow::Borrowed(&self.velocities),
            means: self.means.clone(),
            path,
            jumps: if has_jumps {
                jumps(&self.velocities)
            } else {
                Vec::new()
            },
            slopes: if path.course == VelocityCourse::Smooth {
                spline(&self.times, &self.velocities)
            } else {
                Vec::new()
            },
        }
    }

    /// The motion at selected points, straight between them; with `is_whole` it keeps its distances.
    pub fn at(&self, points: &[usize], is_whole: bool) -> Motion<'static> {
        let of = |values: &[f64]| points.iter().map(|&i| values[i]).collect();
        Motion {
            times: Cow::Owned(of(&self.times)),
            velocities: Cow::Owned(of(&self.velocities)),
            means: is_whole.then(|| self.merged(points)),
            path: Between::PLAIN,
            jumps: Vec::new(),
            slopes: Vec::new(),
        }
    }

    /// Intervals between selected points, with the same durations and distances.
    fn merged(&self, points: &[usize]) -> Vec<Interval> {
        let (times, velocities) = (&self.times, &self.velocities);
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

    /// Whether the velocity jumps before a point, at an instant that is not known.
    pub fn jumps_before(&self, point: usize) -> bool {
        self.jumps.binary_search(&point).is_ok()
    }

    /// The point before which the velocity jumps again, some points after this one; else the last one.
    pub fn next_jump(&self, point: usize, last: usize) -> usize {
        /// The ends of a ramp may be closer.
        const CLOSE: usize = 4;
        let next = self.jumps.partition_point(|jump| *jump < point + CLOSE);
        self.jumps.get(next).map_or(last, |jump| last.min(*jump))
    }

    /// Passes the steps from the point before to `point` on: their lengths in time and mean velocities.
    ///
    /// A reversal lies between two steps, never within one.
    pub fn steps(&self, point: usize, mut each: impl FnMut(f64, f64)) {
        if let Some(means) = &self.means {
            let (dt, mean) = means[point - 1];
            return each(dt, mean);
        }
        if self.jumps_before(point) {
            return self.jump(point, MIDWAY, each);
        }
        let dt = self.times[point] - self.times[point - 1];
        let [from, to] = [self.velocities[point - 1], self.velocities[point]];
        let count = self.path.steps;
        if count == 1 && self.path.course != VelocityCourse::Smooth && from * to >= 0.0 {
            return each(dt, 0.5 * (from + to));
        }
        let slopes = match self.path.course {
            VelocityCourse::Smooth => Some([point - 1, point].map(|i| dt * self.slopes[i])),
            _ => None,
        };
        let velocity = |x: f64| {
            let (rest, rise) = (1.0 - x, to - from);
            match slopes {
                // The cubic of Hermite.
                Some([leaves, arrives]) => {
                    from + rise * x * x * (3.0 - 2.0 * x) + x * rest * (leaves * rest - arrives * x)
                }
                None => from + rise * x,
            }
        };
        let turn = if from * to < 0.0 {
            self.turn(from, &velocity)
        } else {
            0.0
        };
        let steps = f64::from(count);
        for [begin, end] in [[0.0, turn], [turn, 1.0]] {
            let length = end - begin;
            for k in 0..if length > 0.0 { count } else { 0 } {
                let middle = begin + length * (f64::from(k) + 0.5) / steps;
                each(dt * length / steps, velocity(middle));
            }
        }
    }

    /// Share of an interval after which its velocity changes its sign.
    fn turn(&self, from: f64, velocity: &impl Fn(f64) -> f64) -> f64 {
        if self.path.course != VelocityCourse::Smooth {
            return from / (from - velocity(1.0));
        }
        /// Halvings of the interval: to 1e-9 of it.
        const HALVINGS: u32 = 30;
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if velocity(middle) * from > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The steps before a point where the velocity jumps after this share of the time.
    pub fn jump(&self, point: usize, share: f64, mut each: impl FnMut(f64, f64)) {
        let dt = self.times[point] - self.times[point - 1];
        each(share * dt, self.velocities[point - 1]);
        each((1.0 - share) * dt, self.velocities[point]);
    }
}

/// Slopes at the points of the natural cubic spline through the velocities.
fn spline(times: &[f64], velocities: &[f64]) -> Vec<f64> {
    let last = times.len() - 1;
    // Lengths and rises of the intervals before and after a point; none beyond the ends.
    let interval = |i: usize| match i {
        0 => [f64::INFINITY, 0.0],
        i if i > last => [f64::INFINITY, 0.0],
        i => [times[i] - times[i - 1], velocities[i] - velocities[i - 1]],
    };
    // Thomas's algorithm: m[i−1]/h + 2 m[i] (1/h + 1/k) + m[i+1]/k = 3 (rise/h² + rise/k²).
    let (mut factors, mut slopes) = (Vec::new(), Vec::new());
    let [mut factor, mut slope] = [0.0; 2];
    for i in 0..=last {
        let [[h, rise], [k, next]] = [i, i + 1].map(interval);
        let right = 3.0 * (rise / h / h + next / k / k) - slope / h;
        let diagonal = 2.0 * (1.0 / h + 1.0 / k) - factor / h;
        (factor, slope) = (1.0 / k / diagonal, right / diagonal);
        factors.push(factor);
        slopes.push(slope);
    }
    for i in (0..last).rev() {
        slopes[i] -= factors[i] * slopes[i + 1];
    }
    slopes
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

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_course_goes_as_far_as_a_sine_and_turns_between_two_steps() {
        // Eight points a cycle.
        let times: Vec<f64> = (0..81)
            .map(|k| f64::from(k) * std::f64::consts::TAU / 8.0 + 0.3)
            .collect();
        let velocities: Vec<f64> = times.iter().map(|t| t.sin()).collect();
        let plain = Motion::new(&times, &velocities);
        let motion = plain.along(Between {
            steps: 16,
            course: VelocityCourse::Smooth,
        });
        for point in 5..76 {
            let (mut time, mut distance, mut signs) = (0.0, 0.0, Vec::new());
            motion.steps(point, |dt, mean| {
                time += dt;
                distance += dt * mean;
                signs.push(mean.signum());
            });
            let wanted = times[point - 1].cos() - times[point].cos();
            assert!((time - (times[point] - times[point - 1])).abs() < 1e-12);
            assert!((distance - wanted).abs() < 1e-3, "{distance} {wanted}");
            signs.dedup();
            let turns = velocities[point - 1] * velocities[point] < 0.0;
            assert_eq!(signs.len(), if turns { 2 } else { 1 });
        }
    }
}
