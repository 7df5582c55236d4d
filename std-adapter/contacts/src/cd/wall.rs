//! Walls and pistons.

use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::WallBody;

/// Largest deviation of a unit normal's length from 1.
pub(super) const UNIT: f64 = 1e-12;

/// A plane that bounds the space of the spheres: a wall, or a piston if it has a finite mass.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::cd::Wall;
/// let floor = Wall::fixed(Vector3::z(), 0.0);
/// assert_eq!(floor.plate.inv_mass, 0.0); // no force moves it
/// // A lid of 2 kg under its own weight, 10 cm above: its normal points down, into the box.
/// let lid = Wall::piston(-Vector3::z(), -0.1, 2.0, 2.0 * 9.81);
/// assert_eq!(lid.force * lid.plate.inv_mass, 9.81);
/// assert_eq!(lid.outward.dot(&Vector3::new(0.3, 0.2, 0.1)), lid.place); // a point of it
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Unit normal, into the space of the spheres.
    pub outward: Vector3<f64>,
    /// Position along the normal: points x of the plane have outward·x = place.
    pub place: f64,
    /// Velocity and inverse mass. A piston moves along its normal alone.
    pub plate: WallBody<f64>,
    /// Force on the plate along the normal; positive pushes it into the space of the spheres.
    pub force: f64,
    /// The part of the plane that is there; all of it if it is `None`.
    pub edges: Option<Rectangle>,
}

/// A rectangle of a plane: a thin sheet, which spheres meet on its two faces, at its edges and at its corners.
///
/// *Shape and units*: lengths. The edges stay where they are in the plane; the velocity of the plate along its
/// normal moves them with the plane. *Domain*: a wall that forces do not move. `along` is a unit vector in the
/// plane; along a periodic axis a rectangle has both ends or none, and is seen at its image nearest to the sphere.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::cd::{WorldMaterials, Rectangle, WorldSetup, Wall, World, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// // A shelf that ends at x = 0, with a ball of 1 cm that reaches over the end by 6 mm.
/// let open = [f64::NEG_INFINITY, f64::INFINITY];
/// let shelf = Rectangle { along: Vector3::x(), ends: [[f64::NEG_INFINITY, 0.0], open] };
/// let shelf = Wall { edges: Some(shelf), ..Wall::fixed(Vector3::z(), 0.0) };
/// let smooth = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::none());
/// let setup = WorldSetup::new(smooth).wall(shelf).gravity(Vector3::z() * -9.81);
/// let ball = Vector3::new(0.006, 0.0, 0.008);
/// let mut world = World::new(setup.sphere(ball, 0.01, solid(0.01, 2500.0)))?;
/// world.step()?;
/// // The edge pushes along the line to the centre: of gravity the part across that line is left.
/// let velocity = world.state().spheres[0].velocity;
/// assert!((velocity.x / -velocity.z - 0.8 / 0.6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Unit vector in the plane, perpendicular to two of the edges.
    pub along: Vector3<f64>,
    /// Low and high coordinate of these edges, along·x, and of the other two, (outward × along)·x: infinite for a
    /// side without an edge. Nothing is there if a low one exceeds its high one.
    pub ends: [[f64; 2]; 2],
}

/// A wall as a sphere sees it.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Facing {
    /// Unit vector from the nearest point of the wall to the centre.
    pub outward: Vector3<f64>,
    /// Distance of the centre from that point; infinite if nothing of the wall is there. Behind a wall without
    /// edges it is negative.
    pub height: f64,
}

impl Wall {
    /// The wall from a centre: the whole plane by its normal, a rectangle by its point nearest to the centre.
    #[doc(hidden)]
    pub fn facing(&self, space: &PeriodicBox, centre: &Vector3<f64>) -> Facing {
        match &self.edges {
            None => Facing {
                outward: self.outward,
                height: self.outward.dot(centre) - self.place,
            },
            Some(rectangle) => rectangle.facing((&self.outward, self.place), space, centre),
        }
    }

    /// A fixed wall.
    pub fn fixed(outward: Vector3<f64>, place: f64) -> Self {
        Self::piston(outward, place, f64::INFINITY, 0.0)
    }

    /// A plate of this mass at rest, loaded by `force`.
    pub fn piston(outward: Vector3<f64>, place: f64, mass: f64, force: f64) -> Self {
        Self {
            outward,
            place,
            plate: WallBody {
                velocity: Vector3::zeros(),
                inv_mass: 1.0 / mass,
            },
            force,
            edges: None,
        }
    }
}

impl Rectangle {
    /// No part of a plane at all, for walls that are taken away.
    #[doc(hidden)]
    pub const NONE: Self = Self {
        along: Vector3::new(1.0, 0.0, 0.0),
        ends: [[f64::INFINITY, f64::NEG_INFINITY]; 2],
    };

    fn facing(
        &self,
        (outward, place): (&Vector3<f64>, f64),
        space: &PeriodicBox,
        centre: &Vector3<f64>,
    ) -> Facing {
        if self.ends.iter().any(|[low, high]| low > high) {
            return Facing {
                outward: *outward,
                height: f64::INFINITY,
            };
        }
        let axes = [self.along, outward.cross(&self.along)];
        let middles = self.ends.map(middle);
        let origin = outward * place + axes[0] * middles[0] + axes[1] * middles[1];
        let centre = space.displacement(&origin, centre);

        // Beyond an edge the nearest point lies on it.
        let height = outward.dot(&centre);
        let beyond = [0, 1].map(|axis: usize| {
            let [low, high] = self.ends[axis].map(|end| end - middles[axis]);
            outside(axes[axis].dot(&centre), [low, high])
        });
        let [along, across] = beyond;
        let from = outward * height + axes[0] * along + axes[1] * across;
        let distance = from.norm();
        Facing {
            // A centre in the sheet has no normal: the kernel refuses the distance of 0.
            outward: if distance > 0.0 {
                from / distance
            } else {
                *outward
            },
            height: distance,
        }
    }

    /// Whether the ends bound a rectangle of a plane with this normal in this space.
    pub(crate) fn fits(&self, outward: &Vector3<f64>, space: &PeriodicBox) -> bool {
        let is_unit = (self.along.norm() - 1.0).abs() <= UNIT;
        let axes = [self.along, outward.cross(&self.along)];
        let numbers = self.ends.iter().flatten().all(|end| !end.is_nan());
        // Half a plane has no image in a periodic cell.
        let repeats = space.lengths().map(|length| length.is_some());
        let is_seen = |(axis, ends): (&Vector3<f64>, &[f64; 2])| {
            let across = (0..3).any(|at| repeats[at] && axis[at] != 0.0);
            let infinite = ends.iter().filter(|end| end.is_infinite()).count();
            !across || infinite != 1
        };
        let is_whole = axes.iter().zip(&self.ends).all(is_seen);
        is_unit && self.along.dot(outward).abs() <= UNIT && numbers && is_whole
    }
}

/// Middle of two ends, or 0 where one is infinite.
fn middle([low, high]: [f64; 2]) -> f64 {
    let middle = 0.5 * (low + high);
    if middle.is_finite() { middle } else { 0.0 }
}

/// How far a coordinate lies beyond the ends: negative below the low one, 0 between them. NaN counts as between.
fn outside(x: f64, [low, high]: [f64; 2]) -> f64 {
    if x < low {
        x - low
    } else if x > high {
        x - high
    } else {
        0.0
    }
}
