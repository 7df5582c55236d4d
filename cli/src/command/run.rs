//! `tribos run`: a scene simulated, its results in a folder.

pub mod files;
mod path;
pub mod powder;
pub mod size;
pub mod tip;

use self::size::Allowed;
use super::digits::shown;
use super::progress::Meter;
use super::{interrupt, number};
use crate::failure::Failure;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::powder::Compaction;
use tribos::record::{CheckpointError, write_series};
use tribos::run::folder::{Broken, Contents, Lock, Manifest, OutputFolder, Sharing, is_finished};
use tribos::run::{
    CHECKPOINT, FRAMES, LongRun, RunError, Session, Start, forget_checkpoint, read_checkpoint,
};
use tribos::scene::{PowderScene, Scene, SliderScene, TipScene, Units, bodies};
use tribos::slide::{self, COLUMNS, SlideRun};
use tribos::tip::{TipError, build};
use tribos_report::figure::{Axis, Figure, Guide, Series};
use tribos_report::image;

/// Simulates the scene and writes summary.json, series.csv and a plot: motion.svg and motion.png of
/// a disk, path.svg and path.png of a body in the plane.
///
/// Of a powder: series.svg and .png, packing.svg and .png (spheres before and after, the forces),
/// and both states as initial and final .xyz (OVITO, ASE), .vtp and -contacts.vtp (ParaView).
///
/// Of a tip: angles.svg and .png (angles of the layers over time), tip.svg and .png (the atoms),
/// initial.data and final.data (LAMMPS, OVITO; types are the parts from below).
///
/// Of both: frames, the states of a film, which `tribos view DIR` shows in a browser.
#[derive(Debug, clap::Args)]
#[command(after_long_help = examples())]
pub struct Arguments {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    scene: PathBuf,
    /// Folder for the results; made if missing. Results of an earlier command in it go away first;
    /// files that no command of tribos wrote there are never replaced. A powder or a tip there that
    /// was broken off is refused: go on with --resume, or start with --anew.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Replace or add a key of the scene; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// A powder or a tip: go on from the checkpoint in DIR, to the same result as without the break.
    /// One that is finished is left as it is.
    #[arg(long)]
    resume: bool,
    /// Take away a powder or a tip in DIR that was broken off, and start.
    #[arg(long, conflicts_with = "resume")]
    anew: bool,
    /// A powder or a tip: seconds from one checkpoint in DIR to the next.
    #[arg(
        long,
        value_name = "SECONDS",
        default_value = "60",
        value_parser = number::not_negative,
        allow_negative_numbers = true
    )]
    checkpoint: f64,
    /// A powder or a tip: frames kept in DIR/frames at most, evenly spread over the steps; 0 for
    /// none. They change no result. [default: 100, with --resume as the run began]
    #[arg(long, value_name = "N", value_parser = frames)]
    frames: Option<u64>,
    /// A powder or a tip: run it even if it is expected to take more than 4 GB of memory.
    #[arg(long)]
    allow_large: bool,
}

/// The command's name in the folders that it writes.
pub const COMMAND: &str = "run";
/// The folder of a run that starts.
fn begin(
    out: &Path,
    scene: Value,
    files: &[&str],
    broken: Broken,
) -> Result<OutputFolder, Failure> {
    let contents = Contents {
        about: scene,
        broken,
        ..Contents::of(COMMAND, files)
    };
    Ok(OutputFolder::begin(out, &contents)?)
}

/// Refuses to go on with another scene than the folder's.
fn same_scene(kept: &Value, given: &Value) -> Result<(), Failure> {
    let empty = serde_json::Map::new();
    let [there, here] = [kept, given].map(|scene| scene.as_object().unwrap_or(&empty));
    let mut keys = here.keys().chain(there.keys());
    let Some(key) = keys.find(|key| there.get(*key) != here.get(*key)) else {
        return Ok(());
    };
    let told = |value: Option<&Value>| value.map_or("missing".into(), Value::to_string);
    Err(Failure::input(CheckpointError::Scene {
        key: key.clone(),
        kept: told(there.get(key)),
        given: told(here.get(key)),
    }))
}

/// The checkpoint of a folder.
fn checkpoint(out: &Path) -> PathBuf {
    out.join(CHECKPOINT)
}

/// Where the frames of a run are.
pub fn frames_folder(out: &Path) -> PathBuf {
    out.join(FRAMES)
}

/// What to do once a full disk has room: a long run loses what it did since its checkpoint.
fn how_to_go_on(out: &Path) -> String {
    let file = checkpoint(out);
    if file.exists() {
        let name = file.display();
        format!("Then go on from {name}: the same command with --resume.")
    } else {
        "Then give the same command again: there is no checkpoint yet.".into()
    }
}

