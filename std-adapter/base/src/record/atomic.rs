//! Files that are complete or absent.

use super::RecordError;
use super::target::{Target, prepare};
use std::io::{BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

/// Beginning and end of the names of unfinished files.
const UNFINISHED: [&str; 2] = [".tribos-", ".tmp"];

/// Whether a file of this name is being written, or was when its program was killed.
///
/// ```
/// use tribos::record::is_unfinished;
/// assert!(is_unfinished(".tribos-Ab3xYz.tmp"));
/// assert!(!is_unfinished("series.csv") && !is_unfinished(".tmpAb3xYz")); // somebody else's
/// ```
pub fn is_unfinished(name: &str) -> bool {
    let [begin, end] = UNFINISHED;
    name.strip_prefix(begin)
        .is_some_and(|rest| rest.ends_with(end))
}

/// Writes `bytes` to `path` through a temporary file in the same folder, which is created if
/// missing. Once it returns, the file survives a crash of the program and a loss of power.
///
/// A symbolic link is kept, and the file that it points to is replaced. A replaced file keeps its
/// permissions. Devices, pipes and sockets are never replaced: the bytes are written to them.
///
/// A program that is killed meanwhile leaves a file whose name [shows this](is_unfinished).
///
/// ```
/// use tribos::record::write_atomically;
/// let home = tempfile::tempdir()?;
/// let file = home.path().join("out/speed.csv");
/// write_atomically(&file, b"time,speed\n")?;
/// assert_eq!(std::fs::read(&file)?, b"time,speed\n");
/// // A folder is not overwritten by a file, and nothing half-written stays behind.
/// assert!(write_atomically(&home.path().join("out"), b"").is_err());
/// assert_eq!(std::fs::read_dir(home.path())?.count(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    let mut file = AtomicFile::begin(path)?;
    file.add(bytes)?;
    file.finish()
}

/// As [`write_atomically`], in an existing folder, which is not created again if it was moved.
///
/// ```
/// use tribos::record::write_atomically_there;
/// let home = tempfile::tempdir()?;
/// assert!(write_atomically_there(&home.path().join("out/speed.csv"), b"time").is_err());
/// assert!(!home.path().join("out").exists());
/// write_atomically_there(&home.path().join("speed.csv"), b"time")?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_atomically_there(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    let mut file = AtomicFile::begin_in_existing_folder(path)?;
    file.add(bytes)?;
    file.finish()
}

/// As [`write_atomically`], with `fill` to write the contents, for files that are too large for
/// memory. If `fill` fails, an earlier file at `path` is unchanged.
///
/// ```
/// use std::io::Write;
/// use tribos::record::{RecordError, write_atomically_with};
/// let home = tempfile::tempdir()?;
/// let path = home.path().join("speed.csv");
/// write_atomically_with(&path, |file| {
///     let fail = |cause| RecordError::Write { path: path.clone(), cause };
///     (0..3).try_for_each(|k| writeln!(file, "{k}").map_err(fail))
/// })?;
/// assert_eq!(std::fs::read_to_string(&path)?, "0\n1\n2\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_atomically_with<E: From<RecordError>>(
    path: &Path,
    fill: impl FnOnce(&mut std::fs::File) -> Result<(), E>,
) -> Result<(), E> {
    let mut file = AtomicFile::begin(path)?;
    fill(file.file.get_mut().0.as_file_mut())?;
    Ok(file.finish()?)
}

/// A file that is written in parts, and appears once it is finished.
#[derive(Debug)]
pub(crate) struct AtomicFile {
    /// Path for messages.
    path: PathBuf,
    target: Target,
    file: BufWriter<Unnamed>,
}

/// A temporary file whose errors do not name it.
#[derive(Debug)]
struct Unnamed(tempfile::NamedTempFile);

impl Write for Unnamed {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.as_file().write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.0.as_file().flush()
    }
}

impl AtomicFile {
    /// Begins a temporary file in the folder of `path`, which is created if missing.
    pub(crate) fn begin(path: &Path) -> Result<Self, RecordError> {
        Self::begin_in(path, |folder| std::fs::create_dir_all(folder))
    }

    /// The same in an existing folder.
    fn begin_in_existing_folder(path: &Path) -> Result<Self, RecordError> {
        Self::begin_in(path, |_| Ok(()))
    }

    fn begin_in(
        path: &Path,
        make: impl FnOnce(&Path) -> std::io::Result<()>,
    ) -> Result<Self, RecordError> {
        let begun = || {
            let target = Target::of(path)?;
            let folder = target.folder();
            make(&folder)?;
            let [begin, end] = UNFINISHED;
            let mut builder = tempfile::Builder::new();
            builder.prefix(begin).suffix(end);
            Ok((target, builder.tempfile_in(folder)?))
        };
        let path = path.to_path_buf();
        match begun() {
            Ok((target, file)) => Ok(Self {
                path,
                target,
                file: BufWriter::new(Unnamed(file)),
            }),
            Err(cause) => Err(RecordError::Write { path, cause }),
        }
    }

    /// Adds bytes.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.file
            .write_all(bytes)
            .map_err(|cause| RecordError::Write {
                path: self.path.clone(),
                cause,
            })
    }

    /// Gives the file its name, or copies its bytes to a device, pipe or socket.
    pub(crate) fn finish(self) -> Result<(), RecordError> {
        let Self { path, target, file } = self;
        let deliver = || {
            let Unnamed(mut file) = file.into_inner().map_err(|error| error.into_error())?;
            match target {
                Target::File(place) => {
                    prepare(file.as_file(), &place)?;
                    file.as_file().sync_all()?;
                    file.persist(&place).map_err(|error| error.error)?;
                }
                Target::Stream(place) => {
                    let mut stream = std::fs::OpenOptions::new().append(true).open(place)?;
                    file.rewind()?;
                    std::io::copy(file.as_file_mut(), &mut stream)?;
                    stream.flush()?;
                }
            }
            Ok(())
        };
        deliver().map_err(|cause| RecordError::Write { path, cause })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("deep/er/a.txt");
        write_atomically(&path, b"one")?;
        write_atomically(&path, b"two")?;
        assert_eq!(std::fs::read(&path)?, b"two");
        // A folder of that name cannot be replaced by a file.
        let blocked = folder.path().join("deep");
        assert!(write_atomically(&blocked, b"x").is_err());
        assert_eq!(std::fs::read_dir(folder.path())?.count(), 1);
        Ok(())
    }
}
