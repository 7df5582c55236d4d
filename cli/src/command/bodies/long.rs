//! Bodies of spheres, whose runs take long enough for checkpoints and frames.

use super::kind::RunKind;
use super::no_result::session;
use super::{Commands, NoResult};
use crate::command::explain::after;
use crate::command::run::long;
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::failure::Failure;
use serde_json::Value;
use std::error::Error;
use std::path::Path;
use std::sync::Arc;
use tribos::run::folder::{Lock, OutputFolder};
use tribos::run::{LongRun, RunSize};
use tribos::scene::Body;

/// What a run has found.
#[derive(Debug)]
pub struct RunResults<'a> {
    /// The summary as it is written.
    pub summary: Value,
    /// A line about a run of a sweep.
    pub told: String,
    /// A few lines for the person at the terminal.
    pub report: String,
    /// Columns of the series, and its rows.
    pub columns: &'static [&'static str],
    pub rows: Vec<&'a [f64]>,
}

/// What the commands ask of a scene of spheres.
pub trait LongBody: Body + Sized + 'static {
    /// Its run.
    type Run: LongRun<Scene = Self, Error: Error + Into<Failure>>;
    /// What a sweep makes a table of.
    fn kind() -> RunKind;
    /// What it consists of.
    const SPHERES: &'static str;
    /// Names of the files with its results.
    const FILES: &'static [&'static str];

    /// Rough cost of a run.
    fn size(&self) -> RunSize;
    /// Refuses a scene before its folder is touched.
    fn refuse(&self) -> Result<(), Failure> {
        Ok(())
    }

    /// Words about so many spheres that are placed, where that takes a while.
    fn growth(_placed: usize, _expected: f64) -> Option<String> {
        None
    }
    /// Sweeps of the last step, where a step has sweeps.
    fn sweeps(&self, _run: &Self::Run) -> Option<usize> {
        None
    }
    /// How far a run is.
    fn state(run: &Self::Run) -> String;
    /// Whether the end of a run is known before it.
    fn is_end_known(&self) -> bool {
        true
    }

    /// What a run has found.
    fn results<'a>(&self, run: &'a Self::Run) -> RunResults<'a>;
    /// Writes states and pictures.
    fn write(
        &self,
        run: &Self::Run,
        folder: &OutputFolder,
        order: &RunRequest<'_>,
    ) -> Result<(), Failure>;

    /// Laws, modes and unknowns that the scene carries, and their cost.
    fn explanation(&self) -> Result<String, Failure>;
    /// Where the energy of a run with this summary went; `command` runs the scene anew.
    fn account(&self, summary: &Value, command: &str) -> String;
}

impl<S: LongBody> Commands for &S {
    fn is_long(&self) -> bool {
        true
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        long::run(*self, order)
    }

    fn kind(&self) -> RunKind {
        S::kind()
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(&self.size(), S::SPHERES, MemoryPermission::Usual).map_err(NoResult::Refused)?;
        let run = session(lock).run(*self)?;
        let results = self.results(&run);
        Ok((results.summary, results.told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        LongBody::explanation(*self)
    }

    fn account(&self, out: Option<&Path>, command: &str) -> Result<String, Failure> {
        let Some(out) = out else {
            return Ok(String::new());
        };
        let summary = after::summary(out, self.keys(), &self.json())?;
        Ok(LongBody::account(*self, &summary, command))
    }
}
