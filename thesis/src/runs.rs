//! The compactions behind chapter 4, each run once for all exhibits.

pub use super::effort::Effort;
use super::section_cache::SectionCache;
use super::{Reader, plan};
use anyhow::{Result, anyhow};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZero;
use std::path::Path;
use std::sync::atomic::{self, AtomicUsize};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;
use std::time::Instant;
use tribos::powder::{PowderSimulation, PowderSummary};
use tribos::run::{FRAMES as FRAMES_FOLDER, LongRun, Session, StartMode, in_order};
use tribos::scene::PowderScene;
use tribos_report::player::Film;
use tribos_report::runs::RunFrames;
use tribos_report::runs::powder::State;

/// Frames of a film in the report.
pub const FRAMES: u64 = 80;
/// Rolling and torsion coefficients of the compactions in films (thesis, appendix B).
pub const FILMED: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];

/// A system: two of the thesis (section 4.5), and a tiny one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum System {
    /// 85 spheres: not one of the thesis, for what takes many runs.
    Tiny,
    /// 470 spheres.
    Small,
    /// 1015 spheres.
    Large,
}

impl System {
    /// Its name, in the thesis too if it has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tiny => "tiny",
            Self::Small => "small",
            Self::Large => "large",
        }
    }

    /// Side of the base and height of the piston at the start, in R.
    pub fn size(self) -> [f64; 2] {
        match self {
            Self::Tiny => [10.0, 45.0],
            Self::Small => [20.0, 61.5],
            Self::Large => [25.0, 87.5],
        }
    }
}

/// One compaction: a system, and the keys of its scene that are not the defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    system: System,
    /// What its folder is named by, `key=value` each.
    keys: Vec<String>,
    scene: PowderScene,
}

impl Case {
    /// μ = 0.3 and these rolling and torsion coefficients.
    pub fn new(system: System, [rolling, torsion]: [f64; 2], seed: u64) -> Self {
        let keys = vec![
            format!("rolling={rolling}"),
            format!("torsion={torsion}"),
            format!("seed={seed}"),
        ];
        let [width, height] = system.size();
        let scene = PowderScene {
            width,
            height,
            mu_rolling: rolling,
            mu_torsion: torsion,
            seed,
            ..PowderScene::default()
        };
        Self {
            system,
            keys,
            scene,
        }
    }

    /// With one more change, `key=value` in its name.
    pub fn with(mut self, key: &str, change: impl FnOnce(&mut PowderScene)) -> Self {
        self.keys.push(key.into());
        change(&mut self.scene);
        self
    }

    /// Frames kept: of the first packings of which there are films.
    fn frames(&self) -> u64 {
        let is_filmed = |friction| *self == Self::new(self.system, friction, 1);
        if self.system != System::Tiny && FILMED.into_iter().any(is_filmed) {
            FRAMES
        } else {
            0
        }
    }

    /// Its film, once it has run.
    pub fn film(&self, runs: &Runs) -> Result<Film> {
        film(&runs.kept.run(&self.folder()))
    }

    /// Name of its folder.
    fn folder(&self) -> String {
        format!("{},{}", self.system.name(), self.keys.join(","))
    }
}

impl Eq for Case {}

impl PartialOrd for Case {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// By system and name.
impl Ord for Case {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.system, &self.keys).cmp(&(other.system, &other.keys))
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} system, {}", self.system.name(), self.keys.join(", "))
    }
}

/// What is kept of a compaction.
#[derive(Debug)]
pub struct Run {
    /// What was run.
    pub scene: PowderScene,
    /// The summary.
    pub outcome: PowderSummary,
    /// The packing at the start and at the end.
    pub states: [State; 2],
}

impl Run {
    /// From where its folder has it: the end, a checkpoint or the deposit.
    fn of(case: &Case, runs: &Runs) -> Result<Self> {
        let scene = case.scene.clone();
        let folder = &runs.kept.run(&case.folder());
        let compaction: PowderSimulation =
            runs.session(folder).frames(case.frames()).run(&scene)?;
        Ok(Self {
            outcome: compaction.outcome(),
            states: State::both(&compaction),
            scene,
        })
    }
}

