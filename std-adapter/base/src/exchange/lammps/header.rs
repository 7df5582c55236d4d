//! The head of a data file: counts and the box.

use super::bounds::{bounds, tilted};
use crate::exchange::atoms::MOST_SPECIES;
use crate::exchange::text::{Line, Lines, TextError};

/// The part of the file before the first section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    pub atoms: usize,
    pub species: usize,
    pub bounds: [[f64; 2]; 3],
    /// Tilt xz.
    pub tilt: f64,
}

/// The name of a section, if the line begins one: all other lines begin with a number.
pub(super) fn section(line: Line<'_>) -> Option<&str> {
    let text = line.without_comment().text;
    let is_named = text.starts_with(|c: char| c.is_ascii_alphabetic());
    is_named.then_some(text)
}

impl Header {
    pub fn read(lines: &mut Lines) -> Result<Self, TextError> {
        lines.need("a line of title", "is the file empty?")?;
        let (mut atoms, mut species) = (None, None);
        let mut ends = [None; 3];
        let mut tilt = 0.0;
        lines.skip_blank();
        while let Some(line) = lines.peek()
            && section(line).is_none()
        {
            let line = line.without_comment();
            match line.words().as_slice() {
                [n, "atoms"] => {
                    let most = u64::from(u32::MAX);
                    atoms = Some(line.whole("the number of atoms", 0..=most, n)? as usize);
                }
                [n, "atom", "types"] => {
                    let range = 1..=MOST_SPECIES as u64;
                    species = Some(line.whole("the number of atom types", range, n)? as usize);
                }
                [low, high, "xlo", "xhi"] => ends[0] = Some(bounds(line, low, high)?),
                [low, high, "ylo", "yhi"] => ends[1] = Some(bounds(line, low, high)?),
                [low, high, "zlo", "zhi"] => ends[2] = Some(bounds(line, low, high)?),
                [xy, xz, yz, "xy", "xz", "yz"] => {
                    for word in [xy, yz] {
                        if line.number("a tilt factor", word)? != 0.0 {
                            return Err(tilted(line));
                        }
                    }
                    tilt = line.number("a tilt factor", xz)?;
                }
                // A count of zero of other items is the same as no count.
                ["0", ..] => {}
                _ => return Err(unknown(line)),
            }
            lines.next();
            lines.skip_blank();
        }
        let end = lines.here();
        let line_of = |what: &str| format!("give the line `{what}` before the sections");
        let axis = |axis: usize| {
            let [x, y, z] = ["xlo xhi", "ylo yhi", "zlo zhi"];
            let words = line_of(&format!("LOW HIGH {}", [x, y, z][axis]));
            ends[axis].ok_or_else(|| end.missing("a length of the box", words))
        };
        Ok(Self {
            atoms: atoms.ok_or_else(|| end.missing("the number of atoms", line_of("N atoms")))?,
            species: species
                .ok_or_else(|| end.missing("the number of types", line_of("N atom types")))?,
            bounds: [axis(0)?, axis(1)?, axis(2)?],
            tilt,
        })
    }
}

fn unknown(line: Line) -> TextError {
    TextError::Unsupported {
        line: line.number,
        what: format!("`{}` in the head of a data file", line.text),
        cure: "known are `N atoms`, `N atom types`, `LOW HIGH xlo xhi` and so on; atom_style atomic only",
    }
}
