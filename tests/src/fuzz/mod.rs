//! A fuzzer of the kernel and of readers of files: seeded inputs, the same on every platform.
//!
//! [`run`] catches panics, measures the time of each input and reports findings with the seed that repeats
//! them.

mod texts;

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use tribos_subjects::{SUBJECTS, Source, Subject, seed_of};

/// A target of the fuzzer.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Name of the target.
    pub name: &'static str,
    /// Its share of the inputs, per mille; slow targets get fewer.
    pub share: u64,
    takes: Takes,
}

#[derive(Clone, Copy, Debug)]
enum Takes {
    Subject(Subject),
    Texts(fn(&mut Source) -> Result<(), String>),
}

const fn reader(
    name: &'static str,
    share: u64,
    take: fn(&mut Source) -> Result<(), String>,
) -> Target {
    let takes = Takes::Texts(take);
    Target { name, share, takes }
}

/// Readers of files: a refusal tells where the error is.
pub const READERS: [Target; 4] = [
    reader("scenes", 20, texts::scenes),
    reader("overrides", 20, texts::overrides),
    reader("checkpoints", 2, texts::checkpoints),
    reader("golden files", 5, texts::golden_files),
];

/// The parts of the kernel.
fn kernel() -> impl Iterator<Item = Target> {
    SUBJECTS.into_iter().map(|subject| Target {
        name: subject.name,
        share: subject.share,
        takes: Takes::Subject(subject),
    })
}

/// All targets.
pub fn targets() -> impl Iterator<Item = Target> {
    READERS.into_iter().chain(kernel())
}

/// An input that takes longer than this is a finding.
pub const SLOW: Duration = Duration::from_secs(5);
/// Number of findings of a target that are kept.
const KEPT: usize = 5;

/// An input with a broken property.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The seed of the input.
    pub seed: u64,
    /// Description of the broken property, including the numbers.
    pub broken: String,
}

/// Result of a run.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Number of inputs.
    pub inputs: u64,
    /// The first findings.
    pub findings: Vec<Finding>,
    /// Total number of findings.
    pub found: u64,
    /// The longest time of an input, and its seed.
    pub slowest: (Duration, u64),
}

/// Runs the input of one seed.
///
/// # Errors
/// The property that does not hold, or a panic.
pub fn take(target: &Target, seed: u64) -> Result<(), String> {
    let caught = catch_unwind(AssertUnwindSafe(|| match &target.takes {
        Takes::Subject(subject) => {
            let judged = subject.take(seed, &mut |_| ());
            judged.map_err(|broken| broken.to_string())
        }
        Takes::Texts(take) => take(&mut Source::new(seed)),
    }));
    caught.unwrap_or_else(|panic| {
        let text = panic
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| panic.downcast_ref::<&str>().copied());
        Err(format!("panic: {}", text.unwrap_or("without a message")))
    })
}

/// Runs the inputs `range` of the run with `seed`.
pub fn run(target: &Target, seed: u64, range: Range<u64>) -> Report {
    let mut report = Report::default();
    for index in range {
        let own = seed_of(seed, index);
        let start = Instant::now();
        let mut outcome = take(target, own);
        let time = start.elapsed();
        if time > SLOW && outcome.is_ok() {
            outcome = Err(format!("it took {:.1} s", time.as_secs_f64()));
        }
        report.inputs += 1;
        report.slowest = report.slowest.max((time, own));
        if let Err(broken) = outcome {
            report.found += 1;
            if report.findings.len() < KEPT {
                report.findings.push(Finding { seed: own, broken });
            }
        }
    }
    report
}

impl Report {
    /// Sum of both results.
    pub fn merged(mut self, other: Self) -> Self {
        self.inputs += other.inputs;
        self.found += other.found;
        self.findings.extend(other.findings);
        self.findings.truncate(KEPT);
        self.slowest = self.slowest.max(other.slowest);
        self
    }
}
