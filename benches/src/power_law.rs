//! Exponents of power laws through measured points.

/// Slope of the straight line nearest to points in the square of y; NaN for one point.
pub fn slope(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / count);
    let moment = |a: usize, b: usize| -> f64 {
        let product = |point: &[f64; 2]| (point[a] - mean[a]) * (point[b] - mean[b]);
        points.iter().map(product).sum()
    };
    moment(0, 1) / moment(0, 0)
}

/// The exponent b of y ∝ xᵇ, by least squares of logarithms; NaN for one point.
pub fn exponent(points: impl IntoIterator<Item = [f64; 2]>) -> f64 {
    let logs: Vec<[f64; 2]> = points.into_iter().map(|point| point.map(f64::ln)).collect();
    slope(&logs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_those_of_power_laws() {
        let points = [1.0_f64, 2.0, 5.0, 11.0].map(|x| [x, 3.0 * x.powf(1.7)]);
        assert!((exponent(points) - 1.7).abs() < 1e-12);
        assert!(exponent([[1.0, 2.0]]).is_nan());
    }
}
