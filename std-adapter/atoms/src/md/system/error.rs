//! Errors of a system of atoms.

use crate::md::atoms::AtomsError;
use crate::md::neighbours::ListError;

/// A system that cannot be set up, or that blew up.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::md::pair::{LennardJones, Pairing, Shift};
/// # use tribos::md::{atoms::Atoms, group::Group};
/// # use tribos::space::PeriodicBox;
/// use tribos::md::system::{Integrator, Setup, System, SystemError};
/// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
/// # let interaction = LennardJones::single(unit, Shift::None)?;
/// # let setup = |distance: f64, time_step: f64| Setup {
/// #     atoms: Atoms::at(vec![Vector3::zeros(), Vector3::x() * distance]),
/// #     space: PeriodicBox::OPEN,
/// #     interaction: interaction.clone(),
/// #     skin: 0.3,
/// #     groups: vec![Group::default()],
/// #     group_of: vec![0; 2],
/// #     drive: None,
/// #     integrator: Integrator::VelocityVerlet,
/// #     time_step,
/// #     seed: 1,
/// # };
/// // Two atoms a tenth of σ apart would be thrown out in the first step.
/// let overlapping = System::new(setup(0.1, 0.005)).err();
/// assert_eq!(overlapping, Some(SystemError::Overlap { pair: [0, 1], distance: 0.1 }));
/// let backwards = System::new(setup(1.1, -0.005)).err();
/// assert_eq!(backwards, Some(SystemError::TimeStep { given: -0.005 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// The atoms are invalid.
    #[error(transparent)]
    Atoms(#[from] AtomsError),
    /// The box does not fit the cut-off.
    #[error(transparent)]
    List(#[from] ListError),
    /// The atoms have a species that the interaction lacks.
    #[error("the interaction knows {known} species, not {given}: the others need parameters")]
    Species {
        /// Number of species of the interaction.
        known: usize,
        /// Number of species of the atoms.
        given: usize,
    },
    /// The time step is not positive and finite.
    #[error("the time step must be finite and positive, not {given}")]
    TimeStep {
        /// The rejected value.
        given: f64,
    },
    /// An atom has no group, or one that does not exist.
    #[error("atom {atom} is in no group: groups are numbered from 0 to {last}")]
    Group {
        /// Index of the atom, from 0.
        atom: usize,
        /// Number of the last group.
        last: usize,
    },
    /// Two atoms are so close that their force throws them out of each other's range in one step.
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
        /// Distance that the atom moved.
        way: f64,
    },
}
