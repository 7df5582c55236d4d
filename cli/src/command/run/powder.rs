//! Powders under a piston.

mod output;
mod picture;

pub use output::{report, write};
pub use picture::{State, packing};

use super::film::{Film, Filmed};
use super::long::{Course, Progress, Start, Unfinished, checkpoint, kept};
use crate::command::interrupt;
use crate::command::progress::Meter;
use crate::failure::Failure;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;
use tribos::powder::deposit::DepositError;
use tribos::powder::{Compaction, CompactionError, size};
use tribos::record::frames::{Bodies, Frame};
use tribos::record::write_atomically_there;
use tribos::run::{Simulation, drive_watched};
use tribos::scene::PowderScene;

/// Runs the scene to its end, with checkpoints and frames in the folder.
pub fn simulate(
    scene: &PowderScene,
    out: &Path,
    course: &Course<'_>,
) -> Result<Compaction, Unfinished> {
    compacted(scene, out, course).map_err(|end| course.explained(end))
}

fn compacted(
    scene: &PowderScene,
    out: &Path,
    course: &Course<'_>,
) -> Result<Compaction, Unfinished> {
    let file = checkpoint(out);
    let mut compaction = begin(scene, &file, course)?;
    course.lock.check()?;
    let mut film = Film::of(&compaction, out, course.start, course.frames)?;
    let (mut meter, mut saved) = (Meter::new(), Instant::now());
    let mut sweeps = 0;
    let mut since = compaction.steps();
    drive_watched(&mut compaction, |compaction| {
        sweeps += compaction.last_step().effort.sweeps;
        if course.progress == Progress::Told && meter.is_due(compaction.progress()) {
            let each = sweeps as f64 / (compaction.steps() - since).max(1) as f64;
            tell(&mut meter, scene, compaction, each);
            (sweeps, since) = (0, compaction.steps());
        }
        film.look(compaction);
        let is_due = compaction.steps() > 0 && saved.elapsed() >= course.pause;
        if is_due || interrupt::is_asked() {
            course.lock.check()?;
            film.save()?;
            course.lock.check()?;
            write_atomically_there(&file, compaction.checkpoint().as_bytes())?;
            saved = Instant::now();
        }
        if interrupt::is_asked() {
            let step = compaction.steps();
            return Err(course.ended(out, &format!("after step {step}")).into());
        }
        Ok::<(), Unfinished>(())
    })?;
    course.lock.check()?;
    film.end(&compaction)?;
    Ok(compaction)
}

/// The deposit, with how far its growth is, or the state of the checkpoint.
fn begin(scene: &PowderScene, file: &Path, course: &Course<'_>) -> Result<Compaction, Unfinished> {
    let size = size(scene);
    super::size::check(&size, "spheres", course.allowed).map_err(Unfinished::Refused)?;
    let is_told = course.progress == Progress::Told;
    if is_told {
        crate::command::tell(format_args!("{}", super::size::told(&size, "spheres")));
    }
    let text = match course.start {
        Start::Fresh => None,
        Start::Resume => Some(kept(file)?),
    };
    let mut meter = Meter::new();
    let begun = Compaction::begin(scene, text.as_deref(), |spheres| {
        if is_told && meter.is_due(0.0) {
            meter.tell_open(format_args!(
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
            Err(interrupt::ended_early("the deposit grew").into())
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

/// How far a compaction is: its end is known where a time is given, or so few steps that they may
/// end it before the packing is blocked.
fn tell(meter: &mut Meter, scene: &PowderScene, compaction: &Compaction, sweeps: f64) {
    /// A packing is seldom blocked within fewer steps.
    const FEW: u64 = 5_000;
    let words = format!(
        "step {:6}  height {:8.4}  porosity {:7.3} %  {sweeps:6.1} sweeps a step",
        compaction.steps(),
        compaction.height(),
        100.0 * compaction.porosity()
    );
    if scene.duration.is_some() || scene.steps <= FEW {
        meter.tell(compaction.progress(), format_args!("{words}"));
    } else {
        meter.tell_open(format_args!("{words}"));
    }
}

impl From<CompactionError> for Unfinished {
    fn from(error: CompactionError) -> Self {
        match error {
            CompactionError::Checkpoint(_) => Self::Stopped(error.into()),
            _ => Self::Refused(error.into()),
        }
    }
}

impl From<CompactionError> for Failure {
    fn from(error: CompactionError) -> Self {
        match error {
            CompactionError::World(_)
            | CompactionError::Touch { .. }
            | CompactionError::NotFinite { .. } => Self::run(error),
            // The deposit, the laws or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}
