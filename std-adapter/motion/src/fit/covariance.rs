//! Covariance of the parameters, and the combinations that the data do not determine.

use super::reduce::{length_of, reduced};
use nalgebra::DMatrix;

/// Result of the analysis of the Jacobian at the minimum.
#[derive(Clone, Debug)]
pub(super) struct CovarianceAnalysis {
    /// (JᵀJ)⁻¹ of the given columns, without combinations that the data do not determine.
    pub covariance: DMatrix<f64>,
    /// Directions, in the coordinates of the columns, along which nothing changes: columns that trade against each
    /// other, or one that alone has no effect. Components that hardly take part are 0.
    pub loose: Vec<Vec<f64>>,
}

/// Singular value of the Jacobian with columns of length 1, over the largest, below which a
/// combination of parameters has no effect, given the rounding of differences.
const RANK: f64 = 1e-7;
/// Length of a column over that of the data below which a parameter changes nothing.
const EMPTY: f64 = 1e-10;
/// Least component with which a parameter counts as part of a combination.
const TAKES_PART: f64 = 0.05;

/// From some columns of the Jacobian; `sizes` are the magnitudes of their coordinates and `length`
/// that of the data.
pub(super) fn certainty(
    jacobian: &DMatrix<f64>,
    places: &[usize],
    sizes: &[f64],
    length: f64,
) -> CovarianceAnalysis {
    let columns = places.len();
    let rows = vec![0.0; jacobian.nrows()];
    let norms: Vec<f64> = places.iter().map(|&j| length_of(jacobian, j)).collect();
    let is_empty = |j: usize| norms[j] * sizes[j] <= EMPTY * length;
    let full: Vec<usize> = (0..columns).filter(|&j| !is_empty(j)).collect();
    let mut loose: Vec<Vec<f64>> = (0..columns)
        .filter(|&j| is_empty(j))
        .map(|j| (0..columns).map(|k| f64::from(u8::from(k == j))).collect())
        .collect();
    let mut covariance = DMatrix::zeros(columns, columns);
    if full.is_empty() {
        return CovarianceAnalysis { covariance, loose };
    }
    let kept: Vec<usize> = full.iter().map(|&k| places[k]).collect();
    let svd = reduced(jacobian, &kept, &rows).triangle.svd(false, true);
    let v_t = svd
        .v_t
        .unwrap_or_else(|| DMatrix::identity(full.len(), full.len()));
    let most = svd.singular_values.iter().copied().fold(0.0, f64::max);
    // V Σ⁻² Vᵀ, without undetermined directions.
    for (k, sigma) in svd.singular_values.iter().enumerate() {
        let direction = v_t.row(k);
        if *sigma <= RANK * most {
            let mut whole = vec![0.0; columns];
            for (j, &place) in full.iter().enumerate() {
                if direction[j].abs() > TAKES_PART {
                    whole[place] = direction[j] / norms[place];
                }
            }
            loose.push(whole);
            continue;
        }
        for (a, &i) in full.iter().enumerate() {
            for (b, &j) in full.iter().enumerate() {
                let share = direction[a] * direction[b] / (sigma * sigma);
                covariance[(i, j)] += share / (norms[i] * norms[j]);
            }
        }
    }
    CovarianceAnalysis { covariance, loose }
}
