//! Several methods over several problems.

use super::solved::LoadedProblem;
use super::{folder, method, profile};
use crate::command::number;
use crate::failure::Failure;
use std::path::PathBuf;
use tribos::problem::{ProblemMethod, SolverOptions, SolverStatus};
use tribos::record::{number, write_atomically};
use tribos::run::folder::Contents;

/// Run several methods over several problems: which solve them, in what time, and the share of the problems that each
/// solves within a multiple of the fastest time (performance profile of Dolan and More).
///
/// Methods take turns on each problem; a time is the shortest of several runs.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Compare {
    /// Problems, FCLib's HDF5 or text of Siconos.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Largest residual of a solution.
    #[arg(long, default_value = "1e-8", value_parser = number::positive, allow_negative_numbers = true)]
    tolerance: f64,
    /// Methods, with commas between them; all if it is left out.
    #[arg(long = "method", value_name = "METHODS", value_delimiter = ',', value_parser = method::parser())]
    methods: Vec<ProblemMethod>,
    /// Runs of each method on each problem.
    #[arg(long, default_value = "3", value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// Folder for times.csv, profile.csv, profile.svg and profile.png, created if missing; files of an
    /// earlier command in it are removed first.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// How one method did on one problem.
struct Trial {
    method: ProblemMethod,
    ending: SolverStatus,
    residuals: [f64; 2],
    work: [usize; 2],
    seconds: f64,
}

impl Trial {
    /// The time, where the problem was solved.
    fn time(&self) -> Option<f64> {
        (self.ending == SolverStatus::Converged).then_some(self.seconds)
    }
}

const FILES: [&str; 4] = ["times.csv", "profile.csv", "profile.svg", "profile.png"];

impl Compare {
    /// Reads all files, then runs.
    pub fn execute(self) -> Result<(), Failure> {
        let methods = match self.methods.as_slice() {
            [] => ProblemMethod::ALL.to_vec(),
            given => without_repeats(given)?,
        };
        let problems = LoadedProblem::read(&self.files)?;
        let out = match &self.out {
            None => None,
            Some(out) => Some(folder::begin(
                out,
                &Contents::of("contact compare", &FILES),
            )?),
        };
        crate::command::print(&heading(&methods))?;
        let mut all = Vec::new();
        for posed in &problems {
            let trials = self.trials(posed, &methods);
            let times: String = trials.iter().map(cell).collect();
            crate::command::print(&format!("{times} {}\n", posed.file.display()))?;
            all.push(trials);
        }
        let times: Vec<Vec<Option<f64>>> = all
            .iter()
            .map(|trials| trials.iter().map(Trial::time).collect())
            .collect();
        let names: Vec<&str> = methods.iter().map(|method| method.name()).collect();
        let profile = profile::Profile::of(&names, &times);
        crate::command::print(&profile.told())?;
        if let Some(folder) = out {
            let path = folder.path();
            write_atomically(&path.join(FILES[0]), table(&problems, &all).as_bytes())?;
            write_atomically(&path.join(FILES[1]), profile.table().as_bytes())?;
            tribos_report::image::write_both(path, "profile", &profile.figure())?;
            crate::command::print(&format!("written to    {}\n", path.display()))?;
        }
        let unsolved = problems
            .iter()
            .zip(&times)
            .filter(|(_, times)| times.iter().all(Option::is_none));
        let unsolved: Vec<String> = unsolved
            .map(|(posed, _)| posed.file.display().to_string())
            .collect();
        if unsolved.is_empty() {
            return Ok(());
        }
        Err(Failure::Unsolved(format!(
            "no method solves to {:e}: {}",
            self.tolerance,
            unsolved.join(", ")
        )))
    }

    /// Methods in turn, as often as asked.
    fn trials(&self, posed: &LoadedProblem<'_>, methods: &[ProblemMethod]) -> Vec<Trial> {
        let mut trials: Vec<Trial> = Vec::new();
        for run in 0..self.runs {
            for (at, &method) in methods.iter().enumerate() {
                let settings = SolverOptions {
                    tolerance: self.tolerance,
                    method,
                    ..SolverOptions::default()
                };
                let solved = posed.solve(&settings);
                if run > 0 {
                    trials[at].seconds = trials[at].seconds.min(solved.seconds);
                    continue;
                }
                let solution = solved.solution;
                trials.push(Trial {
                    method,
                    ending: solution.ending,
                    residuals: [solution.residual.relative, solution.residual.scaled],
                    work: [solution.sweeps, solution.factorisations],
                    seconds: solved.seconds,
                });
            }
        }
        trials
    }
}

/// Refuses a method that is given twice.
fn without_repeats(methods: &[ProblemMethod]) -> Result<Vec<ProblemMethod>, Failure> {
    let twice = (1..methods.len()).find(|&at| methods[..at].contains(&methods[at]));
    twice.map_or(Ok(methods.to_vec()), |at| {
        let name = methods[at].name();
        let message = format!("--method: {name} is given twice");
        Err(Failure::input(message))
    })
}

fn heading(methods: &[ProblemMethod]) -> String {
    let names = methods
        .iter()
        .map(|method| format!("{:>12}", method.name()));
    format!("{} file (ms)\n", names.collect::<String>())
}

/// Milliseconds, or why there are none.
fn cell(trial: &Trial) -> String {
    match trial.time() {
        Some(seconds) => format!("{:>12.3}", 1e3 * seconds),
        None => format!("{:>12}", trial.ending.name()),
    }
}

/// A row for each method on each problem.
fn table(problems: &[LoadedProblem<'_>], all: &[Vec<Trial>]) -> String {
    let mut text =
        String::from("file,method,ending,residual,residual_scaled,sweeps,factorisations,seconds\n");
    for (posed, trials) in problems.iter().zip(all) {
        for trial in trials {
            let [relative, scaled] = trial.residuals.map(number);
            let [sweeps, factorisations] = trial.work;
            text += &format!(
                "{},{},{},{relative},{scaled},{sweeps},{factorisations},{}\n",
                quoted(&posed.file.display().to_string()),
                trial.method.name(),
                trial.ending.name(),
                number(trial.seconds)
            );
        }
    }
    text
}

/// A field of a table, in quotes where it has to be.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}
