//! Means, scatter and straight lines of measured values, and means over time.

pub mod correlation;
mod time_average;

pub use time_average::{Averages, TimeAverage};

/// Mean; NaN of no value.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Mean and standard deviation; the deviation of less than two values is NaN.
pub fn statistics(values: &[f64]) -> (f64, f64) {
    let (count, mean) = (values.len() as f64, mean(values));
    (mean, (squares(values, mean) / (count - 1.0)).sqrt())
}

/// Mean of independent values and its standard error; the error of less than two values is NaN.
pub fn mean_and_error(values: &[f64]) -> [f64; 2] {
    let (count, mean) = (values.len() as f64, mean(values));
    [
        mean,
        (squares(values, mean) / (count * (count - 1.0))).sqrt(),
    ]
}

/// Sum of the squared distances from a mean.
fn squares(values: &[f64], mean: f64) -> f64 {
    values.iter().map(|x| (x - mean) * (x - mean)).sum()
}

/// Intercept and slope of the least-squares line through points.
pub fn straight_line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let mean = |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
    let (x, y) = (mean(&|point| point.0), mean(&|point| point.1));
    let slope =
        mean(&|point| (point.0 - x) * (point.1 - y)) / mean(&|point| (point.0 - x) * (point.0 - x));
    (y - slope * x, slope)
}

/// The number of first values whose omission makes the standard error of the weighted mean of the rest smallest, among those
/// that have up to a share of the weight: the marginal standard error rule (White, *Simulation* 69, 1997, 323), the least
/// Σ wᵢ(xᵢ − x̄)²/(Σ wᵢ)² over the rest.
pub fn marginal_error_cut(values: &[f64], weights: &[f64], most: f64) -> usize {
    let total: f64 = weights.iter().sum();
    // Sums from the end, of values about the last one: no digits are lost.
    let origin = values.last().copied().unwrap_or(0.0);
    let (mut left, mut sum, mut squares) = (0.0, 0.0, 0.0);
    let (mut best, mut least) = (0, f64::INFINITY);
    for (d, (value, weight)) in values.iter().zip(weights).enumerate().rev() {
        let value = value - origin;
        left += weight;
        sum += weight * value;
        squares += weight * value * value;
        let score = (squares - sum * sum / left) / (left * left);
        if total - left <= most * total && score <= least {
            (best, least) = (d, score);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_deviations_and_lines_are_those_of_a_known_sample() {
        // numpy: mean, std(ddof=1), std(ddof=1)/sqrt(4) of 1, 2, 4, 9.
        let values = [1.0, 2.0, 4.0, 9.0];
        let deviation = 3.559_026_084_010_437;
        assert_eq!(mean(&values), 4.0);
        let (mean, scatter) = statistics(&values);
        assert!(mean == 4.0 && (scatter - deviation).abs() < 1e-15);
        let [mean, error] = mean_and_error(&values);
        assert!(mean == 4.0 && (error - deviation / 2.0).abs() < 1e-15);
        assert_eq!(
            straight_line(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]),
            (1.0, 2.0)
        );
        assert!(super::mean(&[]).is_nan() && mean_and_error(&[1.0])[1].is_nan());
    }

    #[test]
    fn the_cut_is_that_of_the_smallest_error() {
        // Σ (x − x̄)²/(n − d)² by hand: 1.888, 0.043, 0.056 for d = 0, 1, 2, and 0.031 for 3 of 5, which are too many.
        let values = [9.0, 1.0, 2.0, 1.0, 1.5];
        assert_eq!(marginal_error_cut(&values, &[1.0; 5], 0.5), 1);
        assert_eq!(marginal_error_cut(&values, &[1.0; 5], 0.1), 0);
        // The first value has most of the weight, and may not be left out.
        assert_eq!(
            marginal_error_cut(&values, &[9.0, 1.0, 1.0, 1.0, 1.0], 0.5),
            0
        );
        assert_eq!(marginal_error_cut(&[], &[], 0.5), 0);
    }
}
