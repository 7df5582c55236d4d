//! Areas turned, moved and stretched, and cut along straight borders.

use super::arc_piece::ArcPiece;
use super::flat::Flat;
use super::owned_feet::OwnedFeet;
use super::surface::DryRound;
use super::{FrictionError, OwnedNodes, Precision};
use tribos_core::patch::affine_image::{AffineImage, AffineMap, image_of};
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::feet::PatchPart;
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::{Node, NodePatch};
use tribos_core::patch::outline::Edge;
use tribos_core::patch::piece::{HalfPlane, PatchPiece};
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;
use tribos_core::real::Real;

impl<R: Precision> AffineImage<R> for Flat<R> {
    fn image(self, map: &AffineMap<R>) -> Option<Self> {
        Some(match self {
            Self::Polygon(patch) => Self::Polygon(patch.image(map)?),
            Self::Leaning(patch) => Self::Leaning(patch.image(map)?),
            Self::Bar(patch) => Self::Bar(patch.image(map)?),
            Self::LeaningBar(patch) => Self::LeaningBar(patch.image(map)?),
            Self::Mesh(patch) => Self::Mesh(patch.image(map)?),
            Self::Points(patch) => Self::Points(patch.moved(map, |nodes| nodes.moved(map))),
            Self::Ellipse(patch) => Self::Ellipse(patch.image(map)?),
            // Pieces are made of patches that are in their place.
            Self::ArcPiece(_) => return None,
            Self::Round(patch) => return round_image(*patch, map),
            Self::Anisotropic(patch) => Self::Anisotropic(Box::new(patch.placed(map)?)),
            Self::Feet(feet) => {
                let parts = feet.feet().iter().map(|part| {
                    let patch = part.patch.clone().image(map)?;
                    Some(PatchPart { patch, ..*part })
                });
                let parts: Option<Vec<_>> = parts.collect();
                Self::Feet(OwnedFeet::new(parts?).ok()?)
            }
        })
    }
}

/// A round patch elsewhere; stretched it is an ellipse, if it has the pressure of one.
fn round_image<R: Precision>(
    patch: RoundPatch<R, DryRound<R>>,
    map: &AffineMap<R>,
) -> Option<Flat<R>> {
    let [first, second] = map.rows;
    if first.x != second.y || first.y != -second.x {
        return Some(Flat::Ellipse(elliptic(&patch)?.image(map)?));
    }
    let scale = first.x.hypot(first.y);
    let centre = map.of(&patch.centre()).into();
    let moved = RoundPatch::new(*patch.coupling(), centre, patch.radius() * scale).ok()?;
    Some(Flat::Round(Box::new(moved)))
}

impl<R: Real> OwnedNodes<R> {
    /// The same weights at the images of their places.
    fn moved(mut self, map: &AffineMap<R>) -> Self {
        self.change(|node| *node = image_of(map, node));
        self
    }
}

impl<R: Precision> Flat<R> {
    /// What of the area lies within a half-plane, with its share of the load; `None` if nothing does.
    pub(super) fn within(
        &self,
        side: &HalfPlane<R>,
    ) -> Result<Option<PatchPiece<R, Self>>, FrictionError> {
        fn of<R: Real, P, Q>(
            piece: PatchPiece<R, P>,
            patch: impl FnOnce(P) -> Q,
        ) -> PatchPiece<R, Q> {
            let share = piece.share;
            PatchPiece {
                patch: patch(piece.patch),
                share,
            }
        }
        Ok(match self {
            Self::Polygon(patch) => {
                let memory = vec![Edge::default(); 2 * patch.edge_count()];
                let piece = patch
                    .within(side, memory)
                    .map_err(tribos_core::Error::from)?;
                piece.map(|piece| of(piece, Self::Polygon))
            }
            Self::Leaning(patch) => {
                let memory = vec![Edge::default(); 2 * patch.edge_count()];
                let piece = patch
                    .within(side, memory)
                    .map_err(tribos_core::Error::from)?;
                piece.map(|piece| of(piece, Self::Leaning))
            }
            Self::Bar(bar) => bar.within(side).map(|piece| of(piece, Self::Bar)),
            Self::LeaningBar(bar) => bar.within(side).map(|piece| of(piece, Self::LeaningBar)),
            Self::Mesh(mesh) => mesh_within(mesh, side)?,
            Self::Points(points) => points_within(points, side)?,
            Self::Ellipse(patch) => ArcPiece::of_ellipse(patch, side)?,
            Self::ArcPiece(patch) => patch.within(side)?,
            Self::Round(patch) => round_within(patch, side)?,
            Self::Anisotropic(patch) => {
                let piece = patch.stretched().within(&patch.stretched_side(side))?;
                let back = |piece| Self::Anisotropic(Box::new(patch.with_stretched(piece)));
                piece.map(|piece| of(piece, back))
            }
            Self::Feet(feet) => {
                let (mut parts, mut total, mut kept) = (Vec::new(), R::ZERO, R::ZERO);
                for part in feet.feet() {
                    total += part.load;
                    if let Some(PatchPiece { patch, share }) = part.patch.within(side)? {
                        let load = part.load * share;
                        kept += load;
                        parts.push(PatchPart { patch, load });
                    }
                }
                if kept > R::ZERO {
                    let patch = Self::Feet(OwnedFeet::new(parts)?);
                    let share = kept / total;
                    Some(PatchPiece { patch, share })
                } else {
                    None
                }
            }
        })
    }
}

