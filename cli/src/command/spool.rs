//! Output that is too large for the memory and appears whole or not at all.

use crate::failure::Failure;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};
use tribos::record::{RecordError, write_atomically_with};

/// Where text goes before it is delivered.
pub struct Sink<'a> {
    writer: BufWriter<&'a mut File>,
    /// The file as messages name it.
    name: PathBuf,
}

impl Sink<'_> {
    /// Appends text.
    pub fn put(&mut self, text: &str) -> Result<(), Failure> {
        let written = self.writer.write_all(text.as_bytes());
        written.map_err(|cause| self.failure(cause))
    }

    fn flush(mut self) -> Result<(), Failure> {
        let flushed = self.writer.flush();
        flushed.map_err(|cause| self.failure(cause))
    }

    fn failure(&self, cause: io::Error) -> Failure {
        let path = self.name.clone();
        RecordError::Write { path, cause }.into()
    }
}

/// Writes what `fill` puts into a file, or without one to standard output; if `fill` fails, the file
/// is as it was and nothing is printed.
pub fn deliver(
    output: Option<&Path>,
    fill: impl FnOnce(&mut Sink<'_>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let filled = |file: &mut File, name: &Path| {
        let mut sink = Sink {
            writer: BufWriter::new(file),
            name: name.to_path_buf(),
        };
        fill(&mut sink)?;
        sink.flush()
    };
    match output {
        Some(path) => write_atomically_with(path, |file| filled(file, path)),
        None => {
            // A file without a name: nothing of it is left, however the program ends.
            let folder = std::env::temp_dir();
            let fail = |cause| RecordError::Write {
                path: folder.clone(),
                cause,
            };
            let mut file = tempfile::tempfile_in(&folder).map_err(fail)?;
            filled(&mut file, &folder)?;
            file.rewind().map_err(fail)?;
            printed(&mut file)
        }
    }
}

/// Copies a file to standard output; a reader that went away is not an error.
fn printed(file: &mut File) -> Result<(), Failure> {
    match io::copy(file, &mut io::stdout().lock()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::run(format!(
            "cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
