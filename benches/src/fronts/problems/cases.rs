//! Contact problems of the front: files of a folder, and blocked packings.

use std::path::{Path, PathBuf};
use tribos::powder::PowderSimulation;
use tribos::problem::{ContactProblem, ReducedProblem};
use tribos::run::Simulation;
use tribos::scene::PowderScene;

/// A contact problem and its name.
#[derive(Debug)]
pub struct Case {
    /// Name of the file or of the packing.
    pub name: String,
    /// The problem between impulses.
    pub problem: ReducedProblem,
}

/// A packing under a piston.
struct Packing {
    name: &'static str,
    /// Side of the square base and height of the deposit, in radii.
    extents: [f64; 2],
    /// Rolling and torsion coefficients.
    twist: [f64; 2],
}

const PACKINGS: [Packing; 3] = [
    Packing {
        name: "packing (sliding; small)",
        extents: [10.0, 16.0],
        twist: [0.0, 0.0],
    },
    Packing {
        name: "packing (sliding; large)",
        extents: [16.0, 30.0],
        twist: [0.0, 0.0],
    },
    Packing {
        name: "packing (all modes; small)",
        extents: [10.0, 16.0],
        twist: [0.1, 0.1],
    },
];
/// Pressure on the piston in F_coh/R²: contacts bear eight times that of the scene's default.
const PRESSURE: f64 = 0.02;
/// Steps after which a run ends that is not blocked before.
const MOST_STEPS: u64 = 20_000;

/// All problems: files in the order of their names, then packings.
pub fn all(folder: &Path) -> Result<Vec<Case>, String> {
    let mut cases = files(folder)?;
    for packing in &PACKINGS {
        let problem = packed(packing).map_err(|error| format!("{}: {error}", packing.name))?;
        let name = packing.name.into();
        cases.push(Case { name, problem });
    }
    Ok(cases)
}

/// Files of a folder but for texts about them.
fn files(folder: &Path) -> Result<Vec<Case>, String> {
    let entries = std::fs::read_dir(folder)
        .map_err(|error| format!("cannot read the folder {}: {error}", folder.display()))?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let is_problem =
        |path: &PathBuf| path.is_file() && path.extension().is_none_or(|ending| ending != "md");
    let mut paths: Vec<PathBuf> = paths.filter(is_problem).collect();
    paths.sort();
    let case = |path: PathBuf| {
        let read = ContactProblem::read(&path).map_err(|error| error.to_string())?;
        let problem = read
            .reduced()
            .map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        // Names are cells of a table.
        let name = name.replace([',', '|'], " ");
        Ok(Case { name, problem })
    };
    paths.into_iter().map(case).collect()
}

/// The contact problem of the last step: the packing bears the piston.
fn packed(packing: &Packing) -> Result<ReducedProblem, Box<dyn std::error::Error>> {
    let scene = PowderScene {
        width: packing.extents[0],
        height: packing.extents[1],
        pressure: PRESSURE,
        max_steps: MOST_STEPS,
        mu_rolling: packing.twist[0],
        mu_torsion: packing.twist[1],
        ..PowderScene::default()
    };
    let mut compaction = PowderSimulation::new(&scene)?;
    while compaction.ending().is_none() {
        compaction.step()?;
    }
    let problem = compaction.problem().ok_or("no problem after a step")?;
    Ok(problem.reduced()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Options;
    use clap::Parser;

    /// Contacts of problems that are solved at once.
    const SMALL: usize = 200;

    #[test]
    fn the_usual_folder_and_packings_give_problems() {
        let folder = Options::parse_from(["fronts"]).problems();
        let cases = all(&folder).unwrap();
        assert!(cases.len() > PACKINGS.len());
        for Case { name, problem } in &cases {
            let is_packing = name.starts_with("packing");
            assert!(
                problem.contacts() > if is_packing { 50 } else { 0 },
                "{name}"
            );
            if problem.contacts() < SMALL {
                let end = tribos::problem::solve(problem, &Default::default(), |_| ());
                assert!(end.residual.meets(1e-8), "{name}: {:?}", end.residual);
            }
        }
    }
}
