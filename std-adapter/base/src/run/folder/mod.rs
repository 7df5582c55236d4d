//! Folders for results: each belongs to one command at a time, and its files to one result.
//!
//! `tribos.json` in the folder records which command wrote which files, of which scene. A command that starts
//! there removes the files named there, and nothing else; it never replaces other files. While a command works
//! it holds a lock that names it to others. The next command removes half-written files of a killed one.

mod lock;
mod manifest;
mod overwrite_guard;

pub use lock::{Lock, LockMode, LockOutcome};
pub use manifest::Manifest;
pub use overwrite_guard::{InterruptedRunPolicy, is_finished};

use crate::record::frames::FrameFolder;
use crate::record::{RecordError, is_unfinished, write_atomically_there};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The files that a command will write to its folder.
#[derive(Clone, Debug)]
pub struct Contents<'a> {
    /// Name of the command.
    pub command: &'static str,
    /// Subject of the result: the scene of a run, else null.
    pub about: Value,
    /// Names of files that it writes now; `#` stands for digits, and a folder of frames ends with
    /// `/`.
    pub files: &'a [&'a str],
    /// Names of files that it adds later, before it writes them.
    pub later: &'a [&'a str],
    /// What happens to an interrupted run.
    pub broken: InterruptedRunPolicy,
}

impl<'a> Contents<'a> {
    /// Contents of a command whose results do not belong to one scene.
    pub fn of(command: &'static str, files: &'a [&'a str]) -> Self {
        Self {
            command,
            about: Value::Null,
            files,
            later: &[],
            broken: InterruptedRunPolicy::Kept,
        }
    }
}

/// A folder that a command works in. Dropping it releases the folder, and its manifest then names the
/// existing files.
#[derive(Debug)]
pub struct OutputFolder {
    lock: Arc<Lock>,
}

impl OutputFolder {
    /// The folder for a new result, created if missing; files of an earlier result are removed.
    pub fn begin(path: &Path, contents: &Contents<'_>) -> Result<Self, RecordError> {
        let lock = Lock::take(path, LockMode::Alone)?;
        Self::claim(lock, contents, |_| false)
    }

    /// The folder of the same command and subject, whose files are kept, or else a folder for a new result.
    pub fn reopen(path: &Path, contents: &Contents<'_>) -> Result<Self, RecordError> {
        Self::reopen_locked(Lock::take(path, LockMode::Alone)?, contents)
    }

    /// The same for a folder that is already locked.
    pub fn reopen_locked(lock: Lock, contents: &Contents<'_>) -> Result<Self, RecordError> {
        Self::claim(lock, contents, |old| {
            old.command == contents.command && old.about == contents.about
        })
    }

    /// Finishes the folder of a command that was killed after its last result: half-written files go, and the manifest
    /// names the existing files.
    pub fn tidy(lock: Lock) -> Result<(), RecordError> {
        remove_unfinished(lock.folder())?;
        let lock = Arc::new(lock);
        Self { lock }.trim()
    }

    fn claim(
        lock: Lock,
        contents: &Contents<'_>,
        stays: impl FnOnce(&Manifest) -> bool,
    ) -> Result<Self, RecordError> {
        let path = lock.folder();
        let old = Manifest::read(path)?;
        let names = old.as_ref().map_or(&[][..], |old| &old.files);
        let kept = old.as_ref().filter(|old| stays(old));
        if let (Some(old), None) = (&old, kept) {
            overwrite_guard::refuse_overwrite(path, old, contents)?;
        }
        refuse_foreign_files(path, contents.files, names)?;
        refuse_foreign_files(path, contents.later, names)?;
        remove_unfinished(path)?;
        let mut manifest = Manifest::of(contents);
        if let Some(kept) = kept {
            manifest = kept.clone();
            manifest.add(contents.files);
        } else {
            // The new command takes over the manifest first, so that old files left by an
            // interruption belong to it.
            Manifest {
                files: [names, &manifest.files].concat(),
                ..manifest.clone()
            }
            .write(path)?;
            for name in names {
                remove(path, name)?;
            }
        }
        manifest.write(path)?;
        let lock = Arc::new(lock);
        Ok(Self { lock })
    }

    /// Lock of the folder, for occasional writers.
    pub fn lock(&self) -> &Arc<Lock> {
        &self.lock
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        self.lock.folder()
    }

    /// Call this before writing results: it fails if the folder now belongs to another command.
    pub fn check(&self) -> Result<(), RecordError> {
        self.lock.check()
    }

    /// Writes a file that the manifest names, if the folder still belongs to this command.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), RecordError> {
        self.check()?;
        write_atomically_there(&self.path().join(name), bytes)
            .map_err(|error| self.check().err().unwrap_or(error))
    }

    /// Adds names to the manifest; call it before writing files that were not named at the start.
    pub fn add(&self, names: &[&str]) -> Result<(), RecordError> {
        self.check()?;
        add(self.path(), names)
    }

