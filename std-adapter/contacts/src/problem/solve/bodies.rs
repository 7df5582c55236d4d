//! The linear systems over the bodies' velocities instead of the contacts' impulses.
//!
//! With W = Hᵀ M⁻¹ H and Δv = M⁻¹ H Δr, the system B Δr + C W Δr = right becomes
//!
//! ```text
//! (M + H S Hᵀ) Δv = H B⁻¹ right,   S = B⁻¹ C,   Δr = B⁻¹ right − S Hᵀ Δv
//! ```
//!
//! with at most six unknowns a body. In packings it has fewer entries than W: all contacts of a body meet in W.

use super::super::global::{SourceBodies, components};
use super::super::matrix::SparseMatrix;
use super::blocks::Blocks;
use super::cone::{Local, MOST, Square, solve_small};
use super::factor::Lu;
use super::prepared::Prepared;
use super::system::Linear;

/// The part of H of one contact and one node.
#[derive(Clone, Copy, Debug)]
struct JacobianBlock {
    node: usize,
    /// First of its rows in [`Bodies::rows`], one for each degree of freedom of the node.
    start: usize,
}

/// M and H.
#[derive(Clone, Debug)]
pub(super) struct Bodies {
    /// M, with a block for all that contacts join.
    mass: Blocks,
    /// M⁻¹ of each node, by rows.
    inverse_mass: Vec<f64>,
    /// Nodes that each contact acts on: its first one in `arms`, and their number.
    starts: Vec<usize>,
    arms: Vec<JacobianBlock>,
    rows: Vec<Local>,
}

/// M + H S Hᵀ and its factors.
#[derive(Clone, Debug)]
pub(super) struct BodyFactorisation {
    matrix: Blocks,
    lu: Lu,
    /// B⁻¹ and S of each contact.
    inverses: Vec<(Square, Square)>,
}

impl Bodies {
    /// The bodies of a problem; `place` tells the contact, the unknown and its unit of each column
    /// of H that is left.
    pub fn new(
        made: &SourceBodies,
        contacts: usize,
        place: &[Option<(usize, usize, f64)>],
    ) -> Self {
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
        // Entries of H by contacts and nodes.
        let mut entries: Vec<(usize, usize, usize, usize, f64)> = h
            .triplets()
            .filter_map(|(row, column, value)| {
                let (contact, unknown, unit) = place[column]?;
                let (node, at) = home[row];
                Some((contact, node, at, unknown, value * unit))
            })
            .collect();
        entries.sort_unstable_by_key(|entry| (entry.0, entry.1));
        let (mut starts, mut arms, mut rows) = (vec![0], Vec::<JacobianBlock>::new(), Vec::new());
        for (contact, node, at, unknown, value) in entries {
            while starts.len() <= contact {
                starts.push(arms.len());
            }
            let begun = starts[contact];
            let start = match arms[begun..].last() {
                Some(arm) if arm.node == node => arm.start,
                _ => {
                    let start = rows.len();
                    arms.push(JacobianBlock { node, start });
                    rows.resize(start + nodes[node].len(), Local::default());
                    start
                }
            };
            rows[start + at][unknown] = value;
        }
        starts.resize(contacts + 1, arms.len());
        let mut joined: Vec<Vec<usize>> = (0..nodes.len()).map(|node| vec![node]).collect();
        for (row, column, value) in m.triplets() {
            if value != 0.0 {
                joined[home[row].0].push(home[column].0);
            }
        }
        for own in starts.windows(2).map(|ends| &arms[ends[0]..ends[1]]) {
            for arm in own {
                joined[arm.node].extend(own.iter().map(|other| other.node));
            }
        }
        for row in &mut joined {
            row.sort_unstable();
            row.dedup();
        }
        let mut mass = Blocks::zeros(first, &joined);
        for (row, column, value) in m.triplets() {
            let ((a, at), (b, to)) = (home[row], home[column]);
            if let Some(number) = mass.find(a, b) {
                let width = mass.size(b);
                mass.block_mut(number)[at * width + to] += value;
            }
        }
        let mut places = vec![0];
        for node in &nodes {
            places.push(places.last().copied().unwrap_or(0) + node.len() * node.len());
        }
        let mut inverse_mass = vec![0.0; places.last().copied().unwrap_or(0)];
        for body in &made.bodies.all {
            for (a, &row) in body.freedoms.iter().enumerate() {
                for (b, &column) in body.freedoms.iter().enumerate() {
                    let ((node, at), (_, to)) = (home[row], home[column]);
                    inverse_mass[places[node] + at * nodes[node].len() + to] = body.inverse[(a, b)];
                }
            }
        }
        Self {
            mass,
            inverse_mass,
            starts,
            arms,
            rows,
        }
    }

