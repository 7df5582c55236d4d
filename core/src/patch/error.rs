//! Validation of patches.

use super::ellipse::Ellipse;
use super::polar::PolarQuadrature;
use crate::real::Real;

/// An invalid patch: its dimensions, its pressure, the points that it is made of, or the corners that support
/// it.
///
/// ```
/// use tribos_core::coupling::{Annulus, coulomb::CoulombDisk};
/// use tribos_core::limit_surface::UnknownPressureSet;
/// use tribos_core::patch::nodes::{Node, NodeList, Nodes};
/// use tribos_core::patch::polar::PolarQuadrature;
/// use tribos_core::patch::{PatchError, PolynomialPressure, PowerPressure};
/// let max = PowerPressure::MAX_ORDER;
/// assert_eq!(PowerPressure::new(-2.0), Err(PatchError::Order { given: -2.0, max }));
/// assert_eq!(PolynomialPressure::new([0.0]), Err(PatchError::NoLoad));
/// assert!(matches!(Annulus::new(CoulombDisk, 1.0), Err(PatchError::InnerRatio { .. })));
///
/// let foot = |weight: f64| Node { x: 0.1, y: 0.0, weight };
/// assert_eq!(Nodes::new([foot(0.0)]), Err(PatchError::Unloaded));
/// let pulling = Nodes::new([foot(2.0), foot(-1.0)]);
/// assert_eq!(pulling, Err(PatchError::NodeWeight { index: 1, given: -1.0 }));
/// assert_eq!(PolarQuadrature::new(0.04, 0, 16), Err(PatchError::RuleOrder { given: 0 }));
///
/// let feet = [[0.0, 0.0], [0.3, 0.0], [0.0, 0.3]]; // m
/// assert_eq!(Nodes::tripod(feet, [0.2, 0.2]), Err(PatchError::FootPulls { foot: 0 }));
///
/// let u = [[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]];
/// let u = u.map(|corner| corner.map(f64::from));
/// let bent: Result<NodeList<f64, 100>, _> = NodeList::polygon(&u, 1);
/// assert_eq!(bent, Err(PatchError::Hidden)); // cut it into three
///
/// let corners = [[0.0_f64, 0.0], [0.2, 0.0], [0.2, 0.1], [0.0, 0.1]]; // m
/// let tipped = UnknownPressureSet::new(corners, [0.25, 0.05], 400.0); // N
/// assert_eq!(tipped.err(), Some(PatchError::CentreOutside.into()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PatchError {
    /// The radius is not positive and finite.
    Radius {
        /// What was given.
        given: f64,
    },
    /// The order q of a pressure (1−r²)^q is not in [−1, `max`].
    Order {
        /// What was given.
        given: f64,
        /// Largest order served.
        max: f64,
    },
    /// The semi-axes of an ellipse are not positive and finite, or one is more than
    /// [`super::ellipse::Ellipse::MAX_ASPECT_RATIO`] times the other.
    SemiAxes {
        /// What was given; the larger one first if they follow from half-diameters.
        given: [f64; 2],
    },
    /// The inner over the outer radius of an annulus is not in [0, `max`].
    InnerRatio {
        /// What was given.
        given: f64,
        /// Thinnest annulus served; a thinner one is a ring.
        max: f64,
    },
    /// The height of the centre of mass is negative, infinite or NaN.
    Height {
        /// What was given.
        given: f64,
    },
    /// The lean of a tall body is negative, infinite or NaN.
    Lean {
        /// What was given.
        given: f64,
    },
    /// A tall body begins to tip.
    Tips {
        /// |l|, which must not exceed 1.
        lean: f64,
    },
    /// A polynomial pressure is negative somewhere on the patch, or not finite.
    Negative,
    /// The pressure carries no load.
    NoLoad,
    /// The position of a node is infinite or NaN.
    NodePosition {
        /// Which node, from 0.
        index: usize,
        /// What was given.
        given: [f64; 2],
    },
    /// The weight of a node is negative or NaN, or makes the sum infinite.
    NodeWeight {
        /// Which node, from 0.
        index: usize,
        /// What was given.
        given: f64,
    },
    /// No node has a positive weight.
    Unloaded,
    /// All load is at one place, or places are too far apart for their distance to be a number.
    OnePlace,
    /// There is no room for another node.
    Full {
        /// How many nodes there is room for.
        capacity: usize,
    },
    /// The number of rings or angles of a quadrature rule is 0 or too large.
    RuleOrder {
        /// What was given.
        given: u32,
    },
    /// The exponent of a rule's pressure is NaN or not in (−1, [`PolarQuadrature::MAX_RIM_EXPONENT`]].
    RimExponent {
        /// What was given.
        given: f64,
    },
    /// The patch has no image of its kind under an affine map: friction on it cannot differ along two axes.
    NoImage,
    /// A polygon has fewer than 3 corners.
    Corners {
        /// How many were given.
        given: usize,
    },
    /// No corner of a polygon sees its whole inside, or there is no area.
    Hidden,
    /// The number of divisions of an edge is not from 1 to [`PatchError::MAX_DIVISIONS`].
    Divisions {
        /// What was given.
        given: u32,
    },
    /// Three feet lie in a line, or a position is not finite.
    FeetInLine,
    /// A body on three feet tips over: a foot would have to pull.
    FootPulls {
        /// Which foot lifts first, from 0.
        foot: usize,
    },
    /// A support has no corners.
    NoCorners,
    /// A coordinate of a corner of a support is infinite or NaN.
    CornerPosition {
        /// Which corner, from 0.
        corner: usize,
    },
    /// A coordinate of the centre of pressure is infinite or NaN.
    Centre,
    /// The distance of a corner from the centre of pressure is out of range.
    CornerDistance,
    /// The centre of pressure lies outside of the convex hull of the corners: the body tips over.
    CentreOutside,
    /// The smaller of two relative curvatures is below `least` of the larger: a line contact.
    CurvatureRatio {
        /// What was given.
        given: f64,
        /// Smallest ratio served.
        least: f64,
    },
    /// The equation of an ellipse's axes was not solved to rounding.
    Unsolved,
}

