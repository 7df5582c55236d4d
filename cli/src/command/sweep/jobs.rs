//! The runs of a sweep, some at a time.

use super::body::Body;
use super::progress::Progress;
use super::{refusal, summary};
use crate::command::interrupt;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tribos::record::{read_text, write_atomically_there};
use tribos::run::folder::{Lock, LockMode, LockOutcome, remove_file, remove_unfinished};
use tribos::run::{forget_checkpoint, in_order};
use tribos::scene::with_present_names;

/// Bytes of a summary at most.
const MOST_BYTES: u64 = 64 << 20;

/// One run.
#[derive(Debug)]
pub struct Task {
    /// Its overrides, or "scene" if there are none.
    pub name: String,
    /// What is run, or why it cannot be.
    pub body: Result<Body, String>,
    folder: PathBuf,
}

/// How the cores are shared: runs at a time, and threads of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct CoreAllocation {
    jobs: usize,
    threads: usize,
}

impl CoreAllocation {
    /// As many runs at a time as there are cores unless told otherwise; never more threads than
    /// cores, unless more runs are asked for.
    fn new(asked: Option<usize>, cores: usize, runs: usize) -> Self {
        let jobs = asked.unwrap_or(cores).min(runs).max(1);
        let threads = (cores / jobs).max(1);
        Self { jobs, threads }
    }
}

/// Summaries that are there already, in the order of the tasks.
pub fn kept(tasks: &[Task]) -> Vec<Option<Value>> {
    tasks.iter().map(Task::kept).collect()
}

/// Runs those of the tasks that have no summary yet, whatever the threads do to the same results.
/// All are tried, unless the disk is full or the folder of the sweep, which `lock` holds, is lost; the
/// first that failed in the order of the tasks is told.
pub fn run(tasks: &[&Task], asked: Option<usize>, lock: &Lock) -> Result<(), Failure> {
    let missing: Vec<&Task> = tasks
        .iter()
        .copied()
        .filter(|task| task.kept().is_none())
        .collect();
    // The number of threads that the environment or the machine allows.
    let share = CoreAllocation::new(asked, rayon::current_num_threads(), missing.len());
    let possible = tasks.iter().filter(|task| task.body.is_ok()).count();
    let kept = possible - missing.len();
    let progress = Progress::start(possible, kept, share.jobs);
    for task in missing.iter().filter(|task| task.is_changed()) {
        crate::command::note(format_args!(
            "{}: its summary was changed after the run; the run is repeated",
            task.name
        ));
    }
    let full = AtomicBool::new(false);
    let results = in_order(missing.len(), share.jobs, |index| {
        if full.load(Ordering::Relaxed) || interrupt::is_asked() {
            return None;
        }
        // The folder of a run is made if missing: not where the sweep is no more.
        let result = lock
            .check()
            .map_err(Failure::from)
            .and_then(|()| missing[index].run(share.threads, &progress));
        if matches!(result, Err(Failure::NoRoom(_) | Failure::Interrupted(_))) {
            full.store(true, Ordering::Relaxed);
        }
        Some(result)
    });
    let lost = || Some(Err(Failure::run("a run ended without a result")));
    let mut failures = Vec::new();
    for (slot, task) in results.into_iter().zip(&missing) {
        if let Some(Err(failure)) = slot.unwrap_or_else(lost) {
            failures.push(failure.within(&task.name));
        }
    }
    let done = format!("{} of {} runs are done.", progress.done(), tasks.len());
    if interrupt::is_asked() {
        return Err(Failure::Interrupted(format!(
            "interrupted; {done} The same command continues the others where they stopped."
        )));
    }
    let first = failures.into_iter().next();
    first.map_or(Ok(()), |failure| Err(failure.resume_hint(&done)))
}

impl Task {
    /// The run of a body with overrides; its results go to a folder in `out`.
    pub fn new(overrides: &[String], body: Result<Body, String>, out: &Path) -> Self {
        let name = match overrides {
            [] => "scene".to_owned(),
            all => all.join(","),
        };
        let folder = out.join("runs").join(&name);
        Self { name, body, folder }
    }

    fn file(&self) -> PathBuf {
        self.folder.join("summary.json")
    }

    /// Runs with so many threads and leaves the summary.
    fn run(&self, threads: usize, progress: &Progress) -> Result<(), Failure> {
        let began = Instant::now();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| Failure::run(format!("cannot start a thread: {error}")))?;
        let body = self.body.as_ref().map_err(Failure::input)?;
        // The same run may be part of another process's share.
        let lock = match Lock::attempt(&self.folder, LockMode::Alone)? {
            LockOutcome::Taken(lock) => Arc::new(lock),
            LockOutcome::InUse(told) => {
                return Err(Failure::run(format!(
                    "{told}; when it has ended, the same command continues"
                )));
            }
        };
        if self.kept().is_some() {
            progress.ended(&self.name, "taken by another process", began.elapsed());
            return Ok(());
        }
        remove_unfinished(&self.folder)?;
        // What another scene of this name left.
        for name in ["summary.json", "series.csv"] {
            remove_file(&self.folder.join(name))?;
        }
        let (summary, told) = pool.install(|| body.run(&lock))?;
        lock.check()?;
        write_atomically_there(&self.file(), summary::sealed(&summary).as_bytes())?;
        forget_checkpoint(&self.folder)?;
        progress.ended(&self.name, &told, began.elapsed());
        Ok(())
    }

    /// The summary of an earlier run of the same scene, or of one that cannot be run.
    fn kept(&self) -> Option<Value> {
        let body = match &self.body {
            Ok(body) => body,
            Err(reason) => {
                let mut summary = json!({});
                refusal::note(&mut summary, reason);
                return Some(summary);
            }
        };
        let text = read_text(&self.file(), MOST_BYTES).ok()?;
        let summary = summary::unsealed(&text)?;
        (with_present_names(&summary["scene"]) == body.scene().json()).then_some(summary)
    }

    /// Whether there is a summary that is not as a run left it.
    pub fn is_changed(&self) -> bool {
        let text = read_text(&self.file(), MOST_BYTES);
        text.is_ok_and(|text| summary::unsealed(&text).is_none())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cores_are_shared_without_a_thread_too_many() {
        let share = |asked, cores, runs| {
            let CoreAllocation { jobs, threads } = CoreAllocation::new(asked, cores, runs);
            [jobs, threads]
        };
        assert_eq!(share(None, 8, 100), [8, 1]);
        assert_eq!(share(None, 8, 3), [3, 2]);
        assert_eq!(share(Some(2), 8, 100), [2, 4]);
        assert_eq!(share(Some(16), 8, 100), [16, 1]);
        assert_eq!(share(None, 8, 0), [1, 8]);
    }
}
