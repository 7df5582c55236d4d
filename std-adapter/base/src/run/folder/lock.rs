//! Lock of a folder: a file that a process keeps locked and that names this process.
//!
//! The operating system releases the lock when the process ends for any reason, so there are no stale locks.

use crate::record::RecordError;
use crate::run::program;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// Name of the file.
const NAME: &str = ".tribos-lock";
/// Number of characters of a command that are shown to others.
const MOST_LETTERS: usize = 200;

/// Whether others may work in the folder at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LockMode {
    /// Nobody else.
    Alone,
    /// Other processes that share it too: parts of a sweep.
    Shared,
}

/// A held lock; dropping it releases the folder.
#[derive(Debug)]
pub struct Lock {
    folder: PathBuf,
    path: PathBuf,
    /// The locked file; `None` if the file system has no locks.
    file: Option<File>,
    sharing: LockMode,
}

/// Result of an attempt to lock.
#[derive(Debug)]
pub enum LockOutcome {
    /// The lock is held.
    Taken(Lock),
    /// Another process holds the lock; the text names it as the beginning of a sentence.
    InUse(String),
}

impl Lock {
    /// Locks a folder, which is created if missing.
    pub fn take(folder: &Path, sharing: LockMode) -> Result<Self, RecordError> {
        match Self::attempt(folder, sharing)? {
            LockOutcome::Taken(lock) => Ok(lock),
            LockOutcome::InUse(told) => Err(RecordError::Refused(format!(
                "{told}; wait for it, or give another --out"
            ))),
        }
    }

