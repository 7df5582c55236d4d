//! Walls and pistons.

use nalgebra::Vector3;
use tribos_core::contact::Plate;

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
    pub plate: Plate<f64>,
    /// Force on the plate along the normal; positive pushes it into the space of the spheres.
    pub force: f64,
    /// Where the wall acts; everywhere if it is `None`.
    pub acts: Option<HalfSpace>,
}

/// The points x with direction·x ≥ from.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::cd::{HalfSpace, Wall};
/// // The inclined plane of a hopper, which ends at its outlet 0.2 m above the floor.
/// let slope = Vector3::new(0.6, 0.0, 0.8);
/// let outlet = HalfSpace { direction: Vector3::z(), from: 0.2 };
/// let plane = Wall { acts: Some(outlet), ..Wall::fixed(slope, 0.1) };
/// assert!(plane.acts_on(&Vector3::new(0.0, 0.0, 0.3)));
/// assert!(!plane.acts_on(&Vector3::new(0.0, 0.0, 0.1)));
/// assert!(Wall::fixed(slope, 0.1).acts_on(&Vector3::zeros()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// Normal of its border, into it.
    pub direction: Vector3<f64>,
    /// Position of its border along the normal; infinite for no point at all.
    pub from: f64,
}

impl Wall {
    /// Whether the wall acts on a sphere whose centre is here.
    pub fn acts_on(&self, centre: &Vector3<f64>) -> bool {
        self.acts
            .is_none_or(|half| half.direction.dot(centre) >= half.from)
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
            plate: Plate {
                velocity: Vector3::zeros(),
                inv_mass: 1.0 / mass,
            },
            force,
            acts: None,
        }
    }
}
