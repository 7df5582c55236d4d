//! Checkpoint files: the complete state of a run, from which it continues with identical bits.

use super::blocked::Window;
use super::compaction::{COLUMNS, Ending};
use crate::packing::{Frozen, Shape, Stress, Totals};
use crate::record::kept::{damaged, groups, hex, numbers, opened, same_scene};
use crate::record::{CheckpointError, sealed};
use crate::scene::PowderScene;
use nalgebra::Matrix3;
use serde_json::{Map, Value};

/// Version of the format.
const VERSION: u64 = 3;
/// First key of a checkpoint file.
const NAME: &str = "tribos_compaction";
/// Length of a window.
const WINDOW: usize = 24;

/// State of a run between two steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint {
    pub frozen: Frozen,
    pub window: Window,
    /// The last complete window, with the piston's height at its end.
    pub complete: Option<(Window, f64)>,
    pub totals: Totals,
    pub series: Vec<[f64; COLUMNS.len()]>,
    /// Why the run ended, if it has.
    pub ending: Option<Ending>,
}

impl Checkpoint {
    /// Text of the checkpoint file.
    pub fn text(&self, scene: &PowderScene, shape: &Shape) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
        map.insert("scene".into(), scene.json());
        // Read by runs that start from this state.
        shape.put(&mut map);
        self.frozen.put(&mut map);
        let mut put = |name: &str, numbers: Vec<f64>| {
            map.insert(name.into(), hex(&numbers).into());
        };
        put("window", window_numbers(&self.window).to_vec());
        let complete = self
            .complete
            .iter()
            .flat_map(|(window, height)| window_numbers(window).into_iter().chain([*height]));
        put("complete_window", complete.collect());
        put("series", self.series.iter().flatten().copied().collect());
        self.totals.put(&mut map);
        map.insert("ending".into(), self.ending.map(Ending::name).into());
        sealed(map)
    }

    /// Reads a checkpoint of the same scene.
    pub fn read(text: &str, scene: &PowderScene) -> Result<Self, CheckpointError> {
        let value = opened(text, NAME, VERSION)?;
        same_scene(&value["scene"], &scene.json())?;
        let complete = numbers(&value, "complete_window")?;
        Ok(Self {
            frozen: Frozen::read(&value)?,
            window: window(&numbers(&value, "window")?).ok_or_else(|| damaged("window"))?,
            complete: match complete.split_last() {
                None => None,
                Some((height, numbers)) => {
                    let window = window(numbers).ok_or_else(|| damaged("complete_window"))?;
                    Some((window, *height))
                }
            },
            totals: Totals::read(&value)?,
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

    /// Whether the state has this many spheres, forces only between them, and as many rows of the series
    /// as the scene writes in its number of steps.
    pub fn fits(&self, spheres: usize, samples: u64) -> Result<(), CheckpointError> {
        let frozen = &self.frozen;
        let last = self.ending.is_some() && !frozen.steps.is_multiple_of(samples);
        let lines = 1 + frozen.steps / samples + u64::from(last);
        if self.series.len() as u64 != lines {
            return Err(damaged("series"));
        }
        if frozen.fits(spheres, 2) {
            Ok(())
        } else {
            Err(damaged("numbers of spheres"))
        }
    }
}

fn window_numbers(window: &Window) -> [f64; WINDOW] {
    let mut numbers = [0.0; WINDOW];
    let head = [window.steps as f64, window.time, window.start];
    let stress = [&window.stress.plus, &window.stress.minus];
    let all = head
        .into_iter()
        .chain(window.forces)
        .chain(stress.into_iter().flat_map(|tensor| tensor.iter().copied()));
    for (number, value) in numbers.iter_mut().zip(all) {
        *number = value;
    }
    numbers
}

fn window(numbers: &[f64]) -> Option<Window> {
    let numbers = <&[f64; WINDOW]>::try_from(numbers).ok()?;
    let tensor = |start: usize| Matrix3::from_column_slice(&numbers[start..start + 9]);
    Some(Window {
        steps: numbers[0] as u64,
        time: numbers[1],
        start: numbers[2],
        forces: [numbers[3], numbers[4], numbers[5]],
        stress: Stress {
            plus: tensor(6),
            minus: tensor(15),
        },
    })
}
