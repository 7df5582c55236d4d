//! The compactions behind chapter 4, each run once for all exhibits.

use super::kept::Kept;
use super::plan;
use crate::command::parallel::in_order;
use crate::command::run::long::{Course, checkpoint, resumed};
use crate::command::run::powder::{self, State};
use crate::command::view;
use crate::failure::Failure;
use crate::report::player::Film;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZero;
use std::sync::atomic::{self, AtomicUsize};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;
use std::time::Instant;
use tribos::powder::Outcome;
use tribos::record::write_atomically;
use tribos::scene::PowderScene;

/// Frames of a film in the report.
pub const FRAMES: u64 = 80;

/// How much is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// What takes a minute or two.
    Quick,
    /// Everything that the thesis shows.
    Full,
}

impl Effort {
    /// In folders and on the page.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Full => "full",
        }
    }
}

/// A system of the thesis (section 4.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum System {
    /// 470 spheres.
    Small,
    /// 1015 spheres.
    Large,
}

impl System {
    /// Its name in the thesis.
    pub fn name(self) -> &'static str {
        match self {
            Self::Small => "small",
            Self::Large => "large",
        }
    }

    /// Side of the base and height of the piston at the start, in R.
    pub fn size(self) -> [f64; 2] {
        match self {
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
            rolling,
            torsion,
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

    /// Frames kept: of the first packing without torques.
    fn frames(&self) -> u64 {
        if *self == Self::new(self.system, [0.0; 2], 1) {
            FRAMES
        } else {
            0
        }
    }

    /// Its film, once it has run.
    pub fn film(&self, runs: &Runs) -> Result<Film, Failure> {
        view::solid_film(&runs.kept.run(&self.folder()))
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
    pub outcome: Outcome,
    /// The packing at the start and at the end.
    pub states: [State; 2],
}

impl Run {
    /// From where its folder has it: the end, a checkpoint or the deposit.
    fn of(case: &Case, kept: &Kept) -> Result<Self, Failure> {
        let scene = case.scene.clone();
        let folder = kept.run(&case.folder());
        kept.lock.check()?;
        std::fs::create_dir_all(&folder).map_err(Failure::run)?;
        let course = |start| Course::one_of_many(&kept.lock, start, kept.pause, case.frames());
        let run = |start| powder::simulate(&scene, &folder, &course(start));
        let compaction = resumed(run)?;
        let end = compaction.checkpoint();
        kept.lock.check()?;
        write_atomically(&checkpoint(&folder), end.as_bytes())?;
        Ok(Self {
            outcome: compaction.outcome(),
            states: State::both(&compaction),
            scene,
        })
    }
}

/// All compactions so far.
#[derive(Debug)]
pub struct Runs {
    effort: Effort,
    kept: Kept,
    done: Mutex<BTreeMap<Case, Arc<Run>>>,
}

impl Runs {
    /// None yet but those kept.
    pub fn new(effort: Effort, kept: Kept) -> Self {
        Self {
            effort,
            kept,
            done: Mutex::default(),
        }
    }

    /// How much to compute.
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Where sections and runs are kept.
    pub fn kept(&self) -> &Kept {
        &self.kept
    }

    /// What more there would be, if there is.
    pub fn hint<'a>(&self, more: &'a str) -> &'a str {
        match self.effort {
            Effort::Quick => more,
            Effort::Full => "",
        }
    }

    /// The cases in their order. Those that are missing run now, as many at a time as the machine
    /// has cores, each told on standard error.
    pub fn of(&self, cases: &[Case]) -> Result<Vec<Arc<Run>>, Failure> {
        let mut done = self.done.lock().unwrap_or_else(PoisonError::into_inner);
        let mut missing: Vec<&Case> = cases
            .iter()
            .filter(|case| !done.contains_key(*case))
            .collect();
        missing.sort();
        missing.dedup();

        let threads = available_parallelism().map_or(1, NonZero::get);
        let batch = Batch::new(missing.len());
        let results = in_order(missing.len(), threads, |index| {
            let run = Run::of(missing[index], &self.kept)?;
            let (porosity, steps) = (100.0 * run.outcome.porosity[1], run.outcome.steps);
            let what = format!(
                "{}: porosity {porosity:.2} % after {steps} steps",
                missing[index]
            );
            batch.tell(&what);
            Ok::<_, Failure>(run)
        });
        for (case, result) in missing.into_iter().zip(results) {
            let run = result.unwrap_or_else(|| Err(Failure::run("a run was lost")))?;
            done.insert(case.clone(), Arc::new(run));
        }
        let kept = cases.iter().filter_map(|case| done.get(case).cloned());
        Ok(kept.collect())
    }

    /// One case.
    pub fn one(&self, case: &Case) -> Result<Arc<Run>, Failure> {
        let mut runs = self.of(std::slice::from_ref(case))?;
        runs.pop().ok_or_else(|| Failure::run("a run was lost"))
    }
}

/// Runs of one exhibit, told on standard error as they end.
#[derive(Debug)]
pub struct Batch {
    runs: usize,
    ended: AtomicUsize,
    started: Instant,
}

impl Batch {
    /// Starts now.
    pub fn new(runs: usize) -> Self {
        Self {
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
        crate::command::tell(format_args!(
            "  {ended:>3} of {} runs: {what}{left}",
            self.runs
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::folder::{Lock, Sharing};
    use std::path::Path;
    use std::time::Duration;

    type Outcome = Result<(), Box<dyn std::error::Error>>;

    fn runs_in(folder: &Path) -> Result<Runs, Failure> {
        let lock = Lock::take(folder, Sharing::Shared)?;
        let kept = Kept::open(lock.into(), Duration::ZERO)?;
        Ok(Runs::new(Effort::Quick, kept))
    }

    #[test]
    fn a_case_is_run_once_and_answers_in_the_order_asked() -> Outcome {
        let folder = tempfile::tempdir()?;
        let runs = runs_in(folder.path())?;
        let case = |seed| {
            Case::new(System::Small, [0.0; 2], seed).with("steps=2", |scene| scene.steps = 2)
        };
        let first = runs.of(&[case(2), case(1), case(2)])?;
        assert!(Arc::ptr_eq(&first[0], &first[2]) && !Arc::ptr_eq(&first[0], &first[1]));
        assert!(Arc::ptr_eq(&first[1], &runs.one(&case(1))?));
        assert_eq!(first[0].scene.seed, 2);
        assert_eq!(first[1].scene.seed, 1);
        assert_eq!(first[1].outcome.steps, 2);
        // Another process finds it at its end.
        let again = runs_in(folder.path())?.one(&case(1))?;
        assert_eq!(again.outcome.statistics, first[1].outcome.statistics);
        assert_eq!(again.states[1].positions, first[1].states[1].positions);
        Ok(())
    }

    #[test]
    fn a_refused_key_is_an_input_failure() -> Outcome {
        let folder = tempfile::tempdir()?;
        let runs = runs_in(folder.path())?;
        let case = Case::new(System::Large, [0.0; 2], 1).with("sweeps=0", |scene| scene.sweeps = 0);
        assert!(matches!(runs.one(&case), Err(Failure::Input(_))));
        Ok(())
    }
}
