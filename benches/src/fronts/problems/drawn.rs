//! Pictures of the front: performance profiles, and the residual against time.

use super::ours;
use super::siconos::is_usual;
use super::{SolverScore, TOLERANCE, tables};
use crate::written;
use std::path::Path;
use tribos::problem::ProblemMethod;
use tribos_report::figure::{Axis, Figure, Legend, Panels, ReferenceLine, Series};

/// Size of a panel in pixels.
const PANEL: (u32, u32) = (620, 560);
/// Largest ratio of a profile.
const WIDEST: f64 = 1e3;
/// Curves of Siconos' solvers, those that solve most: beside one of ours, there are colours and dashes for them.
const MOST_CURVES: usize = 13;
/// Problems whose residual is drawn against time.
const TRACED: usize = 3;
/// Residuals below this are drawn at it.
const ROUNDING: f64 = 1e-16;

/// A solver's name and its seconds on every problem.
type Row = (String, Vec<Option<f64>>);

/// Share of the problems that a solver solves within a multiple of the least time (Dolan and Moré 2002).
pub fn profiles(folder: &Path, name: &str, all: &[SolverScore]) -> Result<(), String> {
    // Problems that Siconos cannot state would count against it.
    let peers: Vec<&SolverScore> = all.iter().filter(|judged| judged.has_peer()).collect();
    let shown: Vec<&SolverScore> = if peers.is_empty() {
        all.iter().collect()
    } else {
        peers
    };
    let ours = ours_rows(&shown);
    let names = tables::solvers(all);
    let names = names.into_iter().filter(|name| is_usual(name));
    let mut theirs: Vec<Row> = names
        .map(|name| {
            let row = shown.iter().map(|judged| judged.seconds(&name));
            (name.clone(), row.collect())
        })
        .collect();
    let solved = |row: &Row| row.1.iter().flatten().count();
    theirs.sort_by_key(|row| std::cmp::Reverse(solved(row)));
    // The least time of any, drawn or not.
    let of = |at: usize| ours.iter().chain(&theirs).filter_map(move |row| row.1[at]);
    let least: Vec<f64> = (0..shown.len())
        .map(|at| of(at).fold(f64::INFINITY, f64::min))
        .collect();
    let mut ours_and_best = ours.clone();
    let mut panels = Panels::new("Problems solved within a multiple of the least time", 2)
        .cell(PANEL.0, PANEL.1);
    if theirs.is_empty() {
        panels = panels.figure(profile("Our methods", &ours_and_best, &least));
    } else {
        let best = |is_usual: bool| {
            let trials = shown.iter().map(|judged| judged.best(is_usual));
            trials.map(|trial| trial?.seconds()).collect::<Vec<_>>()
        };
        ours_and_best.push(("best of Siconos' defaults".into(), best(true)));
        ours_and_best.push(("best of Siconos, any options".into(), best(false)));
        theirs.truncate(MOST_CURVES);
        theirs.insert(0, ours[0].clone());
        panels = panels
            .figure(profile("Our methods", &ours_and_best, &least))
            .figure(profile(
                "Siconos' solvers, default options",
                &theirs,
                &least,
            ));
    }
    let svg = panels.svg().map_err(|error| error.to_string())?;
    written::write(folder, name, &svg)
}

fn ours_rows(shown: &[&SolverScore]) -> Vec<Row> {
    let row = |(place, method): (usize, ProblemMethod)| {
        let runs = shown.iter().map(|judged| &judged.ours[place]);
        let seconds = runs.map(|run| run.is_solved().then_some(run.seconds));
        (method.name().to_string(), seconds.collect())
    };
    ProblemMethod::ALL
        .into_iter()
        .enumerate()
        .map(row)
        .collect()
}

/// Steps of each row.
fn profile(title: &str, rows: &[Row], least: &[f64]) -> Figure {
    let axes = (
        Axis::log10("time over the least").range(1.0, WIDEST),
        Axis::linear("share of problems solved").range(0.0, 1.02),
    );
    let mut figure = Figure::new(title, axes.0, axes.1).legend(Legend::Below);
    for (name, seconds) in rows {
        let pairs = seconds.iter().zip(least);
        let ratios = pairs.filter_map(|(seconds, least)| Some((*seconds)? / least));
        figure = figure.series(Series::line(
            name.clone(),
            steps(ratios.collect(), least.len()),
        ));
    }
    figure
}

/// Corners of the curve of a solver, from its ratios on the problems that it solves.
fn steps(mut ratios: Vec<f64>, problems: usize) -> Vec<(f64, f64)> {
    ratios.sort_by(f64::total_cmp);
    let share = |solved: usize| solved as f64 / problems as f64;
    let mut corners = vec![(1.0, 0.0)];
    for (before, ratio) in ratios.iter().enumerate() {
        // The best of any options may be faster than all that are drawn.
        let ratio = ratio.max(1.0);
        corners.push((ratio, share(before)));
        corners.push((ratio, share(before + 1)));
    }
    corners.push((WIDEST, share(ratios.len())));
    corners.sort_by(|a, b| a.0.total_cmp(&b.0));
    corners
}

/// Residual of our methods against time, on the problems that take the automatic policy longest.
pub fn residuals(folder: &Path, name: &str, all: &[SolverScore]) -> Result<(), String> {
    let mut longest: Vec<&SolverScore> = all.iter().collect();
    longest.sort_by(|a, b| b.automatic().seconds.total_cmp(&a.automatic().seconds));
    let mut panels = Panels::new("Residual against time", TRACED as u32).cell(PANEL.0, PANEL.1);
    for judged in longest.into_iter().take(TRACED) {
        let axes = (Axis::log10("time [s]"), Axis::log10("scaled residual"));
        let mut figure = Figure::new(judged.case.name.clone(), axes.0, axes.1)
            .legend(Legend::Below)
            .guide(ReferenceLine::horizontal(TOLERANCE, "tolerance"));
        for method in ProblemMethod::ALL {
            let curve = ours::trace(&judged.case.problem, method);
            let shown = curve.into_iter().map(|(t, r)| (t, r.max(ROUNDING)));
            let shown: Vec<(f64, f64)> = shown.collect();
            // A method that does not tell its progress has its end alone.
            let series = match shown.len() {
                1 => Series::points(method.name(), shown),
                _ => Series::line(method.name(), shown),
            };
            figure = figure.series(series);
        }
        panels = panels.figure(figure);
    }
    let svg = panels.svg().map_err(|error| error.to_string())?;
    written::write(folder, name, &svg)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_profile_rises_at_each_ratio_and_ends_at_the_share_solved() {
        let corners = steps(vec![4.0, 1.0], 4);
        let expected = [
            (1.0, 0.0),
            (1.0, 0.0),
            (1.0, 0.25),
            (4.0, 0.25),
            (4.0, 0.5),
            (WIDEST, 0.5),
        ];
        assert_eq!(corners, expected);
    }
}
