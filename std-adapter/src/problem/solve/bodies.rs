//! The linear systems over the bodies' velocities instead of the contacts' impulses.
//!
//! With W = Hᵀ M⁻¹ H and Δv = M⁻¹ H Δr, the system B Δr + C W Δr = right becomes
//!
//! ```text
//! (M + H S Hᵀ) Δv = H B⁻¹ right,   S = B⁻¹ C,   Δr = B⁻¹ right − S Hᵀ Δv
//! ```
//!
//! with at most six unknowns a body. In packings it has fewer entries than W: all contacts of a body meet in W.

use super::super::global::{Made, components};
use super::super::matrix::Matrix;
use super::blocks::Blocks;
use super::cone::{Local, MOST, Square, solve_small};
use super::factor::Lu;
use super::prepared::Prepared;
use super::system::Linear;

/// The part of H of one contact and one node: rows are the node's degrees of freedom.
#[derive(Clone, Debug)]
struct Arm {
    node: usize,
    rows: Vec<Local>,
}

/// M, H and the factors.
#[derive(Clone, Debug)]
pub(super) struct Bodies {
    /// M + H S Hᵀ.
    matrix: Blocks,
    /// M in the same pattern.
    mass: Vec<f64>,
    /// Nodes that each contact acts on.
    arms: Vec<Vec<Arm>>,
    /// B⁻¹ and S of each contact.
    inverses: Vec<(Square, Square)>,
    lu: Lu,
    /// M⁻¹ of each node, by rows.
    inverse_mass: Vec<Vec<f64>>,
}

impl Bodies {
    /// The bodies of a problem; `place` tells the contact, the unknown and its unit of each column
    /// of H that is left.
    pub fn new(made: &Made, contacts: usize, place: &[Option<(usize, usize, f64)>]) -> Self {
        let (m, h) = (made.global.m(), made.global.h());
        let nodes = nodes(m, h, place);
        let mut first = vec![0];
        let mut home = vec![(0, 0); m.rows()];
        for (node, freedoms) in nodes.iter().enumerate() {
            for (at, &freedom) in freedoms.iter().enumerate() {
                home[freedom] = (node, at);
            }
            first.push(first[node] + freedoms.len());
        }
        let mut arms: Vec<Vec<Arm>> = vec![Vec::new(); contacts];
        for (row, column, value) in h.triplets() {
            let Some((contact, unknown, unit)) = place[column] else {
                continue;
            };
            let (node, at) = home[row];
            let own = &mut arms[contact];
            let number = own
                .iter()
                .position(|arm| arm.node == node)
                .unwrap_or_else(|| {
                    let rows = vec![Local::default(); nodes[node].len()];
                    own.push(Arm { node, rows });
                    own.len() - 1
                });
            own[number].rows[at][unknown] = value * unit;
        }
        let mut rows: Vec<Vec<usize>> = (0..nodes.len()).map(|node| vec![node]).collect();
        for (row, column, value) in m.triplets() {
            if value != 0.0 {
                rows[home[row].0].push(home[column].0);
            }
        }
        for own in &arms {
            for arm in own {
                rows[arm.node].extend(own.iter().map(|other| other.node));
            }
        }
        for row in &mut rows {
            row.sort_unstable();
            row.dedup();
        }
        let mut matrix = Blocks::zeros(first, &rows);
        for (row, column, value) in m.triplets() {
            let ((a, at), (b, to)) = (home[row], home[column]);
            if let Some(number) = matrix.find(a, b) {
                let width = matrix.size(b);
                matrix.block_mut(number)[at * width + to] += value;
            }
        }
        let mut inverse_mass: Vec<Vec<f64>> = nodes
            .iter()
            .map(|node| vec![0.0; node.len() * node.len()])
            .collect();
        for body in &made.bodies.all {
            for (a, &row) in body.freedoms.iter().enumerate() {
                for (b, &column) in body.freedoms.iter().enumerate() {
                    let ((node, at), (_, to)) = (home[row], home[column]);
                    inverse_mass[node][at * nodes[node].len() + to] = body.inverse[(a, b)];
                }
            }
        }
        Self {
            inverse_mass,
            mass: matrix.values.clone(),
            lu: Lu::new(&matrix),
            inverses: vec![Default::default(); contacts],
            arms,
            matrix,
        }
    }

    /// Multiplications of a factorisation.
    pub fn cost(&self) -> f64 {
        self.lu.cost()
    }

    /// W times a vector, as Hᵀ M⁻¹ H: what heavy bodies receive does not hide what light ones do.
    pub fn apply(&self, problem: &Prepared, vector: &[f64], out: &mut [f64]) {
        let mut momenta = vec![0.0; self.matrix.unknowns()];
        for (contact, arms) in self.arms.iter().enumerate() {
            let r = problem.local(contact, vector);
            for arm in arms {
                let start = self.matrix.first[arm.node];
                for (momentum, row) in momenta[start..].iter_mut().zip(&arm.rows) {
                    *momentum += dot(row, &r);
                }
            }
        }
        let mut speeds = Vec::with_capacity(momenta.len());
        for (node, inverse) in self.inverse_mass.iter().enumerate() {
            let part = &momenta[self.matrix.first[node]..self.matrix.first[node + 1]];
            for row in inverse.chunks_exact(part.len()) {
                speeds.push(row.iter().zip(part).map(|(a, b)| a * b).sum::<f64>());
            }
        }
        for (contact, arms) in self.arms.iter().enumerate() {
            problem.put(contact, &self.relative(arms, &speeds), out);
        }
    }

