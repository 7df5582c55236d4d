//! `tribos sweep`: a scene run for all combinations of some keys and seeds.

mod body;
mod frame;
mod grid;
mod jobs;
mod output;
#[cfg(feature = "parquet")]
mod parquet;
mod part;
mod plan;
mod plot;
mod progress;
mod range;
mod refusal;
mod runs;
mod slurm;
mod summary;
mod table;

use super::{interrupt, number};
use crate::failure::Failure;
use grid::Grid;
use jobs::Task;
use part::Shard;
use plan::Plan;
use slurm::JobArray;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tribos::run::folder::{Contents, Lock, LockMode, LockOutcome, Manifest, OutputFolder};

/// Runs a scene of any body for every combination of the values of its keys, each with several seeds
/// if the body has one, and writes tables: sweep.csv, means and standard deviations over the seeds, and
/// runs.csv, one row a run; sweep.parquet and runs.parquet hold the same. Of two keys with several numbers
/// each there is a surface, of one a line, of the final porosity, angle, distance or curl, or of the column
/// that --plot names: sweep.svg and sweep.png.
///
/// Of grains the table has means over time with their standard errors, in place of the last instant.
///
/// Every run writes its summary to DIR/runs, one of grains its series too. An interrupted sweep continues where it
/// stopped: runs with a summary are not repeated.
///
/// A combination that is refused or fails, such as a body that tips or a tip that blows up, has a row
/// with the reason in the column `refusal`, and the others run; the exit code is 0 unless all are
/// refused. A value that is refused in every combination is bad input: nothing runs, and the exit code
/// is 2.
///
/// DIR/sweep.json is the plan: the scene's text and the keys. Other machines can each run a
/// part of it, or a cluster a job array; then one command merges the tables. See docs/runs.md.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    #[arg(required_unless_present_any = ["plan", "merge"], requires = "out")]
    scene: Option<PathBuf>,
    /// A key of the scene with its values, or ranges of them with both ends, FROM:TO:STEP or
    /// FROM:TO:xFACTOR; a text with commas in "quotes"; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE,...", conflicts_with_all = ["plan", "merge"])]
    sets: Vec<String>,
    /// Runs for each combination: the scene's seed and those after it.
    #[arg(long, default_value = "1", value_parser = number::count,
          conflicts_with_all = ["plan", "merge"])]
    seeds: NonZero<u32>,
    /// Runs at a time; as many as there are cores if left out. Their threads share the cores.
    #[arg(long, conflicts_with_all = ["merge", "slurm"])]
    jobs: Option<NonZero<usize>>,
    /// Folder for the results, created if missing. Results of another command in it are removed
    /// first; the folder of a powder, a tip or a report is refused.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["plan", "merge"])]
    out: Option<PathBuf>,
    /// Run the sweep planned in DIR/sweep.json instead of a scene.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["scene", "merge"])]
    plan: Option<PathBuf>,
    /// Run only part I of K, counted from 0; --merge makes the tables.
    #[arg(long, value_name = "I/K", conflicts_with_all = ["merge", "slurm"])]
    part: Option<Shard>,
    /// Make the tables of a sweep whose parts are finished; missing runs are listed.
    #[arg(long, value_name = "DIR", conflicts_with = "scene")]
    merge: Option<PathBuf>,
    /// Draw this column of sweep.csv, over two keys as lines, or as COLUMN:OVER over another column; with --merge also of a
    /// sweep that is done.
    #[arg(long, value_name = "COLUMN[:OVER]", conflicts_with_all = ["part", "slurm"])]
    plot: Option<String>,
    /// Write a job array for Slurm, DIR/job.sh, and run nothing.
    #[arg(long, requires = "scene")]
    slurm: bool,
    /// Tasks of the array, each with its part of the runs; one a run, at most 100, if left out.
    #[arg(long, value_name = "K", requires = "slurm")]
    slurm_tasks: Option<NonZero<usize>>,
    /// An option of sbatch for the script, such as --time=2:00:00; may be repeated.
    #[arg(
        long,
        value_name = "OPTION",
        requires = "slurm",
        allow_hyphen_values = true
    )]
    slurm_option: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  Final porosity over rolling and torsion friction (fig. 4.7, small system):
    tribos sweep scenes/compaction-small.toml --set mu_rolling=0,0.1,0.2,0.4,1 \\
        --set mu_torsion=0,0.1,0.2,0.4,1 --seeds 2 --out out/figure-4.7
  Over the range of cohesion, with error bars from five deposits, two runs at a time:
    tribos sweep scenes/compaction-small.toml --set cohesion_range=1e-4,1e-3,1e-2 \\
        --seeds 5 --jobs 2 --out out/range
  Both readings of cohesion at a gap:
    tribos sweep scenes/compaction-small.toml --set attraction=pull,resistance --out out/pull
  Whether a tip turns back, over the torque, three seeds each (fig. 5.2):
    tribos sweep scenes/tip-irreversible.toml --set lambda=0.01,0.017,0.02,0.03 \\
        --seeds 3 --out out/tips
  How far a spinning disk slides, and how much a rock curls:
    tribos sweep scenes/disk.toml --set spin=0:50:10 --out out/spin
    tribos sweep scenes/disk.toml --set inertia_ratio=1e-2:1e2:x10 --out out/inertia
    tribos sweep scenes/curling-draw.toml --set spin=0.5,1,1.5,2 --set speed=1.9,2 --out out/curl
  Shear stress over normal stress of a flow, with errors over time and over three seeds:
    tribos sweep shear-periodic --set shear_rate=5,10,20 --set mu=0.3,0.5 --seeds 3 \\
        --plot stress_ratio --out out/flow
  On two machines that share a folder (or copy DIR together afterwards):
    tribos sweep scenes/compaction-small.toml --set mu_rolling=0,1 --seeds 50 --out DIR --part 0/2
    tribos sweep --plan DIR --part 1/2
    tribos sweep --merge DIR
  On a cluster, 20 tasks of 4 cores:
    tribos sweep scenes/compaction-large.toml --set mu_rolling=0,0.1,1 --seeds 100 --out DIR \\
        --slurm --slurm-tasks 20 --slurm-option=--time=2:00:00 --slurm-option=--cpus-per-task=4
    sbatch DIR/job.sh
    tribos sweep --merge DIR";

