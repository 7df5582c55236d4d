//! `tribos contact`: contact problems of other programs, solved.

mod output;
mod plot;

use super::number;
use crate::failure::Failure;
use output::Row;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tribos::problem::{Ending, Method, Problem, Progress, Settings, Solution, solve};
use tribos::run::folder::{Contents, OutputFolder};

/// Solve contact problems of many bodies, as other programs hand them over: which contacts stick, slip or open,
/// and under which impulses.
///
/// Files are FCLib's HDF5 or text of Siconos; their contents tell which. A problem is either W and q between impulses,
/// u = W r + q, or M, H, f and w between bodies, M v = H r + f and u = H^T v + w; contacts have 2, 3 or 5 components
/// (sliding, and rolling), in HDF5 also torsion and cohesion.
///
/// A solution has both residuals at or below the tolerance: the natural map r - P(r - u~) over the largest of |q|, |r|
/// and |u|, and the same in scaled unknowns. A problem that is not solved leaves its best impulses, and the
/// exit code is 4.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Problems, FCLib's HDF5 or text of Siconos.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Largest residual of a solution.
    #[arg(long, default_value = "1e-8", value_parser = number::positive)]
    tolerance: f64,
    /// Method; the automatic one changes from sweeps to others where they are foreseen to be faster.
    #[arg(long, default_value = "automatic")]
    method: Choice,
    /// Folder for summary.json, reactions.csv, convergence.svg and convergence.png, created if missing; files of an
    /// earlier command in it are removed first. Several problems have a folder each in it, named like
    /// the file without its ending.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos contact rover.dat --out out/rover
  tribos contact rover.dat spheres.dat --tolerance 1e-10 --out out/contacts
  tribos contact spheres.dat --method interior
Summaries of all problems in one table:
  jq -r '[.file, .converged, .residual] | @tsv' out/contacts/*/summary.json";

/// Names of the methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Choice {
    /// By foreseen cost.
    Automatic,
    /// Gauss-Seidel sweeps with momentum.
    Sweeps,
    /// Interior point method, Newton's method at its end.
    Interior,
    /// Proximal points with Newton's method.
    Proximal,
}

impl From<Choice> for Method {
    fn from(choice: Choice) -> Self {
        match choice {
            Choice::Automatic => Self::Automatic,
            Choice::Sweeps => Self::Sweeps,
            Choice::Interior => Self::Interior,
            Choice::Proximal => Self::Proximal,
        }
    }
}

/// A problem that was solved, or tried.
struct Solved {
    solution: Solution,
    history: Vec<Progress>,
    seconds: f64,
}

impl Arguments {
    /// Reads all files, then solves, writes and prints one problem after the other.
    pub fn execute(self) -> Result<(), Failure> {
        let folders = self.folders()?;
        let read = |file: &PathBuf| Problem::read(file).map_err(Failure::input);
        let problems: Vec<Problem> = self.files.iter().map(read).collect::<Result<_, _>>()?;
        super::print(&output::heading())?;
        let mut left = Vec::new();
        for ((file, folder), problem) in self.files.iter().zip(folders).zip(problems) {
            let reduced = problem.reduced();
            let reduced = reduced
                .map_err(|error| Failure::input(error).within(&file.display().to_string()))?;
            let solved = self.solved(|settings, watch| solve(&reduced, settings, watch));
            let row = Row {
                file,
                layout: problem.layout(),
                solved: &solved,
            };
            if let Some(folder) = folder {
                write(&folder, &row)?;
            }
            super::print(&row.line())?;
            if solved.solution.ending != Ending::Converged {
                left.push(file.display().to_string());
            }
        }
        if let Some(out) = &self.out {
            super::print(&format!("written to    {}\n", out.display()))?;
        }
        if left.is_empty() {
            return Ok(());
        }
        Err(Failure::Unsolved(format!(
            "not solved to {:e}: {}\n  The best impulses are kept; try another --method, or a larger --tolerance.",
            self.tolerance,
            left.join(", ")
        )))
    }

    fn solved(
        &self,
        solve: impl FnOnce(&Settings, &mut dyn FnMut(&Progress)) -> Solution,
    ) -> Solved {
        let settings = Settings {
            tolerance: self.tolerance,
            method: self.method.into(),
            ..Settings::default()
        };
        let mut history = Vec::new();
        let begun = Instant::now();
        let solution = solve(&settings, &mut |progress| history.push(*progress));
        Solved {
            solution,
            history,
            seconds: begun.elapsed().as_secs_f64(),
        }
    }

    /// The folder of each file, if any; two files must not share one.
    fn folders(&self) -> Result<Vec<Option<PathBuf>>, Failure> {
        let Some(out) = &self.out else {
            return Ok(vec![None; self.files.len()]);
        };
        if self.files.len() == 1 {
            return Ok(vec![Some(out.clone())]);
        }
        let mut taken: BTreeMap<PathBuf, &Path> = BTreeMap::new();
        let mut folders = Vec::new();
        for file in &self.files {
            let stem = file.file_stem().unwrap_or(file.as_os_str());
            let folder = out.join(stem);
            if let Some(other) = taken.insert(folder.clone(), file) {
                return Err(Failure::input(format!(
                    "{} and {} would both have the folder {}; rename one, or give them one at a time",
                    other.display(),
                    file.display(),
                    folder.display()
                )));
            }
            folders.push(Some(folder));
        }
        Ok(folders)
    }
}

/// Leaves a problem's files in its folder.
fn write(folder: &Path, row: &Row) -> Result<(), Failure> {
    let files = [
        "summary.json",
        "reactions.csv",
        "convergence.svg",
        "convergence.png",
    ];
    let _folder = OutputFolder::begin(folder, &Contents::of("contact", &files))?;
    tribos_report::image::write_both(
        folder,
        "convergence",
        &plot::convergence(&row.solved.history),
    )?;
    row.write(folder)
}
