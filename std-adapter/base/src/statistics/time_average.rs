//! Means over time of a record, with their standard errors.

use super::correlation::{correlation, drift};
use super::marginal_error_cut;
use crate::results::{Quantity, Recorded, Reporting, Summary, is_averaged, summary};
use serde_json::{Map, Value};

/// Share of the time that is left out at most: what settles later has not settled.
const MOST_LEFT_OUT: f64 = 0.5;
/// Standard errors of a slope that is a drift.
const DRIFTS: f64 = 4.0;
/// Fewest independent lines of a record that is long enough to tell.
const FEWEST: f64 = 8.0;

summary! {
    /// Mean over time of a column, with its standard error.
    ///
    /// A line counts by the time since the line before; the first, at which no time has passed, does not. Correlation
    /// enlarges the [error](super::correlation) by √(2τ), and that of a record of n lines by another √(1 + (2W + 1)/n),
    /// since its own mean is taken off (Wolff, Comput. Phys. Commun. 156 (2004) 143, eq. 49).
    ///
    /// *Accuracy*: of correlated noise the interval of one error holds the mean in 65 to 71 % of the records, that of 1.96
    /// errors in 92 to 96 %, where `effective` is 50 or more; at 15 in 59 and 85 %.
    ///
    /// ```
    /// use tribos::statistics::TimeAverage;
    /// // A force that rises to 2 in five steps, and stays there.
    /// let (times, force): (Vec<f64>, Vec<f64>) = (0..50).map(|i| (f64::from(i), f64::from(i.min(5)) * 0.4)).unzip();
    /// let mean = TimeAverage::of(&times, &force, None);
    /// assert_eq!((mean.mean, mean.error, mean.from), (2.0, 0.0, 4.0));
    /// // From the start on it is less, and has not settled.
    /// let all = TimeAverage::of(&times, &force, Some(0.0));
    /// assert!(all.mean < 1.95 && all.error > 0.0);
    /// ```
    #[derive(Copy)]
    pub struct TimeAverage = part;

    /// Mean over the time from `from` to the end.
    mean: f64, "of the column";
    /// Standard error of the mean; where the column has not settled, at least half of what its halves differ by.
    error: f64, "of the column";
    /// Time from which on it is taken: that of `average_from`, or after which the column has settled.
    from: f64, "s";
    /// Number of independent values among the lines: lines over 2τ.
    effective: f64, "-";
    /// Whether the column has settled in the first half of the run, does not drift afterwards, and has eight independent lines.
    settled: bool, "-";
}

impl TimeAverage {
    /// The mean of a column over the lines later than `from`, by default from where the column has settled. *Domain*:
    /// times that do not fall. NaN of values that are not finite, or where no line is later.
    pub fn of(times: &[f64], values: &[f64], from: Option<f64>) -> Self {
        Self::weighted(times, values, &vec![1.0; values.len()], from)
    }

    /// The same with another weight of each line beside its time. With the values τ/P and the weights P it is the mean of τ
    /// over that of P, which differs from the mean of τ/P where P fluctuates.
    pub fn weighted(times: &[f64], values: &[f64], weights: &[f64], from: Option<f64>) -> Self {
        let first = match from {
            Some(from) => times.iter().skip(1).position(|time| *time > from),
            None => Some(0),
        };
        let later = |first: usize| {
            Some((
                times.get(first..)?,
                values.get(first + 1..)?,
                weights.get(first + 1..)?,
            ))
        };
        let alone = Self::of_line(times, values);
        let Some((times, values, weights)) = first.and_then(later) else {
            return alone;
        };
        if values.is_empty() || [times.len() - 1, weights.len()] != [values.len(); 2] {
            return alone;
        }
        // Weighted values settle: where a weight is small, a ratio may be any.
        let passed: Vec<f64> = times.windows(2).map(|ends| ends[1] - ends[0]).collect();
        let shares: Vec<f64> = values
            .iter()
            .zip(weights)
            .map(|(x, weight)| x * weight)
            .collect();
        let start = match from {
            Some(_) => 0,
            None => marginal_error_cut(&shares, &passed, MOST_LEFT_OUT),
        };
        // One line more could not have been left out.
        let next: f64 = passed.iter().take(start + 1).sum();
        let is_late = start > 0 && next > MOST_LEFT_OUT * passed.iter().sum::<f64>();
        let weights = passed
            .iter()
            .zip(weights)
            .map(|(time, weight)| time * weight);
        Self::over(
            times[start],
            &values[start..],
            weights.skip(start).collect(),
            is_late,
        )
    }

