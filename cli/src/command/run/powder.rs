//! Powders under a piston.

mod output;
mod picture;

pub use output::{report, write};
pub use picture::{State, packing};

use crate::failure::Failure;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tribos::powder::{Compaction, CompactionError};
use tribos::record::write_atomically;
use tribos::run::drive_watched;
use tribos::scene::PowderScene;

/// Whether a run starts or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// From the deposit.
    Fresh,
    /// From the checkpoint.
    Resume,
}

/// Who is told how far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The terminal, once a second.
    Told,
    /// Nobody.
    Silent,
}

/// How often the terminal is told.
const TOLD: Duration = Duration::from_secs(1);

/// Runs the scene to its end; a checkpoint in the folder is renewed after every `pause`.
pub fn simulate(
    scene: &PowderScene,
    out: &Path,
    start: Start,
    pause: Duration,
    progress: Progress,
) -> Result<Compaction, Failure> {
    let file = checkpoint(out);
    let mut compaction = match start {
        Start::Fresh => Compaction::new(scene)?,
        Start::Resume => Compaction::resume(scene, &kept(&file)?)?,
    };
    let (mut told, mut saved) = (Instant::now(), Instant::now());
    let mut sweeps = 0;
    let mut since = compaction.steps();
    drive_watched(&mut compaction, |compaction| {
        sweeps += compaction.last_step().effort.sweeps;
        if progress == Progress::Told && told.elapsed() >= TOLD {
            tell(compaction, sweeps, compaction.steps() - since);
            (told, sweeps, since) = (Instant::now(), 0, compaction.steps());
        }
        if compaction.steps() > 0 && saved.elapsed() >= pause {
            write_atomically(&file, compaction.checkpoint().as_bytes())?;
            saved = Instant::now();
        }
        Ok::<(), Failure>(())
    })?;
    Ok(compaction)
}

/// The checkpoint of a folder.
fn checkpoint(out: &Path) -> PathBuf {
    out.join("checkpoint.json")
}

/// The text of a checkpoint.
fn kept(file: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(file).map_err(|error| {
        let name = file.display();
        Failure::input(format!(
            "nothing to go on from: {name}: {error}; run without --resume"
        ))
    })
}

/// Takes away the checkpoint of a run that has left its results.
pub fn forget_checkpoint(out: &Path) -> Result<(), Failure> {
    let file = checkpoint(out);
    match std::fs::remove_file(&file) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(Failure::run(format!(
            "cannot remove {}: {error}",
            file.display()
        ))),
        _ => Ok(()),
    }
}

/// One line on standard error.
fn tell(compaction: &Compaction, sweeps: usize, steps: u64) {
    eprintln!(
        "step {:6}  height {:8.4}  porosity {:7.3} %  {:6.1} sweeps a step",
        compaction.steps(),
        compaction.height(),
        100.0 * compaction.porosity(),
        sweeps as f64 / steps.max(1) as f64
    );
}

impl From<CompactionError> for Failure {
    fn from(error: CompactionError) -> Self {
        match error {
            CompactionError::World(_) | CompactionError::Touch { .. } => Self::run(error),
            // The deposit, the laws or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}
