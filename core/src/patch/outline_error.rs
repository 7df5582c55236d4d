//! Why an outline or its pressure is refused.

/// A polygon that bounds no patch, or a pressure that it cannot carry.
///
/// ```
/// use tribos_core::patch::outline::{OutlineError, Polygon};
/// // A bow tie: two edges cross.
/// let tie = Polygon::new([[0.0_f64, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
/// assert_eq!(tie.err(), Some(OutlineError::Crossing { edges: [[0, 0], [0, 2]] }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum OutlineError {
    /// Fewer than 3 corners.
    Corners {
        /// Which loop, from 0.
        in_loop: usize,
        /// How many were given.
        given: usize,
    },
    /// A coordinate is infinite or NaN.
    Position {
        /// Which loop, from 0.
        in_loop: usize,
        /// Which corner, from 0.
        corner: usize,
    },
    /// A corner coincides with the next one, or cannot be told from it beside the patch's size.
    Repeated {
        /// Which loop, from 0.
        in_loop: usize,
        /// Which corner, from 0.
        corner: usize,
    },
    /// Two edges touch or cross.
    Crossing {
        /// Loop and number of the edge, each from 0, of both.
        edges: [[usize; 2]; 2],
    },
    /// A loop has no area beyond rounding; the outer one, if its holes leave none of it.
    Flat {
        /// Which loop, from 0.
        in_loop: usize,
    },
    /// A loop that should be a hole lies outside of the first loop or inside of another hole.
    Hole {
        /// Which loop, from 0.
        in_loop: usize,
    },
    /// The borders of a patch do not form closed loops.
    Open,
    /// The distance between two corners or the centre of pressure is out of range.
    Extent,
    /// There are more corners than there is room for edges.
    Room {
        /// How many corners were given.
        given: usize,
        /// How many there is room for.
        room: usize,
    },
    /// The slope of the pressure or its centre is infinite or NaN.
    Slope,
    /// The pressure would be negative at a corner: the patch lifts off there.
    LiftOff {
        /// The pressure at that corner, of the mean pressure.
        lowest: f64,
    },
}

impl core::fmt::Display for OutlineError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Corners { in_loop, given } => {
                write!(
                    f,
                    "loop {in_loop} must have at least 3 corners, not {given}"
                )
            }
            Self::Position { in_loop, corner } => {
                write!(
                    f,
                    "corner {corner} of loop {in_loop} must lie at a finite place"
                )
            }
            Self::Repeated { in_loop, corner } => write!(
                f,
                "corner {corner} of loop {in_loop} must differ from the next one"
            ),
            Self::Crossing {
                edges: [[a, i], [b, j]],
            } => write!(
                f,
                "edge {i} of loop {a} and edge {j} of loop {b} must not touch or cross"
            ),
            Self::Flat { in_loop } => write!(f, "loop {in_loop} must enclose an area"),
            Self::Hole { in_loop } => write!(
                f,
                "loop {in_loop} must lie inside of the first loop and outside of other holes"
            ),
            Self::Open => f.write_str("each border must begin where another one ends"),
            Self::Extent => f.write_str("the distances between corners must be finite"),
            Self::Room { given, room } => {
                write!(f, "there is room for {room} edges, not for {given}")
            }
            Self::Slope => f.write_str("slope and centre of the pressure must be finite"),
            Self::LiftOff { lowest } => write!(
                f,
                "the pressure must be nowhere negative, not {lowest} of its mean at a corner; \
                 the patch lifts off there"
            ),
        }
    }
}

impl core::error::Error for OutlineError {}
