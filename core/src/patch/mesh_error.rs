//! Why a mesh is refused.

/// A mesh that is no patch.
///
/// ```
/// use tribos_core::patch::mesh::{Mesh, MeshError, Triangle, Vertex};
/// let vertices = [[0.0_f64, 0.0], [0.1, 0.0], [0.0, 0.1]]
///     .map(|[x, y]| Vertex { x, y, pressure: 1e4 });
/// let mesh = Mesh::with_vertices(&vertices, &[[0, 1, 3]], [Triangle::default()]);
/// let refused = MeshError::Index { triangle: 0, vertex: 3, vertices: 3 };
/// assert_eq!(mesh.err(), Some(refused));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshError {
    /// There is no triangle.
    Empty,
    /// There are more triangles than there is room for.
    Room {
        /// How many were given.
        given: usize,
        /// How many there is room for.
        room: usize,
    },
    /// A triangle names a vertex that does not exist.
    Index {
        /// Which triangle, from 0.
        triangle: usize,
        /// The vertex that it names.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// A coordinate is infinite or NaN.
    Position {
        /// Which triangle, from 0.
        triangle: usize,
        /// Which of its corners, from 0.
        corner: usize,
    },
    /// A pressure is negative, infinite or NaN.
    Pressure {
        /// Which triangle, from 0.
        triangle: usize,
        /// Which of its corners, from 0.
        corner: usize,
        /// What was given.
        given: f64,
    },
    /// The distance between two corners or the centre of pressure is out of range.
    Extent,
    /// No triangle has both an area and a pressure, beyond rounding.
    Unloaded,
}

impl core::fmt::Display for MeshError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Empty => f.write_str("a mesh must have at least one triangle"),
            Self::Room { given, room } => {
                write!(f, "there is room for {room} triangles, not for {given}")
            }
            Self::Index {
                triangle,
                vertex,
                vertices,
            } => write!(
                f,
                "triangle {triangle} must name vertices below {vertices}, not {vertex}"
            ),
            Self::Position { triangle, corner } => write!(
                f,
                "corner {corner} of triangle {triangle} must lie at a finite place"
            ),
            Self::Pressure {
                triangle,
                corner,
                given,
            } => write!(
                f,
                "the pressure at corner {corner} of triangle {triangle} must be finite and not \
                 negative, not {given}"
            ),
            Self::Extent => f.write_str("the distances between corners must be finite"),
            Self::Unloaded => f.write_str("some triangle must have an area under pressure"),
        }
    }
}

impl core::error::Error for MeshError {}