    /// Nodes that a contact acts on, with the part of H of each.
    fn arms(&self, contact: usize) -> impl Iterator<Item = (usize, &[Local])> + Clone {
        let own = &self.arms[self.starts[contact]..self.starts[contact + 1]];
        own.iter().map(|arm| {
            let end = arm.start + self.mass.size(arm.node);
            (arm.node, &self.rows[arm.start..end])
        })
    }

    /// Adds H r of one contact.
    fn push(&self, contact: usize, r: &Local, momenta: &mut [f64]) {
        for (node, rows) in self.arms(contact) {
            let start = self.mass.first[node];
            for (momentum, row) in momenta[start..].iter_mut().zip(rows) {
                *momentum += dot(row, r);
            }
        }
    }

    /// Hᵀ times velocities, at one contact.
    fn relative(&self, contact: usize, speeds: &[f64]) -> Local {
        let mut velocity = Local::default();
        for (node, rows) in self.arms(contact) {
            let start = self.mass.first[node];
            for (v, row) in speeds[start..].iter().zip(rows) {
                for (velocity, entry) in velocity.iter_mut().zip(row) {
                    *velocity += entry * v;
                }
            }
        }
        velocity
    }

    /// W times a vector, as Hᵀ M⁻¹ H: what heavy bodies receive does not hide what light ones do.
    pub fn apply(&self, problem: &Prepared, vector: &[f64], out: &mut [f64]) {
        let mut momenta = vec![0.0; self.mass.unknowns()];
        for contact in 0..problem.contacts() {
            self.push(contact, &problem.local(contact, vector), &mut momenta);
        }
        let mut speeds = Vec::with_capacity(momenta.len());
        let mut inverse = self.inverse_mass.as_slice();
        for ends in self.mass.first.windows(2) {
            let part = &momenta[ends[0]..ends[1]];
            let (own, rest) = inverse.split_at(part.len() * part.len());
            inverse = rest;
            for row in own.chunks_exact(part.len()) {
                speeds.push(row.iter().zip(part).map(|(a, b)| a * b).sum::<f64>());
            }
        }
        for contact in 0..problem.contacts() {
            problem.put(contact, &self.relative(contact, &speeds), out);
        }
    }
}

impl BodyFactorisation {
    /// Prepares factorisations.
    pub fn new(bodies: &Bodies) -> Self {
        Self {
            lu: Lu::new(&bodies.mass),
            inverses: vec![Default::default(); bodies.starts.len() - 1],
            matrix: bodies.mass.clone(),
        }
    }

    /// Multiplications of a factorisation.
    pub fn cost(&self) -> f64 {
        self.lu.cost()
    }

    pub fn factorise(&mut self, bodies: &Bodies, problem: &Prepared, linear: &[Linear]) {
        self.matrix.values.copy_from_slice(&bodies.mass.values);
        let mut moved: Vec<Local> = Vec::new();
        for (contact, own) in linear.iter().enumerate() {
            let size = problem.w.size(contact);
            let inverse = invert(&own.impulse, size);
            let schur = match &own.velocity {
                Some(velocity) => product(&inverse, velocity, size),
                None => inverse,
            };
            self.inverses[contact] = (inverse, schur);
            for (a, rows) in bodies.arms(contact) {
                moved.clear();
                moved.extend(rows.iter().map(|row| row_times(row, &schur, size)));
                for (b, others) in bodies.arms(contact) {
                    let Some(number) = self.matrix.find(a, b) else {
                        continue;
                    };
                    let block = self.matrix.block_mut(number);
                    for (line, left) in block.chunks_exact_mut(others.len()).zip(&moved) {
                        for (entry, right) in line.iter_mut().zip(others) {
                            *entry += dot(left, right);
                        }
                    }
                }
            }
        }
        self.lu.factorise(&self.matrix);
    }

    pub fn solve(&self, bodies: &Bodies, problem: &Prepared, vector: &mut [f64]) {
        let mut momenta = vec![0.0; self.matrix.unknowns()];
        for (contact, (inverse, _)) in self.inverses.iter().enumerate() {
            let moved = times(inverse, &problem.local(contact, vector));
            problem.put(contact, &moved, vector);
            bodies.push(contact, &moved, &mut momenta);
        }
        self.lu.solve(&mut momenta);
        for (contact, (_, schur)) in self.inverses.iter().enumerate() {
            let moved = problem.local(contact, vector);
            let change = times(schur, &bodies.relative(contact, &momenta));
            problem.put(
                contact,
                &std::array::from_fn(|at| moved[at] - change[at]),
                vector,
            );
        }
    }
}

/// Degrees of freedom that M joins, and those among these parts that the same contacts act on.
fn nodes(
    m: &SparseMatrix,
    h: &SparseMatrix,
    place: &[Option<(usize, usize, f64)>],
) -> Vec<Vec<usize>> {
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
