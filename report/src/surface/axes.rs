//! Floor and back walls of the box with their grid, ticks, labels and names of the axes.

use crate::figure::axis::{Axis, Span};
use crate::figure::{Color, canvas};
use crate::solid::svg_canvas::{Anchor, SvgCanvas, width};
use crate::solid::view::{CanvasPoint, Point, View};

/// Colours of the frame, the grid and the walls.
const FRAME: Color = Color(80, 80, 80);
const GRID: Color = Color(214, 214, 214);
const WALL: Color = Color(247, 247, 247);
/// Length of a tick and distance of an axis' name from the labels, px.
const TICK: f64 = 4.0;
const NAME: f64 = 22.0;
/// From a tick's foot to its label, px: to the right and down for x, mirrored for y, left for z.
const BELOW: (f64, f64) = (4.0, 13.0);
const BESIDE: f64 = 8.0;
/// Text sizes of labels and names, px.
const SMALL: f64 = 12.0;
const LARGE: f64 = 14.0;
/// Pixels between two labels, about.
const APART: f64 = 30.0;

// One axis in the picture: positions and directions of its ticks.
struct Edge {
    // From the low to the high end.
    ends: [Point; 2],
    // Away from the box, in space.
    outward: Point,
    // From the end of a tick over the floor and up the wall, to its grid line's other ends.
    across: [Point; 2],
    anchor: Anchor,
    // From the foot of a tick to its label, px.
    label: CanvasPoint,
}

/// Draws everything behind the surface.
pub(super) fn draw(paper: &mut SvgCanvas, view: &View, (axes, spans): (&[Axis; 3], &[Span; 3])) {
    for wall in walls() {
        paper.fill(&wall.map(|corner| view.place(corner)), WALL, 1.0);
    }
    let edges = edges();
    let ticks: Vec<_> = edges
        .iter()
        .zip(spans)
        .map(|(edge, span)| ticks(edge, span, view))
        .collect();
    for (edge, ticks) in edges.iter().zip(&ticks) {
        for (share, _) in ticks {
            let start = between(edge.ends, *share);
            let middle = plus(start, edge.across[0], 1.0);
            let bend = [start, middle, plus(middle, edge.across[1], 1.0)];
            paper.line(&bend.map(|point| view.place(point)), GRID, 1.0);
        }
    }
    for wall in walls() {
        let [a, b, c, d] = wall.map(|corner| view.place(corner));
        paper.line(&[a, b, c, d, a], FRAME, 0.8);
    }
    for ((edge, ticks), axis) in edges.iter().zip(&ticks).zip(axes) {
        labels(paper, view, (edge, ticks, axis));
    }
}

// The floor, the wall behind the high end of x and that behind the high end of y.
fn walls() -> [[Point; 4]; 3] {
    let h = super::HEIGHT;
    [
        [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ],
        [
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 1.0, h],
            [1.0, 0.0, h],
        ],
        [
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 1.0, h],
            [0.0, 1.0, h],
        ],
    ]
}

// The near edges of the floor for x and y, the left edge of the walls for z.
fn edges() -> [Edge; 3] {
    let h = super::HEIGHT;
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, h]);
    [
        Edge {
            ends: [[0.0; 3], x],
            outward: [0.0, -1.0, 0.0],
            across: [y, z],
            anchor: Anchor::Start,
            label: BELOW,
        },
        Edge {
            ends: [[0.0; 3], y],
            outward: [-1.0, 0.0, 0.0],
            across: [x, z],
            anchor: Anchor::End,
            label: (-BELOW.0, BELOW.1),
        },
        Edge {
            ends: [y, [0.0, 1.0, h]],
            outward: [-1.0, 0.0, 0.0],
            across: [x, [0.0, -1.0, 0.0]],
            anchor: Anchor::End,
            label: (-BESIDE, 0.0),
        },
    ]
}

// As many ticks as the length of the edge in the picture allows.
fn ticks(edge: &Edge, span: &Span, view: &View) -> Vec<(f64, String)> {
    let [from, to] = edge.ends.map(|end| view.place(end));
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    let ticks = span.ticks((length / APART).max(2.0) as usize).0;
    ticks
        .into_iter()
        .filter(|tick| (0.0..=1.0).contains(&tick.0))
        .collect()
}

// Ticks, their labels, and the name of the axis along the edge.
fn labels(
    paper: &mut SvgCanvas,
    view: &View,
    (edge, ticks, axis): (&Edge, &[(f64, String)], &Axis),
) {
    let away = direction(view.place([0.0; 3]), view.place(edge.outward));
    let step = |place: CanvasPoint, far: f64| (place.0 + far * away.0, place.1 + far * away.1);
    for (share, label) in ticks {
        let place = view.place(between(edge.ends, *share));
        paper.line(&[place, step(place, TICK)], FRAME, 1.0);
        let beside = (place.0 + edge.label.0, place.1 + edge.label.1);
        paper.text(beside, label, SMALL, edge.anchor);
    }

    // The name reads from left to right, or upwards, and stands clear of the widest label.
    let widest = ticks
        .iter()
        .map(|tick| width(&tick.1, SMALL))
        .fold(0.0, f64::max);
    let [from, to] = edge.ends.map(|end| view.place(end));
    let [from, to] = if from.0 > to.0 {
        [to, from]
    } else {
        [from, to]
    };
    let along = direction(from, to);
    let normal = if along.1 * away.0 - along.0 * away.1 > 0.0 {
        (along.1, -along.0)
    } else {
        (-along.1, along.0)
    };
    let clear = widest * normal.0.abs() + SMALL * normal.1.abs() + NAME;
    let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
    let place = (middle.0 + clear * normal.0, middle.1 + clear * normal.1);
    let length = (to.0 - from.0).hypot(to.1 - from.1).max(1.0);
    let size = canvas::fitting(&axis.label, LARGE, (length * f64::from(canvas::PX)) as i32);
    let angle = along.1.atan2(along.0).to_degrees();
    paper.turned_text(place, &axis.label, size, Anchor::Middle, angle);
}

// The unit vector from one place to another.
fn direction(from: CanvasPoint, to: CanvasPoint) -> CanvasPoint {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let length = x.hypot(y).max(f64::MIN_POSITIVE);
    (x / length, y / length)
}

// The point at a share of the way.
fn between([from, to]: [Point; 2], share: f64) -> Point {
    std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]))
}

// A point moved by a multiple of a vector.
fn plus(point: Point, by: Point, times: f64) -> Point {
    std::array::from_fn(|axis| point[axis] + times * by[axis])
}
