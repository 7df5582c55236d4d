//! The search for normal impulses that only squeeze.
//!
//! Without friction a problem is min ½ r W r + q r over r ≥ 0. With a I added to W it has one solution r_a. If the
//! problem itself has none, a r_a tends to impulses that move nothing while their contacts close, as a falls
//! to zero (the vector of least displacement: Banjac, Goulart, Stellato and Boyd, J. Optim. Theory Appl. 183
//! (2019) 490).

use super::super::law::ContactThresholds;
use super::super::reduced::ReducedProblem;
use super::super::squeeze::Squeeze;
use super::newton::{CostLimit, ProximalProblem, newton};
use super::prepared::Prepared;
use super::system::System;

/// First and last weight a, in scaled unknowns, and its fall from one problem to the next.
const FIRST: f64 = 1e-1;
const LAST: f64 = 1e-12;
const FALL: f64 = 0.1;
/// Accuracy of each problem, and its effort.
const GOAL: f64 = 1e-12;
const EFFORT: CostLimit = CostLimit {
    steps: 30,
    halvings: 12,
};

/// Factorisations that the search is expected to take.
const EXPECTED: f64 = 30.0;

/// A proof that the problem has no solution to `tolerance`, if one is found, and foreseen to take at most `most_cost`
/// multiplications; its absence proves nothing.
pub(super) fn squeeze(problem: &ReducedProblem, tolerance: f64, most_cost: f64) -> Option<Squeeze> {
    let smooth = ReducedProblem {
        layout: problem.layout,
        w: problem.w.clone(),
        q: problem.without_cohesion(),
        laws: vec![ContactThresholds::default(); problem.laws.len()],
        made: None,
    };
    let prepared = Prepared::new(&smooth);
    if EXPECTED * System::least_cost(&prepared) > most_cost {
        return None;
    }
    let mut system = System::new(&prepared);
    if EXPECTED * system.cost(&prepared) > most_cost {
        return None;
    }
    let centre = vec![0.0; prepared.q.len()];
    let (mut r, mut before) = (centre.clone(), centre.clone());
    let mut weight = FIRST;
    while weight >= LAST {
        let near = ProximalProblem {
            weight,
            centre: &centre,
        };
        // Wherever it ends: what is found is judged.
        newton(&prepared, &mut system, near, &mut r, (GOAL, EFFORT));
        // r = y/a + …: the difference of two is free of the part that does not grow.
        let grown: Vec<f64> = r.iter().zip(&before).map(|(r, old)| r - old).collect();
        for trial in [&grown, &r] {
            let impulses = prepared.unscaled(trial, &smooth);
            let proof = Squeeze::of(problem, &impulses, tolerance);
            if proof.is_some() {
                return proof;
            }
        }
        before.copy_from_slice(&r);
        weight *= FALL;
    }
    None
}
