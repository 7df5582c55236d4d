//! Scientific line plots, drawn to SVG and PNG from one description.

mod axis;
mod curves;
mod error;
mod font;
mod frame;
mod guides;
mod layout;
mod legend;
mod paint;
mod panels;
mod scene;
mod series;
mod ticks;

pub use axis::{Axis, Scale};
pub use error::FigureError;
pub use guides::{Guide, Region};
pub use legend::Legend;
pub use panels::Panels;
pub use scene::Color;
pub use series::{Series, Style};

use scene::{Rect, Scene};

/// Width and height in pixels when none is given.
const DEFAULT_SIZE: (u32, u32) = (900, 560);

/// One plot: two axes with curves, reference lines and filled regions.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    title: String,
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    guides: Vec<Guide>,
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
            size: DEFAULT_SIZE,
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
    pub fn guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// Adds a filled region below all curves.
    #[must_use]
    pub fn region(mut self, region: Region) -> Self {
        self.regions.push(region);
        self
    }

    /// Chooses where the legend stands.
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

    /// Draws the figure as an SVG document.
    pub fn svg(&self) -> Result<String, FigureError> {
        paint::svg(&self.scene()?)
    }

    /// Draws the figure as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        paint::png(&self.scene()?)
    }

    // Lays the figure out over its whole canvas.
    fn scene(&self) -> Result<Scene, FigureError> {
        let mut scene = Scene::new(self.size)?;
        let cell = Rect::new(0.0, 0.0, f64::from(self.size.0), f64::from(self.size.1));
        layout::draw(self, cell, &mut scene)?;
        Ok(scene)
    }
}

#[cfg(test)]
mod tests;
