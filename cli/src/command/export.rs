//! `tribos export`: a scene, the trajectory or a contact problem of a run, as files of another program.

mod problem;
mod trajectory;

use self::trajectory::Trajectory;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::grains;
use tribos::powder;
use tribos::record::trajectory::Format;
use tribos::record::write_atomically;
use tribos::run::folder::{Contents, OutputFolder};
use tribos::scene::Scene;
use tribos::tip;

/// Write the trajectory of a run, or the contact problem of a step, for another program; or a scene that the program
/// runs itself.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    program: Program,
}

/// Programs.
#[derive(Debug, clap::Subcommand)]
enum Program {
    /// LAMMPS: a tip, a powder or grains of soft spheres, the bodies at the start and the input script.
    ///
    /// Of a scene with body = "tip": tip.data and in.tip. Run it with `lmp -in in.tip` in the folder; its first lines
    /// write energies and forces of the start to compare with ours: start.dump.
    ///
    /// Of a scene with body = "powder" and method = "soft": powder.data, the spheres at rest, and in.powder, which needs the
    /// pair style gran/tribos: a plugin, engines/lammps. It runs until the piston stands and writes porosity.txt.
    ///
    /// Of a scene with body = "grains" and method = "soft": grains.data, the grains with their velocities, and in.grains, the
    /// same box, loads, hopper or drum, glued and driven grains with the same plugin. It runs for the duration and writes
    /// series.txt. What LAMMPS cannot hold, such as `mesh`, is refused; what it holds approximately is printed and stands
    /// at the head of the script.
    Lammps(Lammps),
    /// ParaView: a run as trajectory.pvd, a collection of trajectory/<step>.vtp.
    Vtk(Trajectory),
    /// OVITO, ASE: a run as trajectory.xyz, extended XYZ of many frames.
    Xyz(Trajectory),
    /// LAMMPS, OVITO: a run as trajectory.dump, a text dump.
    LammpsDump(Trajectory),
    /// FCLib, Siconos, `tribos contact`: the contact problem of one step of a run.
    Problem(problem::Step),
}

/// What to export, and where.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
struct Lammps {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    scene: PathBuf,
    /// Folder for the files, created if missing; files of an earlier command in it are removed first.
    /// The folder of a powder, a tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Replace or add a key of the scene, or leave one out (`KEY=`); may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  tribos run compaction-small --out out/powder && tribos export vtk out/powder
  tribos export xyz out/powder --out out/ovito
  tribos run tip-reversible --out out/tip && tribos export lammps-dump out/tip
  tribos export problem out/powder --step 2
  tribos export lammps scenes/tip-irreversible.toml --out out/lammps
  cd out/lammps && lmp -in in.tip
  tribos export lammps compaction-soft --out out/powder-lammps
  tribos export lammps hopper --set method=soft --out out/hopper-lammps";

impl Arguments {
    /// Writes.
    pub fn execute(self) -> Result<(), Failure> {
        match self.program {
            Program::Lammps(lammps) => lammps.write(),
            Program::Vtk(run) => run.write(Format::Vtk),
            Program::Xyz(run) => run.write(Format::Xyz),
            Program::LammpsDump(run) => run.write(Format::LammpsDump),
            Program::Problem(step) => step.write(),
        }
    }
}

/// Whether both are the same folder, which is there.
fn is_same(one: &Path, other: &Path) -> bool {
    matches!((one.canonicalize(), other.canonicalize()), (Ok(one), Ok(other)) if one == other)
}

impl Lammps {
    fn write(self) -> Result<(), Failure> {
        let scene = super::scene::read(&self.scene, &self.overrides)?;
        let files = match scene {
            Scene::Tip(scene) => tip::export::start(&scene).map_err(Failure::input)?,
            Scene::Powder(scene) => powder::export::start(&scene).map_err(Failure::input)?,
            Scene::Grains(scene) => grains::export::start(&scene).map_err(Failure::input)?,
            _ => {
                return Err(Failure::input(format!(
                    "{}: only scenes with body = \"tip\", and with body = \"powder\" or \"grains\" and method = \"soft\", are \
                     exported",
                    self.scene.display()
                )));
            }
        };
        let names = [format!("{}.data", files.name), format!("in.{}", files.name)];
        let files_of = names.each_ref().map(String::as_str);
        let contents = Contents::of("export", &files_of);
        let _folder = OutputFolder::begin(&self.out, &contents)?;
        for (name, text) in names.iter().zip([&files.data, &files.script]) {
            write_atomically(&self.out.join(name), text.as_bytes())?;
        }
        let plugin = if files.script.contains("plugin load") {
            [
                " -var plugin PATH/tribosplugin.so",
                "; the plugin is that of engines/lammps",
            ]
        } else {
            ["", ""]
        };
        let mut said = format!(
            "written to    {}; run it there with `lmp -in {}{}`{}\n",
            self.out.display(),
            names[1],
            plugin[0],
            plugin[1],
        );
        for note in &files.notes {
            said += &format!("differs       {note}\n");
        }
        super::print(&said)
    }
}
