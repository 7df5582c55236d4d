//! Refusals of contact problems.

use super::file::{Fault, FilePosition};
use std::path::PathBuf;

/// Why data is not a contact problem, or a file of one cannot be read or written.
///
/// ```
/// use tribos::problem::{ContactProblem, ProblemError};
/// let home = tempfile::tempdir()?;
/// let path = home.path().join("fall.dat");
/// std::fs::write(&path, "3\n1\n0\n3 x")?;
/// let error = ContactProblem::read(&path).unwrap_err();
/// assert!(matches!(error, ProblemError::File { .. }));
/// assert!(error.to_string().contains("fall.dat, line 4: the number of rows is 3, not at most 2"));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProblemError {
    /// A file could not be read or written.
    #[error("{}{place}: {fault}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Where in the file.
        place: FilePosition,
        /// What is wrong there, and what would be valid.
        #[source]
        fault: Box<Fault>,
    },
    /// An entry of a matrix is outside.
    #[error("entry ({row}, {column}) is outside the matrix of {} rows and {} columns", shape[0], shape[1])]
    OutOfRange {
        /// Row of the entry, from 0.
        row: usize,
        /// Column of the entry, from 0.
        column: usize,
        /// Rows and columns of the matrix.
        shape: [usize; 2],
    },
    /// A number is not finite.
    #[error("{what} is not finite")]
    NotFinite {
        /// What is not finite.
        what: &'static str,
    },
    /// A matrix or a vector has another size than the others.
    #[error("{what} has {found} {of}, not {wanted}")]
    Size {
        /// The matrix or the vector.
        what: &'static str,
        /// What is counted: rows, columns or elements.
        of: &'static str,
        /// Its size.
        found: usize,
        /// The size that fits the rest.
        wanted: usize,
    },
    /// A coefficient or a cohesion is negative.
    #[error("{what} of contact {contact} is {value}; it must be finite and not negative")]
    Law {
        /// The coefficient.
        what: &'static str,
        /// The contact, from 0.
        contact: usize,
        /// Its value.
        value: f64,
    },
    /// The mass matrix cannot be inverted.
    #[error("the mass matrix is singular at degree of freedom {0}")]
    Singular(usize),
}
