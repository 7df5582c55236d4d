//! Files of contact problems: HDF5 of FCLib and text of Siconos.

mod error;
mod fclib;
mod siconos;
#[cfg(test)]
mod tests;

pub use error::{Fault, FilePosition};

use super::{ContactComponents, ContactThresholds, GlobalProblem, ProblemError, ReducedProblem};
use std::path::Path;
use tribos_base::record::write_atomically;

/// A contact problem of either kind.
///
/// ```
/// use tribos::problem::{ContactThresholds, ProblemFormat, ContactComponents, SparseMatrix, ContactProblem, ReducedProblem};
/// let w = SparseMatrix::from_triplets([3, 3], &[(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5)])?;
/// let fall = ReducedProblem::new(ContactComponents::Space, w, vec![-3.0, 4.0, 0.0], vec![ContactThresholds::coulomb(0.5)])?;
/// let problem = ContactProblem::from(fall);
/// let home = tempfile::tempdir()?;
/// for (name, format) in [("fall.hdf5", ProblemFormat::FclibHdf5), ("fall.dat", ProblemFormat::SiconosText)] {
///     problem.write(&home.path().join(name), format)?;
///     assert_eq!(ContactProblem::read(&home.path().join(name))?, problem);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ContactProblem {
    /// Between impulses: u = W r + q.
    Reduced(ReducedProblem),
    /// Between bodies: M v = H r + f.
    Global(GlobalProblem),
}

/// Format of a file of a contact problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ProblemFormat {
    /// HDF5 as the library FCLib lays it out.
    ///
    /// Groups `fclib_local` (W, q), `fclib_global` or `fclib_global_rolling` (M, H, f, w). Coefficients are
    /// `vectors/mu` and `vectors/mu_r`. FCLib has neither torsion nor cohesion, and rolling only between bodies:
    /// `fclib_local_rolling`, `vectors/mu_n`, `vectors/cohesion` and `vectors/ellipsoid` (0 or 1 for each contact)
    /// are our extension, written where a layout or a law needs them. Rolling in a plane (FCLib's three components
    /// with rolling) is refused.
    FclibHdf5,
    /// Text as Siconos writes it.
    ///
    /// W is in square blocks, M and H in triplets; numbers have the shortest digits that keep their bits. Entries
    /// of W that are zero are not kept apart from absent ones. There is no place for torsion, cohesion and
    /// ellipsoids.
    SiconosText,
}

impl ContactProblem {
    /// Reads a file; its contents tell the format, not its name.
    ///
    /// Text of Siconos does not say which kind of problem it holds: a file of one matrix is [`Self::Reduced`], one of two
    /// is [`Self::Global`]. Matrices may be dense (stored by columns), in blocks, or as CSparse prints them
    /// (triplets, columns or rows).
    ///
    /// HDF5 must be without compression; solutions and guesses in it are not read, and equality constraints
    /// (`G`, `V`, `R`) are refused.
    ///
    /// # Errors
    /// [`ProblemError`] if the file cannot be read, or is not a contact problem. Memory is bounded by a multiple
    /// of the file's size, whatever sizes it claims.
    pub fn read(path: &Path) -> Result<Self, ProblemError> {
        let parsed = match std::fs::read(path) {
            Ok(bytes) => Self::parse(&bytes),
            Err(cause) => Err((FilePosition::File, Fault::Read(cause))),
        };
        parsed.map_err(|(place, fault)| ProblemError::File {
            path: path.to_path_buf(),
            place,
            fault: fault.into(),
        })
    }

    fn parse(bytes: &[u8]) -> Result<Self, error::LocatedFault> {
        if fclib::is_hdf5(bytes) {
            return fclib::read(bytes);
        }
        match std::str::from_utf8(bytes) {
            Ok(text) => siconos::read(text),
            Err(_) => Err((FilePosition::File, Fault::NeitherFormat)),
        }
    }

    /// Writes a file; it is complete, or an earlier one at `path` is unchanged.
    ///
    /// # Errors
    /// [`ProblemError`] if the format has no place for a law or a layout, or the file cannot be written.
    pub fn write(&self, path: &Path, format: ProblemFormat) -> Result<(), ProblemError> {
        let bytes = match format {
            ProblemFormat::FclibHdf5 => fclib::write(self),
            ProblemFormat::SiconosText => siconos::write(self).map(String::into_bytes),
        };
        let written = bytes.and_then(|bytes| {
            write_atomically(path, &bytes)
                .map_err(|error| (FilePosition::File, Fault::Write(error.into())))
        });
        written.map_err(|(place, fault)| ProblemError::File {
            path: path.to_path_buf(),
            place,
            fault: fault.into(),
        })
    }

    /// The problem between impulses: W = Hᵀ M⁻¹ H where it is between bodies.
    ///
    /// # Errors
    /// [`ProblemError::Singular`] if M has no inverse.
    pub fn reduced(&self) -> Result<ReducedProblem, ProblemError> {
        match self {
            Self::Reduced(problem) => Ok(problem.clone()),
            Self::Global(problem) => problem.reduced(),
        }
    }

    /// Components of each contact.
    #[must_use]
    pub fn layout(&self) -> ContactComponents {
        match self {
            Self::Reduced(problem) => problem.layout(),
            Self::Global(problem) => problem.layout(),
        }
    }

    /// Laws of the contacts.
    #[must_use]
    pub fn laws(&self) -> &[ContactThresholds] {
        match self {
            Self::Reduced(problem) => problem.laws(),
            Self::Global(problem) => problem.laws(),
        }
    }
}

impl From<ReducedProblem> for ContactProblem {
    fn from(problem: ReducedProblem) -> Self {
        Self::Reduced(problem)
    }
}

impl From<GlobalProblem> for ContactProblem {
    fn from(problem: GlobalProblem) -> Self {
        Self::Global(problem)
    }
}
