//! What a folder holds of the run that it belongs to.

use crate::command::run::{COMMAND, frames_folder};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::record::frames::{Bodies, FrameFolder};
use tribos::record::read_text;
use tribos::run::folder::Manifest;
use tribos::scene::with_present_names;

/// Bytes of a summary at most.
const MOST_BYTES: u64 = 64 << 20;

/// One run: what belongs to another has been refused.
pub struct RunFiles {
    /// Which run, and the digests of its files.
    pub manifest: Manifest,
    /// Of a run that came to its end.
    pub summary: Option<Value>,
    /// Of a powder or a tip with frames.
    pub bodies: Option<Bodies>,
}

impl RunFiles {
    /// Reads all but the frames themselves.
    pub fn read(folder: &Path) -> Result<Self, Failure> {
        let frames = frames_folder(folder);
        let kept = Self {
            manifest: manifest(folder)?,
            summary: summary(folder)?,
            bodies: FrameFolder::bodies(&frames)?,
        };
        let scene = kept.summary.as_ref().map(|kept| &kept["scene"]);
        kept.refuse_other(&folder.join("summary.json"), scene)?;
        kept.refuse_other(&frames, kept.bodies.as_ref().map(|kept| &kept.scene))?;
        if kept.bodies.is_some() {
            kept.refuse_short(folder, &FrameFolder::steps(&frames)?)?;
        }
        Ok(kept)
    }

    /// Refuses what was put beside the run from another scene.
    fn refuse_other(&self, what: &Path, of: Option<&Value>) -> Result<(), Failure> {
        match of {
            Some(scene) if with_present_names(scene) != self.manifest.about => {
                Err(Failure::input(format!(
                    "{} is of another scene than the run of the folder; run the scene again",
                    what.display()
                )))
            }
            _ => Ok(()),
        }
    }

    /// Refuses frames that end before the run did.
    fn refuse_short(&self, folder: &Path, steps: &[u64]) -> Result<(), Failure> {
        let ended = self.summary.as_ref();
        let ended = ended.and_then(|summary| summary["steps"].as_f64());
        let last = steps.last().map(|step| *step as f64);
        match (ended, last) {
            (Some(ended), Some(last)) if ended != last => Err(Failure::input(format!(
                "{}: the last frame is of step {last}, the run ended with step {ended}; \
                 run the scene again",
                folder.display()
            ))),
            _ => Ok(()),
        }
    }
}

/// What the folder says that it holds: one run.
fn manifest(folder: &Path) -> Result<Manifest, Failure> {
    let shown = folder.display();
    let Some(mut manifest) = Manifest::read(folder)? else {
        return Err(Failure::input(format!(
            "{shown}: no run is there, or none that says which files are its own; \
             make one with `tribos run SCENE --out {shown}`"
        )));
    };
    if manifest.command != COMMAND {
        return Err(Failure::input(format!(
            "{shown} holds the results of `tribos {}`, not a run",
            manifest.command
        )));
    }
    manifest.about = with_present_names(&manifest.about);
    Ok(manifest)
}

/// The summary of a run, if it has come to its end.
pub fn summary(folder: &Path) -> Result<Option<Value>, Failure> {
    let file = folder.join("summary.json");
    let named = |error: String| Failure::input(format!("{}: {error}", file.display()));
    match read_text(&file, MOST_BYTES) {
        Err(error) if error.is_missing() => Ok(None),
        Err(error) => Err(named(error.to_string())),
        Ok(text) => {
            let mut summary: Value = serde_json::from_str(&text)
                .map_err(|error| named(format!("{error}; run the scene again")))?;
            if let Some(scene) = summary.get_mut("scene") {
                *scene = with_present_names(scene);
            }
            Ok(Some(summary))
        }
    }
}
