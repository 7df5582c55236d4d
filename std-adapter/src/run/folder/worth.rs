//! Results that took long: what a command may take away, and what it must not.

use super::FolderError;
use super::{Contents, Manifest};
use std::path::Path;

/// Commands whose folders hold many results.
const COLLECTIONS: [&str; 2] = ["sweep", "reproduce"];
/// The command of one run, and bodies whose runs take long.
const RUN: &str = "run";
const LONG: [&str; 2] = ["powder", "tip"];

/// What happens to a run that was broken off when another one begins in its folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    /// It is kept: the new one is refused.
    Kept,
    /// It goes away.
    Replaced,
}

/// Whether the run of a folder has come to its end.
pub fn is_finished(path: &Path) -> bool {
    path.join("summary.json").exists()
}

/// Refuses to take away what took long: collections and long runs by another command, and runs
/// that were broken off by any.
pub fn refuse_loss(path: &Path, old: &Manifest, new: &Contents<'_>) -> Result<(), FolderError> {
    let name = path.display();
    let is_other = old.command != new.command;
    let held = || {
        FolderError::Refused(format!(
            "{name} holds the results of `tribos {}`; give another --out, or remove {name}",
            old.command
        ))
    };
    if COLLECTIONS.contains(&old.command.as_str()) {
        return if is_other { Err(held()) } else { Ok(()) };
    }
    let is_long = LONG.contains(&old.about["body"].as_str().unwrap_or_default());
    if old.command != RUN || !is_long {
        return Ok(());
    }
    let is_broken = path.join("checkpoint.json").exists() && !is_finished(path);
    match (is_other, is_broken) {
        (true, true) => Err(FolderError::Refused(format!(
            "{name} holds a run that was broken off and can go on; give another --out, or remove \
             {name}"
        ))),
        (true, false) if is_finished(path) => Err(held()),
        (false, true) if new.broken == Broken::Kept => Err(FolderError::Refused(format!(
            "{name} holds a run that was broken off; go on with its own command and --resume, give \
             another --out, or take it away and start with --anew"
        ))),
        _ => Ok(()),
    }
}
