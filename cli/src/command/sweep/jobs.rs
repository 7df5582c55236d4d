//! The runs of a sweep, some at a time.

use super::grid::Grid;
use crate::command::parallel::in_order;
use crate::command::run::powder::{self, Progress, Start};
use crate::failure::Failure;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::record::write_atomically;
use tribos::scene::{self, PowderScene, Scene};

/// Time from one checkpoint of a run to the next.
const PAUSE: Duration = Duration::from_secs(60);

/// One run.
#[derive(Debug)]
pub struct Task {
    name: String,
    scene: PowderScene,
    folder: PathBuf,
}

/// All runs, seeds changing first; every scene is read before any of them starts.
pub fn tasks(file: &Path, grid: &Grid, seeds: u32, out: &Path) -> Result<Vec<Task>, Failure> {
    if seeds > 1 && grid.keys.iter().any(|swept| swept.key == "seed") {
        let message = "--seeds: `seed` is among the keys already; give one or the other";
        return Err(Failure::input(message));
    }
    let mut tasks = Vec::new();
    for combination in 0..grid.len() {
        let overrides = grid.overrides(combination);
        let first = powder_scene(file, &overrides)?.seed;
        for seed in first..first + u64::from(seeds) {
            let mut all = overrides.clone();
            if seeds > 1 {
                all.push(format!("seed={seed}"));
            }
            let scene = powder_scene(file, &all)?;
            let name = if all.is_empty() {
                "scene".to_owned()
            } else {
                all.join(",")
            };
            let folder = out.join("runs").join(&name);
            tasks.push(Task {
                name,
                scene,
                folder,
            });
        }
    }
    Ok(tasks)
}

/// The scene with overrides, if it is a powder.
fn powder_scene(file: &Path, overrides: &[String]) -> Result<PowderScene, Failure> {
    match scene::read_scene(file, overrides).map_err(Failure::input)? {
        Scene::Powder(scene) => Ok(*scene),
        _ => Err(Failure::input(format!(
            "{}: a sweep needs body = \"powder\"; use `tribos run` for other bodies",
            file.display()
        ))),
    }
}

/// Runs the tasks in `jobs` threads; summaries in the order of the tasks, whatever the threads do.
/// All runs are tried; the first that failed in that order is told.
pub fn run(tasks: &[Task], jobs: usize) -> Result<Vec<Value>, Failure> {
    let results = in_order(tasks.len(), jobs, |index| tasks[index].summary());
    let lost = || Err(Failure::run("a run ended without a result"));
    results
        .into_iter()
        .zip(tasks)
        .map(|(slot, task)| {
            let result = slot.unwrap_or_else(lost);
            result.map_err(|failure| task.named(failure))
        })
        .collect()
}

impl Task {
    /// The summary that is there, or that of a run, which goes on from its checkpoint if it can.
    fn summary(&self) -> Result<Value, Failure> {
        let file = self.folder.join("summary.json");
        if let Some(kept) = self.kept(&file) {
            return Ok(kept);
        }
        let simulate =
            |start| powder::simulate(&self.scene, &self.folder, start, PAUSE, Progress::Silent);
        let compaction = match simulate(Start::Resume) {
            // No checkpoint, or one of another scene.
            Err(Failure::Input(_)) => simulate(Start::Fresh)?,
            other => other?,
        };
        let outcome = compaction.outcome();
        let summary = outcome.json(&self.scene);
        write_atomically(&file, format!("{summary:#}\n").as_bytes())?;
        powder::forget_checkpoint(&self.folder)?;
        eprintln!(
            "{}: porosity {:.3} % after {} steps, {:.1} s",
            self.name,
            100.0 * outcome.porosity[1],
            outcome.steps,
            outcome.wall_seconds
        );
        Ok(summary)
    }

    /// The summary of an earlier run of the same scene.
    fn kept(&self, file: &Path) -> Option<Value> {
        let text = std::fs::read_to_string(file).ok()?;
        let summary: Value = serde_json::from_str(&text).ok()?;
        (summary["scene"] == self.scene.json()).then_some(summary)
    }

    /// A failure with the run's name before it.
    fn named(&self, failure: Failure) -> Failure {
        let name = &self.name;
        match failure {
            Failure::Input(message) => Failure::Input(format!("{name}: {message}")),
            Failure::Run(message) => Failure::Run(format!("{name}: {message}")),
            Failure::Mismatch(message) => Failure::Mismatch(format!("{name}: {message}")),
        }
    }
}
