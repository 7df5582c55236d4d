//! `tribos view`: a run as a film.

mod colors;
mod encoder;
mod frame_images;
pub mod path;
pub mod run_files;

use self::colors::{ColorBy, RenderStyle};
use self::run_files::RunFiles;
use crate::command::number;
use crate::command::run::{files, frames_folder};
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::record::write_atomically;
use tribos::run::folder;
use tribos::scene::vocabulary;
use tribos_report::player::Film;
use tribos_report::runs::RunFrames;

/// Write DIR/view.html, a page that plays the run in a browser, from a file and without a network.
///
/// Powders, grains, gases and tips are shown from the frames that `tribos run` keeps in DIR/frames, bodies in the
/// plane from series.csv and summary.json.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The folder of a run.
    folder: PathBuf,
    /// File for the page. [default: DIR/view.html]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["still", "film"])]
    out: Option<PathBuf>,
    /// PNG pictures of these frames instead of a page, into DIR/still-<frame>.png: numbers from 1,
    /// or `last`.
    #[arg(long, value_name = "FRAMES", value_delimiter = ',', value_parser = frame_images::which)]
    still: Vec<frame_images::FrameSelector>,
    /// A film file instead of a page; needs ffmpeg on the PATH. Ends in .mp4, .webm or .gif.
    #[arg(long, value_name = "FILE", value_parser = encoder::film_name)]
    film: Option<PathBuf>,
    /// Frames a second of a film file.
    #[arg(long, default_value = "20", value_parser = number::whole(1..=100), requires = "film")]
    rate: u32,
    /// Quantity shown by colour in pictures and film files. [default: layer, or part for a tip]
    #[arg(long, value_enum)]
    color: Option<ColorBy>,
    /// Draw the normal forces instead of the spheres in pictures and film files.
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
        let RunFiles {
            manifest,
            summary,
            bodies,
        } = RunFiles::read(&self.folder)?;
        if bodies.is_some() {
            let frames = frames_folder(&self.folder);
            return self.solid(&RunFrames::read(&frames, summary.as_ref())?);
        }
        let folder = self.folder.display();
        let Some(summary) = summary else {
            return Err(Failure::input(format!(
                "{folder}: the run there was interrupted before it wrote anything to show; \
                 run its scene again"
            )));
        };
        let body = summary["scene"]["body"].as_str().unwrap_or("disk");
        if ["powder", "grains", "gas", "tip"].contains(&body) {
            return Err(Failure::input(format!(
                "{folder}: the run kept no frames; run it again without `--frames 0`"
            )));
        }
        // Bodies that slide to rest alone have a final ratio, and a path.
        let results = vocabulary(body).map_or(&[][..], |known| known.results);
        if !results.iter().any(|entry| entry.name == "final_ratio") {
            return Err(Failure::input(format!(
                "{folder}: the motion of a {body} is in motion.svg and series.csv; it has no film"
            )));
        }
        if self.draws() {
            return Err(Failure::input(
                "--still, --film, --color and --network are for powders and tips; \
                 pictures of this run are beside its series",
            ));
        }
        self.page(&path::film(&self.folder, &summary["scene"], &manifest)?)
    }

    /// Whether anything but a page is asked for.
    fn draws(&self) -> bool {
        !self.still.is_empty() || self.film.is_some() || self.color.is_some() || self.network
    }

    fn solid(&self, run: &RunFrames) -> Result<(), Failure> {
        if self.still.is_empty() && self.film.is_none() {
            if self.draws() {
                return Err(Failure::input(
                    "--color and --network go with --still or --film; the page has them as buttons",
                ));
            }
            return self.page(&run.film().map_err(Failure::run)?);
        }
        let look = RenderStyle::of(run, self.color, self.network)?;
        let mut chosen = Vec::new();
        for which in &self.still {
            chosen.push(which.number(run.frames.len())?);
        }
        for number in chosen {
            let name = format!("still-{number}.png");
            folder::add(&self.folder, &[&name])?;
            let file = self.folder.join(name);
            write_atomically(&file, &frame_images::png(run, &look, number - 1)?)?;
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
            None => {
                folder::add(&self.folder, &[files::PAGE])?;
                self.folder.join(files::PAGE)
            }
        };
        write_atomically(&file, film.page().as_bytes())?;
        written(&file)
    }
}

fn written(file: &Path) -> Result<(), Failure> {
    crate::command::print(&format!("written to    {}\n", file.display()))
}
