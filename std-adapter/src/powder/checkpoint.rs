//! A run as a file: everything that it goes on from, to the same bits.

use super::blocked::Window;
use super::compaction::{COLUMNS, Ending, Totals};
use super::packing::Force;
use super::stress::Stress;
use crate::cd::Book;
use crate::record::CheckpointError;
use crate::record::kept::{damaged, hex, numbers, same_scene, triple, vectors};
use crate::scene::PowderScene;
use nalgebra::{Matrix3, Vector3};
use serde_json::{Map, Value};

/// Version of the format.
const VERSION: u64 = 1;
/// Numbers of a window, of the energy book, of a kept force with its bodies.
const WINDOW: usize = 24;
const BOOK: usize = 10;
const FORCE: usize = 10;

/// A state of a world without its types.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frozen {
    pub time: f64,
    pub steps: u64,
    pub positions: Vec<Vector3<f64>>,
    /// Velocity and spin.
    pub motions: Vec<[Vector3<f64>; 2]>,
    /// Place and velocity.
    pub walls: Vec<(f64, Vector3<f64>)>,
    pub book: Book,
    /// Pairs, walls.
    pub forces: [Vec<([u32; 2], Force)>; 2],
    pub awake: Vec<bool>,
    pub still: Vec<u8>,
}

/// A run between two steps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint {
    pub frozen: Frozen,
    pub window: Window,
    /// The last complete window with the piston's height at its end.
    pub complete: Option<(Window, f64)>,
    pub totals: Totals,
    pub series: Vec<[f64; COLUMNS.len()]>,
    /// Why it ended, if it has.
    pub ending: Option<Ending>,
}

impl Checkpoint {
    /// The file.
    pub fn text(&self, scene: &PowderScene) -> String {
        let mut map = Map::new();
        map.insert("tribos_compaction".into(), VERSION.into());
        map.insert("scene".into(), scene.json());
        let frozen = &self.frozen;
        let mut put = |name: &str, numbers: Vec<f64>| {
            map.insert(name.into(), hex(&numbers).into());
        };
        put("time", vec![frozen.time]);
        put(
            "positions",
            frozen.positions.iter().flat_map(triple).collect(),
        );
        put(
            "motions",
            frozen.motions.iter().flatten().flat_map(triple).collect(),
        );
        let wall =
            |(place, velocity): &(f64, Vector3<f64>)| [*place, velocity.x, velocity.y, velocity.z];
        put("walls", frozen.walls.iter().flat_map(wall).collect());
        put("book", book_numbers(&frozen.book).to_vec());
        for (name, forces) in ["pair_forces", "wall_forces"].iter().zip(&frozen.forces) {
            put(name, forces.iter().flat_map(force_numbers).collect());
        }
        put("window", window_numbers(&self.window).to_vec());
        let complete = self
            .complete
            .iter()
            .flat_map(|(window, height)| window_numbers(window).into_iter().chain([*height]));
        put("complete_window", complete.collect());
        put("wall_seconds", vec![self.totals.wall_seconds]);
        put("series", self.series.iter().flatten().copied().collect());
        map.insert("steps".into(), frozen.steps.into());
        map.insert("iterations".into(), self.totals.iterations.into());
        map.insert("unmet".into(), self.totals.unmet.into());
        let awake: String = frozen
            .awake
            .iter()
            .map(|&is| if is { '1' } else { '0' })
            .collect();
        map.insert("awake".into(), awake.into());
        map.insert("still".into(), frozen.still.clone().into());
        map.insert("ending".into(), self.ending.map(Ending::name).into());
        format!("{}\n", Value::Object(map))
    }

