//! Where a patch is, and where its bonds are unstrained.

use crate::real::Real;
use crate::twist::{Displacement, Wrench};
use nalgebra::Vector2;

/// Place of a patch on the floor: its centre and its angle about the normal.
///
/// *Units*: length, radians. The angle counts whole turns: poses one turn apart differ.
///
/// ```
/// use tribos_core::presliding::Pose;
/// use tribos_core::twist::Displacement;
/// let before = Pose::new(1.0_f64, 2.0, 0.0); // m, m, rad
/// let after = before.moved(&Displacement::new(0.5, 0.0, 0.25));
/// assert_eq!(after.since(&before), Displacement::new(0.5, 0.0, 0.25));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<R: Real> {
    /// Position of the patch centre in the axes of the floor.
    pub position: Vector2<R>,
    /// Angle of the patch axes to those of the floor.
    pub angle: R,
}

/// The pose in which the bonds of a patch are unstrained: the state of presliding.
///
/// A patch that has just touched is anchored where it is.
///
/// ```
/// use tribos_core::presliding::{Anchor, Pose};
/// let touched = Anchor::at(Pose::new(1.0_f64, 2.0, 0.0)); // m, m, rad
/// let deflection = touched.deflection(&Pose::new(1.5, 2.0, 0.0));
/// assert_eq!([deflection.shift.x, deflection.turn], [0.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor<R: Real> {
    /// The pose without strain.
    pub pose: Pose<R>,
}

impl<R: Real> Pose<R> {
    /// From the position of the centre and the angle.
    #[inline]
    pub const fn new(x: R, y: R, angle: R) -> Self {
        Self {
            position: Vector2::new(x, y),
            angle,
        }
    }

    /// The displacement that leads from `other` to this pose, in the axes of the floor.
    #[inline]
    pub fn since(&self, other: &Self) -> Displacement<R> {
        Displacement {
            shift: self.position - other.position,
            turn: self.angle - other.angle,
        }
    }

    /// The pose after `by`, given in the axes of the floor.
    #[inline]
    #[must_use]
    pub fn moved(&self, by: &Displacement<R>) -> Self {
        Self {
            position: self.position + by.shift,
            angle: self.angle + by.turn,
        }
    }
}

impl<R: Real> Anchor<R> {
    /// Bonds that are unstrained in `pose`.
    #[inline]
    pub const fn at(pose: Pose<R>) -> Self {
        Self { pose }
    }

    /// Displacement of the bonds of a patch in `pose`, in the axes of the floor.
    #[inline]
    pub fn deflection(&self, pose: &Pose<R>) -> Displacement<R> {
        pose.since(&self.pose)
    }

    /// The anchor from which a patch in `pose` is displaced by `strain`.
    #[inline]
    pub fn with_deflection(pose: &Pose<R>, strain: &Displacement<R>) -> Self {
        Self::at(pose.moved(&-*strain))
    }
}

/// The axes of a patch that is turned against the floor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes<R> {
    cos: R,
    sin: R,
}

impl<R: Real> Axes<R> {
    /// Axes at an angle to those of the floor.
    #[inline]
    pub(crate) fn at(angle: R) -> Self {
        // Unturned patches are common and need no series.
        if angle == R::ZERO {
            return Self {
                cos: R::ONE,
                sin: R::ZERO,
            };
        }
        Self {
            cos: angle.cos(),
            sin: angle.sin(),
        }
    }

    #[inline]
    fn to_patch(self, v: &Vector2<R>) -> Vector2<R> {
        let Self { cos, sin } = self;
        Vector2::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x)
    }

    #[inline]
    pub(super) fn to_floor(self, v: &Vector2<R>) -> Vector2<R> {
        let Self { cos, sin } = self;
        Vector2::new(cos * v.x - sin * v.y, cos * v.y + sin * v.x)
    }

    /// A displacement in the axes of the patch.
    #[inline]
    pub(crate) fn displacement_to_patch(self, d: &Displacement<R>) -> Displacement<R> {
        Displacement {
            shift: self.to_patch(&d.shift),
            turn: d.turn,
        }
    }

    /// A displacement in the axes of the floor.
    #[inline]
    pub(crate) fn displacement_to_floor(self, d: &Displacement<R>) -> Displacement<R> {
        Displacement {
            shift: self.to_floor(&d.shift),
            turn: d.turn,
        }
    }

    /// A wrench in the axes of the patch.
    #[inline]
    pub(crate) fn wrench_to_patch(self, w: &Wrench<R>) -> Wrench<R> {
        Wrench {
            force: self.to_patch(&w.force),
            torque: w.torque,
        }
    }

    /// A wrench in the axes of the floor.
    #[inline]
    pub(crate) fn wrench_to_floor(self, w: &Wrench<R>) -> Wrench<R> {
        Wrench {
            force: self.to_floor(&w.force),
            torque: w.torque,
        }
    }
}