    /// Removes the files of the manifest that `is_meant` selects.
    pub fn remove(&self, is_meant: impl Fn(&str) -> bool) -> Result<(), RecordError> {
        self.check()?;
        let Some(mut manifest) = Manifest::read(self.path())? else {
            return Ok(());
        };
        for name in manifest.files.iter().filter(|name| is_meant(name)) {
            remove(self.path(), name)?;
        }
        manifest.files.retain(|name| !is_meant(name));
        manifest.write(self.path())
    }

    /// Records the digests of files that others rely on; call it before writing the summary.
    pub fn seal(&self, names: &[&str]) -> Result<(), RecordError> {
        self.check()?;
        let Some(mut manifest) = Manifest::read(self.path())? else {
            return Ok(());
        };
        manifest.seal(self.path(), names)?;
        manifest.write(self.path())
    }

    /// Removes files that were not written from the manifest.
    fn trim(&self) -> Result<(), RecordError> {
        self.check()?;
        let Some(manifest) = Manifest::read(self.path())? else {
            return Ok(());
        };
        let mut there = manifest.clone();
        there.files.clear();
        for name in &manifest.files {
            if !matching(self.path(), name)?.is_empty() {
                there.files.push(name.clone());
            }
        }
        if there == manifest {
            return Ok(());
        }
        there.write(self.path())
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        // Surplus names do no harm if this fails.
        let _ = self.trim();
    }
}

/// Adds names to the manifest of a folder, before files of these names are written there.
pub fn add(path: &Path, names: &[&str]) -> Result<(), RecordError> {
    let Some(mut manifest) = Manifest::read(path)? else {
        return Err(RecordError::Lost(format!(
            "{} is gone",
            path.join(manifest::NAME).display()
        )));
    };
    refuse_foreign_files(path, names, &manifest.files)?;
    if manifest.add(names) {
        manifest.write(path)?;
    }
    Ok(())
}

/// Refuses to replace files that no tribos command wrote in this folder.
fn refuse_foreign_files(path: &Path, files: &[&str], known: &[String]) -> Result<(), RecordError> {
    for file in files {
        if known.iter().any(|name| name == file) {
            continue;
        }
        if let Some(there) = matching(path, file)?.into_iter().next() {
            return Err(RecordError::Refused(format!(
                "{} is there, and {} does not say that tribos wrote it; move it away, or give \
                 another --out",
                there.display(),
                path.join(manifest::NAME).display()
            )));
        }
    }
    Ok(())
}

/// Removes the files that a name in a manifest denotes.
fn remove(path: &Path, name: &str) -> Result<(), RecordError> {
    if let Some(folder) = name.strip_suffix('/') {
        return FrameFolder::clear(&path.join(folder));
    }
    for file in matching(path, name)? {
        remove_file(&file)?;
    }
    if let Some((folder, _)) = name.rsplit_once('/') {
        // The folder may contain other files too, or not exist.
        let _ = std::fs::remove_dir(path.join(folder));
    }
    Ok(())
}

/// Files of a folder that a name denotes.
fn matching(path: &Path, name: &str) -> Result<Vec<PathBuf>, RecordError> {
    if let Some(folder) = name.strip_suffix('/') {
        let frames = path.join(folder);
        let bodies = frames.join("bodies.json");
        return Ok(if bodies.exists() {
            vec![bodies]
        } else {
            Vec::new()
        });
    }
    let Some((begin, end)) = name.split_once('#') else {
        let file = path.join(name);
        let is_there = file.symlink_metadata().is_ok();
        return Ok(if is_there { vec![file] } else { Vec::new() });
    };
    let (path, begin) = match begin.rsplit_once('/') {
        Some((folder, begin)) => (&path.join(folder), begin),
        None => (&path.to_owned(), begin),
    };
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let is_meant = |name: &str| {
        let digits = name
            .strip_prefix(begin)
            .and_then(|rest| rest.strip_suffix(end));
        digits.is_some_and(|digits| {
            !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
        })
    };
    let names = names(path)?.into_iter();
    Ok(names
        .filter(|name| is_meant(name))
        .map(|name| path.join(name))
        .collect())
}

/// Removes half-written files of killed commands, here and among the frames.
pub fn remove_unfinished(path: &Path) -> Result<(), RecordError> {
    for folder in [path.to_owned(), path.join("frames")] {
        if !folder.is_dir() {
            continue;
        }
        for name in names(&folder)?.iter().filter(|name| is_unfinished(name)) {
            remove_file(&folder.join(name))?;
        }
    }
    Ok(())
}

fn names(folder: &Path) -> Result<Vec<String>, RecordError> {
    let fail = |error| RecordError::lost("read", folder, error);
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        names.extend(entry.map_err(fail)?.file_name().into_string().ok());
    }
    Ok(names)
}

/// Removes a file if it exists.
pub fn remove_file(file: &Path) -> Result<(), RecordError> {
    match std::fs::remove_file(file) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(RecordError::Lost(
            format!("cannot remove {}: {error}", file.display()),
        )),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
