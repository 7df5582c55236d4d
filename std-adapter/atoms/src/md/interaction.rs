//! Interactions of atoms.

use super::atoms::Atoms;
use super::neighbours::{ListError, VerletList};
use nalgebra::{Matrix3, Vector3};

/// Sums over all pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Potential energy.
    pub energy: f64,
    /// Σ r ⊗ F over pairs, an energy: its trace over 3V is the pressure of the interaction.
    pub virial: Matrix3<f64>,
}

/// What a force calculation sums besides forces. A run requests sums only when it records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// Nothing: [`Tally`] is all NaN.
    Forces,
    /// Energy and virial.
    Sums,
}

/// An interaction of atoms with a cut-off.
pub trait Interaction: Sync {
    /// Largest distance at which two atoms interact.
    fn cutoff(&self) -> f64;

    /// Number of species of the interaction.
    fn species(&self) -> usize;

    /// Writes the force on every atom to `forces`; `list` must be up to date.
    fn forces(
        &self,
        list: &mut VerletList,
        forces: &mut [Vector3<f64>],
        wanted: Evaluation,
    ) -> Tally;
}

impl<I: Interaction + ?Sized> Interaction for Box<I> {
    fn cutoff(&self) -> f64 {
        (**self).cutoff()
    }

    fn species(&self) -> usize {
        (**self).species()
    }

    fn forces(
        &self,
        list: &mut VerletList,
        forces: &mut [Vector3<f64>],
        wanted: Evaluation,
    ) -> Tally {
        (**self).forces(list, forces, wanted)
    }
}

/// Forces and sums for the current positions: the list is updated first.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::interaction::{Interaction, Tally, Evaluation, evaluate};
/// use tribos::md::pair::{LennardJones, Pairing, Shift};
/// use tribos::md::{atoms::Atoms, neighbours::VerletList};
/// use tribos::space::PeriodicBox;
/// let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
/// let potential = LennardJones::single(unit, Shift::None)?;
/// let mut list = VerletList::new(PeriodicBox::OPEN, potential.cutoff(), 0.3)?;
/// // Two atoms σ apart: U = 0 and −U' = 24 ε/σ, so that Σ r · F = 24 ε.
/// let pair = Atoms::at(vec![Vector3::zeros(), Vector3::x()]);
/// let mut forces = Vec::new();
/// let sums: Tally = evaluate(&potential, &mut list, &pair, &mut forces, Evaluation::Sums)?;
/// assert!(sums.energy.abs() < 1e-14 && (sums.virial.trace() - 24.0).abs() < 1e-13);
/// assert!((forces[1].x - 24.0).abs() < 1e-13);
/// assert_eq!(forces[0], -forces[1]); // action and reaction
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn evaluate(
    interaction: &(impl Interaction + ?Sized),
    list: &mut VerletList,
    atoms: &Atoms,
    forces: &mut Vec<Vector3<f64>>,
    wanted: Evaluation,
) -> Result<Tally, ListError> {
    list.update(&atoms.positions, &atoms.species)?;
    forces.resize(atoms.len(), Vector3::zeros());
    Ok(interaction.forces(list, forces, wanted))
}
