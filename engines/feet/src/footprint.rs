//! Shapes of feet.

use crate::area::Round;
use crate::convex::{centroid, divisions, thinned};
use crate::points::{
    POINTS, bar_points, disk_points, mesh_points, polygon_points, ring_points, round_points,
    weighted_points,
};
use crate::refusal::FootprintError;
use crate::standing::Exact;
use crate::surface::Surface;
use std::sync::Arc;
use tribos_core::patch::mesh::Vertex;
use tribos_core::patch::nodes::{Node, NodeList};
use tribos_friction::{Area as Shape, FrictionError, Patch};

/// Distance from the centre of mass, as a fraction of the radius, up to which a footprint counts as centred.
pub(crate) const CENTRED: f64 = 1e-3;

/// Distance between two places of a foot, as a fraction of its radius, up to which they are one: rounding of its turn.
const SAME: f64 = 1e-6;

/// The limit surface of a foot aside of the centre of mass, kept from one step to the next of the same foot.
#[derive(Clone, Debug)]
pub struct SurfaceAside(Arc<Aside>);

#[derive(Debug)]
struct Aside {
    of: Footprint,
    /// Its centre from the centre of mass, in its axes.
    place: [f64; 2],
    surface: Surface,
}

impl SurfaceAside {
    pub(crate) fn surface(&self) -> &Surface {
        &self.0.surface
    }
}

/// The shape of a foot's area, and its pressure: uniform, unless a round one is given another. Copies share
/// their data.
///
/// ```
/// use tribos_feet::{Footprint, FootprintError};
/// let puck = Footprint::disk(0.04)?;
/// let cup = Footprint::ring(0.03)?;
/// let rectangle = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]; // m
/// let parcel = Footprint::polygon(&rectangle, 2)?; // 7 · 2 · 2² = 56 points
/// assert_eq!(puck.radius(), 0.04);
/// # let _ = (cup, parcel);
/// # Ok::<(), FootprintError>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Outline", into = "Outline"))]
pub struct Footprint {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    outline: Outline,
    /// The exact limit surface under a friction limit of 1 N, about the footprint's centre.
    surface: Option<Surface>,
    /// A round foot among others.
    round: Option<Round>,
    /// Distance of the farthest point from the centre, in metres.
    radius: f32,
    /// Points that stand for the area, with their shares of the load.
    points: Vec<[f32; 3]>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Outline {
    Disk {
        radius: f32,
    },
    Ring {
        radius: f32,
    },
    Round {
        /// As [`Patch`] is written.
        patch: String,
        radius: f32,
    },
    Polygon {
        corners: Vec<[f32; 2]>,
        /// Of every edge, for the points.
        divisions: u32,
    },
    Bar {
        half: f32,
    },
    Points {
        /// x, y and weight.
        points: Vec<[f32; 3]>,
    },
    Mesh {
        /// x, y and pressure.
        vertices: Vec<[f32; 3]>,
        triangles: Vec<[usize; 3]>,
    },
}

impl Footprint {
    /// A full disk: pucks, checkers, bottle caps. *Domain*: `radius` > 0 in metres.
    pub fn disk(radius: f32) -> Result<Self, FootprintError> {
        made(Outline::Disk { radius }, radius)
    }

    /// A thin ring: cups, curling stones, tubes. *Domain*: `radius` > 0 in metres.
    pub fn ring(radius: f32) -> Result<Self, FootprintError> {
        made(Outline::Ring { radius }, radius)
    }

    /// A round foot under any pressure: elastic pads, worn soles. *Domain*: `radius` > 0 in metres.
    ///
    /// ```
    /// use tribos_feet::{Footprint, Patch, FrictionError};
    /// let ball = Footprint::round(&Patch::Hertz, 0.02)?;
    /// let tube = Footprint::round(&Patch::Annulus(0.8), 0.03)?;
    /// assert_eq!([ball.radius(), tube.radius()], [0.02, 0.03]);
    /// assert_eq!(Footprint::round(&"points:feet.csv".parse()?, 0.1).err(), Some(FrictionError::NoAxis));
    /// # Ok::<(), FrictionError>(())
    /// ```
    pub fn round(patch: &Patch, radius: f32) -> Result<Self, FrictionError> {
        let patch = patch.to_string();
        Outline::Round { patch, radius }.try_into()
    }

