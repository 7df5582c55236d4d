//! The embedded font and the text measures that follow from it.

use super::error::FigureError;
use ab_glyph::{Font, FontRef, ScaleFont, point};
use std::sync::OnceLock;

/// Family name written to the SVG; the PNG uses the embedded DejaVu Sans.
pub(super) const FAMILY: &str = "sans-serif";

// Font size at which texts are measured.
const PROBE: f64 = 1000.0;

// The embedded font, read once per process.
fn font() -> Option<&'static FontRef<'static>> {
    static FONT: OnceLock<Option<FontRef<'static>>> = OnceLock::new();
    let font = FONT.get_or_init(|| FontRef::try_from_slice(dejavu::sans::regular()).ok());
    font.as_ref()
}

/// Fails when the embedded font cannot be read.
pub(super) fn check() -> Result<(), FigureError> {
    font().map(|_| ()).ok_or(FigureError::Font)
}

/// Width of a text in pixels at a font size.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let end = place(text, PROBE, |_, _| {});
    end / PROBE * size
}

/// Passes the inked pixels of a text to `ink`, counted from the start of its baseline.
pub(super) fn draw(text: &str, size: f64, mut ink: impl FnMut(i32, i32, f64)) {
    place(text, size, |font, glyph| {
        if let Some(outline) = font.outline_glyph(glyph) {
            let corner = outline.px_bounds().min;
            outline.draw(|x, y, cover| {
                let (x, y) = (corner.x as i32 + x as i32, corner.y as i32 + y as i32);
                ink(x, y, f64::from(cover));
            });
        }
    });
}

// Visits the glyphs of a text from left to right and returns the end of the last.
fn place(text: &str, size: f64, mut visit: impl FnMut(&FontRef, ab_glyph::Glyph)) -> f64 {
    let Some(font) = font() else {
        return 0.0;
    };
    let units = font.units_per_em().unwrap_or(1000.0);
    let scale = size as f32 * font.height_unscaled() / units;
    let scaled = font.as_scaled(scale);
    let mut x = 0.0;
    let mut previous = None;
    for character in text.chars() {
        let id = scaled.glyph_id(character);
        x += previous.map_or(0.0, |previous| scaled.kern(previous, id));
        visit(font, id.with_scale_and_position(scale, point(x, 0.0)));
        x += scaled.h_advance(id);
        previous = Some(id);
    }
    f64::from(x)
}

/// Breaks a text into lines no wider than `limit`, at spaces only.
pub(super) fn wrap(text: &str, size: f64, limit: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= limit => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The largest size up to `size` at which a text fits into `limit` pixels.
pub(super) fn fitting_size(text: &str, size: f64, limit: f64) -> f64 {
    let needed = width(text, size);
    if needed <= limit || needed <= 0.0 {
        return size;
    }
    (size * limit / needed).max(7.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_keeps_every_word_and_the_limit() {
        assert!(check().is_ok());
        let text = "one two three four five six seven";
        let lines = wrap(text, 12.0, 80.0);
        assert!(lines.len() > 1);
        assert!(lines.iter().all(|line| width(line, 12.0) <= 80.0));
        assert_eq!(lines.join(" "), text);
    }

    #[test]
    fn long_texts_shrink_to_fit() {
        assert!(check().is_ok());
        let size = fitting_size("a label too long for its axis", 14.0, 150.0);
        assert!(size < 14.0);
        assert!(width("a label too long for its axis", size) <= 151.0);
    }
}
