//! Units of what is read and written.

/// A set of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Units {
    /// Reduced, or any consistent set.
    Lj,
    /// eV, angstrom, picosecond, g/mol; pressure in bar.
    Metal,
}

impl Units {
    /// As `--units` takes it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lj => "lj",
            Self::Metal => "metal",
        }
    }

    /// Energy of a unit of mass times speed squared; LAMMPS' number, so that pressures agree.
    pub fn energy_of_motion(self) -> f64 {
        match self {
            Self::Lj => 1.0,
            Self::Metal => 1.0364269e-4,
        }
    }

    /// Pressure of a unit of energy in a unit of volume; LAMMPS' number, 8e-8 below that of the SI.
    pub fn pressure_of_energy(self) -> f64 {
        match self {
            Self::Lj => 1.0,
            Self::Metal => 1.6021765e6,
        }
    }
}