    /// Locks a folder, which is created if missing, unless another process holds the lock.
    pub fn attempt(folder: &Path, sharing: LockMode) -> Result<LockOutcome, RecordError> {
        let path = folder.join(NAME);
        let fail = |verb| move |error| RecordError::lost(verb, folder, error);
        if folder.exists() && !folder.is_dir() {
            let name = folder.display();
            return Err(RecordError::Refused(format!(
                "{name} is a file; give a folder for the results"
            )));
        }
        std::fs::create_dir_all(folder).map_err(fail("make the folder"))?;
        loop {
            let file = OpenOptions::new()
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .open(&path)
                .map_err(fail("lock"))?;
            let taken = match sharing {
                LockMode::Alone => file.try_lock(),
                LockMode::Shared => file.try_lock_shared(),
            };
            let file = match taken {
                Ok(()) if !is_at(&file, &path) => continue,
                Ok(()) => Some(signed(file)),
                Err(TryLockError::WouldBlock) => {
                    return Ok(LockOutcome::InUse(in_use(folder, file)));
                }
                Err(TryLockError::Error(error))
                    if error.kind() == std::io::ErrorKind::Unsupported =>
                {
                    None
                }
                Err(TryLockError::Error(error)) => return Err(fail("lock")(error)),
            };
            return Ok(LockOutcome::Taken(Self {
                folder: folder.to_owned(),
                path,
                file,
                sharing,
            }));
        }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Call this before writing: it fails if the folder at this path is not the one that was locked.
    /// In that case it was moved or deleted, or the lock was removed, and another command may use it.
    pub fn check(&self) -> Result<(), RecordError> {
        if self.is_own() {
            return Ok(());
        }
        Err(RecordError::Lost(format!(
            "{0} was moved or deleted while this command worked in it, or its file {NAME} was; \
             nothing more is written there\n  Leave the folder of a command where it is until the \
             command ends, and give the command again.",
            self.folder.display()
        )))
    }

    fn is_own(&self) -> bool {
        let file = self.file.as_ref();
        file.is_none_or(|file| match self.sharing {
            LockMode::Alone => is_still_at(file, &self.path),
            // Other processes that share the lock sign it too.
            LockMode::Shared => is_at(file, &self.path),
        })
    }
}

/// Writes the holder's name. On a full disk the lock holds without a name, and the next write
/// reports the disk.
fn signed(mut file: File) -> File {
    let _ = sign(&mut file);
    file
}

impl Drop for Lock {
    /// The file goes while it is locked: whoever opened it before sees that it is gone. One that is
    /// shared stays for the others, and one that another command has made since for that.
    fn drop(&mut self) {
        if self.file.is_some() && self.sharing == LockMode::Alone && self.is_own() {
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

/// Whether the open file is the one that the path leads to now: another process may have removed it
/// between opening and locking.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let (Ok(open), Ok(there)) = (file.metadata(), path.metadata()) else {
        return false;
    };
    (open.dev(), open.ino()) == (there.dev(), there.ino())
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}

/// Whether the file that the path leads to is the open one, which this process has signed.
#[cfg(unix)]
fn is_still_at(file: &File, path: &Path) -> bool {
    is_at(file, path)
}

/// The same where files have no numbers: by the name of this process, if the file can be read while
/// it is locked.
#[cfg(not(unix))]
fn is_still_at(_: &File, path: &Path) -> bool {
    let process = format!("process {},", std::process::id());
    match std::fs::read_to_string(path) {
        Ok(name) => name.is_empty() || name.starts_with(&process),
        Err(error) => error.kind() != std::io::ErrorKind::NotFound,
    }
}

/// Text that names the other command.
fn in_use(folder: &Path, mut file: File) -> String {
    let mut other = String::new();
    let told = file.read_to_string(&mut other).is_ok() && !other.trim().is_empty();
    let other = if told {
        other.trim()
    } else {
        "another command"
    };
    format!("{} is in use by {other}", folder.display())
}

/// Replaces the name in the file by that of this process.
fn sign(file: &mut File) -> std::io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    file.write_all(process_description().as_bytes())
}

/// Description of this process for others.
fn process_description() -> String {
    let words: Vec<String> = program::line()
        .iter()
        .map(|word| word.to_string_lossy().into_owned())
        .collect();
    let command: String = words.join(" ").chars().take(MOST_LETTERS).collect();
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let seconds = now.map_or(0, |now| now.as_secs());
    format!(
        "process {}, `{command}`, since {}\n",
        std::process::id(),
        clock(seconds)
    )
}

/// A time since 1970 as date and time, in UTC.
fn clock(seconds: u64) -> String {
    const DAY: u64 = 86_400;
    let (mut year, mut day) = (1970, seconds / DAY);
    let leap = |year: u64| {
        year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
    };
    while day >= 365 + u64::from(leap(year)) {
        day -= 365 + u64::from(leap(year));
        year += 1;
    }
    let mut month = 1;
    for length in [
        31,
        28 + u64::from(leap(year)),
        31,
        30,
        31,
        30,
        31,
        31,
        30,
        31,
        30,
    ] {
        if day < length {
            break;
        }
        day -= length;
        month += 1;
    }
    let (hour, minute, second) = (seconds % DAY / 3600, seconds % 3600 / 60, seconds % 60);
    format!(
        "{year}-{month:02}-{:02} {hour:02}:{minute:02}:{second:02} UTC",
        day + 1
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_told_as_dates() {
        // From `date -u -d @…`.
        for (seconds, told) in [
            (0, "1970-01-01 00:00:00 UTC"),
            (951_782_399, "2000-02-28 23:59:59 UTC"),
            (951_782_400, "2000-02-29 00:00:00 UTC"),
            (1_767_225_599, "2025-12-31 23:59:59 UTC"),
            (4_107_542_400, "2100-03-01 00:00:00 UTC"),
        ] {
            assert_eq!(clock(seconds), told);
        }
    }

    #[test]
    fn a_folder_is_for_one_or_for_those_that_share_it() -> Result<(), Box<dyn std::error::Error>> {
        let home = tempfile::tempdir()?;
        let folder = home.path().join("out");
        let alone = Lock::take(&folder, LockMode::Alone)?;
        let Err(RecordError::Refused(told)) = Lock::take(&folder, LockMode::Shared) else {
            unreachable!("locked");
        };
        let process = format!("process {}", std::process::id());
        assert!(
            told.contains(&process) && told.contains("since 20"),
            "{told}"
        );
        drop(alone);
        // Nothing is left behind.
        assert_eq!(std::fs::read_dir(&folder)?.count(), 0);
        let parts = [(); 2].map(|()| Lock::take(&folder, LockMode::Shared));
        assert!(parts.iter().all(Result::is_ok));
        assert!(Lock::take(&folder, LockMode::Alone).is_err());
        drop(parts);
        assert!(Lock::take(&folder, LockMode::Alone).is_ok());
        // A file that a killed process left is no lock.
        std::fs::write(folder.join(NAME), "process 1")?;
        assert!(Lock::take(&folder, LockMode::Alone).is_ok());
        assert!(Lock::take(&folder.join("x/y"), LockMode::Alone).is_ok());
        Ok(())
    }

    #[test]
    fn a_folder_that_is_moved_or_remade_is_lost() -> Result<(), Box<dyn std::error::Error>> {
        let home = tempfile::tempdir()?;
        let folder = home.path().join("out");
        let lock = Lock::take(&folder, LockMode::Alone)?;
        lock.check()?;
        std::fs::rename(&folder, home.path().join("moved"))?;
        assert!(matches!(lock.check(), Err(RecordError::Lost(_))));
        // The lock of another command there stays when this one ends.
        let other = Lock::take(&folder, LockMode::Alone)?;
        assert!(lock.check().is_err());
        drop(lock);
        assert!(folder.join(NAME).exists());
        other.check()?;
        std::fs::remove_file(folder.join(NAME))?;
        assert!(other.check().is_err());
        Ok(())
    }
}
