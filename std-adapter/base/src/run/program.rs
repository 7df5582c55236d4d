//! The program that runs here, for locks, scripts and kept results: its command line, its file, and the file
//! whose code computes.
//!
//! Of the command these are what the operating system says. A program that loads this crate as a library says
//! them itself: there the operating system knows an interpreter only.

use std::ffi::OsString;
use std::io;
use std::path::PathBuf;
use std::sync::{PoisonError, RwLock};

/// A program that loads this crate as a library.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Command line, the program's name first.
    pub line: Vec<OsString>,
    /// The command `tribos`, if there is one.
    pub command: Option<PathBuf>,
    /// The loaded library.
    pub library: PathBuf,
}

static HOST: RwLock<Option<Program>> = RwLock::new(None);

/// Says which program runs here.
pub fn host(program: Program) {
    *HOST.write().unwrap_or_else(PoisonError::into_inner) = Some(program);
}

fn of_host<T>(part: impl FnOnce(&Program) -> T) -> Option<T> {
    let host = HOST.read().unwrap_or_else(PoisonError::into_inner);
    host.as_ref().map(part)
}

/// The command line, the program's name first: `tribos` for the command.
pub fn line() -> Vec<OsString> {
    of_host(|host| host.line.clone()).unwrap_or_else(|| {
        let rest = std::env::args_os().skip(1);
        std::iter::once("tribos".into()).chain(rest).collect()
    })
}

/// The file of the command `tribos`.
pub fn command() -> io::Result<PathBuf> {
    let missing = || {
        let text = "the command tribos is not on the PATH";
        io::Error::new(io::ErrorKind::NotFound, text)
    };
    match of_host(|host| host.command.clone()) {
        Some(command) => command.ok_or_else(missing),
        None => std::env::current_exe(),
    }
}

/// The file whose code computes: another one may compute other bits.
pub fn code() -> io::Result<PathBuf> {
    of_host(|host| host.library.clone()).map_or_else(std::env::current_exe, Ok)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_operating_system_knows_the_command() {
        let here = std::env::current_exe().ok();
        assert!(here.is_some() && command().ok() == here && code().ok() == here);
        assert_eq!(line()[0], "tribos");
    }
}
