//! Why corners cannot carry a load.

/// Corners, or a centre of pressure, that no load can have.
///
/// ```
/// use tribos_core::Error;
/// use tribos_core::limit_surface::{AnyPressure, SupportError};
/// let corners = [[0.0_f64, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]]; // m
/// let tipped = AnyPressure::new(corners, [0.25, 0.05], 400.0); // N
/// assert_eq!(tipped.err(), Some(Error::Support(SupportError::Outside)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SupportError {
    /// There are no corners.
    NoCorners,
    /// A coordinate of a corner is infinite or NaN.
    Position {
        /// Which corner, from 0.
        corner: usize,
    },
    /// A coordinate of the centre of pressure is infinite or NaN.
    Centre,
    /// The distance of a corner from the centre of pressure is out of range.
    Extent,
    /// The centre of pressure lies outside of the convex hull of the corners: the body tips over.
    Outside,
}

impl core::fmt::Display for SupportError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::NoCorners => f.write_str("a support must have at least one corner"),
            Self::Position { corner } => {
                write!(f, "corner {corner} must lie at a finite place")
            }
            Self::Centre => f.write_str("the centre of pressure must lie at a finite place"),
            Self::Extent => {
                f.write_str("corners must lie at a finite distance from the centre of pressure")
            }
            Self::Outside => f.write_str(
                "the centre of pressure must lie in the convex hull of the corners; \
                 the body tips over there",
            ),
        }
    }
}

impl core::error::Error for SupportError {}
