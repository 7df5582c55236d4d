//! The runs of a sweep, some at a time.

use super::grid::Grid;
use super::kind::{self, Kind};
use crate::command::parallel::in_order;
use crate::command::run::long::{Course, Progress, Start, forget_checkpoint};
use crate::command::run::{powder, tip};
use crate::failure::Failure;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::record::write_atomically;
use tribos::scene::{self, PowderScene, Scene, TipScene};

/// Time from one checkpoint of a run to the next.
const PAUSE: Duration = Duration::from_secs(60);

/// A scene that a sweep can run.
#[derive(Debug)]
enum Body {
    Powder(Box<PowderScene>),
    Tip(Box<TipScene>),
}

/// One run.
#[derive(Debug)]
pub struct Task {
    name: String,
    body: Body,
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
        let first = body(file, &overrides)?.seed();
        for seed in first..first + u64::from(seeds) {
            let mut all = overrides.clone();
            if seeds > 1 {
                all.push(format!("seed={seed}"));
            }
            let body = body(file, &all)?;
            let name = if all.is_empty() {
                "scene".to_owned()
            } else {
                all.join(",")
            };
            let folder = out.join("runs").join(&name);
            tasks.push(Task { name, body, folder });
        }
    }
    Ok(tasks)
}

/// The scene with overrides, if it is one of a sweep.
fn body(file: &Path, overrides: &[String]) -> Result<Body, Failure> {
    match scene::read_scene(file, overrides).map_err(Failure::input)? {
        Scene::Powder(scene) => Ok(Body::Powder(scene)),
        Scene::Tip(scene) => Ok(Body::Tip(scene)),
        _ => Err(Failure::input(format!(
            "{}: a sweep needs body = \"powder\" or \"tip\"; use `tribos run` for other bodies",
            file.display()
        ))),
    }
}

/// What is made of the summaries: all tasks are of one body.
pub fn kind(tasks: &[Task]) -> &'static Kind {
    match tasks.first().map(|task| &task.body) {
        Some(Body::Tip(_)) => &kind::TIP,
        _ => &kind::POWDER,
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

impl Body {
    fn seed(&self) -> u64 {
        match self {
            Self::Powder(scene) => scene.seed,
            Self::Tip(scene) => scene.seed,
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Powder(scene) => scene.json(),
            Self::Tip(scene) => scene.json(),
        }
    }

    /// Runs to the end, on from a checkpoint if there is one: the summary, and a line about it.
    fn run(&self, folder: &Path) -> Result<(Value, String), Failure> {
        match self {
            Self::Powder(scene) => {
                let run = resumed(|start| powder::simulate(scene, folder, &course(start)))?;
                let outcome = run.outcome();
                let told = format!(
                    "porosity {:.3} % after {} steps, {:.1} s",
                    100.0 * outcome.porosity[1],
                    outcome.steps,
                    outcome.wall_seconds
                );
                Ok((outcome.json(scene), told))
            }
            Self::Tip(scene) => {
                let run = resumed(|start| tip::simulate(scene, folder, &course(start)))?;
                let outcome = run.outcome();
                tip::write_series(&run, folder)?;
                let told = format!(
                    "{:.2} degrees driven, {:.2} after it",
                    outcome.driven_angle, outcome.final_angle
                );
                Ok((outcome.json(scene), told))
            }
        }
    }
}

/// Runs of a sweep keep checkpoints, no frames, and their peace.
fn course(start: Start) -> Course {
    Course {
        start,
        pause: PAUSE,
        frames: Some(0),
        progress: Progress::Silent,
    }
}

/// A run on from its checkpoint, or from the start where there is none of the same scene.
fn resumed<R>(simulate: impl Fn(Start) -> Result<R, Failure>) -> Result<R, Failure> {
    match simulate(Start::Resume) {
        Err(Failure::Input(_)) => simulate(Start::Fresh),
        other => other,
    }
}

impl Task {
    /// The summary that is there, or that of a run, which goes on from its checkpoint if it can.
    fn summary(&self) -> Result<Value, Failure> {
        let file = self.folder.join("summary.json");
        if let Some(kept) = self.kept(&file) {
            return Ok(kept);
        }
        let (summary, told) = self.body.run(&self.folder)?;
        write_atomically(&file, format!("{summary:#}\n").as_bytes())?;
        forget_checkpoint(&self.folder)?;
        eprintln!("{}: {told}", self.name);
        Ok(summary)
    }

    /// The summary of an earlier run of the same scene.
    fn kept(&self, file: &Path) -> Option<Value> {
        let text = std::fs::read_to_string(file).ok()?;
        let summary: Value = serde_json::from_str(&text).ok()?;
        (summary["scene"] == self.body.json()).then_some(summary)
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
