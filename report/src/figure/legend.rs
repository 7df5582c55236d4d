//! The legend: which line belongs to which series.

use super::canvas::{Area, PX, fitting, font, width};
use super::marks::curve;
use super::{Figure, FigureError};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

// Text size in pixels; line height, sample length and gap in SVG units.
const SIZE: f64 = 13.0;
const LINE: i32 = 20 * PX;
const SAMPLE: i32 = 28 * PX;
const GAP: i32 = 8 * PX;

/// Position of the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// Outside, at the right of the plot.
    #[default]
    Right,
    /// Outside, in rows under the plot.
    Below,
    /// Inside, in the upper left corner.
    TopLeft,
    /// Inside, in the upper right corner.
    TopRight,
    /// Inside, in the lower left corner.
    BottomLeft,
    /// Inside, in the lower right corner.
    BottomRight,
    /// No legend.
    Hidden,
}

/// A legend laid out as a grid of equal cells.
pub(super) struct Block<'f> {
    figure: &'f Figure,
    size: f64,
    cell: i32,
    rows: i32,
    columns: i32,
}

impl<'f> Block<'f> {
    /// Plans a legend: side by side below a plot, else one entry under another.
    pub fn new(figure: &'f Figure, area: &Area) -> Self {
        let labels = figure.series.iter().map(|series| series.label.as_str());
        let shown = labels.filter(|label| !label.is_empty());
        let count = shown.clone().count() as i32;
        let longest = shown.max_by_key(|label| width(label, SIZE)).unwrap_or("");
        let full = area.dim_in_pixel().0 as i32;
        let sample = SAMPLE + 3 * GAP;
        let below = figure.legend == Legend::Below;
        let room = if below { full } else { full * 2 / 5 };
        let size = fitting(longest, SIZE, room - sample);
        let cell = sample + width(longest, size);
        let columns = if below { full / cell } else { 1 }.clamp(1, count.max(1));
        Self {
            figure,
            size,
            cell,
            rows: (count + columns - 1) / columns,
            columns,
        }
    }

    /// Splits off room for a legend outside the plot.
    pub fn split<'a>(&self, area: &Area<'a>) -> (Area<'a>, Area<'a>) {
        let (full, height) = area.dim_in_pixel();
        match self.figure.legend {
            Legend::Right => area.split_horizontally(full as i32 - self.cell * self.rows.min(1)),
            Legend::Below => area.split_vertically(height as i32 - LINE * self.rows - GAP),
            _ => (area.clone(), area.clone()),
        }
    }

    /// Draws the legend at its place beside or inside the plot.
    pub fn draw<'a>(&self, side: &Area<'a>, plot: &Area<'a>) -> Result<(), FigureError> {
        let (wide, high) = (self.cell * self.columns, LINE * self.rows);
        let (full, height) = plot.dim_in_pixel();
        let (right, low) = (full as i32 - wide - GAP, height as i32 - high - GAP);
        let middle = (side.dim_in_pixel().0 as i32 - wide) / 2;
        let (area, (left, top)) = match self.figure.legend {
            Legend::Hidden => return Ok(()),
            Legend::Right => (side, (0, GAP)),
            Legend::Below => (side, (middle, GAP)),
            Legend::TopLeft => (plot, (GAP, GAP)),
            Legend::TopRight => (plot, (right, GAP)),
            Legend::BottomLeft => (plot, (GAP, low)),
            Legend::BottomRight => (plot, (right, low)),
        };
        let corners = [(left, top), (left + wide, top + high)];
        area.draw(&Rectangle::new(corners, WHITE.mix(0.85).filled()))?;
        self.entries(area, (left, top))
    }

    // Draws a piece of line and the label of each series.
    fn entries(&self, area: &Area, (left, top): (i32, i32)) -> Result<(), FigureError> {
        let style = font(self.size).pos(Pos::new(HPos::Left, VPos::Center));
        let all = self.figure.series.iter().enumerate();
        let shown = all.filter(|(_, series)| !series.label.is_empty());
        for ((index, series), cell) in shown.zip(0..) {
            let x = left + GAP + cell % self.columns * self.cell;
            let y = top + LINE / 2 + cell / self.columns * LINE;
            let ends = vec![(x, y), (x + SAMPLE, y)];
            curve(area, (series, index), vec![ends], vec![(x + SAMPLE / 2, y)])?;
            area.draw_text(&series.label, &style, (x + SAMPLE + GAP, y))?;
        }
        Ok(())
    }
}
