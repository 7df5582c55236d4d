//! Where a body touches its ground, and how rough it is.

use core::fmt;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::Ring;
use tribos_core::coupling::table::Coulomb;
use tribos_core::limit_surface::{FrictionSet, LimitSurface};
use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::patch::polygon::{PolygonError, polygon};
use tribos_core::planar::{Foot, FootError, PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};

/// Points of a polygon at most.
const POINTS: usize = 256;

/// A patch of Coulomb friction under a body, centred below its centre of mass.
///
/// The pressure is spread evenly: over a disk, along a ring, over a polygon.
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
pub struct Patch {
    mu: f32,
    shape: Shape,
}

#[derive(Clone, Debug)]
enum Shape {
    Disk { radius: f32 },
    Ring { radius: f32 },
    Polygon(Box<Foot<f32, NodeList<f32, POINTS>, POINTS>>),
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
        /// What was given.
        given: f32,
    },
    /// The radius is not positive and finite.
    Radius {
        /// What was given.
        given: f32,
    },
    /// The polygon has no inside, or too many corners.
    Polygon(PolygonError),
    /// The foot was refused.
    Foot(FootError),
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

    /// The foot of a box or a boot: corners in metres, around the point below the centre of mass.
    ///
    /// The first coordinate lies along the body's own x axis, the second across it, so that the
    /// normal, x and the second axis are right-handed. *Domain*: `mu` ≥ 0; at least 3 corners, one
    /// of which sees the whole inside; `divisions` of every edge such that 7 (corners − 2)
    /// `divisions`² ≤ 256. *Accuracy*: friction within 1.2 % (root mean square) with 56 points.
    pub fn polygon(mu: f32, corners: &[[f32; 2]], divisions: u32) -> Result<Self, PatchError> {
        let points = polygon(corners, divisions).map_err(PatchError::Polygon)?;
        let foot = Foot::new(points, 0.0).map_err(PatchError::Foot)?;
        Self::new(mu, Shape::Polygon(Box::new(foot)))
    }

    fn new(mu: f32, shape: Shape) -> Result<Self, PatchError> {
        if mu >= 0.0 && mu.is_finite() {
            Ok(Self { mu, shape })
        } else {
            Err(PatchError::Coefficient { given: mu })
        }
    }

    /// The coefficient of friction.
    pub fn mu(&self) -> f32 {
        self.mu
    }

    /// True if the patch has directions of its own.
    pub(crate) fn is_oriented(&self) -> bool {
        matches!(self.shape, Shape::Polygon(_))
    }

    /// The motion after `dt` under a load in newtons.
    pub(crate) fn step(
        &mut self,
        body: &PlanarBody<f32>,
        load: f32,
        twist: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<PlanarStep<f32>> {
        let limit = self.mu * load;
        Some(match &mut self.shape {
            Shape::Disk { radius } => {
                let set = LimitSurface::new(Coulomb, limit, *radius).ok()?;
                body.step(&set, twist, push, dt)
            }
            Shape::Ring { radius } => {
                let set = LimitSurface::new(Ring, limit, *radius).ok()?;
                body.step(&set, twist, push, dt)
            }
            Shape::Polygon(foot) => {
                foot.set_force_limit(limit).ok()?;
                body.step_on_foot(foot, twist, push, dt)
            }
        })
    }

    /// How much of what the patch can carry `friction` is, at most 1: by how far it could grow, for a
    /// polygon by the power that it takes from the motion `twist`.
    pub(crate) fn share(
        &self,
        load: f32,
        friction: &Wrench<f32>,
        twist: &Twist<f32>,
    ) -> Option<f32> {
        let limit = self.mu * load;
        let share = match &self.shape {
            Shape::Disk { radius } => LimitSurface::new(Coulomb, limit, *radius)
                .ok()?
                .gauge(friction),
            Shape::Ring { radius } => LimitSurface::new(Ring, limit, *radius)
                .ok()?
                .gauge(friction),
            Shape::Polygon(foot) => {
                let power = friction.force.dot(&twist.velocity) + friction.torque * twist.spin;
                -power / (limit * mean_speed(foot.patch(), twist))
            }
        };
        // Nothing resists nothing: no share.
        Some(if share > 0.0 { share.min(1.0) } else { 0.0 })
    }
}

/// The mean speed of the points, by weight.
fn mean_speed(points: &NodeList<f32, POINTS>, twist: &Twist<f32>) -> f32 {
    let of = |node: &Node<f32>| {
        let x = twist.velocity.x - twist.spin * node.y;
        let y = twist.velocity.y + twist.spin * node.x;
        node.weight * x.hypot(y)
    };
    points.nodes().iter().map(of).sum::<f32>() / points.total_weight()
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
            Self::Foot(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for PatchError {}
