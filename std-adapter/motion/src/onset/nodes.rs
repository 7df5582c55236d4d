//! Nodes of any patch by name, about its centre of pressure, and how far it reaches.

use super::strips;
use std::path::Path;
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch};
use tribos_core::patch::polygon::polygon_into;
use tribos_core::real::Real;
use tribos_friction::{
    FlatPatch, FrictionError, OwnedNodes, Patch, points_of, round_nodes, triangles_of,
};

/// Nodes with the origin at the centre of pressure.
#[derive(Debug)]
pub(super) struct CentredNodes {
    pub nodes: OwnedNodes,
    /// The centre of pressure in the patch's own coordinates.
    pub centre: [f64; 2],
    /// Distance of the farthest point of the patch from there.
    pub reach: f64,
}

/// Rings of nodes on a round patch: as in the kernel's standard rule.
const RINGS: u32 = 16;
/// Nodes of a bar.
pub(super) const ON_BAR: usize = 64;
/// Nodes of a triangle.
const ON_TRIANGLE: usize = 7;

/// The nodes of a patch; `radius` is that of a round one, `centre` the centre of pressure of a polygon.
pub(super) fn spread(
    patch: &Patch,
    radius: f64,
    centre: Option<[f64; 2]>,
) -> Result<CentredNodes, FrictionError> {
    match patch {
        Patch::Points(file) => about_centre(points_of(file)?),
        Patch::Flat(flat) => about_centre(of_flat(flat, centre)?),
        round => Ok(CentredNodes {
            nodes: OwnedNodes::new(of_round(round, radius)?)?,
            centre: [0.0; 2],
            reach: radius,
        }),
    }
}

fn of_round(patch: &Patch, radius: f64) -> Result<Vec<Node<f64>>, FrictionError> {
    Ok(match patch {
        // Smoother across the rings than nodes at the middles of equal shares.
        Patch::Annulus(inner) => {
            map_disk_to_annulus(&on_rings(&Patch::Disk, radius)?, *inner, radius)
        }
        _ => on_rings(patch, radius)?,
    })
}

fn on_rings(patch: &Patch, radius: f64) -> Result<Vec<Node<f64>>, FrictionError> {
    round_nodes(patch, radius, RINGS, 0.0)
}

/// The nodes of a disk moved into the annulus with the same shares of the area: r² is linear in r².
fn map_disk_to_annulus(disk: &[Node<f64>], inner: f64, radius: f64) -> Vec<Node<f64>> {
    let moved = |node: &Node<f64>| {
        let square = (node.x * node.x + node.y * node.y) / (radius * radius);
        let factor = (inner * inner / square + (1.0 - inner * inner)).sqrt();
        Node {
            x: node.x * factor,
            y: node.y * factor,
            ..*node
        }
    };
    disk.iter().map(moved).collect()
}

fn of_flat(flat: &FlatPatch, centre: Option<[f64; 2]>) -> Result<Vec<Node<f64>>, FrictionError> {
    // All refusals are those of the exact patch.
    flat.loaded::<f64>(centre)?;
    if let FlatPatch::Ellipse(_)
    | FlatPatch::HertzEllipse(_)
    | FlatPatch::Bolts(..)
    | FlatPatch::Feet(_) = flat
    {
        let reason = format!(
            "bonds have no nodes on {flat}: give a round patch, a box, a polygon, a bar, a mesh or points"
        );
        return Err(FrictionError::Unserved(reason));
    }
    if matches!(flat, FlatPatch::Bar(_)) && centre.is_some() {
        return Err(FrictionError::Unserved(
            "bonds of a bar are under uniform pressure: leave the centre of pressure out".into(),
        ));
    }
    if let FlatPatch::Mesh(file) = flat {
        return of_mesh(file);
    }
    let loops = flat.loops()?;
    if let (FlatPatch::Bar(_), Some(&[from, to])) = (flat, loops.first().map(Vec::as_slice)) {
        return Ok(of_bar(from, to));
    }
    let mut nodes = strips::nodes(&loops);
    if let Some(at) = centre {
        lean(&mut nodes, at);
    }
    nodes.extend(loops.iter().flatten().map(|&corner| edge(corner)));
    Ok(nodes)
}

