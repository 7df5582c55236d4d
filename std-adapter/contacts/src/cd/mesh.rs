//! Walls of triangles: where a sphere meets them, on faces, at edges and at corners.
//!
//! A sphere touches a mesh where the distance from its centre has a local minimum. The nearest point of one triangle is
//! such a minimum unless it lies on another triangle too, one that has a nearer point: then the way to that point leads
//! along the other triangle. So a sphere that rolls over an edge inside a flat part meets the part alone, and neither
//! the order of the triangles nor whether they share corners matters.

use super::mesh_grid::Grid;
use super::moving_mesh::Meeting;
use super::wall::Facing;
use nalgebra::Vector3;
use std::collections::HashMap;

/// Distance within which a point lies on a triangle, in lengths of the mesh: what single precision and the digits of
/// a file leave between corners that are one.
const SAME: f64 = 1e-6;
/// Largest difference of the unit normals of two triangles of a flat part.
const FLAT: f64 = 1e-6;
/// Numbers of contacts a triangle: its face, three edges, three corners.
const FEATURES: u32 = 7;

/// Triangles that bound the space of the spheres, which meet them from both sides.
///
/// ```
/// use tribos::cd::Mesh;
/// use tribos::kernel::nalgebra::Vector3;
/// let [o, x, y] = [Vector3::zeros(), Vector3::x(), Vector3::y()];
/// assert_eq!(Mesh::new(vec![[o, x, y]])?.triangles(), 1);
/// assert!(Mesh::new(vec![[o, x, x * 2.0]]).is_err()); // no area
/// # Ok::<(), tribos::cd::MeshError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Mesh {
    triangles: Vec<Triangle>,
    /// The first triangle of the flat part to which each belongs.
    parts: Vec<u32>,
    pub(super) grid: Grid,
    /// Distance within which points are the same.
    same: f64,
}

/// Why triangles are no wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshError {
    /// No triangle has an area.
    #[error("a mesh needs at least one triangle with an area")]
    Empty,
    /// A coordinate is infinite or NaN.
    #[error("triangle {triangle} (from 0): coordinates must be finite")]
    NotFinite {
        /// Number of the triangle.
        triangle: usize,
    },
    /// There are more triangles than contacts have numbers.
    #[error("a mesh has at most {} triangles, not {given}", MOST)]
    TooMany {
        /// Number given.
        given: usize,
    },
}

/// Most triangles of a mesh.
const MOST: usize = 100_000_000;

#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [Vector3<f64>; 3],
    /// Unit normal by the right hand.
    normal: Vector3<f64>,
}

