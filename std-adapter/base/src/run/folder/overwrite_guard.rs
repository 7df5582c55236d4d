//! Protection of results that took long to compute.

use super::{Contents, Manifest};
use crate::record::RecordError;
use crate::record::frames::Kind;
use std::path::Path;

/// Commands whose folders hold many results.
const COLLECTIONS: [&str; 2] = ["sweep", "reproduce"];
/// The command of one run.
const RUN: &str = "run";

/// What happens to an interrupted run when another one begins in its folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InterruptedRunPolicy {
    /// The interrupted run is kept, and the new one refused.
    Kept,
    /// The interrupted run is removed.
    Replaced,
}

/// Whether the run in a folder is finished.
pub fn is_finished(path: &Path) -> bool {
    path.join("summary.json").exists()
}

/// Refuses to remove results that took long: collections and long runs if the command is another,
/// and interrupted runs always.
pub fn refuse_overwrite(
    path: &Path,
    old: &Manifest,
    new: &Contents<'_>,
) -> Result<(), RecordError> {
    let name = path.display();
    let is_other = old.command != new.command;
    let held = || {
        RecordError::Refused(format!(
            "{name} holds the results of `tribos {}`; give another --out, or remove {name}",
            old.command
        ))
    };
    if COLLECTIONS.contains(&old.command.as_str()) {
        return if is_other { Err(held()) } else { Ok(()) };
    }
    // Bodies with frames take long.
    let is_long = old.about["body"].as_str().and_then(Kind::named).is_some();
    if old.command != RUN || !is_long {
        return Ok(());
    }
    let is_broken = path.join("checkpoint.json").exists() && !is_finished(path);
    match (is_other, is_broken) {
        (true, true) => Err(RecordError::Refused(format!(
            "{name} holds a run that was broken off and can go on; give another --out, or remove \
             {name}"
        ))),
        (true, false) if is_finished(path) => Err(held()),
        (false, true) if new.broken == InterruptedRunPolicy::Kept => {
            Err(RecordError::Refused(format!(
                "{name} holds a run that was broken off; go on with its own command and --resume, give \
             another --out, or take it away and start with --anew"
            )))
        }
        _ => Ok(()),
    }
}
