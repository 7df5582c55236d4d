//! Checkpoints of tip runs.

use super::loop_work::{LoopWork, Totals, counts};
use super::monitor;
use super::shape::AtomRole;
use crate::md::system::State;
use crate::tip::scene::TipScene;
use serde_json::Map;
use tribos_base::record::checkpoint::{damaged, hex, numbers, opened, triple, vectors};
use tribos_base::record::{CheckpointError, with_digest};

/// Version of the format.
const VERSION: u64 = 3;
/// First key of the file.
const NAME: &str = "tribos_tip";

/// A run between two lines of its series.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint {
    pub state: State,
    /// Angles of the driven atoms and of each layer, in radians.
    pub angles: Vec<f64>,
    /// Work of the drive, in ε.
    pub work: f64,
    /// Heat that thermostats and damping took.
    pub heat: f64,
    /// Turning points of a slid tip.
    pub loops: LoopWork,
    /// Lines for averages.
    pub lines: Vec<Vec<f64>>,
    pub series: Vec<Vec<f64>>,
}

impl Checkpoint {
    /// The file.
    pub fn text(&self, scene: &TipScene) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
        map.insert("scene".into(), scene.json());
        map.insert("steps".into(), self.state.steps.into());
        let mut put = |name: &str, numbers: Vec<f64>| {
            map.insert(name.into(), hex(&numbers).into());
        };
        for (name, vectors) in [
            ("positions", &self.state.positions),
            ("velocities", &self.state.velocities),
            ("list", &self.state.reference),
        ] {
            put(name, vectors.iter().flat_map(triple).collect());
        }
        put(
            "thermostats",
            self.state.thermostats.iter().flatten().copied().collect(),
        );
        put("angles", self.angles.clone());
        put("work", vec![self.work]);
        put("heat", vec![self.heat]);
        let ends = self.loops.ends.iter();
        put(
            "ends",
            ends.flat_map(|end| [end.work, end.heat, end.energy])
                .collect(),
        );
        put("turns", self.loops.turns.clone());
        put("lines", self.lines.iter().flatten().copied().collect());
        put("series", self.series.iter().flatten().copied().collect());
        with_digest(map)
    }

    /// Reads a file of the same scene, of so many atoms and numbers in a line for averages and in one
    /// of the series.
    pub fn read(
        text: &str,
        scene: &TipScene,
        atoms: usize,
        [line_width, width]: [usize; 2],
    ) -> Result<Self, CheckpointError> {
        let value = opened::<TipScene>(text, (NAME, VERSION), &scene.json())?;
        let finite = |name: &str, count: usize| {
            let numbers = numbers(&value, name)?;
            if numbers.len() == count && numbers.iter().all(|number| number.is_finite()) {
                Ok(numbers)
            } else {
                Err(damaged(name))
            }
        };
        let places = |name: &str| Ok(vectors(&finite(name, 3 * atoms)?));
        let steps = value["steps"].as_u64().ok_or_else(|| damaged("steps"))?;
        let last: u64 = scene.stage_steps().total();
        if steps > last {
            return Err(damaged("steps"));
        }
        let table = |name: &str, width: usize, lines: u64| {
            let numbers = numbers(&value, name)?;
            let (lines_of, rest) = (numbers.chunks_exact(width), numbers.len() % width);
            if rest != 0 || lines_of.len() as u64 != lines {
                return Err(damaged(name));
            }
            Ok(lines_of.map(<[f64]>::to_vec).collect())
        };
        let [ends, turns] = counts(scene, steps);
        let thermostats = finite("thermostats", 2 * AtomRole::ALL.len())?;
        Ok(Self {
            state: State {
                steps,
                positions: places("positions")?,
                velocities: places("velocities")?,
                reference: places("list")?,
                thermostats: thermostats.as_chunks().0.to_vec(),
            },
            angles: finite("angles", 1 + scene.tip_layers)?,
            work: finite("work", 1)?.first().copied().unwrap_or_default(),
            heat: finite("heat", 1)?.first().copied().unwrap_or_default(),
            loops: LoopWork {
                ends: finite("ends", 3 * ends as usize)?
                    .as_chunks()
                    .0
                    .iter()
                    .map(|&[work, heat, energy]| Totals { work, heat, energy })
                    .collect(),
                turns: finite("turns", turns as usize)?,
            },
            lines: table("lines", line_width, monitor::lines(scene, steps))?,
            // One line at the start and one after every interval of steps.
            series: table("series", width, 1 + steps.div_ceil(scene.sample_every))?,
        })
    }
}
