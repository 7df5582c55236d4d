//! The elements of a potential file.

use super::PotentialFile;

/// An element of a potential file.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Its name; a `funcfl` file has none.
    pub name: Option<String>,
    /// Atomic number.
    pub number: u64,
    /// Mass; in files for LAMMPS' metal units in g/mol.
    pub mass: f64,
}

/// A species that the file does not contain.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ElementError {
    /// No such name.
    #[error("there is no element `{name}` in the potential file, which has {}", known.join(", "))]
    Name {
        /// The name.
        name: String,
        /// Those in the file.
        known: Vec<String>,
    },
    /// No such number.
    #[error("there is no element number {number} in the potential file, which has {known}")]
    Number {
        /// Number of the element, from 1.
        number: usize,
        /// Number of elements in the file.
        known: usize,
    },
}

impl PotentialFile {
    /// The element of the file, from 0, of each species: by name if the species and the file have
    /// names, else in order.
    pub fn elements_of(
        &self,
        names: Option<&[String]>,
        species: usize,
    ) -> Result<Vec<usize>, ElementError> {
        let own: Option<Vec<String>> = self.elements.iter().map(|e| e.name.clone()).collect();
        let (Some(names), Some(own)) = (names, own) else {
            let known = self.elements.len();
            let number = known + 1;
            return if species > known {
                Err(ElementError::Number { number, known })
            } else {
                Ok((0..species).collect())
            };
        };
        let find = |name: &String| {
            let at = own.iter().position(|element| element == name);
            at.ok_or_else(|| ElementError::Name {
                name: name.clone(),
                known: own.clone(),
            })
        };
        names.iter().map(find).collect()
    }
}
