//! `tribos.json`: which command wrote which files.

use super::Contents;
use crate::record::RecordError;
use crate::record::{digest, read_text, verified, with_digest, write_atomically_there};
use serde_json::{Map, Value};
use std::path::{Component, Path};

/// Name of the file.
pub const NAME: &str = "tribos.json";
/// First key of the file, with its format.
const KEY: &str = "tribos_folder";
const FORMAT: u64 = 1;
/// Largest size of the file in bytes.
const MOST_BYTES: u64 = 16 << 20;

/// Contents of a folder.
#[derive(Clone, Debug, PartialEq)]
pub struct Manifest {
    /// Name of the command.
    pub command: String,
    /// Subject of the results: the scene of a run, else null.
    pub about: Value,
    /// Names of the files, as in [`Contents`].
    pub files: Vec<String>,
    /// Digests of some of the files, once they are complete.
    pub digests: Map<String, Value>,
}

impl Manifest {
    /// Manifest of a command that begins to write.
    pub fn of(contents: &Contents<'_>) -> Self {
        Self {
            command: contents.command.into(),
            about: contents.about.clone(),
            files: contents.files.iter().map(|&name| name.into()).collect(),
            digests: Map::new(),
        }
    }

    /// Adds names and returns whether any of them is new.
    pub fn add(&mut self, names: &[&str]) -> bool {
        let before = self.files.len();
        for &name in names {
            if !self.files.iter().any(|file| file == name) {
                self.files.push(name.into());
            }
        }
        self.files.len() > before
    }

    /// Reads the manifest of a folder, if there is one.
    pub fn read(folder: &Path) -> Result<Option<Self>, RecordError> {
        let file = folder.join(NAME);
        let text = match read_text(&file, MOST_BYTES) {
            Err(error) if error.is_missing() => return Ok(None),
            text => text.map_err(|error| {
                RecordError::Refused(format!("cannot read {}: {error}", file.display()))
            })?,
        };
        Self::parse(&text).map(Some).ok_or_else(|| {
            RecordError::Refused(format!(
                "{} is damaged or of another version, so that nobody knows which files beside it \
                 tribos wrote; empty the folder, or give another one",
                file.display()
            ))
        })
    }

    fn parse(text: &str) -> Option<Self> {
        let value = verified(text)?;
        if value[KEY].as_u64() != Some(FORMAT) {
            return None;
        }
        let names = value["files"].as_array()?.iter();
        let files: Option<Vec<String>> =
            names.map(|name| name.as_str().map(String::from)).collect();
        let files = files?;
        files.iter().all(|name| is_inside(name)).then_some(Self {
            command: value["command"].as_str()?.into(),
            about: value["about"].clone(),
            files,
            digests: value["digests"].as_object()?.clone(),
        })
    }

    /// Writes the manifest to the folder.
    pub fn write(&self, folder: &Path) -> Result<(), RecordError> {
        // Sorted, so that the order does not depend on interruptions.
        let mut files = self.files.clone();
        files.sort();
        let map = Map::from_iter([
            (KEY.to_owned(), FORMAT.into()),
            ("command".to_owned(), self.command.as_str().into()),
            ("version".to_owned(), env!("CARGO_PKG_VERSION").into()),
            ("about".to_owned(), self.about.clone()),
            ("files".to_owned(), files.into()),
            ("digests".to_owned(), self.digests.clone().into()),
        ]);
        write_atomically_there(&folder.join(NAME), with_digest(map).as_bytes())
    }

    /// Records the digests of files.
    pub fn seal(&mut self, folder: &Path, names: &[&str]) -> Result<(), RecordError> {
        for &name in names {
            let file = folder.join(name);
            let bytes =
                std::fs::read(&file).map_err(|error| RecordError::lost("read", &file, error))?;
            self.digests.insert(name.into(), digits(&bytes).into());
        }
        Ok(())
    }

    /// Whether these are the bytes of a file as the command wrote it.
    pub fn is_of(&self, name: &str, bytes: &[u8]) -> bool {
        self.digests.get(name).and_then(Value::as_str) == Some(&digits(bytes))
    }
}

fn digits(bytes: &[u8]) -> String {
    format!("{:032x}", digest(bytes))
}

/// Whether a name denotes a path inside the folder.
fn is_inside(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    !name.is_empty() && parts.all(|part| matches!(part, Component::Normal(_)))
}
