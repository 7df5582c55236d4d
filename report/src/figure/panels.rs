//! Several figures in a grid in one image.

use super::canvas::{self, Area, PX};
use super::{Figure, FigureError, chart};

/// Figures in rows of equal cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Panels {
    title: String,
    columns: u32,
    cell: (u32, u32),
    zoom: f64,
    figures: Vec<Figure>,
}

impl Panels {
    /// An empty grid with a number of columns, at least one.
    pub fn new(title: impl Into<String>, columns: u32) -> Self {
        Self {
            title: title.into(),
            columns: columns.max(1),
            cell: (480, 360),
            zoom: 1.0,
            figures: Vec::new(),
        }
    }

    /// Adds a figure in the next free cell, row by row.
    #[must_use]
    pub fn figure(mut self, figure: Figure) -> Self {
        self.figures.push(figure);
        self
    }

    /// Sets the size of one cell in pixels.
    #[must_use]
    pub fn cell(mut self, width: u32, height: u32) -> Self {
        self.cell = (width, height);
        self
    }

    /// Enlarges the whole grid, letters and lines with it.
    #[must_use]
    pub fn zoom(mut self, zoom: f64) -> Self {
        self.zoom = zoom;
        self
    }

    /// Width and height of the whole grid in pixels.
    pub fn extent(&self) -> (u32, u32) {
        let (width, height) = self.drawn();
        let zoomed = |side: u32| (f64::from(side) * self.zoom).round() as u32;
        (zoomed(width), zoomed(height))
    }

    // Width and height before they are enlarged.
    fn drawn(&self) -> (u32, u32) {
        let (rows, columns) = self.grid();
        let height = self.cell.1.saturating_mul(rows);
        let width = self.cell.0.saturating_mul(columns);
        (width, height.saturating_add(self.head()))
    }

    // Rows and columns of the cells in use.
    fn grid(&self) -> (u32, u32) {
        let count = u32::try_from(self.figures.len()).unwrap_or(u32::MAX).max(1);
        let columns = self.columns.min(count);
        (count.div_ceil(columns), columns)
    }

    // Height of the title in pixels.
    fn head(&self) -> u32 {
        if self.title.is_empty() { 0 } else { 34 }
    }

    /// Draws the grid as an SVG document; an empty grid still has one cell.
    pub fn svg(&self) -> Result<String, FigureError> {
        let (rows, columns) = self.grid();
        let head = self.head();
        canvas::svg_shown_at(self.extent(), self.drawn(), |root| {
            let (top, body) = root.split_vertically(head as i32 * PX);
            chart::title(&self.title, 18.0, &top.margin(9 * PX, 0, 0, 0))?;
            let cells: Vec<Area> = body.split_evenly((rows as usize, columns as usize));
            let mut pairs = self.figures.iter().zip(&cells);
            pairs.try_for_each(|(figure, cell)| chart::draw(figure, cell))
        })
    }

    /// Draws the grid as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        canvas::png(&self.svg()?)
    }
}
