//! Several patches under one rigid body, each with its share of the load.

use super::PatchError;
use crate::coupling::flat::PatchShape;
use crate::real::Real;
use nalgebra::Vector2;

/// A patch in the coordinates of the body, and what it carries.
///
/// ```
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::patch::feet::PatchPart;
/// // One blade of a sledge, with half of its load.
/// let runner = PatchPart { patch: Bar::new([-0.5_f64, 0.2], [0.5, 0.2])?, load: 0.5 }; // m
/// assert!(runner.load > 0.0);
/// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct PatchPart<R, P> {
    /// The patch.
    pub patch: P,
    /// Its share of the load in any unit, because only ratios count.
    pub load: R,
}

/// A body on several feet: one patch under dry friction.
///
/// Feet of different kinds have a common type as `&dyn PatchShape`. How the load is shared is the
/// caller's to know: statics gives it for three feet ([`super::nodes::Nodes::tripod`]).
///
/// *Units*: length. *Accuracy*: that of the feet times R over the radius of the smallest one, with R the
/// distance within which all lie, or that of the common centre from the origin if it is longer: places are
/// rounded in units of R (feet of 1e-6 m one metre from the origin: 1e-10). The torque of a body that hardly
/// turns has that of μN R, not of itself. Feet below 1e-6 R may have a limit surface whose search does not end, which is NaN:
/// they are points. *Cost*: that of all feet.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::patch::feet::{CompoundPatch, PatchPart};
/// use tribos_core::twist::Twist;
/// let runner = |y: f64| Bar::new([-0.5, y], [0.5, y]); // m
/// let runners = [
///     PatchPart { patch: runner(-0.2)?, load: 300.0 }, // N
///     PatchPart { patch: runner(0.2)?, load: 100.0 },
/// ];
/// let sledge = CompoundPatch::new(&runners)?;
/// assert!((sledge.centre().y + 0.1).abs() < 1e-16);
/// let friction = ShapeFriction::new(sledge, 0.05)?;
/// // Drawn straight on, the heavier side resists more.
/// let drag = friction.wrench(400.0, &Twist::new(1.0, 0.0, 0.0));
/// assert!((drag.force.x + 20.0).abs() < 1e-13 && (drag.torque + 20.0 * 0.1).abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompoundPatch<'a, R: Real, P> {
    feet: &'a [PatchPart<R, P>],
    total: R,
    centre: Vector2<R>,
    radius: R,
}

impl<'a, R: Real, P: PatchShape<R>> CompoundPatch<'a, R, P> {
    /// *Domain*: weights ≥ 0 of which at least one is positive, finite sum; finite distances.
    pub fn new(feet: &'a [PatchPart<R, P>]) -> Result<Self, PatchError> {
        let mut total = R::ZERO;
        for (index, foot) in feet.iter().enumerate() {
            total += foot.load;
            if !(foot.load >= R::ZERO && total.is_finite()) {
                let given = foot.load.to_f64();
                return Err(PatchError::NodeWeight { index, given });
            }
        }
        if total == R::ZERO {
            return Err(PatchError::Unloaded);
        }
        let mut centre = Vector2::new(R::ZERO, R::ZERO);
        for foot in feet {
            centre += foot.patch.centre() * (foot.load / total);
        }
        let mut radius = R::ZERO;
        for foot in feet.iter().filter(|foot| foot.load > R::ZERO) {
            let from = foot.patch.centre() - centre;
            let reach = from.x.hypot(from.y) + foot.patch.radius();
            if reach > radius || reach.is_nan() {
                radius = reach;
            }
        }
        if !(radius + centre.x + centre.y).is_finite() {
            let given = radius.to_f64();
            return Err(PatchError::Radius { given });
        }
        Ok(Self {
            feet,
            total,
            centre,
            radius,
        })
    }

    /// The common centre of pressure.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance from the centre of pressure within which all feet lie.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// The feet.
    pub fn feet(&self) -> &'a [PatchPart<R, P>] {
        self.feet
    }

    /// The feet about the common centre, in radii of all.
    pub(crate) fn placed(&self) -> impl Iterator<Item = PlacedPatch<'a, R, P>> + Clone {
        let (frame, total) = ((self.centre, self.radius), self.total);
        self.feet
            .iter()
            .map(move |foot| PlacedPatch::new(&foot.patch, frame, foot.load / total))
    }
}

/// One of several patches: its place and size in radii of all about the common centre, and its share of the load.
pub(crate) struct PlacedPatch<'a, R: Real, P> {
    pub(crate) patch: &'a P,
    pub(crate) at: Vector2<R>,
    pub(crate) scale: R,
    pub(crate) share: R,
}

impl<'a, R: Real, P: PatchShape<R>> PlacedPatch<'a, R, P> {
    /// A patch among others with this common centre and radius.
    pub(crate) fn new(patch: &'a P, (centre, radius): (Vector2<R>, R), share: R) -> Self {
        let from = patch.centre() - centre;
        Self {
            patch,
            at: Vector2::new(from.x / radius, from.y / radius),
            scale: patch.radius() / radius,
            share,
        }
    }
}
