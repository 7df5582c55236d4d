//! Who works in a folder: a file that its process keeps locked, and that says which one it is.
//!
//! The system lets go of the lock when the process ends, whatever ended it: there are no stale locks.

use crate::failure::Failure;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// Name of the file.
const NAME: &str = ".tribos-lock";
/// Letters of a command that are shown to others.
const MOST_LETTERS: usize = 200;

/// Whether others may work in the folder at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharing {
    /// Nobody else.
    Alone,
    /// Others that share it too: parts of a sweep.
    Shared,
}

/// A lock that is held. Dropped, it is free.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    /// None where the file system has no locks.
    file: Option<File>,
    sharing: Sharing,
}

impl Lock {
    /// Takes the lock of a folder, which is made if missing.
    pub fn take(folder: &Path, sharing: Sharing) -> Result<Self, Failure> {
        let path = folder.join(NAME);
        let fail = |error| Failure::run(format!("cannot lock {}: {error}", folder.display()));
        if folder.exists() && !folder.is_dir() {
            let name = folder.display();
            return Err(Failure::input(format!(
                "{name} is a file; give a folder for the results"
            )));
        }
        std::fs::create_dir_all(folder).map_err(fail)?;
        loop {
            let file = OpenOptions::new()
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .open(&path)
                .map_err(fail)?;
            let taken = match sharing {
                Sharing::Alone => file.try_lock(),
                Sharing::Shared => file.try_lock_shared(),
            };
            match taken {
                Ok(()) if !is_at(&file, &path) => continue,
                Ok(()) => return Ok(Self::held(path, file, sharing)),
                Err(TryLockError::WouldBlock) => return Err(in_use(folder, file)),
                Err(TryLockError::Error(error))
                    if error.kind() == std::io::ErrorKind::Unsupported =>
                {
                    return Ok(Self {
                        path,
                        file: None,
                        sharing,
                    });
                }
                Err(TryLockError::Error(error)) => return Err(fail(error)),
            }
        }
    }

    /// Writes who holds it. On a full disk the lock holds without a name, and what is written next
    /// tells of the disk.
    fn held(path: PathBuf, mut file: File, sharing: Sharing) -> Self {
        let _ = sign(&mut file);
        Self {
            path,
            file: Some(file),
            sharing,
        }
    }
}

impl Drop for Lock {
    /// The file goes while it is locked: whoever opened it before sees that it is gone. One that is
    /// shared stays for the others.
    fn drop(&mut self) {
        if self.file.is_some() && self.sharing == Sharing::Alone {
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
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// The refusal that names the other command.
fn in_use(folder: &Path, mut file: File) -> Failure {
    let mut other = String::new();
    let told = file.read_to_string(&mut other).is_ok() && !other.trim().is_empty();
    let other = if told {
        other.trim()
    } else {
        "another command"
    };
    Failure::input(format!(
        "{} is in use by {other}; wait for it, or give another --out",
        folder.display()
    ))
}

/// Replaces the name in the file by that of this process.
fn sign(file: &mut File) -> std::io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    file.write_all(myself().as_bytes())
}

/// This process as others read it.
fn myself() -> String {
    let words: Vec<String> = std::env::args_os()
        .skip(1)
        .map(|word| word.to_string_lossy().into_owned())
        .collect();
    let command: String = words.join(" ").chars().take(MOST_LETTERS).collect();
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let seconds = now.map_or(0, |now| now.as_secs());
    format!(
        "process {}, `tribos {command}`, since {}\n",
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
        let alone = Lock::take(&folder, Sharing::Alone)?;
        let Err(Failure::Input(told)) = Lock::take(&folder, Sharing::Shared) else {
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
        let parts = [(); 2].map(|()| Lock::take(&folder, Sharing::Shared));
        assert!(parts.iter().all(Result::is_ok));
        assert!(Lock::take(&folder, Sharing::Alone).is_err());
        drop(parts);
        assert!(Lock::take(&folder, Sharing::Alone).is_ok());
        // A file that a killed process left is no lock.
        std::fs::write(folder.join(NAME), "process 1")?;
        assert!(Lock::take(&folder, Sharing::Alone).is_ok());
        assert!(Lock::take(&folder.join("x/y"), Sharing::Alone).is_ok());
        Ok(())
    }
}
