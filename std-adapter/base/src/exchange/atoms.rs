//! Atoms, with one array per property.

use nalgebra::Vector3;

/// Largest number of species in a table of pairs.
#[doc(hidden)]
pub const MOST_SPECIES: usize = 64;

/// Atoms of one or more species in consistent units; in reduced units σ, ε and m are 1.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::atoms::{Atoms, AtomsError, MOST_SPECIES};
/// // Carbon monoxide, 1.128 Å long, with masses in g/mol.
/// let mut atoms = Atoms::at(vec![Vector3::zeros(), Vector3::new(1.128, 0.0, 0.0)]);
/// assert!(atoms.len() == 2 && !atoms.is_empty());
/// atoms.masses = vec![12.011, 15.999];
/// atoms.species = vec![0, 1];
/// assert_eq!([atoms.mass(0), atoms.mass(1)], [12.011, 15.999]);
/// atoms.check()?;
/// atoms.masses.truncate(1); // oxygen is left without a mass
/// let refused = AtomsError::Species { atom: 1, species: 2, known: 1 };
/// assert_eq!(atoms.check(), Err(refused));
/// let given = MOST_SPECIES + 1;
/// atoms.masses = vec![1.0; given];
/// assert_eq!(atoms.check(), Err(AtomsError::TooManySpecies { given }));
/// # Ok::<(), AtomsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Atoms {
    /// Positions, not wrapped along periodic axes, so that they show the distance travelled.
    pub positions: Vec<Vector3<f64>>,
    /// Velocities.
    pub velocities: Vec<Vector3<f64>>,
    /// Species of each atom, from 0.
    pub species: Vec<u8>,
    /// Mass of each species.
    pub masses: Vec<f64>,
}

/// Why atoms are invalid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum AtomsError {
    /// The arrays have different lengths.
    #[error(
        "{positions} positions need as many velocities and species, not {velocities} and {species}"
    )]
    Lengths {
        /// Number of positions.
        positions: usize,
        /// Number of velocities.
        velocities: usize,
        /// Number of species entries.
        species: usize,
    },
    /// A coordinate or a velocity is not finite.
    #[error("atom {atom}: its position and velocity must be finite")]
    NotFinite {
        /// Index of the atom, from 0.
        atom: usize,
    },
    /// An atom of a species that has no mass.
    #[error("atom {atom} is of species {species}, but only {known} have a mass")]
    Species {
        /// Index of the atom, from 0.
        atom: usize,
        /// Species of the atom, from 1.
        species: usize,
        /// Number of species with a mass.
        known: usize,
    },
    /// Too many species.
    #[error("{given} species are more than the {MOST_SPECIES} that pairs can number")]
    TooManySpecies {
        /// Number of species.
        given: usize,
    },
    /// A mass is not positive and finite.
    #[error("species {species}: its mass must be finite and positive, not {given}")]
    Mass {
        /// Species with the invalid mass, from 1.
        species: usize,
        /// The rejected value.
        given: f64,
    },
}

impl Atoms {
    /// Atoms at rest, all of one species of mass 1.
    pub fn at(positions: Vec<Vector3<f64>>) -> Self {
        let count = positions.len();
        Self {
            positions,
            velocities: vec![Vector3::zeros(); count],
            species: vec![0; count],
            masses: vec![1.0],
        }
    }

    /// Number of atoms.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are no atoms.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Mass of an atom.
    #[inline]
    pub fn mass(&self, atom: usize) -> f64 {
        self.masses[usize::from(self.species[atom])]
    }

    /// Refuses arrays of different lengths, numbers that are not finite and species without a mass.
    pub fn check(&self) -> Result<(), AtomsError> {
        let count = self.len();
        if self.velocities.len() != count || self.species.len() != count {
            return Err(AtomsError::Lengths {
                positions: count,
                velocities: self.velocities.len(),
                species: self.species.len(),
            });
        }
        let known = self.masses.len();
        if known > MOST_SPECIES {
            return Err(AtomsError::TooManySpecies { given: known });
        }
        for (index, &given) in self.masses.iter().enumerate() {
            if !given.is_finite() || given <= 0.0 {
                let species = index + 1;
                return Err(AtomsError::Mass { species, given });
            }
        }
        for atom in 0..count {
            let numbers = self.positions[atom].iter().chain(&self.velocities[atom]);
            if !numbers.into_iter().all(|number| number.is_finite()) {
                return Err(AtomsError::NotFinite { atom });
            }
            let species = usize::from(self.species[atom]) + 1;
            if species > known {
                return Err(AtomsError::Species {
                    atom,
                    species,
                    known,
                });
            }
        }
        Ok(())
    }
}
