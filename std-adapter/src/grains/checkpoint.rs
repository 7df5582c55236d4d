//! Checkpoint files: the complete state of a run, from which it continues with identical bits.

use super::measure::Line;
use super::run::Ending;
use crate::packing::{Frozen, Shape, Totals};
use crate::record::kept::{damaged, groups, hex, opened, same_scene};
use crate::record::{CheckpointError, sealed};
use crate::scene::GrainsScene;
use serde_json::{Map, Value};

/// Version of the format.
const VERSION: u64 = 2;
/// First key of a checkpoint file.
const NAME: &str = "tribos_grains";

/// State of a run between two steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint {
    pub frozen: Frozen,
    pub totals: Totals,
    /// Number of steps for which the grains have been slow.
    pub slow: u64,
    pub series: Vec<Line>,
    /// Why the run ended, if it has.
    pub ending: Option<Ending>,
}

impl Checkpoint {
    /// Text of the checkpoint file.
    pub fn text(&self, scene: &GrainsScene, shape: &Shape) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
        map.insert("scene".into(), scene.json());
        // Read by runs that start from this state.
        shape.put(&mut map);
        self.frozen.put(&mut map);
        self.totals.put(&mut map);
        map.insert("slow".into(), self.slow.into());
        let series: Vec<f64> = self.series.iter().flatten().copied().collect();
        map.insert("series".into(), hex(&series).into());
        map.insert("ending".into(), self.ending.map(Ending::name).into());
        sealed(map)
    }

    /// Reads a checkpoint of the same scene.
    pub fn read(text: &str, scene: &GrainsScene) -> Result<Self, CheckpointError> {
        let value = opened(text, NAME, VERSION)?;
        same_scene(&value["scene"], &scene.json())?;
        Ok(Self {
            frozen: Frozen::read(&value)?,
            totals: Totals::read(&value)?,
            slow: value["slow"].as_u64().ok_or_else(|| damaged("slow"))?,
            series: groups(&value, "series")?,
            ending: match &value["ending"] {
                Value::Null => None,
                name => {
                    let ending = name.as_str().and_then(Ending::named);
                    Some(ending.ok_or_else(|| damaged("ending"))?)
                }
            },
        })
    }

    /// Whether the state has these numbers of grains and walls, forces only between them, and as many
    /// lines of the series as the scene writes in its number of steps.
    pub fn fits(&self, [grains, walls]: [usize; 2], samples: u64) -> Result<(), CheckpointError> {
        let frozen = &self.frozen;
        let last = self.ending.is_some() && !frozen.steps.is_multiple_of(samples);
        let lines = 1 + frozen.steps / samples + u64::from(last);
        if self.series.len() as u64 != lines {
            return Err(damaged("series"));
        }
        if frozen.fits(grains, walls) {
            Ok(())
        } else {
            Err(damaged("numbers of grains"))
        }
    }
}
