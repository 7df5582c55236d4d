//! Problems solved one after the other.

use super::output::{Row, heading};
use super::solved::LoadedProblem;
use super::{folder, method, plot};
use crate::command::number;
use crate::failure::Failure;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tribos::problem::{ProblemMethod, SolverOptions, SolverStatus};

/// Problems, and how to solve them.
#[derive(Debug, clap::Args)]
pub struct Solve {
    /// Problems, FCLib's HDF5 or text of Siconos.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Largest residual of a solution.
    #[arg(long, default_value = "1e-8", value_parser = number::positive, allow_negative_numbers = true)]
    tolerance: f64,
    /// Method.
    #[arg(long, default_value = "automatic", value_parser = method::parser())]
    method: ProblemMethod,
    /// Folder for summary.json, reactions.csv, convergence.svg and convergence.png, created if missing; files of an
    /// earlier command in it are removed first. Several problems have a folder each in it, named like
    /// the file without its ending.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Solve {
    /// Reads all files, then solves, writes and prints one problem after the other.
    pub fn execute(self) -> Result<(), Failure> {
        let folders = self.folders()?;
        let problems = LoadedProblem::read(&self.files)?;
        let _several = match &self.out {
            Some(out) if folders.len() > 1 => {
                let names = folders.iter().flatten().filter_map(|path| path.file_name());
                let names: Vec<String> = names
                    .map(|name| name.to_string_lossy().into_owned())
                    .collect();
                Some(folder::of_several(out, &names)?)
            }
            _ => None,
        };
        let settings = SolverOptions {
            tolerance: self.tolerance,
            method: self.method,
            ..SolverOptions::default()
        };
        crate::command::print(&heading())?;
        let (mut left, mut can_help) = (Vec::new(), false);
        for (folder, posed) in folders.iter().zip(&problems) {
            let solved = posed.solve(&settings);
            let row = Row {
                posed,
                solved: &solved,
            };
            if let Some(folder) = folder {
                write(folder, &row, self.tolerance)?;
            }
            crate::command::print(&row.line())?;
            can_help |= matches!(
                solved.solution.ending,
                SolverStatus::Stalled | SolverStatus::OutOfWork
            );
            if solved.solution.ending != SolverStatus::Converged {
                left.push(format!(
                    "{} ({})",
                    posed.file.display(),
                    row.failure_reason(self.tolerance)
                ));
            }
        }
        if let Some(out) = &self.out {
            crate::command::print(&format!("written to    {}\n", out.display()))?;
        }
        if left.is_empty() {
            return Ok(());
        }
        let cure = if can_help {
            "; try another --method, or a larger --tolerance (rounding allows about 1e-14)"
        } else {
            ""
        };
        Err(Failure::Unsolved(format!(
            "not solved to {:e}: {}\n  The best impulses are kept{cure}.",
            self.tolerance,
            left.join(", ")
        )))
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
                if other == file {
                    return Err(Failure::input(format!("{} is given twice", file.display())));
                }
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
fn write(path: &Path, row: &Row<'_>, tolerance: f64) -> Result<(), Failure> {
    let folder = folder::of_a_problem(path)?;
    let figure = plot::convergence(&row.solved.history, tolerance);
    tribos_report::image::write_both(folder.path(), "convergence", &figure)?;
    row.write(folder.path())
}
