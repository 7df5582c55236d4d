//! The law between the atoms.

use std::path::Path;
use tribos::md::eam::Tabulated;
use tribos::md::eam::file::{ElementError, PotentialFile};
use tribos::md::interaction::Interaction;
use tribos::md::pair::LennardJones;
use tribos::md::text::TextError;

/// A law with what to call it.
pub struct Potential {
    law: Box<dyn Interaction>,
    description: String,
}

/// A potential file that cannot serve.
#[derive(Debug, thiserror::Error)]
pub enum PotentialError {
    /// It cannot be read.
    #[error(transparent)]
    Text(#[from] TextError),
    /// It has other elements.
    #[error(transparent)]
    Element(#[from] ElementError),
}

impl Potential {
    /// Lennard-Jones.
    pub fn pair(law: LennardJones, text: &str) -> Self {
        Self {
            law: Box::new(law),
            description: text.into(),
        }
    }

    /// Embedded atoms, and the mass of each species.
    pub fn embedded(
        text: &str,
        path: &Path,
        names: Option<&[String]>,
        species: usize,
    ) -> Result<(Self, Vec<f64>), PotentialError> {
        let file = PotentialFile::read(text)?;
        let elements = file.elements_of(names, species)?;
        let law = Tabulated::new(&file, &elements)?;
        let mass = |&element: &usize| file.elements[element].mass;
        let potential = Self {
            law: Box::new(law),
            description: format!("eam:{}", path.display()),
        };
        Ok((potential, elements.iter().map(mass).collect()))
    }

    pub fn law(&self) -> &dyn Interaction {
        self.law.as_ref()
    }

    pub fn description(&self) -> &str {
        &self.description
    }
}
