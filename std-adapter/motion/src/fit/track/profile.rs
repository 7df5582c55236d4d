//! Intervals from the profile of the sum of squares: it rises by t² of the noise at their ends.

use super::super::minimise::Minimum;
use super::super::parameter::{Model, Range};
use super::weighted::{ROUGH, Weighted};
use nalgebra::DMatrix;

/// Share of t within which an end is found.
const CLOSE: f64 = 0.01;
/// Trials for one end.
const MOST_TRIALS: usize = 14;
/// A trial between two keeps this share of their distance from either.
const LEAST_SHARE: f64 = 0.05;
/// Largest factor from one trial to the next outwards.
const LONGEST: f64 = 3.0;
/// Logarithms or, of other coordinates, standard errors beyond which an interval has no end.
const OPEN_LOGARITHM: f64 = 5.0;
const OPEN_ERRORS: f64 = 100.0;
/// First trial of a logarithm.
const FIRST_LOGARITHM: f64 = 1.0;

/// The sum of squares around a minimum along one coordinate, with the others at their best.
struct Profile<'a> {
    film: &'a Weighted<'a>,
    /// Where it begins.
    from: &'a Minimum,
    /// Least sum of squares of all, and the rise at the ends of an interval.
    least: f64,
    rise: f64,
    /// Covariance of the coordinates, 0 where there is none.
    covariance: &'a DMatrix<f64>,
}

/// An end of an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    /// The coordinate.
    At(f64),
    /// The data set no bound.
    Open,
}

impl Profile<'_> {
    /// Both ends along coordinate `k`.
    fn ends(&self, k: usize, is_logarithm: bool) -> [End; 2] {
        [-1.0, 1.0].map(|sign| self.end(k, sign, is_logarithm))
    }

    /// Searches outwards, then between what is too near and what is too far, on √ of the rise, which is nearly
    /// linear.
    fn end(&self, k: usize, sign: f64, is_logarithm: bool) -> End {
        let wanted = self.rise.sqrt();
        let error = self.covariance[(k, k)].sqrt();
        let scale = 1.0 / OPEN_ERRORS;
        let (first, most) = match (is_logarithm, error > 0.0) {
            (true, true) => ((wanted * error).min(FIRST_LOGARITHM), OPEN_LOGARITHM),
            (true, false) => (FIRST_LOGARITHM, OPEN_LOGARITHM),
            (false, true) => (wanted * error, OPEN_ERRORS * error),
            (false, false) => (scale * self.from.q[k].abs().max(scale), f64::INFINITY),
        };
        let [low, high] = self.film.bounds(&self.film.unknowns)[k];
        let room = if sign < 0.0 {
            self.from.q[k] - low
        } else {
            high - self.from.q[k]
        };
        let most = most.min(room);
        let mut near = [0.0, (self.from.cost - self.least).max(0.0).sqrt()];
        let mut far: Option<[f64; 2]> = None;
        let mut at = first.min(most);
        let mut place = self.from.q.clone();
        for _ in 0..MOST_TRIALS {
            let Some((found, rise)) = self.risen(k, self.from.q[k] + sign * at, &place) else {
                far = Some([at, f64::INFINITY]);
                at = 0.5 * (near[0] + at);
                continue;
            };
            if (rise - wanted).abs() <= CLOSE * wanted {
                return End::At(self.from.q[k] + sign * at);
            }
            if rise < wanted {
                if at >= most {
                    // Bounds of logarithms are those of the search alone.
                    return if room <= most && !is_logarithm {
                        End::At(self.from.q[k] + sign * at)
                    } else {
                        End::Open
                    };
                }
                (near, place) = ([at, rise], found);
            } else {
                far = Some([at, rise]);
            }
            at = match far {
                Some([end, rise]) if rise.is_finite() => {
                    let share = (wanted - near[1]) / (rise - near[1]);
                    near[0] + (end - near[0]) * share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE)
                }
                Some([end, _]) => 0.5 * (near[0] + end),
                None => {
                    let ahead = at * (wanted / near[1]).clamp(1.1, LONGEST);
                    ahead.min(most)
                }
            };
        }
        End::At(self.from.q[k] + sign * at)
    }

    /// All coordinates with coordinate `k` held at a value, and √ of the rise above the least sum of squares.
    fn risen(&self, k: usize, value: f64, near: &[f64]) -> Option<(Vec<f64>, f64)> {
        let film = self.film;
        let all = &film.unknowns;
        let held = all.sought.get(k).copied()?;
        let range = all.model.parameters()[held].range;
        let unknowns = all.keeping(held, range.value(value));
        // The others follow by their correlation with this one.
        let slope = |j: usize| {
            let own = self.covariance[(k, k)];
            if own > 0.0 {
                self.covariance[(j, k)] / own
            } else {
                0.0
            }
        };
        let shift = value - near[k];
        let others = (0..near.len()).filter(|j| *j != k);
        let start: Vec<f64> = others.map(|j| near[j] + slope(j) * shift).collect();
        let found = film.minimum(&unknowns, &start, ROUGH)?;
        let mut q = found.q;
        q.insert(k, value);
        Some((q, (found.cost - self.least).max(0.0).sqrt()))
    }
}

/// Values at the ends of the profiles around all minima that are alike.
pub(super) fn intervals(
    film: &Weighted<'_>,
    alike: &[&Minimum],
    covariance: &DMatrix<f64>,
    rises: &[f64],
) -> Vec<[f64; 2]> {
    let unknowns = &film.unknowns;
    let least = alike.first().map_or(0.0, |best| best.cost);
    let ranges = unknowns
        .sought
        .iter()
        .map(|&j| film.model.parameters()[j].range);
    let interval = |(k, range): (usize, Range)| {
        let nothing = match range {
            Range::Positive | Range::NotNegative => [0.0, f64::INFINITY],
            Range::Any => [f64::NEG_INFINITY, f64::INFINITY],
            Range::Between { above, up_to } => [above, up_to],
        };
        let around = alike.iter().map(|from| {
            let profile = Profile {
                film,
                from,
                least,
                rise: rises[k],
                covariance,
            };
            let [low, high] = profile.ends(k, range == Range::Positive);
            let value = |end: End, open: f64| match end {
                End::At(q) => range.value(q),
                End::Open => open,
            };
            [value(low, nothing[0]), value(high, nothing[1])]
        });
        around.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [low, high]| {
            [a.min(low), b.max(high)]
        })
    };
    ranges.enumerate().map(interval).collect()
}
