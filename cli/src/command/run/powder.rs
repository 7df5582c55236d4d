//! Powders under a piston.

mod output;
mod picture;

pub use output::{report, write};
pub use picture::{State, packing};

use super::film::{Film, Filmed};
use super::long::{Course, Progress, Start, TOLD, checkpoint, kept};
use crate::command::interrupt;
use crate::failure::Failure;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;
use tribos::powder::deposit::DepositError;
use tribos::powder::{Compaction, CompactionError, size};
use tribos::record::frames::{Bodies, Frame};
use tribos::record::write_atomically;
use tribos::run::drive_watched;
use tribos::scene::PowderScene;

/// Runs the scene to its end, with checkpoints and frames in the folder.
pub fn simulate(scene: &PowderScene, out: &Path, course: &Course) -> Result<Compaction, Failure> {
    let file = checkpoint(out);
    let mut compaction = begin(scene, &file, course)?;
    let mut film = Film::of(&compaction, out, course.start, course.frames)?;
    let (mut told, mut saved) = (Instant::now(), Instant::now());
    let mut sweeps = 0;
    let mut since = compaction.steps();
    drive_watched(&mut compaction, |compaction| {
        sweeps += compaction.last_step().effort.sweeps;
        if course.progress == Progress::Told && told.elapsed() >= TOLD {
            tell(compaction, sweeps, compaction.steps() - since);
            (told, sweeps, since) = (Instant::now(), 0, compaction.steps());
        }
        film.look(compaction);
        let is_due = compaction.steps() > 0 && saved.elapsed() >= course.pause;
        if is_due || interrupt::is_asked() {
            film.save()?;
            write_atomically(&file, compaction.checkpoint().as_bytes())?;
            saved = Instant::now();
        }
        if interrupt::is_asked() {
            let step = compaction.steps();
            return Err(course.ended(out, &format!("after step {step}")));
        }
        Ok::<(), Failure>(())
    })?;
    film.end(&compaction)?;
    Ok(compaction)
}

/// The deposit, with how far its growth is, or the state of the checkpoint.
fn begin(scene: &PowderScene, file: &Path, course: &Course) -> Result<Compaction, Failure> {
    let size = size(scene);
    super::size::check(&size, "spheres", course.allowed)?;
    let is_told = course.progress == Progress::Told;
    if is_told {
        crate::command::tell(format_args!("{}", super::size::told(&size, "spheres")));
    }
    let text = match course.start {
        Start::Fresh => None,
        Start::Resume => Some(kept(file)?),
    };
    let mut told = Instant::now();
    let begun = Compaction::begin(scene, text.as_deref(), |spheres| {
        if is_told && told.elapsed() >= TOLD {
            told = Instant::now();
            crate::command::tell(format_args!(
                "deposit: {spheres} spheres have fallen, about {:.0} will stay below the cut",
                size.bodies
            ));
        }
        if interrupt::is_asked() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    match begun {
        Err(CompactionError::Deposit(DepositError::Stopped)) => {
            Err(interrupt::ended_early("the deposit grew"))
        }
        begun => Ok(begun?),
    }
}

impl Filmed for Compaction {
    fn bodies(&self, limit: u64) -> Bodies {
        self.bodies(limit)
    }
    fn steps(&self) -> u64 {
        self.steps()
    }
    fn frame(&self) -> Frame {
        self.frame()
    }
}

/// One line on standard error.
fn tell(compaction: &Compaction, sweeps: usize, steps: u64) {
    crate::command::tell(format_args!(
        "step {:6}  height {:8.4}  porosity {:7.3} %  {:6.1} sweeps a step",
        compaction.steps(),
        compaction.height(),
        100.0 * compaction.porosity(),
        sweeps as f64 / steps.max(1) as f64
    ));
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
