//! Scientific line plots, drawn to SVG and PNG from one description.

pub(crate) mod axis;
pub(crate) mod canvas;
mod chart;
mod clip;
mod legend;
mod marks;
mod panels;

pub use axis::{Axis, Scale};
pub use legend::Legend;
pub use marks::{Color, ReferenceLine, Region, Series, Style};
pub use panels::Panels;

use plotters::drawing::DrawingAreaErrorKind;

/// One plot: two axes with curves, reference lines and filled regions.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    title: String,
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    guides: Vec<ReferenceLine>,
    regions: Vec<Region>,
    legend: Legend,
    size: (u32, u32),
}

impl Figure {
    /// Starts an empty figure; an empty title takes no room.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            series: Vec::new(),
            guides: Vec::new(),
            regions: Vec::new(),
            legend: Legend::default(),
            size: (900, 560),
        }
    }

    /// Adds a curve; later curves lie over earlier ones.
    #[must_use]
    pub fn series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a thin grey reference line.
    #[must_use]
    pub fn guide(mut self, guide: ReferenceLine) -> Self {
        self.guides.push(guide);
        self
    }

    /// Adds a filled region below all curves.
    #[must_use]
    pub fn region(mut self, region: Region) -> Self {
        self.regions.push(region);
        self
    }

    /// Sets the position of the legend.
    #[must_use]
    pub fn legend(mut self, legend: Legend) -> Self {
        self.legend = legend;
        self
    }

    /// Sets the size in pixels; `Panels` ignores it and uses its cell size.
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Width and height in pixels.
    pub fn extent(&self) -> (u32, u32) {
        self.size
    }

    /// Draws the figure as an SVG document.
    pub fn svg(&self) -> Result<String, FigureError> {
        canvas::svg(self.size, |area| chart::draw(self, area))
    }

    /// Draws the figure as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        canvas::png(&self.svg()?)
    }
}

/// Reasons a figure cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum FigureError {
    /// A given axis range is empty, not finite, or not positive on a log axis.
    #[error("axis \"{0}\" cannot span {1} to {2}")]
    Range(String, f64, f64),
    /// The canvas is too small to hold a plot or too large to draw.
    #[error("a figure of {0} x {1} pixels cannot be drawn")]
    Size(u32, u32),
    /// The SVG could not be drawn.
    #[error("drawing failed: {0}")]
    Draw(#[from] DrawingAreaErrorKind<std::io::Error>),
    /// The PNG could not be made from the SVG.
    #[error("PNG encoding failed: {0}")]
    Png(String),
}

#[cfg(test)]
mod tests;
