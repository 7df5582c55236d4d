//! An SVG document of filled polygons, lines, shaded balls and text, in pixels.

use super::view::{CanvasPoint, Frame};
use crate::figure::{Color, FigureError, canvas};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Colour of text.
const INK: Color = Color(50, 50, 50);
/// Size of a title, space above it and height of its strip, px; as in figures.
const TITLE: f64 = 16.0;
const MARGIN: f64 = 6.0;
const STRIP: f64 = 24.0;
/// Centre of the highlight of a ball, as a share of its size from the upper left.
const LIGHT: (f64, f64) = (0.36, 0.32);

/// Alignment of a text at its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// A drawing under construction; later shapes lie over earlier ones.
#[derive(Debug)]
pub struct SvgCanvas {
    size: (u32, u32),
    body: String,
    insets: String,
    balls: BTreeSet<String>,
}

impl SvgCanvas {
    /// White paper of a size in pixels.
    pub fn new(size: (u32, u32)) -> Result<Self, FigureError> {
        canvas::check_size(size)?;
        Ok(Self {
            size,
            body: String::new(),
            insets: String::new(),
            balls: BTreeSet::new(),
        })
    }

    /// Writes a title at the top and returns the rest of the paper.
    pub fn title(&mut self, text: &str) -> Frame {
        let (wide, high) = (f64::from(self.size.0), f64::from(self.size.1));
        let inside = |top| [MARGIN, top, wide - MARGIN, high - MARGIN];
        if text.is_empty() {
            return inside(MARGIN);
        }
        let room = (wide - 2.0 * MARGIN) as i32 * canvas::PX;
        let size = canvas::fitting(text, TITLE, room);
        let middle = (wide / 2.0, MARGIN + STRIP / 2.0);
        self.text(middle, text, size, Anchor::Middle);
        inside(MARGIN + STRIP)
    }

    /// Fills a polygon, opacity 0 to 1.
    pub fn fill(&mut self, corners: &[CanvasPoint], color: Color, opacity: f64) {
        let glass = match opacity {
            1.0 => String::new(),
            _ => format!(" fill-opacity=\"{}\"", digits(opacity)),
        };
        self.polygon(corners, color, &glass);
    }

    /// Fills a polygon with hard edges, which leave no seam to its neighbours.
    pub fn tile(&mut self, corners: &[CanvasPoint], color: Color) {
        self.polygon(corners, color, " shape-rendering=\"crispEdges\"");
    }

    // A closed path with further attributes.
    fn polygon(&mut self, corners: &[CanvasPoint], color: Color, attributes: &str) {
        let (path, color) = (path(corners), hex(color));
        let _ = writeln!(
            self.body,
            "<path d=\"{path}Z\" fill=\"{color}\"{attributes}/>"
        );
    }

    /// Draws a line through all places, width in pixels.
    pub fn line(&mut self, places: &[CanvasPoint], color: Color, width: f64) {
        let (path, color, width) = (path(places), hex(color), digits(width));
        let _ = writeln!(
            self.body,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"/>"
        );
    }

    /// Draws a shaded ball.
    pub fn ball(&mut self, (x, y): CanvasPoint, radius: f64, color: Color) {
        let color = hex(color).split_off(1);
        let (x, y, r) = (digits(x), digits(y), digits(radius));
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"url(#ball-{color})\"/>"
        );
        self.balls.insert(color);
    }

    /// Draws a flat dot.
    pub fn dot(&mut self, (x, y): CanvasPoint, radius: f64, color: Color) {
        let (x, y, r) = (digits(x), digits(y), digits(radius));
        let color = hex(color);
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{color}\"/>"
        );
    }

    /// Writes a text whose middle line runs through a place, size in pixels.
    pub fn text(&mut self, at: CanvasPoint, text: &str, size: f64, anchor: Anchor) {
        self.turned_text(at, text, size, anchor, 0.0);
    }

    /// Writes a text turned clockwise about its place by an angle in degrees.
    pub fn turned_text(
        &mut self,
        at: CanvasPoint,
        text: &str,
        size: f64,
        anchor: Anchor,
        angle: f64,
    ) {
        let (x, y, size) = (digits(at.0), digits(at.1), digits(size));
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let turn = match angle {
            0.0 => String::new(),
            _ => format!(" transform=\"rotate({} {x} {y})\"", digits(angle)),
        };
        let (color, text) = (hex(INK), escaped(text));
        let _ = writeln!(
            self.body,
            "<text x=\"{x}\" y=\"{y}\" dy=\"0.36em\" text-anchor=\"{anchor}\" \
             font-family=\"sans-serif\" font-size=\"{size}\" fill=\"{color}\"{turn}>{text}</text>"
        );
    }

    /// Puts another SVG document, above all shapes, with its upper left corner at a place.
    pub fn inset(&mut self, (left, top): (u32, u32), svg: &str) {
        let placed = format!("<svg x=\"{left}\" y=\"{top}\" ");
        self.insets.push_str(&svg.replacen("<svg ", &placed, 1));
    }

    /// The document.
    pub fn svg(self) -> String {
        let (width, height) = self.size;
        let balls: String = self.balls.iter().map(|color| gradient(color)).collect();
        let (body, insets) = (self.body, self.insets);
        format!(
            "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             xmlns=\"http://www.w3.org/2000/svg\" stroke-linejoin=\"round\">\n\
             <defs>\n{balls}</defs>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n\
             <g stroke-linecap=\"round\">\n{body}</g>\n{insets}</svg>\n"
        )
    }
}