/// The triangles, and parts of triangles, on one side.
fn mesh_within<R: Precision>(
    mesh: &Mesh<R, Vec<Triangle<R>>>,
    side: &HalfPlane<R>,
) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
    let mut vertices: Vec<Vertex<R>> = Vec::new();
    let mut triangles = Vec::new();
    for corners in mesh.corners() {
        let mut kept: Vec<Vertex<R>> = Vec::with_capacity(4);
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (from, to) = (corners[a], corners[b]);
            if side.contains([from.x, from.y]) {
                kept.push(from);
            }
            if let Some(at) = side.crossing([[from.x, from.y], [to.x, to.y]]) {
                kept.push(Vertex {
                    x: from.x + (to.x - from.x) * at,
                    y: from.y + (to.y - from.y) * at,
                    pressure: from.pressure + (to.pressure - from.pressure) * at,
                });
            }
        }
        let first = vertices.len();
        for last in 2..kept.len() {
            triangles.push([first, first + last - 1, first + last]);
        }
        vertices.extend(kept);
    }
    let memory = vec![Triangle::default(); triangles.len()];
    // What is left may carry nothing.
    let Ok(piece) = Mesh::with_vertices(&vertices, &triangles, memory) else {
        return Ok(None);
    };
    // The corners' pressures are such that the whole carries 1 per squared radius.
    let share = piece.load() / (mesh.radius() * mesh.radius());
    Ok(Some(PatchPiece {
        patch: Flat::Mesh(piece),
        share,
    }))
}

/// The points on one side.
fn points_within<R: Precision>(
    points: &PointPatch<R, OwnedNodes<R>>,
    side: &HalfPlane<R>,
) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
    let nodes = points.nodes().nodes().iter().copied();
    let kept: Vec<Node<R>> = nodes
        .filter(|node| side.contains([node.x, node.y]))
        .collect();
    let Ok(nodes) = OwnedNodes::new(kept) else {
        return Ok(None);
    };
    let share = nodes.total_weight() / points.nodes().total_weight();
    let patch = PointPatch::new(nodes).map_err(|_| {
        FrictionError::Unserved(
            "a single point stands on a surface of its own: give it a small patch, such as disk with its radius".into(),
        )
    })?;
    Ok(Some(PatchPiece {
        patch: Flat::Points(patch),
        share,
    }))
}

/// A round patch on one side; one that is cut is a piece of an ellipse.
fn round_within<R: Precision>(
    patch: &RoundPatch<R, DryRound<R>>,
    side: &HalfPlane<R>,
) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
    let centre = patch.centre();
    let distance = side.distance_of([centre.x, centre.y]);
    if distance.abs() >= patch.radius() {
        return Ok((distance > R::ZERO).then(|| PatchPiece {
            patch: Flat::Round(Box::new(*patch)),
            share: R::ONE,
        }));
    }
    match elliptic(patch) {
        Some(ellipse) => ArcPiece::of_ellipse(&ellipse, side),
        None => Err(FrictionError::Unserved(
            "a border runs through a ring, an annulus or another round patch whose pressure is not uniform: give the patch \
             as a mesh of triangles, or as points"
                .into(),
        )),
    }
}

/// A round patch as an ellipse, if it has the pressure of one.
fn elliptic<R: Precision>(patch: &RoundPatch<R, DryRound<R>>) -> Option<Ellipse<R>> {
    let pressure = match patch.coupling() {
        DryRound::Disk(_) => EllipsePressure::Uniform,
        DryRound::Hertz(_) => EllipsePressure::Hertz,
        DryRound::Punch(_) => EllipsePressure::FlatPunch,
        DryRound::Paraboloid(_) => EllipsePressure::Paraboloid,
        _ => return None,
    };
    let semi_axes = [patch.radius(); 2];
    Ellipse::new(patch.centre().into(), semi_axes, pressure).ok()
}
