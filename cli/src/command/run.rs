//! `tribos run`: a scene simulated, its results in a folder.

pub mod files;
pub mod frontend;
pub mod long;
pub mod motion;
pub mod packing;
pub mod path;
pub mod request;
pub mod resource_check;

pub use request::COMMAND;

use self::frontend::Frontend;
use self::request::{Pictures, RunRequest, how_to_go_on};
use self::resource_check::MemoryPermission;
use super::{bodies, number};
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::run::FRAMES;
use tribos::run::folder::InterruptedRunPolicy;
use tribos::scene::bodies as names;

/// Simulate the scene and write summary.json, series.csv and a plot: motion.svg and motion.png of
/// a disk and of bodies that hold and slip, path.svg and path.png of a body in the plane.
///
/// Of a powder or grains: series.svg and .png, packing.svg and .png (spheres before and after, the forces),
/// and both states as initial and final .xyz (OVITO, ASE), .vtp and -contacts.vtp (ParaView).
///
/// Of a tip: angles.svg and .png (angles of the layers over time), tip.svg and .png (the atoms),
/// initial.data and final.data (LAMMPS, OVITO; types are the parts from below).
///
/// Of a gas: series.svg and .png (temperatures beside theory, clusters), spheres.svg and .png, and the last
/// state as final.xyz and final.vtp.
///
/// Of all these: frames, the states of a film, which `tribos view DIR` shows in a browser.
#[derive(Debug, clap::Args)]
#[command(after_long_help = examples())]
pub struct Arguments {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    scene: PathBuf,
    /// Folder for the results, created if missing. Results of an earlier command in it are removed
    /// first; files that tribos did not write are never replaced. A folder with an interrupted run of
    /// a powder, grains, a gas or a tip is refused: continue it with --resume or discard it with --anew.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Replace or add a key of the scene, or leave one out (`KEY=`); may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Powders, grains, gases and tips: continue from the checkpoint in DIR, to the same result as without the
    /// interruption. A finished run is not changed.
    #[arg(long)]
    resume: bool,
    /// Powders, grains, gases and tips: discard the interrupted run in DIR and start from the beginning.
    #[arg(long, conflicts_with = "resume")]
    anew: bool,
    /// Powders, grains, gases and tips: seconds between checkpoints in DIR.
    /// [default: 60]
    #[arg(long, value_name = "SECONDS", value_parser = number::pause)]
    #[arg(allow_negative_numbers = true)]
    checkpoint: Option<Duration>,
    /// Powders, grains, gases and tips: largest number of frames kept in DIR/frames, evenly spread over the steps;
    /// 0 for none. Frames do not change the results. [default: 100, or with --resume the number that
    /// the run began with]
    #[arg(long, value_name = "N", value_parser = frames)]
    frames: Option<u64>,
    /// Powders, grains, gases and tips: run even if more than 4 GB of memory is expected.
    #[arg(long)]
    allow_large: bool,
}

/// Usual time between checkpoints.
const PAUSE: Duration = Duration::from_secs(60);

/// Where the frames of a run are.
pub fn frames_folder(out: &Path) -> PathBuf {
    out.join(FRAMES)
}

/// A number of frames that can be kept.
fn frames(text: &str) -> Result<u64, String> {
    match text.trim().parse::<u64>() {
        Ok(1) | Err(_) => Err("give 0 for none, or a whole number from 2 up".into()),
        Ok(number) => Ok(number),
    }
}

/// Examples, and the commands that list the keys of a scene.
fn examples() -> String {
    let mut text = String::from(
        "Examples:\n  \
         tribos run disk --out out/disk\n  \
         tribos run my.toml --out out/mine\n  \
         tribos run scenes/disk.toml --out out/fast --set spin=50 --set alpha=0.5\n  \
         tribos run scenes/disk.toml --out out/verlet --set integrator=verlet --set time_step=1e-4\n  \
         tribos run scenes/cylinder.toml --out out/cylinder --set spin=-12\n  \
         tribos run scenes/curling-draw.toml --out out/draw --set model=pivot-slide\n  \
         tribos run scenes/compaction-small.toml --out out/powder --set mu_rolling=0.3\n  \
         tribos run scenes/compaction-large.toml --out out/large --resume\n  \
         tribos run scenes/tip-irreversible.toml --out out/tip --set seed=2\n\
         Keys of a scene, by its body:\n",
    );
    for body in names() {
        text += &format!("  tribos scene keys {body}\n");
    }
    text
}

impl Arguments {
    /// Runs and writes.
    pub fn execute(self) -> Result<(), Failure> {
        let scene = super::scene::read(&self.scene, &self.overrides)?;
        let body = bodies::of(&scene);
        if self.resume && !body.is_long() {
            return Err(Failure::input(
                "--resume is for powders, grains, gases and tips only; this scene runs in a moment, run it again",
            ));
        }
        if self.frames.is_some() && !body.is_long() {
            return Err(Failure::input(
                "--frames is for powders, grains, gases and tips only; `tribos view` shows this scene from its series",
            ));
        }
        let long_only = [
            ("--checkpoint", self.checkpoint.is_some()),
            ("--allow-large", self.allow_large),
        ];
        let idle = long_only.iter().find(|(_, is_given)| *is_given);
        if let (Some((option, _)), false) = (idle, body.is_long()) {
            return Err(Failure::input(format!(
                "{option} is for powders, grains, gases and tips only; this scene runs in a moment"
            )));
        }
        let done = body.simulate(&RunRequest {
            out: &self.out,
            broken: if self.anew {
                InterruptedRunPolicy::Replaced
            } else {
                InterruptedRunPolicy::Kept
            },
            resume: self.resume,
            pause: self.checkpoint.unwrap_or(PAUSE),
            frames: self.frames,
            allowed: MemoryPermission::of(self.allow_large),
            pictures: Pictures::Drawn,
            caller: Frontend::Terminal,
        });
        done.map_err(|failure| failure.resume_hint(&how_to_go_on(&self.out)))
    }
}
