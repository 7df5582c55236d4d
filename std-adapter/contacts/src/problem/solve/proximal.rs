//! Proximal point iterations around Newton's method.
//!
//! Each iteration solves the problem with W + a I in place of W and q − a r in place of q; its solution exists
//! and stays near r. The weight a falls while that succeeds and grows where it fails (Rockafellar, SIAM J. Control
//! Optim. 14 (1976) 877; Acary, Brémond and Huber 2018 on contacts).

use super::newton::{CostLimit, ProximalProblem, newton};
use super::prepared::Prepared;
use super::system::System;

/// First weight, in scaled unknowns, and its bounds.
const FIRST: f64 = 1e-3;
const LEAST: f64 = 1e-12;
const MOST: f64 = 1e3;
/// Change of the weight with success and failure.
const CHANGE: f64 = 10.0;
/// Newton's steps of an inner problem, and their halvings.
const INNER: CostLimit = CostLimit {
    steps: 12,
    halvings: 12,
};

/// Iterates from r at most `most` times, until the scaled residual is at most `goal`. Tells whether it is, and
/// leaves the best point.
pub(super) fn proximal(
    problem: &Prepared,
    system: &mut System,
    r: &mut [f64],
    (goal, most): (f64, usize),
    mut watch: impl FnMut(f64, &System) -> bool,
) -> bool {
    let mut u = vec![0.0; r.len()];
    let mut weight = FIRST;
    let mut centre = r.to_vec();
    problem.velocities(&centre, &mut u);
    let mut best = problem.residual(&centre, &u);
    for _ in 0..most {
        let mut trial = centre.clone();
        let near = ProximalProblem {
            weight,
            centre: &centre,
        };
        // The inner problem's accuracy follows the distance that is left.
        let inner = (0.01 * best).clamp(0.01 * goal, 1e-3);
        let solved = newton(problem, system, near, &mut trial, (inner, INNER));
        problem.velocities(&trial, &mut u);
        let residual = problem.residual(&trial, &u);
        if solved || residual < best {
            if residual < best {
                best = residual;
                r.copy_from_slice(&trial);
            }
            centre = trial;
        }
        let is_enough = watch(best, system);
        if best <= goal || is_enough {
            return best <= goal;
        }
        weight = if solved {
            weight / CHANGE
        } else {
            weight * CHANGE
        };
        if weight > MOST {
            return false;
        }
        weight = weight.max(LEAST);
    }
    false
}
