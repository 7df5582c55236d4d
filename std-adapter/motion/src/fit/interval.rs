//! Intervals from the profile of the sum of squares: how far a parameter can be moved, the others following, before the data
//! refuse it.

use super::estimate::Uncertainty;
use super::jacobian::{DifferenceScale, Order};
use super::linearised::Linearised;
use super::minimise::{Problem, Stall, minimise};
use super::outwards::{End, Outwards};
use super::parameter::Range;
use super::reduce::reduced;
use super::sample::WeightedData;
use super::search::problem;
use super::unknowns::Unknowns;
use tribos_base::run::in_order;

/// Normal quantile of an interval that covers 95 %.
const NORMAL: f64 = 1.959_963_984_540_054;
/// Relative offset at which a minimisation on the profile ends.
const OFFSET: f64 = 1e-4;
/// When a minimisation has stalled: the rise of the sum of squares is known well enough.
const STALL: Stall = Stall {
    share: 1e-3,
    steps: 5,
    ..Stall::ROUGH
};
/// Decrease of the sum of squares that is another minimum, in variances.
const LOWER: f64 = 0.02;
/// Most steps with the slopes at the minimum, before slopes are taken anew.
const MOST_STEPS: usize = 8;
/// Decrease of the sum of squares that a step may still promise, in variances.
const PROMISED: f64 = 0.01;
/// First distance of a parameter at its bound, in its natural size.
const STEP: f64 = 0.1;
/// Largest first distance of a logarithm.
const FIRST_LOGARITHM: f64 = 1.0;

/// Quantile of Student's t for an interval that covers 95 %.
///
/// *Accuracy*: 2e-3 from 3 degrees of freedom on (Cornish and Fisher, to the fourth order); 4 digits for 1 and 2.
pub(super) fn student(freedoms: f64) -> f64 {
    if freedoms < 1.5 {
        return 12.706;
    }
    if freedoms < 2.5 {
        return 4.3027;
    }
    let (z, n) = (NORMAL, freedoms);
    let [z3, z5, z7, z9] = [3, 5, 7, 9].map(|power| (0..power).fold(1.0, |x, _| x * z));
    z + (z3 + z) / (4.0 * n)
        + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n)
        + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n)
        + (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z)
            / (92_160.0 * n * n * n * n)
}

/// The profile of a fit around a minimum.
pub(super) struct Profile<'a> {
    pub unknowns: &'a Unknowns<'a>,
    pub target: &'a WeightedData,
    pub lengths: &'a [DifferenceScale],
    /// Values at the minimum.
    pub values: Vec<f64>,
    /// The least sum of squares of all minima, and how far that of this one is above.
    pub cost: f64,
    pub above: f64,
    /// Standard deviation of a residual, with what correlation adds.
    pub deviation: f64,
    /// Distance of the interval's ends in standard deviations.
    pub quantile: f64,
    /// Values with parameters that are as good as zero at their usual size, if there are any: from there they may grow
    /// again, which their logarithms do not show.
    pub grown: Option<Vec<f64>>,
}

/// What a profile found.
pub(super) enum Profiled {
    /// The ends of the interval of each parameter.
    Intervals(Vec<[f64; 2]>),
    /// Values with a smaller sum of squares.
    Lower(Vec<f64>),
}

