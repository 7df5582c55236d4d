//! Multifrontal LU factorisation of a matrix of blocks.

use super::blocks::Blocks;
use super::symbolic::{Front, Symbolic};
use tribos_avx2::{Avx2, Work, run};

/// Factors of one front of n unknowns, p of them eliminated.
#[derive(Clone, Debug, Default)]
struct Factors {
    /// p × n by rows: the lower and the upper factor, and to their right the upper factor's other columns.
    upper: Vec<f64>,
    /// (n − p) × p by rows: the other rows of the lower factor.
    lower: Vec<f64>,
    /// Row that stands at each place after pivoting.
    rows: Vec<usize>,
}

/// Columns eliminated at once, before the rest of a front is updated.
const PANEL: usize = 8;
/// A pivot below this part of its front's largest entry is replaced by it.
const SMALLEST: f64 = 1e-40;

/// An LU factorisation; rows are exchanged inside fronts only.
#[derive(Clone, Debug, Default)]
pub(super) struct Lu {
    symbolic: Symbolic,
    factors: Vec<Factors>,
    /// Updates that wait for their parents, and buffers for the next ones.
    updates: Vec<Vec<f64>>,
    spare: Vec<Vec<f64>>,
    work: Vec<f64>,
}

impl Lu {
    /// Prepares factorisations of matrices with the pattern of `matrix`.
    pub fn new(matrix: &Blocks) -> Self {
        let symbolic = Symbolic::new(matrix);
        Self {
            factors: vec![Factors::default(); symbolic.fronts.len()],
            updates: vec![Vec::new(); symbolic.fronts.len()],
            symbolic,
            ..Self::default()
        }
    }

    /// Multiplications of a factorisation.
    pub fn cost(&self) -> f64 {
        self.symbolic.cost
    }

    /// Factorises a matrix of the pattern prepared.
    pub fn factorise(&mut self, matrix: &Blocks) {
        for number in 0..self.symbolic.fronts.len() {
            self.assemble(number, matrix);
            let front = &self.symbolic.fronts[number];
            let size = front.unknowns.len();
            let factors = &mut self.factors[number];
            run(Elimination {
                matrix: &mut self.work,
                size,
                pivots: front.pivots,
                rows: &mut factors.rows,
            });
            self.keep(number);
        }
    }

    /// Adds up the entries of a front: blocks of the matrix, and updates of its children.
    fn assemble(&mut self, number: usize, matrix: &Blocks) {
        let front = &self.symbolic.fronts[number];
        let size = front.unknowns.len();
        self.work.clear();
        self.work.resize(size * size, 0.0);
        for &(block, row, column) in &front.entries {
            let width = matrix.size(matrix.columns[block]);
            for (line, values) in matrix.block(block).chunks_exact(width).enumerate() {
                let start = (row + line) * size + column;
                for (entry, value) in self.work[start..start + width].iter_mut().zip(values) {
                    *entry += value;
                }
            }
        }
        for &child in &front.children {
            let places = &self.symbolic.fronts[child].in_parent;
            let update = std::mem::take(&mut self.updates[child]);
            for (&row, values) in places.iter().zip(update.chunks_exact(places.len().max(1))) {
                let line = &mut self.work[row * size..(row + 1) * size];
                for (&column, value) in places.iter().zip(values) {
                    line[column] += value;
                }
            }
            self.spare.push(update);
        }
    }

    /// Stores the factors of the front in the work space, and its update for the parent.
    fn keep(&mut self, number: usize) {
        let Front {
            unknowns, pivots, ..
        } = &self.symbolic.fronts[number];
        let (size, pivots) = (unknowns.len(), *pivots);
        let factors = &mut self.factors[number];
        factors.upper.clear();
        factors.upper.extend_from_slice(&self.work[..pivots * size]);
        factors.lower.clear();
        let mut update = self.spare.pop().unwrap_or_default();
        update.clear();
        for row in self.work[pivots * size..].chunks_exact(size.max(1)) {
            factors.lower.extend_from_slice(&row[..pivots]);
            update.extend_from_slice(&row[pivots..]);
        }
        self.updates[number] = update;
    }

    /// Replaces a right-hand side by the solution.
    pub fn solve(&self, vector: &mut [f64]) {
        run(Division { lu: self, vector });
    }

    #[inline(always)]
    fn divide(&self, vector: &mut [f64]) {
        let mut part = Vec::new();
        for (front, factors) in self.symbolic.fronts.iter().zip(&self.factors) {
            let (own, rest) = front.unknowns.split_at(front.pivots);
            let size = front.unknowns.len();
            part.clear();
            part.extend(factors.rows.iter().map(|&row| vector[own[row]]));
            for row in 0..own.len() {
                let line = &factors.upper[row * size..row * size + row];
                part[row] -= dot(line, &part[..row]);
            }
            for (&unknown, line) in rest
                .iter()
                .zip(factors.lower.chunks_exact(own.len().max(1)))
            {
                vector[unknown] -= dot(line, &part);
            }
            for (&unknown, value) in own.iter().zip(&part) {
                vector[unknown] = *value;
            }
        }
        for (front, factors) in self.symbolic.fronts.iter().zip(&self.factors).rev() {
            let size = front.unknowns.len();
            part.clear();
            part.extend(front.unknowns.iter().map(|&unknown| vector[unknown]));
            for row in (0..front.pivots).rev() {
                let line = &factors.upper[row * size..(row + 1) * size];
                part[row] = (part[row] - dot(&line[row + 1..], &part[row + 1..])) / line[row];
            }
            for (&unknown, value) in front.unknowns[..front.pivots].iter().zip(&part) {
                vector[unknown] = *value;
            }
        }
    }
}