/// Width of a text in pixels, slightly generous.
pub fn width(text: &str, size: f64) -> f64 {
    f64::from(canvas::width(text, size)) / f64::from(canvas::PX)
}

// The shading of a ball, named by its colour: equal names on one page mean the same shading.
fn gradient(color: &str) -> String {
    let part = |at: usize| u8::from_str_radix(&color[at..at + 2], 16).unwrap_or(0);
    let base = Color(part(0), part(2), part(4));
    let (light, dark) = (
        hex(mixed(base, Color(255, 255, 255), 0.7)),
        hex(mixed(base, INK, 0.55)),
    );
    format!(
        "<radialGradient id=\"ball-{color}\" cx=\"{x}\" cy=\"{y}\" r=\"0.75\">\
         <stop offset=\"0\" stop-color=\"{light}\"/><stop offset=\"0.45\" stop-color=\"#{color}\"/>\
         <stop offset=\"1\" stop-color=\"{dark}\"/></radialGradient>\n",
        x = LIGHT.0,
        y = LIGHT.1,
    )
}

/// A colour with a share of another.
pub fn mixed(Color(r, g, b): Color, other: Color, share: f64) -> Color {
    let mix = |a: u8, b: u8| (f64::from(a) + share * (f64::from(b) - f64::from(a))).round() as u8;
    Color(mix(r, other.0), mix(g, other.1), mix(b, other.2))
}

/// A colour as SVG and web pages write it.
pub fn hex(Color(red, green, blue): Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

// Path data through all places.
fn path(places: &[CanvasPoint]) -> String {
    let mut path = String::new();
    for (at, (x, y)) in places.iter().enumerate() {
        let verb = if at == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{verb}{} {}", digits(*x), digits(*y));
    }
    path
}

// A number to a hundredth of a pixel; nought has no sign.
fn digits(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

// Text with SVG's special characters escaped.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_escaped_and_numbers_short() -> Result<(), FigureError> {
        let mut paper = SvgCanvas::new((200, 150))?;
        paper.text((1.0 / 3.0, -0.001), "a < b & c", 12.0, Anchor::End);
        let svg = paper.svg();
        assert!(svg.contains("a &lt; b &amp; c") && svg.contains("x=\"0.33\" y=\"0\""));
        assert!(matches!(
            SvgCanvas::new((10, 150)),
            Err(FigureError::Size(10, 150))
        ));
        Ok(())
    }

    #[test]
    fn balls_of_one_colour_share_their_shading() -> Result<(), FigureError> {
        let mut paper = SvgCanvas::new((200, 150))?;
        for at in 0..5 {
            paper.ball((20.0 * f64::from(at), 50.0), 9.0, Color(0, 114, 178));
        }
        let svg = paper.svg();
        assert_eq!(svg.matches("<radialGradient id=\"ball-0072b2\"").count(), 1);
        assert_eq!(svg.matches("url(#ball-0072b2)").count(), 5);

        // The PNG has the blue of the ball's body.
        let pixels = resvg::tiny_skia::Pixmap::decode_png(&canvas::png(&svg)?);
        let pixels = pixels.map_err(|error| FigureError::Png(error.to_string()))?;
        let blue = pixels
            .pixel(40, 52)
            .map(|at| (at.red() < at.green(), at.green() < at.blue()));
        assert_eq!(blue, Some((true, true)));
        Ok(())
    }
}
