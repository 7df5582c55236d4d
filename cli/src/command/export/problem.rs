//! `tribos export problem`: the contact problem of one step.

use crate::command::digits::shown;
use crate::command::progress::Meter;
use crate::command::view::run_files::RunFiles;
use crate::failure::Failure;
use serde_json::Value;
use std::error::Error;
use std::path::{Path, PathBuf};
use tribos::cd::StepReport;
use tribos::grains::GrainsSimulation;
use tribos::powder::PowderSimulation;
use tribos::problem::{self, GlobalProblem};
use tribos::run::folder::{self, Contents, OutputFolder};
use tribos::run::{CHECKPOINT, LongRun, read_checkpoint};
use tribos::scene::Scene;

/// Of a run with body = "powder" or "grains", by contact dynamics. The steps up to it are taken again, from the
/// run's checkpoint if that is of an earlier step, else from its beginning.
///
/// Bodies and contacts have the units of the scene: M v = H r + f, u = H^T v + w. Contacts are pairs of spheres, then
/// spheres at walls; bodies that sleep are not among them, and impacts with restitution come later.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Step {
    /// The folder of the run.
    run: PathBuf,
    /// The step, from 1.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    step: u64,
    /// Format of the file.
    #[arg(long, value_enum, default_value = "hdf5")]
    format: Format,
    /// Folder for the file, created if missing. [default: that of the run]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// HDF5 of FCLib: problem-N.hdf5.
    Hdf5,
    /// Text of Siconos: problem-N.dat. It has no place for torsion and cohesion, which powders have: `column` fits.
    Text,
}

/// What an export leaves.
const FILES: [&str; 2] = ["problem-#.hdf5", "problem-#.dat"];

impl Step {
    /// Runs up to the step, and writes its problem.
    pub fn write(self) -> Result<(), Failure> {
        let kept = RunFiles::read(&self.run)?;
        let scene = scene(&self.run, &kept.manifest.about)?;
        let (problem, step) = match scene {
            Scene::Powder(scene) => self.problem(&scene, |run: &PowderSimulation| {
                Some((run.problem()?, *run.last_step()))
            })?,
            Scene::Grains(scene) => self.problem(&scene, |run: &GrainsSimulation| {
                Some((run.problem()?, *run.last_step()))
            })?,
            _ => {
                return Err(Failure::input(format!(
                    "{}: only runs with body = \"powder\" or \"grains\" have contact problems",
                    self.run.display()
                )));
            }
        };
        let (format, ending) = match self.format {
            Format::Hdf5 => (problem::ProblemFormat::FclibHdf5, "hdf5"),
            Format::Text => (problem::ProblemFormat::SiconosText, "dat"),
        };
        let out = self.out.as_deref().unwrap_or(&self.run);
        let _lock = if super::is_same(out, &self.run) {
            folder::add(out, &FILES)?;
            None
        } else {
            let contents = Contents {
                about: kept.manifest.about.clone(),
                ..Contents::of("export", &FILES)
            };
            Some(OutputFolder::reopen(out, &contents)?)
        };
        let contacts = problem.laws().len();
        let file = out.join(format!("problem-{}.{ending}", self.step));
        let problem = problem::ContactProblem::from(problem);
        problem.write(&file, format).map_err(Failure::input)?;
        // The file holds the problem, and not how far the run has solved it.
        let solved = match step.iterations.met {
            true => "within its tolerance",
            false => "its tolerance missed",
        };
        crate::command::print(&format!(
            "written to    {}, {contacts} contacts\nin the run    solved to a residual of {}, {solved}\n",
            file.display(),
            shown(step.residual.relative)
        ))
    }

    /// The problem of the step of a run, and how the run solved it.
    fn problem<R>(
        &self,
        scene: &R::Scene,
        problem: impl Fn(&R) -> Option<(GlobalProblem, StepReport)>,
    ) -> Result<(GlobalProblem, StepReport), Failure>
    where
        R: LongRun<Error: Error + 'static>,
    {
        let mut run: R = self.begin(scene)?;
        let mut meter = Meter::new();
        let from = run.steps();
        while run.steps() < self.step {
            let goes_on = run.step().map_err(Failure::run)?;
            if !goes_on && run.steps() < self.step {
                return Err(Failure::input(format!(
                    "--step {}: the run ends with step {}",
                    self.step,
                    run.steps()
                )));
            }
            let done = (run.steps() - from) as f64 / (self.step - from) as f64;
            if meter.is_due(done) {
                meter.tell(done, format_args!("step {}", run.steps()));
            }
        }
        problem(&run).ok_or_else(|| {
            Failure::input(format!(
                "--step {}: the step has no contact problem that a file can hold: no contacts, springs in their place, or \
                 sliding and torsion under an exact limit surface",
                self.step
            ))
        })
    }

    /// The run at its checkpoint, if that is of an earlier step; else at its beginning.
    fn begin<R>(&self, scene: &R::Scene) -> Result<R, Failure>
    where
        R: LongRun<Error: Error + 'static>,
    {
        let mut growing = |_: usize| std::ops::ControlFlow::Continue(());
        if let Ok(text) = read_checkpoint(&self.run.join(CHECKPOINT))
            && let Ok(run) = R::begin(scene, Some(&text), &mut growing)
            && run.steps() < self.step
        {
            return Ok(run);
        }
        R::begin(scene, None, &mut growing).map_err(Failure::run)
    }
}

/// The scene that a run's folder tells.
fn scene(run: &Path, about: &Value) -> Result<Scene, Failure> {
    Scene::of_json(about).ok_or_else(|| {
        Failure::input(format!(
            "{}: the run is of another version of tribos; run the scene again",
            run.display()
        ))
    })
}
