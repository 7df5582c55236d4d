//! Checkpoint files of a gas.

use super::engine::EngineCheckpoint;
use super::outcome::Row;
use crate::gas::scene::GasScene;
use crate::packing::PackingStopReason;
use serde_json::Map;
use tribos_base::record::checkpoint::{damaged, groups, hex, one, opened};
use tribos_base::record::{CheckpointError, with_digest};

/// Version of the format.
const VERSION: u64 = 1;
/// First key of a checkpoint file.
const NAME: &str = "tribos_gas";

/// State of a run between two steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint {
    pub medium: EngineCheckpoint,
    pub steps: u64,
    pub series: Vec<Row>,
    pub ending: Option<PackingStopReason>,
    pub wall_seconds: f64,
}

impl Checkpoint {
    /// Text of the checkpoint file.
    pub fn text(&self, scene: &GasScene) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
        map.insert("scene".into(), scene.json());
        self.medium.put(&mut map);
        let series: Vec<f64> = self.series.iter().flatten().copied().collect();
        map.insert("series".into(), hex(&series).into());
        map.insert("wall_seconds".into(), hex(&[self.wall_seconds]).into());
        map.insert("gas_steps".into(), self.steps.into());
        map.insert(
            "ending".into(),
            self.ending.map(PackingStopReason::name).into(),
        );
        with_digest(map)
    }

    /// Reads a checkpoint of the same scene.
    pub fn read(text: &str, scene: &GasScene) -> Result<Self, CheckpointError> {
        let value = opened::<GasScene>(text, (NAME, VERSION), &scene.json())?;
        let series: Vec<Row> = groups(&value, "series")?;
        if series.is_empty() {
            return Err(damaged("series"));
        }
        let steps = value["gas_steps"].as_u64();
        Ok(Self {
            medium: EngineCheckpoint::read(&value, scene)?,
            steps: steps.ok_or_else(|| damaged("gas_steps"))?,
            series,
            ending: PackingStopReason::read(
                &value,
                &[
                    PackingStopReason::Collisions,
                    PackingStopReason::Time,
                    PackingStopReason::Collapse,
                    PackingStopReason::Rest,
                ],
            )?,
            wall_seconds: one(&value, "wall_seconds")?,
        })
    }
}
