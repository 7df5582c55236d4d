//! Arranges title, axes, curves and legend of one figure in a rectangle.

use super::Figure;
use super::axis::Span;
use super::curves::{self, Plane};
use super::error::FigureError;
use super::font;
use super::frame::{self, MAJOR, PAD, TICK_SIZE, TITLE_LINE, TITLE_SIZE};
use super::guides::{self, Guide};
use super::legend::{Block, Legend};
use super::scene::{Color, Point, Rect, Scene, snapped};
use super::ticks::{Ticks, ticks};

// Room for the labels of the axes in pixels.
const X_TICK_ROOM: f64 = 24.0;
const X_LABEL_ROOM: f64 = 24.0;
const Y_LABEL_ROOM: f64 = 24.0;

/// The parts of a figure at their places.
pub(super) struct Layout {
    pub plane: Plane,
    pub x_ticks: Ticks,
    pub y_ticks: Ticks,
    pub title: Vec<String>,
    pub legend: Block,
    pub cell: Rect,
}

/// Draws a figure into a rectangle of the scene.
pub(super) fn draw(figure: &Figure, cell: Rect, scene: &mut Scene) -> Result<(), FigureError> {
    let layout = arrange(figure, cell)?;
    let plane = &layout.plane;

    // Areas and lines from back to front.
    for region in &figure.regions {
        guides::fill(region, plane, scene);
    }
    if figure.regions.is_empty() {
        frame::grid(&layout, scene);
    }
    for guide in &figure.guides {
        guides::rule(guide, plane, scene);
    }
    for (index, series) in figure.series.iter().enumerate() {
        curves::draw(series, index, plane, scene);
    }
    frame::axes(figure, &layout, scene);

    // Texts over everything else.
    for region in &figure.regions {
        guides::region_label(region, plane, scene);
    }
    let mut taken: Vec<Rect> = legend(figure, &layout, scene).into_iter().collect();
    let trail = trail(figure, plane);
    for guide in &figure.guides {
        guides::rule_label(guide, plane, &trail, &mut taken, scene);
    }
    Ok(())
}

// Finds the plot rectangle that leaves room for everything around it.
fn arrange(figure: &Figure, cell: Rect) -> Result<Layout, FigureError> {
    let (x, y) = spans(figure)?;
    let title = font::wrap(&figure.title, TITLE_SIZE, cell.width() - 2.0 * PAD);
    let legend = match figure.legend {
        Legend::Hidden => Block::default(),
        Legend::Below => Block::rows(&figure.series, cell.width() - 2.0 * PAD),
        Legend::Right => Block::column(&figure.series, 0.34 * cell.width()),
        _ => Block::column(&figure.series, 0.5 * cell.width()),
    };

    // Height first, since it decides the labels at the left.
    let below = if figure.legend == Legend::Below {
        legend.height
    } else {
        0.0
    };
    let x_label = if figure.x.label.is_empty() {
        0.0
    } else {
        X_LABEL_ROOM
    };
    let y_label = if figure.y.label.is_empty() {
        0.0
    } else {
        Y_LABEL_ROOM
    };
    let mut plot = cell;
    plot.bottom -= PAD + X_TICK_ROOM + x_label + below;
    plot.top += PAD + TITLE_LINE * title.len() as f64;
    let y_ticks = ticks(&y, (plot.height() / 45.0) as usize);
    if y_ticks.factor.is_some() {
        plot.top += 14.0;
    }
    plot.top = snapped(plot.top);
    plot.bottom = snapped(plot.bottom.max(plot.top + 20.0));

    // Then the width left between tick labels and legend.
    plot.left += PAD + y_label + widest(&y_ticks) + MAJOR + 4.0;
    plot.right -= match figure.legend {
        Legend::Right if !legend.is_empty() => legend.width + PAD,
        _ => PAD + 10.0,
    };
    plot.left = snapped(plot.left);
    plot.right = snapped(plot.right.max(plot.left + 20.0));
    let x_ticks = spaced_ticks(&x, plot.width());
    Ok(Layout {
        plane: Plane { x, y, plot },
        x_ticks,
        y_ticks,
        title,
        legend,
        cell,
    })
}

