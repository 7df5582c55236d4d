//! Contacts of a deposit.

use super::Deposit;
use nalgebra::Vector3;
use tribos_base::record::{ContactRow, Partner, Snapshot};

/// Number of the substrate among the walls.
pub const SUBSTRATE: u32 = 0;

impl Deposit {
    /// The contacts, one per sphere in the order of the spheres, without forces. The partner is the parent
    /// or the substrate.
    pub fn contacts(&self) -> Vec<ContactRow> {
        let spheres = self.positions.iter().zip(&self.parents).enumerate();
        let row = |(index, (place, parent)): (usize, (&Vector3<f64>, &Option<u32>))| {
            let (b, way, reach) = match *parent {
                None => (Partner::Wall(SUBSTRATE), -Vector3::z() * place.z, 0.0),
                Some(b) => {
                    let way = self.space.displacement(place, &self.positions[b as usize]);
                    (Partner::Particle(b), way, self.radii[b as usize])
                }
            };
            ContactRow {
                a: index as u32,
                b,
                normal: way.normalize(),
                gap: way.norm() - self.radii[index] - reach,
                force: Vector3::zeros(),
                torque: Vector3::zeros(),
            }
        };
        spheres.map(row).collect()
    }

    /// The deposit with its [contacts](Self::contacts), ready for export.
    pub fn snapshot<'a>(&'a self, contacts: &'a [ContactRow]) -> Snapshot<'a> {
        Snapshot {
            time: 0.0,
            space: self.space,
            extents: [[0.0, self.width], [0.0, self.width], [0.0, self.height]],
            positions: &self.positions,
            radii: &self.radii,
            velocities: None,
            spins: None,
            species: None,
            materials: None,
            densities: None,
            contacts,
        }
    }
}
