//! Spheres and their histories in a checkpoint.
//!
//! Events are not stored: their times follow from the spheres alone, to the same bits.

use super::body::Body;
use super::impact::{Impact, Motion};
use super::spheres::{HardSpheres, Totals};
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::{damaged, groups, hex, numbers};

/// Numbers of a sphere and of the totals.
const BODY: usize = 14;
const TOTALS: usize = 8;

/// The state of hard spheres.
#[derive(Clone, Debug, PartialEq)]
#[doc(hidden)]
pub struct Stored {
    bodies: Vec<Body>,
    totals: Totals,
}

impl HardSpheres {
    /// The state from which [`thawed`](Self::thawed) goes on with the same bits.
    #[doc(hidden)]
    pub fn freeze(&self) -> Stored {
        Stored {
            bodies: self.bodies.clone(),
            totals: self.totals,
        }
    }

    /// Spheres that go on from a stored state.
    #[doc(hidden)]
    pub fn restore(stored: Stored, length: f64, law: Impact, contact_time: f64) -> Self {
        Self::of(length, law, contact_time, stored.bodies, stored.totals)
    }
}

impl Stored {
    /// Adds the state to a checkpoint.
    pub fn put(&self, map: &mut Map<String, Value>) {
        let bodies: Vec<f64> = self.bodies.iter().flat_map(body_numbers).collect();
        map.insert("spheres".into(), hex(&bodies).into());
        let totals = &self.totals;
        let totals = [
            totals.time,
            totals.collisions as f64,
            totals.lost,
            totals.virial,
            totals.cured as f64,
            totals.watch.0 as f64,
            totals.watch.1,
            totals.still,
        ];
        map.insert("totals".into(), hex(&totals).into());
    }

    /// Reads the state of this many spheres from a checkpoint.
    pub fn read(value: &Value, spheres: usize) -> Result<Self, CheckpointError> {
        let bodies: Option<Vec<Body>> = groups(value, "spheres")?.iter().map(body).collect();
        let bodies = bodies.filter(|bodies| bodies.len() == spheres);
        let totals = numbers(value, "totals")?;
        let &[time, collisions, lost, virial, cured, from, since, still] =
            <&[f64; TOTALS]>::try_from(&totals[..]).map_err(|_| damaged("totals"))?;
        Ok(Self {
            bodies: bodies.ok_or_else(|| damaged("spheres"))?,
            totals: Totals {
                time,
                collisions: collisions as u64,
                lost,
                virial,
                cured: cured as u64,
                watch: (from as u64, since),
                still,
            },
        })
    }
}

fn body_numbers(body: &Body) -> [f64; BODY] {
    let (place, Motion { velocity, spin }) = (body.place, body.motion);
    let [x, y, z] = body.cell.map(f64::from);
    [
        place.x, place.y, place.z, velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z,
        body.time, body.last, x, y, z,
    ]
}

/// A sphere of a checkpoint; none if its numbers cannot be those of one.
fn body(numbers: &[f64; BODY]) -> Option<Body> {
    /// Cells are counted on between collisions, but never this far.
    const FAR: f64 = 1e9;
    let &[x, y, z, vx, vy, vz, wx, wy, wz, time, last, cx, cy, cz] = numbers;
    let cell = [cx, cy, cz];
    let finite = numbers[..10].iter().all(|number| number.is_finite());
    let whole = cell.iter().all(|c| c.fract() == 0.0 && c.abs() < FAR);
    (finite && whole && !last.is_nan()).then(|| Body {
        place: Vector3::new(x, y, z),
        motion: Motion {
            velocity: Vector3::new(vx, vy, vz),
            spin: Vector3::new(wx, wy, wz),
        },
        time,
        last,
        cell: cell.map(|c| c as i32),
        // Only differences to events of the same queue count.
        count: 0,
    })
}
