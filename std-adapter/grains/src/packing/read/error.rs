//! Why spheres cannot be read.

use tribos_base::exchange::text::TextError;
use tribos_base::record::RecordError;
use tribos_base::space::SpaceError;

/// Why spheres cannot be read.
///
/// ```
/// use tribos::measure::{Assembly, AssemblyError};
/// let atoms = "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3\nAr 1 1 1\n";
/// let refused = Assembly::parse("argon.xyz", atoms).map(|_| ()).map_err(|error| error.to_string());
/// assert_eq!(
///     refused,
///     Err(
///         "argon.xyz: line 2: there are no radii; give a column radius:R:1, or one radius of all by --columns \
///          radius=all:VALUE (key `columns`)"
///             .into()
///     )
/// );
/// ```
#[derive(Debug, thiserror::Error)]
pub enum AssemblyError {
    /// The file cannot be read.
    #[error("{file}: {cause}")]
    Read {
        /// Name of the file.
        file: String,
        /// The reason.
        #[source]
        cause: RecordError,
    },
    /// A line of the file is wrong.
    #[error("{file}: {cause}")]
    Text {
        /// Name of the file.
        file: String,
        /// The line, and what would be valid.
        #[source]
        cause: TextError,
    },
    /// A state or a checkpoint is damaged, or of another body.
    #[error("{file}: {reason}; give a state or a checkpoint of a powder or of grains")]
    State {
        /// Name of the file.
        file: String,
        /// The reason.
        reason: String,
    },
    /// Frames of a run cannot be read.
    #[error(transparent)]
    Frames(#[from] RecordError),
    /// The file has no radii.
    #[error(
        "{file}: line {line}: there are no radii; {cure}, or one radius of all by --columns radius=all:VALUE (key `columns`)"
    )]
    NoRadii {
        /// Name of the file.
        file: String,
        /// Line that names the columns.
        line: usize,
        /// How to add them.
        cure: &'static str,
    },
    /// The box of the file is invalid, or its spheres do not fit the box.
    #[error("{file}: {cause}")]
    Space {
        /// Name of the file.
        file: String,
        /// The reason.
        #[source]
        cause: SpaceError,
    },
    /// Anything else that a file or folder lacks.
    #[error("{file}: {reason}")]
    Content {
        /// Name of the file or folder.
        file: String,
        /// What is wrong, and what would be valid.
        reason: String,
    },
}