    /// Hᵀ times velocities, at one contact.
    fn relative(&self, arms: &[Arm], speeds: &[f64]) -> Local {
        let mut velocity = Local::default();
        for arm in arms {
            let start = self.matrix.first[arm.node];
            for (v, row) in speeds[start..].iter().zip(&arm.rows) {
                for (velocity, entry) in velocity.iter_mut().zip(row) {
                    *velocity += entry * v;
                }
            }
        }
        velocity
    }

    pub fn factorise(&mut self, problem: &Prepared, linear: &[Linear]) {
        self.matrix.values.copy_from_slice(&self.mass);
        for (contact, own) in linear.iter().enumerate() {
            let size = problem.w.size(contact);
            let inverse = invert(&own.impulse, size);
            let schur = match &own.velocity {
                Some(velocity) => product(&inverse, velocity, size),
                None => inverse,
            };
            self.inverses[contact] = (inverse, schur);
            for a in &self.arms[contact] {
                let moved: Vec<Local> = a
                    .rows
                    .iter()
                    .map(|row| row_times(row, &schur, size))
                    .collect();
                for b in &self.arms[contact] {
                    let Some(number) = self.matrix.find(a.node, b.node) else {
                        continue;
                    };
                    let block = self.matrix.block_mut(number);
                    for (line, left) in block.chunks_exact_mut(b.rows.len()).zip(&moved) {
                        for (entry, right) in line.iter_mut().zip(&b.rows) {
                            *entry += dot(left, right);
                        }
                    }
                }
            }
        }
        self.lu.factorise(&self.matrix);
    }

    pub fn solve(&self, problem: &Prepared, vector: &mut [f64]) {
        let mut momenta = vec![0.0; self.matrix.unknowns()];
        for (contact, (inverse, _)) in self.inverses.iter().enumerate() {
            let moved = times(inverse, &problem.local(contact, vector));
            problem.put(contact, &moved, vector);
            for arm in &self.arms[contact] {
                let start = self.matrix.first[arm.node];
                for (momentum, row) in momenta[start..].iter_mut().zip(&arm.rows) {
                    *momentum += dot(row, &moved);
                }
            }
        }
        self.lu.solve(&mut momenta);
        for (contact, (_, schur)) in self.inverses.iter().enumerate() {
            let velocity = self.relative(&self.arms[contact], &momenta);
            let moved = problem.local(contact, vector);
            let change = times(schur, &velocity);
            problem.put(
                contact,
                &std::array::from_fn(|at| moved[at] - change[at]),
                vector,
            );
        }
    }
}

/// Degrees of freedom that M joins, and those among these parts that the same contacts act on.
fn nodes(m: &Matrix, h: &Matrix, place: &[Option<(usize, usize, f64)>]) -> Vec<Vec<usize>> {
    let mut parts: Vec<(Vec<usize>, Vec<usize>)> = components(m)
        .into_iter()
        .map(|freedoms| {
            let mut contacts: Vec<usize> = freedoms
                .iter()
                .flat_map(|&row| h.row(row))
                .filter_map(|&(column, _)| place[column].map(|at| at.0))
                .collect();
            contacts.sort_unstable();
            contacts.dedup();
            (contacts, freedoms)
        })
        .collect();
    parts.sort();
    let mut all: Vec<Vec<usize>> = Vec::new();
    let mut last: Option<Vec<usize>> = None;
    for (contacts, freedoms) in parts {
        match all.last_mut() {
            Some(node) if last.as_ref() == Some(&contacts) && !contacts.is_empty() => {
                node.extend(freedoms);
            }
            _ => all.push(freedoms),
        }
        last = Some(contacts);
    }
    all
}

fn dot(a: &Local, b: &Local) -> f64 {
    ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5])
}

fn times(square: &Square, vector: &Local) -> Local {
    square.map(|row| dot(&row, vector))
}

fn row_times(row: &Local, square: &Square, size: usize) -> Local {
    let mut out = Local::default();
    for (factor, line) in row.iter().zip(square).take(size) {
        for (out, entry) in out.iter_mut().zip(line) {
            *out += factor * entry;
        }
    }
    out
}

fn product(a: &Square, b: &Square, size: usize) -> Square {
    a.map(|row| row_times(&row, b, size))
}

/// The inverse of the first `size` rows and columns; zero for a singular square, which then has no effect.
fn invert(square: &Square, size: usize) -> Square {
    let mut inverse = Square::default();
    for column in 0..size {
        let mut unit = Local::default();
        unit[column] = 1.0;
        let Some(solved) = solve_small(*square, unit, size) else {
            return Square::default();
        };
        for (row, value) in solved.into_iter().enumerate().take(MOST) {
            inverse[row][column] = value;
        }
    }
    inverse
}
