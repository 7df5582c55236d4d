//! The cells of a surface and its whiskers, from the back to the front.

use super::{HEIGHT, Surface, inside};
use crate::figure::Color;
use crate::figure::axis::Span;
use crate::solid::ramp;
use crate::solid::svg_canvas::SvgCanvas;
use crate::solid::view::{Point, View};

/// Quadrilaterals along each axis, about, and the most in one cell, which is bilinear between its
/// corners: fine enough for smooth colours, few enough for small files.
const PARTS: usize = 32;
const MOST_PARTS: usize = 12;
/// Colours of grid lines and of whiskers.
const MESH: Color = Color(60, 60, 60);
const WHISKER: Color = Color(20, 20, 20);
/// Widths of grid lines and whiskers, half the width of caps, radius of dots, px.
const THIN: f64 = 0.8;
const BOLD: f64 = 1.6;
const CAP: f64 = 4.0;
const DOT: f64 = 2.5;

impl Surface {
    /// Draws cells and whiskers: both horizontal axes lead away from the eye, so a cell can only
    /// be hidden by one with a smaller or equal index on each axis.
    pub(super) fn cells(&self, paper: &mut SvgCanvas, view: &View, spans: &[Span; 3]) {
        let point = |i: usize, j: usize| self.point(spans, i, j, 0.0);
        let (wide, deep) = (self.lines[0].len(), self.lines[1].len());
        let parts = PARTS / wide.max(deep).saturating_sub(1).max(1);
        let parts = parts.clamp(1, MOST_PARTS);
        for i in (0..wide).rev() {
            for j in (0..deep).rev() {
                // The cell whose far corner is this grid point.
                if let (Some(low_i), Some(low_j)) = (i.checked_sub(1), j.checked_sub(1)) {
                    let corners = [
                        point(low_i, low_j),
                        point(i, low_j),
                        point(low_i, j),
                        point(i, j),
                    ];
                    if let [Some(a), Some(b), Some(c), Some(d)] = corners {
                        cell(paper, view, ([a, b, c, d], parts));
                    }
                }
                self.mark(paper, view, spans, (i, j));
            }
        }
    }

    // A grid point, moved up by so many errors, in the box.
    fn point(&self, spans: &[Span; 3], i: usize, j: usize, errors: f64) -> Option<Point> {
        let value = self.values[i][j] + errors * self.error(i, j);
        let places = [self.lines[0][i].at, self.lines[1][j].at, value];
        inside(std::array::from_fn(|axis| spans[axis].place(places[axis])))
    }

    // The whisker of a grid point with a dot, or the dot alone where no cell shows the point.
    fn mark(&self, paper: &mut SvgCanvas, view: &View, spans: &[Span; 3], (i, j): (usize, usize)) {
        let Some(point) = self.point(spans, i, j, 0.0) else {
            return;
        };
        if self.error(i, j) > 0.0 {
            // A whisker that leaves the box is cut there and has no cap.
            let ends = [-1.0, 1.0].map(|side| self.point(spans, i, j, side));
            let [low, high] = [(ends[0], 0.0), (ends[1], HEIGHT)]
                .map(|(end, border)| view.place(end.unwrap_or([point[0], point[1], border])));
            paper.line(&[low, high], WHISKER, BOLD);
            for (x, y) in ends.into_iter().flatten().map(|end| view.place(end)) {
                paper.line(&[(x - CAP, y), (x + CAP, y)], WHISKER, BOLD);
            }
        } else if self.in_a_cell(spans, (i, j)) {
            return;
        }
        paper.dot(view.place(point), DOT, WHISKER);
    }

    // Whether one of the four cells around a grid point has all its corners.
    fn in_a_cell(&self, spans: &[Span; 3], (i, j): (usize, usize)) -> bool {
        let sides = |at: usize, count: usize| {
            let other = [at.checked_sub(1), Some(at + 1).filter(|next| *next < count)];
            other.into_iter().flatten()
        };
        let shown = |i: usize, j: usize| self.point(spans, i, j, 0.0).is_some();
        sides(i, self.lines[0].len()).any(|other_i| {
            sides(j, self.lines[1].len())
                .any(|other_j| shown(other_i, j) && shown(i, other_j) && shown(other_i, other_j))
        })
    }
}

// One cell: small quadrilaterals in the colour of their height, then its outline. Corners: low x
// and y, high x, high y, both high.
fn cell(paper: &mut SvgCanvas, view: &View, ([a, b, c, d], parts): ([Point; 4], usize)) {
    let at = |u: f64, v: f64| -> Point {
        std::array::from_fn(|axis| {
            let (near, far) = (
                a[axis] + u * (b[axis] - a[axis]),
                c[axis] + u * (d[axis] - c[axis]),
            );
            near + v * (far - near)
        })
    };
    let share = |part: usize| part as f64 / parts as f64;
    for i in (0..parts).rev() {
        for j in (0..parts).rev() {
            let (u, v, next_u, next_v) = (share(i), share(j), share(i + 1), share(j + 1));
            let around = [at(u, v), at(next_u, v), at(next_u, next_v), at(u, next_v)];
            let middle = at((u + next_u) / 2.0, (v + next_v) / 2.0);
            let color = ramp::color(middle[2] / HEIGHT);
            paper.tile(&around.map(|point| view.place(point)), color);
        }
    }
    paper.line(&[a, b, d, c, a].map(|point| view.place(point)), MESH, THIN);
}
