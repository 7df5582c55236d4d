//! Checkpoint files of a run: its complete state, from which it continues with identical bits.

use super::body::{PackingBody, RunLimits};
use super::last::read_report;
use super::{PackingStopReason, Totals, WorldSnapshot};
use serde_json::Value;
use std::array;
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, numbers, opened};
use tribos_contacts::cd::StepReport;

/// Key of the digest of what a run began with.
pub(super) const ORIGIN: &str = "began_with";

/// State of a run between two steps.
#[derive(Debug)]
pub(crate) struct PackingCheckpoint<B: PackingBody<N>, const N: usize> {
    pub frozen: WorldSnapshot,
    pub totals: Totals,
    /// Report of the last step.
    pub report: StepReport,
    /// Digest of what the run began with.
    pub origin: String,
    pub watch: B::Monitor,
    /// Lines of the series, one after the other.
    series: Vec<f64>,
    /// Why the run ended, if it has.
    pub ending: Option<PackingStopReason>,
}

impl<B: PackingBody<N>, const N: usize> PackingCheckpoint<B, N> {
    /// Reads a checkpoint of the same scene, if there is one.
    pub fn read(text: Option<&str>, scene: &Value) -> Result<Option<Self>, CheckpointError> {
        let Some(text) = text else {
            return Ok(None);
        };
        let value = opened::<B::Scene>(text, B::FORMAT, scene)?;
        Ok(Some(Self {
            frozen: WorldSnapshot::read(&value)?,
            totals: Totals::read(&value)?,
            report: read_report(&value)?,
            origin: value[ORIGIN]
                .as_str()
                .ok_or_else(|| damaged(ORIGIN))?
                .into(),
            watch: B::read(&value)?,
            series: numbers(&value, "series")?,
            ending: PackingStopReason::read(
                &value,
                &[B::OVER, PackingStopReason::Time, PackingStopReason::Steps],
            )?,
        }))
    }

    /// Whether the state has these numbers of spheres and walls, forces only between them, and began with what the scene
    /// begins with now.
    pub fn fits(
        &self,
        (spheres, walls, has_mesh): (usize, usize, bool),
        origin: &str,
    ) -> Result<(), CheckpointError> {
        if self.origin != origin {
            return Err(CheckpointError::Scene {
                key: "initial_state".into(),
                kept: "of other spheres".into(),
                given: "changed since".into(),
            });
        }
        if self.frozen.fits(spheres, walls, has_mesh) {
            Ok(())
        } else {
            Err(damaged("numbers of spheres"))
        }
    }

    /// As many lines of the series as the scene writes in the number of steps; columns that have come since are NaN.
    pub fn series(&self, to: RunLimits) -> Result<Vec<[f64; N]>, CheckpointError> {
        let steps = self.frozen.steps;
        let last = self.ending.is_some() && !steps.is_multiple_of(to.samples);
        let lines = 1 + steps / to.samples + u64::from(last);
        let is_whole = |columns: &&usize| {
            (**columns as u64).checked_mul(lines) == Some(self.series.len() as u64)
        };
        let columns = [N, B::FORMER_COLUMNS];
        let columns = columns.iter().find(is_whole);
        let &columns = columns.ok_or_else(|| damaged("series"))?;
        let line =
            |numbers: &[f64]| array::from_fn(|i| numbers.get(i).copied().unwrap_or(f64::NAN));
        Ok(self.series.chunks(columns).map(line).collect())
    }
}