impl Mesh {
    /// The wall of these triangles; those without an area are left out.
    ///
    /// *Domain*: finite coordinates, at least one triangle with an area.
    pub fn new(triangles: Vec<[Vector3<f64>; 3]>) -> Result<Self, MeshError> {
        if triangles.len() > MOST {
            let given = triangles.len();
            return Err(MeshError::TooMany { given });
        }
        let finite = |corner: &Vector3<f64>| corner.iter().all(|x| x.is_finite());
        let lost = triangles.iter().position(|all| !all.iter().all(finite));
        if let Some(triangle) = lost {
            return Err(MeshError::NotFinite { triangle });
        }
        let triangles: Vec<Triangle> = triangles.into_iter().filter_map(Triangle::new).collect();
        let boxes: Vec<_> = triangles.iter().map(Triangle::bounds).collect();
        let grid = Grid::new(&boxes).ok_or(MeshError::Empty)?;
        let same = SAME * grid.size();
        let parts = flat_parts(&triangles, same);
        Ok(Self {
            triangles,
            parts,
            grid,
            same,
        })
    }

    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.triangles.len()
    }

    /// Corners of the triangles.
    pub fn corners(&self) -> impl Iterator<Item = &[Vector3<f64>; 3]> {
        self.triangles.iter().map(|triangle| &triangle.corners)
    }

    /// Local minima of the distance from a centre, up to a distance. In a periodic cell the centre has images; the mesh
    /// goes on from one to the next.
    pub(super) fn nearest(&self, images: &[Vector3<f64>], within: f64) -> Vec<Meeting> {
        let mut near = Vec::new();
        for centre in images
            .iter()
            .filter(|image| self.grid.is_near(image, within))
        {
            for index in self.grid.around(centre, within) {
                let found = self.triangles[index as usize].nearest(centre, self.same);
                if found.facing.height <= within {
                    near.push((index, centre, found));
                }
            }
        }
        near.sort_by(|(i, _, a), (j, _, b)| {
            a.facing.height.total_cmp(&b.facing.height).then(i.cmp(j))
        });
        let is_minimum = |at: usize| {
            let (_, centre, found) = &near[at];
            let lies_on = |(other, image, _): &(u32, &Vector3<f64>, Nearest)| {
                let point = found.point + (*image - *centre);
                let (closest, _) = self.triangles[*other as usize].closest(&point);
                (closest - point).norm() <= self.same
            };
            !near[..at].iter().any(lies_on)
        };
        let minima = (0..near.len()).filter(|at| is_minimum(*at));
        minima
            .map(|at| self.meeting(near[at].0, &near[at].2))
            .collect()
    }

    /// The nearest point of a triangle by the number of its contact: all faces of a flat part have one.
    fn meeting(&self, index: u32, found: &Nearest) -> Meeting {
        let first = if found.feature == 0 {
            self.parts[index as usize]
        } else {
            index
        };
        Meeting {
            number: first * FEATURES + found.feature,
            facing: found.facing,
        }
    }

    /// A contact of this number as a centre sees it: the plane of a flat part, an edge, or a corner.
    pub(super) fn facing(&self, number: u32, centre: &Vector3<f64>) -> Option<Facing> {
        let triangle = self.triangles.get((number / FEATURES) as usize)?;
        Some(match number % FEATURES {
            0 => triangle.plane(centre),
            edge @ 1..=3 => {
                let [a, b, _] = triangle.cycled(edge as usize - 1);
                let along = b - a;
                let share = (centre - a).dot(&along) / along.norm_squared();
                Facing::from_point(
                    &(a + along * share.clamp(0.0, 1.0)),
                    centre,
                    &triangle.normal,
                )
            }
            corner => {
                let point = triangle.corners[corner as usize - 4];
                Facing::from_point(&point, centre, &triangle.normal)
            }
        })
    }
}

/// The nearest point of a triangle.
struct Nearest {
    point: Vector3<f64>,
    /// 0 of the face, 1 to 3 of an edge, 4 to 6 of a corner.
    feature: u32,
    facing: Facing,
}

impl Triangle {
    fn new(corners: [Vector3<f64>; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0)?;
        normal
            .iter()
            .all(|x| x.is_finite())
            .then_some(Self { corners, normal })
    }

    fn bounds(&self) -> [Vector3<f64>; 2] {
        let [a, b, c] = &self.corners;
        [a.inf(b).inf(c), a.sup(b).sup(c)]
    }

    /// The corners from one on.
    fn cycled(&self, first: usize) -> [Vector3<f64>; 3] {
        [0, 1, 2].map(|next: usize| self.corners[(first + next) % 3])
    }

    /// The plane of the triangle, from the side on which the centre lies.
    fn plane(&self, centre: &Vector3<f64>) -> Facing {
        let height = self.normal.dot(&(centre - self.corners[0]));
        let outward = if height < 0.0 {
            -self.normal
        } else {
            self.normal
        };
        Facing {
            outward,
            height: height.abs(),
        }
    }

    /// The nearest point; what lies on the face but for rounding is the face.
    fn nearest(&self, centre: &Vector3<f64>, same: f64) -> Nearest {
        let (point, feature) = self.closest(centre);
        let plane = self.plane(centre);
        let foot = centre - plane.outward * plane.height;
        if feature == 0 || (foot - point).norm() <= same {
            return Nearest {
                point,
                feature: 0,
                facing: plane,
            };
        }
        let facing = Facing::from_point(&point, centre, &self.normal);
        Nearest {
            point,
            feature,
            facing,
        }
    }

