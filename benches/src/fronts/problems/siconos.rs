//! Running Siconos: building the driver, problems as its files, and answers from its output.

use super::TOLERANCE;
use crate::command_line::first_line;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use tempfile::TempDir;
use tribos::problem::{ContactComponents, ReducedProblem, residual};

/// The driver in C.
const SOURCE: &str = include_str!("../../../siconos/race.c");
/// How to install what the driver needs.
const ADVICE: &str = "apt-get install -y --no-install-recommends gcc libsiconos-numerics-dev";
/// Debian's package.
const PACKAGE: &str = "libsiconos-numerics-dev";
/// Folders of headers, and libraries.
const HEADERS: [&str; 3] = [
    "-I/usr/include/siconos",
    "-I/usr/include/siconos/numerics",
    "-I/usr/include/suitesparse",
];
const LIBRARIES: [&str; 3] = ["-lsiconos_numerics", "-lsiconos_externals", "-lm"];
/// Status of the driver when a solver takes too long.
const OUT_OF_TIME: i32 = 24;

/// Storage of the matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Sparse blocks, one a pair of contacts.
    Blocks,
    /// Triplets.
    Sparse,
    /// All entries.
    Dense,
}

impl Storage {
    /// All, the usual one first.
    pub const ALL: [Self; 3] = [Self::Blocks, Self::Sparse, Self::Dense];

    /// Name in tables and for the driver.
    pub fn name(self) -> &'static str {
        match self {
            Self::Blocks => "blocks",
            Self::Sparse => "sparse",
            Self::Dense => "dense",
        }
    }
}

/// What the driver is asked to run.
#[derive(Clone, Debug)]
pub struct Job {
    /// Name of the solver; "+" comes before options that are not the defaults.
    pub solver: String,
    /// Storage of the matrix.
    pub storage: Storage,
    /// The solver's own tolerance.
    pub tolerance: f64,
}

impl Job {
    /// Whether the solver has its default options.
    pub fn is_usual(&self) -> bool {
        is_usual(&self.solver)
    }

    /// Solver and storage.
    pub fn name(&self) -> String {
        format!("{} {}", self.solver, self.storage.name())
    }
}

/// Whether a name is that of default options.
pub fn is_usual(solver: &str) -> bool {
    !solver.contains('+')
}

/// An answer of a solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Seconds: of the processor without a limit, of the wall with one.
    pub seconds: f64,
    /// The larger of both residuals, judged as ours are.
    pub residual: f64,
}

impl Answer {
    /// Whether both residuals are at most the tolerance.
    pub fn is_solved(&self) -> bool {
        self.residual <= TOLERANCE
    }
}

/// Answers of a job.
#[derive(Clone, Debug, Default)]
pub struct SolverRun {
    /// One a repetition; fewer if the solver crashed or took too long.
    pub answers: Vec<Answer>,
    /// Whether it took too long.
    pub is_out_of_time: bool,
}

impl SolverRun {
    /// The least time of the answers that solve the problem.
    pub fn least(&self) -> f64 {
        let solved = self.answers.iter().filter(|answer| answer.is_solved());
        solved.fold(f64::INFINITY, |least, answer| least.min(answer.seconds))
    }
}

/// The driver, built.
#[derive(Debug)]
pub struct Siconos {
    folder: TempDir,
    /// Release of the package.
    pub release: String,
    /// Names of solvers and components of a contact.
    solvers: Vec<(String, usize)>,
}

impl Siconos {
    /// Compiles the driver; the reason and advice where that fails.
    pub fn build() -> Result<Self, String> {
        let folder = tempfile::tempdir().map_err(|error| format!("no folder: {error}"))?;
        let missing = |cause: String| format!("Siconos: {cause} (Debian: `{ADVICE}`)");
        let source = folder.path().join("race.c");
        fs::write(&source, SOURCE).map_err(|error| missing(format!("no driver: {error}")))?;
        let program = folder.path().join("race");
        let output = Command::new("gcc")
            .args(["-O2", "-o"])
            .args([&program, &source])
            .args(HEADERS.iter().chain(&LIBRARIES))
            .output()
            .map_err(|error| missing(format!("no gcc: {error}")))?;
        if !output.status.success() {
            let told = String::from_utf8_lossy(&output.stderr).into_owned();
            let first = told.lines().find(|line| line.contains("error"));
            let first = first.unwrap_or_default().trim();
            return Err(missing(format!("the driver does not compile: {first}")));
        }
        let listed = Command::new(&program).arg("--list").output();
        let listed =
            listed.map_err(|error| missing(format!("the driver does not run: {error}")))?;
        let release = first_line("dpkg-query", &["-W", "-f", "${Version}\n", PACKAGE]);
        Ok(Self {
            folder,
            release: release.unwrap_or("of unknown release".into()),
            solvers: String::from_utf8_lossy(&listed.stdout)
                .lines()
                .filter_map(solver)
                .collect(),
        })
    }

    /// Solvers for contacts of a number of components.
    pub fn solvers(&self, size: usize) -> impl Iterator<Item = &str> {
        let fit = self.solvers.iter().filter(move |solver| solver.1 == size);
        fit.map(|solver| solver.0.as_str())
    }
}

/// Reads a line of the driver's list.
fn solver(line: &str) -> Option<(String, usize)> {
    let (name, size) = line.split_once(' ')?;
    Some((name.into(), size.parse().ok()?))
}

