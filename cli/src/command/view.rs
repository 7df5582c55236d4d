//! `tribos view`: a run as a film.

mod colors;
mod encoder;
mod path;
mod solid;
mod still;

use self::colors::Paint;
use self::solid::Solid;
use crate::command::run::{COMMAND, frames_folder};
use crate::failure::Failure;
use crate::folder::Manifest;
use crate::report::player::Film;
use serde_json::Value;
use std::path::{Path, PathBuf};
use tribos::record::frames::FrameFolder;
use tribos::record::{read_text, write_atomically};

/// Bytes of a summary at most.
const MOST_BYTES: u64 = 64 << 20;

/// Writes DIR/view.html, a page that plays the run in a browser, from a file and without a network.
///
/// Powders and tips are shown from the frames that `tribos run` keeps in DIR/frames, bodies in the
/// plane from series.csv and summary.json.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The folder of a run.
    folder: PathBuf,
    /// Where the page goes. [default: DIR/view.html]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// PNG pictures of these frames instead of a page, into DIR/still-<frame>.png: numbers from 1,
    /// or `last`.
    #[arg(long, value_name = "FRAMES", value_delimiter = ',', value_parser = still::which)]
    still: Vec<still::Which>,
    /// A film file instead of a page; needs ffmpeg on the PATH. Ends in .mp4, .webm or .gif.
    #[arg(long, value_name = "FILE", value_parser = encoder::film_name)]
    film: Option<PathBuf>,
    /// Frames a second of a film file.
    #[arg(long, default_value = "20", value_parser = clap::value_parser!(u32).range(1..=100), requires = "film")]
    rate: u32,
    /// What colours pictures and film files. [default: layer, of a tip part]
    #[arg(long, value_enum)]
    color: Option<Paint>,
    /// In pictures and film files the normal forces instead of the spheres.
    #[arg(long, conflicts_with = "color")]
    network: bool,
}

const EXAMPLES: &str = "Examples:\n  \
    tribos run scenes/compaction-small.toml --out out/powder && tribos view out/powder\n  \
    tribos view out/powder --still 1,last --color coordination\n  \
    tribos view out/powder --film out/forces.mp4 --network --rate 25\n  \
    tribos run scenes/cylinder.toml --out out/cylinder && tribos view out/cylinder\n";

impl Arguments {
    /// Reads the run, writes what is asked for.
    pub fn execute(self) -> Result<(), Failure> {
        let frames = frames_folder(&self.folder);
        let run = self.run()?;
        let summary = summary(&self.folder)?;
        self.refuse_other(
            "summary.json",
            summary.as_ref().map(|kept| &kept["scene"]),
            &run,
        )?;
        let bodies = FrameFolder::bodies(&frames)?;
        self.refuse_other("frames", bodies.as_ref().map(|kept| &kept.scene), &run)?;
        if bodies.is_some() {
            let solid = Solid::read(&frames, summary.as_ref())?;
            self.refuse_short(&solid, summary.as_ref())?;
            return self.solid(&solid);
        }
        let folder = self.folder.display();
        let Some(summary) = summary else {
            return Err(Failure::input(format!(
                "{folder}: the run there was broken off before it left anything to show; \
                 run its scene again"
            )));
        };
        let body = summary["scene"]["body"].as_str().unwrap_or("disk");
        if body == "powder" || body == "tip" {
            return Err(Failure::input(format!(
                "{folder}: the run kept no frames; run it again without `--frames 0`"
            )));
        }
        if self.draws() {
            return Err(Failure::input(
                "--still, --film, --color and --network are for powders and tips; \
                 pictures of this run are beside its series",
            ));
        }
        self.page(&path::film(&self.folder, &summary["scene"], &run)?)
    }

    /// What the folder says that it holds: one run.
    fn run(&self) -> Result<Manifest, Failure> {
        let folder = self.folder.display();
        let Some(manifest) = Manifest::read(&self.folder)? else {
            return Err(Failure::input(format!(
                "{folder}: no run is there, or none that says which files are its own; \
                 make one with `tribos run SCENE --out {folder}`"
            )));
        };
        if manifest.command != COMMAND {
            return Err(Failure::input(format!(
                "{folder} holds the results of `tribos {}`, not a run",
                manifest.command
            )));
        }
        Ok(manifest)
    }

    /// Refuses what was put beside the run from another scene.
    fn refuse_other(&self, what: &str, of: Option<&Value>, run: &Manifest) -> Result<(), Failure> {
        match of {
            Some(scene) if *scene != run.about => Err(Failure::input(format!(
                "{} is of another scene than the run of the folder; run the scene again",
                self.folder.join(what).display()
            ))),
            _ => Ok(()),
        }
    }

    /// Refuses frames that end before the run did.
    fn refuse_short(&self, solid: &Solid, summary: Option<&Value>) -> Result<(), Failure> {
        let ended = summary.and_then(|summary| summary["steps"].as_f64());
        let last = solid.frames.last().map(|frame| frame.step as f64);
        match (ended, last) {
            (Some(ended), Some(last)) if ended != last => Err(Failure::input(format!(
                "{}: the last frame is of step {last}, the run ended with step {ended}; \
                 run the scene again",
                self.folder.display()
            ))),
            _ => Ok(()),
        }
    }

    /// Whether anything but a page is asked for.
    fn draws(&self) -> bool {
        !self.still.is_empty() || self.film.is_some() || self.color.is_some() || self.network
    }

    fn solid(&self, run: &Solid) -> Result<(), Failure> {
        if self.still.is_empty() && self.film.is_none() {
            if self.draws() {
                return Err(Failure::input(
                    "--color and --network go with --still or --film; the page has them as buttons",
                ));
            }
            return self.page(&run.film()?);
        }
        let look = run.look(self.color, self.network)?;
        let mut chosen = Vec::new();
        for which in &self.still {
            chosen.push(which.number(run.frames.len())?);
        }
        for number in chosen {
            let file = self.folder.join(format!("still-{number}.png"));
            write_atomically(&file, &still::png(run, &look, number - 1)?)?;
            written(&file)?;
        }
        if let Some(file) = &self.film {
            encoder::film(run, &look, file, self.rate)?;
            written(file)?;
        }
        Ok(())
    }

    fn page(&self, film: &Film) -> Result<(), Failure> {
        let file = match &self.out {
            Some(file) => file.clone(),
            None => self.folder.join("view.html"),
        };
        write_atomically(&file, film.page().as_bytes())?;
        written(&file)
    }
}

/// The film of a powder's or a tip's run.
pub fn solid_film(run: &Path) -> Result<Film, Failure> {
    Solid::read(&frames_folder(run), summary(run)?.as_ref())?.film()
}

fn written(file: &Path) -> Result<(), Failure> {
    crate::command::print(&format!("written to    {}\n", file.display()))
}

/// The summary of a run, if it has come to its end.
fn summary(folder: &Path) -> Result<Option<Value>, Failure> {
    let file = folder.join("summary.json");
    let named = |error: String| Failure::input(format!("{}: {error}", file.display()));
    match read_text(&file, MOST_BYTES) {
        Err(error) if error.is_missing() => Ok(None),
        Err(error) => Err(named(error.to_string())),
        Ok(text) => serde_json::from_str(&text)
            .map(Some)
            .map_err(|error| named(format!("{error}; run the scene again"))),
    }
}