impl PatchError {
    /// Most divisions of an edge of a polygon.
    pub const MAX_DIVISIONS: u32 = 1024;
}

impl core::fmt::Display for PatchError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Radius { given } => write!(
                f,
                "the contact radius must be positive and finite, not {given}"
            ),
            Self::Order { given, max } => write!(
                f,
                "the order q of a pressure (1-r^2)^q must satisfy -1 <= q <= {max}, not {given}"
            ),
            Self::SemiAxes { given: [a, b] } => {
                let max = Ellipse::<f64>::MAX_ASPECT_RATIO;
                write!(
                    f,
                    "the semi-axes of an ellipse must be positive and finite, one at most {max} times the other, \
                     not {a} and {b}; a longer ellipse is a bar"
                )
            }
            Self::InnerRatio { given, max } => write!(
                f,
                "inner radius / outer radius must be from 0 to {max}, not {given}; \
                 a thinner annulus is a ring"
            ),
            Self::Height { given } => write!(
                f,
                "the height of the centre of mass must be finite and not negative, not {given}"
            ),
            Self::Lean { given } => {
                write!(f, "the lean must be finite and not negative, not {given}")
            }
            Self::Tips { lean } => write!(
                f,
                "the body tips: the pressure gradient is {lean} of what its foot can bear; \
                 lower the centre of mass or the friction"
            ),
            Self::Negative => f.write_str(
                "the pressure must be finite and nowhere negative on the patch; \
                 change its coefficients",
            ),
            Self::NoLoad => {
                f.write_str("the pressure carries no load; give a positive coefficient")
            }
            Self::NodePosition {
                index,
                given: [x, y],
            } => write!(f, "node {index} must lie at a finite place, not ({x}, {y})"),
            Self::NodeWeight { index, given } => write!(
                f,
                "node {index} must carry a finite weight, not negative, not {given}"
            ),
            Self::Unloaded => f.write_str("at least one node must carry load"),
            Self::NoImage => f.write_str(
                "friction that differs along two axes is not served on this patch: give an ellipse, a disk, hertz, punch, \
                 paraboloid, straight edges, triangles or points",
            ),
            Self::OnePlace => {
                f.write_str("at least two places a finite distance apart must carry load")
            }
            Self::Full { capacity } => write!(f, "there is room for {capacity} nodes, not more"),
            Self::RuleOrder { given } => {
                let max = PolarQuadrature::<f64>::MAX_ORDER;
                write!(f, "rings and angles must be from 1 to {max}, not {given}")
            }
            Self::RimExponent { given } => {
                let max = PolarQuadrature::<f64>::MAX_RIM_EXPONENT;
                write!(
                    f,
                    "the exponent q must satisfy -1 < q <= {max}, not {given}"
                )
            }
            Self::Corners { given } => write!(f, "a polygon has at least 3 corners, not {given}"),
            Self::Hidden => f.write_str(
                "a polygon must have an area and a corner that sees all of it; cut it into several",
            ),
            Self::Divisions { given } => {
                let max = Self::MAX_DIVISIONS;
                write!(f, "divisions must be from 1 to {max}, not {given}")
            }
            Self::FeetInLine => f.write_str("three feet must span a triangle of finite size"),
            Self::FootPulls { foot } => {
                write!(f, "the body tips over: foot {foot} would have to pull")
            }
            Self::NoCorners => f.write_str("a support must have at least one corner"),
            Self::CornerPosition { corner } => {
                write!(f, "corner {corner} must lie at a finite place")
            }
            Self::Centre => f.write_str("the centre of pressure must lie at a finite place"),
            Self::CornerDistance => {
                f.write_str("corners must lie at a finite distance from the centre of pressure")
            }
            Self::CentreOutside => f.write_str(
                "the centre of pressure must lie in the convex hull of the corners; \
                 the body tips over there",
            ),
            Self::CurvatureRatio { given, least } => write!(
                f,
                "the smaller relative curvature must be at least {least} of the larger, not {given}; \
                 a contact along a line has a width and no length of its own"
            ),
            Self::Unsolved => f.write_str("the axes of the ellipse were not found to rounding"),
        }
    }
}

impl core::error::Error for PatchError {}

/// `radius` if positive and finite.
pub(crate) fn validated_radius<R: Real>(radius: R) -> Result<R, PatchError> {
    if radius > R::ZERO && radius.is_finite() {
        Ok(radius)
    } else {
        Err(PatchError::Radius {
            given: radius.to_f64(),
        })
    }
}
