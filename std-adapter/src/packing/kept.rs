//! Checkpoint files of a run: its complete state, from which it continues with identical bits.

use super::body::{Body, Bounds, Ending};
use super::{Frozen, Totals};
use crate::record::CheckpointError;
use crate::record::kept::{damaged, groups, opened, same_scene};
use serde_json::Value;

/// State of a run between two steps.
#[derive(Debug)]
pub(crate) struct Kept<B: Body<N>, const N: usize> {
    pub frozen: Frozen,
    pub totals: Totals,
    pub watch: B::Watch,
    pub series: Vec<[f64; N]>,
    /// Why the run ended, if it has.
    pub ending: Option<B::Ending>,
}

impl<B: Body<N>, const N: usize> Kept<B, N> {
    /// Reads a checkpoint of the same scene, if there is one.
    pub fn read(text: Option<&str>, scene: &Value) -> Result<Option<Self>, CheckpointError> {
        let Some(text) = text else {
            return Ok(None);
        };
        let value = opened(text, B::FORMAT.0, B::FORMAT.1)?;
        same_scene(&value["scene"], scene)?;
        Ok(Some(Self {
            frozen: Frozen::read(&value)?,
            totals: Totals::read(&value)?,
            watch: B::read(&value)?,
            series: groups(&value, "series")?,
            ending: match &value["ending"] {
                Value::Null => None,
                name => {
                    let ending = name.as_str().and_then(B::Ending::named);
                    Some(ending.ok_or_else(|| damaged("ending"))?)
                }
            },
        }))
    }

    /// Whether the state has these numbers of spheres and walls, forces only between them, and as many lines
    /// of the series as the scene writes in its number of steps.
    pub fn fits(&self, spheres: usize, walls: usize, to: Bounds) -> Result<(), CheckpointError> {
        let steps = self.frozen.steps;
        let last = self.ending.is_some() && !steps.is_multiple_of(to.samples);
        let lines = 1 + steps / to.samples + u64::from(last);
        if self.series.len() as u64 != lines {
            return Err(damaged("series"));
        }
        if self.frozen.fits(spheres, walls) {
            Ok(())
        } else {
            Err(damaged("numbers of spheres"))
        }
    }
}
