//! Checkpoint files: the complete state of a run, from which it continues with identical bits.

use super::blocked::Window;
use super::compaction::{COLUMNS, Ending, Totals};
use super::packing::{Force, Forces};
use super::stress::Stress;
use crate::cd::EnergyBalance;
use crate::record::kept::{damaged, groups, hex, numbers, one, opened, places, same_scene, triple};
use crate::record::{CheckpointError, sealed};
use crate::scene::PowderScene;
use nalgebra::{Matrix3, Vector3};
use serde_json::{Map, Value};

/// Version of the format.
const VERSION: u64 = 3;
/// First key of a checkpoint file.
const NAME: &str = "tribos_compaction";
/// Lengths of a window, of the energy balance, and of a stored force with its bodies.
const WINDOW: usize = 24;
const BALANCE: usize = 10;
const FORCE: usize = 10;

/// Keys of the forces of pairs and at walls.
const FORCES: [&str; 2] = ["pair_forces", "wall_forces"];
const IMPACTS: [&str; 2] = ["pair_impacts", "wall_impacts"];

/// The state of a world independent of its contact modes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frozen {
    pub time: f64,
    pub steps: u64,
    pub positions: Vec<Vector3<f64>>,
    /// Velocities and spins.
    pub motions: Vec<[Vector3<f64>; 2]>,
    /// Positions and velocities of the walls.
    pub walls: Vec<(f64, Vector3<f64>)>,
    pub energy: EnergyBalance,
    /// Forces of lasting contacts.
    pub forces: Forces,
    /// Forces of the last step's impacts.
    pub impacts: Forces,
    pub awake: Vec<bool>,
    pub still: Vec<u8>,
}

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
    pub fn text(&self, scene: &PowderScene) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
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
        put("book", energy_numbers(&frozen.energy).to_vec());
        for (names, forces) in [(FORCES, &frozen.forces), (IMPACTS, &frozen.impacts)] {
            for (name, forces) in names.iter().zip(forces) {
                put(name, forces.iter().flat_map(force_numbers).collect());
            }
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
        for (name, steps) in [
            ("unmet", self.totals.unmet),
            ("solver_unmet", self.totals.solver_unmet),
            ("cut", self.totals.cut),
            ("impacts_unmet", self.totals.impacts_unmet),
        ] {
            map.insert(name.into(), steps.into());
        }
        let awake: String = frozen
            .awake
            .iter()
            .map(|&is| if is { '1' } else { '0' })
            .collect();
        map.insert("awake".into(), awake.into());
        map.insert("still".into(), frozen.still.clone().into());
        map.insert("ending".into(), self.ending.map(Ending::name).into());
        sealed(map)
    }

    /// Reads a checkpoint of the same scene.
    pub fn read(text: &str, scene: &PowderScene) -> Result<Self, CheckpointError> {
        let value = opened(text, NAME, VERSION)?;
        same_scene(&value["scene"], &scene.json())?;
        let whole = |name: &str| value[name].as_u64().ok_or_else(|| damaged(name));
        let forces = |name: &str| -> Result<Vec<_>, CheckpointError> {
            Ok(groups(&value, name)?.iter().map(force).collect())
        };
        let walls = groups(&value, "walls")?;
        let complete = numbers(&value, "complete_window")?;
        Ok(Self {
            frozen: Frozen {
                time: one(&value, "time")?,
                steps: whole("steps")?,
                positions: places(&value, "positions")?,
                motions: motions(&value)?,
                walls: walls
                    .into_iter()
                    .map(|[place, x, y, z]| (place, Vector3::new(x, y, z)))
                    .collect(),
                energy: energy(&numbers(&value, "book")?).ok_or_else(|| damaged("book"))?,
                forces: [forces(FORCES[0])?, forces(FORCES[1])?],
                impacts: [forces(IMPACTS[0])?, forces(IMPACTS[1])?],
                awake: awake(&value)?,
                still: still(&value)?,
            },
            window: window(&numbers(&value, "window")?).ok_or_else(|| damaged("window"))?,
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
                solver_unmet: whole("solver_unmet")?,
                cut: whole("cut")?,
                impacts_unmet: whole("impacts_unmet")?,
                wall_seconds: one(&value, "wall_seconds")?,
            },
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
        let lengths = [
            frozen.positions.len(),
            frozen.motions.len(),
            frozen.awake.len(),
            frozen.still.len(),
        ];
        let last = self.ending.is_some() && !frozen.steps.is_multiple_of(samples);
        let lines = 1 + frozen.steps / samples + u64::from(last);
        if self.series.len() as u64 != lines {
            return Err(damaged("series"));
        }
        let known = |body: u32| (body as usize) < spheres;
        let exist = |[pairs, walls]: &Forces| {
            pairs.iter().all(|([a, b], _)| known(*a) && known(*b))
                && walls.iter().all(|([a, wall], _)| known(*a) && *wall < 2)
        };
        let fits = lengths.iter().all(|&length| length == spheres)
            && frozen.walls.len() == 2
            && exist(&frozen.forces)
            && exist(&frozen.impacts);
        if fits {
            Ok(())
        } else {
            Err(damaged("numbers of spheres"))
        }
    }
}

/// Velocities and spins in pairs.
fn motions(value: &Value) -> Result<Vec<[Vector3<f64>; 2]>, CheckpointError> {
    match places(value, "motions")?.as_chunks() {
        (pairs, []) => Ok(pairs.to_vec()),
        _ => Err(damaged("motions")),
    }
}

/// One digit per sphere, 1 if it is awake.
fn awake(value: &Value) -> Result<Vec<bool>, CheckpointError> {
    let digits = value["awake"].as_str().ok_or_else(|| damaged("awake"))?;
    let is_awake = |byte| match byte {
        b'0' => Ok(false),
        b'1' => Ok(true),
        _ => Err(damaged("awake")),
    };
    digits.bytes().map(is_awake).collect()
}

/// Number of steps for which each sphere has been slow.
fn still(value: &Value) -> Result<Vec<u8>, CheckpointError> {
    let steps = value["still"].as_array().ok_or_else(|| damaged("still"))?;
    let small = |steps: &Value| u8::try_from(steps.as_u64()?).ok();
    let steps: Option<Vec<u8>> = steps.iter().map(small).collect();
    steps.ok_or_else(|| damaged("still"))
}

fn energy_numbers(energy: &EnergyBalance) -> [f64; BALANCE] {
    [
        energy.work,
        energy.normal,
        energy.sliding,
        energy.rolling,
        energy.torsion,
        energy.cohesion,
        energy.stilled,
        energy.kinetic,
        f64::from(u8::from(energy.kinetic_initial.is_some())),
        energy.kinetic_initial.unwrap_or(0.0),
    ]
}

fn energy(numbers: &[f64]) -> Option<EnergyBalance> {
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
    ] = <&[f64; BALANCE]>::try_from(numbers).ok()?;
    Some(EnergyBalance {
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

/// Numbers of bodies are far below 2⁵³ and therefore exact in f64.
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