    /// The nearest point and its feature, by the regions of the corners and edges (Ericson, Real-Time Collision
    /// Detection (2005), section 5.1.5).
    fn closest(&self, x: &Vector3<f64>) -> (Vector3<f64>, u32) {
        let [a, b, c] = self.corners;
        let (ab, ac) = (b - a, c - a);
        let [pa, pb, pc] = self.corners.map(|corner| {
            let p = x - corner;
            [ab.dot(&p), ac.dot(&p)]
        });
        if pa[0] <= 0.0 && pa[1] <= 0.0 {
            return (a, 4);
        }
        if pb[0] >= 0.0 && pb[1] <= pb[0] {
            return (b, 5);
        }
        let weight_c = pa[0] * pb[1] - pb[0] * pa[1];
        if weight_c <= 0.0 && pa[0] >= 0.0 && pb[0] <= 0.0 {
            return (a + ab * (pa[0] / (pa[0] - pb[0])), 1);
        }
        if pc[1] >= 0.0 && pc[0] <= pc[1] {
            return (c, 6);
        }
        let weight_b = pc[0] * pa[1] - pa[0] * pc[1];
        if weight_b <= 0.0 && pa[1] >= 0.0 && pc[1] <= 0.0 {
            return (a + ac * (pa[1] / (pa[1] - pc[1])), 3);
        }
        let weight_a = pb[0] * pc[1] - pc[0] * pb[1];
        let [to_c, to_b] = [pb[1] - pb[0], pc[0] - pc[1]];
        if weight_a <= 0.0 && to_c >= 0.0 && to_b >= 0.0 {
            return (b + (c - b) * (to_c / (to_c + to_b)), 2);
        }
        let sum = weight_a + weight_b + weight_c;
        (a + ab * (weight_b / sum) + ac * (weight_c / sum), 0)
    }
}

impl Facing {
    /// A point as a centre sees it; a centre at the point itself has no normal of its own.
    fn from_point(point: &Vector3<f64>, centre: &Vector3<f64>, normal: &Vector3<f64>) -> Self {
        let from = centre - point;
        let height = from.norm();
        let outward = if height > 0.0 { from / height } else { *normal };
        Self { outward, height }
    }
}

/// The first triangle of each one's flat part: neighbours across an edge with one plane belong together.
fn flat_parts(triangles: &[Triangle], same: f64) -> Vec<u32> {
    let cell = |corner: &Vector3<f64>| {
        let place = corner / same;
        [place.x, place.y, place.z].map(|x| x.round() as i64)
    };
    let mut parts: Vec<u32> = (0..triangles.len() as u32).collect();
    let mut edges: HashMap<[[i64; 3]; 2], Vec<u32>> = HashMap::new();
    for (index, triangle) in (0_u32..).zip(triangles) {
        let corners = triangle.corners.map(|corner| cell(&corner));
        for first in 0..3 {
            let (a, b) = (corners[first], corners[(first + 1) % 3]);
            let others = edges.entry([a.min(b), a.max(b)]).or_default();
            for &other in others.iter() {
                // A neighbour may be wound the other way.
                let lean = triangle
                    .normal
                    .cross(&triangles[other as usize].normal)
                    .norm();
                if lean <= FLAT {
                    let [i, j] = [index, other].map(|part| root(&mut parts, part));
                    parts[i.max(j) as usize] = i.min(j);
                }
            }
            others.push(index);
        }
    }
    (0..triangles.len() as u32)
        .map(|part| root(&mut parts, part))
        .collect()
}

/// The first triangle of a part; ways to it are halved.
fn root(parts: &mut [u32], mut part: u32) -> u32 {
    while parts[part as usize] != part {
        parts[part as usize] = parts[parts[part as usize] as usize];
        part = parts[part as usize];
    }
    part
}
