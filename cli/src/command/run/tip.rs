//! Tips turned on a substrate.

mod picture;

use super::film::{Film, Filmed};
use super::long::{Course, Progress, Start, Unfinished, checkpoint, kept};
use crate::command::digits::shown;
use crate::command::interrupt;
use crate::command::progress::Meter;
use crate::command::run::files;
use crate::failure::Failure;
use crate::folder::OutputFolder;
use crate::report::image;
use std::path::Path;
use std::time::Instant;
use tribos::record::frames::{Bodies, Frame};
use tribos::record::{self, write_atomically_there};
use tribos::run::{Simulation, drive_watched};
use tribos::scene::TipScene;
use tribos::tip::export;
use tribos::tip::{Outcome, TipError, TipRun, Verdict, size};

pub use picture::{atoms, series};

/// Runs the scene to its end, with checkpoints and frames in the folder.
pub fn simulate(scene: &TipScene, out: &Path, course: &Course<'_>) -> Result<TipRun, Unfinished> {
    turned(scene, out, course).map_err(|end| course.explained(end))
}

fn turned(scene: &TipScene, out: &Path, course: &Course<'_>) -> Result<TipRun, Unfinished> {
    let file = checkpoint(out);
    let size = size(scene);
    super::size::check(&size, "atoms", course.allowed).map_err(Unfinished::Refused)?;
    if course.progress == Progress::Told {
        crate::command::tell(format_args!("{}", super::size::told(&size, "atoms")));
    }
    let mut run = match course.start {
        Start::Fresh => TipRun::new(scene)?,
        Start::Resume => TipRun::resume(scene, &kept(&file)?)?,
    };
    course.lock.check()?;
    let mut film = Film::of(&run, out, course.start, course.frames)?;
    let (mut meter, mut saved) = (Meter::new(), Instant::now());
    drive_watched(&mut run, |run| {
        if course.progress == Progress::Told && meter.is_due(run.progress()) {
            let angle = run.angle().to_degrees();
            meter.tell(
                run.progress(),
                format_args!("time {:9.2}  angle {angle:8.3} degrees", run.time()),
            );
        }
        film.look(run);
        let is_due = run.series().len() > 1 && saved.elapsed() >= course.pause;
        if is_due || interrupt::is_asked() {
            course.lock.check()?;
            film.save()?;
            course.lock.check()?;
            write_atomically_there(&file, run.checkpoint().as_bytes())?;
            saved = Instant::now();
        }
        if interrupt::is_asked() {
            let time = run.time();
            return Err(course.ended(out, &format!("at time {time:.2}")).into());
        }
        Ok::<(), Unfinished>(())
    })?;
    course.lock.check()?;
    film.end(&run)?;
    Ok(run)
}

impl Filmed for TipRun {
    fn bodies(&self, limit: u64) -> Bodies {
        self.bodies(limit)
    }
    fn steps(&self) -> u64 {
        self.system().steps()
    }
    fn frame(&self) -> Frame {
        self.frame()
    }
}

/// The series as CSV.
pub fn write_series(run: &TipRun, out: &Path) -> Result<(), Failure> {
    let columns = run.columns();
    let names: Vec<&str> = columns.iter().map(String::as_str).collect();
    let rows = run.series().iter().map(Vec::as_slice);
    Ok(record::write_series(&out.join("series.csv"), &names, rows)?)
}

/// Writes series, pictures, the first and the last state and at last the summary.
pub fn write(scene: &TipScene, run: &TipRun, folder: &OutputFolder) -> Result<(), Failure> {
    folder.add(files::TIP)?;
    let out = folder.path();
    let outcome = run.outcome();
    write_series(run, out)?;
    image::write_both(out, "angles", &series(scene, run, &outcome))?;
    if interrupt::is_asked() {
        return Err(interrupt::ended(out, "while results were written"));
    }
    folder.check()?;
    image::write_both(out, "tip", &picture::both_ends(scene, run)?)?;
    let start = export::start(scene).map_err(Failure::input)?;
    folder.write("initial.data", start.data.as_bytes())?;
    let atoms = run.system().atoms();
    let velocities = run.system().velocities_on_step();
    let end = export::data(scene, &atoms.positions, &velocities, run.parts());
    folder.write("final.data", end.as_bytes())?;
    let summary = format!("{:#}\n", outcome.json(scene));
    folder.write("summary.json", summary.as_bytes())
}

/// A few lines for the person at the terminal.
pub fn report(outcome: &Outcome, out: &Path) -> Result<(), Failure> {
    let verdict = match outcome.verdict {
        Verdict::Reversible => "reversible: the driven layers turned back",
        Verdict::Irreversible => "irreversible: the driven layers did not turn back",
        Verdict::Open => "open: the scene ends before it shows",
    };
    let interfaces = |list: &[usize]| match list {
        [] => "none".to_owned(),
        list => list
            .iter()
            .map(usize::to_string)
            .collect::<Vec<_>>()
            .join(", "),
    };
    let angles: Vec<String> = outcome
        .layer_angles
        .iter()
        .map(|&angle| shown(angle))
        .collect();
    let mut text = format!(
        "verdict       {verdict}\n\
         angle         {} degrees driven, {} at the end, {} at most\n\
         layers        {} degrees at the end, from below\n\
         slipped       while driven {}, for good {} (0 is the contact, k above the tip's layer k)\n\
         temperature   {} eps/k_B of the tip's bath\n",
        shown(outcome.driven_angle),
        shown(outcome.final_angle),
        shown(outcome.largest_angle),
        angles.join(", "),
        interfaces(&outcome.slipped_driven),
        interfaces(&outcome.slipped),
        shown(outcome.tip_temperature),
    );
    for plateau in &outcome.plateaus {
        text += &format!(
            "locked        {} degrees from {} to {}\n",
            shown(plateau.angle),
            shown(plateau.from),
            shown(plateau.to)
        );
    }
    text += &format!("written to    {}\n", out.display());
    crate::command::print(&text)
}

impl From<TipError> for Unfinished {
    fn from(error: TipError) -> Self {
        match error {
            TipError::Checkpoint(_) => Self::Stopped(error.into()),
            _ => Self::Refused(error.into()),
        }
    }
}

impl From<TipError> for Failure {
    fn from(error: TipError) -> Self {
        match error {
            TipError::System(_) => Self::run(error),
            // The scene or the checkpoint cannot be used.
            _ => Self::input(error),
        }
    }
}
