//! Who asked for a run: a person at a terminal, or a program that has this crate as a library.

use crate::command::interrupt;
use crate::command::progress::{HostProgram, Meter};
use crate::failure::Failure;
use std::fmt;

/// The one who asked, and who hears what a person at a terminal would read.
#[derive(Clone, Copy)]
pub enum Frontend<'a> {
    /// The person who gave the command.
    Terminal,
    /// A program.
    Host(&'a dyn HostProgram),
}

impl fmt::Debug for Frontend<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Terminal => "Terminal",
            Self::Host(_) => "Host",
        })
    }
}

impl<'a> Frontend<'a> {
    /// From now on signals of the terminal are noted; a program has its own.
    pub fn watch(self) -> Result<(), Failure> {
        match self {
            Self::Terminal => interrupt::watch(),
            Self::Host(_) => Ok(()),
        }
    }

    /// Whether the run has been asked to end.
    pub fn is_asked(self) -> bool {
        match self {
            Self::Terminal => interrupt::is_asked(),
            Self::Host(host) => host.is_cancelled(),
        }
    }

    /// Follows the run.
    pub fn meter(self) -> Meter<'a> {
        match self {
            Self::Terminal => Meter::new(),
            Self::Host(host) => Meter::of(host),
        }
    }

    /// A line before the work starts.
    pub fn tell(self, words: fmt::Arguments<'_>) {
        if matches!(self, Self::Terminal) {
            crate::command::note(words);
        }
    }

    /// The results in words.
    pub fn report(self, text: &str) -> Result<(), Failure> {
        match self {
            Self::Terminal => crate::command::print(text),
            Self::Host(_) => Ok(()),
        }
    }
}
