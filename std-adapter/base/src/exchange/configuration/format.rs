//! Detection of file formats.

use super::Configuration;
use crate::exchange::text::TextError;
use crate::exchange::{extended_xyz, lammps};

/// A file format for atoms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// LAMMPS data file.
    Data,
    /// LAMMPS text dump.
    Dump,
    /// Extended XYZ.
    ExtendedXyz,
}

impl Format {
    /// Detects the format from the first lines: a dump begins with `ITEM:`, extended XYZ with a
    /// number alone and a line of `key=value`; anything else is a data file.
    pub fn of(text: &str) -> Self {
        let mut lines = text.lines();
        let first = lines.next().unwrap_or_default().trim();
        let second = lines.next().unwrap_or_default();
        if first.starts_with("ITEM:") {
            Self::Dump
        } else if first.parse::<u64>().is_ok() && second.contains('=') {
            Self::ExtendedXyz
        } else {
            Self::Data
        }
    }
}

/// Lines of a data file that are searched for its head.
const HEAD: usize = 200;

/// Whether a text has lines that only the head of a data file of LAMMPS has.
pub fn is_lammps_data(text: &str) -> bool {
    text.lines().take(HEAD).any(|line| {
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().collect();
        matches!(
            words[..],
            [_, "atoms"] | [_, "atom", "types"] | [_, _, "xlo", "xhi"]
        )
    })
}

/// The format of a file that has what each begins with; others are refused, with what was expected.
pub fn recognised(text: &str) -> Result<Format, TextError> {
    let format = Format::of(text);
    if format != Format::Data || text.trim().is_empty() || is_lammps_data(text) {
        return Ok(format);
    }
    let first = text.lines().next().unwrap_or_default().trim();
    let is_plain_xyz = first.parse::<u64>().is_ok();
    Err(TextError::Unsupported {
        line: if is_plain_xyz { 2 } else { 1 },
        what: if is_plain_xyz {
            "plain XYZ without cell and columns".into()
        } else {
            "a file that is none of extended XYZ, LAMMPS data and LAMMPS text dump".into()
        },
        cure: "extended XYZ begins with the number alone and a line of `Lattice=\"…\" Properties=…`, a dump with \
               `ITEM:`, and data have lines `N atoms` and `LOW HIGH xlo xhi` before the sections",
    })
}

/// The atoms of a file in any of the formats; if it has several frames, the last.
///
/// ```
/// use tribos::md::configuration::{Format, read};
/// // A molecule of hydrogen, 0.74 Å long.
/// let text = "2\nProperties=species:S:1:pos:R:3\nH 0 0 0\nH 0 0 0.74\n";
/// assert_eq!(Format::of(text), Format::ExtendedXyz);
/// assert_eq!(Format::of("ITEM: TIMESTEP\n0\n"), Format::Dump);
/// assert_eq!(Format::of("Liquid argon\n\n864 atoms\n"), Format::Data);
/// let hydrogen = read(text)?;
/// assert_eq!(hydrogen.names, Some(vec!["H".into()]));
/// assert_eq!(hydrogen.lengths(), [0.0, 0.0, 0.74]); // the file has no box
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(text: &str) -> Result<Configuration, TextError> {
    match recognised(text)? {
        Format::Data => lammps::read_data(text),
        Format::Dump => lammps::last_frame(text),
        Format::ExtendedXyz => extended_xyz::last_frame(text),
    }
}
