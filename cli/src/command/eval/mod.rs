//! `tribos eval`: forces, energy and pressure of atoms as they are.

mod boundary;
mod output;
mod overlap;
mod pair;
mod potential;
mod units;

use crate::failure::Failure;
use boundary::Boundary;
use pair::PairSpec;
use potential::Potential;
use std::path::{Path, PathBuf};
use tribos::md::configuration::{self, Configuration};
use tribos::md::interaction::{Evaluation, Tally, evaluate};
use tribos::md::neighbours::VerletList;
use tribos::record::{read_text, write_atomically};
use tribos::run::folder::{Contents, OutputFolder};
use units::Units;

/// Bytes of a file of atoms or of a potential at most.
const MOST_BYTES: u64 = 4 << 30;

/// Forces, energy, virial and pressure of the atoms in a file.
#[derive(Debug, clap::Args)]
#[command(after_long_help = MORE)]
#[command(group(clap::ArgGroup::new("law").required(true).args(["pair", "eam"])))]
pub struct Arguments {
    /// Atoms: a LAMMPS data file (atom_style atomic), a LAMMPS text dump or extended XYZ, recognized
    /// by its contents. The last of several frames is used. Boxes must be orthogonal.
    config: PathBuf,
    /// Lennard-Jones: lj:cutoff=R[,shift=none|energy|force][,mixing=geometric|arithmetic|sixthpower]
    /// and for species 1, 2 … [,epsilon11=E][,sigma11=S][,cutoff12=R]; epsilon10-2 from ten species on.
    ///
    /// Epsilon and sigma of like pairs are 1 where not given, those of unlike pairs mixed; cut-offs not
    /// given are `cutoff`.
    #[arg(long, value_name = "LAW")]
    pair: Option<PairSpec>,
    /// Embedded atoms from a DYNAMO file: setfl (*.eam.alloy) or funcfl (*.eam), recognized by its
    /// contents.
    ///
    /// Species with names are the elements of that name, numbered ones the first, second … of the file.
    #[arg(long, value_name = "FILE")]
    eam: Option<PathBuf>,
    /// Periodic (p) or open (f) along x, y, z [default: as in the file; p,p,p for data files].
    #[arg(long, value_name = "X,Y,Z")]
    boundary: Option<Boundary>,
    /// Units [default: lj, or metal with --eam].
    #[arg(long)]
    units: Option<Units>,
    /// Folder for the results, created if missing; files of an earlier command in it are removed
    /// first. The folder of a powder, a tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const MORE: &str = "\
Writes forces.csv, with the columns id,fx,fy,fz and the ids ascending, and summary.json with
  energy           potential energy
  kinetic_energy   of the velocities in the file, 0 without; masses are those of the data file or of
                   the EAM file, else 1
  virial           xx, yy, zz, xy, xz, yz of the sum of r (x) F over pairs, an energy
  virial_trace     xx + yy + zz
  pressure         (2 kinetic_energy + virial_trace)/(3 volume), which is LAMMPS' `press`
  pressure_tensor  its xx, yy, zz, xy, xz, yz
  volume           of the box in the file, open axes from end to end

Units: lj is any consistent set with k_B = 1; metal is eV, angstrom, ps, g/mol and bar, converted with
the numbers of LAMMPS (1 eV/A^3 = 1.6021765e6 bar, 1 g/mol A^2/ps^2 = 1.0364269e-4 eV).

Examples:
  A LAMMPS data file, truncated at 2.5 sigma:
    tribos eval melt.data --pair lj:cutoff=2.5 --out out/melt
  A slab, open along z, energy and force shifted to end at 0:
    tribos eval slab.data --pair lj:cutoff=2.5,shift=force --boundary p,p,f --out out/slab
  The mixture of Kob and Andersen:
    tribos eval glass.data --out out/glass \\
      --pair lj:cutoff=2.5,shift=energy,epsilon12=1.5,sigma12=0.8,cutoff12=2,epsilon22=0.5,sigma22=0.88,cutoff22=2.2
  Copper from extended XYZ with an embedded-atom potential, in eV, angstrom and bar:
    tribos eval copper.xyz --eam Cu_mishin1.eam.alloy --out out/copper";

/// The skin of a list that is used once, in cut-offs: it costs pairs and is never needed.
const SKIN: f64 = 1e-3;

impl Arguments {
    /// Evaluates and writes.
    pub fn execute(self) -> Result<(), Failure> {
        let mut atoms = configuration::read(&text(&self.config)?)
            .map_err(|error| in_file(&self.config, error))?;
        if let Some(boundary) = &self.boundary {
            if !atoms.has_box && boundary.is_periodic.contains(&true) {
                return Err(in_file(
                    &self.config,
                    "a periodic axis needs its length: give Lattice in the second line",
                ));
            }
            atoms.is_periodic = boundary.is_periodic;
        }
        let (potential, units) = self.potential(&mut atoms)?;
        let (forces, tally) = forces(&atoms, &potential)?;
        let csv = output::forces_csv(&atoms.ids, &forces);
        let summary = output::Summary::new(&atoms, &tally, units);
        let json = format!("{:#}\n", summary.json(&potential, units));
        let contents = Contents::of("eval", &["forces.csv", "summary.json"]);
        let _folder = OutputFolder::begin(&self.out, &contents)?;
        write_atomically(&self.out.join("forces.csv"), csv.as_bytes())?;
        // Last: a summary stands only beside complete results.
        write_atomically(&self.out.join("summary.json"), json.as_bytes())?;
        super::print(&summary.text(units, &self.out))
    }