/// How long a part waits for others that begin in its folder, and between two looks.
const PATIENCE: Duration = Duration::from_secs(5);
const PAUSE: Duration = Duration::from_millis(20);
/// How to go on after a full disk.
const GO_ON: &str = "Then give the same command again: finished runs are not repeated.";

impl Arguments {
    /// Runs, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        self.take().map_err(|failure| failure.resume_hint(GO_ON))
    }

    fn take(self) -> Result<(), Failure> {
        if let Some(out) = &self.merge {
            let plan = Plan::read(out)?;
            let tasks = plan.tasks(out)?;
            output::kind(&tasks, self.plot.as_deref())?;
            let folder = claim(&plan, out)?;
            return self.tables(&plan, &tasks, folder.lock());
        }
        let (plan, out) = self.planned()?;
        let tasks = plan.tasks(&out)?;
        output::kind(&tasks, self.plot.as_deref())?;
        if self.slurm {
            return self.write_job_array(&plan, &tasks, &out);
        }
        if self.plan.is_none() {
            guard(&plan, &out)?;
        }
        let held = self.hold(&plan, &out)?;
        if self.plan.is_none() {
            plan.write(&out)?;
        }
        interrupt::watch()?;
        let part = self.part.unwrap_or(Shard::WHOLE);
        let numbered = tasks.iter().enumerate();
        let mine: Vec<&Task> = numbered
            .filter(|(run, _)| part.has(*run))
            .map(|(_, task)| task)
            .collect();
        jobs::run(&mine, self.jobs.map(NonZero::get), held.lock())?;
        match self.part {
            None => self.tables(&plan, &tasks, held.lock()),
            Some(part) => super::print(&format!(
                "part {} of {} is done: {} of {} runs\nafter all parts  tribos sweep --merge {}\n",
                part.index,
                part.count,
                mine.len(),
                tasks.len(),
                out.display()
            )),
        }
    }

    /// The plan of a scene or of a folder, and the folder.
    fn planned(&self) -> Result<(Plan, PathBuf), Failure> {
        match (&self.plan, &self.scene, &self.out) {
            (Some(out), _, _) => Ok((Plan::read(out)?, out.clone())),
            (None, Some(scene), Some(out)) => {
                let grid = Grid::parse(&self.sets)?;
                Ok((Plan::new(scene, grid, self.seeds.get())?, out.clone()))
            }
            _ => Err(Failure::input("give a scene and --out DIR, or --plan DIR")),
        }
    }

    /// The folder, for a whole sweep alone, for a part together with the others.
    fn hold(&self, plan: &Plan, out: &Path) -> Result<FolderGuard, Failure> {
        if self.part.is_none() {
            return Ok(FolderGuard::Whole(claim(plan, out)?));
        }
        let is_mine = |kept: Manifest| kept.command == "sweep" && kept.about == plan.json();
        let until = Instant::now() + PATIENCE;
        // Another part that begins now holds the folder alone for a moment.
        let attempt = |sharing| match Lock::attempt(out, sharing)? {
            LockOutcome::Taken(lock) => Ok(Some(lock)),
            LockOutcome::InUse(_) if Instant::now() < until => {
                std::thread::sleep(PAUSE);
                Ok(None)
            }
            LockOutcome::InUse(_) => Lock::take(out, sharing).map(Some),
        };
        while !Manifest::read(out)?.is_some_and(is_mine) {
            if let Some(lock) = attempt(LockMode::Alone)? {
                drop(OutputFolder::reopen_locked(lock, &contents(plan))?);
                break;
            }
        }
        loop {
            if let Some(lock) = attempt(LockMode::Shared)? {
                return Ok(FolderGuard::Part(lock));
            }
        }
    }

    /// Writes the plan and the job array.
    fn write_job_array(&self, plan: &Plan, tasks: &[Task], out: &Path) -> Result<(), Failure> {
        let count = self.slurm_tasks.map(NonZero::get);
        let array = JobArray::new(count, tasks.len(), &self.slurm_option)?;
        guard(plan, out)?;
        let _folder = claim(plan, out)?;
        plan.write(out)?;
        let script = array.write(out)?;
        super::print(&format!(
            "{} runs in {} tasks\nsubmit        sbatch {}\nafterwards    tribos sweep --merge {}\n",
            tasks.len(),
            array.tasks(),
            script.display(),
            out.display()
        ))
    }

    /// The tables of a complete sweep, in the folder of the lock.
    fn tables(&self, plan: &Plan, tasks: &[Task], lock: &Lock) -> Result<(), Failure> {
        lock.check()?;
        let out = lock.folder();
        let summaries = output::complete(tasks, jobs::kept(tasks), out)?;
        let table = output::write(plan, tasks, &summaries, (out, self.plot.as_deref()))?;
        let text = table.text();
        super::print(&format!("{text}written to    {}\n", out.display()))?;
        match (table.refused(), table.runs()) {
            (0, _) => Ok(()),
            (refused, 0) => Err(Failure::input(format!(
                "all {refused} runs were refused; the column `refusal` says why"
            ))),
            (refused, _) => {
                super::note(format_args!(
                    "{refused} of {} runs were refused; the column `refusal` says why",
                    tasks.len()
                ));
                Ok(())
            }
        }
    }
}

