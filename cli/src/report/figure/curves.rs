//! Breaking, clipping and dashing of curves, and their markers.

use super::axis::Span;
use super::scene::{Color, Point, Rect, Scene};
use super::series::{Series, Style};

/// Width of a curve in pixels.
pub(super) const LINE_WIDTH: f64 = 2.0;

// Lengths of dash and gap in pixels.
const DASH: (f64, f64) = (8.0, 5.0);

// Half the size of a marker in pixels.
const MARKER: f64 = 3.6;

/// Maps values to pixels inside the plot rectangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    pub x: Span,
    pub y: Span,
    pub plot: Rect,
}

impl Plane {
    /// Pixel of a point, or nothing when it cannot be shown.
    pub fn pixel(&self, (x, y): (f64, f64)) -> Option<Point> {
        Some(self.at(self.x.place(x)?, self.y.place(y)?))
    }

    /// Pixel of a region corner; values below a log axis move to its far end.
    pub fn corner(&self, (x, y): (f64, f64)) -> Option<Point> {
        Some(self.at(self.x.place_or_end(x)?, self.y.place_or_end(y)?))
    }

    // Pixel of a position given as shares of the plot.
    fn at(&self, x: f64, y: f64) -> Point {
        let left = self.plot.left + x * self.plot.width();
        (left, self.plot.bottom - y * self.plot.height())
    }

    /// Unbroken pieces of a curve inside the plot.
    pub fn pieces(&self, points: &[(f64, f64)]) -> Vec<Vec<Point>> {
        let mut pieces = Vec::new();
        let mut run: Vec<Point> = Vec::new();
        for point in points {
            match self.pixel(*point) {
                // Points closer than the eye can tell are left out.
                Some(pixel) if run.last().is_none_or(|last| distance(*last, pixel) > 0.2) => {
                    run.push(pixel);
                }
                Some(_) => {}
                None => pieces.extend(clip_run(&std::mem::take(&mut run), &self.plot)),
            }
        }
        pieces.extend(clip_run(&run, &self.plot));
        pieces
    }
}

/// Draws one series into the plot.
pub(super) fn draw(series: &Series, index: usize, plane: &Plane, scene: &mut Scene) {
    let color = series.shown_color(index);
    if series.style.has_line() {
        for piece in plane.pieces(&series.points) {
            line(&piece, series.style, color, scene);
        }
    }
    if series.style.has_markers() {
        let pixels = series.points.iter().filter_map(|point| plane.pixel(*point));
        for pixel in pixels.filter(|pixel| plane.plot.holds(*pixel)) {
            marker(pixel, index, color, scene);
        }
    }
}

/// Draws one unbroken line, dashed when the style asks for it.
pub(super) fn line(piece: &[Point], style: Style, color: Color, scene: &mut Scene) {
    if style == Style::Dashed {
        for dash in dashes(piece) {
            scene.stroke(dash, LINE_WIDTH, color);
        }
    } else {
        scene.stroke(piece.to_vec(), LINE_WIDTH, color);
    }
}

/// Draws a marker whose shape follows the place of the series.
pub(super) fn marker((x, y): Point, index: usize, color: Color, scene: &mut Scene) {
    let r = MARKER;
    let outline = match index % 4 {
        0 => {
            let at = (x, y);
            let radius = r;
            let disc = super::scene::Mark::Disc { at, radius, color };
            return scene.marks.push(disc);
        }
        1 => Rect::new(x - r, y - r, x + r, y + r).corners(),
        2 => vec![(x, y - 1.2 * r), (x + 1.2 * r, y + r), (x - 1.2 * r, y + r)],
        _ => vec![
            (x, y - 1.4 * r),
            (x + 1.4 * r, y),
            (x, y + 1.4 * r),
            (x - 1.4 * r, y),
        ],
    };
    scene.fill(outline, color, 1.0);
}

// Pieces of a line that lie inside a rectangle.
fn clip_run(run: &[Point], rect: &Rect) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    for pair in run.windows(2) {
        let Some((from, to)) = clip_segment(pair[0], pair[1], rect) else {
            continue;
        };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

// The part of a segment inside a rectangle (Liang and Barsky).
fn clip_segment(from: Point, to: Point, rect: &Rect) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let sides = [
        (-dx, from.0 - rect.left),
        (dx, rect.right - from.0),
        (-dy, from.1 - rect.top),
        (dy, rect.bottom - from.1),
    ];
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    for (slope, room) in sides {
        if slope < 0.0 {
            start = start.max(room / slope);
        } else if slope > 0.0 {
            end = end.min(room / slope);
        } else if room < 0.0 {
            return None;
        }
    }
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    let first = if start > 0.0 { at(start) } else { from };
    let last = if end < 1.0 { at(end) } else { to };
    (start < end).then_some((first, last))
}

/// The part of a polygon inside a rectangle (Sutherland and Hodgman).
pub(super) fn clip_polygon(outline: &[Point], rect: &Rect) -> Vec<Point> {
    let sides: [(f64, f64, f64); 4] = [
        (1.0, 0.0, rect.left),
        (-1.0, 0.0, -rect.right),
        (0.0, 1.0, rect.top),
        (0.0, -1.0, -rect.bottom),
    ];
    let mut kept = outline.to_vec();
    for (a, b, limit) in sides {
        let depth = |p: Point| a * p.0 + b * p.1 - limit;
        let previous = kept.iter().cycle().skip(kept.len().saturating_sub(1));
        let pairs: Vec<_> = previous.copied().zip(kept.iter().copied()).collect();
        kept = Vec::new();
        for (from, to) in pairs {
            // A crossing of the side comes before the point itself.
            if (depth(from) < 0.0) != (depth(to) < 0.0) {
                let share = depth(from) / (depth(from) - depth(to));
                kept.push((
                    from.0 + share * (to.0 - from.0),
                    from.1 + share * (to.1 - from.1),
                ));
            }
            if depth(to) >= 0.0 {
                kept.push(to);
            }
        }
    }
    kept
}

// Cuts a line into dashes of equal length.
fn dashes(piece: &[Point]) -> Vec<Vec<Point>> {
    let mut done: Vec<Vec<Point>> = Vec::new();
    let (mut on, mut left) = (true, DASH.0);
    let mut dash: Vec<Point> = piece.first().copied().into_iter().collect();
    for pair in piece.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        let mut rest = distance(from, to);
        while rest > left {
            let share = left / rest;
            from = (
                from.0 + share * (to.0 - from.0),
                from.1 + share * (to.1 - from.1),
            );
            rest -= left;
            dash.push(from);
            if on {
                done.push(std::mem::take(&mut dash));
            }
            on = !on;
            dash = vec![from];
            left = if on { DASH.0 } else { DASH.1 };
        }
        left -= rest;
        dash.push(to);
    }
    if on && dash.len() > 1 {
        done.push(dash);
    }
    done
}

// Distance between two points.
fn distance(from: Point, to: Point) -> f64 {
    (from.0 - to.0).hypot(from.1 - to.1)
}

#[cfg(test)]
mod tests;
