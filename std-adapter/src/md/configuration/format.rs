//! Which file it is.

use super::Configuration;
use crate::md::text::TextError;
use crate::md::{extended_xyz, lammps};

/// A kind of file with atoms.
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
    /// Told by the first lines: a dump begins with `ITEM:`, extended XYZ with a number alone and a
    /// line of `key=value`; all else is a data file.
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

/// The atoms of a file in any of the formats; the last frame where there are many.
pub fn read(text: &str) -> Result<Configuration, TextError> {
    match Format::of(text) {
        Format::Data => lammps::read_data(text),
        Format::Dump => lammps::last_frame(text),
        Format::ExtendedXyz => extended_xyz::last_frame(text),
    }
}
