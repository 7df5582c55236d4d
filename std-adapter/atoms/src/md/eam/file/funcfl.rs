//! `funcfl`: a line of comment, the element, the grids, then F, the effective charge Z and ρ.

use super::values::{end, values};
use super::{Element, Grids, PotentialFile, number_and_mass};
use crate::md::text::{Lines, TextError};

/// rφ = 27.2 · 0.529 Z² [eV Å]: a hartree times a bohr, with the digits that the format fixes.
const HARTREE_BOHR: f64 = 27.2 * 0.529;

const CUT_SHORT: &str = "is the file cut short?";

/// Numbers begin the second line, and five fill the third; in `setfl` both are comment.
pub(super) fn is_funcfl(text: &str) -> bool {
    let numbers = |line: Option<&str>| {
        let words = line.unwrap_or_default().split_whitespace();
        words.map_while(|word| word.parse::<f64>().ok()).count()
    };
    let mut lines = text.lines().skip(1);
    numbers(lines.next()) >= 2 && numbers(lines.next()) == 5
}

/// The last knot of each table only sets its length: LAMMPS, and so Tribos, ends one before it. Beyond that
/// density F continues linearly; LAMMPS' energy there, not its forces, is off by the slope times a step.
pub(super) fn read(text: &str) -> Result<PotentialFile, TextError> {
    let mut lines = Lines::new(text);
    lines.need("a line of comment", CUT_SHORT)?;
    let line = lines.need("the line of the element", CUT_SHORT)?;
    let (number, mass) = number_and_mass(line)?;
    let grids = Grids::read(&mut lines)?;
    let mut embedding = values(&mut lines, "the embedding energy", grids.density_knots)?;
    let mut charge = values(&mut lines, "the effective charge", grids.distance_knots)?;
    let mut density = values(&mut lines, "the density", grids.distance_knots)?;
    end(&mut lines)?;
    for table in [&mut embedding, &mut charge, &mut density] {
        table.pop();
    }
    let pair = charge.iter().map(|&z| HARTREE_BOHR * z * z).collect();
    Ok(PotentialFile {
        elements: vec![Element {
            name: None,
            number,
            mass,
        }],
        cutoff: grids.cutoff,
        density_step: grids.density_step,
        distance_step: grids.distance_step,
        embeddings: vec![embedding],
        densities: vec![density],
        pairs: vec![pair],
    })
}