    /// A straight bar along the foot's x axis: a skate's blade, the edge of a tilted box.
    ///
    /// *Domain*: `half_length` > 0 in metres. *Accuracy*: exact where the body stands on this foot alone;
    /// elsewhere 16 points stand for it.
    pub fn bar(half_length: f32) -> Result<Self, FootprintError> {
        made(Outline::Bar { half: half_length }, half_length)
    }

    /// A polygon with these corners in metres, around the foot's centre.
    ///
    /// *Domain*: at least 3 corners, one of which sees the whole inside; `divisions` of every edge such that
    /// 7 (corners − 2) `divisions`² ≤ 256. *Accuracy*: exact where the body stands on this foot alone;
    /// friction within 1.2 % (root mean square) with 56 points where it stands on several feet or on a
    /// ground that moves.
    pub fn polygon(corners: &[[f32; 2]], divisions: u32) -> Result<Self, FootprintError> {
        let _: NodeList<f32, POINTS> =
            NodeList::polygon(corners, divisions).map_err(FootprintError::Polygon)?;
        let corners = corners.to_vec();
        let outline = Outline::Polygon { corners, divisions };
        let surface = outline.surface([0.0; 2]).ok();
        Ok(Self::of(outline, surface, None))
    }

    /// Points around the foot's centre, each with x, y in metres and a weight of which only the ratios count:
    /// legs, studs, measured pressures. *Domain*: at least two places carry load. *Accuracy*: exact.
    ///
    /// ```
    /// use tribos_feet::{Footprint, FrictionError};
    /// let studs = Footprint::weighted(&[[0.1, 0.0, 1.0], [-0.1, 0.1, 2.0], [-0.1, -0.1, 1.0]])?;
    /// assert_eq!(studs.points()[1], [-0.1, 0.1, 0.5]);
    /// assert!(Footprint::weighted(&[[0.1, 0.0, 1.0]]).is_err()); // one point resists no torque
    /// # Ok::<(), FrictionError>(())
    /// ```
    pub fn weighted(points: &[[f32; 3]]) -> Result<Self, FrictionError> {
        let points = points.to_vec();
        Outline::Points { points }.try_into()
    }

    /// Triangles that name their corners among `vertices`, each with x, y in metres from the foot's centre and a
    /// pressure of which only the ratios count: soles with holes or parts, any pressure.
    ///
    /// *Domain*: at least one triangle with an area and a pressure. *Accuracy*: exact where the body stands on
    /// this foot alone; elsewhere at least 7 points a triangle stand for it.
    ///
    /// ```
    /// use tribos_feet::{Footprint, FrictionError};
    /// let corners = [[-0.1, -0.1, 1.0], [0.1, -0.1, 1.0], [0.1, 0.1, 1.0], [-0.1, 0.1, 1.0]];
    /// let tile = Footprint::mesh(&corners, &[[0, 1, 2], [0, 2, 3]])?;
    /// assert!((tile.radius() - 0.02_f32.sqrt()).abs() < 1e-7);
    /// # Ok::<(), FrictionError>(())
    /// ```
    pub fn mesh(vertices: &[[f32; 3]], triangles: &[[usize; 3]]) -> Result<Self, FrictionError> {
        let (vertices, triangles) = (vertices.to_vec(), triangles.to_vec());
        Outline::Mesh {
            vertices,
            triangles,
        }
        .try_into()
    }

