//! Refusals of files.

use super::super::ProblemError;
use std::fmt;

/// A fault and its place, before the file's path is known.
pub(super) type LocatedFault = (FilePosition, Fault);

/// Where in a file something is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FilePosition {
    /// The file as a whole.
    File,
    /// A line of text, from 1.
    Line(usize),
    /// A dataset or a group of HDF5, by its path.
    Dataset(String),
}

impl fmt::Display for FilePosition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(line) => write!(f, ", line {line}"),
            Self::Dataset(path) => write!(f, ", {path}"),
        }
    }
}

/// Why a file of a contact problem was refused.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The operating system could not read the file.
    #[error("cannot be read: {0}")]
    Read(std::io::Error),
    /// The operating system could not write the file.
    #[error("cannot be written: {0}")]
    Write(std::io::Error),
    /// The file is neither HDF5 nor text.
    #[error("neither HDF5 nor text in UTF-8; contact problems are FCLib's HDF5 or Siconos' text")]
    NeitherFormat,
    /// The text ends early.
    #[error("the file ends where {0} should follow")]
    Ended(String),
    /// A word of the text is another than what should stand there.
    #[error("found {found} instead of {wanted}")]
    Word {
        /// The word.
        found: String,
        /// What would be valid.
        wanted: String,
    },
    /// A number is larger than others or the file's size allow.
    #[error("{what} is {found}, not {wanted}")]
    Count {
        /// What is counted.
        what: String,
        /// The number in the file.
        found: i128,
        /// Numbers that would be valid.
        wanted: String,
    },
    /// Something follows after the problem's last number.
    #[error("found {0} where the file should end")]
    Beyond(String),
    /// The library for HDF5 refuses the file.
    #[error("not readable as HDF5: {0}")]
    Hdf5(String),
    /// A dataset or a group is missing.
    #[error("missing; {0}")]
    Missing(&'static str),
    /// Data are stored in a form that is not read.
    #[error("{0}")]
    Unsupported(&'static str),
    /// A file of this format cannot hold a part of the problem.
    #[error("{what} of contact {contact} has no place in this format; write HDF5 instead")]
    NoPlace {
        /// The part.
        what: &'static str,
        /// First contact that needs it, from 0.
        contact: usize,
    },
    /// Contacts of this layout do not exist in this format.
    #[error(
        "contacts of {0} components have no place in this format, which has 2, 3 or 5; write HDF5 instead"
    )]
    Layout(usize),
    /// Data are not a contact problem.
    #[error("not a contact problem: {0}")]
    Problem(#[from] ProblemError),
}