/// The film of a run from the frames in its folder.
pub fn film(folder: &Path) -> Result<Film> {
    Ok(RunFrames::read(&folder.join(FRAMES_FOLDER), None)?.film()?)
}

/// All compactions so far.
#[allow(missing_debug_implementations)] // Who reads has none.
pub struct Runs<'a> {
    effort: Effort,
    kept: SectionCache,
    reader: &'a dyn Reader,
    done: Mutex<BTreeMap<Case, Arc<Run>>>,
}

impl<'a> Runs<'a> {
    /// None yet but those kept.
    pub fn new(effort: Effort, kept: SectionCache, reader: &'a dyn Reader) -> Self {
        Self {
            effort,
            kept,
            reader,
            done: Mutex::default(),
        }
    }

    /// How much to compute.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Where sections and runs are kept.
    pub fn kept(&self) -> &SectionCache {
        &self.kept
    }

    /// A run in its folder, resumed if it can be, and cancelled when the reader is.
    pub fn session<R: LongRun>(&self, folder: &Path) -> Session<'_, R> {
        Session::under(self.kept.lock.clone(), folder)
            .start(StartMode::ResumeIfPossible)
            .checkpoint_every(self.kept.pause)
            .cancel_when(|| self.reader.is_cancelled())
    }

    /// Who is told of the work.
    pub fn reader(&self) -> &dyn Reader {
        self.reader
    }

    /// The cases in their order. Those that are missing run now, as many at a time as the machine
    /// has cores, each told on standard error.
    pub fn of(&self, cases: &[Case]) -> Result<Vec<Arc<Run>>> {
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        let mut missing: Vec<&Case> = cases
            .iter()
            .filter(|case| !done.contains_key(*case))
            .collect();
        missing.sort();
        missing.dedup();

        let threads = available_parallelism().map_or(1, NonZero::get);
        let batch = Batch::new(missing.len(), self.reader);
        let results = in_order(missing.len(), threads, |index| {
            let run = Run::of(missing[index], self)?;
            let (porosity, steps) = (100.0 * run.outcome.porosity_final, run.outcome.steps);
            let what = format!(
                "{}: porosity {porosity:.2} % after {steps} steps",
                missing[index]
            );
            batch.tell(&what);
            anyhow::Ok(run)
        });
        for (case, result) in missing.into_iter().zip(results) {
            let run = result.ok_or_else(|| anyhow!("a run was lost"))??;
            done.insert(case.clone(), Arc::new(run));
        }
        let kept = cases.iter().filter_map(|case| done.get(case).cloned());
        Ok(kept.collect())
    }

    /// One case.
    pub fn one(&self, case: &Case) -> Result<Arc<Run>> {
        let mut runs = self.of(std::slice::from_ref(case))?;
        runs.pop().ok_or_else(|| anyhow!("a run was lost"))
    }
}

/// Runs of one exhibit, told on standard error as they end.
#[allow(missing_debug_implementations)] // Who reads has none.
pub struct Batch<'a> {
    reader: &'a dyn Reader,
    runs: usize,
    ended: AtomicUsize,
    started: Instant,
}

impl<'a> Batch<'a> {
    /// Starts now.
    pub fn new(runs: usize, reader: &'a dyn Reader) -> Self {
        Self {
            reader,
            runs,
            ended: AtomicUsize::new(0),
            started: Instant::now(),
        }
    }

    /// Tells that a run has ended, and about how long the others take.
    pub fn tell(&self, what: &str) {
        let ended = self.ended.fetch_add(1, atomic::Ordering::Relaxed) + 1;
        let each = self.started.elapsed().div_f64(ended as f64);
        let left = each.mul_f64((self.runs - ended) as f64);
        let left = match self.runs - ended {
            0 => String::new(),
            _ => format!("; the others about {}", plan::told(left)),
        };
        self.reader.progress(format_args!(
            "  {ended:>3} of {} runs: {what}{left}",
            self.runs
        ));
    }
}
