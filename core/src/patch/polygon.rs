//! Nodes of a uniform pressure on a polygon.
//!
//! The polygon is cut into the triangles that one of its corners spans with all edges, each of
//! these into equal smaller ones, and each of those gets Radon's seven points, exact for
//! polynomials up to degree 5.
//!
//! *Source*: J. Radon, Monatsh. Math. 52 (1948) 286.

use super::PatchError;
use super::nodes::{Node, NodeList, NodeSink};
use crate::real::Real;
use nalgebra::Vector2;

/// Nodes a small triangle has.
const NODES_PER_TRIANGLE: usize = 7;

impl<R: Real, const CAPACITY: usize> NodeList<R, CAPACITY> {
    /// Nodes for uniform pressure on the polygon with these `corners`, in either sense of rotation.
    ///
    /// Each of the n − 2 triangles is divided into `divisions`² equal ones, so that there are
    /// 7 (n − 2) `divisions`² nodes, fewer where corners lie on a line. The sum of the weights is the
    /// polygon's area.
    ///
    /// *Domain*: a simple polygon of at least 3 corners, one of which sees the whole inside: every
    /// convex polygon, and shapes like L, T and +, but not like U. `divisions` from 1 to
    /// [`PatchError::MAX_DIVISIONS`]. Edges that cross are refused if no corner spans only triangles
    /// of one sense; otherwise what is covered twice carries twice.
    /// *Accuracy*: area, centroid and all moments up to degree 5 to rounding. Friction: while the
    /// instantaneous centre of rotation lies inside, the error falls as h^(2+α) with the size h of the
    /// small triangles; outside as h⁶. A square of side 2 under Coulomb friction, unit load: root mean
    /// square 1.2e-2, 2.8e-3, 6.8e-4 with 56, 224, 896 nodes.
    ///
    /// ```
    /// use tribos_core::patch::nodes::{NodeList, NodePatch};
    /// let ell = [[0.0, 0.0], [0.2, 0.0], [0.2, 0.1], [0.1, 0.1], [0.1, 0.2], [0.0, 0.2]]; // m
    /// const NODES: usize = 7 * (6 - 2) * 2 * 2;
    /// let foot: NodeList<f64, NODES> = NodeList::polygon(&ell, 2)?;
    /// assert!((foot.total_weight() - 0.03).abs() < 1e-16); // three squares of 0.1 m
    /// # Ok::<(), tribos_core::patch::PatchError>(())
    /// ```
    pub fn polygon(corners: &[[R; 2]], divisions: u32) -> Result<Self, PatchError> {
        let mut list = Self::new();
        polygon_into(&mut list, corners, divisions)?;
        Ok(list)
    }
}

/// [`NodeList::polygon`] into memory of the caller's choice, behind the nodes that are there already.
///
/// *Special values*: what was added before an error stays.
///
/// ```
/// use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch};
/// use tribos_core::patch::polygon::polygon_into;
/// let mut memory = [Node::default(); 14]; // two triangles of 7 nodes
/// let mut sole = NodeBuffer::new(&mut memory);
/// polygon_into(&mut sole, &[[0.0, 0.0], [0.3, 0.0], [0.3, 0.1], [0.0, 0.1_f64]], 1)?; // m
/// assert!((sole.total_weight() - 0.03).abs() < 1e-16);
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
pub fn polygon_into<R: Real>(
    list: &mut impl NodeSink<R>,
    corners: &[[R; 2]],
    divisions: u32,
) -> Result<(), PatchError> {
    if corners.len() < 3 {
        return Err(PatchError::Corners {
            given: corners.len(),
        });
    }
    if divisions == 0 || divisions > PatchError::MAX_DIVISIONS {
        return Err(PatchError::Divisions { given: divisions });
    }
    for (index, [x, y]) in corners.iter().enumerate() {
        if !(x.is_finite() && y.is_finite()) {
            let given = [x.to_f64(), y.to_f64()];
            return Err(PatchError::NodePosition { index, given });
        }
    }
    let apex = corners
        .iter()
        .find(|&&apex| is_star_centre(corners, apex))
        .ok_or(PatchError::Hidden)?;
    for triangle in fan(corners, *apex) {
        push_triangle(list, triangle, divisions)?;
    }
    Ok(())
}

