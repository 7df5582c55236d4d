//! A mesh in its motion, as spheres see it.

use super::mesh::Mesh;
use super::wall::{Facing, UNIT};
use nalgebra::Vector3;
use std::sync::Arc;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::ContactBody;

/// A mesh in its motion: a constant velocity, and a rotation about an axis that moves along.
///
/// ```
/// use std::sync::Arc;
/// use tribos::cd::{Mesh, MovingMesh, WorldMaterials, WorldSetup, World, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// // A ball of 1 cm lies in a hole, a square of 1.2 cm, and touches the middles of its edges: 8 mm above.
/// let at = |x: f64, y: f64| Vector3::new(x, y, 0.0);
/// let quarter = |turn: fn(f64, f64) -> Vector3<f64>| {
///     let [a, b, c, d] = [turn(-0.006, 0.006), turn(0.006, 0.006), turn(0.03, 0.03), turn(-0.03, 0.03)];
///     [[a, b, c], [a, c, d]]
/// };
/// let sides = [quarter(|x, y| Vector3::new(x, y, 0.0)), quarter(|x, y| Vector3::new(y, -x, 0.0)),
///     quarter(|x, y| Vector3::new(-x, -y, 0.0)), quarter(|x, y| Vector3::new(-y, x, 0.0))];
/// let plate = MovingMesh::at_rest(Arc::new(Mesh::new(sides.concat())?));
/// let smooth = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::none());
/// let mut setup = WorldSetup::new(smooth).gravity(Vector3::z() * -9.81);
/// setup.mesh = Some(plate);
/// setup = setup.sphere(at(0.0, 0.0) + Vector3::z() * 0.009, 0.01, solid(0.01, 2500.0));
/// let mut world = World::new(setup)?;
/// while world.state().time < 0.2 {
///     world.step()?;
/// }
/// assert!((world.state().positions[0].z - 0.008).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct MovingMesh {
    /// The triangles where they are at time 0.
    pub mesh: Arc<Mesh>,
    /// Velocity of the axis.
    pub velocity: Vector3<f64>,
    /// Unit vector along the axis of the rotation.
    pub axis: Vector3<f64>,
    /// Rate of the rotation, right-handed about the axis.
    pub rate: f64,
    /// A point of the axis at time 0.
    pub centre: Vector3<f64>,
}

/// Where a mesh is at a time.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Pose<'a> {
    of: &'a MovingMesh,
    shift: Vector3<f64>,
    sin: f64,
    cos: f64,
}

/// A contact of a sphere with a mesh: its number, which it keeps on a flat part, at an edge or a corner.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Meeting {
    pub number: u32,
    pub facing: Facing,
}

/// A point of a mesh as a body: no impulse changes its motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(hidden)]
pub struct Surface {
    pub velocity: Vector3<f64>,
    pub spin: Vector3<f64>,
}

impl ContactBody<f64> for Surface {
    fn velocity(&self) -> Vector3<f64> {
        self.velocity
    }
    fn angular_velocity(&self) -> Vector3<f64> {
        self.spin
    }
    fn inv_mass_normal(&self) -> f64 {
        0.0
    }
    fn inv_mass_tangential(&self) -> f64 {
        0.0
    }
    fn inv_inertia(&self) -> f64 {
        0.0
    }
    fn apply_impulse(&mut self, _: f64, _: &Vector3<f64>, _: f64, _: &Vector3<f64>) {}
    fn apply_angular_impulse(&mut self, _: f64, _: &Vector3<f64>) {}
}

impl MovingMesh {
    /// A mesh that stands.
    pub fn at_rest(mesh: Arc<Mesh>) -> Self {
        let zero = Vector3::zeros();
        Self {
            mesh,
            velocity: zero,
            axis: Vector3::z(),
            rate: 0.0,
            centre: zero,
        }
    }

    /// Whether its motion is finite and its axis a unit vector.
    pub(crate) fn is_valid(&self) -> bool {
        let sum = self.velocity.norm() + self.centre.norm() + self.rate;
        sum.is_finite() && (self.axis.norm() - 1.0).abs() <= UNIT
    }

