//! Reading the frames of a run, and films of them.

use crate::player::{Film, MovieError, solid_film};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tribos::record::RecordError;
use tribos::record::frames::{Bodies, Frame, FrameFolder, Kind};
use tribos::scene::with_present_names;

/// Why a run cannot be shown as a film.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// The run has no frames.
    #[error("{}: no frames are there; run the scene again", .0.display())]
    Missing(PathBuf),
    /// The frames cannot be read.
    #[error(transparent)]
    Frames(#[from] RecordError),
    /// The frames cannot be made into a film.
    #[error(transparent)]
    Movie(#[from] MovieError),
}

/// A run of a powder or a tip, from its frames.
#[derive(Debug)]
pub struct RunFrames {
    /// Title of the run.
    pub title: String,
    /// The data that all frames share.
    pub bodies: Bodies,
    /// The frames in order, at least one.
    pub frames: Vec<Frame>,
}

impl RunFrames {
    /// Reads all frames of a folder; the summary of the run adds to the title.
    pub fn read(folder: &Path, summary: Option<&Value>) -> Result<Self, FilmError> {
        let Some(bodies) = FrameFolder::bodies(folder)? else {
            return Err(FilmError::Missing(folder.to_owned()));
        };
        let steps = FrameFolder::steps(folder)?;
        let frames: Result<Vec<Frame>, _> = steps
            .into_iter()
            .map(|step| FrameFolder::read(folder, &bodies, step))
            .collect();
        let frames = frames?;
        if frames.is_empty() {
            return Err(FilmError::Missing(folder.to_owned()));
        }
        let title = title(&bodies, summary);
        Ok(Self {
            title,
            bodies,
            frames,
        })
    }

    /// The film for a page.
    pub fn film(&self) -> Result<Film, MovieError> {
        solid_film(&self.title, &self.bodies, &self.frames)
    }
}

/// Coefficients of spheres in a title.
const MODES: [(&str, &str); 3] = [("mu", "μ"), ("mu_rolling", "μ_t"), ("mu_torsion", "μ_n")];

/// Title from the kind of run and its summary.
fn title(bodies: &Bodies, summary: Option<&Value>) -> String {
    let count = bodies.radii.len();
    let scene = summary.map(|summary| with_present_names(&summary["scene"]));
    let told = |key: &str| {
        // In short form.
        let value = scene.as_ref()?[key].as_f64()?;
        Some(value.to_string())
    };
    match bodies.kind {
        Kind::Powder => {
            let mut title = format!("Compaction of {count} cohesive spheres");
            for (key, name) in MODES {
                if let Some(value) = told(key) {
                    title += &format!(", {name} = {value}");
                }
            }
            title
        }
        Kind::Grains => {
            let mut title = format!("{count} grains");
            for (key, name) in MODES {
                if let Some(value) = told(key) {
                    title += &format!(", {name} = {value}");
                }
            }
            title
        }
        Kind::Gas => {
            let e = told("restitution").map_or(String::new(), |value| format!(", e = {value}"));
            format!("Gas of {count} spheres{e}")
        }
        Kind::Tip => {
            let lambda = told("lambda").map_or(String::new(), |value| format!(", λ = {value}"));
            format!("Tip on a substrate, {count} atoms{lambda}")
        }
    }
}
