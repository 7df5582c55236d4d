//! Contact patches: shape, position and coefficient of friction.

use core::fmt;
use rapier3d::math::Vector;
use tribos_feet::{Footprint, FootprintError};

/// A patch of Coulomb friction under a foot, centred below the origin of the foot's collider.
///
/// The pressure is uniform over a disk, along a ring or a bar, or over a polygon; [`Patch::new`] takes any other
/// footprint. A body may have several feet, each a collider with its own patch: the engine determines how they
/// share the load.
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
    /// Direction of the footprint's x axis in the collider's frame.
    along: Vector,
    footprint: Footprint,
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
        Self::new(mu, Footprint::disk(radius)?)
    }

    /// A thin ring: cups, curling stones, tubes. *Domain*: `mu` ≥ 0, `radius` > 0 in metres.
    pub fn ring(mu: f32, radius: f32) -> Result<Self, PatchError> {
        Self::new(mu, Footprint::ring(radius)?)
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
        Self::new(mu, Footprint::bar(half_length)?)
    }

    /// The foot of a box or a boot: corners in metres, around the patch's centre.
    ///
    /// The first coordinate lies along the x axis of the foot's collider, the second across it, so that the
    /// normal, x and the second axis are right-handed. *Domain*: `mu` ≥ 0; at least 3 corners, one
    /// of which sees the whole inside; `divisions` of every edge such that 7 (corners − 2)
    /// `divisions`² ≤ 256. *Accuracy*: exact where the body stands on this foot alone; friction within
    /// 1.2 % (root mean square) with 56 points where it stands on several feet or on a ground that moves.
    pub fn polygon(mu: f32, corners: &[[f32; 2]], divisions: u32) -> Result<Self, PatchError> {
        Self::new(mu, Footprint::polygon(corners, divisions)?)
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

    /// A patch of any footprint: a round foot under another pressure, a sole with holes, legs.
    ///
    /// ```
    /// use tribos_rapier::{Footprint, Patch};
    /// let studs = Footprint::weighted(&[[0.1, 0.0, 1.0], [-0.1, 0.1, 2.0], [-0.1, -0.1, 1.0]])?; // m, m, share
    /// assert_eq!(Patch::new(0.6, studs)?.mu(), 0.6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(mu: f32, footprint: Footprint) -> Result<Self, PatchError> {
        if mu >= 0.0 && mu.is_finite() {
            Ok(Self {
                mu,
                center: Vector::ZERO,
                along: Vector::X,
                footprint,
            })
        } else {
            Err(PatchError::Coefficient { given: mu })
        }
    }

    /// The coefficient of friction.
    pub fn mu(&self) -> f32 {
        self.mu
    }

    /// The same patch with its x axis along a direction of the collider's own frame, along x before: the bar of a wheel,
    /// whose cylinder has its axis along y.
    ///
    /// ```
    /// use rapier3d::prelude::Vector;
    /// use tribos_rapier::Patch;
    /// let tyre = Patch::bar(0.8, 0.02)?.along(Vector::Y); // half its width in m
    /// # Ok::<(), tribos_rapier::PatchError>(())
    /// ```
    pub fn along(self, along: Vector) -> Self {
        Self { along, ..self }
    }

    /// Direction of the x axis in the collider's frame.
    pub(crate) fn axis(&self) -> Vector {
        self.along
    }

    /// The same patch with another coefficient of friction, which is sound.
    pub(crate) fn set_mu(&mut self, mu: f32) {
        self.mu = mu;
    }

    /// The shape.
    pub(crate) fn footprint(&self) -> &Footprint {
        &self.footprint
    }
}

impl From<FootprintError> for PatchError {
    fn from(error: FootprintError) -> Self {
        match error {
            FootprintError::Radius { given } => Self::Radius { given },
            FootprintError::Polygon(error) => Self::Polygon(error),
        }
    }
}

impl fmt::Display for PatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient { given } => write!(
                f,
                "the coefficient of friction must be finite and not negative, not {given}"
            ),
            Self::Radius { given } => FootprintError::Radius { given: *given }.fmt(f),
            Self::Polygon(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for PatchError {}
