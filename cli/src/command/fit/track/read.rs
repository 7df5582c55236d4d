//! The frames of a film.

use super::FilmArguments;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::fit::track::Track;
use tribos::record::{LogOptions, LogRole, TableError, read_log};

/// A film that was read.
#[derive(Debug)]
pub struct Film {
    pub track: Track,
    /// What was understood of the file.
    pub told: Vec<String>,
    pub name: PathBuf,
    /// Line of each frame.
    pub lines: Vec<u64>,
}

/// Columns of a film.
pub const ROLES: [LogRole; 4] = [
    LogRole::TIME.needed(),
    LogRole::POSITION.needed(),
    LogRole::ACROSS.needed(),
    LogRole::ANGLE,
];

impl Film {
    /// What was understood of the file.
    pub fn told_text(&self) -> String {
        self.told
            .iter()
            .map(|line| format!("read          {line}\n"))
            .collect()
    }
}

impl FilmArguments {
    /// Reads t,x,y and perhaps angle, in SI units.
    pub(super) fn read(&self, path: &Path, options: &LogOptions) -> Result<Film, Failure> {
        let mut log = read_log(path, &ROLES, options).map_err(|refusal| with_scale(&refusal))?;
        let mut scaled = |name: &str, factor: Option<f64>| {
            let column = log.take(name)?;
            let factor = factor.unwrap_or(1.0);
            Some(column.into_iter().map(|x| x * factor).collect::<Vec<f64>>())
        };
        let times = scaled("t", self.frame_rate.map(|rate| 1.0 / rate)).unwrap_or_default();
        let [x, y] = ["x", "y"].map(|name| scaled(name, self.scale).unwrap_or_default());
        let angle = scaled("angle", None);
        let track = Track::new(times, x, y, angle)
            .map_err(|error| refusal(path, &log.lines, &log.brief, error))?;
        Ok(Film {
            track,
            told: log.brief,
            name: path.to_path_buf(),
            lines: log.lines,
        })
    }
}

/// A refusal, with the cure for pixels and frames, which are no units.
fn with_scale(refusal: &TableError) -> Failure {
    let text = refusal.to_string();
    let cure = if text.contains("`px`") || text.contains("`pixel`") {
        "; pixels have no length: give --scale METRES_PER_PIXEL"
    } else if text.contains("`frame`") || text.contains("`frames`") {
        "; frames have no duration: give --frame-rate HZ"
    } else {
        ""
    };
    Failure::input(format!("{text}{cure}"))
}

pub use super::super::table::refusal;
