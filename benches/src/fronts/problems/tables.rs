//! Tables of the front.

use super::ours::Run;
use super::search::{Outcome, Trial};
use super::siconos::{Siconos, is_usual};
use super::{Extent, SolverScore, TOLERANCE};
use crate::timing::median;
use crate::written::{Sheet, short};
use tribos::problem::ProblemMethod;

/// A cell of what is not there.
const NONE: &str = "–";

/// Our automatic policy beside the best of Siconos, a row a problem.
pub fn beside(all: &[SolverScore], extent: &Extent) -> Sheet {
    Sheet {
        about: format!(
            "Contact problems solved to a residual of {TOLERANCE:e}: automatic policy beside the best of Siconos, \
             chosen for each problem alone; times in ms, the least of up to {} rounds in turn; `ratio` is ours over \
             the best of Siconos with any options",
            extent.rounds
        ),
        header: vec![
            "problem",
            "contacts",
            "components",
            "ours",
            "method",
            "residual",
            "best with defaults",
            "its time",
            "best with any options",
            "its time",
            "ratio",
        ],
        rows: all.iter().map(row).collect(),
    }
}

fn row(judged: &SolverScore) -> Vec<String> {
    let (problem, ours) = (&judged.case.problem, judged.automatic());
    let best = |trial: Option<&Trial>| {
        let name = trial.map_or(NONE.into(), |trial| trial.job.name());
        let seconds = trial.and_then(Trial::seconds);
        [name, seconds.map_or(NONE.into(), milliseconds)]
    };
    let ratio = judged.ratio().map_or(NONE.into(), short);
    let mut cells = vec![
        judged.case.name.clone(),
        problem.contacts().to_string(),
        problem.layout().size().to_string(),
        ended(ours),
        ours.found_by.name().into(),
        short(ours.residual),
    ];
    cells.extend(best(judged.best(true)));
    cells.extend(best(judged.best(false)));
    cells.push(ratio);
    cells
}

/// A problem in one line, with the cells of its row.
pub fn told(judged: &SolverScore) -> String {
    row(judged).join(", ")
}

fn milliseconds(seconds: f64) -> String {
    short(1e3 * seconds)
}

/// Time in ms, or how a method ended.
fn ended(run: &Run) -> String {
    if run.is_solved() {
        milliseconds(run.seconds)
    } else {
        format!("{} at {}", run.ending.name(), short(run.residual))
    }
}

/// Each of our methods on each problem.
pub fn methods(all: &[SolverScore]) -> Sheet {
    let mut header = vec!["problem"];
    header.extend(ProblemMethod::ALL.map(ProblemMethod::name));
    let row = |judged: &SolverScore| {
        let mut cells = vec![judged.case.name.clone()];
        cells.extend(judged.ours.iter().map(ended));
        cells
    };
    Sheet {
        about: "Our methods: time in ms, or how they ended and the residual".into(),
        header,
        rows: all.iter().map(row).collect(),
    }
}

/// Problems solved by each method of ours and each solver of Siconos.
pub fn counts(all: &[SolverScore], siconos: &Siconos) -> Sheet {
    let peers: Vec<&SolverScore> = all.iter().filter(|judged| judged.has_peer()).collect();
    let mut rows: Vec<(usize, usize, String)> = Vec::new();
    for (place, method) in ProblemMethod::ALL.into_iter().enumerate() {
        let solved = peers
            .iter()
            .filter(|judged| judged.ours[place].is_solved())
            .count();
        rows.push((solved, peers.len(), format!("ours: {}", method.name())));
    }
    for name in solvers(all) {
        let fits = |judged: &&&SolverScore| {
            let size = judged.case.problem.layout().size();
            siconos.solvers(size).any(|solver| solver == name)
        };
        let fit: Vec<_> = peers.iter().filter(fits).collect();
        let solved = fit
            .iter()
            .filter(|judged| judged.seconds(&name).is_some())
            .count();
        rows.push((solved, fit.len(), name));
    }
    rows.sort_by_key(|row| std::cmp::Reverse(row.0));
    let cells =
        |(solved, of, name): (usize, usize, String)| vec![name, solved.to_string(), of.to_string()];
    Sheet {
        about: "Problems solved, of those with contacts that the solver knows (its best storage and tolerance)".into(),
        header: vec!["solver", "solved", "of"],
        rows: rows.into_iter().map(cells).collect(),
    }
}

