//! Gauss–Seidel sweeps with momentum over the contacts.
//!
//! The iteration of [`crate::cd::internals::Accelerated`], on a matrix: every contact in turn is solved exactly
//! with all others held; the next sweep starts from a point extrapolated along the last step.

use super::cone::{Cone, Local, Square};
use super::delassus_block::{DelassusBlock, solve_contact, solve_three};
use super::prepared::Prepared;

/// Factor that a restart applies to the age of the momentum.
const LEFT: f64 = 0.5;

/// Measured times of a contact's own solution, in multiplications of a factorisation: without friction, with sliding
/// alone, with other modes; and of an entry of W.
const FRICTIONLESS: f64 = 50.0;
const SLIDING: f64 = 300.0;
const ITERATED: f64 = 3000.0;
const AN_ENTRY: f64 = 0.5;

/// Impulses and momentum.
#[derive(Clone, Debug)]
pub(super) struct Sweeps {
    /// Impulses after the last sweep.
    pub r: Vec<f64>,
    /// Those that the next sweep starts from.
    start: Vec<f64>,
    /// Those of the sweep at hand.
    now: Vec<f64>,
    age: f64,
    diagonal: Vec<DelassusBlock>,
}

impl Sweeps {
    pub fn new(problem: &Prepared, r: Vec<f64>) -> Self {
        let diagonal = (0..problem.contacts())
            .map(|contact| {
                let mut square = Square::default();
                let size = problem.w.size(contact);
                if let Some(number) = problem.w.find(contact, contact) {
                    for (row, values) in problem.w.block(number).chunks_exact(size).enumerate() {
                        square[row][..size].copy_from_slice(values);
                    }
                }
                DelassusBlock::new(square, size)
            })
            .collect();
        Self {
            start: r.clone(),
            now: r.clone(),
            r,
            age: 1.0,
            diagonal,
        }
    }

    /// Time of a sweep, in multiplications.
    pub fn cost(problem: &Prepared) -> f64 {
        let of = |cone: &Cone| match cone.sliding_alone() {
            Some(_) => SLIDING,
            None if cone.size() == 1 => FRICTIONLESS,
            None => ITERATED,
        };
        let contacts: f64 = problem.cones.iter().map(of).sum();
        AN_ENTRY * problem.w.values.len() as f64 + contacts
    }

    /// One sweep.
    pub fn sweep(&mut self, problem: &Prepared) {
        self.now.copy_from_slice(&self.start);
        let now = &mut self.now;
        let mut along = 0.0;
        for (contact, cone) in problem.cones.iter().enumerate() {
            let own = &self.diagonal[contact];
            if let Some(mu) = cone.sliding_alone() {
                along += slide_three(problem, contact, (mu, own), &self.r, now);
                continue;
            }
            let size = cone.size();
            let mut u = problem.local(contact, &problem.q);
            problem.w.add_row_product(contact, now, &mut u[..size]);
            let old = problem.local(contact, now);
            // Velocity without the contact's own impulse.
            let mut free = u;
            for (free, row) in free.iter_mut().zip(&own.w).take(size) {
                *free -= row.iter().zip(&old).map(|(w, r)| w * r).sum::<f64>();
            }
            let new = solve_contact(cone, own, &free, &old);
            let before: Local = problem.local(contact, &self.r);
            for at in 0..size {
                along += (new[at] - old[at]) * (old[at] - before[at]);
            }
            problem.put(contact, &new, now);
        }
        self.extrapolate(problem, along);
        std::mem::swap(&mut self.r, &mut self.now);
    }

    /// Sets the start of the next sweep, from the impulses now and those of the sweep before.
    fn extrapolate(&mut self, problem: &Prepared, along: f64) {
        if along < 0.0 {
            self.age = (LEFT * self.age).max(1.0);
            self.start.copy_from_slice(&self.now);
            return;
        }
        let older = 0.5 * (1.0 + (1.0 + 4.0 * self.age * self.age).sqrt());
        let beta = (self.age - 1.0) / older;
        self.age = older;
        for (contact, cone) in problem.cones.iter().enumerate() {
            if let Some(mu) = cone.sliding_alone() {
                let at = problem.w.first[contact];
                let ahead = |at: usize| self.now[at] + beta * (self.now[at] - self.r[at]);
                let start = nearest_three(mu, [ahead(at), ahead(at + 1), ahead(at + 2)]);
                self.start[at..at + 3].copy_from_slice(&start);
                continue;
            }
            let (now, before) = (
                problem.local(contact, &self.now),
                problem.local(contact, &self.r),
            );
            let ahead: Local = std::array::from_fn(|at| now[at] + beta * (now[at] - before[at]));
            problem.put(contact, &cone.project(&ahead).point, &mut self.start);
        }
    }
}

/// Solves a contact with two components of sliding and no other mode. Returns the product of this change and the one that led
/// to `now` from the sweep before.
#[inline]
fn slide_three(
    problem: &Prepared,
    contact: usize,
    (mu, own): (f64, &DelassusBlock),
    swept: &[f64],
    now: &mut [f64],
) -> f64 {
    let at = problem.w.first[contact];
    let three = |vector: &[f64]| [vector[at], vector[at + 1], vector[at + 2]];
    let (old, before) = (three(now), three(swept));
    let mut free = three(&problem.q);
    problem.w.add_row_product(contact, now, &mut free);
    // Velocity without the contact's own impulse.
    for (free, w) in free.iter_mut().zip(&own.w) {
        *free -= w[0] * old[0] + w[1] * old[1] + w[2] * old[2];
    }
    let new = solve_three(mu, own, free);
    now[at..at + 3].copy_from_slice(&new);
    let along = |at: usize| (new[at] - old[at]) * (old[at] - before[at]);
    along(0) + along(1) + along(2)
}

/// The nearest point of |r_T| ≤ μ r_N.
#[inline]
fn nearest_three(mu: f64, [n, a, b]: [f64; 3]) -> [f64; 3] {
    let length = (a * a + b * b).sqrt();
    if length <= mu * n {
        return [n, a, b];
    }
    let normal = (n + mu * length) / (1.0 + mu * mu);
    if normal <= 0.0 {
        return [0.0; 3];
    }
    let factor = mu * normal / length;
    [normal, a * factor, b * factor]
}
