//! The substrate, the piston and the edges of the box.

use super::BoxGeometry;
use crate::figure::Color;
use crate::solid::svg_canvas::{SvgCanvas, mixed};
use crate::solid::view::{Point, View};

/// Colours of the box's edges, of the substrate and of the piston.
const EDGE: Color = Color(150, 150, 150);
const SUBSTRATE: Color = Color(176, 176, 184);
const PISTON: Color = Color(120, 130, 150);
/// Shares of black in the sides of a plate that face the front and the right.
const SHADE: [f64; 2] = [0.18, 0.32];
/// Opacity of the piston: the spheres below stay visible.
const GLASS: f64 = 0.7;
/// Width of edges, px.
const THIN: f64 = 0.8;

/// Draws the parts behind the spheres.
pub(super) fn behind(paper: &mut SvgCanvas, view: &View, hall: &BoxGeometry) {
    slab(paper, view, hall, ([-hall.plate, 0.0], SUBSTRATE, 1.0));
    let [x, y] = hall.lengths;
    for (x, y) in [(0.0, 0.0), (0.0, y), (x, y)] {
        upright(paper, view, [x, y], hall.top);
    }
}

/// Draws plates given by their corners.
pub(super) fn inclined(paper: &mut SvgCanvas, view: &View, plates: &[[Point; 4]]) {
    for plate in plates {
        let places = plate.map(|corner| view.place(corner));
        paper.fill(&places, PISTON, GLASS);
    }
}

/// Draws the parts in front of the spheres: the edge nearest to the eye and the piston.
pub(super) fn before(paper: &mut SvgCanvas, view: &View, hall: &BoxGeometry) {
    upright(paper, view, [hall.lengths[0], 0.0], hall.top);
    if let Some(height) = hall.piston {
        slab(
            paper,
            view,
            hall,
            ([height, height + hall.plate], PISTON, GLASS),
        );
    }
}

// A vertical edge of the box.
fn upright(paper: &mut SvgCanvas, view: &View, [x, y]: [f64; 2], top: f64) {
    let ends = [[x, y, 0.0], [x, y, top]].map(|end| view.place(end));
    paper.line(&ends, EDGE, THIN);
}

// A plate over the whole box: the three faces that the eye sees.
fn slab(
    paper: &mut SvgCanvas,
    view: &View,
    hall: &BoxGeometry,
    ([low, high], color, opacity): ([f64; 2], Color, f64),
) {
    let [x, y] = hall.lengths;
    let top = [
        [0.0, 0.0, high],
        [x, 0.0, high],
        [x, y, high],
        [0.0, y, high],
    ];
    let front = [
        [0.0, 0.0, low],
        [x, 0.0, low],
        [x, 0.0, high],
        [0.0, 0.0, high],
    ];
    let right = [[x, 0.0, low], [x, y, low], [x, y, high], [x, 0.0, high]];
    let dark = SHADE.map(|share| mixed(color, Color(0, 0, 0), share));
    for (face, color) in [(top, color), (front, dark[0]), (right, dark[1])] {
        let places = face.map(|corner: Point| view.place(corner));
        paper.fill(&places, color, opacity);
    }
}
