//! Contact patches: shape, position and coefficient of friction.

use crate::area::{Area, Element};
use core::fmt;
use rapier3d::math::Vector;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::Ring;
use tribos_core::coupling::table::Coulomb;
use tribos_core::limit_surface::{FrictionSet, LimitSurface, PatchSurface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::patch::polygon::polygon;
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};

/// Largest number of points of a polygon.
const POINTS: usize = 256;
/// Distance from the centre of mass, as a fraction of the radius, up to which a round patch counts as centred.
const CENTRED: f64 = 1e-3;
/// Points of a bar, where the body stands on several feet.
const ALONG: usize = 16;

/// A patch of Coulomb friction under a foot, centred below the origin of the foot's collider.
///
/// The pressure is uniform over a disk, along a ring or a bar, or over a polygon. A body may have several
/// feet, each a collider with its own patch: the engine determines how they share the load.
///
/// ```
/// use tribos_rapier::{Patch, PatchError};
/// let puck = Patch::disk(0.1, 0.04)?;
/// let cup = Patch::ring(0.3, 0.03)?;
/// let rectangle = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]; // m
/// let parcel = Patch::polygon(0.4, &rectangle, 2)?; // 7 · 2 · 2² = 56 points
/// assert_eq!([puck.mu(), cup.mu(), parcel.mu()], [0.1, 0.3, 0.4]);
/// # Ok::<(), PatchError>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Patch {
    mu: f32,
    /// Point of the collider's frame below which the patch is centred.
    center: Vector,
    shape: Shape,
}

#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
enum Shape {
    Disk {
        radius: f32,
    },
    Ring {
        radius: f32,
    },
    Polygon {
        corners: Vec<[f32; 2]>,
        /// Points with their shares of the load, for a body on several feet.
        points: Vec<[f32; 3]>,
    },
    Bar {
        half: f32,
    },
}

/// Why a patch was refused.
///
/// ```
/// use tribos_rapier::{Patch, PatchError};
/// assert_eq!(Patch::disk(-0.1, 0.04).err(), Some(PatchError::Coefficient { given: -0.1 }));
/// assert_eq!(Patch::ring(0.1, 0.0).err(), Some(PatchError::Radius { given: 0.0 }));
/// let line = Patch::polygon(0.1, &[[0.0, 0.0], [0.1, 0.0]], 2); // two corners
/// assert!(matches!(line, Err(PatchError::Polygon(_))));
/// let fine = Patch::polygon(0.1, &[[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], 7); // 343 points
/// assert!(matches!(fine, Err(PatchError::Polygon(_))));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchError {
    /// The coefficient of friction is negative, infinite or NaN.
    Coefficient {
        /// The rejected value.
        given: f32,
    },
    /// The radius, or the half length of a bar, is not positive and finite.
    Radius {
        /// The rejected value.
        given: f32,
    },
    /// The polygon has no interior, or too many corners.
    Polygon(tribos_core::patch::PatchError),
}

impl Patch {
    /// A full disk: pucks, checkers, bottle caps. *Domain*: `mu` ≥ 0, `radius` > 0 in metres.
    pub fn disk(mu: f32, radius: f32) -> Result<Self, PatchError> {
        let radius = valid_radius(radius)?;
        Self::new(mu, Shape::Disk { radius })
    }

    /// A thin ring: cups, curling stones, tubes. *Domain*: `mu` ≥ 0, `radius` > 0 in metres.
    pub fn ring(mu: f32, radius: f32) -> Result<Self, PatchError> {
        let radius = valid_radius(radius)?;
        Self::new(mu, Shape::Ring { radius })
    }

    /// A straight bar along the x axis of the foot's collider: a skate's blade, the edge of a tilted box.
    ///
    /// *Domain*: `mu` ≥ 0, `half_length` > 0 in metres. *Accuracy*: exact where the body stands on this foot
    /// alone; elsewhere 16 points stand for it.
    ///
    /// ```
    /// use tribos_rapier::{Patch, PatchError};
    /// assert_eq!(Patch::bar(0.02, 0.14)?.mu(), 0.02); // steel on ice
    /// assert_eq!(Patch::bar(0.02, 0.0).err(), Some(PatchError::Radius { given: 0.0 }));
    /// # Ok::<(), PatchError>(())
    /// ```
    pub fn bar(mu: f32, half_length: f32) -> Result<Self, PatchError> {
        let half = valid_radius(half_length)?;
        Self::new(mu, Shape::Bar { half })
    }

