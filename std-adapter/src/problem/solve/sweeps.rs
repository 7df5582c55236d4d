//! Gauss–Seidel sweeps with momentum over the contacts.
//!
//! The iteration of [`crate::cd::internals::Accelerated`], on a matrix: every contact in turn is solved exactly
//! with all others held; the next sweep starts from a point extrapolated along the last step.

use super::cone::{Local, Square};
use super::local::{Own, solve_contact};
use super::prepared::Prepared;

/// Factor that a restart applies to the age of the momentum.
const LEFT: f64 = 0.5;

/// Measured time of a contact's own solution, in multiplications.
const A_CONTACT: f64 = 400.0;

/// Impulses and momentum.
#[derive(Clone, Debug)]
pub(super) struct Sweeps {
    /// Impulses after the last sweep.
    pub r: Vec<f64>,
    /// Those that the next sweep starts from.
    start: Vec<f64>,
    age: f64,
    diagonal: Vec<Own>,
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
                Own::new(square, size)
            })
            .collect();
        Self {
            start: r.clone(),
            r,
            age: 1.0,
            diagonal,
        }
    }

    /// Time of a sweep, in multiplications.
    pub fn cost(problem: &Prepared) -> f64 {
        problem.w.values.len() as f64 + A_CONTACT * problem.contacts() as f64
    }

    /// One sweep.
    pub fn sweep(&mut self, problem: &Prepared) {
        let mut now = self.start.clone();
        let mut along = 0.0;
        for (contact, cone) in problem.cones.iter().enumerate() {
            let size = cone.size();
            let mut u = problem.local(contact, &problem.q);
            problem.w.add_row_product(contact, &now, &mut u[..size]);
            let (old, own) = (problem.local(contact, &now), &self.diagonal[contact]);
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
            problem.put(contact, &new, &mut now);
        }
        self.extrapolate(problem, &now, along);
        self.r = now;
    }

    /// Sets the start of the next sweep, from the impulses `now` and those of the sweep before.
    fn extrapolate(&mut self, problem: &Prepared, now: &[f64], along: f64) {
        if along < 0.0 {
            self.age = (LEFT * self.age).max(1.0);
            self.start.copy_from_slice(now);
            return;
        }
        let older = 0.5 * (1.0 + (1.0 + 4.0 * self.age * self.age).sqrt());
        let beta = (self.age - 1.0) / older;
        self.age = older;
        for (contact, cone) in problem.cones.iter().enumerate() {
            let (now, before) = (problem.local(contact, now), problem.local(contact, &self.r));
            let ahead: Local = std::array::from_fn(|at| now[at] + beta * (now[at] - before[at]));
            let start = cone.project(&ahead).point;
            problem.put(contact, &start, &mut self.start);
        }
    }
}
