//! A run as it was asked for: its folder, and how it starts and goes on.

use super::files;
use super::frontend::Frontend;
use super::resource_check::MemoryPermission;
use crate::failure::Failure;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribos::record::CheckpointError;
use tribos::run::folder::{
    Contents, InterruptedRunPolicy, Lock, LockMode, Manifest, OutputFolder, is_finished,
};
use tribos::run::{CHECKPOINT, LongRun, RunError, Session, StartMode, read_checkpoint};
use tribos::scene::with_present_names;
use tribos_report::image::{self, Drawing};

/// The command's name in the folders that it writes.
pub const COMMAND: &str = "run";

/// What the command line asks of a run.
#[derive(Debug)]
pub struct RunRequest<'a> {
    /// Folder for the results.
    pub out: &'a Path,
    /// What becomes of a run in the folder that was broken off.
    pub broken: InterruptedRunPolicy,
    /// Whether a run in the folder goes on.
    pub resume: bool,
    /// Time between checkpoints.
    pub pause: Duration,
    /// Largest number of frames.
    pub frames: Option<u64>,
    /// Which sizes are run.
    pub allowed: MemoryPermission,
    /// Whether pictures are drawn.
    pub pictures: Pictures,
    /// Who asked.
    pub caller: Frontend<'a>,
}

/// Whether the pictures of a run are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pictures {
    /// With the other results.
    Drawn,
    /// Nobody will see them.
    LeftOut,
}

impl<'a> RunRequest<'a> {
    /// The folder of a run that starts.
    pub fn begin(&self, scene: Value, files: &[&str]) -> Result<OutputFolder, Failure> {
        let contents = Contents {
            about: scene,
            broken: self.broken,
            ..Contents::of(COMMAND, files)
        };
        Ok(OutputFolder::begin(self.out, &contents)?)
    }

    /// A long run in its folder.
    pub fn session<R: LongRun>(&self, start: StartMode, folder: &OutputFolder) -> Session<'a, R> {
        let caller = self.caller;
        let session = Session::under(folder.lock().clone(), self.out)
            .start(start)
            .checkpoint_every(self.pause)
            .cancel_when(move || caller.is_asked());
        match self.frames {
            Some(limit) => session.frames(limit),
            None => session,
        }
    }

    /// Draws a picture as .svg and .png, if pictures are asked for.
    pub fn draw<D: Drawing>(
        &self,
        stem: &str,
        drawing: impl FnOnce() -> Result<D, Failure>,
    ) -> Result<(), Failure> {
        if self.pictures == Pictures::Drawn {
            image::write_both(self.out, stem, &drawing()?)?;
        }
        Ok(())
    }

    /// Ends a run that was interrupted after its last step: it is in its checkpoint.
    pub fn interrupted(&self) -> Result<(), Failure> {
        if self.caller.is_asked() {
            return Err(Failure::ended(
                self.out,
                "interrupted while results were written",
            ));
        }
        Ok(())
    }

    /// A run that was interrupted says how to go on.
    pub fn failure<E: std::error::Error + Into<Failure>>(&self, error: RunError<E>) -> Failure {
        match error {
            RunError::Cancelled(step) => {
                Failure::ended(self.out, &format!("interrupted after step {step}"))
            }
            other => other.into(),
        }
    }

    /// The folder of a long run, and where the run starts; none if it is finished.
    pub fn long(
        &self,
        scene: Value,
        later: &[&str],
    ) -> Result<Option<(OutputFolder, StartMode)>, Failure> {
        self.caller.watch()?;
        let contents = Contents {
            about: scene,
            later,
            broken: self.broken,
            ..Contents::of(COMMAND, files::UNDER_WAY)
        };
        if !self.resume {
            let folder = OutputFolder::begin(self.out, &contents)?;
            return Ok(Some((folder, StartMode::Fresh)));
        }
        if !self.out.is_dir() {
            read_checkpoint(&checkpoint(self.out))?;
        }
        let lock = Lock::take(self.out, LockMode::Alone)?;
        let mut contents = contents;
        if let Some(begun) = Manifest::read(self.out)?
            && with_present_names(&begun.about) == contents.about
        {
            // A folder keeps the names that its version had for the keys.
            contents.about = begun.about;
        }
        let Some(start) = self.start(&contents.about)? else {
            OutputFolder::tidy(lock)?;
            let out = self.out.display();
            let told = format!("finished already; its results are in {out}\n");
            self.caller.report(&told)?;
            return Ok(None);
        };
        let folder = OutputFolder::reopen_locked(lock, &contents)?;
        // What was made from the frames of the unfinished run is out of date.
        folder.remove(files::is_made_from_frames)?;
        Ok(Some((folder, start)))
    }

    /// Where a run that goes on starts: broken off before its first checkpoint at the beginning, and
    /// nowhere if it is finished.
    fn start(&self, scene: &Value) -> Result<Option<StartMode>, Failure> {
        let file = checkpoint(self.out);
        let begun = Manifest::read(self.out)?.filter(|begun| begun.command == COMMAND);
        match begun {
            Some(begun) if file.exists() => same_scene(&begun.about, scene)?,
            Some(begun) if is_finished(self.out) => {
                same_scene(&begun.about, scene)?;
                return Ok(None);
            }
            Some(begun) if begun.about == *scene => {
                let told = format_args!("no checkpoint yet: starting from the beginning");
                self.caller.tell(told);
                return Ok(Some(StartMode::Fresh));
            }
            None if file.exists() => {}
            _ => {
                read_checkpoint(&file)?;
            }
        }
        Ok(Some(StartMode::Resume))
    }
}

/// Refuses to go on with another scene than the folder's.
fn same_scene(kept: &Value, given: &Value) -> Result<(), Failure> {
    let empty = serde_json::Map::new();
    let [kept, given] = [kept, given].map(with_present_names);
    let [there, here] = [&kept, &given].map(|scene| scene.as_object().unwrap_or(&empty));
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

/// What to do once a full disk has room: a long run loses what it did since its checkpoint.
pub fn how_to_go_on(out: &Path) -> String {
    let file = checkpoint(out);
    if file.exists() {
        let name = file.display();
        format!("Then continue from {name}: the same command with --resume.")
    } else {
        "Then give the same command again: there is no checkpoint yet.".into()
    }
}