/// A corner: it carries nothing and shows how far the patch reaches.
fn edge([x, y]: [f64; 2]) -> Node<f64> {
    Node { x, y, weight: 0.0 }
}

fn of_bar(from: [f64; 2], to: [f64; 2]) -> Vec<Node<f64>> {
    let at = |share: f64| [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]));
    let inside = strips::legendre(ON_BAR).into_iter().map(|[share, weight]| {
        let [x, y] = at(share);
        Node { x, y, weight }
    });
    inside.chain([edge(from), edge(to)]).collect()
}

/// Radon's nodes on each triangle, under its linear pressure.
fn of_mesh(file: &Path) -> Result<Vec<Node<f64>>, FrictionError> {
    let mut nodes = Vec::new();
    for [ax, ay, ap, bx, by, bp, cx, cy, cp] in triangles_of(file)? {
        let corners = [[ax, ay], [bx, by], [cx, cy]];
        let mut memory = [Node::default(); ON_TRIANGLE];
        let mut list = NodeBuffer::new(&mut memory);
        match polygon_into(&mut list, &corners, 1) {
            // A triangle without an area carries nothing.
            Err(PatchError::Hidden) => continue,
            made => made?,
        }
        let [ux, uy, vx, vy] = [bx - ax, by - ay, cx - ax, cy - ay];
        let area = ux * vy - uy * vx;
        for node in list.nodes() {
            let [x, y] = [node.x - ax, node.y - ay];
            let (along, across) = ((x * vy - y * vx) / area, (ux * y - uy * x) / area);
            let pressure = ap + along * (bp - ap) + across * (cp - ap);
            let weight = node.weight * pressure;
            nodes.push(Node { weight, ..*node });
        }
        if ap > 0.0 || bp > 0.0 || cp > 0.0 {
            nodes.extend(corners.map(edge));
        }
    }
    Ok(nodes)
}

/// Share-weighted mean place.
fn mean(nodes: &[Node<f64>]) -> [f64; 2] {
    let total: f64 = nodes.iter().map(|node| node.weight).sum();
    let [x, y] = nodes.iter().fold([0.0; 2], |[x, y], node| {
        [x + node.weight * node.x, y + node.weight * node.y]
    });
    [x / total, y / total]
}

/// Makes uniform nodes carry a linear pressure with its centre at `at`.
fn lean(nodes: &mut [Node<f64>], at: [f64; 2]) {
    let [cx, cy] = mean(nodes);
    let total: f64 = nodes.iter().map(|node| node.weight).sum();
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for node in nodes.iter() {
        let (x, y, share) = (node.x - cx, node.y - cy, node.weight / total);
        xx += share * x * x;
        xy += share * x * y;
        yy += share * y * y;
    }
    // The slope s of 1 + s·x moves the centre by the second moments times s.
    let (dx, dy, determinant) = (at[0] - cx, at[1] - cy, xx * yy - xy * xy);
    let (sx, sy) = (
        (yy * dx - xy * dy) / determinant,
        (xx * dy - xy * dx) / determinant,
    );
    for node in nodes {
        let pressure = 1.0 + sx * (node.x - cx) + sy * (node.y - cy);
        // Rounding alone makes it negative.
        node.weight *= pressure.max(0.0);
    }
}

fn about_centre(mut nodes: Vec<Node<f64>>) -> Result<CentredNodes, FrictionError> {
    // Refuses nodes that carry nothing.
    let centre = mean(OwnedNodes::new(nodes.clone())?.nodes());
    let mut reach: f64 = 0.0;
    for node in &mut nodes {
        node.x -= centre[0];
        node.y -= centre[1];
        reach = reach.max(Real::hypot(node.x, node.y));
    }
    Ok(CentredNodes {
        nodes: OwnedNodes::new(nodes)?,
        centre,
        reach,
    })
}
