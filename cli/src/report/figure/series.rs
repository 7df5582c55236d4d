//! Curves of a figure.

use super::scene::Color;

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

impl Style {
    /// Whether the points are joined.
    pub(super) fn has_line(self) -> bool {
        self != Style::Points
    }

    /// Whether each point gets a marker.
    pub(super) fn has_markers(self) -> bool {
        matches!(self, Style::Points | Style::LinePoints)
    }
}

/// A labelled list of points; one that cannot be shown breaks the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    pub(super) label: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) style: Style,
    pub(super) color: Option<Color>,
}

impl Series {
    /// A series in the next palette colour; an empty label keeps it out of the legend.
    pub fn new(label: impl Into<String>, points: Vec<(f64, f64)>, style: Style) -> Self {
        Self {
            label: label.into(),
            points,
            style,
            color: None,
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

    /// The colour set, or the palette colour of the series' place.
    pub(super) fn shown_color(&self, index: usize) -> Color {
        self.color.unwrap_or(Color::palette(index))
    }
}