/// Twice the signed area of a triangle; zero if it is not larger than its own rounding.
fn twice_area<R: Real>([a, b, c]: [[R; 2]; 3]) -> R {
    let left = (b[0] - a[0]) * (c[1] - a[1]);
    let right = (b[1] - a[1]) * (c[0] - a[0]);
    let rounding = R::TWO * R::TWO * R::EPSILON * (left.abs() + right.abs());
    let area = left - right;
    if area.abs() <= rounding {
        R::ZERO
    } else {
        area
    }
}

/// Triangles of `apex` with all edges that do not end in it.
fn fan<R: Real>(corners: &[[R; 2]], apex: [R; 2]) -> impl Iterator<Item = [[R; 2]; 3]> {
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    edges
        .filter(move |(b, c)| **b != apex && **c != apex)
        .map(move |(&b, &c)| [apex, b, c])
}

/// True if all triangles of `apex` have one sense of rotation and some have an area.
fn is_star_centre<R: Real>(corners: &[[R; 2]], apex: [R; 2]) -> bool {
    let any = |sign: R| fan(corners, apex).any(|triangle| sign * twice_area(triangle) > R::ZERO);
    any(R::ONE) != any(-R::ONE)
}

/// The nodes of one triangle, cut into `divisions`² equal ones.
fn push_triangle<R: Real>(
    list: &mut impl NodeSink<R>,
    triangle: [[R; 2]; 3],
    divisions: u32,
) -> Result<(), PatchError> {
    let [a, b, c] = triangle.map(|[x, y]| Vector2::new(x, y));
    let step = R::ONE / R::from_f64(f64::from(divisions));
    let (first, second) = ((b - a) * step, (c - a) * step);
    let area = R::HALF * twice_area(triangle).abs() * step * step;
    if area == R::ZERO {
        return Ok(());
    }
    for row in 0..divisions {
        for column in 0..divisions - row {
            let [i, j] = [column, row].map(|n| R::from_f64(f64::from(n)));
            let corner = a + first * i + second * j;
            push_small(list, corner, first, second, area)?;
            // The upside-down neighbour, except at the end of the row.
            if row + column + 1 < divisions {
                push_small(list, corner + first + second, -first, -second, area)?;
            }
        }
    }
    Ok(())
}

/// Radon's nodes on the triangle with one `corner` and two sides.
fn push_small<R: Real>(
    list: &mut impl NodeSink<R>,
    corner: Vector2<R>,
    first: Vector2<R>,
    second: Vector2<R>,
    area: R,
) -> Result<(), PatchError> {
    for [i, j, weight] in RADON {
        let at = corner + first * R::from_f64(i) + second * R::from_f64(j);
        list.push(Node {
            x: at.x,
            y: at.y,
            weight: area * R::from_f64(weight),
        })?;
    }
    Ok(())
}

/// √15
const ROOT_15: f64 = 3.872_983_346_207_417;
/// Distance of the outer three nodes from two sides, in heights, and their weight.
const OUTER: f64 = (6.0 - ROOT_15) / 21.0;
const OUTER_WEIGHT: f64 = (155.0 - ROOT_15) / 1200.0;
/// The same of the inner three.
const INNER: f64 = (6.0 + ROOT_15) / 21.0;
const INNER_WEIGHT: f64 = (155.0 + ROOT_15) / 1200.0;

/// [along the first side, along the second, weight], sum of weights 1.
const RADON: [[f64; 3]; NODES_PER_TRIANGLE] = [
    [1.0 / 3.0, 1.0 / 3.0, 9.0 / 40.0],
    [OUTER, OUTER, OUTER_WEIGHT],
    [1.0 - 2.0 * OUTER, OUTER, OUTER_WEIGHT],
    [OUTER, 1.0 - 2.0 * OUTER, OUTER_WEIGHT],
    [INNER, INNER, INNER_WEIGHT],
    [1.0 - 2.0 * INNER, INNER, INNER_WEIGHT],
    [INNER, 1.0 - 2.0 * INNER, INNER_WEIGHT],
];
