//! A round patch in a place of its own: a foot among others.

use super::{PatchError, validated_radius};
use crate::real::Real;
use nalgebra::Vector2;

/// A round patch under dry friction, about any centre, as a [`crate::coupling::flat::PatchShape`].
///
/// Alone on one surface [`crate::coupling::RoundFriction`] is quicker.
///
/// *Units*: length. *Accuracy*: that of the coupling.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::round::RoundPatch;
/// use tribos_core::twist::Twist;
/// let cup = ShapeFriction::new(RoundPatch::new(CoulombDisk, [0.1_f64, 0.0], 0.02)?, 0.5)?; // m
/// let pivoting = cup.wrench(30.0, &Twist::new(0.0, -0.1, 1.0)); // N; about its own centre
/// assert!((pivoting.torque + 0.5 * 30.0 * 0.02 * 2.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundPatch<R: Real, C> {
    coupling: C,
    centre: Vector2<R>,
    radius: R,
}

impl<R: Real, C> RoundPatch<R, C> {
    /// *Domain*: a finite `centre`; 0 < `radius` < ∞.
    pub fn new(coupling: C, centre: [R; 2], radius: R) -> Result<Self, PatchError> {
        let [x, y] = centre;
        if !(x.is_finite() && y.is_finite()) {
            return Err(PatchError::Centre);
        }
        Ok(Self {
            coupling,
            centre: Vector2::new(x, y),
            radius: validated_radius(radius)?,
        })
    }

    /// The coupling: its pressure.
    pub fn coupling(&self) -> &C {
        &self.coupling
    }

    /// Its middle.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Its radius.
    pub fn radius(&self) -> R {
        self.radius
    }
}
