//! Contact problems as data: our methods beside the solvers of Siconos, speed and reliability.

mod cases;
mod drawn;
mod ours;
mod race;
mod search;
mod siconos;
mod tables;

use super::{Finding, Front, Setting};
use cases::Case;
use ours::Run;
use search::Trial;
use siconos::{Siconos, SiconosProblem, Storage};
use std::path::Path;
use tribos::problem::ProblemMethod;

const PROFILE: &str = "problems.svg";
const RESIDUAL: &str = "problems_residual.svg";
/// Largest residual of a solution, plain and scaled.
const TOLERANCE: f64 = 1e-8;

/// Length of the measurements.
struct Extent {
    /// Most rounds of the race.
    rounds: usize,
    /// The processor's time for an attempt of a solver of Siconos, in s.
    seconds: f64,
    /// Storages tried.
    storages: &'static [Storage],
    /// Default options only.
    usual_only: bool,
}

const FULL: Extent = Extent {
    rounds: 15,
    seconds: 5.0,
    storages: &Storage::ALL,
    usual_only: false,
};
const QUICK: Extent = Extent {
    rounds: 3,
    seconds: 1.0,
    storages: &[Storage::Blocks],
    usual_only: true,
};

/// A problem, our methods in the order of [`ProblemMethod::ALL`], and Siconos' solvers.
struct SolverScore {
    case: Case,
    ours: Vec<Run>,
    /// Empty where there is no peer.
    theirs: Vec<Trial>,
}

impl SolverScore {
    /// Our automatic policy.
    fn automatic(&self) -> &Run {
        &self.ours[0]
    }

    /// Whether Siconos' solvers were tried.
    fn has_peer(&self) -> bool {
        !self.theirs.is_empty()
    }

    /// The fastest of Siconos that solves it, with default or with any options.
    fn best(&self, usual_only: bool) -> Option<&Trial> {
        let fit =
            |trial: &&Trial| trial.seconds().is_some() && (!usual_only || trial.job.is_usual());
        let seconds = |trial: &&Trial| trial.seconds().unwrap_or(f64::INFINITY);
        let fit = self.theirs.iter().filter(fit);
        fit.min_by(|a, b| seconds(a).total_cmp(&seconds(b)))
    }

    /// The least time of a solver of Siconos, where it solves the problem.
    fn seconds(&self, solver: &str) -> Option<f64> {
        let of = self
            .theirs
            .iter()
            .filter(|trial| trial.job.solver == solver);
        of.filter_map(Trial::seconds).min_by(f64::total_cmp)
    }

    /// Our time over the best of Siconos', where both solve the problem.
    fn ratio(&self) -> Option<f64> {
        let theirs = self.best(false)?.seconds()?;
        let ours = self.automatic();
        ours.is_solved().then_some(ours.seconds / theirs)
    }
}

/// Makes the front with the files of a folder.
pub fn run(setting: &Setting<'_>, folder: &Path) -> Result<Finding, String> {
    let extent = if setting.quick { QUICK } else { FULL };
    let siconos = Siconos::build();
    if let Err(missing) = &siconos {
        println!("{missing}");
    }
    let cases = cases::all(folder)?.into_iter();
    let all = cases.map(|case| judged(case, siconos.as_ref().ok(), &extent));
    let all = all.collect::<Result<Vec<_>, String>>()?;
    let sheets = [
        ("problems", tables::beside(&all, &extent)),
        ("problems_methods", tables::methods(&all)),
        ("problems_siconos", tables::search(&all)),
    ];
    for (stem, sheet) in &sheets {
        setting.table(stem, sheet)?;
    }
    drawn::profiles(setting.out, PROFILE, &all)?;
    drawn::residuals(setting.out, RESIDUAL, &all)?;
    let peer = match &siconos {
        Ok(siconos) => format!(
            "{}\n{}\nAll that was tried: [problems_siconos.csv](problems_siconos.csv).\n",
            legend(siconos, &extent),
            tables::counts(&all, siconos).markdown()
        ),
        Err(missing) => format!("Nothing is compared. {missing}.\n"),
    };
    let body = format!(
        "![Performance profiles]({PROFILE})\n\n{}\n{}\n{peer}\n![Residual against time]({RESIDUAL})\n",
        sheets[0].1.markdown(),
        sheets[1].1.markdown(),
    );
    setting.page(Front::Problems, &body)?;
    Ok(Finding {
        line: tables::line(&all),
        picture: PROFILE,
    })
}

/// Runs our methods, the search and the race on a problem, and tells how it went: all problems take minutes.
fn judged(case: Case, siconos: Option<&Siconos>, extent: &Extent) -> Result<SolverScore, String> {
    let problem = &case.problem;
    let mut ours: Vec<Run> = ProblemMethod::ALL
        .into_iter()
        .map(|method| ours::measure(problem, method))
        .collect();
    let posed = match siconos {
        Some(siconos) => SiconosProblem::new(siconos, problem)?,
        None => None,
    };
    let mut theirs = Vec::new();
    if let Some(posed) = &posed {
        theirs = search::search(posed, extent)?;
        race::time_again(posed, &mut theirs)?;
        race::race(posed, &mut ours[0], &mut theirs, extent)?;
    }
    let judged = SolverScore { case, ours, theirs };
    println!("{}", tables::told(&judged));
    Ok(judged)
}

/// How Siconos was run, and what is told of it.
fn legend(siconos: &Siconos, extent: &Extent) -> String {
    let storages = extent.storages.iter().map(|storage| storage.name());
    let storages: Vec<&str> = storages.collect();
    format!(
        "Siconos {} (Acary and others; Debian's package) runs on one thread in processes of its own; its time is \
         that of the driver's call from zero impulses, as ours is of `solve`, with W and q given. Problems between \
         bodies are given to it as W and q too; ours knows their bodies. Every answer is judged by `residual`: both \
         sizes at most {TOLERANCE:e}, and of ours also the speed of contacts. A solver's own tolerance starts at \
         1e-8; it is tightened down to 1e-13 until the answer is good enough, or loosened as long as it is and that \
         saves time. Storages of W: {}. An attempt may take {} s of the processor. Cohesion, which Siconos does not \
         have, moves to q: the problem is the same. Problems with torsion have no peer, and the profiles are without \
         them. Left out are four solvers that do not return, crash or solve another problem on the smallest files \
         (HP, NSGS with its quartic local solver, NSGSV, SOCLCP), and those that need the bodies. \"+\" marks \
         options that are not the defaults.\n",
        siconos.release,
        storages.join(", "),
        extent.seconds,
    )
}
