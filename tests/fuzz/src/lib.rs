//! A fuzzer of the kernel: seeded inputs, the same on every platform.
//!
//! [`KERNEL`]'s targets take one input each, generated from a seed, use it and judge the results. [`run`] catches
//! panics, measures the time of each input and reports findings with the seed that repeats them. The
//! properties are
//!
//! - no panic for any input, and no input that takes longer than [`SLOW`];
//! - finite results of mild inputs: magnitudes from 2⁻¹² to 2¹² and zero, within each domain;
//! - results that are not NaN for every finite input, and NaN for NaN, if so documented;
//! - friction that dissipates;
//! - refusals that report the position of the error.

mod bonds;
mod check;
mod contacts;
mod couplings;
mod laws;
mod manifolds;
mod motions;
mod patches;
mod planes;
mod polygons;
mod presliding;
mod sets;
mod source;
mod special;
mod supports;

pub use check::Broken;
pub use source::{Regime, Source, seed_of};

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// A target of the fuzzer.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Name of the target.
    pub name: &'static str,
    /// Its share of the inputs, per mille; slow targets get fewer.
    pub share: u64,
    /// Runs one input.
    pub take: fn(&mut Source) -> Result<(), Broken>,
}

/// A target of the fuzzer.
pub const fn target(
    name: &'static str,
    share: u64,
    take: fn(&mut Source) -> Result<(), Broken>,
) -> Target {
    Target { name, share, take }
}

/// Targets in the kernel.
pub const KERNEL: [Target; 17] = [
    target("laws", 100, laws::memoryless),
    target("laws with memory", 100, laws::with_memory),
    target("bonds", 20, bonds::bonds),
    target("special functions", 100, special::special),
    target("couplings", 90, couplings::couplings),
    target("patches", 30, patches::patches),
    target("planes", 100, planes::planes),
    target("limit surfaces", 60, sets::sets),
    target("contacts", 110, contacts::contacts),
    target("manifolds", 40, contacts::manifolds),
    target("manifold friction", 20, manifolds::manifold),
    target("modes", 40, motions::modes),
    target("sliders", 13, motions::sliders),
    target("planar steps", 30, planes::steps),
    target("feet", 20, planes::feet),
    target("presliding", 40, presliding::presliding),
    target("polygons", 40, polygons::polygons),
];

/// An input that takes longer than this is a finding.
pub const SLOW: Duration = Duration::from_secs(5);
/// Number of findings of a target that are kept.
const KEPT: usize = 5;

/// An input with a broken property.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The seed of the input.
    pub seed: u64,
    /// Description of the broken property.
    pub broken: Broken,
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
pub fn take(target: &Target, seed: u64) -> Result<(), Broken> {
    let mut source = Source::new(seed);
    let caught = catch_unwind(AssertUnwindSafe(|| (target.take)(&mut source)));
    caught.unwrap_or_else(|panic| {
        let text = panic
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| panic.downcast_ref::<&str>().copied());
        Err(format!("panic: {}", text.unwrap_or("without a message")))
    })
}

/// Runs the inputs `range` of the run with `seed`.
pub fn run(target: &Target, seed: u64, range: std::ops::Range<u64>) -> Report {
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
