//! A problem of a file, read and solved.

use crate::command::progress::Meter;
use crate::failure::Failure;
use std::path::Path;
use std::time::Instant;
use tribos::problem::{
    ContactComponents, ContactProblem, ReducedProblem, Solution, SolverOptions, SolverProgress,
    solve,
};

/// A problem, and the file that it is of.
pub struct LoadedProblem<'a> {
    pub file: &'a Path,
    pub layout: ContactComponents,
    reduced: ReducedProblem,
}

/// A problem that was solved, or tried.
pub struct SolvedProblem {
    pub solution: Solution,
    pub history: Vec<SolverProgress>,
    pub seconds: f64,
}

impl<'a> LoadedProblem<'a> {
    /// Reads all files; the first that is refused ends it.
    pub fn read(files: &'a [impl AsRef<Path>]) -> Result<Vec<Self>, Failure> {
        files
            .iter()
            .map(|file| {
                let file = file.as_ref();
                let problem = ContactProblem::read(file).map_err(Failure::input)?;
                let reduced = problem.reduced();
                let reduced = reduced
                    .map_err(|error| Failure::input(error).within(&file.display().to_string()))?;
                Ok(Self {
                    file,
                    layout: problem.layout(),
                    reduced,
                })
            })
            .collect()
    }

    /// Solves it, and says how far the work is.
    pub fn solve(&self, settings: &SolverOptions) -> SolvedProblem {
        let mut history = Vec::new();
        let mut meter = Meter::new();
        let begun = Instant::now();
        let solution = solve(&self.reduced, settings, |progress| {
            history.push(*progress);
            // The end is not known.
            if meter.is_due(0.0) {
                let SolverProgress {
                    sweeps,
                    factorisations,
                    residual,
                    ..
                } = progress;
                meter.report_elapsed(format_args!(
                    "{}: {sweeps} sweeps, {factorisations} factorisations, residual {residual:.1e}",
                    self.file.display()
                ));
            }
        });
        SolvedProblem {
            solution,
            history,
            seconds: begun.elapsed().as_secs_f64(),
        }
    }
}
