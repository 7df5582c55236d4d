//! `tribos packing`: what a file of spheres is taken for, and the same spheres in another format.

use super::digits::shown;
use super::number;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::measure::{Assembly, PackingColumns, PackingFormat};
use tribos::record::write_atomically;

/// Say what is understood of a file of spheres, of any program, and write it in another format.
///
/// Reads, by content and packed by gzip or not: extended and plain XYZ; tables between blanks, commas or semicolons, as x y z
/// radius or with named columns (YADE, Lethe, ParaView); data and dumps of LAMMPS and LIGGGHTS; VTK .vtp, .vtu and .vtk, as
/// text or binary, appended or packed by zlib; .data and .restart of MercuryDPM; .geo of ESyS-Particle; .mdpa of Kratos;
/// texts of MUSEN; the folder, the state or a checkpoint of a run. Of several states the last.
///
/// The same reader serves `initial_state` of scenes, `tribos measure` and Python.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(flatten)]
    source: SpheresSource,
    /// File for the spheres, replaced if it is there: .xyz (extended XYZ), .vtp (VTK), .data (LAMMPS), .csv, .txt (table of
    /// x y z radius and more). All numbers keep their bits; what the format cannot hold is said.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Spheres that a command reads, and what the user says of their file.
#[derive(Debug, clap::Args)]
pub struct SpheresSource {
    /// The folder of a run, or a file of spheres.
    #[arg(value_name = "RUN|FILE")]
    pub path: PathBuf,
    /// What the columns of a table, or the arrays of a file of VTK, are where the file does not say it: x, y, z, radius, diameter,
    /// density, mass, type, vx, vy, vz, wx, wy, wz in their order, - for one that is not read; or NAME=COLUMN, by heading or
    /// number; or NAME=all:VALUE, one value for all spheres.
    #[arg(long, value_name = "COLUMNS", value_parser = str::parse::<PackingColumns>, allow_hyphen_values = true)]
    columns: Option<PackingColumns>,
    /// Periods along x, y and z, with - for an open axis, where the file does not say them.
    #[arg(long, value_name = "X,Y,Z", value_parser = periods)]
    periods: Option<Periods>,
}

impl SpheresSource {
    /// The last state.
    pub fn read(&self) -> Result<Assembly, Failure> {
        self.periodic(Assembly::read_as(&self.path, self.columns.as_ref())?)
    }

    /// All states with their steps.
    pub fn read_all(&self) -> Result<(Vec<u64>, Vec<Assembly>), Failure> {
        let all = Assembly::read_all_as(&self.path, self.columns.as_ref())?;
        let periodic = |(step, state)| Ok((step, self.periodic(state)?));
        all.into_iter().map(periodic).collect()
    }

    fn periodic(&self, state: Assembly) -> Result<Assembly, Failure> {
        match self.periods {
            Some(Periods(periods)) => {
                Ok(state.with_periods(&self.path.display().to_string(), periods)?)
            }
            None => Ok(state),
        }
    }
}

/// Periods of the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Periods([Option<f64>; 3]);

/// Three lengths, each a number > 0 or `-`.
fn periods(text: &str) -> Result<Periods, String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let &[x, y, z] = parts.as_slice() else {
        return Err("give three periods, such as 20,20,-".into());
    };
    let period = |part: &str| match part {
        "-" => Ok(None),
        length => number::positive(length).map(Some),
    };
    Ok(Periods([period(x)?, period(y)?, period(z)?]))
}

const EXAMPLES: &str = "\
Examples:
  A deposit as data of LAMMPS:
    tribos deposit --cut 20 --out out/deposit
    tribos packing out/deposit/deposit.xyz --out out/deposit.data
  Centres of equal spheres behind the names of elements:
    tribos packing plain.xyz --columns radius=all:0.5
  A table with headings of its own:
    tribos packing grains.csv --columns radius=R_eq,density=all:2650 --out out/grains.vtp";

impl Arguments {
    /// Reads, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let packing = self.source.read()?;
        let mut text = String::new();
        for (name, what) in packing.about(&shown) {
            text += &format!("{name:<14} {what}\n");
        }
        if let Some(out) = &self.out {
            text += &self.write(&packing, out)?;
        }
        super::print(&text)
    }

    /// Writes the spheres; the lines that say so.
    fn write(&self, packing: &Assembly, out: &Path) -> Result<String, Failure> {
        super::file::refuse_input("--out", out, &self.source.path)?;
        let format = PackingFormat::written_as(out).ok_or_else(|| {
            Failure::input(format!(
                "--out {}: the ending says the format; give .xyz, .vtp, .data, .csv or .txt",
                out.display()
            ))
        })?;
        let written = packing.written(format).map_err(Failure::input)?;
        let written = written.unwrap_or_default();
        write_atomically(out, written.text.as_bytes())?;
        let mut text = format!(
            "{:<14} {}, {}\n",
            "written to",
            out.display(),
            format.name()
        );
        for lost in written.lost {
            text += &format!("{:<14} {lost}\n", "not in it");
        }
        Ok(text)
    }
}
