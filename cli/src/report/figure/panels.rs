//! Several figures in a grid in one image.

use super::error::FigureError;
use super::scene::{Anchor, Color, Rect, Scene};
use super::{Figure, font, layout, paint};

// Size of one cell in pixels when none is given.
const CELL: (u32, u32) = (480, 360);

// Text size of the title and room above the grid for it.
const TITLE_SIZE: f64 = 18.0;
const TITLE_ROOM: u32 = 38;

/// Figures in rows of equal cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Panels {
    title: String,
    columns: u32,
    cell: (u32, u32),
    figures: Vec<Figure>,
}

impl Panels {
    /// An empty grid with a number of columns, at least one.
    pub fn new(title: impl Into<String>, columns: u32) -> Self {
        Self {
            title: title.into(),
            columns: columns.max(1),
            cell: CELL,
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

    /// Draws the grid as an SVG document.
    pub fn svg(&self) -> Result<String, FigureError> {
        paint::svg(&self.scene()?)
    }

    /// Draws the grid as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        paint::png(&self.scene()?)
    }

    // Lays out the title and every figure in its cell.
    fn scene(&self) -> Result<Scene, FigureError> {
        let size = self.canvas();
        let mut scene = Scene::new(size)?;
        let width = f64::from(size.0);
        let head = f64::from(self.head());
        if !self.title.is_empty() {
            let text = font::fitting_size(&self.title, TITLE_SIZE, width - 24.0);
            let at = (width / 2.0, head - 12.0);
            scene.text(&self.title, at, text, Color(30, 30, 30), Anchor::Middle);
        }
        for (figure, index) in self.figures.iter().zip(0_u32..) {
            let (column, row) = (index % self.columns, index / self.columns);
            let left = f64::from(column) * f64::from(self.cell.0);
            let top = head + f64::from(row) * f64::from(self.cell.1);
            let right = left + f64::from(self.cell.0);
            let bottom = top + f64::from(self.cell.1);
            layout::draw(figure, Rect::new(left, top, right, bottom), &mut scene)?;
        }
        Ok(scene)
    }

    // Height of the title.
    fn head(&self) -> u32 {
        if self.title.is_empty() { 0 } else { TITLE_ROOM }
    }

    // Size of the whole image; an empty grid still has one cell.
    fn canvas(&self) -> (u32, u32) {
        let count = u32::try_from(self.figures.len()).unwrap_or(u32::MAX).max(1);
        let columns = self.columns.min(count);
        let rows = count.div_ceil(self.columns);
        let width = self.cell.0.saturating_mul(columns);
        let height = self.cell.1.saturating_mul(rows);
        (width, height.saturating_add(self.head()))
    }
}
