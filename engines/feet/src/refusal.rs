//! Footprints that have no area.

use core::fmt;

/// Why a footprint was refused.
///
/// ```
/// use tribos_feet::{Footprint, FootprintError};
/// assert_eq!(Footprint::ring(0.0).err(), Some(FootprintError::Radius { given: 0.0 }));
/// let line = Footprint::polygon(&[[0.0, 0.0], [0.1, 0.0]], 2); // two corners
/// assert!(matches!(line, Err(FootprintError::Polygon(_))));
/// let fine = Footprint::polygon(&[[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]], 7); // 343 points
/// assert!(matches!(fine, Err(FootprintError::Polygon(_))));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FootprintError {
    /// The radius, or the half length of a bar, is not positive and finite.
    Radius {
        /// The rejected value.
        given: f32,
    },
    /// The polygon has no interior, or too many corners.
    Polygon(tribos_core::patch::PatchError),
}

impl fmt::Display for FootprintError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Radius { given } => {
                write!(f, "the radius must be positive and finite, not {given} m")
            }
            Self::Polygon(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for FootprintError {}