impl Profile<'_> {
    /// Intervals of all parameters by the profile.
    pub fn intervals(&self, known: &[Uncertainty]) -> Profiled {
        let sides: Vec<(usize, f64)> = self
            .unknowns
            .sought
            .iter()
            .filter(|&&j| !matches!(known[j], Uncertainty::Undetermined(_)))
            .flat_map(|&j| [(j, -1.0), (j, 1.0)])
            .collect();
        let mut intervals = self.without_data(known);
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let end = |index: usize| {
            let (parameter, side) = sides[index];
            self.end(parameter, side, &known[parameter])
        };
        let ends: Vec<_> = if threads == 1 {
            (0..sides.len()).map(end).collect()
        } else {
            let ends = in_order(sides.len(), threads, end);
            ends.into_iter()
                .map(|end| end.unwrap_or(Ok(f64::NAN)))
                .collect()
        };
        for (&(parameter, side), end) in sides.iter().zip(ends) {
            match end {
                Ok(end) => intervals[parameter][usize::from(side > 0.0)] = end,
                Err(lower) => return Profiled::Lower(lower),
            }
        }
        Profiled::Intervals(intervals)
    }

    /// Intervals of the linearised law, in the coordinate of each parameter.
    pub fn linear(&self, known: &[Uncertainty]) -> Vec<[f64; 2]> {
        let mut intervals = self.without_data(known);
        for &j in &self.unknowns.sought {
            if let Uncertainty::StandardError(error) = known[j] {
                let range = self.unknowns.model.parameters()[j].range;
                let value = self.values[j];
                let at = range.coordinate(value);
                let [low, high] = range.bounds();
                let reach = self.quantile * error / range.derivative(value);
                intervals[j] = [
                    range.value((at - reach).max(low)),
                    range.value((at + reach).min(high)),
                ];
            }
        }
        intervals
    }

    /// A fixed parameter has its value; the data tell nothing of others.
    fn without_data(&self, known: &[Uncertainty]) -> Vec<[f64; 2]> {
        let intervals = self
            .values
            .iter()
            .zip(known)
            .map(|(value, known)| match known {
                Uncertainty::Fixed => [*value; 2],
                Uncertainty::AtBound | Uncertainty::Undetermined(_) => {
                    [f64::NEG_INFINITY, f64::INFINITY]
                }
                Uncertainty::StandardError(_) => [f64::NAN; 2],
            });
        intervals.collect()
    }

    /// The value on one side at which the sum of squares has risen to the quantile, or values with a smaller sum.
    fn end(&self, parameter: usize, side: f64, known: &Uncertainty) -> Result<f64, Vec<f64>> {
        let range = self.unknowns.model.parameters()[parameter].range;
        let value = self.values[parameter];
        let at = range.coordinate(value);
        let [low, high] = self.ends_of_range(parameter, range.bounds());
        let most = if side < 0.0 { at - low } else { high - at };
        if most <= 0.0 {
            return Ok(value);
        }
        let reach = match known {
            Uncertainty::StandardError(error) => self.quantile * error / range.derivative(value),
            _ => STEP * at.abs().max(self.natural(parameter)),
        };
        let search = Outwards {
            first: match range {
                Range::Positive => reach.min(FIRST_LOGARITHM),
                _ => reach,
            },
            most,
            wanted: self.quantile,
            begin: self.above.max(0.0).sqrt() / self.deviation,
        };
        let slopes = self.slopes(parameter);
        let lower = LOWER * self.deviation * self.deviation + self.target.floor();
        let end = search.end(self.values.clone(), |distance, others| {
            let moved = range.value(at + side * distance);
            let (mut cost, mut found) = self.at((parameter, moved), others, slopes.as_ref())?;
            let grown = self.grown.as_ref();
            if let Some((other, there)) =
                grown.and_then(|all| self.at((parameter, moved), all, None))
                && other < cost
            {
                (cost, found) = (other, there);
            }
            let risen = if cost < self.cost - lower {
                -1.0
            } else {
                (cost - self.cost).max(0.0).sqrt() / self.deviation
            };
            Some((found, risen))
        });
        match end {
            End::At(distance) => Ok(range.value(at + side * distance)),
            End::Open => Ok(range.value(at + side * most)),
            End::Lower(values) => Err(values),
        }
    }

    /// The natural size of a parameter that is at its bound.
    fn natural(&self, parameter: usize) -> f64 {
        let place = self.unknowns.sought.iter().position(|&j| j == parameter);
        place.map_or(1.0, |place| self.lengths[place].least())
    }

    /// Bounds of the parameter's coordinate.
    fn ends_of_range(&self, parameter: usize, [low, high]: [f64; 2]) -> [f64; 2] {
        let model = self.unknowns.model;
        let [least, most] = match (model.limits(parameter), model.above(parameter)) {
            (limits, None) => limits,
            // Limits of the excess over another parameter.
            ([_, most], Some(lower)) => [f64::NEG_INFINITY, self.values[lower] + most],
        };
        let range = model.parameters()[parameter].range;
        let inside = |value: f64, otherwise: f64| {
            if value.is_finite() && range.admits(value) {
                range.coordinate(value)
            } else {
                otherwise
            }
        };
        [inside(least, low).max(low), inside(most, high).min(high)]
    }

    /// The least sum of squares with one parameter kept, and the values there.
    fn at(
        &self,
        (parameter, value): (usize, f64),
        others: &[f64],
        slopes: Option<&Linearised>,
    ) -> Option<(f64, Vec<f64>)> {
        let unknowns = self.unknowns.keeping(parameter, value);
        if unknowns.sought.is_empty() {
            let mut values = others.to_vec();
            values[parameter] = value;
            let residuals = self.target.residuals_of(unknowns.model, &values)?;
            return Some((residuals.iter().map(|r| r * r).sum(), values));
        }
        let residuals = |q: &[f64]| self.target.residuals(&unknowns, q);
        let problem = self.problem(parameter, &unknowns, &residuals);
        let mut start = others.to_vec();
        start[parameter] = value;
        let q = unknowns.coordinates(&start);
        let (cost, q) = match slopes.and_then(|slopes| self.nearby(&problem, slopes, &q)) {
            Some(found) => found,
            None => {
                let end = minimise(&problem, &q, &mut |_| ())?;
                (end.cost, end.q)
            }
        };
        Some((cost, unknowns.values(&q)))
    }

    /// The problem of the other parameters.
    fn problem<'b>(
        &self,
        parameter: usize,
        unknowns: &Unknowns<'_>,
        residuals: &'b super::jacobian::Residuals<'b>,
    ) -> Problem<'b> {
        let places = self.unknowns.sought.iter().enumerate();
        let lengths = places.filter(|(_, j)| **j != parameter);
        let lengths: Vec<_> = lengths.map(|(k, _)| self.lengths[k]).collect();
        let mut problem = problem(residuals, unknowns, self.target, &lengths);
        problem.offset = OFFSET;
        problem.stall = Stall {
            above: self.cost,
            ..STALL
        };
        problem
    }

    /// Slopes of the other parameters at the minimum, if none of them is at a bound.
    fn slopes(&self, parameter: usize) -> Option<Linearised> {
        let unknowns = self.unknowns.keeping(parameter, self.values[parameter]);
        if unknowns.sought.is_empty() {
            return None;
        }
        let residuals = |q: &[f64]| self.target.residuals(&unknowns, q);
        let problem = self.problem(parameter, &unknowns, &residuals);
        let q = unknowns.coordinates(&self.values);
        let slopes = Linearised::at(&problem, &q, Order::Second)?;
        (slopes.free.len() == q.len()).then_some(slopes)
    }

    /// Least sum of squares near the minimum, by Gauss–Newton steps with the slopes there; `None` where these lead
    /// astray or to a bound.
    fn nearby(
        &self,
        problem: &Problem<'_>,
        slopes: &Linearised,
        start: &[f64],
    ) -> Option<(f64, Vec<f64>)> {
        /// Singular value over the largest of a combination that stays as it is.
        const FLAT: f64 = 1e-7;
        let mut q = start.to_vec();
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let is_inside = |(x, [low, high]): (&f64, &[f64; 2])| low < x && x < high;
            if !q.iter().zip(&problem.bounds).all(is_inside) {
                return None;
            }
            let residuals = (problem.residuals)(&q)?;
            let cost: f64 = residuals.iter().map(|r| r * r).sum();
            if cost.is_nan() || cost >= last {
                return None;
            }
            let system = reduced(&slopes.jacobian, &slopes.free, &residuals);
            let promised = system.turned.norm_squared();
            if promised <= PROMISED * self.deviation * self.deviation {
                return Some((cost, q));
            }
            let svd = system.triangle.svd(true, true);
            let most = svd.singular_values.iter().copied().fold(0.0, f64::max);
            let step = svd.solve(&system.turned, FLAT * most).ok()?;
            for ((x, step), norm) in q.iter_mut().zip(step.iter()).zip(&system.norms) {
                *x -= step / norm;
            }
            last = cost;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::student;

    #[test]
    fn quantiles_are_those_of_tables() {
        // Abramowitz and Stegun, table 26.10.
        for (freedoms, wanted) in [
            (1.0, 12.706),
            (2.0, 4.303),
            (3.0, 3.182),
            (5.0, 2.571),
            (10.0, 2.228),
            (30.0, 2.042),
        ] {
            assert!(
                (student(freedoms) - wanted).abs() < 2e-3 * wanted,
                "{freedoms}"
            );
        }
    }
}
