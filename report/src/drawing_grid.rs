//! Several drawings of any kind in one image.

use super::figure::FigureError;
use super::image::Drawing;
use super::solid::svg_canvas::SvgCanvas;

/// Drawings in rows, each at its own size.
pub struct DrawingGrid {
    title: String,
    columns: usize,
    drawings: Vec<Box<dyn Drawing>>,
}

impl std::fmt::Debug for DrawingGrid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "Sheet {:?} of {} drawings",
            self.title,
            self.drawings.len()
        )
    }
}

impl DrawingGrid {
    /// An empty sheet with a number of columns, at least one; an empty title takes no room.
    pub fn new(title: impl Into<String>, columns: usize) -> Self {
        Self {
            title: title.into(),
            columns: columns.max(1),
            drawings: Vec::new(),
        }
    }

    /// Adds a drawing at the next free place, row by row.
    #[must_use]
    pub fn drawing(mut self, drawing: impl Drawing + 'static) -> Self {
        self.drawings.push(Box::new(drawing));
        self
    }

    // Height of the title in pixels.
    fn head(&self) -> u32 {
        if self.title.is_empty() { 0 } else { 34 }
    }

    // Width and height of one row.
    fn row(row: &[Box<dyn Drawing>]) -> (u32, u32) {
        let sizes = row.iter().map(|drawing| drawing.extent());
        sizes.fold((0, 0), |(width, height), size| {
            (width.saturating_add(size.0), height.max(size.1))
        })
    }
}

impl Drawing for DrawingGrid {
    fn extent(&self) -> (u32, u32) {
        let rows = self.drawings.chunks(self.columns).map(Self::row);
        rows.fold((0, self.head()), |(width, height), row| {
            (width.max(row.0), height.saturating_add(row.1))
        })
    }

    fn to_svg(&self) -> Result<String, FigureError> {
        let mut paper = SvgCanvas::new(self.extent())?;
        paper.title(&self.title);
        let mut top = self.head();
        for row in self.drawings.chunks(self.columns) {
            let mut left = 0;
            for drawing in row {
                paper.inset((left, top), &drawing.to_svg()?);
                left += drawing.extent().0;
            }
            top += Self::row(row).1;
        }
        Ok(paper.svg())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Axis, Figure, canvas};

    fn figure(title: &str, width: u32, height: u32) -> Figure {
        let axis = || Axis::linear("").range(0.0, 1.0);
        Figure::new(title, axis(), axis()).size(width, height)
    }

    #[test]
    fn drawings_stand_side_by_side_row_by_row() -> Result<(), FigureError> {
        let sheet = DrawingGrid::new("All & more", 2)
            .drawing(figure("one", 200, 150))
            .drawing(figure("two", 300, 180))
            .drawing(figure("three", 250, 130));
        assert_eq!(sheet.extent(), (500, 34 + 180 + 130));
        let svg = sheet.to_svg()?;
        for text in ["All &amp; more", "one", "two", "three"] {
            assert!(svg.contains(text), "{text}");
        }
        for place in [
            "x=\"0\" y=\"34\"",
            "x=\"200\" y=\"34\"",
            "x=\"0\" y=\"214\"",
        ] {
            assert!(svg.contains(&format!("<svg {place} width")), "{place}");
        }
        Ok(())
    }

    #[test]
    fn a_drawing_looks_the_same_on_a_sheet() -> Result<(), FigureError> {
        let alone = canvas::png(&figure("one", 200, 150).to_svg()?)?;
        let sheet = DrawingGrid::new("", 1).drawing(figure("one", 200, 150));
        assert!(sheet.to_png()? == alone);
        assert!(matches!(
            DrawingGrid::new("", 3).to_svg(),
            Err(FigureError::Size(0, 0))
        ));
        Ok(())
    }
}
