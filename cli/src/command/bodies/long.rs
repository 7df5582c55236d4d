//! Bodies of spheres or atoms, whose runs take long enough for checkpoints and frames.

use super::kind::{RunKind, first};
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
use tribos::results::{Summary, SweepView, file, swept};
use tribos::run::folder::{Lock, OutputFolder};
use tribos::run::{LongRun, RunSize};
use tribos::scene::Body;

/// Names of the columns of a series, and its rows.
pub type Series<'a> = (Vec<String>, Vec<&'a [f64]>);

/// A series whose rows have all the same columns.
pub fn series<'a, const N: usize>(columns: [&str; N], rows: &'a [[f64; N]]) -> Series<'a> {
    let names = columns.map(str::to_owned).to_vec();
    (names, rows.iter().map(|row| &row[..]).collect())
}

/// What the commands ask of a scene of spheres or atoms.
pub trait LongBody: Body + Sized + 'static {
    /// Its run.
    type Run: LongRun<Scene = Self, Error: Error + Into<Failure>>;
    /// What it has found.
    type Summary: Summary;
    /// What it consists of.
    const SPHERES: &'static str;
    /// Names of the files with its results.
    const FILES: &'static [&'static str];
    /// Columns of a sweep that stand before all others.
    const FIRST: &'static [&'static str] = &[];
    /// Whether the runs of a sweep leave their series.
    const KEEPS_SERIES: bool = false;

    /// What a sweep makes a table of.
    fn kind(&self) -> RunKind {
        let quantities = swept(Self::Summary::QUANTITIES);
        RunKind::of(first(Self::FIRST, quantities), self.sweep_view())
    }
    /// What a sweep shows.
    fn sweep_view(&self) -> SweepView;

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
    fn outcome(run: &Self::Run) -> Self::Summary;
    /// A line about a run of a sweep.
    fn told(outcome: &Self::Summary) -> String;
    /// A few lines for the person at the terminal.
    fn report(&self, outcome: &Self::Summary) -> String;
    /// The series of a run.
    fn series(run: &Self::Run) -> Series<'_>;
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
        LongBody::kind(*self)
    }

    fn summarize(&self, lock: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        check(&self.size(), S::SPHERES, MemoryPermission::Never).map_err(NoResult::Refused)?;
        let run = session(lock).run(*self)?;
        if S::KEEPS_SERIES {
            let written = lock.check().map_err(Failure::from);
            let written = written.and_then(|()| long::write_series::<S>(&run, lock.folder()));
            written.map_err(NoResult::Stopped)?;
        }
        let outcome = S::outcome(&run);
        Ok((file(outcome.entries(), *self), S::told(&outcome)))
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
