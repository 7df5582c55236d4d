//! Prints how many contact problems are solved: 500 random ones by kind, and 20 changes of each file that is
//! given.

use std::error::Error;
use std::path::Path;
use tribos::problem::{ContactProblem, ReducedProblem, SolverOptions, SolverStatus, solve};
use tribos_tests::problems::{CHANGES, KINDS, changed, random};

/// Solves a problem; prints what is not solved.
fn is_solved(name: &str, problem: &ReducedProblem) -> bool {
    let end = solve(problem, &SolverOptions::default(), |_| ());
    let is_solved = end.ending == SolverStatus::Converged;
    if !is_solved {
        println!(
            "{name}: {}, residuals {:.1e} {:.1e} {:.1e}, {} sweeps, {} factorisations",
            end.ending.name(),
            end.residual.relative,
            end.residual.scaled,
            end.residual.speed,
            end.sweeps,
            end.factorisations
        );
    }
    is_solved
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut solved = [0; KINDS.len()];
    for number in 0..500 {
        let (kind, problem) = random(number);
        let is_solved = is_solved(&format!("{kind} {number}"), &problem.reduced()?);
        solved[number as usize % KINDS.len()] += usize::from(is_solved);
    }
    for (kind, solved) in KINDS.iter().zip(solved) {
        println!("{kind}: {solved} of 100");
    }
    for file in std::env::args().skip(1) {
        let problem = ContactProblem::read(Path::new(&file))?.reduced()?;
        let solved = (0..CHANGES.len())
            .filter(|&at| is_solved(&format!("{file}, {}", CHANGES[at]), &changed(&problem, at)));
        println!("{file}: {} of {}", solved.count(), CHANGES.len());
    }
    Ok(())
}
