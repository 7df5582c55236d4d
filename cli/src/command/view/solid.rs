//! The frames of a run, read, and films of them.

use super::colors::{Look, Paint};
use crate::failure::Failure;
use crate::report::player::{Film, solid_film};
use serde_json::Value;
use std::path::Path;
use tribos::record::frames::{Bodies, Frame, FrameFolder, Kind};

/// A run of a powder or a tip as its frames show it.
#[derive(Debug)]
pub struct Solid {
    /// What it is called.
    pub title: String,
    /// What its frames have in common.
    pub bodies: Bodies,
    /// The frames in order, at least one.
    pub frames: Vec<Frame>,
}

impl Solid {
    /// Reads all frames of a folder.
    pub fn read(folder: &Path, summary: Option<&Value>) -> Result<Self, Failure> {
        let Some(bodies) = FrameFolder::bodies(folder)? else {
            return Err(no_frames(folder));
        };
        let steps = FrameFolder::steps(folder)?;
        let frames: Result<Vec<Frame>, _> = steps
            .into_iter()
            .map(|step| FrameFolder::read(folder, &bodies, step))
            .collect();
        let frames = frames?;
        if frames.is_empty() {
            return Err(no_frames(folder));
        }
        let title = title(&bodies, summary);
        Ok(Self {
            title,
            bodies,
            frames,
        })
    }

    /// The film for a page.
    pub fn film(&self) -> Result<Film, Failure> {
        solid_film(&self.title, &self.bodies, &self.frames).map_err(Failure::run)
    }

    /// How pictures look, the same for all frames.
    pub fn look(&self, paint: Option<Paint>, network: bool) -> Result<Look, Failure> {
        Look::of(self, paint, network)
    }
}

fn no_frames(folder: &Path) -> Failure {
    Failure::input(format!(
        "{}: no frames are there; run the scene again",
        folder.display()
    ))
}

/// What a run is, with what its summary adds.
fn title(bodies: &Bodies, summary: Option<&Value>) -> String {
    let count = bodies.radii.len();
    let told = |key: &str| {
        // As short as a person writes it.
        let value = summary?["scene"][key].as_f64()?;
        Some(value.to_string())
    };
    match bodies.kind {
        Kind::Powder => {
            let mut title = format!("Compaction of {count} cohesive spheres");
            for (key, name) in [("sliding", "μ"), ("rolling", "μ_t"), ("torsion", "μ_n")] {
                if let Some(value) = told(key) {
                    title += &format!(", {name} = {value}");
                }
            }
            title
        }
        Kind::Tip => {
            let lambda = told("lambda").map_or(String::new(), |value| format!(", λ = {value}"));
            format!("Tip on a substrate, {count} atoms{lambda}")
        }
    }
}
