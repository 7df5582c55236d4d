//! `tribos fit --track`: friction, radius and launch of a body that was filmed while it slides.

mod output;
mod picture;
mod read;

use super::log::Format;
use crate::command::number;
use crate::failure::Failure;
use std::path::Path;
use tribos::fit::track::{TrackLaw, TrackOptions, fit_track};
use tribos::fit::{FitError, FitLaw};
use tribos::friction::Patch;
use tribos::record::LogOptions;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;

pub use read::ROLES;

/// Files of a fit.
const FILES: [&str; 4] = ["residuals.csv", "fit.toml", "fit.svg", "fit.png"];

/// Options of a filmed body.
#[derive(Debug, clap::Args)]
pub struct FilmArguments {
    /// Follow a film: columns t,x,y [s, m, m] and perhaps angle [rad] of a body that slides on a level floor. A tilted
    /// floor is not in the fit.
    #[arg(long, requires = "data", conflicts_with_all = ["load", "inertia", "offset", "spring", "strokes"])]
    pub track: bool,
    /// First time of the film that is used [s].
    #[arg(long, requires = "track", value_name = "T", value_parser = number::finite, allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last time of the film that is used [s]; frames in which the body rests after its stop may stay.
    #[arg(long, requires = "track", value_name = "T", value_parser = number::finite, allow_hyphen_values = true)]
    to: Option<f64>,
    /// Gravity [m/s²], 9.81 unless it is given.
    #[arg(long, requires = "track", value_parser = number::positive, default_value = "9.81", hide_default_value = true)]
    gravity: f64,
    /// I/(M R²) of a round body: 0.5 as of a solid disk unless it is given, 1 for a hoop; a box is of uniform thickness.
    #[arg(long, requires = "track", value_parser = number::positive, default_value = "0.5", hide_default_value = true)]
    inertia_ratio: f64,
    /// Frames per second, where t is the number of the frame.
    #[arg(long, requires = "track", value_name = "HZ", value_parser = number::positive)]
    frame_rate: Option<f64>,
    /// Metres per pixel, where x and y are pixels.
    #[arg(long, requires = "track", value_name = "M_PER_PIXEL", value_parser = number::positive)]
    scale: Option<f64>,
}

/// What other kinds of fits take as well.
#[derive(Debug)]
pub struct Common<'a> {
    pub law: Option<FitLaw>,
    pub patch: Option<&'a Patch>,
    pub fixed: &'a [(String, f64)],
    pub log: LogOptions,
    pub starts: usize,
    pub format: Format,
    pub out: Option<&'a Path>,
}

impl FilmArguments {
    /// Fits, writes and prints.
    pub fn execute(&self, film: &Path, common: &Common<'_>) -> Result<(), Failure> {
        let read = self.read(film, &common.log)?;
        let options = TrackOptions {
            law: law(common.law)?,
            patch: common.patch.cloned().unwrap_or(Patch::Disk),
            gravity: self.gravity,
            inertia_ratio: self.inertia_ratio,
            fixed: common.fixed.to_vec(),
            starts: common.starts,
            skip: 0,
            from: self.from,
            to: self.to,
            noise_position: None,
            noise_angle: None,
        };
        let fit = fit_track(&read.track, &options).map_err(|error| read.refusal(error))?;
        if let Some(out) = common.out {
            let _folder = OutputFolder::begin(out, &Contents::of("fit", &FILES))?;
            image::write_both(out, "fit", &picture::panels(&fit))?;
            output::write(&fit, &options, out)?;
        }
        let text = match common.format {
            Format::Json => format!("{:#}\n", output::json(&fit, &options)),
            Format::Text => {
                let end = common
                    .out
                    .map(|out| format!("written to    {}\n", out.display()));
                read.told_text() + &output::text(&fit, &options) + &end.unwrap_or_default()
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
    named
        .name()
        .parse()
        .map_err(|error| Failure::input(format!("--law: {error}")))
}

impl read::Film {
    /// A refusal with file and line, where it is about a frame.
    fn refusal(&self, error: FitError) -> Failure {
        read::refusal(&self.name, &self.lines, &self.told, error)
    }
}
