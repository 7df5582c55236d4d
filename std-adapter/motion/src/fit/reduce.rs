//! Triangular factor of a tall Jacobian: all that a step or a standard error needs.

use nalgebra::{DMatrix, DVector};

/// Reduction of a Jacobian J with column lengths D and residuals r: J D⁻¹ = Q R and Qᵀ r.
pub(super) struct Reduced {
    /// Lengths of the columns, 1 for a column of zeros.
    pub norms: Vec<f64>,
    /// R
    pub triangle: DMatrix<f64>,
    /// Qᵀ r, as many components as there are columns.
    pub turned: DVector<f64>,
}

/// Rows per block: memory does not grow with the number of points.
const BLOCK: usize = 8192;

/// Reduces some columns, which must be fewer than the rows.
///
/// Householder reflections of blocks of rows, each below the triangle of those before it (Golub and
/// Van Loan, *Matrix Computations*, 5.2), in the order of the rows: the same points give the same
/// bits.
pub(super) fn reduced(jacobian: &DMatrix<f64>, columns: &[usize], residuals: &[f64]) -> Reduced {
    let norms = columns.iter().map(|&j| match length_of(jacobian, j) {
        0.0 => 1.0,
        length => length,
    });
    let norms: Vec<f64> = norms.collect();
    let width = columns.len();
    let mut triangle = DMatrix::zeros(0, width + 1);
    for first in (0..residuals.len()).step_by(BLOCK) {
        let rows = BLOCK.min(residuals.len() - first);
        let above = triangle.nrows();
        let stacked =
            DMatrix::from_fn(above + rows, width + 1, |i, k| match i.checked_sub(above) {
                None => triangle[(i, k)],
                Some(i) if k == width => residuals[first + i],
                Some(i) => jacobian[(first + i, columns[k])] / norms[k],
            });
        triangle = stacked.qr().r();
    }
    let top = width.min(triangle.nrows());
    Reduced {
        norms,
        triangle: triangle.view((0, 0), (top, width)).into_owned(),
        turned: DVector::from_fn(top, |i, _| triangle[(i, width)]),
    }
}

/// Length of a column without overflow of its squares.
pub(super) fn length_of(jacobian: &DMatrix<f64>, j: usize) -> f64 {
    let column = jacobian.column(j);
    let largest = column.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    let unit = power_of_two(largest);
    let squares = column.iter().map(|x| (x / unit) * (x / unit));
    unit * squares.sum::<f64>().sqrt()
}

/// The power of two below a normal number > 0: dividing by it loses no digit.
pub(super) fn power_of_two(x: f64) -> f64 {
    /// Sign and exponent of an f64.
    const EXPONENT: u64 = 0xfff0_0000_0000_0000;
    f64::from_bits(x.max(f64::MIN_POSITIVE).to_bits() & EXPONENT)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_of_rows_give_the_triangle_of_the_whole() {
        // Points on a parabola, more than two blocks.
        let rows = 2 * BLOCK + 100;
        let x = |i: usize| i as f64 / rows as f64;
        let jacobian = DMatrix::from_fn(rows, 3, |i, k| [1.0, x(i), x(i) * x(i)][k]);
        let residuals: Vec<f64> = (0..rows).map(|i| 2.0 - x(i) + 3.0 * x(i) * x(i)).collect();
        let found = reduced(&jacobian, &[0, 1, 2], &residuals);
        // J D⁻¹ y = r has the solution y = D (2, −1, 3).
        let solution = found.triangle.clone().lu().solve(&found.turned);
        let solution = solution.unwrap_or_else(|| DVector::zeros(3));
        for (k, wanted) in [2.0, -1.0, 3.0].into_iter().enumerate() {
            assert!((solution[k] / found.norms[k] - wanted).abs() < 1e-10);
        }
        // Lengths of the triangle's columns are those of the scaled Jacobian.
        for column in found.triangle.column_iter() {
            assert!((column.norm() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn lengths_neither_overflow_nor_vanish() {
        for size in [1e-250, 1.0, 1e250] {
            let jacobian = DMatrix::from_element(4, 1, size);
            assert_eq!(length_of(&jacobian, 0), 2.0 * size);
        }
        assert_eq!(length_of(&DMatrix::zeros(4, 1), 0), 0.0);
        assert_eq!(power_of_two(5.0), 4.0);
    }
}