/// The folder of the sweep, for this process alone.
fn claim(plan: &Plan, out: &Path) -> Result<OutputFolder, Failure> {
    Ok(OutputFolder::reopen(out, &contents(plan))?)
}

/// What a sweep leaves beside its runs and its plan, which may have come from another machine.
fn contents(plan: &Plan) -> Contents<'static> {
    let files = &[
        "sweep.csv",
        "sweep.parquet",
        "sweep.svg",
        "sweep.png",
        "runs.csv",
        "runs.parquet",
    ];
    Contents {
        about: plan.json(),
        ..Contents::of("sweep", files)
    }
}

/// What keeps others out of the folder while runs are taken.
#[derive(Debug)]
enum FolderGuard {
    /// A whole sweep: nobody else works there.
    Whole(OutputFolder),
    /// A part: other parts may.
    Part(Lock),
}

impl FolderGuard {
    fn lock(&self) -> &Lock {
        match self {
            Self::Whole(folder) => folder.lock(),
            Self::Part(lock) => lock,
        }
    }
}

/// A folder that was handed to a cluster keeps its plan: tasks that wait would take another.
fn guard(plan: &Plan, out: &Path) -> Result<(), Failure> {
    let script = out.join(slurm::SCRIPT);
    if !script.exists() || Plan::read(out).is_ok_and(|kept| kept.takes_the_runs_of(plan)) {
        return Ok(());
    }
    let [script, out] = [script.display(), out.display()];
    Err(Failure::input(format!(
        "{out} holds the job array of another sweep; give another --out, \
         or remove {script} if that array is done"
    )))
}
