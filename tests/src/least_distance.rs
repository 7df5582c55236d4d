//! The point of a polyhedron nearest to the origin, by an active set: an oracle without sweeps.
//!
//! min |x| subject to G x ≥ h becomes min |Eᵀu − f| with u ≥ 0, E = (G h), f = (0 … 0 1), whose
//! residual r gives x = −r/r_last (Lawson and Hanson 1974, chapters 20 and 23).

/// Gradient relative to the row's length below which a multiplier stays 0.
const STATIONARY: f64 = 1e-13;
/// Fraction of a row outside the span of the active ones below which it counts as dependent.
const DEPENDENT: f64 = 1e-11;

/// Nearest point x with rows·x ≥ bounds; `None` if there is none.
pub fn least_distance(rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>> {
    let length = rows.first()?.len();
    let extended: Vec<Vec<f64>> = rows
        .iter()
        .zip(bounds)
        .map(|(row, bound)| row.iter().copied().chain([*bound]).collect())
        .collect();
    let mut target = vec![0.0; length + 1];
    target[length] = 1.0;
    let rest = least_squares_not_negative(&extended, &target);
    let last = rest[length];
    (last < -f64::EPSILON).then(|| rest[..length].iter().map(|r| -r / last).collect())
}

/// Σ uᵢ rowsᵢ − target for the u ≥ 0 that makes it shortest.
fn least_squares_not_negative(rows: &[Vec<f64>], target: &[f64]) -> Vec<f64> {
    let mut u = vec![0.0; rows.len()];
    let mut active: Vec<usize> = Vec::new();
    let mut refused = vec![false; rows.len()];
    loop {
        let rest = combined(rows, &u, target);
        let gradient =
            |index: usize| -dot(&rows[index], &rest) / dot(&rows[index], &rows[index]).sqrt();
        let steepest = (0..rows.len())
            .filter(|index| !active.contains(index) && !refused[*index])
            .max_by(|a, b| gradient(*a).total_cmp(&gradient(*b)));
        let Some(entering) = steepest.filter(|index| gradient(*index) > STATIONARY) else {
            return rest;
        };
        active.push(entering);
        let Some(mut trial) = least_squares(rows, &active, target) else {
            active.pop();
            refused[entering] = true;
            continue;
        };
        refused.fill(false);
        // Back to the last point at which no multiplier is negative.
        while trial.iter().any(|value| *value <= 0.0) {
            let step = active
                .iter()
                .zip(&trial)
                .filter(|(_, value)| **value <= 0.0);
            let step = step.map(|(&index, value)| u[index] / (u[index] - value));
            let step = step.fold(1.0, f64::min);
            for (&index, value) in active.iter().zip(&trial) {
                u[index] += step * (value - u[index]);
            }
            let leaves: Vec<usize> = active
                .iter()
                .zip(&trial)
                .filter(|&(&index, value)| *value <= 0.0 && u[index] <= f64::EPSILON)
                .map(|(&index, _)| index)
                .collect();
            active.retain(|index| !leaves.contains(index));
            leaves.iter().for_each(|&index| u[index] = 0.0);
            refused
                .iter_mut()
                .zip(0..)
                .for_each(|(flag, index)| *flag |= leaves.contains(&index));
            trial = least_squares(rows, &active, target).unwrap_or_default();
        }
        active
            .iter()
            .zip(&trial)
            .for_each(|(&index, &value)| u[index] = value);
    }
}

/// Coefficients of the active rows for the best approximation of the target, by Gram-Schmidt, applied twice.
fn least_squares(rows: &[Vec<f64>], active: &[usize], target: &[f64]) -> Option<Vec<f64>> {
    let count = active.len();
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(count);
    let mut upper = vec![vec![0.0; count]; count];
    for (column, &index) in active.iter().enumerate() {
        let mut row = rows[index].clone();
        let size = dot(&row, &row).sqrt();
        for _ in 0..2 {
            for (level, unit) in basis.iter().enumerate() {
                let share = dot(unit, &row);
                upper[level][column] += share;
                row.iter_mut().zip(unit).for_each(|(x, e)| *x -= share * e);
            }
        }
        let left = dot(&row, &row).sqrt();
        if left <= DEPENDENT * size {
            return None;
        }
        upper[column][column] = left;
        basis.push(row.iter().map(|x| x / left).collect());
    }
    let mut u: Vec<f64> = basis.iter().map(|unit| dot(unit, target)).collect();
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count)
            .map(|column| upper[row][column] * u[column])
            .sum();
        u[row] = (u[row] - known) / upper[row][row];
    }
    Some(u)
}

fn combined(rows: &[Vec<f64>], u: &[f64], target: &[f64]) -> Vec<f64> {
    let mut sum: Vec<f64> = target.iter().map(|x| -x).collect();
    for (row, factor) in rows.iter().zip(u).filter(|(_, factor)| **factor != 0.0) {
        sum.iter_mut().zip(row).for_each(|(x, r)| *x += factor * r);
    }
    sum
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
