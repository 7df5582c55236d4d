//! Spheres in a box as a file or a run has them.

use crate::packing::{PackingFormat, WorldSnapshot};
use nalgebra::Vector3;
use serde_json::Value;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::space::PeriodicBox;
use tribos_base::space::SpaceError;
use tribos_base::space::pairs::neighbours;

/// Spheres in a box, with contacts if they are known. Any consistent units.
///
/// ```
/// use tribos::measure::Assembly;
/// // Two touching spheres, 1 and 2 in radius, in a box that is open along z.
/// let text = "2\nLattice=\"20 0 0 0 20 0 0 0 9\" pbc=\"T T F\" \
///             Properties=species:S:1:pos:R:3:radius:R:1\nX 19 1 1 1\nX 2 1 1 2\n";
/// let mut pair = Assembly::parse("pair.xyz", text)?;
/// assert_eq!(pair.radii, [1.0, 2.0]);
/// assert_eq!(pair.space.lengths(), [Some(20.0), Some(20.0), None]);
/// pair.touch(0.0)?;
/// assert_eq!(pair.contacts.len(), 1); // across the border
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Assembly {
    /// The space, periodic or open along each axis.
    pub space: PeriodicBox,
    /// Low and high end along each axis: the box, or the outermost points of the spheres along open axes
    /// without a box.
    pub bounds: [[f64; 2]; 3],
    /// Whether the file says the box, or walls of a run are one.
    pub(crate) has_box: bool,
    /// Centres.
    pub positions: Vec<Vector3<f64>>,
    /// Radii.
    pub radii: Vec<f64>,
    /// Numbers of the materials, from 1; none if all spheres are of one.
    pub materials: Option<Vec<u8>>,
    /// Densities, if they are known.
    pub densities: Option<Vec<f64>>,
    /// Velocities, if they are known.
    pub velocities: Option<Vec<Vector3<f64>>>,
    /// Angular velocities, if they are known.
    pub spins: Option<Vec<Vector3<f64>>>,
    /// Time of the state, if it is known.
    pub time: Option<f64>,
    /// Contacts of spheres with each other and with walls.
    pub contacts: Vec<ContactRow>,
    /// What is known of the forces of the contacts.
    pub forces: KnownForces,
    /// The scene of the run that the spheres come from; null for files of other programs.
    pub scene: Value,
    /// Whether the periods are assumed: the file does not say which axes are periodic.
    pub(crate) is_assumed: bool,
    /// The format of the file, if they are of one.
    pub format: Option<PackingFormat>,
    /// What the reader left out of the file, or assumed.
    pub notes: Vec<String>,
    /// The complete state of a run.
    pub(crate) frozen: Option<WorldSnapshot>,
    /// Normals of the walls of that state.
    pub(crate) outward: Vec<Vector3<f64>>,
}

/// What is known of the forces of contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownForces {
    /// Forces and torques to the bit.
    Complete,
    /// Forces to 2⁻⁸ of each component, no torques.
    Rounded,
    /// Normal forces only.
    Normal,
    /// Nothing: the contacts are those of the geometry.
    Unknown,
}

impl Assembly {
    /// Spheres without contacts; open axes reach as far as the spheres.
    pub fn new(space: PeriodicBox, positions: Vec<Vector3<f64>>, radii: Vec<f64>) -> Self {
        let mut assembly = Self {
            space,
            bounds: [[0.0; 2]; 3],
            has_box: false,
            positions,
            radii,
            materials: None,
            densities: None,
            velocities: None,
            spins: None,
            time: None,
            contacts: Vec::new(),
            forces: KnownForces::Unknown,
            scene: Value::Null,
            is_assumed: false,
            format: None,
            notes: Vec::new(),
            frozen: None,
            outward: Vec::new(),
        };
        assembly.enclose();
        assembly
    }

    /// Sets the bounds to the periods, and along open axes to the outermost points of the spheres.
    pub(crate) fn enclose(&mut self) {
        for axis in 0..3 {
            self.bounds[axis] = match self.space.lengths()[axis] {
                Some(length) => [0.0, length],
                None => self.extent(axis),
            };
        }
    }

    /// Outermost points of the spheres along an axis.
    pub(crate) fn extent(&self, axis: usize) -> [f64; 2] {
        let spheres = self.positions.iter().zip(&self.radii);
        let ends = spheres.map(|(place, radius)| [place[axis] - radius, place[axis] + radius]);
        let all = ends.reduce(|[low, high], [l, h]| [low.min(l), high.max(h)]);
        all.unwrap_or([0.0; 2])
    }

    /// Replaces the contacts by all pairs of spheres whose gap is at most `gap`, without forces.
    ///
    /// *Domain*: `gap` finite; two diameters at most along every period.
    pub fn touch(&mut self, gap: f64) -> Result<(), SpaceError> {
        let pairs = neighbours(&self.space, &self.positions, &self.radii, gap.next_up())?;
        let row = |&[a, b]: &[u32; 2]| {
            let [i, j] = [a as usize, b as usize];
            let way = self
                .space
                .displacement(&self.positions[i], &self.positions[j]);
            ContactRow {
                a,
                b: Partner::Particle(b),
                normal: way.normalize(),
                gap: way.norm() - self.radii[i] - self.radii[j],
                force: Vector3::zeros(),
                torque: Vector3::zeros(),
            }
        };
        self.contacts = pairs.iter().map(row).collect();
        self.forces = KnownForces::Unknown;
        Ok(())
    }

    /// Volume of the box.
    pub fn volume(&self) -> f64 {
        self.bounds.iter().map(|[low, high]| high - low).product()
    }

    /// Mean radius.
    pub fn mean_radius(&self) -> f64 {
        self.radii.iter().sum::<f64>() / self.radii.len() as f64
    }

    /// The deepest overlap over the smaller radius of two spheres that count, with these.
    pub(crate) fn deepest(
        &self,
        counts: impl Fn(&&[u32; 2]) -> bool,
    ) -> Result<Option<(f64, [u32; 2])>, SpaceError> {
        let pairs = neighbours(&self.space, &self.positions, &self.radii, 0.0)?;
        let depth = |&[a, b]: &[u32; 2]| {
            let [i, j] = [a as usize, b as usize];
            let way = self
                .space
                .displacement(&self.positions[i], &self.positions[j]);
            let radii = [self.radii[i], self.radii[j]];
            let depth = radii[0] + radii[1] - way.norm();
            (depth / radii[0].min(radii[1]), [a, b])
        };
        Ok(pairs
            .iter()
            .filter(counts)
            .map(depth)
            .max_by(|a, b| f64::total_cmp(&a.0, &b.0)))
    }
}