    /// The foot of a box or a boot: corners in metres, around the patch's centre.
    ///
    /// The first coordinate lies along the x axis of the foot's collider, the second across it, so that the
    /// normal, x and the second axis are right-handed. *Domain*: `mu` ≥ 0; at least 3 corners, one
    /// of which sees the whole inside; `divisions` of every edge such that 7 (corners − 2)
    /// `divisions`² ≤ 256. *Accuracy*: exact where the body stands on this foot alone; friction within
    /// 1.2 % (root mean square) with 56 points where it stands on several feet or on a ground that moves.
    pub fn polygon(mu: f32, corners: &[[f32; 2]], divisions: u32) -> Result<Self, PatchError> {
        let points: NodeList<f32, POINTS> =
            polygon(corners, divisions).map_err(PatchError::Polygon)?;
        let whole = points.total_weight();
        let point = |node: &Node<f32>| [node.x, node.y, node.weight / whole];
        let points = points.nodes().iter().map(point).collect();
        // Corners whose edges touch have points alone.
        let corners = match outline(corners.to_vec()) {
            Some(_) => corners.to_vec(),
            None => Vec::new(),
        };
        Self::new(mu, Shape::Polygon { corners, points })
    }

    /// The same patch centred below another point than the collider's origin, in metres in the
    /// collider's own frame: for shapes whose origin is not above the middle of the contact.
    ///
    /// ```
    /// use rapier3d::prelude::Vector;
    /// use tribos_rapier::Patch;
    /// // A table leg whose origin is at the rim of its foot.
    /// let leg = Patch::disk(0.4, 0.03)?.centered_at(Vector::new(0.03, 0.0, 0.0));
    /// assert_eq!(leg.center(), Vector::new(0.03, 0.0, 0.0));
    /// # Ok::<(), tribos_rapier::PatchError>(())
    /// ```
    pub fn centered_at(self, center: Vector) -> Self {
        Self { center, ..self }
    }

    /// The point of the collider's frame below which the patch is centred, in metres.
    pub fn center(&self) -> Vector {
        self.center
    }

    fn new(mu: f32, shape: Shape) -> Result<Self, PatchError> {
        if mu >= 0.0 && mu.is_finite() {
            Ok(Self {
                mu,
                center: Vector::ZERO,
                shape,
            })
        } else {
            Err(PatchError::Coefficient { given: mu })
        }
    }

    /// The coefficient of friction.
    pub fn mu(&self) -> f32 {
        self.mu
    }

    /// Whether the kernel's step of a body on this foot alone is exact, with the centre at `place` from
    /// the centre of mass: a polygon or a bar anywhere, a round patch in the middle.
    pub(crate) fn is_exact(&self, place: [f64; 2]) -> bool {
        let [x, y] = place;
        match &self.shape {
            Shape::Disk { radius } | Shape::Ring { radius } => {
                (x * x + y * y).sqrt() <= CENTRED * f64::from(*radius)
            }
            Shape::Polygon { corners, .. } => !corners.is_empty(),
            Shape::Bar { .. } => true,
        }
    }

    /// What friction carries of a body on this foot alone, about its centre of mass.
    fn set(&self, lying: &Lying) -> Option<Set> {
        let Lying { load, place, axis } = *lying;
        let limit = self.mu * load;
        let [c, s] = axis;
        let moved = |&[x, y]: &[f32; 2]| {
            let [x, y] = [x, y].map(f64::from);
            [
                (place[0] + c * x - s * y) as f32,
                (place[1] + s * x + c * y) as f32,
            ]
        };
        match &self.shape {
            Shape::Disk { radius } => {
                Some(Set::Disk(LimitSurface::new(Coulomb, limit, *radius).ok()?))
            }
            Shape::Ring { radius } => {
                Some(Set::Ring(LimitSurface::new(Ring, limit, *radius).ok()?))
            }
            Shape::Bar { half } => {
                let [from, to] = [[-half, 0.0], [*half, 0.0]].map(|end| moved(&end));
                let bar = Bar::new(from, to).ok()?;
                Some(Set::Bar(PatchSurface::new(bar, limit).ok()?))
            }
            Shape::Polygon { corners, .. } => {
                let patch = outline(corners.iter().map(moved).collect())?;
                Some(Set::Polygon(PatchSurface::new(patch, limit).ok()?))
            }
        }
    }

