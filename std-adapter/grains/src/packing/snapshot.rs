//! The state of a packing, independent of its method and modes, and its part of a checkpoint.

use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, groups, hex, numbers, one, places, triple};
use tribos_contacts::cd::EnergyBalance;

/// Lengths of the energy balance, and of a stored force with its bodies.
const BALANCE: usize = 10;
const FORCE: usize = 10;

/// Keys of the forces of pairs and at walls.
const FORCES: [&str; 2] = ["pair_forces", "wall_forces"];
/// Key of what only soft spheres have: elastic energy now, energies at the start.
const SOFT: &str = "soft";
/// Key of what only a deforming box has.
const CELL: &str = "cell";
const IMPACTS: [&str; 2] = ["pair_impacts", "wall_impacts"];

/// The state of a world independent of its contact modes.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldSnapshot {
    pub time: f64,
    pub steps: u64,
    pub positions: Vec<Vector3<f64>>,
    /// Velocities and spins.
    pub motions: Vec<[Vector3<f64>; 2]>,
    /// Positions and velocities of the walls.
    pub walls: Vec<(f64, Vector3<f64>)>,
    /// Displacement of the images of a sheared cell, 0 without a shear.
    pub shear_offset: f64,
    pub energy: EnergyBalance,
    /// Forces of lasting contacts.
    pub forces: Forces,
    /// Forces of the last step's impacts; of soft spheres the springs, with the slope of the normal one.
    pub impacts: Forces,
    pub awake: Vec<bool>,
    pub still: Vec<u8>,
    /// Energies of springs and cohesion at the start, of soft spheres alone.
    pub origin: Option<[f64; 2]>,
    /// Lengths of a deforming box, 0 along an open axis, and the speeds at which they change.
    pub cell: Option<[[f64; 3]; 2]>,
}

/// Forces of pairs and at walls, with their bodies.
pub type Forces = [Vec<([u32; 2], Force)>; 2];

/// Force and torque of a contact, in all modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    pub normal: f64,
    pub sliding: Vector3<f64>,
    pub rolling: Vector3<f64>,
    pub torsion: f64,
}

impl WorldSnapshot {
    /// Adds the state to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        let mut put = |name: &str, numbers: Vec<f64>| {
            map.insert(name.into(), hex(&numbers).into());
        };
        put("time", vec![self.time]);
        put(
            "positions",
            self.positions.iter().flat_map(triple).collect(),
        );
        put(
            "motions",
            self.motions.iter().flatten().flat_map(triple).collect(),
        );
        let wall =
            |(place, velocity): &(f64, Vector3<f64>)| [*place, velocity.x, velocity.y, velocity.z];
        put("walls", self.walls.iter().flat_map(wall).collect());
        if self.shear_offset != 0.0 {
            put("shear_offset", vec![self.shear_offset]);
        }
        put("book", energy_numbers(&self.energy).to_vec());
        if let Some(cell) = self.cell {
            put(CELL, cell.concat());
        }
        if let Some([elastic, cohesion]) = self.origin {
            put(SOFT, vec![self.energy.elastic, elastic, cohesion]);
        }
        for (names, forces) in [(FORCES, &self.forces), (IMPACTS, &self.impacts)] {
            for (name, forces) in names.iter().zip(forces) {
                put(name, forces.iter().flat_map(force_numbers).collect());
            }
        }
        map.insert("steps".into(), self.steps.into());
        let awake: String = self
            .awake
            .iter()
            .map(|&is| if is { '1' } else { '0' })
            .collect();
        map.insert("awake".into(), awake.into());
        map.insert("still".into(), self.still.clone().into());
    }

    /// Reads the state from a checkpoint.
    pub fn read(value: &Value) -> Result<Self, CheckpointError> {
        let steps = value["steps"].as_u64().ok_or_else(|| damaged("steps"))?;
        let forces = |name: &str| -> Result<Vec<_>, CheckpointError> {
            Ok(groups(value, name)?.iter().map(force).collect())
        };
        let walls = groups(value, "walls")?;
        let soft: Option<[f64; 3]> = match &value[SOFT] {
            Value::Null => None,
            _ => {
                let numbers = numbers(value, SOFT)?;
                Some(<[f64; 3]>::try_from(numbers).map_err(|_| damaged(SOFT))?)
            }
        };
        Ok(Self {
            time: one(value, "time")?,
            steps,
            positions: places(value, "positions")?,
            motions: motions(value)?,
            walls: walls
                .into_iter()
                .map(|[place, x, y, z]| (place, Vector3::new(x, y, z)))
                .collect(),
            shear_offset: match &value["shear_offset"] {
                Value::Null => 0.0,
                _ => one(value, "shear_offset")?,
            },
            energy: EnergyBalance {
                elastic: soft.map_or(0.0, |[elastic, ..]| elastic),
                ..energy(&numbers(value, "book")?).ok_or_else(|| damaged("book"))?
            },
            forces: [forces(FORCES[0])?, forces(FORCES[1])?],
            impacts: [forces(IMPACTS[0])?, forces(IMPACTS[1])?],
            awake: awake(value)?,
            still: still(value)?,
            origin: soft.map(|[_, elastic, cohesion]| [elastic, cohesion]),
            cell: match &value[CELL] {
                Value::Null => None,
                _ => {
                    let numbers = <[f64; 6]>::try_from(numbers(value, CELL)?);
                    let [x, y, z, along, across, up] = numbers.map_err(|_| damaged(CELL))?;
                    Some([[x, y, z], [along, across, up]])
                }
            },
        })
    }

    /// Whether the state has these numbers of spheres and walls, and forces only between them, or at a mesh.
    pub fn fits(&self, spheres: usize, walls: usize, has_mesh: bool) -> bool {
        let lengths = [
            self.positions.len(),
            self.motions.len(),
            self.awake.len(),
            self.still.len(),
        ];
        let known = |body: u32| (body as usize) < spheres;
        let exist = |[pairs, plates]: &Forces| {
            pairs.iter().all(|([a, b], _)| known(*a) && known(*b))
                && plates
                    .iter()
                    .all(|([a, wall], _)| known(*a) && (has_mesh || (*wall as usize) < walls))
        };
        lengths.iter().all(|&length| length == spheres)
            && self.walls.len() == walls
            && exist(&self.forces)
            && exist(&self.impacts)
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
        elastic: 0.0,
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
