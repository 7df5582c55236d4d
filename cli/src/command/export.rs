//! `tribos export`: a scene as files of another program.

use crate::failure::Failure;
use crate::folder::{Contents, OutputFolder};
use std::path::PathBuf;
use tribos::record::write_atomically;
use tribos::scene::Scene;
use tribos::tip::export;

/// Write a scene as files of another program, which then runs the same system.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    program: Program,
}

/// Programs.
#[derive(Debug, clap::Subcommand)]
enum Program {
    /// LAMMPS: tip.data, the atoms at the start, and in.tip, the input script.
    Lammps(Lammps),
}

/// Of a scene with body = "tip". Run it with `lmp -in in.tip` in the folder; its first lines write
/// energies and forces of the start to compare with ours: start.dump.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
struct Lammps {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    scene: PathBuf,
    /// Folder for the files; made if missing; files of an earlier command in it go away first.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Replace or add a key of the scene; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  tribos export lammps scenes/tip-irreversible.toml --out out/lammps
  cd out/lammps && lmp -in in.tip";

impl Arguments {
    /// Writes.
    pub fn execute(self) -> Result<(), Failure> {
        let Program::Lammps(lammps) = self.program;
        let scene = super::scene::read(&lammps.scene, &lammps.overrides)?;
        let Scene::Tip(scene) = scene else {
            return Err(Failure::input(format!(
                "{}: only scenes with body = \"tip\" are made of atoms",
                lammps.scene.display()
            )));
        };
        let files = export::start(&scene).map_err(Failure::input)?;
        let contents = Contents::of("export", &["tip.data", "in.tip"]);
        let _folder = OutputFolder::begin(&lammps.out, &contents)?;
        write_atomically(&lammps.out.join("tip.data"), files.data.as_bytes())?;
        write_atomically(&lammps.out.join("in.tip"), files.script.as_bytes())?;
        super::print(&format!(
            "written to    {0}; run it with `lmp -in in.tip` there\n",
            lammps.out.display()
        ))
    }
}