    /// The kernel's step of a body on this foot alone: the motion after `dt` under a load in newtons.
    pub(crate) fn step(
        &self,
        body: &PlanarBody<f32>,
        lying: &Lying,
        twist: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<PlanarStep<f32>> {
        Some(match self.set(lying)? {
            Set::Disk(set) => body.step(&set, twist, push, dt),
            Set::Ring(set) => body.step(&set, twist, push, dt),
            Set::Polygon(set) => body.step(&set, twist, push, dt),
            Set::Bar(set) => body.step(&set, twist, push, dt),
        })
    }

    /// `friction` as a fraction of the largest that this foot alone can carry, at most 1.
    pub(crate) fn share(&self, lying: &Lying, friction: &Wrench<f32>) -> Option<f32> {
        let gauge = match self.set(lying)? {
            Set::Disk(set) => set.gauge(friction),
            Set::Ring(set) => set.gauge(friction),
            Set::Polygon(set) => set.gauge(friction),
            Set::Bar(set) => set.gauge(friction),
        };
        // No friction under no load: no fraction.
        Some(if gauge > 0.0 { gauge.min(1.0) } else { 0.0 })
    }

    /// The elements of the patch under a load in newtons, labelled with the index of the foot: centre
    /// at `place` from the centre of mass, x axis along `axis` in the plane.
    pub(crate) fn elements(
        &self,
        foot: usize,
        place: [f64; 2],
        axis: [f64; 2],
        load: f32,
    ) -> Vec<Element> {
        let limit = f64::from(self.mu * load);
        let presses = limit > 0.0;
        if !presses {
            return Vec::new();
        }
        let one = |area: Area, place: [f64; 2], share: f32| Element {
            place,
            area,
            limit: limit * f64::from(share),
            foot,
        };
        let [c, s] = axis;
        let point = |&[x, y, share]: &[f32; 3]| {
            let [x, y] = [x, y].map(f64::from);
            let place = [place[0] + c * x - s * y, place[1] + s * x + c * y];
            one(Area::Point, place, share)
        };
        match &self.shape {
            Shape::Disk { radius } => vec![one(Area::Disk(f64::from(*radius)), place, 1.0)],
            Shape::Ring { radius } => vec![one(Area::Ring(f64::from(*radius)), place, 1.0)],
            Shape::Polygon { points, .. } => points.iter().map(point).collect(),
            Shape::Bar { half } => {
                let share = 1.0 / ALONG as f32;
                let at = |k: usize| [half * ((2 * k + 1) as f32 * share - 1.0), 0.0, share];
                (0..ALONG).map(|k| point(&at(k))).collect()
            }
        }
    }
}

/// How a foot lies under a body.
pub(crate) struct Lying {
    /// Load in newtons.
    pub(crate) load: f32,
    /// The foot's centre from the centre of mass, in the plane.
    pub(crate) place: [f64; 2],
    /// Direction of its x axis in the plane.
    pub(crate) axis: [f64; 2],
}

/// The exact limit surface of one foot.
enum Set {
    Disk(LimitSurface<f32, Coulomb>),
    Ring(LimitSurface<f32, Ring>),
    Polygon(PatchSurface<f32, Polygon<f32, Vec<Edge<f32>>>>),
    Bar(PatchSurface<f32, Bar<f32>>),
}

/// The patch with these corners, if no edges touch.
fn outline(corners: Vec<[f32; 2]>) -> Option<Polygon<f32, Vec<Edge<f32>>>> {
    let memory = vec![Edge::default(); corners.len()];
    Polygon::with_holes(&[&corners], memory).ok()
}

fn valid_radius(radius: f32) -> Result<f32, PatchError> {
    if radius > 0.0 && radius.is_finite() {
        Ok(radius)
    } else {
        Err(PatchError::Radius { given: radius })
    }
}

impl fmt::Display for PatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient { given } => write!(
                f,
                "the coefficient of friction must be finite and not negative, not {given}"
            ),
            Self::Radius { given } => {
                write!(f, "the radius must be positive and finite, not {given} m")
            }
            Self::Polygon(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for PatchError {}
