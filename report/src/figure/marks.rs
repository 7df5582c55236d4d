//! Elements of a figure: curves, reference lines, filled regions and their colours.

use super::FigureError;
use super::canvas::PX;
use plotters::coord::CoordTranslate;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::Color as _;

// Width of the lines of series.
const STROKE: u32 = 2 * PX as u32;

/// An opaque colour: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    /// Colour-blind-safe line colours (Okabe and Ito).
    const PALETTE: [Self; 7] = [
        Self(0, 114, 178),
        Self(213, 94, 0),
        Self(0, 158, 115),
        Self(204, 121, 167),
        Self(230, 159, 0),
        Self(86, 180, 233),
        Self(30, 30, 30),
    ];

    /// Line colours, repeated after the seventh.
    pub fn palette(index: usize) -> Self {
        Self::PALETTE[index % Self::PALETTE.len()]
    }

    /// The same colours mixed with white, for filled regions.
    pub fn pale(index: usize) -> Self {
        let Color(red, green, blue) = Self::palette(index);
        let lighten = |part: u8| 255 - (255 - part) / 4;
        Color(lighten(red), lighten(green), lighten(blue))
    }

    // The colour for plotters.
    pub(super) fn rgb(self) -> RGBColor {
        RGBColor(self.0, self.1, self.2)
    }
}

/// How the points of a series are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    Line,
    /// A dashed line.
    Dashed,
    /// Markers only.
    Points,
    /// Markers joined by a solid line.
    LinePoints,
}

/// A labelled list of points; one that cannot be shown breaks the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    pub(super) label: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) style: Style,
    pub(super) color: Option<Color>,
    pub(super) errors: Vec<f64>,
}

impl Series {
    /// A series in the next palette colour; an empty label keeps it out of the legend.
    pub fn new(label: impl Into<String>, points: Vec<(f64, f64)>, style: Style) -> Self {
        Self {
            label: label.into(),
            points,
            style,
            color: None,
            errors: Vec::new(),
        }
    }

    /// A solid line.
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(label, points, Style::Line)
    }

    /// A dashed line.
    pub fn dashed(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(label, points, Style::Dashed)
    }

    /// Markers only.
    pub fn points(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(label, points, Style::Points)
    }

    /// Markers joined by a line.
    pub fn line_points(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(label, points, Style::LinePoints)
    }

    /// Sets the colour instead of taking the next one.
    #[must_use]
    pub fn color(mut self, color: Color) -> Self {
        self.color = Some(color);
        self
    }

    /// Puts a whisker from y − error to y + error on each point, in the order of the points and the
    /// unit of y; a point whose error is missing, not finite or not positive has none.
    #[must_use]
    pub fn errors(mut self, errors: Vec<f64>) -> Self {
        self.errors = errors;
        self
    }

    // Its colour and style as series number `index`: lines whose colour is a repeated one are dashed.
    pub(super) fn look(&self, index: usize) -> (RGBColor, Style) {
        let repeats = self.color.is_none() && index >= Color::PALETTE.len();
        let style = match self.style {
            Style::Line if repeats => Style::Dashed,
            style => style,
        };
        (self.color.unwrap_or(Color::palette(index)).rgb(), style)
    }

    // The lower and the upper end of each whisker.
    pub(super) fn whiskers(&self) -> impl Iterator<Item = [(f64, f64); 2]> {
        let pairs = self.points.iter().zip(&self.errors);
        let shown = pairs
            .filter(|(point, error)| point.1.is_finite() && error.is_finite() && **error > 0.0);
        shown.map(|((x, y), error)| [(*x, y - error), (*x, y + error)])
    }
}

/// A thin grey reference line across the plot.
#[derive(Debug, Clone, PartialEq)]
pub enum ReferenceLine {
    /// A line at one y value.
    Horizontal {
        /// The y value.
        at: f64,
        /// Text beside the line, may be empty.
        label: String,
    },
    /// A line at one x value.
    Vertical {
        /// The x value.
        at: f64,
        /// Text beside the line, may be empty.
        label: String,
    },
}

impl ReferenceLine {
    /// A line at one y value.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Horizontal { at, label }
    }

    /// A line at one x value.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        let label = label.into();
        Self::Vertical { at, label }
    }
}

/// A filled polygon of a phase diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Text inside the region; line breaks are kept.
    pub label: String,
    /// Corners in data coordinates.
    pub outline: Vec<(f64, f64)>,
    /// Fill colour; `Color::pale` gives fitting ones.
    pub fill: Color,
    /// Centre of the label in data coordinates.
    pub label_at: (f64, f64),
}

/// Draws the lines and markers of a series.
pub(super) fn curve<C: CoordTranslate<From: Clone>>(
    area: &DrawingArea<SVGBackend, C>,
    (series, index): (&Series, usize),
    pieces: Vec<Vec<C::From>>,
    points: Vec<C::From>,
) -> Result<(), FigureError> {
    let (color, style) = series.look(index);
    let stroke = color.stroke_width(STROKE);
    for piece in pieces {
        match style {
            Style::Points => {}
            Style::Dashed => {
                area.draw(&DashedPathElement::new(piece, 8 * PX, 5 * PX, stroke))?;
            }
            _ => area.draw(&PathElement::new(piece, stroke))?,
        }
    }
    if matches!(style, Style::Points | Style::LinePoints) {
        for at in points {
            area.draw(&Circle::new(at, 7 * PX / 2, stroke.filled()))?;
        }
    }
    Ok(())
}