    /// A convex polygon about the middle of its area, and the middle; of more than 38 corners, 38 are kept,
    /// scaled to the same area.
    ///
    /// ```
    /// use tribos_feet::{Footprint, FootprintError};
    /// let (tile, middle) = Footprint::convex(&[[0.0, 0.0], [0.4, 0.0], [0.4, 0.2], [0.0, 0.2]])?;
    /// assert!((middle[0] - 0.2).abs() < 1e-6 && (middle[1] - 0.1).abs() < 1e-6);
    /// assert!((tile.radius() - 0.05_f32.sqrt()).abs() < 1e-6);
    /// # Ok::<(), FootprintError>(())
    /// ```
    pub fn convex(corners: &[[f32; 2]]) -> Result<(Self, [f32; 2]), FootprintError> {
        let kept = thinned(corners);
        let middle = centroid(&kept);
        let about = |[x, y]: [f32; 2]| [x - middle[0], y - middle[1]];
        let kept: Vec<[f32; 2]> = kept.into_iter().map(about).collect();
        Ok((Self::polygon(&kept, divisions(kept.len()))?, middle))
    }

    /// Points that stand for the area, each with its share of the load: x, y in metres and the share, whose
    /// sum is 1.
    ///
    /// ```
    /// use tribos_feet::{Footprint, FootprintError};
    /// let disk = Footprint::disk(0.5)?;
    /// let sum = |f: fn(&[f32; 3]) -> f32| disk.points().iter().map(f).sum::<f32>();
    /// assert!((sum(|p| p[2]) - 1.0).abs() < 1e-6);
    /// let mean_square = sum(|p| p[2] * (p[0] * p[0] + p[1] * p[1]));
    /// assert!((mean_square - 0.5 * 0.5 * 0.5).abs() < 1e-6); // R²/2
    /// # Ok::<(), FootprintError>(())
    /// ```
    pub fn points(&self) -> &[[f32; 3]] {
        &self.inner.points
    }

    /// Distance of the farthest point from the foot's centre, in metres.
    pub fn radius(&self) -> f32 {
        self.inner.radius
    }

    /// Whether the direction of the foot's x axis makes no difference.
    pub fn is_round(&self) -> bool {
        self.inner.round.is_some()
    }

    /// The exact limit surface under 1 N in the foot's axes, about a point from which the foot's centre is at
    /// `place`: the one `kept` where it serves. `None` for a round foot aside, whose exact surface is known about its
    /// middle alone.
    pub(crate) fn surface_about(
        &self,
        [x, y]: [f64; 2],
        [c, s]: [f64; 2],
        kept: Option<&SurfaceAside>,
    ) -> Option<Exact<'_>> {
        let centred = self.inner.surface.as_ref()?;
        let radius = f64::from(self.inner.radius);
        // A distance that does not count.
        if (x * x + y * y).sqrt() <= CENTRED * radius {
            return Some(Exact::Prepared(centred));
        }
        if self.is_round() {
            return None;
        }
        let in_foot = [c * x + s * y, c * y - s * x];
        let serves = |kept: &&SurfaceAside| {
            let [dx, dy] = [0, 1].map(|k| (kept.0.place[k] - in_foot[k]).abs());
            Arc::ptr_eq(&kept.0.of.inner, &self.inner) && dx.max(dy) <= SAME * radius
        };
        if let Some(kept) = kept.filter(serves) {
            return Some(Exact::Moved(kept.clone()));
        }
        let surface = self.inner.outline.surface(in_foot).ok()?;
        let (of, place) = (self.clone(), in_foot);
        Some(Exact::Moved(SurfaceAside(Arc::new(Aside {
            of,
            place,
            surface,
        }))))
    }

    /// Friction of a round foot among others.
    pub(crate) fn round_friction(&self) -> Option<&Round> {
        self.inner.round.as_ref()
    }

