//! Resolves a path to a file that may be replaced or a stream to write to.

use std::io;
use std::path::{Path, PathBuf};

/// Largest number of links that are followed, as in Linux.
const MOST_LINKS: usize = 40;

/// Target of a path.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// A regular file, or none yet: replaced at the end of all links.
    File(PathBuf),
    /// A device, a pipe, a socket or an open file of a process: written into.
    Stream(PathBuf),
}

impl Target {
    /// Follows the links of a path.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        // The target of a link in /dev/fd is not always a path: the system opens it.
        let is_stream = path
            .metadata()
            .is_ok_and(|there| !there.is_file() && !there.is_dir());
        if is_stream {
            return Ok(Self::Stream(path.to_owned()));
        }
        let mut place = path.to_owned();
        for _ in 0..MOST_LINKS {
            if !place.is_symlink() {
                return Ok(Self::File(place));
            }
            if is_of_process(&place) {
                return Ok(Self::Stream(path.to_owned()));
            }
            let link = std::fs::read_link(&place)?;
            place = folder_of(&place).join(link);
        }
        Err(io::Error::other("too many symbolic links"))
    }

    /// Folder of the temporary file.
    pub(super) fn folder(&self) -> PathBuf {
        match self {
            Self::File(place) => folder_of(place).to_owned(),
            Self::Stream(_) => std::env::temp_dir(),
        }
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Whether a link is an open file of a process, like that of /dev/stdout: a file that a process
/// has open is not replaced.
fn is_of_process(link: &Path) -> bool {
    let folder = folder_of(link).canonicalize();
    cfg!(target_os = "linux") && folder.is_ok_and(|folder| folder.starts_with("/proc"))
}

/// Gives a temporary file, private by default, the permissions and the owner of the file that it
/// replaces, or those of an ordinary one.
#[cfg(unix)]
pub(super) fn prepare(file: &std::fs::File, place: &Path) -> io::Result<()> {
    use std::fs::Permissions;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    /// Mode of an ordinary file: the owner writes, everybody reads.
    const ORDINARY: u32 = 0o644;
    /// Permission bits of a mode, without setuid, setgid and sticky bits.
    const RIGHTS: u32 = 0o777;
    let old = place.metadata().ok().filter(std::fs::Metadata::is_file);
    if let Some(old) = &old {
        let new = file.metadata()?;
        if (old.uid(), old.gid()) != (new.uid(), new.gid()) {
            // Only some users may give files away.
            let _ = fchown(file, Some(old.uid()), Some(old.gid()));
        }
    }
    let mode = old.map_or(ORDINARY, |old| old.mode() & RIGHTS);
    file.set_permissions(Permissions::from_mode(mode))
}

#[cfg(not(unix))]
pub(super) fn prepare(_: &std::fs::File, _: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use crate::record::write_atomically;
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::path::Path;
    use std::process::Command;

    type Outcome = Result<(), Box<dyn std::error::Error>>;

    #[test]
    fn links_stay_and_a_file_keeps_its_permissions() -> Outcome {
        let home = tempfile::tempdir()?;
        let home = home.path();
        let mode = |path: &Path| Ok::<_, std::io::Error>(path.metadata()?.permissions().mode());
        std::fs::create_dir(home.join("there"))?;
        let file = home.join("there/file");
        std::fs::write(&file, "old")?;
        std::fs::set_permissions(&file, PermissionsExt::from_mode(0o600))?;
        symlink("there/file", home.join("near"))?;
        symlink(home.join("near"), home.join("far"))?;
        write_atomically(&home.join("far"), b"new")?;
        assert_eq!(std::fs::read(&file)?, b"new");
        assert_eq!(mode(&file)? & 0o777, 0o600);
        assert!(home.join("far").is_symlink() && home.join("near").is_symlink());
        assert_eq!(std::fs::read_dir(home.join("there"))?.count(), 1);
        // A dangling link creates its file; a cycle is refused.
        symlink("there/made", home.join("dangling"))?;
        write_atomically(&home.join("dangling"), b"made")?;
        assert_eq!(mode(&home.join("there/made"))? & 0o777, 0o644);
        symlink("circle", home.join("circle"))?;
        assert!(write_atomically(&home.join("circle"), b"x").is_err());
        Ok(())
    }

    #[test]
    fn a_pipe_takes_the_bytes_and_stays() -> Outcome {
        let home = tempfile::tempdir()?;
        let pipe = home.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status()?.success());
        symlink("pipe", home.path().join("link"))?;
        for name in ["pipe", "link"] {
            let reader = std::thread::spawn({
                let pipe = pipe.clone();
                move || std::fs::read(pipe)
            });
            write_atomically(&home.path().join(name), b"through")?;
            let read = reader.join().map_err(|_| "the reader failed")??;
            assert_eq!(read, b"through");
        }
        assert!(pipe.metadata()?.file_type().is_fifo());
        assert_eq!(std::fs::read_dir(home.path())?.count(), 2);
        Ok(())
    }
}
