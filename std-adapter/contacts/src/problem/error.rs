//! Refusals of contact problems.

/// Why data is not a contact problem.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProblemError {
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