/// A number of frames that can be kept.
fn frames(text: &str) -> Result<u64, String> {
    match text.trim().parse::<u64>() {
        Ok(1) | Err(_) => Err("give 0 for none, or a whole number from 2 up".into()),
        Ok(number) => Ok(number),
    }
}

/// Examples, and where the keys of a scene are told.
fn examples() -> String {
    let mut text = String::from(
        "Examples:\n  \
         tribos run disk --out out/disk\n  \
         tribos run my.toml --out out/mine\n  \
         tribos run scenes/disk.toml --out out/fast --set spin=50 --set alpha=0.5\n  \
         tribos run scenes/disk.toml --out out/verlet --set stepper=verlet --set time_step=1e-4\n  \
         tribos run scenes/cylinder.toml --out out/cylinder --set spin=-12\n  \
         tribos run scenes/curling-draw.toml --out out/draw --set model=pivot-slide\n  \
         tribos run scenes/compaction-small.toml --out out/powder --set rolling=0.3\n  \
         tribos run scenes/compaction-large.toml --out out/large --resume\n  \
         tribos run scenes/tip-irreversible.toml --out out/tip --set seed=2\n\
         Keys of a scene, by its body:\n",
    );
    for body in bodies() {
        text += &format!("  tribos scene keys {body}\n");
    }
    text
}

impl Arguments {
    /// Runs and writes.
    pub fn execute(self) -> Result<(), Failure> {
        let scene = super::scene::read(&self.scene, &self.overrides)?;
        if self.resume && !matches!(scene, Scene::Powder(_) | Scene::Tip(_)) {
            return Err(Failure::input(
                "--resume is for powders and tips only; this scene takes a moment, run it anew",
            ));
        }
        if self.frames.is_some() && !matches!(scene, Scene::Powder(_) | Scene::Tip(_)) {
            return Err(Failure::input(
                "--frames is for powders and tips only; `tribos view` shows this scene from its series",
            ));
        }
        let done = match scene {
            Scene::Disk(scene) => self.slide(&scene),
            Scene::Cylinder(scene) => path::run(&scene, &self.out, self.broken()),
            Scene::Pipe(scene) => path::run(&scene, &self.out, self.broken()),
            Scene::Curling(scene) => path::run(&scene, &self.out, self.broken()),
            Scene::Powder(scene) => self.compact(&scene),
            Scene::Tip(scene) => self.turn(&scene),
        };
        done.map_err(|failure| failure.going_on(&how_to_go_on(&self.out)))
    }

