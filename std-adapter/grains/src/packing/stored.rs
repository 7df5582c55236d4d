//! The last state of a packing as a file, complete to the bit: spheres, walls, contacts, motion.

use super::{Kinds, WorldSnapshot};
use crate::gas::scene::GasScene;
use crate::grains::scene::GrainsScene;
use crate::powder::scene::PowderScene;
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::checkpoint::{damaged, groups, hex, numbers, of_other_body, triple};
use tribos_base::record::{CheckpointError, ContactRow, Partner, verified, with_digest};
use tribos_base::scene::table::Table;
use tribos_base::space::PeriodicBox;

/// Name of the file in the folder of a run.
pub const STATE: &str = "final-state.json";
/// First key of the file, and the version of its format.
const NAME: &str = "tribos_state";
const VERSION: u64 = 2;
/// Bodies whose checkpoints contain a state.
const BODIES: [&str; 2] = ["powder", "grains"];
/// Numbers of a stored contact: bodies, normal, gap, force, torque.
const CONTACT: usize = 12;

/// What a state consists of besides its motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Shape {
    pub space: PeriodicBox,
    pub radii: Vec<f64>,
    pub kinds: Kinds,
    /// Normals of the walls, into the space of the spheres.
    pub outward: Vec<Vector3<f64>>,
    pub contacts: Vec<ContactRow>,
}

/// A complete state with the scene that it came from.
#[derive(Clone, Debug)]
pub(crate) struct Stored {
    pub scene: Value,
    pub shape: Shape,
    pub frozen: WorldSnapshot,
}

impl Shape {
    /// Adds the shape to a checkpoint or a state.
    pub fn put(&self, map: &mut Map<String, Value>) {
        // No period is stored as 0.
        let periods = self.space.lengths().map(|length| length.unwrap_or(0.0));
        let contacts: Vec<f64> = self.contacts.iter().flat_map(contact_numbers).collect();
        let outward: Vec<f64> = self.outward.iter().flat_map(triple).collect();
        for (name, numbers) in [
            ("periods", &periods[..]),
            ("radii", &self.radii),
            ("outward", &outward),
            ("contacts", &contacts),
        ] {
            map.insert(name.into(), hex(numbers).into());
        }
        self.kinds.put(map);
    }

    fn read(value: &Value) -> Result<Self, CheckpointError> {
        let periods = numbers(value, "periods")?;
        let &[x, y, z] = periods.as_slice() else {
            return Err(damaged("periods"));
        };
        let period = |length: f64| (length != 0.0).then_some(length);
        let contacts = groups(value, "contacts")?;
        let radii = numbers(value, "radii")?;
        Ok(Self {
            space: PeriodicBox::new([x, y, z].map(period)).map_err(|_| damaged("periods"))?,
            kinds: Kinds::read(value, radii.len())?,
            radii,
            outward: groups(value, "outward")?
                .into_iter()
                .map(Vector3::from)
                .collect(),
            contacts: contacts.iter().map(contact).collect(),
        })
    }
}

impl Stored {
    /// Text of the file.
    pub fn text(&self) -> String {
        let mut map = Map::new();
        map.insert(NAME.into(), VERSION.into());
        map.insert("scene".into(), self.scene.clone());
        self.shape.put(&mut map);
        self.frozen.put(&mut map);
        with_digest(map)
    }

    /// Reads a state, or the state in a checkpoint of any kind.
    pub fn read(text: &str) -> Result<Self, CheckpointError> {
        let value = verified(text)
            .ok_or_else(|| CheckpointError::Format("its digest is not that of its bytes".into()))?;
        match value[NAME].as_u64() {
            Some(found) if found != VERSION => {
                return Err(CheckpointError::Version {
                    found,
                    read: VERSION,
                });
            }
            Some(_) => {}
            None if BODIES.iter().any(|body| value["scene"]["body"] == *body) => {}
            None => {
                let none = || CheckpointError::Format("there is no state of spheres".into());
                return Err(of_other_body(&value, &BODIES[0].into()).unwrap_or_else(none));
            }
        }
        let stored = Self {
            scene: scene(&value["scene"]),
            shape: Shape::read(&value)?,
            frozen: WorldSnapshot::read(&value)?,
        };
        let (spheres, walls) = (stored.shape.radii.len(), stored.shape.outward.len());
        let has_mesh = stored.scene["mesh"].is_string();
        let known = |row: &ContactRow| {
            let b = match row.b {
                Partner::Particle(b) => (b as usize) < spheres,
                Partner::Wall(wall) => has_mesh || (wall as usize) < walls,
            };
            b && (row.a as usize) < spheres
        };
        if stored.frozen.fits(spheres, walls, has_mesh) && stored.shape.contacts.iter().all(known) {
            Ok(stored)
        } else {
            Err(damaged("numbers of spheres"))
        }
    }
}

/// The scene of a file, by the present names of its keys.
pub(crate) fn scene(values: &Value) -> Value {
    match values["body"].as_str() {
        Some(PowderScene::BODY) => PowderScene::present(values),
        Some(GrainsScene::BODY) => GrainsScene::present(values),
        Some(GasScene::BODY) => GasScene::present(values),
        _ => values.clone(),
    }
}

/// Walls count down from −1, as in the exports of contacts.
fn contact_numbers(row: &ContactRow) -> [f64; CONTACT] {
    let b = match row.b {
        Partner::Particle(b) => f64::from(b),
        Partner::Wall(wall) => -1.0 - f64::from(wall),
    };
    let ([nx, ny, nz], [fx, fy, fz], [tx, ty, tz]) =
        (triple(&row.normal), triple(&row.force), triple(&row.torque));
    [
        f64::from(row.a),
        b,
        nx,
        ny,
        nz,
        row.gap,
        fx,
        fy,
        fz,
        tx,
        ty,
        tz,
    ]
}

fn contact(&[a, b, nx, ny, nz, gap, fx, fy, fz, tx, ty, tz]: &[f64; CONTACT]) -> ContactRow {
    ContactRow {
        a: a as u32,
        b: if b < 0.0 {
            Partner::Wall((-1.0 - b) as u32)
        } else {
            Partner::Particle(b as u32)
        },
        normal: Vector3::new(nx, ny, nz),
        gap,
        force: Vector3::new(fx, fy, fz),
        torque: Vector3::new(tx, ty, tz),
    }
}