// Spans of both axes from the points, regions and reference lines.
fn spans(figure: &Figure) -> Result<(Span, Span), FigureError> {
    let corners = figure.regions.iter().flat_map(|region| &region.outline);
    let points = figure.series.iter().flat_map(|series| &series.points);
    let points: Vec<(f64, f64)> = points.chain(corners).copied().collect();
    let across = figure.guides.iter().filter_map(|guide| match guide {
        Guide::Vertical { at, .. } => Some(*at),
        Guide::Horizontal { .. } => None,
    });
    let upright = figure.guides.iter().filter_map(|guide| match guide {
        Guide::Horizontal { at, .. } => Some(*at),
        Guide::Vertical { .. } => None,
    });
    let x = Span::new(&figure.x, points.iter().map(|point| point.0).chain(across))?;

    // Heights of points beside the plot do not count.
    let (low, high) = figure.x.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let shown = points
        .iter()
        .filter(|point| (low..=high).contains(&point.0));
    let y = Span::new(&figure.y, shown.map(|point| point.1).chain(upright))?;
    Ok((x, y))
}

// As many ticks as fit with their labels apart.
fn spaced_ticks(span: &Span, width: f64) -> Ticks {
    let mut target = ((width / 75.0) as usize).clamp(2, 12);
    loop {
        let ticks = ticks(span, target);
        let labelled: Vec<f64> = ticks
            .marks
            .iter()
            .filter(|tick| !tick.label.is_empty())
            .map(|tick| tick.at * width)
            .collect();
        let needed = widest(&ticks) + 10.0;
        if target <= 2 || labelled.windows(2).all(|pair| pair[1] - pair[0] >= needed) {
            return ticks;
        }
        target -= 1;
    }
}

// Width of the longest tick label.
fn widest(ticks: &Ticks) -> f64 {
    let labels = ticks
        .marks
        .iter()
        .map(|tick| font::width(&tick.label, TICK_SIZE));
    labels.fold(0.0, f64::max)
}

// Draws the legend and tells which part of the plot it covers.
fn legend(figure: &Figure, layout: &Layout, scene: &mut Scene) -> Option<Rect> {
    let (block, cell, plot) = (&layout.legend, &layout.cell, &layout.plane.plot);
    if block.is_empty() {
        return None;
    }
    match figure.legend {
        Legend::Hidden => None,
        Legend::Right => {
            let at = (plot.right + PAD / 2.0, plot.top - 8.0);
            block.draw(at, &figure.series, scene);
            None
        }
        Legend::Below => {
            let left = (plot.left + plot.right - block.width) / 2.0;
            let left = left.min(cell.right - PAD - block.width).max(cell.left);
            let at = (left, cell.bottom - PAD / 2.0 - block.height);
            block.draw(at, &figure.series, scene);
            None
        }
        // Curves under a legend stay visible.
        corner => {
            let covered = block.corner(corner, plot);
            scene.fill(covered.corners(), Color(255, 255, 255), 0.85);
            frame::outline(&covered, frame::GRID, scene);
            block.draw((covered.left, covered.top), &figure.series, scene);
            Some(covered)
        }
    }
}

// Pixels along all curves, dense enough to find free places for labels.
fn trail(figure: &Figure, plane: &Plane) -> Vec<Point> {
    let mut trail = Vec::new();
    for series in &figure.series {
        for piece in plane.pieces(&series.points) {
            for pair in piece.windows(2) {
                let (from, to) = (pair[0], pair[1]);
                let steps = ((to.0 - from.0).hypot(to.1 - from.1) / 4.0).ceil().max(1.0);
                trail.extend((0..=steps as usize).map(|step| {
                    let share = step as f64 / steps;
                    let x = from.0 + share * (to.0 - from.0);
                    (x, from.1 + share * (to.1 - from.1))
                }));
            }
        }
        if series.style.has_markers() {
            trail.extend(series.points.iter().filter_map(|point| plane.pixel(*point)));
        }
    }
    trail
}