    /// A long run in its folder.
    fn session<R: LongRun>(&self, start: Start, folder: &OutputFolder) -> Session<'_, R> {
        let pause = Duration::try_from_secs_f64(self.checkpoint).unwrap_or(Duration::MAX);
        let session = Session::under(folder.lock().clone(), &self.out)
            .start(start)
            .checkpoint_every(pause);
        match self.frames {
            Some(limit) => session.frames(limit),
            None => session,
        }
    }

    /// A run that was interrupted says how to go on.
    fn failure<E: std::error::Error + Into<Failure>>(&self, error: RunError<E>) -> Failure {
        match error {
            RunError::Cancelled(step) => {
                interrupt::ended(&self.out, &format!("interrupted after step {step}"))
            }
            other => other.into(),
        }
    }

    /// What becomes of a run in the folder that was broken off.
    fn broken(&self) -> Broken {
        if self.anew {
            Broken::Replaced
        } else {
            Broken::Kept
        }
    }

    /// The folder of a long run, and where the run starts; none if it is finished.
    fn long(&self, scene: Value, later: &[&str]) -> Result<Option<(OutputFolder, Start)>, Failure> {
        interrupt::watch()?;
        let contents = Contents {
            about: scene,
            later,
            broken: self.broken(),
            ..Contents::of(COMMAND, files::UNDER_WAY)
        };
        if !self.resume {
            let folder = OutputFolder::begin(&self.out, &contents)?;
            return Ok(Some((folder, Start::Fresh)));
        }
        if !self.out.is_dir() {
            read_checkpoint(&checkpoint(&self.out))?;
        }
        let lock = Lock::take(&self.out, Sharing::Alone)?;
        let Some(start) = self.start(&contents.about)? else {
            let out = self.out.display();
            super::print(&format!("finished already; its results are in {out}\n"))?;
            return Ok(None);
        };
        let folder = OutputFolder::go_on_with(lock, &contents)?;
        // What was made from the frames of the unfinished run is out of date.
        folder.remove(files::is_made_from_frames)?;
        Ok(Some((folder, start)))
    }

    /// Where a run that goes on starts: broken off before its first checkpoint at the beginning, and
    /// nowhere if it is finished.
    fn start(&self, scene: &Value) -> Result<Option<Start>, Failure> {
        let file = checkpoint(&self.out);
        let begun = Manifest::read(&self.out)?.filter(|begun| begun.command == COMMAND);
        match begun {
            Some(begun) if file.exists() => same_scene(&begun.about, scene)?,
            Some(begun) if is_finished(&self.out) => {
                same_scene(&begun.about, scene)?;
                return Ok(None);
            }
            Some(begun) if begun.about == *scene => {
                super::tell(format_args!("no checkpoint yet: from the start"));
                return Ok(Some(Start::Fresh));
            }
            None if file.exists() => {}
            _ => {
                read_checkpoint(&file)?;
            }
        }
        Ok(Some(Start::Resume))
    }

    fn turn(&self, scene: &TipScene) -> Result<(), Failure> {
        size::check(
            &tribos::tip::size(scene),
            "atoms",
            Allowed::of(self.allow_large),
        )?;
        // All refusals come before the folder is touched.
        build(scene).map_err(TipError::Build)?;
        let Some((folder, start)) = self.long(scene.json(), files::TIP)? else {
            return Ok(());
        };
        // From its end on a break costs no more than the results.
        let run = tip::simulate(scene, self.session(start, &folder))
            .map_err(|error| self.failure(error))?;
        folder.remove(files::is_made_from_frames)?;
        tip::write(scene, &run, &folder)?;
        folder.check()?;
        forget_checkpoint(&self.out)?;
        tip::report(&run.outcome(), &self.out)
    }

    fn compact(&self, scene: &PowderScene) -> Result<(), Failure> {
        let size = tribos::powder::size(scene);
        size::check(&size, "spheres", Allowed::of(self.allow_large))?;
        // All refusals come before the folder is touched.
        Compaction::check(scene)?;
        let Some((folder, start)) = self.long(scene.json(), files::POWDER)? else {
            return Ok(());
        };
        // From its end on a break costs no more than the results.
        let compaction = powder::simulate(scene, self.session(start, &folder))
            .map_err(|error| self.failure(error))?;
        folder.remove(files::is_made_from_frames)?;
        let outcome = compaction.outcome();
        powder::write(scene, &compaction, &outcome, &folder)?;
        folder.check()?;
        forget_checkpoint(&self.out)?;
        powder::report(&outcome, &self.out)
    }

    fn slide(&self, scene: &SliderScene) -> Result<(), Failure> {
        let mut meter = Meter::new();
        let result = slide::run(scene, |done| {
            if meter.is_due(done) {
                meter.tell(done, format_args!("sliding"));
            }
        })?;
        let folder = begin(&self.out, scene.json(), files::DISK, self.broken())?;
        let rows = result.series.iter().map(<[f64; COLUMNS.len()]>::as_slice);
        write_series(&self.out.join("series.csv"), &COLUMNS, rows)?;
        image::write_both(&self.out, "motion", &figure(scene, &result))?;
        folder.seal(&["series.csv"])?;
        // Last: a summary stands only beside complete results.
        let summary = format!("{:#}\n", result.outcome.json(scene));
        folder.write("summary.json", summary.as_bytes())?;
        self.report(scene, &result)
    }

    /// A few lines for the person at the terminal.
    fn report(&self, scene: &SliderScene, result: &SlideRun) -> Result<(), Failure> {
        let outcome = &result.outcome;
        let (s, m) = match scene.units {
            Units::Si => (" s", " m"),
            Units::Dimensionless => ("", ""),
        };
        super::print(&format!(
            "ending        {:?} after {} steps\n\
             time          {}{s}\n\
             distance      {}{m}\n\
             angle         {} rad\n\
             final ratio   {}\n\
             energy error  {:.1e} of the initial energy\n\
             written to    {}\n",
            outcome.ending,
            outcome.steps,
            shown(outcome.time),
            shown(outcome.distance),
            shown(outcome.angle),
            shown(outcome.ratio),
            outcome.energy_error,
            self.out.display()
        ))
    }
}

/// Sliding and rim speed over time.
fn figure(scene: &SliderScene, result: &SlideRun) -> Figure {
    let unit = match scene.units {
        Units::Si => [" [s]", " [m/s]"],
        Units::Dimensionless => ["", " [√(gR)]"],
    };
    let curve = |value: &dyn Fn(&[f64; COLUMNS.len()]) -> f64| {
        result
            .series
            .iter()
            .map(|row| (row[0], value(row)))
            .collect::<Vec<_>>()
    };
    let figure = Figure::new(
        match scene.law {
            Some(law) => format!("Sliding and spinning to rest, {law}"),
            None => format!("Sliding and spinning to rest, α = {}", scene.alpha),
        },
        Axis::linear(format!("time{}", unit[0])),
        Axis::linear(format!("speed{}", unit[1])),
    )
    .series(Series::line("sliding, v", curve(&|row| row[1])))
    .series(Series::line(
        "rim, |ω|R",
        curve(&|row| (row[2] * scene.radius).abs()),
    ));
    match result.outcome.ending {
        slide::Ending::Rest => figure.guide(Guide::vertical(result.outcome.time, "rest")),
        _ => figure,
    }
}
