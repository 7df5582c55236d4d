//! Lines of text on both backends.

use super::super::error::FigureError;
use super::super::font::{self, FAMILY};
use super::super::scene::{Anchor, Text};
use super::{Pen, failed, rgb};
use plotters::backend::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontTransform, TextStyle};

// The font size and drop to the baseline by which the SVG backend changes a text.
const SVG_TEXT: f64 = 1.24;
const SVG_DROP: f64 = 0.76;

/// Paints a line of text with its baseline where the scene wants it.
pub(super) fn write<B: DrawingBackend>(
    backend: &mut B,
    text: &Text,
    pen: &Pen,
) -> Result<(), FigureError> {
    if pen.bitmap {
        return write_pixels(backend, text, pen);
    }
    let size = text.size * pen.scale;
    let (x, y) = pen.units(text.at);
    let drop = (size * SVG_DROP).round() as i32;
    let (at, turn) = if text.upwards {
        ((x - drop, y), FontTransform::Rotate270)
    } else {
        ((x, y - drop), FontTransform::None)
    };
    let anchor = match text.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let color = rgb(text.color);
    let style = TextStyle::from((FAMILY, size * SVG_TEXT))
        .color(&color)
        .pos(Pos::new(anchor, VPos::Top))
        .transform(turn);
    backend.draw_text(&text.text, &style, at).map_err(failed)
}

// Paints a line of text glyph by glyph in the embedded font.
fn write_pixels<B: DrawingBackend>(
    backend: &mut B,
    text: &Text,
    pen: &Pen,
) -> Result<(), FigureError> {
    let size = text.size * pen.scale;
    let share = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5,
        Anchor::End => 1.0,
    };
    let back = (share * font::width(&text.text, size)).round() as i32;
    let (left, base) = pen.units(text.at);
    let (width, height) = backend.get_size();
    let mut result = Ok(());
    font::draw(&text.text, size, |x, y, cover| {
        let along = x - back;
        let (x, y) = if text.upwards {
            (left + y, base - along)
        } else {
            (left + along, base + y)
        };
        let inside = (0..width as i32).contains(&x) && (0..height as i32).contains(&y);
        if inside && result.is_ok() {
            let ink = rgb(text.color).mix(cover).to_backend_color();
            result = backend.draw_pixel((x, y), ink).map_err(failed);
        }
    });
    result
}
