//! Title, grid, frame, ticks and axis labels around a plot.

use super::Figure;
use super::font;
use super::layout::Layout;
use super::scene::{Anchor, Color, Rect, Scene, snapped};
use super::ticks::Tick;

/// Text sizes in pixels.
pub(super) const TITLE_SIZE: f64 = 16.0;
pub(super) const TICK_SIZE: f64 = 12.0;
const LABEL_SIZE: f64 = 14.0;

/// Room around a figure and for each line of its title in pixels.
pub(super) const PAD: f64 = 12.0;
pub(super) const TITLE_LINE: f64 = 22.0;

/// Lengths of major and minor ticks in pixels.
pub(super) const MAJOR: f64 = 5.0;
const MINOR: f64 = 3.0;

/// Colours of texts, frame and grid lines.
const TEXT: Color = Color(30, 30, 30);
const FRAME: Color = Color(70, 70, 70);
pub(super) const GRID: Color = Color(230, 230, 230);

/// Pale lines at all labelled ticks.
pub(super) fn grid(layout: &Layout, scene: &mut Scene) {
    let plot = &layout.plane.plot;
    for tick in labelled(&layout.x_ticks.marks) {
        let x = snapped(plot.left + tick.at * plot.width());
        scene.stroke(vec![(x, plot.top), (x, plot.bottom)], 1.0, GRID);
    }
    for tick in labelled(&layout.y_ticks.marks) {
        let y = snapped(plot.bottom - tick.at * plot.height());
        scene.stroke(vec![(plot.left, y), (plot.right, y)], 1.0, GRID);
    }
}

/// The frame with ticks and all texts around it.
pub(super) fn axes(figure: &Figure, layout: &Layout, scene: &mut Scene) {
    let plot = &layout.plane.plot;
    outline(plot, FRAME, scene);
    x_ticks(layout, scene);
    y_ticks(layout, scene);
    title(layout, scene);
    labels(figure, layout, scene);
}

/// A thin line around a rectangle.
pub(super) fn outline(rect: &Rect, color: Color, scene: &mut Scene) {
    let mut border = rect.corners();
    border.extend([(rect.left, rect.top), (rect.right, rect.top)]);
    scene.stroke(border, 1.0, color);
}

// Ticks and numbers under the plot.
fn x_ticks(layout: &Layout, scene: &mut Scene) {
    let plot = &layout.plane.plot;
    for tick in &layout.x_ticks.marks {
        let x = snapped(plot.left + tick.at * plot.width());
        let end = plot.bottom + length(tick);
        scene.stroke(vec![(x, plot.bottom), (x, end)], 1.0, FRAME);
        let at = (x, plot.bottom + MAJOR + 3.0 + TICK_SIZE);
        scene.text(&tick.label, at, TICK_SIZE, TEXT, Anchor::Middle);
    }
    if let Some(factor) = &layout.x_ticks.factor {
        let at = (plot.right, plot.bottom + MAJOR + 22.0 + TICK_SIZE);
        scene.text(factor, at, TICK_SIZE, TEXT, Anchor::End);
    }
}

// Ticks and numbers at the left of the plot.
fn y_ticks(layout: &Layout, scene: &mut Scene) {
    let plot = &layout.plane.plot;
    for tick in &layout.y_ticks.marks {
        let y = snapped(plot.bottom - tick.at * plot.height());
        let end = plot.left - length(tick);
        scene.stroke(vec![(end, y), (plot.left, y)], 1.0, FRAME);
        let at = (plot.left - MAJOR - 3.0, y + 0.36 * TICK_SIZE);
        scene.text(&tick.label, at, TICK_SIZE, TEXT, Anchor::End);
    }
    if let Some(factor) = &layout.y_ticks.factor {
        let at = (plot.left, plot.top - 6.0);
        scene.text(factor, at, TICK_SIZE, TEXT, Anchor::Start);
    }
}

// The title, centred over the plot as far as the figure is wide enough.
fn title(layout: &Layout, scene: &mut Scene) {
    let (plot, cell) = (&layout.plane.plot, &layout.cell);
    let widths = layout
        .title
        .iter()
        .map(|line| font::width(line, TITLE_SIZE));
    let half = widths.fold(0.0, f64::max) / 2.0;
    let middle = (plot.left + plot.right) / 2.0;
    let middle = middle
        .min(cell.right - PAD - half)
        .max(cell.left + PAD + half);
    for (row, line) in layout.title.iter().enumerate() {
        let baseline = cell.top + PAD + TITLE_LINE * row as f64 + 0.75 * TITLE_SIZE;
        let at = (middle, baseline);
        scene.text(line, at, TITLE_SIZE, TEXT, Anchor::Middle);
    }
}

// The names of both axes, made smaller when too long.
fn labels(figure: &Figure, layout: &Layout, scene: &mut Scene) {
    let (plot, cell) = (&layout.plane.plot, &layout.cell);
    let (x, y) = (&figure.x.label, &figure.y.label);
    let middle = |rect: &Rect| (rect.left + rect.right) / 2.0;
    if !x.is_empty() {
        let size = font::fitting_size(x, LABEL_SIZE, plot.width());
        let at = (
            middle(plot),
            plot.bottom + MAJOR + TICK_SIZE + 9.0 + LABEL_SIZE,
        );
        scene.text(x, at, size, TEXT, Anchor::Middle);
    }
    if !y.is_empty() {
        let size = font::fitting_size(y, LABEL_SIZE, plot.height());
        let at = (
            cell.left + PAD + 0.8 * LABEL_SIZE,
            (plot.top + plot.bottom) / 2.0,
        );
        scene.text_upwards(y, at, size, TEXT, Anchor::Middle);
    }
}

// Length of a tick line.
fn length(tick: &Tick) -> f64 {
    if tick.label.is_empty() { MINOR } else { MAJOR }
}

// Ticks that have a label.
fn labelled(ticks: &[Tick]) -> impl Iterator<Item = &Tick> {
    ticks.iter().filter(|tick| !tick.label.is_empty())
}
