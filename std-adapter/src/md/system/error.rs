//! Why a system cannot be set up or go on.

use crate::md::atoms::AtomsError;
use crate::md::neighbours::ListError;

/// A system that cannot be set up, or that blew up.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// Atoms that make no sense.
    #[error(transparent)]
    Atoms(#[from] AtomsError),
    /// The box does not fit the cut-off.
    #[error(transparent)]
    List(#[from] ListError),
    /// Atoms of a species that the interaction does not know.
    #[error("the interaction knows {known} species, not {given}: the others need parameters")]
    Species {
        /// Species that it knows.
        known: usize,
        /// Species of the atoms.
        given: usize,
    },
    /// The time step is no time.
    #[error("the time step must be finite and positive, not {given}")]
    TimeStep {
        /// What was given.
        given: f64,
    },
    /// Every atom needs a group that there is.
    #[error("atom {atom} is in no group: groups are numbered from 0 to {last}")]
    Group {
        /// Index of the atom, from 0.
        atom: usize,
        /// Number of the last group.
        last: usize,
    },
    /// Two atoms so near that their force throws them out of each other's reach in one step.
    #[error("atoms {} and {} overlap: they are {distance:.3e} apart", pair[0], pair[1])]
    Overlap {
        /// Indices of the atoms, from 0.
        pair: [usize; 2],
        /// Their distance.
        distance: f64,
    },
    /// An atom moved farther in one step than half the cut-off.
    #[error(
        "step {step}: atom {atom} moved by {way:.3e}, more than half the cut-off: \
         the run blew up; a smaller time step or a better start is needed"
    )]
    BlownUp {
        /// The step, from 1.
        step: u64,
        /// Index of the atom, from 0.
        atom: usize,
        /// How far it moved.
        way: f64,
    },
}
