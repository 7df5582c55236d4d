//! The component that gives a collider an area of friction.

use crate::friction::PatchFriction;
use bevy::prelude::*;
use core::fmt;
use tribos_feet::{Footprint, FootprintError};

/// An area of Coulomb friction under a collider, for the contacts at which the ground is below it.
///
/// Insert it on the entity of the [`Collider`](avian3d::prelude::Collider): the body's own, or a child of the
/// body. A contact is the patch's if its normal, from the ground to the foot, is within 8° of
/// [`up`](Self::up). There `mu` replaces the engine's friction; other contacts of the collider, such as the
/// rim of a puck on a cushion, keep the engine's.
///
/// *Units*: metres, in the frame of the collider; a scale of the entity does not scale the patch. *Domain*:
/// the collider must belong to a dynamic body; on others the component has no effect.
///
/// ```
/// use tribos_bevy::{FrictionPatch, PatchError};
/// let puck = FrictionPatch::disk(0.1, 0.04)?;
/// let cup = FrictionPatch::ring(0.3, 0.03)?;
/// let rectangle = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]];
/// let parcel = FrictionPatch::polygon(0.4, &rectangle)?;
/// assert_eq!([puck.mu(), cup.mu(), parcel.mu()], [0.1, 0.3, 0.4]);
/// # Ok::<(), PatchError>(())
/// ```
#[derive(Component, Clone, Debug)]
#[require(PatchFriction)]
pub struct FrictionPatch {
    mu: f32,
    footprint: Footprint,
    center: Vec3,
    up: Dir3,
    along: Dir3,
}

/// Why a patch was refused.
///
/// ```
/// use tribos_bevy::{FrictionPatch, PatchError};
/// let refused = FrictionPatch::disk(-0.1, 0.04).err();
/// assert_eq!(refused, Some(PatchError::Coefficient { given: -0.1 }));
/// assert!(matches!(FrictionPatch::ring(0.1, 0.0), Err(PatchError::Footprint(_))));
/// assert!(matches!(FrictionPatch::polygon(0.1, &[[0.0, 0.0], [0.1, 0.0]]), Err(PatchError::Footprint(_))));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchError {
    /// The coefficient of friction is negative, infinite or NaN.
    Coefficient {
        /// The rejected value.
        given: f32,
    },
    /// The shape is not that of a foot.
    Footprint(FootprintError),
    /// The axis along which the patch lies is parallel to its normal.
    Axis,
}

/// Sine of the least angle between the x axis of a patch and its normal.
const LEAST_ANGLE: f32 = 1e-2;

impl FrictionPatch {
    /// A full disk: pucks, checkers, bottle caps. *Domain*: `mu` ≥ 0, `radius` > 0 in metres.
    pub fn disk(mu: f32, radius: f32) -> Result<Self, PatchError> {
        Self::new(mu, Footprint::disk(radius)?)
    }

    /// A thin ring: cups, curling stones, tubes. *Domain*: `mu` ≥ 0, `radius` > 0 in metres.
    pub fn ring(mu: f32, radius: f32) -> Result<Self, PatchError> {
        Self::new(mu, Footprint::ring(radius)?)
    }

    /// A straight bar along the x axis of the collider: a skate's blade.
    ///
    /// *Domain*: `mu` ≥ 0, `half_length` > 0 in metres. *Accuracy*: as [`Footprint::bar`].
    pub fn bar(mu: f32, half_length: f32) -> Result<Self, PatchError> {
        Self::new(mu, Footprint::bar(half_length)?)
    }

    /// A convex polygon: the foot of a box or a boot. The corners are in metres around the patch's
    /// [centre](Self::center), counterclockwise as seen from above: the first coordinate along the x axis of
    /// the collider, the second along its −z axis.
    ///
    /// *Domain*: `mu` ≥ 0; at least 3 corners that enclose an area. *Accuracy*: exact where the body stands on
    /// this foot alone; by points otherwise, see [`Footprint::polygon`].
    pub fn polygon(mu: f32, corners: &[[f32; 2]]) -> Result<Self, PatchError> {
        let (footprint, [x, y]) = Footprint::convex(corners)?;
        Ok(Self::new(mu, footprint)?.centered_at(Vec3::new(x, 0.0, -y)))
    }

    /// A patch of any footprint.
    pub fn new(mu: f32, footprint: Footprint) -> Result<Self, PatchError> {
        let mut patch = Self {
            mu: 0.0,
            footprint,
            center: Vec3::ZERO,
            up: Dir3::Y,
            along: Dir3::X,
        };
        patch.set_mu(mu)?;
        Ok(patch)
    }

    /// The same patch centred below another point of the collider's frame than its origin, in metres.
    pub fn centered_at(self, center: Vec3) -> Self {
        Self { center, ..self }
    }

    /// The same patch with another normal and another x axis, both in the collider's frame. `up` points from the
    /// ground into the foot; the default is +y, and +x for `along`.
    ///
    /// ```
    /// use bevy::prelude::*;
    /// use tribos_bevy::FrictionPatch;
    /// // A coin whose cylinder has its axis along z.
    /// let coin = FrictionPatch::disk(0.2, 0.01)?.oriented(Dir3::Z, Dir3::X)?;
    /// assert_eq!(coin.up(), Dir3::Z);
    /// assert!(FrictionPatch::disk(0.2, 0.01)?.oriented(Dir3::X, Dir3::X).is_err());
    /// # Ok::<(), tribos_bevy::PatchError>(())
    /// ```
    pub fn oriented(self, up: Dir3, along: Dir3) -> Result<Self, PatchError> {
        if up.cross(*along).length() < LEAST_ANGLE {
            return Err(PatchError::Axis);
        }
        Ok(Self { up, along, ..self })
    }

    /// Changes the coefficient of friction: swept ice, oil. *Domain*: `mu` ≥ 0.
    pub fn set_mu(&mut self, mu: f32) -> Result<(), PatchError> {
        if mu >= 0.0 && mu.is_finite() {
            self.mu = mu;
            Ok(())
        } else {
            Err(PatchError::Coefficient { given: mu })
        }
    }

    /// The coefficient of friction.
    pub fn mu(&self) -> f32 {
        self.mu
    }

    /// The shape.
    pub fn footprint(&self) -> &Footprint {
        &self.footprint
    }

    /// The point of the collider's frame below which the patch is centred, in metres.
    pub fn center(&self) -> Vec3 {
        self.center
    }

    /// The patch's normal in the collider's frame, from the ground into the foot.
    pub fn up(&self) -> Dir3 {
        self.up
    }

    /// The footprint's x axis in the collider's frame.
    pub fn along(&self) -> Dir3 {
        self.along
    }
}

impl From<FootprintError> for PatchError {
    fn from(error: FootprintError) -> Self {
        Self::Footprint(error)
    }
}

impl fmt::Display for PatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient { given } => write!(
                f,
                "the coefficient of friction must be finite and not negative, not {given}"
            ),
            Self::Footprint(error) => error.fmt(f),
            Self::Axis => write!(
                f,
                "the axis along which a patch lies must not be parallel to its normal"
            ),
        }
    }
}

impl core::error::Error for PatchError {}
