//! A surface z(x, y) over a rectangular grid in parallel projection, coloured by its height.

mod axes;
mod cells;

use super::figure::axis::{Axis, Span};
use super::figure::{FigureError, canvas};
use super::solid::ramp;
use super::solid::svg_canvas::SvgCanvas;
use super::solid::view::{Point, View, corners};

/// Azimuth of the eye: (0, 0) is the near corner, x runs to the right and y to the left.
const AZIMUTH: f64 = -2.27;
const ELEVATION: f64 = 0.46;
/// Height of the box whose floor is the unit square.
const HEIGHT: f64 = 0.8;
/// Room for labels around the box, px: left, above, right, below.
const ROOM: [f64; 4] = [68.0, 10.0, 30.0, 52.0];

/// One surface with its axes.
///
/// Missing values leave holes, and so do values outside a given range of an axis. Values in
/// front hide those behind: the picture suits surfaces that rise from the corner of the
/// smallest x and y.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    title: String,
    axes: [Axis; 3],
    lines: [Vec<GridLine>; 2],
    values: Vec<Vec<f64>>,
    errors: Vec<Vec<f64>>,
    size: (u32, u32),
}

// A grid line: its x or y, and its place in the list that the caller gave.
#[derive(Debug, Clone, Copy, PartialEq)]
struct GridLine {
    at: f64,
    index: usize,
}

impl Surface {
    /// A surface through `value(i, j)` at `xs[i]`, `ys[j]`; axes in the order x, y, z.
    ///
    /// Grid lines may come in any order and at any distance; those that are not finite are left
    /// out. A missing value is NaN.
    pub fn new(
        title: impl Into<String>,
        axes: [Axis; 3],
        [xs, ys]: [&[f64]; 2],
        value: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let lines = [sorted(xs), sorted(ys)];
        Self {
            title: title.into(),
            axes,
            values: on_grid(&lines, value),
            errors: Vec::new(),
            lines,
            size: (620, 470),
        }
    }

    /// Puts a whisker from value − error to value + error on each grid point; one whose error is
    /// not finite or not positive has none.
    #[must_use]
    pub fn errors(mut self, error: impl Fn(usize, usize) -> f64) -> Self {
        self.errors = on_grid(&self.lines, error);
        self
    }

    /// Sets the size in pixels.
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Width and height in pixels.
    pub fn extent(&self) -> (u32, u32) {
        self.size
    }

    /// Draws the surface as an SVG document.
    pub fn svg(&self) -> Result<String, FigureError> {
        let mut paper = SvgCanvas::new(self.size)?;
        let frame = paper.title(&self.title);
        let spans = self.spans()?;

        // The colour bar is at the right, the box with its labels in the remaining space.
        let unnamed = Axis::linear("");
        let frame = ramp::bar(&mut paper, (&unnamed, &spans[2]), frame)?;
        let [left, above, right, below] = ROOM;
        let frame = [
            frame[0] + left,
            frame[1] + above,
            frame[2] - right,
            frame[3] - below,
        ];
        let all = corners([0.0; 3], [1.0, 1.0, HEIGHT]);
        let view = View::new(AZIMUTH, ELEVATION).fitted(&all, frame);
        axes::draw(&mut paper, &view, (&self.axes, &spans));
        self.cells(&mut paper, &view, &spans);
        Ok(paper.svg())
    }

    /// Draws the surface as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        canvas::png(&self.svg()?)
    }

    // Spans of x, y and z; whiskers count.
    fn spans(&self) -> Result<[Span; 3], FigureError> {
        let [x, y, z] = &self.axes;
        let at = |lines: &[GridLine]| lines.iter().map(|line| line.at).collect::<Vec<_>>();
        let mut values = Vec::new();
        for (i, row) in self.values.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let error = self.error(i, j);
                values.extend([*value, value - error, value + error]);
            }
        }
        Ok([
            Span::new(x, at(&self.lines[0]).into_iter())?,
            Span::new(y, at(&self.lines[1]).into_iter())?,
            Span::new(z, values.into_iter())?,
        ])
    }

    // Half the length of the whisker at a grid point, nought without one.
    fn error(&self, i: usize, j: usize) -> f64 {
        let error = self.errors.get(i).and_then(|row| row.get(j)).copied();
        error
            .filter(|error| error.is_finite())
            .map_or(0.0, |error| error.max(0.0))
    }
}

// Finite grid lines from the smallest to the largest.
fn sorted(places: &[f64]) -> Vec<GridLine> {
    let lines = places.iter().enumerate();
    let lines = lines.map(|(index, at)| GridLine { at: *at, index });
    let mut lines: Vec<_> = lines.filter(|line| line.at.is_finite()).collect();
    lines.sort_by(|a, b| a.at.total_cmp(&b.at));
    lines
}

// A function of the caller's indices at every crossing of the sorted grid lines.
fn on_grid(lines: &[Vec<GridLine>; 2], value: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    let row = |x: &GridLine| lines[1].iter().map(|y| value(x.index, y.index)).collect();
    lines[0].iter().map(row).collect()
}

// A point of the box from shares of the three axes, nothing outside of it.
fn inside(shares: [Option<f64>; 3]) -> Option<Point> {
    // Ends of a given range may miss it by rounding.
    const ROUNDING: f64 = 1e-9;
    let [x, y, z] = shares.map(|share| {
        let share = share.filter(|share| (-ROUNDING..=1.0 + ROUNDING).contains(share));
        share.map(|share| share.clamp(0.0, 1.0))
    });
    Some([x?, y?, HEIGHT * z?])
}

#[cfg(test)]
mod tests;
