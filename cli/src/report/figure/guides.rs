//! Reference lines and filled regions with their labels.

use super::curves::{Plane, clip_polygon};
use super::font;
use super::scene::{Anchor, Color, Point, Rect, Scene, snapped};

// Colour and text size of reference lines.
const GREY: Color = Color(150, 150, 150);
const GREY_TEXT: Color = Color(95, 95, 95);
const LABEL_SIZE: f64 = 12.0;

// Colour and text size of region labels.
const REGION_TEXT: Color = Color(45, 45, 45);
const REGION_SIZE: f64 = 14.0;

/// A thin grey reference line across the plot.
#[derive(Debug, Clone, PartialEq)]
pub enum Guide {
    /// A line at one y value.
    Horizontal {
        /// The y value.
        at: f64,
        /// Text beside the line, may be empty.
        label: String,
    },
    /// A line at one x value.
    Vertical {
        /// The x value.
        at: f64,
        /// Text beside the line, may be empty.
        label: String,
    },
}

impl Guide {
    /// A line at one y value.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Horizontal { at, label }
    }

    /// A line at one x value.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Vertical { at, label }
    }
}

/// A filled polygon of a phase diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Text inside the region; line breaks are kept.
    pub label: String,
    /// Corners in data coordinates.
    pub outline: Vec<(f64, f64)>,
    /// Fill colour; `Color::pale` gives fitting ones.
    pub fill: Color,
    /// Centre of the label in data coordinates.
    pub label_at: (f64, f64),
}

/// Fills a region.
pub(super) fn fill(region: &Region, plane: &Plane, scene: &mut Scene) {
    let corners = region.outline.iter();
    let corners: Vec<Point> = corners.filter_map(|point| plane.corner(*point)).collect();
    let shown = clip_polygon(&corners, &plane.plot);
    if shown.len() > 2 {
        scene.fill(shown, region.fill, 1.0);
    }
}

/// Writes the label of a region, centred line by line and kept inside the plot.
pub(super) fn region_label(region: &Region, plane: &Plane, scene: &mut Scene) {
    let Some((x, y)) = plane.corner(region.label_at) else {
        return;
    };
    let lines: Vec<&str> = region.label.lines().collect();
    let widths = lines.iter().map(|line| font::width(line, REGION_SIZE));
    let half = widths.fold(0.0, f64::max) / 2.0 + 4.0;
    let height = 1.25 * REGION_SIZE * lines.len() as f64;
    let plot = &plane.plot;
    let x = x.min(plot.right - half).max(plot.left + half);
    let top = (y - height / 2.0)
        .min(plot.bottom - height - 4.0)
        .max(plot.top + 4.0);
    for (index, line) in lines.iter().enumerate() {
        let baseline = top + REGION_SIZE * (0.95 + 1.25 * index as f64);
        scene.text(
            line,
            (x, baseline),
            REGION_SIZE,
            REGION_TEXT,
            Anchor::Middle,
        );
    }
}

/// Draws a reference line, if it lies inside the plot.
pub(super) fn rule(guide: &Guide, plane: &Plane, scene: &mut Scene) {
    let plot = &plane.plot;
    match (guide, position(guide, plane)) {
        (Guide::Horizontal { .. }, Some(y)) => {
            scene.stroke(vec![(plot.left, y), (plot.right, y)], 1.0, GREY);
        }
        (Guide::Vertical { .. }, Some(x)) => {
            scene.stroke(vec![(x, plot.top), (x, plot.bottom)], 1.0, GREY);
        }
        (_, None) => {}
    }
}

/// Writes the label of a reference line where it hides least.
pub(super) fn rule_label(
    guide: &Guide,
    plane: &Plane,
    curves: &[Point],
    taken: &mut Vec<Rect>,
    scene: &mut Scene,
) {
    let (Guide::Horizontal { label, .. } | Guide::Vertical { label, .. }) = guide;
    let Some(at) = position(guide, plane).filter(|_| !label.is_empty()) else {
        return;
    };
    let upwards = matches!(guide, Guide::Vertical { .. });
    let places = places(upwards, at, font::width(label, LABEL_SIZE), &plane.plot);

    // Fewest hidden labels first, then fewest hidden curve points.
    let cost = |place: &Rect| {
        let labels = taken.iter().filter(|other| other.overlaps(place)).count();
        let outside = !plane.plot.holds((place.left, place.top))
            || !plane.plot.holds((place.right, place.bottom));
        let points = curves.iter().filter(|point| place.holds(**point)).count();
        (labels, outside, points)
    };
    let Some(place) = places.into_iter().min_by_key(cost) else {
        return;
    };

    // Curves under a label turn pale so that it can be read.
    if curves.iter().any(|point| place.holds(*point)) {
        scene.fill(place.corners(), Color(255, 255, 255), 0.75);
    }
    if upwards {
        let start = (place.right - 0.3 * LABEL_SIZE, place.bottom - 2.0);
        scene.text_upwards(label, start, LABEL_SIZE, GREY_TEXT, Anchor::Start);
    } else {
        let start = (place.left + 2.0, place.bottom - 0.3 * LABEL_SIZE);
        scene.text(label, start, LABEL_SIZE, GREY_TEXT, Anchor::Start);
    }
    taken.push(place);
}

// Possible boxes for a label beside a line: either side, several places along it.
fn places(upwards: bool, at: f64, width: f64, plot: &Rect) -> Vec<Rect> {
    let (length, height) = (width + 4.0, 1.25 * LABEL_SIZE);
    let mut places = Vec::new();
    for side in [at - height - 2.0, at + 2.0] {
        for share in [1.0, 0.0, 0.75, 0.5, 0.25] {
            places.push(if upwards {
                let room = plot.height() - length - 8.0;
                let top = plot.top + 4.0 + (1.0 - share) * room;
                Rect::new(side, top, side + height, top + length)
            } else {
                let room = plot.width() - length - 8.0;
                let left = plot.left + 4.0 + share * room;
                Rect::new(left, side, left + length, side + height)
            });
        }
    }
    places
}

// Pixel position of a reference line across the plot.
fn position(guide: &Guide, plane: &Plane) -> Option<f64> {
    let plot = &plane.plot;
    let (share, start, extent) = match guide {
        Guide::Horizontal { at, .. } => (plane.y.place(*at)?, plot.bottom, -plot.height()),
        Guide::Vertical { at, .. } => (plane.x.place(*at)?, plot.left, plot.width()),
    };
    (0.0..=1.0)
        .contains(&share)
        .then_some(snapped(start + share * extent))
}
