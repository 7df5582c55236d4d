//! A list of simple marks in pixel coordinates, ready to be painted.

use super::error::FigureError;
use super::font;

/// A place on the canvas in pixels, y counted downwards.
pub(super) type Point = (f64, f64);

// Smallest and largest canvas side in pixels.
const SIDE: std::ops::RangeInclusive<u32> = 120..=4000;

/// An opaque colour: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl Color {
    /// Colour-blind-safe line colours (Okabe and Ito), repeated after the seventh.
    pub fn palette(index: usize) -> Self {
        const COLORS: [Color; 7] = [
            Color(0, 114, 178),
            Color(213, 94, 0),
            Color(0, 158, 115),
            Color(204, 121, 167),
            Color(230, 159, 0),
            Color(86, 180, 233),
            Color(30, 30, 30),
        ];
        COLORS[index % COLORS.len()]
    }

    /// The same colours mixed with white, for filled regions.
    pub fn pale(index: usize) -> Self {
        let Color(red, green, blue) = Self::palette(index);
        let lighten = |part: u8| 255 - (255 - part) / 4;
        Color(lighten(red), lighten(green), lighten(blue))
    }
}

/// Which end of a text stands at its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A line of text; `at` is on its baseline.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Text {
    pub text: String,
    pub at: Point,
    pub size: f64,
    pub color: Color,
    pub anchor: Anchor,
    /// Whether the text runs upwards instead of to the right.
    pub upwards: bool,
}

/// One thing to paint.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Mark {
    Stroke {
        points: Vec<Point>,
        width: f64,
        color: Color,
    },
    Fill {
        outline: Vec<Point>,
        color: Color,
        opacity: f64,
    },
    Disc {
        at: Point,
        radius: f64,
        color: Color,
    },
    Text(Text),
}

/// All marks of one image, painted in order on white.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scene {
    pub size: (u32, u32),
    pub marks: Vec<Mark>,
}

impl Scene {
    /// An empty canvas of a size that can be drawn.
    pub fn new(size: (u32, u32)) -> Result<Self, FigureError> {
        font::check()?;
        if !SIDE.contains(&size.0) || !SIDE.contains(&size.1) {
            return Err(FigureError::Size {
                width: size.0,
                height: size.1,
            });
        }
        let marks = Vec::new();
        Ok(Self { size, marks })
    }

    /// Adds a line through some points.
    pub fn stroke(&mut self, points: Vec<Point>, width: f64, color: Color) {
        self.marks.push(Mark::Stroke {
            points,
            width,
            color,
        });
    }

    /// Adds a filled polygon.
    pub fn fill(&mut self, outline: Vec<Point>, color: Color, opacity: f64) {
        self.marks.push(Mark::Fill {
            outline,
            color,
            opacity,
        });
    }

    /// Adds a horizontal line of text.
    pub fn text(&mut self, text: &str, at: Point, size: f64, color: Color, anchor: Anchor) {
        if text.is_empty() {
            return;
        }
        self.marks.push(Mark::Text(Text {
            text: text.to_owned(),
            at,
            size,
            color,
            anchor,
            upwards: false,
        }));
    }

    /// Adds a line of text that runs upwards.
    pub fn text_upwards(&mut self, text: &str, at: Point, size: f64, color: Color, anchor: Anchor) {
        self.marks.push(Mark::Text(Text {
            text: text.to_owned(),
            at,
            size,
            color,
            anchor,
            upwards: true,
        }));
    }
}

/// The middle of the pixel a place falls into, where thin lines are sharp.
pub(super) fn snapped(place: f64) -> f64 {
    place.floor() + 0.5
}

/// An upright rectangle in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Rect {
    /// A rectangle from its four sides.
    pub fn new(left: f64, top: f64, right: f64, bottom: f64) -> Self {
        Self {
            left,
            top,
            right,
            bottom,
        }
    }

    /// Horizontal extent.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Vertical extent.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Whether a point lies inside or on the border.
    pub fn holds(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// Whether two rectangles share some area.
    pub fn overlaps(&self, other: &Rect) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// The four corners in drawing order.
    pub fn corners(&self) -> Vec<Point> {
        vec![
            (self.left, self.top),
            (self.right, self.top),
            (self.right, self.bottom),
            (self.left, self.bottom),
        ]
    }
}