    /// That of a record without time: its last value.
    fn of_line(times: &[f64], values: &[f64]) -> Self {
        let is_line = times.len() == 1;
        Self {
            mean: values
                .last()
                .copied()
                .filter(|_| is_line)
                .unwrap_or(f64::NAN),
            error: f64::NAN,
            from: times.last().copied().unwrap_or(f64::NAN),
            effective: 0.0,
            settled: false,
        }
    }

    /// The mean over all of the lines, which begin after a time.
    fn over(from: f64, values: &[f64], mut weights: Vec<f64>, is_late: bool) -> Self {
        let count = values.len() as f64;
        let mut total: f64 = weights.iter().sum();
        if total <= 0.0 {
            weights.fill(1.0);
            total = count;
        }
        // About one of the values, so that a constant has its own bits.
        let origin = values[0];
        let weighted = values.iter().zip(&weights);
        let sum: f64 = weighted.map(|(x, weight)| (x - origin) * weight).sum();
        let mean = origin + sum / total;
        let distances = || values.iter().map(|x| x - mean);
        // Squares neither overflow nor vanish.
        let unit = distances().fold(0.0, |most: f64, x| most.max(x.abs()));
        let mut found = Self {
            mean,
            error: 0.0,
            from,
            effective: count,
            settled: !is_late,
        };
        if values.len() < 2 || !mean.is_finite() || !unit.is_finite() {
            (found.error, found.settled) = (f64::NAN, false);
            return found;
        }
        if unit == 0.0 {
            return found;
        }
        // What each line adds to the mean, relative to an even share of the time.
        let terms = distances().zip(&weights);
        let terms: Vec<f64> = terms
            .map(|(x, weight)| x / unit * (weight * count / total))
            .collect();
        let squares: f64 = terms.iter().map(|x| x * x).sum();
        let (slope, z) = drift(&terms);
        let [time, window] = correlation(terms);
        let time = time.max(0.5) * (1.0 + (2.0 * window + 1.0) / count);
        found.effective = count / (2.0 * time);
        found.error = unit * (squares / (count - 1.0) / found.effective).sqrt();
        found.settled &= found.effective >= FEWEST && z.abs() <= DRIFTS;
        if !found.settled && slope.is_finite() {
            found.error = found.error.max(unit * 0.25 * slope.abs() * count);
        }
        found
    }
}

/// Means over time of the columns of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Averages(pub Vec<(&'static str, TimeAverage)>);

impl Averages {
    /// Means of all columns but the time, which is the first, and the number of steps.
    pub fn of<const N: usize>(
        columns: [&'static str; N],
        rows: &[[f64; N]],
        from: Option<f64>,
    ) -> Self {
        let column = |at: usize| rows.iter().map(|row| row[at]).collect::<Vec<f64>>();
        let times = column(0);
        let averaged = columns.into_iter().enumerate().skip(1);
        let averaged = averaged.filter(|(_, name)| is_averaged(name));
        Self(
            averaged
                .map(|(at, name)| (name, TimeAverage::of(&times, &column(at), from)))
                .collect(),
        )
    }

    /// Replaces the mean of a column.
    pub fn set(&mut self, column: &str, average: TimeAverage) {
        for (_, known) in self.0.iter_mut().filter(|(name, _)| *name == column) {
            *known = average;
        }
    }

    /// The mean of a column.
    pub fn get(&self, column: &str) -> Option<&TimeAverage> {
        let found = self.0.iter().find(|(name, _)| *name == column);
        found.map(|(_, average)| average)
    }
}

impl Recorded for Averages {
    const PARTS: &'static [Quantity] = &[Quantity {
        name: "COLUMN",
        unit: "-",
        meaning: "Each column of the series but `time` and `step`.",
        reporting: Reporting::InSummary,
        parts: TimeAverage::QUANTITIES,
        is_flat: false,
    }];

    fn recorded(&self) -> Option<Value> {
        let entry = |(name, average): &(&'static str, TimeAverage)| {
            Some((String::from(*name), average.recorded()?))
        };
        Some(Value::Object(
            self.0.iter().filter_map(entry).collect::<Map<_, _>>(),
        ))
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