/// A problem that the driver can read.
#[derive(Debug)]
pub struct SiconosProblem<'a> {
    /// The driver.
    pub siconos: &'a Siconos,
    /// The problem.
    pub problem: &'a ReducedProblem,
    file: PathBuf,
}

impl<'a> SiconosProblem<'a> {
    /// Writes the problem; `None` if Siconos has no such law.
    pub fn new(siconos: &'a Siconos, problem: &'a ReducedProblem) -> Result<Option<Self>, String> {
        if problem.layout().torsion() != (0..0) {
            return Ok(None);
        }
        let file = siconos.folder.path().join("problem.txt");
        fs::write(&file, text(problem))
            .map_err(|error| format!("cannot write {}: {error}", file.display()))?;
        Ok(Some(Self {
            siconos,
            problem,
            file,
        }))
    }

    /// Runs a job in a process of its own; `limit` is that of a repetition in s, 0 for none.
    pub fn run(&self, job: &Job, limit: f64, repetitions: usize) -> Result<SolverRun, String> {
        let numbers = [limit.to_string(), format!("{:e}", job.tolerance)];
        let output = Command::new(self.siconos.folder.path().join("race"))
            .arg(&self.file)
            .args([&numbers[0], &job.solver, job.storage.name(), &numbers[1]])
            .arg(repetitions.to_string())
            .env("OMP_NUM_THREADS", "1")
            .env("OPENBLAS_NUM_THREADS", "1")
            .output()
            .map_err(|error| format!("cannot run the driver of Siconos: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout);
        Ok(SolverRun {
            answers: text.lines().filter_map(|line| self.answer(line)).collect(),
            is_out_of_time: output.status.code() == Some(OUT_OF_TIME),
        })
    }

    /// Judges the impulses of a line of the driver.
    fn answer(&self, line: &str) -> Option<Answer> {
        let mut words = line.split(' ');
        let milliseconds: f64 = words.next()?.parse().ok()?;
        // The status is Siconos' own judgement.
        let numbers = words.skip(1).map(|word| word.parse().unwrap_or(f64::NAN));
        let mut impulses: Vec<f64> = numbers.collect();
        let size = self.problem.layout().size();
        if impulses.len() != size * self.problem.contacts() {
            return None;
        }
        let normals = impulses.iter_mut().step_by(size);
        for (normal, law) in normals.zip(self.problem.laws()) {
            *normal -= law.cohesion;
        }
        Some(Answer {
            seconds: 1e-3 * milliseconds,
            residual: residual(self.problem, &impulses).largest(),
        })
    }
}

/// The problem as the driver reads it. Siconos has no cohesion: its impulses count from the largest pull, whose
/// velocities are in q.
fn text(problem: &ReducedProblem) -> String {
    let (w, laws, layout) = (problem.w(), problem.laws(), problem.layout());
    let mut pull = vec![0.0; problem.q().len()];
    for (pull, law) in pull.iter_mut().step_by(layout.size()).zip(laws) {
        *pull = -law.cohesion;
    }
    let mut text = format!("{} {} {}\n", layout.size(), laws.len(), w.stored());
    for (row, column, value) in w.triplets() {
        let _ = writeln!(text, "{row} {column} {value:e}");
    }
    for q in problem.velocities(&pull) {
        let _ = writeln!(text, "{q:e}");
    }
    let rolls = layout == ContactComponents::Rolling;
    for law in laws {
        let rolling = if rolls { law.rolling } else { 0.0 };
        let _ = writeln!(text, "{:e} {rolling:e}", law.sliding);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos::problem::{ContactThresholds, SparseMatrix};

    #[test]
    fn cohesion_moves_to_the_velocities() {
        let w = SparseMatrix::from_triplets([2, 2], &[(0, 0, 0.5), (1, 1, 2.0)]).unwrap();
        let law = ContactThresholds {
            sliding: 0.25,
            cohesion: 3.0,
            ..ContactThresholds::default()
        };
        let problem =
            ReducedProblem::new(ContactComponents::Plane, w, vec![-1.0, 4.0], vec![law]).unwrap();
        let expected = "2 1 2\n0 0 5e-1\n1 1 2e0\n-2.5e0\n4e0\n2.5e-1 0e0\n";
        assert_eq!(text(&problem), expected);
    }

    #[test]
    fn a_driver_that_is_there_solves_a_fall() {
        let Ok(siconos) = Siconos::build() else {
            return;
        };
        let w = [(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5)];
        let w = SparseMatrix::from_triplets([3, 3], &w).unwrap();
        let laws = vec![ContactThresholds {
            sliding: 0.5,
            cohesion: 0.25,
            ..ContactThresholds::default()
        }];
        let fall =
            ReducedProblem::new(ContactComponents::Space, w, vec![-3.0, 4.0, 0.0], laws).unwrap();
        let posed = SiconosProblem::new(&siconos, &fall).unwrap().unwrap();
        for storage in Storage::ALL {
            let job = Job {
                solver: "NSGS".into(),
                storage,
                tolerance: 1e-8,
            };
            let ran = posed.run(&job, 1.0, 2).unwrap();
            assert!(ran.answers.len() == 2 && ran.answers.iter().all(Answer::is_solved));
        }
        assert!(siconos.solvers(5).count() > 1);
    }
}