    /// Where it is at a time.
    #[doc(hidden)]
    pub fn at(&self, time: f64) -> Pose<'_> {
        let (sin, cos) = match self.rate {
            0.0 => (0.0, 1.0),
            rate => libm::sincos(rate * time),
        };
        Pose {
            of: self,
            shift: self.velocity * time,
            sin,
            cos,
        }
    }

    /// Largest speed of any of its points.
    pub(crate) fn fastest(&self) -> f64 {
        if self.rate == 0.0 {
            return self.velocity.norm();
        }
        let arm = |corner: &Vector3<f64>| self.axis.cross(&(corner - self.centre)).norm();
        let longest = self.mesh.grid.corners().map(|corner| arm(&corner));
        self.velocity.norm() + self.rate.abs() * longest.into_iter().fold(0.0, f64::max)
    }
}

impl Pose<'_> {
    /// A vector of space in the frame of the mesh.
    fn inward(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.turned(v, -self.sin)
    }

    /// A vector of that frame in space.
    fn outward(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.turned(v, self.sin)
    }

    fn turned(&self, v: &Vector3<f64>, sin: f64) -> Vector3<f64> {
        if self.of.rate == 0.0 {
            return *v;
        }
        let axis = &self.of.axis;
        v * self.cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - self.cos))
    }

    /// A point of space in the frame of the mesh.
    fn seen(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let moved = x - self.shift;
        if self.of.rate == 0.0 {
            return moved;
        }
        self.of.centre + self.inward(&(moved - self.of.centre))
    }

    /// The centre and its images that may see the mesh within a distance, in its frame.
    fn images(&self, space: &PeriodicBox, centre: &Vector3<f64>) -> Vec<Vector3<f64>> {
        let periods = space.lengths();
        if periods == [None; 3] {
            return vec![self.seen(centre)];
        }
        // The image nearest to the middle of the mesh, and those beside it.
        let middle = self.of.centre
            + self.shift
            + self.outward(&(self.of.mesh.grid.middle() - self.of.centre));
        let near = middle + space.displacement(&middle, centre);
        let mut all = vec![near];
        for (axis, period) in periods.into_iter().enumerate() {
            let Some(period) = period else { continue };
            for at in 0..all.len() {
                for side in [-period, period] {
                    let mut image = all[at];
                    image[axis] += side;
                    all.push(image);
                }
            }
        }
        all.iter().map(|image| self.seen(image)).collect()
    }

    /// Contacts of a sphere with this centre up to a distance from it, in ascending order of their numbers.
    #[doc(hidden)]
    pub fn meetings(
        &self,
        space: &PeriodicBox,
        centre: &Vector3<f64>,
        within: f64,
    ) -> Vec<Meeting> {
        let mesh = &self.of.mesh;
        let mut all = mesh.nearest(&self.images(space, centre), within);
        // Of the images at which a part is met twice the nearest counts.
        all.sort_by(|a, b| {
            a.number
                .cmp(&b.number)
                .then(a.facing.height.total_cmp(&b.facing.height))
        });
        all.dedup_by_key(|meeting| meeting.number);
        for meeting in &mut all {
            meeting.facing.outward = self.outward(&meeting.facing.outward);
        }
        all
    }

    /// The contact of this number as a centre sees it; `None` if there is no such triangle.
    #[doc(hidden)]
    pub fn facing(
        &self,
        number: u32,
        space: &PeriodicBox,
        centre: &Vector3<f64>,
    ) -> Option<Facing> {
        let images = self.images(space, centre).into_iter();
        let facings = images.filter_map(|image| self.of.mesh.facing(number, &image));
        let nearest = facings.min_by(|a, b| a.height.total_cmp(&b.height))?;
        Some(Facing {
            outward: self.outward(&nearest.outward),
            ..nearest
        })
    }

    /// Motion of the mesh at a point of space, by its image nearest to the axis.
    #[doc(hidden)]
    pub fn surface(&self, space: &PeriodicBox, point: &Vector3<f64>) -> Surface {
        let spin = self.of.axis * self.of.rate;
        let arm = space.displacement(&self.centre(), point);
        Surface {
            velocity: self.of.velocity + spin.cross(&arm),
            spin,
        }
    }

    /// Current place of the point about which the torque is taken.
    #[doc(hidden)]
    pub fn centre(&self) -> Vector3<f64> {
        self.of.centre + self.shift
    }
}