    /// The law asked for; that of embedded atoms knows masses.
    fn potential(&self, atoms: &mut Configuration) -> Result<(Potential, Units), Failure> {
        let species = atoms.atoms.masses.len();
        // The parser sees to it that one of the two is given.
        match (&self.pair, &self.eam) {
            (Some(pair), _) => {
                let law = pair.law(species).map_err(Failure::input)?;
                let potential = Potential::pair(law, pair.text());
                Ok((potential, self.units.unwrap_or(Units::Lj)))
            }
            (None, eam) => {
                let path = eam.as_deref().unwrap_or(Path::new(""));
                let fail = |error: &dyn std::fmt::Display| in_file(path, error);
                let (potential, masses) =
                    Potential::embedded(&text(path)?, path, atoms.names.as_deref(), species)
                        .map_err(|error| fail(&error))?;
                atoms.atoms.masses = masses;
                Ok((potential, self.units.unwrap_or(Units::Metal)))
            }
        }
    }
}

/// Forces and sums; refused where they are no numbers.
fn forces(
    all: &Configuration,
    potential: &Potential,
) -> Result<(Vec<nalgebra::Vector3<f64>>, Tally), Failure> {
    let law = potential.law();
    let space = all.space().map_err(Failure::input)?;
    let cutoff = law.cutoff();
    within_reach(all, cutoff)?;
    let mut list = VerletList::new(space, cutoff, SKIN * cutoff).map_err(Failure::input)?;
    let mut forces = Vec::new();
    let tally = evaluate(law, &mut list, &all.atoms, &mut forces, Evaluation::Sums);
    let tally = tally.map_err(Failure::input)?;
    let is_finite = tally.energy.is_finite()
        && tally.virial.iter().all(|part| part.is_finite())
        && forces.iter().flatten().all(|force| force.is_finite());
    if is_finite {
        Ok((forces, tally))
    } else {
        Err(overlap::failure(&mut list, &all.ids))
    }
}

/// Refuses coordinates so large that the numbers next to them lie too far apart for the cut-off.
fn within_reach(all: &Configuration, cutoff: f64) -> Result<(), Failure> {
    /// Distance of neighbouring numbers, in cut-offs, from which distances are lost.
    const GRAIN: f64 = 1e-3;
    let farthest = GRAIN * cutoff / f64::EPSILON;
    for (id, place) in all.ids.iter().zip(&all.atoms.positions) {
        if let Some(x) = place.iter().find(|x| x.abs() > farthest) {
            return Err(Failure::input(format!(
                "atom {id} has the coordinate {x:e}: numbers of that size lie too far apart to tell \
                 distances within the cut-off of {cutoff}; give coordinates up to {farthest:.0e}"
            )));
        }
    }
    Ok(())
}

fn text(path: &Path) -> Result<String, Failure> {
    read_text(path, MOST_BYTES)
        .map_err(|error| Failure::input(format!("cannot read {}: {error}", path.display())))
}

fn in_file(path: &Path, error: impl std::fmt::Display) -> Failure {
    Failure::input(format!("{}: {error}", path.display()))
}