/// The division of a right-hand side by the factors, for both kinds of processors: none of its sums has another order.
struct Division<'a> {
    lu: &'a Lu,
    vector: &'a mut [f64],
}

impl Work for Division<'_> {
    type Out = ();

    #[inline(always)]
    fn with_avx2(self, _: Avx2) {
        self.without();
    }

    #[inline(always)]
    fn without(self) {
        self.lu.divide(self.vector);
    }
}

/// The elimination of a front, likewise.
struct Elimination<'a> {
    matrix: &'a mut [f64],
    size: usize,
    pivots: usize,
    rows: &'a mut Vec<usize>,
}

impl Work for Elimination<'_> {
    type Out = ();

    #[inline(always)]
    fn with_avx2(self, _: Avx2) {
        self.without();
    }

    #[inline(always)]
    fn without(self) {
        eliminate(self.matrix, self.size, self.pivots, self.rows);
    }
}

/// Σ a b in four sums, which a processor adds side by side.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours, rest) = (a.chunks_exact(4), a.len() - a.len() % 4);
    for (a, b) in fours.zip(b.chunks_exact(4)) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let tail: f64 = a[rest..].iter().zip(&b[rest..]).map(|(a, b)| a * b).sum();
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + tail
}

/// Eliminates the first `pivots` unknowns of a dense matrix by rows, with exchanges of rows among them.
#[inline(always)]
fn eliminate(matrix: &mut [f64], size: usize, pivots: usize, rows: &mut Vec<usize>) {
    rows.clear();
    rows.extend(0..pivots);
    let largest = matrix
        .iter()
        .fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let smallest = SMALLEST * largest;
    for start in (0..pivots).step_by(PANEL) {
        let end = (start + PANEL).min(pivots);
        for step in start..end {
            exchange(matrix, size, (step, pivots), rows);
            let pivot = &mut matrix[step * size + step];
            if pivot.abs() < smallest {
                *pivot = if *pivot < 0.0 { -smallest } else { smallest };
            }
            let pivot = if *pivot == 0.0 { 1.0 } else { *pivot };
            // The panel's columns of the rows below.
            let (above, below) = matrix.split_at_mut((step + 1) * size);
            let source = &above[step * size + step + 1..step * size + end];
            for row in below.chunks_exact_mut(size) {
                let factor = row[step] / pivot;
                row[step] = factor;
                if factor != 0.0 {
                    for (entry, value) in row[step + 1..end].iter_mut().zip(source) {
                        *entry -= factor * value;
                    }
                }
            }
        }
        // The panel's rows of the upper factor, right of the panel.
        for step in start + 1..end {
            let (above, below) = matrix.split_at_mut(step * size);
            let (factors, target) = below[..size].split_at_mut(end);
            for (column, source) in (start..step).zip(above[start * size..].chunks_exact(size)) {
                let factor = factors[column];
                for (entry, value) in target.iter_mut().zip(&source[end..]) {
                    *entry -= factor * value;
                }
            }
        }
        update(matrix, size, start, end);
    }
}

/// Brings the largest entry of a column among the rows from `step` up to `pivots` to the diagonal.
#[inline(always)]
fn exchange(matrix: &mut [f64], size: usize, (step, pivots): (usize, usize), rows: &mut [usize]) {
    let mut best = step;
    for row in step + 1..pivots {
        if matrix[row * size + step].abs() > matrix[best * size + step].abs() {
            best = row;
        }
    }
    if best != step {
        rows.swap(step, best);
        let (above, below) = matrix.split_at_mut(best * size);
        above[step * size..(step + 1) * size].swap_with_slice(&mut below[..size]);
    }
}

/// Subtracts the product of a panel's columns and rows from all that is below and right of it.
#[inline(always)]
fn update(matrix: &mut [f64], size: usize, start: usize, end: usize) {
    let (above, below) = matrix.split_at_mut(end * size);
    let panel: Vec<&[f64]> = above[start * size..]
        .chunks_exact(size)
        .map(|row| &row[end..])
        .collect();
    for row in below.chunks_exact_mut(size) {
        let (factors, target) = row.split_at_mut(end);
        let factors = &factors[start..];
        if let (&[a, b, c, d, e, f, g, h], &[u, v, w, x, y, z, s, t]) = (factors, &panel[..]) {
            let (u, v, w, x) = (
                &u[..target.len()],
                &v[..target.len()],
                &w[..target.len()],
                &x[..target.len()],
            );
            let (y, z, s, t) = (
                &y[..target.len()],
                &z[..target.len()],
                &s[..target.len()],
                &t[..target.len()],
            );
            for (i, entry) in target.iter_mut().enumerate() {
                let first = (a * u[i] + b * v[i]) + (c * w[i] + d * x[i]);
                let second = (e * y[i] + f * z[i]) + (g * s[i] + h * t[i]);
                *entry -= first + second;
            }
        } else {
            for (factor, source) in factors.iter().zip(&panel) {
                for (entry, value) in target.iter_mut().zip(*source) {
                    *entry -= factor * value;
                }
            }
        }
    }
}
