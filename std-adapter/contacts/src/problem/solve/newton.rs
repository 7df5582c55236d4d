//! Semismooth Newton iterations on the natural map.
//!
//! F(r) = r − P_K(r − ũ(r)) has a derivative almost everywhere; steps are halved until |F| falls (Armijo).
//! Near a solution they converge quadratically, far from it they often stall.
//! Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353, took the map with u in place of ũ.

use super::natural::{linearised, map};
use super::prepared::Prepared;
use super::system::{Linear, System};

/// Added to W in the derivative, in scaled unknowns: most W have no full rank.
const SHIFT: f64 = 1e-9;
/// Least part of the foreseen decrease of |F| that a step must reach.
const DECREASE: f64 = 1e-4;
/// A problem with W + a I in place of W and q − a r₀ in place of q: its solution stays near r₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProximalProblem<'a> {
    pub weight: f64,
    pub centre: &'a [f64],
}

/// What an iteration may cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct CostLimit {
    /// Steps, each with a factorisation.
    pub steps: usize,
    /// Halvings of a step before the iteration gives up.
    pub halvings: usize,
}

impl ProximalProblem<'static> {
    /// The problem itself.
    pub const NOTHING: Self = Self {
        weight: 0.0,
        centre: &[],
    };
}

impl ProximalProblem<'_> {
    /// Adds a (r − r₀) to velocities.
    fn add(&self, r: &[f64], u: &mut [f64]) {
        if self.weight > 0.0 {
            for ((u, r), centre) in u.iter_mut().zip(r).zip(self.centre) {
                *u += self.weight * (r - centre);
            }
        }
    }
}

/// Iterates from r until the map is at most `goal` · |r|, with at most this effort. Tells whether it is.
pub(super) fn newton(
    problem: &Prepared,
    system: &mut System,
    near: ProximalProblem<'_>,
    r: &mut Vec<f64>,
    (goal, most): (f64, CostLimit),
) -> bool {
    let mut u = vec![0.0; r.len()];
    let mut value = vec![0.0; r.len()];
    let mut linear = vec![Linear::default(); problem.contacts()];
    let mut size = evaluate(problem, near, r, &mut u, &mut value);
    for _ in 0..most.steps {
        if !size.is_finite() {
            return false;
        }
        if size <= goal * norm(r) {
            return true;
        }
        let shift = SHIFT.max(near.weight);
        for (contact, cone) in problem.cones.iter().enumerate() {
            let (r, u) = (problem.local(contact, r), problem.local(contact, &u));
            let (_, mut impulse, velocity) = linearised(cone, &r, &u);
            for (row, velocity) in impulse.iter_mut().zip(&velocity) {
                for (entry, velocity) in row.iter_mut().zip(velocity) {
                    *entry += shift * velocity;
                }
            }
            linear[contact] = Linear {
                impulse,
                velocity: Some(velocity),
            };
        }
        system.factorise(problem, &linear);
        let mut step: Vec<f64> = value.iter().map(|x| -x).collect();
        system.solve(problem, &mut step);
        let mut length = 1.0;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for _ in 0..most.halvings {
            let trial: Vec<f64> = r
                .iter()
                .zip(&step)
                .map(|(r, step)| r + length * step)
                .collect();
            let new = evaluate(problem, near, &trial, &mut u, &mut value);
            if new <= (1.0 - DECREASE * length) * size {
                best = Some((new, trial));
                break;
            }
            length *= 0.5;
        }
        let Some((new, trial)) = best else {
            return false;
        };
        size = new;
        *r = trial;
    }
    size <= goal * norm(r)
}

/// Velocities and the map of r; returns |F|.
fn evaluate(
    problem: &Prepared,
    near: ProximalProblem<'_>,
    r: &[f64],
    u: &mut [f64],
    value: &mut [f64],
) -> f64 {
    problem.velocities(r, u);
    near.add(r, u);
    for (contact, cone) in problem.cones.iter().enumerate() {
        let own = map(cone, &problem.local(contact, r), &problem.local(contact, u));
        problem.put(contact, &own, value);
    }
    norm(value)
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
