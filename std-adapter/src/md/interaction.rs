//! What acts between atoms.

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

/// What a force calculation sums up besides forces. A run asks for sums only where it records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Nothing: [`Tally`] is all NaN.
    Forces,
    /// Energy and virial.
    Sums,
}

/// An interaction of atoms that ends at a cut-off.
pub trait Interaction: Sync {
    /// The farthest that two atoms act on each other.
    fn cutoff(&self) -> f64;

    /// Number of species it knows.
    fn species(&self) -> usize;

    /// Puts the force on every atom into `forces`, with `list` up to date.
    fn forces(&self, list: &mut VerletList, forces: &mut [Vector3<f64>], wanted: Wanted) -> Tally;
}

impl<I: Interaction + ?Sized> Interaction for Box<I> {
    fn cutoff(&self) -> f64 {
        (**self).cutoff()
    }

    fn species(&self) -> usize {
        (**self).species()
    }

    fn forces(&self, list: &mut VerletList, forces: &mut [Vector3<f64>], wanted: Wanted) -> Tally {
        (**self).forces(list, forces, wanted)
    }
}

/// Forces and sums for atoms as they are: the list is brought up to date first.
pub fn evaluate(
    interaction: &(impl Interaction + ?Sized),
    list: &mut VerletList,
    atoms: &Atoms,
    forces: &mut Vec<Vector3<f64>>,
    wanted: Wanted,
) -> Result<Tally, ListError> {
    list.update(&atoms.positions, &atoms.species)?;
    forces.clear();
    forces.resize(atoms.len(), Vector3::zeros());
    Ok(interaction.forces(list, forces, wanted))
}
