//! The set of impulses of a contact: discs and balls whose radii grow with one normal impulse.
//!
//! K = {(P, r₁, r₂, …): |r_k| ≤ m_k P}, with one r_k for each mode (sliding, rolling, torsion) that has a
//! threshold m_k > 0. All cones of a contact share P.

use std::ops::Range;

/// Most unknowns of a contact: normal, two of sliding, two of rolling, torsion.
pub(super) const MOST: usize = 6;
/// Most modes of a contact.
pub(super) const MODES: usize = 3;

/// Unknowns of a contact; those beyond its number are zero.
pub(super) type Local = [f64; MOST];
/// Square matrix of a contact, by rows.
pub(super) type Square = [[f64; MOST]; MOST];

/// One mode: its unknowns, and its threshold over P.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mode {
    pub start: usize,
    pub end: usize,
    pub threshold: f64,
}

impl Mode {
    pub fn range(&self) -> Range<usize> {
        self.start..self.end
    }

    /// Length of the mode's part of a vector.
    pub fn length(&self, vector: &Local) -> f64 {
        let part = &vector[self.range()];
        match part {
            [one] => one.abs(),
            _ => part.iter().map(|x| x * x).sum::<f64>().sqrt(),
        }
    }
}

/// Modes of a contact.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cone {
    modes: [Mode; MODES],
    count: usize,
}

/// Where a projection ends.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Projection {
    pub point: Local,
    /// Whether the nearest point is the apex.
    pub apex: bool,
    /// Modes that are at their thresholds, and lengths of the projected vector's parts.
    slips: [bool; MODES],
    lengths: [f64; MODES],
}

impl Cone {
    /// Adds a mode of `size` unknowns after those there are.
    pub fn push(&mut self, size: usize, threshold: f64) {
        let start = self.size();
        self.modes[self.count] = Mode {
            start,
            end: start + size,
            threshold,
        };
        self.count += 1;
    }

    pub fn modes(&self) -> &[Mode] {
        &self.modes[..self.count]
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.modes().last().map_or(1, |mode| mode.end)
    }

    /// μ of a contact whose only mode is sliding in two directions.
    #[inline]
    pub fn sliding_alone(&self) -> Option<f64> {
        match self.modes() {
            [mode] if mode.end == 3 => Some(mode.threshold),
            _ => None,
        }
    }

    /// The velocity with De Saxcé's correction: ũ_N = u_N + Σ m_k |u_k|.
    pub fn corrected(&self, velocity: &Local) -> Local {
        let mut corrected = *velocity;
        for mode in self.modes() {
            corrected[0] += mode.threshold * mode.length(velocity);
        }
        corrected
    }

    /// The nearest point of K.
    ///
    /// P is the zero of (P − n) − Σ m_k max(|x_k| − m_k P, 0), which grows with P. With more modes taken to
    /// slip than do, the zero comes out too small: modes that do not slip there do not slip at all.
    pub fn project(&self, vector: &Local) -> Projection {
        let mut end = Projection::default();
        let mut slope = 1.0;
        let mut sum = vector[0];
        for (number, mode) in self.modes().iter().enumerate() {
            let length = mode.length(vector);
            end.lengths[number] = length;
            end.slips[number] = true;
            slope += mode.threshold * mode.threshold;
            sum += mode.threshold * length;
        }
        if sum <= 0.0 {
            end.apex = true;
            return end;
        }
        for _ in 0..self.count {
            let normal = sum / slope;
            for (number, mode) in self.modes().iter().enumerate() {
                if end.slips[number] && end.lengths[number] <= mode.threshold * normal {
                    end.slips[number] = false;
                    slope -= mode.threshold * mode.threshold;
                    sum -= mode.threshold * end.lengths[number];
                }
            }
        }
        let sticks = !end.slips.contains(&true);
        let normal = if sticks { vector[0] } else { sum / slope };
        end.point = *vector;
        end.point[0] = normal;
        for (number, mode) in self.modes().iter().enumerate() {
            if end.slips[number] {
                let factor = mode.threshold * normal / end.lengths[number];
                end.point[mode.range()]
                    .iter_mut()
                    .for_each(|x| *x *= factor);
            }
        }
        end
    }

    /// Derivative of the projection of `vector`, which led to `end`.
    pub fn derivative(&self, vector: &Local, end: &Projection) -> Square {
        let mut square = Square::default();
        if end.apex {
            return square;
        }
        let size = self.size();
        for (number, row) in square.iter_mut().enumerate().take(size) {
            row[number] = 1.0;
        }
        let slips = |number: usize| end.slips[number];
        let slipping = || {
            self.modes()
                .iter()
                .enumerate()
                .filter(|(number, _)| slips(*number))
        };
        let slope = 1.0
            + slipping()
                .map(|(_, mode)| mode.threshold * mode.threshold)
                .sum::<f64>();
        // Change of P with each unknown.
        let mut normal = [0.0; MOST];
        normal[0] = 1.0 / slope;
        for (number, mode) in slipping() {
            for at in mode.range() {
                normal[at] = mode.threshold * vector[at] / (end.lengths[number] * slope);
            }
        }
        square[0] = normal;
        for (number, mode) in slipping() {
            let length = end.lengths[number];
            let turn = mode.threshold * end.point[0] / length;
            for at in mode.range() {
                let along = vector[at] / length;
                for other in 0..size {
                    square[at][other] = mode.threshold * along * normal[other];
                }
                for other in mode.range() {
                    let same = f64::from(u8::from(at == other));
                    square[at][other] += turn * (same - along * vector[other] / length);
                }
            }
        }
        square
    }
}

/// Solves a dense system of the first `size` unknowns by elimination with exchanges of rows; `None` if the
/// matrix is singular.
pub(super) fn solve_small(mut matrix: Square, mut right: Local, size: usize) -> Option<Local> {
    for step in 0..size {
        let best = (step..size).reduce(|best, row| {
            if matrix[row][step].abs() > matrix[best][step].abs() {
                row
            } else {
                best
            }
        })?;
        matrix.swap(step, best);
        right.swap(step, best);
        let pivot = matrix[step][step];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        for row in step + 1..size {
            let factor = matrix[row][step] / pivot;
            if factor != 0.0 {
                let source = matrix[step];
                for (entry, above) in matrix[row].iter_mut().zip(source).take(size).skip(step) {
                    *entry -= factor * above;
                }
                right[row] -= factor * right[step];
            }
        }
    }
    for step in (0..size).rev() {
        let known: f64 = (step + 1..size)
            .map(|column| matrix[step][column] * right[column])
            .sum();
        right[step] = (right[step] - known) / matrix[step][step];
    }
    Some(right)
}
