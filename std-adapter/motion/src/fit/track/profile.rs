//! Intervals from the profile of the sum of squares: it rises by t² of the noise at their ends.

use super::super::minimise::Minimum;
use super::super::outwards::{End, Outwards};
use super::super::parameter::{Model, Range};
use super::weighted::{ROUGH, Weighted};
use nalgebra::DMatrix;

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

impl Profile<'_> {
    /// The coordinate on one side of coordinate `k`; none where the data set no bound.
    fn end(&self, k: usize, sign: f64, is_logarithm: bool) -> Option<f64> {
        let wanted = self.rise.sqrt();
        let error = self.covariance[(k, k)].sqrt();
        let scale = 1.0 / OPEN_ERRORS;
        let (first, most) = match (is_logarithm, error > 0.0) {
            (true, true) => ((wanted * error).min(FIRST_LOGARITHM), OPEN_LOGARITHM),
            (true, false) => (FIRST_LOGARITHM, OPEN_LOGARITHM),
            (false, true) => (wanted * error, OPEN_ERRORS * error),
            (false, false) => (scale * self.from.q[k].abs().max(scale), f64::INFINITY),
        };
        let at = self.from.q[k];
        let [low, high] = self.film.bounds(&self.film.unknowns)[k];
        let room = if sign < 0.0 { at - low } else { high - at };
        let search = Outwards {
            first,
            most: most.min(room),
            wanted,
            begin: (self.from.cost - self.least).max(0.0).sqrt(),
        };
        let end = search.end(self.from.q.clone(), |distance, place| {
            self.risen(k, at + sign * distance, place)
        });
        match end {
            End::At(distance) => Some(at + sign * distance),
            // Bounds of logarithms are those of the search alone.
            _ if room <= most && !is_logarithm => Some(at + sign * room),
            _ => None,
        }
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
            [(-1.0, nothing[0]), (1.0, nothing[1])].map(|(sign, open)| {
                let end = profile.end(k, sign, range == Range::Positive);
                end.map_or(open, |q| range.value(q))
            })
        });
        around.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [low, high]| {
            [a.min(low), b.max(high)]
        })
    };
    ranges.enumerate().map(interval).collect()
}