/// Names of Siconos' solvers that were tried.
pub fn solvers(all: &[SolverScore]) -> Vec<String> {
    let trials = all.iter().flat_map(|judged| &judged.theirs);
    let mut names: Vec<String> = trials.map(|trial| trial.job.solver.clone()).collect();
    // Those with default options first.
    names.sort_by_key(|name| (!is_usual(name), name.clone()));
    names.dedup();
    names
}

/// Everything that the search of Siconos' solvers found.
pub fn search(all: &[SolverScore]) -> Sheet {
    let rows = all
        .iter()
        .flat_map(|judged| judged.theirs.iter().map(move |trial| (judged, trial)));
    let ending = |trial: &Trial| match trial.outcome {
        Outcome::Solved(_) => "solved",
        Outcome::Above(_) => "above",
        Outcome::OutOfTime => "out of time",
        Outcome::Crashed => "crashed",
    };
    let residual = |trial: &Trial| match trial.outcome {
        Outcome::Solved(answer) => short(answer.residual),
        Outcome::Above(residual) => short(residual),
        Outcome::OutOfTime | Outcome::Crashed => String::new(),
    };
    Sheet::of(
        "Siconos' solvers: their own tolerance, and time in ms",
        rows,
        &[
            ("problem", &|(judged, _)| judged.case.name.clone()),
            ("solver", &|(_, trial)| trial.job.solver.clone()),
            ("storage", &|(_, trial)| trial.job.storage.name().into()),
            ("tolerance", &|(_, trial)| {
                format!("{:.0e}", trial.job.tolerance)
            }),
            ("ending", &|(_, trial)| ending(trial).into()),
            ("time", &|(_, trial)| {
                trial.seconds().map_or(String::new(), milliseconds)
            }),
            ("residual", &|(_, trial)| residual(trial)),
        ],
    )
}

/// Summary of the front.
pub fn line(all: &[SolverScore]) -> String {
    let count = |is_solved: &dyn Fn(&SolverScore) -> bool| {
        let peers = all.iter().filter(|judged| judged.has_peer());
        peers.filter(|judged| is_solved(judged)).count()
    };
    let with_peer = count(&|_| true);
    let solved = all.iter().filter(|judged| judged.automatic().is_solved());
    let ours = format!(
        "The automatic policy solves {} of {} contact problems to a residual of {TOLERANCE:e}",
        solved.count(),
        all.len()
    );
    if with_peer == 0 {
        return format!("{ours}.");
    }
    let names = solvers(all);
    let best = names.iter().map(|name| {
        let solved = count(&|judged| judged.seconds(name).is_some());
        (solved, name)
    });
    let best = best.max_by_key(|(solved, _)| *solved);
    let alone = best.map_or(String::new(), |(solved, name)| {
        format!("; alone, none solves more than {solved} ({name})")
    });
    let ratios: Vec<f64> = all.iter().filter_map(SolverScore::ratio).collect();
    format!(
        "{ours}. Of the {with_peer} that Siconos can state, its best solver for each one solves {} with default \
         options and {} with any{alone}. Our time over that of its best with any options: median {}, {} to {}.",
        count(&|judged| judged.best(true).is_some()),
        count(&|judged| judged.best(false).is_some()),
        short(median(&ratios)),
        short(ratios.iter().copied().fold(f64::INFINITY, f64::min)),
        short(ratios.iter().copied().fold(0.0, f64::max)),
    )
}
