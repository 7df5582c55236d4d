//! Projected gradients with Nesterov's momentum.
//!
//! y' = P_K(y − t ũ(y)), extrapolated along the last step, with the step length t found by backtracking and the
//! momentum reset where it leads back (Mazhar, Heyn, Negrut and Tasora, ACM Trans. Graph. 34 (2015) 32). Unlike
//! theirs, the normal velocity has De Saxcé's correction, so that slip does not open contacts. No factorisation and no
//! pass in sequence: one product with W an iteration.

use super::cone::Local;
use super::prepared::Prepared;

/// Growth of the step length in an iteration, and its cut where the step is too long.
const GROWTH: f64 = 1.1;
const CUT: f64 = 0.5;
/// Cuts in one iteration.
const MOST_CUTS: usize = 60;

/// Impulses and momentum.
#[derive(Clone, Debug)]
pub(super) struct Gradient {
    /// Impulses after the last iteration.
    pub r: Vec<f64>,
    /// W times them.
    moved: Vec<f64>,
    /// The point that the next iteration starts from, and W times it.
    start: Vec<f64>,
    start_moved: Vec<f64>,
    /// Buffers.
    next: Vec<f64>,
    next_moved: Vec<f64>,
    step: f64,
    age: f64,
}

impl Gradient {
    pub fn new(problem: &Prepared, r: Vec<f64>) -> Self {
        let mut moved = vec![0.0; r.len()];
        problem.apply(&r, &mut moved);
        Self {
            start: r.clone(),
            start_moved: moved.clone(),
            next: r.clone(),
            next_moved: moved.clone(),
            moved,
            r,
            step: 1.0,
            age: 1.0,
        }
    }

    /// One iteration.
    pub fn advance(&mut self, problem: &Prepared) {
        for _ in 0..MOST_CUTS {
            self.project(problem);
            problem.apply(&self.next, &mut self.next_moved);
            // Along the step, W must not exceed 1/t.
            let (mut along, mut size_sq) = (0.0, 0.0);
            for at in 0..self.next.len() {
                let change = self.next[at] - self.start[at];
                along += change * (self.next_moved[at] - self.start_moved[at]);
                size_sq += change * change;
            }
            if along * self.step <= size_sq {
                break;
            }
            self.step *= CUT;
        }
        let mut back = 0.0;
        for at in 0..self.next.len() {
            back += (self.start[at] - self.next[at]) * (self.next[at] - self.r[at]);
        }
        let older = 0.5 * (1.0 + (1.0 + 4.0 * self.age * self.age).sqrt());
        let beta = if back > 0.0 {
            0.0
        } else {
            (self.age - 1.0) / older
        };
        self.age = if back > 0.0 { 1.0 } else { older };
        for at in 0..self.next.len() {
            self.start[at] = self.next[at] + beta * (self.next[at] - self.r[at]);
            self.start_moved[at] =
                self.next_moved[at] + beta * (self.next_moved[at] - self.moved[at]);
        }
        std::mem::swap(&mut self.r, &mut self.next);
        std::mem::swap(&mut self.moved, &mut self.next_moved);
        self.step *= GROWTH;
    }

    /// Sets the next impulses: a step along −ũ from the start, projected.
    fn project(&mut self, problem: &Prepared) {
        for (contact, cone) in problem.cones.iter().enumerate() {
            let start = problem.local(contact, &self.start);
            let moved = problem.local(contact, &self.start_moved);
            let q = problem.local(contact, &problem.q);
            let u: Local = std::array::from_fn(|at| moved[at] + q[at]);
            let corrected = cone.corrected(&u);
            let trial: Local = std::array::from_fn(|at| start[at] - self.step * corrected[at]);
            problem.put(contact, &cone.project(&trial).point, &mut self.next);
        }
    }
}