    /// Reads a file of the same scene.
    pub fn read(text: &str, scene: &PowderScene) -> Result<Self, CheckpointError> {
        let value: Value = serde_json::from_str(text)
            .map_err(|error| CheckpointError::Format(error.to_string()))?;
        if value["tribos_compaction"].as_u64() != Some(VERSION) {
            let message = format!("not version {VERSION} of a compaction");
            return Err(CheckpointError::Format(message));
        }
        same_scene(&value["scene"], &scene.json())?;
        let list = |name: &str| numbers(&value, name);
        let whole = |name: &str| value[name].as_u64().ok_or_else(|| damaged(name));
        let one = |name: &str| list(name)?.first().copied().ok_or_else(|| damaged(name));

        let motions = vectors(&list("motions")?);
        let walls = list("walls")?;
        let forces = [list("pair_forces")?, list("wall_forces")?];
        let complete = list("complete_window")?;
        let series = list("series")?;
        let awake = value["awake"].as_str().ok_or_else(|| damaged("awake"))?;
        let still = value["still"].as_array().ok_or_else(|| damaged("still"))?;
        let checkpoint = Self {
            frozen: Frozen {
                time: one("time")?,
                steps: whole("steps")?,
                positions: vectors(&list("positions")?),
                motions: motions.as_chunks().0.to_vec(),
                walls: walls
                    .as_chunks()
                    .0
                    .iter()
                    .map(|&[place, x, y, z]| (place, Vector3::new(x, y, z)))
                    .collect(),
                book: book(&list("book")?).ok_or_else(|| damaged("book"))?,
                forces: forces.map(|list| list.as_chunks().0.iter().map(force).collect()),
                awake: awake.bytes().map(|byte| byte == b'1').collect(),
                still: still
                    .iter()
                    .filter_map(|steps| u8::try_from(steps.as_u64()?).ok())
                    .collect(),
            },
            window: window(&list("window")?).ok_or_else(|| damaged("window"))?,
            complete: match complete.split_last() {
                None => None,
                Some((height, numbers)) => {
                    let window = window(numbers).ok_or_else(|| damaged("complete_window"))?;
                    Some((window, *height))
                }
            },
            totals: Totals {
                iterations: whole("iterations")?,
                unmet: whole("unmet")?,
                wall_seconds: one("wall_seconds")?,
            },
            series: series.as_chunks().0.to_vec(),
            ending: match value["ending"].as_str() {
                None => None,
                Some(name) => Some(Ending::named(name).ok_or_else(|| damaged("ending"))?),
            },
        };
        Ok(checkpoint)
    }

    /// Whether it holds this many spheres, and forces between them only.
    pub fn fits(&self, spheres: usize) -> Result<(), CheckpointError> {
        let frozen = &self.frozen;
        let lengths = [
            frozen.positions.len(),
            frozen.motions.len(),
            frozen.awake.len(),
            frozen.still.len(),
        ];
        let [pairs, walls] = &frozen.forces;
        let known = |body: u32| (body as usize) < spheres;
        let fits = lengths.iter().all(|&length| length == spheres)
            && frozen.walls.len() == 2
            && pairs.iter().all(|([a, b], _)| known(*a) && known(*b))
            && walls.iter().all(|([a, wall], _)| known(*a) && *wall < 2);
        if fits {
            Ok(())
        } else {
            Err(damaged("numbers of spheres"))
        }
    }
}

fn book_numbers(book: &Book) -> [f64; BOOK] {
    [
        book.work,
        book.normal,
        book.sliding,
        book.rolling,
        book.torsion,
        book.cohesion,
        book.stilled,
        book.kinetic,
        f64::from(u8::from(book.kinetic_initial.is_some())),
        book.kinetic_initial.unwrap_or(0.0),
    ]
}

fn book(numbers: &[f64]) -> Option<Book> {
    let &[
        work,
        normal,
        sliding,
        rolling,
        torsion,
        cohesion,
        stilled,
        kinetic,
        begun,
        initial,
    ] = <&[f64; BOOK]>::try_from(numbers).ok()?;
    Some(Book {
        work,
        normal,
        sliding,
        rolling,
        torsion,
        cohesion,
        stilled,
        kinetic,
        kinetic_initial: (begun == 1.0).then_some(initial),
    })
}

/// Numbers of bodies are far below 2⁵³: exact in f64.
fn force_numbers((bodies, force): &([u32; 2], Force)) -> [f64; FORCE] {
    let [a, b] = bodies.map(f64::from);
    let ([sx, sy, sz], [rx, ry, rz]) = (triple(&force.sliding), triple(&force.rolling));
    [a, b, force.normal, sx, sy, sz, rx, ry, rz, force.torsion]
}

fn force(&[a, b, normal, sx, sy, sz, rx, ry, rz, torsion]: &[f64; FORCE]) -> ([u32; 2], Force) {
    let force = Force {
        normal,
        sliding: Vector3::new(sx, sy, sz),
        rolling: Vector3::new(rx, ry, rz),
        torsion,
    };
    ([a as u32, b as u32], force)
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
