//! Points that stand for an area, with their shares of the load: x, y and the share.

use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_friction::{Patch, round_nodes};

/// Largest number of points of a polygon.
pub(crate) const POINTS: usize = 256;
/// Points of a triangle that is not divided.
pub(crate) const TRIANGLE: usize = 7;
/// Points of a triangle whose edges are halved.
const FINE: usize = 4 * TRIANGLE;
/// Rings of points of a round area under any pressure.
const RINGS: u32 = 6;
/// Points of a bar.
const ALONG: usize = 16;
/// Gauss's four points on 0 … 1 and their weights (Abramowitz & Stegun 25.4.30): exact for moments up to degree 6.
const GAUSS: [[f32; 2]; 4] = [
    [0.069_431_84, 0.173_927_42],
    [0.330_009_5, 0.326_072_58],
    [0.669_990_52, 0.326_072_58],
    [0.930_568_16, 0.173_927_42],
];
/// Directions of an eighth of a turn, four steps apart: cosine and sine of 11.25° + 22.5° k.
const EIGHTH: [[f32; 2]; 2] = [[0.980_785_28, 0.195_090_32], [0.831_469_6, 0.555_570_23]];

pub(crate) fn bar_points(half: f32) -> Vec<[f32; 3]> {
    let share = 1.0 / ALONG as f32;
    let at = |k: usize| [half * ((2 * k + 1) as f32 * share - 1.0), 0.0, share];
    (0..ALONG).map(at).collect()
}

/// 16 points on a circle.
pub(crate) fn ring_points(radius: f32, whole: f32) -> Vec<[f32; 3]> {
    let share = whole / 16.0;
    let quarter = EIGHTH.into_iter().flat_map(|[c, s]| [[c, s], [s, c]]);
    let around = quarter.flat_map(|[c, s]| [[c, s], [-s, c], [-c, -s], [s, -c]]);
    around
        .map(|[c, s]| [radius * c, radius * s, share])
        .collect()
}

/// 64 points, exact for moments of the distance up to degree 6.
pub(crate) fn disk_points(radius: f32) -> Vec<[f32; 3]> {
    let circle = |[r, weight]: [f32; 2]| ring_points(radius * r, 2.0 * r * weight);
    GAUSS.into_iter().flat_map(circle).collect()
}

/// 72 points under the pressure of a patch; nothing for a patch that has been refused.
pub(crate) fn round_points(patch: &str, radius: f32) -> Vec<[f32; 3]> {
    let patch = patch.parse::<Patch>();
    let nodes = patch.and_then(|patch| round_nodes(&patch, radius, RINGS, 0.0));
    let nodes = nodes.unwrap_or_default();
    let whole: f32 = nodes.iter().map(|node| node.weight).sum();
    let point = |node: &Node<f32>| [node.x, node.y, node.weight / whole];
    nodes.iter().map(point).collect()
}

/// Nothing for a polygon that has been refused.
pub(crate) fn polygon_points(corners: &[[f32; 2]], divisions: u32) -> Vec<[f32; 3]> {
    let Ok(points) = NodeList::<f32, POINTS>::polygon(corners, divisions) else {
        return Vec::new();
    };
    let points: NodeList<f32, POINTS> = points;
    let whole = points.total_weight();
    let point = |node: &Node<f32>| [node.x, node.y, node.weight / whole];
    points.nodes().iter().map(point).collect()
}

/// The points themselves.
pub(crate) fn weighted_points(points: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let whole: f32 = points.iter().map(|[_, _, weight]| weight).sum();
    let share = |&[x, y, weight]: &[f32; 3]| [x, y, weight / whole];
    points.iter().map(share).collect()
}

/// The points of each triangle, weighted with its pressure.
pub(crate) fn mesh_points(vertices: &[[f32; 3]], triangles: &[[usize; 3]]) -> Vec<[f32; 3]> {
    let is_coarse = FINE * triangles.len() <= POINTS;
    let divisions = if is_coarse { 2 } else { 1 };
    let corners = |triangle: &[usize; 3]| triangle.map(|at| vertices.get(at).copied());
    let mut points = Vec::new();
    for triangle in triangles.iter().map(corners) {
        let [Some(a), Some(b), Some(c)] = triangle else {
            continue;
        };
        let places = [a, b, c].map(|[x, y, _]| [x, y]);
        // A triangle without area carries nothing.
        let Ok(nodes) = NodeList::<f32, FINE>::polygon(&places, divisions) else {
            continue;
        };
        let nodes: NodeList<f32, FINE> = nodes;
        let pressure = |node: &Node<f32>| {
            let [x, y] = [node.x - a[0], node.y - a[1]];
            let [[bx, by, p], [cx, cy, q]] =
                [b, c].map(|v| [v[0] - a[0], v[1] - a[1], v[2] - a[2]]);
            let whole = bx * cy - by * cx;
            a[2] + (x * cy - y * cx) / whole * p + (bx * y - by * x) / whole * q
        };
        points.extend(
            nodes
                .nodes()
                .iter()
                .map(|node| [node.x, node.y, node.weight * pressure(node)]),
        );
    }
    weighted_points(&points)
}
