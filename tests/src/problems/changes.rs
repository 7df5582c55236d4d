//! Twenty changes of a problem between impulses.

use nalgebra::{DMatrix, Rotation2, Vector2};
use tribos::problem::{ContactThresholds, ReducedProblem, SparseMatrix};
use tribos::random::Random;

/// Names of the changes.
pub const CHANGES: [&str; 20] = [
    "mass in 1e-6 units",
    "mass in 1e6 units",
    "length in 1e-6 units",
    "length in 1e6 units",
    "contacts in another order",
    "contacts in a third order",
    "tangents turned",
    "tangents turned otherwise",
    "thresholds times 0.1",
    "thresholds times 0.3",
    "thresholds times 2",
    "thresholds times 3",
    "q changed by 1e-3",
    "q changed otherwise by 1e-3",
    "q changed a third time by 1e-3",
    "some contacts doubled",
    "other contacts doubled",
    "W unsymmetric by 1e-3",
    "W unsymmetric otherwise by 1e-3",
    "contacts added that stay open",
];

/// A problem as plain numbers.
struct Parts {
    size: usize,
    w: DMatrix<f64>,
    q: Vec<f64>,
    laws: Vec<ContactThresholds>,
}

/// The problem under change number `number`, from 0 to 19.
pub fn changed(problem: &ReducedProblem, number: usize) -> ReducedProblem {
    let mut parts = Parts::of(problem);
    let mut random = Random::new(number as u64, 24);
    match number {
        0 => parts.w *= 1e-6,
        1 => parts.w *= 1e6,
        2 => parts.stretch(1e6),
        3 => parts.stretch(1e-6),
        4 | 5 => parts.shuffle(&mut random),
        6 | 7 => parts.turn(&mut random),
        8..=11 => parts.times([0.1, 0.3, 2.0, 3.0][number - 8]),
        12..=14 => {
            let largest = parts.q.iter().fold(0.0_f64, |most, q| most.max(q.abs()));
            let mut by = || 1e-3 * largest * (2.0 * random.unit() - 1.0);
            parts.q.iter_mut().for_each(|q| *q += by());
        }
        15 | 16 => parts.double(&mut random),
        17 | 18 => {
            let mut by = || 1.0 + 1e-3 * (2.0 * random.unit() - 1.0);
            parts.w.iter_mut().for_each(|w| *w *= by());
        }
        _ => parts.add_open(5),
    }
    let entries: Vec<_> = (0..parts.q.len())
        .flat_map(|row| (0..parts.q.len()).map(move |column| (row, column)))
        .map(|(row, column)| (row, column, parts.w[(row, column)]))
        .filter(|entry| entry.2 != 0.0)
        .collect();
    let w = SparseMatrix::from_triplets([parts.q.len(); 2], &entries).expect("entries are inside");
    ReducedProblem::new(problem.layout(), w, parts.q, parts.laws).expect("the problem is valid")
}

impl Parts {
    fn of(problem: &ReducedProblem) -> Self {
        let count = problem.q().len();
        let mut w = DMatrix::zeros(count, count);
        for (row, column, value) in problem.w().triplets() {
            w[(row, column)] = value;
        }
        Self {
            size: problem.layout().size(),
            w,
            q: problem.q().to_vec(),
            laws: problem.laws().to_vec(),
        }
    }

    /// Lengths count `factor` times as many units: velocities too, spins do not.
    fn stretch(&mut self, factor: f64) {
        let size = self.size;
        let is_spin = |at: usize| at % size >= 3;
        for at in 0..self.q.len() {
            if is_spin(at) {
                // A torque is `factor` times as large.
                self.w.column_mut(at).scale_mut(factor.recip());
            } else {
                self.w.row_mut(at).scale_mut(factor);
                self.q[at] *= factor;
            }
        }
        for law in &mut self.laws {
            law.rolling *= factor;
            law.torsion *= factor;
        }
    }

    /// Takes contacts, some more than once, in this order.
    fn take(&mut self, order: &[usize]) {
        let size = self.size;
        let from: Vec<usize> = order
            .iter()
            .flat_map(|contact| contact * size..(contact + 1) * size)
            .collect();
        self.w = DMatrix::from_fn(from.len(), from.len(), |row, column| {
            self.w[(from[row], from[column])]
        });
        self.q = from.iter().map(|&at| self.q[at]).collect();
        self.laws = order.iter().map(|&contact| self.laws[contact]).collect();
    }

    fn shuffle(&mut self, random: &mut Random) {
        let mut order: Vec<usize> = (0..self.laws.len()).collect();
        for last in (1..order.len()).rev() {
            order.swap(last, (random.unit() * (last + 1) as f64) as usize);
        }
        self.take(&order);
    }

    /// Other tangents at every contact; a plane has no others.
    fn turn(&mut self, random: &mut Random) {
        if self.size < 3 {
            return;
        }
        for contact in 0..self.laws.len() {
            let turn = Rotation2::new(std::f64::consts::TAU * random.unit());
            let pairs = [1, 3].into_iter().filter(|first| first + 2 <= self.size);
            for at in pairs.map(|first| contact * self.size + first) {
                let turned = |pair: [f64; 2]| turn * Vector2::from(pair);
                let q = turned([self.q[at], self.q[at + 1]]);
                (self.q[at], self.q[at + 1]) = (q.x, q.y);
                for other in 0..self.q.len() {
                    let row = turned([self.w[(at, other)], self.w[(at + 1, other)]]);
                    (self.w[(at, other)], self.w[(at + 1, other)]) = (row.x, row.y);
                }
                for other in 0..self.q.len() {
                    let column = turned([self.w[(other, at)], self.w[(other, at + 1)]]);
                    (self.w[(other, at)], self.w[(other, at + 1)]) = (column.x, column.y);
                }
            }
        }
    }

    fn times(&mut self, factor: f64) {
        for law in &mut self.laws {
            law.sliding *= factor;
            law.rolling *= factor;
            law.torsion *= factor;
        }
    }

    fn double(&mut self, random: &mut Random) {
        let mut order: Vec<usize> = (0..self.laws.len()).collect();
        let again: Vec<usize> = order
            .iter()
            .copied()
            .filter(|_| random.unit() < 1.0 / 3.0)
            .collect();
        order.extend(again);
        self.take(&order);
    }

    /// Contacts that nothing else touches and that open.
    fn add_open(&mut self, count: usize) {
        let before = self.q.len();
        let largest = self.q.iter().fold(1.0_f64, |most, q| most.max(q.abs()));
        let after = before + count * self.size;
        let diagonal = self.w[(0, 0)];
        self.w = DMatrix::from_fn(after, after, |row, column| {
            if row < before && column < before {
                self.w[(row, column)]
            } else if row == column {
                diagonal
            } else {
                0.0
            }
        });
        for at in before..after {
            let is_normal = (at - before).is_multiple_of(self.size);
            self.q.push(if is_normal { largest } else { 0.1 * largest });
        }
        self.laws.extend(std::iter::repeat_n(self.laws[0], count));
    }
}
