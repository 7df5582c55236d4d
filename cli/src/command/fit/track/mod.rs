//! `tribos fit --track`: friction, radius and launch of a body that was filmed while it slides.

mod output;
mod picture;
mod read;

use super::super::number;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::track::{TrackLaw, TrackOptions, fit_track};
use tribos::fit::{FitError, FitLaw};
use tribos::friction::Patch;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;

/// Files of a fit.
const FILES: [&str; 4] = ["residuals.csv", "fit.toml", "fit.svg", "fit.png"];

/// What the text is printed as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Text,
    /// For programs.
    Json,
}

/// Options of a filmed body.
#[derive(Debug, clap::Args)]
pub struct Options {
    /// A film: a CSV file with the columns t,x,y [s, m, m] and perhaps angle [rad] of a body that slides on a level
    /// floor (`-` for standard input). A tilted floor is not in the fit.
    #[arg(long, value_name = "FILM.csv", conflicts_with_all = ["data", "support", "load"])]
    pub track: Option<PathBuf>,
    /// First time of the film that is used [s].
    #[arg(long, requires = "track", value_name = "T", value_parser = number::finite, allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last time of the film that is used [s]; frames in which the body rests after its stop may stay.
    #[arg(long, requires = "track", value_name = "T", value_parser = number::finite, allow_hyphen_values = true)]
    to: Option<f64>,
    /// Frames at the beginning that are left out.
    #[arg(long, requires = "track", value_name = "N", default_value = "0")]
    skip: usize,
    /// Gravity [m/s²].
    #[arg(long, requires = "track", value_parser = number::positive, default_value = "9.81")]
    gravity: f64,
    /// I/(M R²) of a round body: 0.5 for a solid disk, 1 for a hoop; a box is of uniform thickness.
    #[arg(long, requires = "track", value_parser = number::positive, default_value = "0.5")]
    inertia_ratio: f64,
    /// Standard deviation of x and y [m]; without it the residuals tell.
    #[arg(long, requires = "track", value_name = "M", value_parser = number::positive)]
    noise_position: Option<f64>,
    /// Standard deviation of the angle [rad]; without it the residuals tell.
    #[arg(long, requires = "track", value_name = "RAD", value_parser = number::positive)]
    noise_angle: Option<f64>,
    /// Frames per second, where t is the number of the frame.
    #[arg(long, requires = "track", value_name = "HZ", value_parser = number::positive)]
    frame_rate: Option<f64>,
    /// Metres per pixel, where x and y are pixels.
    #[arg(long, requires = "track", value_name = "M_PER_PIXEL", value_parser = number::positive)]
    scale: Option<f64>,
    /// Units of columns, such as x=mm,y=mm,angle=deg.
    #[arg(long, requires = "track", value_name = "NAME=UNIT,…", value_delimiter = ',', value_parser = read::unit)]
    units: Vec<(String, f64)>,
    /// Text for people or JSON.
    #[arg(long, requires = "track", value_enum, default_value = "text")]
    format: Format,
}

/// What other kinds of fits take as well.
#[derive(Debug)]
pub struct Common<'a> {
    pub law: Option<FitLaw>,
    pub patch: Option<&'a Patch>,
    pub fixed: &'a [(String, f64)],
    pub starts: usize,
    pub out: Option<&'a Path>,
}

impl Options {
    /// Fits, writes and prints.
    pub fn execute(&self, film: &Path, common: &Common<'_>) -> Result<(), Failure> {
        let read = self.read(film)?;
        let options = TrackOptions {
            law: law(common.law)?,
            patch: common.patch.cloned().unwrap_or(Patch::Disk),
            gravity: self.gravity,
            inertia_ratio: self.inertia_ratio,
            fixed: common.fixed.to_vec(),
            starts: common.starts,
            skip: self.skip,
            from: self.from,
            to: self.to,
            noise_position: self.noise_position,
            noise_angle: self.noise_angle,
        };
        let fit = fit_track(&read.track, &options).map_err(|error| read.refusal(error))?;
        if let Some(out) = common.out {
            let _folder = OutputFolder::begin(out, &Contents::of("fit", &FILES))?;
            image::write_both(out, "fit", &picture::panels(&fit))?;
            output::write(&fit, &options, out)?;
        }
        let text = match self.format {
            Format::Json => format!("{:#}\n", output::json(&fit, &options)),
            Format::Text => {
                let end = common
                    .out
                    .map(|out| format!("written to    {}\n", out.display()));
                output::text(&fit, &options) + &end.unwrap_or_default()
            }
        };
        crate::command::print(&text)
    }
}

/// The law of that name under which a filmed body can be followed.
fn law(named: Option<FitLaw>) -> Result<TrackLaw, Failure> {
    let Some(named) = named else {
        return Ok(TrackLaw::Coulomb);
    };
    let mut all = FitLaw::ALL.into_iter();
    let name = all
        .find(|(law, ..)| *law == named)
        .map_or("", |(_, name, _)| name);
    name.parse()
        .map_err(|error| Failure::input(format!("--law: {error}")))
}

impl read::Film {
    /// A refusal with file and line, where it is about a frame.
    fn refusal(&self, error: FitError) -> Failure {
        read::refusal(&self.name, &self.lines, error)
    }
}