    /// What follows from an outline and its exact surface.
    fn of(outline: Outline, surface: Option<Surface>, round: Option<Round>) -> Self {
        let radius = match &outline {
            Outline::Disk { radius } | Outline::Ring { radius } | Outline::Round { radius, .. } => {
                *radius
            }
            Outline::Polygon { corners, .. } => farthest(corners.iter().copied()),
            Outline::Bar { half } => *half,
            Outline::Points { points } => farthest(points.iter().map(|&[x, y, _]| [x, y])),
            Outline::Mesh { vertices, .. } => farthest(vertices.iter().map(|&[x, y, _]| [x, y])),
        };
        let points = match &outline {
            Outline::Disk { radius } => disk_points(*radius),
            Outline::Ring { radius } => ring_points(*radius, 1.0),
            Outline::Round { patch, radius } => round_points(patch, *radius),
            Outline::Polygon { corners, divisions } => polygon_points(corners, *divisions),
            Outline::Bar { half } => bar_points(*half),
            Outline::Points { points } => weighted_points(points),
            Outline::Mesh {
                vertices,
                triangles,
            } => mesh_points(vertices, triangles),
        };
        let inner = Arc::new(Inner {
            outline,
            surface,
            round,
            radius,
            points,
        });
        Self { inner }
    }
}

impl Outline {
    /// The exact limit surface under 1 N of the foot whose centre is at `place`; a round foot stays in the middle.
    fn surface(&self, [x, y]: [f64; 2]) -> Result<Surface, FrictionError> {
        let moved = |[px, py]: [f32; 2]| [(f64::from(px) + x) as f32, (f64::from(py) + y) as f32];
        let area = match self {
            Self::Disk { radius } => Shape::round(Patch::Disk, *radius),
            Self::Ring { radius } => Shape::round(Patch::Ring, *radius),
            Self::Round { patch, radius } => Shape::round(patch.parse()?, *radius),
            Self::Polygon { corners, .. } => {
                let corners: Vec<[f32; 2]> = corners.iter().copied().map(moved).collect();
                Shape::polygon(&[&corners], None)
            }
            Self::Bar { half } => Shape::bar(moved([-half, 0.0]), moved([*half, 0.0])),
            Self::Points { points } => {
                let node = |&[x, y, weight]: &[f32; 3]| {
                    let [x, y] = moved([x, y]);
                    Node { x, y, weight }
                };
                Shape::points(points.iter().map(node).collect())
            }
            Self::Mesh {
                vertices,
                triangles,
            } => {
                let vertex = |&[x, y, pressure]: &[f32; 3]| {
                    let [x, y] = moved([x, y]);
                    Vertex { x, y, pressure }
                };
                let vertices: Vec<_> = vertices.iter().map(vertex).collect();
                Shape::mesh(&vertices, triangles)
            }
        };
        Surface::of(&area?)
    }

    /// Friction of a round foot among others.
    fn round(&self) -> Result<Option<Round>, FrictionError> {
        let (patch, radius) = match self {
            Self::Disk { radius } => (Patch::Disk, radius),
            Self::Ring { radius } => (Patch::Ring, radius),
            Self::Round { patch, radius } => (patch.parse()?, radius),
            _ => return Ok(None),
        };
        Round::new(&patch, *radius).map(Some)
    }
}

impl TryFrom<Outline> for Footprint {
    type Error = FrictionError;

    fn try_from(outline: Outline) -> Result<Self, FrictionError> {
        let surface = match (&outline, outline.surface([0.0; 2])) {
            // Points stand for a polygon whose edges touch.
            (Outline::Polygon { .. }, surface) => surface.ok(),
            (_, surface) => Some(surface?),
        };
        let round = outline.round()?;
        Ok(Self::of(outline, surface, round))
    }
}

/// Distance of the farthest of these places from the middle.
fn farthest(places: impl Iterator<Item = [f32; 2]>) -> f32 {
    let distances = places.map(|[x, y]| (x * x + y * y).sqrt());
    distances.fold(0.0, f32::max)
}

#[cfg(feature = "serde")]
impl From<Footprint> for Outline {
    fn from(footprint: Footprint) -> Self {
        footprint.inner.outline.clone()
    }
}

/// An outline of one positive length.
fn made(outline: Outline, given: f32) -> Result<Footprint, FootprintError> {
    let refused = FootprintError::Radius { given };
    if given > 0.0 && given.is_finite() {
        outline.try_into().map_err(|_: FrictionError| refused)
    } else {
        Err(refused)
    }
}
