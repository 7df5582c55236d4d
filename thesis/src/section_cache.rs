//! What a report goes on from: finished sections, and runs with their checkpoints.

use super::effort::Effort;
use anyhow::{Context, Result};
use std::hash::{DefaultHasher, Hasher};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tribos::record::write_atomically;
use tribos::run::folder::Lock;
use tribos::run::program;
use tribos_report::page::Section;

/// Name of the folder in a report's.
pub const FOLDER: &str = "kept";

/// The part of a report's folder that no reader looks at. It belongs to one program: another one
/// may compute other bits.
#[derive(Debug)]
pub struct SectionCache {
    /// Of the report's folder.
    pub lock: Arc<Lock>,
    folder: PathBuf,
    /// Time from one checkpoint of a run to the next.
    pub pause: Duration,
}

impl SectionCache {
    /// Opens it, and takes away what another program has left there.
    pub fn open(lock: Arc<Lock>, pause: Duration) -> Result<Self> {
        let all = lock.folder().join(FOLDER);
        let mine = all.join(program());
        let others = std::fs::read_dir(&all).into_iter().flatten().flatten();
        let others = others.filter(|other| other.path() != mine);
        for other in others.filter(|other| is_generated_name(&other.file_name().to_string_lossy()))
        {
            let place = other.path();
            std::fs::remove_dir_all(&place)
                .with_context(|| format!("cannot remove {}", place.display()))?;
        }
        Ok(Self {
            lock,
            folder: mine,
            pause,
        })
    }

    /// The section of an exhibit, if it is finished and all its files are there.
    pub fn section(&self, name: &str, effort: Effort) -> Option<Section> {
        let text = std::fs::read_to_string(self.section_file(name, effort)).ok()?;
        // By way of a value, which holds the digits of its numbers: they come back to the bit.
        let value: serde_json::Value = serde_json::from_str(&text).ok()?;
        let section: Section = serde_json::from_value(value).ok()?;
        let there = |file: &String| self.lock.folder().join(file).exists();
        let files = section.figure.iter().flat_map(|figure| &figure.files);
        files.clone().all(there).then_some(section)
    }

    /// Keeps a section whose files are written.
    pub fn keep(&self, name: &str, effort: Effort, section: &Section) -> Result<()> {
        let text = serde_json::to_string(section)?;
        let file = self.section_file(name, effort);
        self.lock.check()?;
        Ok(write_atomically(&file, text.as_bytes())?)
    }

    /// The folder of a run.
    pub fn run(&self, name: &str) -> PathBuf {
        self.folder.join("runs").join(name)
    }

    fn section_file(&self, name: &str, effort: Effort) -> PathBuf {
        self.folder.join(effort.name()).join(format!("{name}.json"))
    }
}

/// A name for this program: its version, and a digest of its file where that can be read.
fn program() -> String {
    let mut hasher = DefaultHasher::new();
    let file = program::code().and_then(std::fs::read);
    hasher.write(&file.unwrap_or_default());
    format!("{}-{:016x}", env!("CARGO_PKG_VERSION"), hasher.finish())
}

/// Whether a name is one of a program; others are somebody else's.
fn is_generated_name(name: &str) -> bool {
    /// Hexadecimal digits of a digest.
    const DIGITS: usize = 16;
    let digest = name.rsplit_once('-').map_or("", |(_, digest)| digest);
    digest.len() == DIGITS && digest.bytes().all(|byte| byte.is_ascii_hexdigit())
}
