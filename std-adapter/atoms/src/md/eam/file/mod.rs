//! Files of embedded-atom potentials in the formats of DYNAMO: `setfl` (`*.eam.alloy`) and `funcfl`
//! (`*.eam`), as LAMMPS reads them.

mod elements;
mod funcfl;
mod setfl;
mod values;

pub use elements::{Element, ElementError};

use super::spline::FEWEST_KNOTS;
use crate::md::text::{Line, Lines, TextError};

/// Tables of a potential, at knots from 0 on.
///
/// ```
/// use tribos::md::eam::file::{Element, ElementError, PotentialFile};
/// // As `setfl`: six knots a table, all 0. Comment, names, grids, then F and ρ of each element.
/// let zero = "0 0 0 0 0 0\n";
/// let head = "comment\n\n\n2 Cu Ni\n6 0.5 6 1.0 4.5\n";
/// let copper = format!("29 63.546 3.615 fcc\n{zero}{zero}");
/// let nickel = format!("28 58.693 3.524 fcc\n{zero}{zero}");
/// let file = PotentialFile::read(&format!("{head}{copper}{nickel}{zero}{zero}{zero}"))?;
/// assert_eq!(file.pairs.len(), 3); // of Cu and Cu, Ni and Cu, Ni and Ni
/// // A configuration that names nickel first.
/// let names = ["Ni", "Cu"].map(String::from);
/// assert_eq!(file.elements_of(Some(&names), 2), Ok(vec![1, 0]));
/// let first: &Element = &file.elements[1];
/// assert_eq!((first.number, first.mass), (28, 58.693));
/// // Without names the third species is a third element, which is not there.
/// let refused = file.elements_of(None, 3);
/// assert_eq!(refused, Err(ElementError::Number { number: 3, known: 2 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PotentialFile {
    /// The elements.
    pub elements: Vec<Element>,
    /// Cut-off of densities and pair energies.
    pub cutoff: f64,
    /// Distance between knots of F, a density.
    pub density_step: f64,
    /// Distance between knots of ρ and rφ.
    pub distance_step: f64,
    /// F of each element.
    pub embeddings: Vec<Vec<f64>>,
    /// ρ of each element.
    pub densities: Vec<Vec<f64>>,
    /// rφ of the pairs (1, 1), (2, 1), (2, 2), (3, 1), …
    pub pairs: Vec<Vec<f64>>,
}

impl PotentialFile {
    /// Reads either format, recognised by the numbers in the second and third line.
    pub fn read(text: &str) -> Result<Self, TextError> {
        if funcfl::is_funcfl(text) {
            funcfl::read(text)
        } else {
            setfl::read(text)
        }
    }

    /// rφ of two elements, from 0 and both in the file.
    pub(super) fn pair(&self, a: usize, b: usize) -> &[f64] {
        let (more, less) = (a.max(b), a.min(b));
        &self.pairs[more * (more + 1) / 2 + less]
    }
}

/// Largest number of knots of a table; published files have some ten thousand.
const MOST_KNOTS: u64 = 10_000_000;

/// The line `nrho drho nr dr cutoff`.
#[derive(Clone, Copy, Debug)]
struct Grids {
    density_knots: usize,
    density_step: f64,
    distance_knots: usize,
    distance_step: f64,
    cutoff: f64,
}

impl Grids {
    fn read(lines: &mut Lines) -> Result<Self, TextError> {
        const WHAT: &str = "the line `nrho drho nr dr cutoff`";
        let line = lines.need(WHAT, "is the file cut short?")?;
        let words = line.words();
        let &[nrho, drho, nr, dr, cutoff] = words.as_slice() else {
            return Err(line.invalid(WHAT, "five numbers", line.text.trim()));
        };
        let knots = FEWEST_KNOTS as u64 + 1..=MOST_KNOTS;
        Ok(Self {
            density_knots: line.whole("nrho", knots.clone(), nrho)? as usize,
            density_step: line.positive("drho", drho)?,
            distance_knots: line.whole("nr", knots, nr)? as usize,
            distance_step: line.positive("dr", dr)?,
            cutoff: line.positive("the cut-off", cutoff)?,
        })
    }
}

/// The line `atomic-number mass lattice-constant structure`, of which the first two matter.
fn number_and_mass(line: Line) -> Result<(u64, f64), TextError> {
    const WHAT: &str = "the line `atomic-number mass lattice-constant structure`";
    let words = line.words();
    let &[number, mass, ..] = words.as_slice() else {
        return Err(line.invalid(WHAT, "at least two numbers", line.text.trim()));
    };
    let number = line.whole("the atomic number", 0..=999, number)?;
    Ok((number, line.positive("the mass", mass)?))
}

#[cfg(test)]
mod tests;
