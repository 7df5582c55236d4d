//! The state of many particles at one time, the input of exports.

use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// Particles and contacts at one time, borrowed. Any consistent units.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::record::{Snapshot, SnapshotError};
/// use tribos::space::PeriodicBox;
/// let pair = Snapshot {
///     time: 0.0,
///     space: PeriodicBox::OPEN,
///     extents: [[-1.0, 3.0], [-1.0, 1.0], [-1.0, 1.0]],
///     positions: &[Vector3::zeros(), Vector3::x() * 2.0],
///     radii: &[1.0; 2],
///     velocities: None,
///     spins: None,
///     species: None,
///     materials: None,
///     densities: None,
///     contacts: &[],
/// };
/// assert_eq!(pair.check(), Ok(()));
/// let short = Snapshot { radii: &[1.0], ..pair };
/// assert_eq!(
///     short.check(),
///     Err(SnapshotError::Lengths { name: "radii", positions: 2, given: 1 })
/// );
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// The time.
    pub time: f64,
    /// Periodic box; positions are wrapped into its cell.
    pub space: PeriodicBox,
    /// Ends of the drawn box along open axes; unused along periodic ones.
    pub extents: [[f64; 2]; 3],
    /// Centres.
    pub positions: &'a [Vector3<f64>],
    /// Radii.
    pub radii: &'a [f64],
    /// Velocities, if there are any.
    pub velocities: Option<&'a [Vector3<f64>]>,
    /// Angular velocities, if there are any.
    pub spins: Option<&'a [Vector3<f64>]>,
    /// Names of the species without blanks, `X` if absent.
    pub species: Option<&'a [&'a str]>,
    /// Numbers of the materials, from 1, if there are several.
    pub materials: Option<&'a [u8]>,
    /// Densities, if they are known.
    pub densities: Option<&'a [f64]>,
    /// Contacts.
    pub contacts: &'a [ContactRow],
}

/// One contact.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::record::{ContactRow, Partner};
/// // A ball that weighs 5 N, held by a slope of 3 in 4.
/// let held = ContactRow {
///     a: 0,
///     b: Partner::Wall(0),
///     normal: Vector3::new(-0.6, 0.0, -0.8),
///     gap: 0.0,
///     force: Vector3::new(0.0, 0.0, -5.0),
///     torque: Vector3::zeros(),
/// };
/// assert!((held.normal_force() - 4.0).abs() < 1e-14);
/// assert!((held.tangential_force() - 3.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactRow {
    /// A particle.
    pub a: u32,
    /// The other side of the contact.
    pub b: Partner,
    /// Unit vector from a to b.
    pub normal: Vector3<f64>,
    /// Distance of the surfaces, negative for overlap.
    pub gap: f64,
    /// Force on b; a component along the normal pushes, one against it pulls.
    pub force: Vector3<f64>,
    /// Torque on b at the contact.
    pub torque: Vector3<f64>,
}

/// The other side of a contact.
///
/// ```
/// use tribos::record::Partner;
/// assert_eq!(Partner::Particle(7).particle(), Some(7));
/// assert_eq!(Partner::Wall(7).particle(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partner {
    /// A particle.
    Particle(u32),
    /// A wall by its number.
    Wall(u32),
}

/// A snapshot that contradicts itself.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::{Snapshot, SnapshotError};
/// # use tribos::space::PeriodicBox;
/// # let nameless = Snapshot {
/// #     time: 0.0,
/// #     space: PeriodicBox::OPEN,
/// #     extents: [[-1.0, 1.0]; 3],
/// #     positions: &[Vector3::zeros()],
/// #     radii: &[1.0],
/// #     velocities: None,
/// #     spins: None,
/// #     species: None,
/// #     materials: None,
/// #     densities: None,
/// #     contacts: &[],
/// # };
/// // A blank would make two columns of the name.
/// let split = Snapshot { species: Some(&["He 3"]), ..nameless };
/// assert_eq!(
///     split.check(),
///     Err(SnapshotError::Species { particle: 0, given: "He 3".into() })
/// );
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SnapshotError {
    /// A list and the positions differ in length.
    #[error("{positions} positions need as many {name}, not {given}")]
    Lengths {
        /// Name of the list.
        name: &'static str,
        /// Number of positions.
        positions: usize,
        /// Length of the list.
        given: usize,
    },
    /// A contact refers to a particle that does not exist.
    #[error("contact {contact} names particle {particle}, but there are {positions}, from 0 on")]
    Contact {
        /// Index of the contact.
        contact: usize,
        /// The particle.
        particle: u32,
        /// Number of positions.
        positions: usize,
    },
    /// A species name is empty or contains blanks.
    #[error("particle {particle}: the species `{given}` must be one word")]
    Species {
        /// Index of the particle.
        particle: usize,
        /// The rejected value.
        given: String,
    },
}

impl Partner {
    /// The particle, unless this is a wall.
    pub fn particle(self) -> Option<u32> {
        match self {
            Self::Particle(index) => Some(index),
            Self::Wall(_) => None,
        }
    }
}

impl ContactRow {
    /// Force along the normal, positive for pressure.
    pub fn normal_force(&self) -> f64 {
        self.force.dot(&self.normal)
    }

    /// Magnitude of the force across the normal.
    pub fn tangential_force(&self) -> f64 {
        (self.force - self.normal * self.normal_force()).norm()
    }
}

impl Snapshot<'_> {
    /// Refuses lists of different lengths, unknown particles and names that are not single words.
    pub fn check(&self) -> Result<(), SnapshotError> {
        let positions = self.positions.len();
        for (name, given) in [
            ("radii", Some(self.radii.len())),
            ("velocities", self.velocities.map(<[_]>::len)),
            ("spins", self.spins.map(<[_]>::len)),
            ("species", self.species.map(<[_]>::len)),
            ("materials", self.materials.map(<[_]>::len)),
            ("densities", self.densities.map(<[_]>::len)),
        ] {
            if let Some(given) = given.filter(|&given| given != positions) {
                return Err(SnapshotError::Lengths {
                    name,
                    positions,
                    given,
                });
            }
        }
        for (contact, row) in self.contacts.iter().enumerate() {
            let unknown = |&index: &u32| index as usize >= positions;
            if let Some(particle) = row.particles().find(unknown) {
                return Err(SnapshotError::Contact {
                    contact,
                    particle,
                    positions,
                });
            }
        }
        let is_word = |name: &str| name.split_whitespace().eq([name]);
        let mut names = self.species.unwrap_or_default().iter().enumerate();
        match names.find(|(_, name)| !is_word(name)) {
            Some((particle, name)) => Err(SnapshotError::Species {
                particle,
                given: (*name).into(),
            }),
            None => Ok(()),
        }
    }

    /// Number of contacts of each particle, walls included.
    pub(super) fn coordination(&self) -> Vec<u32> {
        let mut counts = vec![0; self.positions.len()];
        for index in self.contacts.iter().flat_map(ContactRow::particles) {
            counts[index as usize] += 1;
        }
        counts
    }
}

impl ContactRow {
    /// The particles that touch.
    fn particles(&self) -> impl Iterator<Item = u32> + use<> {
        [Some(self.a), self.b.particle()].into_iter().flatten()
    }
}
