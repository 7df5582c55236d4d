//! SVG documents, PNG files made from them, and the embedded font of both.

use super::FigureError;
use plotters::coord::Shift;
use plotters::prelude::*;
use resvg::{tiny_skia, usvg};
use skrifa::instance::{LocationRef, Size};
use skrifa::raw::{TableProvider, tables::kern::SubtableKind};
use skrifa::{FontRef, MetadataProvider};
use std::sync::Arc;

/// SVG units per pixel: plotters knows whole units only and a pixel is too coarse.
pub(crate) const PX: i32 = 10;

/// A rectangle of the image, measured in SVG units.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Refuses sizes that cannot be drawn.
pub(crate) fn check_size((width, height): (u32, u32)) -> Result<(), FigureError> {
    if ![width, height]
        .iter()
        .all(|side| (120..=4000).contains(side))
    {
        return Err(FigureError::Size(width, height));
    }
    Ok(())
}

/// Draws on a white canvas and returns the SVG document.
pub(super) fn svg(
    size: (u32, u32),
    paint: impl Fn(&Area) -> Result<(), FigureError>,
) -> Result<String, FigureError> {
    svg_shown_at(size, size, paint)
}

/// The same, drawn at one size and shown at another.
pub(super) fn svg_shown_at(
    shown: (u32, u32),
    (width, height): (u32, u32),
    paint: impl Fn(&Area) -> Result<(), FigureError>,
) -> Result<String, FigureError> {
    check_size(shown)?;
    check_size((width, height))?;
    let fine = (width * PX as u32, height * PX as u32);
    let mut text = String::new();
    let root = SVGBackend::with_string(&mut text, fine).into_drawing_area();
    root.fill(&WHITE)?;
    paint(&root)?;
    root.present()?;
    drop(root);

    // The fine units stay inside; the image keeps its size in pixels.
    let drawn = format!("width=\"{}\" height=\"{}\"", fine.0, fine.1);
    let (width, height) = shown;
    let shown = format!("width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\"");
    Ok(text.replacen(&drawn, &shown, 1))
}

/// Renders an SVG document as a PNG file with the embedded font.
pub(crate) fn png(svg: &str) -> Result<Vec<u8>, FigureError> {
    let mut options = usvg::Options::default();
    let face = Arc::new(dejavu::sans::regular());
    let fonts = options.fontdb_mut();
    fonts.load_font_source(usvg::fontdb::Source::Binary(face));
    fonts.set_sans_serif_family("DejaVu Sans");
    let tree = usvg::Tree::from_str(svg, &options).map_err(failed)?;
    let size = tree.size().to_int_size();
    let pixels = tiny_skia::Pixmap::new(size.width(), size.height());
    let mut pixels = pixels.ok_or_else(|| failed("no pixels"))?;
    resvg::render(&tree, usvg::Transform::identity(), &mut pixels.as_mut());
    pixels.encode_png().map_err(failed)
}

// Any failure on the way to a PNG file.
fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError::Png(error.to_string())
}

/// A text style in pixels; plotters divides sizes by 1.24 when it writes SVG.
pub(super) fn font(size: f64) -> TextStyle<'static> {
    let size = size * 1.24 * f64::from(PX);
    ("sans-serif", size)
        .into_font()
        .color(&RGBColor(50, 50, 50))
}

/// Width of a text in SVG units, 7 % generous; plotters has no font and only guesses.
pub(crate) fn width(text: &str, size: f64) -> i32 {
    let share = width_in_heights(text).unwrap_or(0.0);
    (share * size * 1.24 * f64::from(PX)) as i32
}

// Width of a text in the embedded font, in units of the font's height from ascent to descent.
fn width_in_heights(text: &str) -> Option<f64> {
    let font = FontRef::new(dejavu::sans::regular()).ok()?;
    let (map, kern) = (font.charmap(), font.kern().ok()?);
    let subtables: Vec<_> = kern.subtables().flatten().collect();
    let glyphs: Vec<_> = text
        .chars()
        .map(|letter| map.map(letter).unwrap_or_default())
        .collect();
    let advances = font.glyph_metrics(Size::unscaled(), LocationRef::default());
    let alone: f32 = glyphs
        .iter()
        .filter_map(|id| advances.advance_width(*id))
        .sum();

    // Pairs of letters that stand closer, or farther apart.
    let kerning = |pair: &[skrifa::GlyphId]| {
        subtables.iter().find_map(|table| match table.kind() {
            Ok(SubtableKind::Format0(pairs)) => pairs.kerning(pair[0], pair[1]),
            _ => None,
        })
    };
    let together: i32 = glyphs.windows(2).filter_map(kerning).sum();
    let metrics = font.metrics(Size::unscaled(), LocationRef::default());
    let height = f64::from(metrics.ascent - metrics.descent);
    Some((f64::from(alone) + f64::from(together)) / height)
}

/// A font size at which a text is no wider than `room`, at most `size`.
pub(crate) fn fitting(text: &str, size: f64, room: i32) -> f64 {
    let needed = f64::from(width(text, size).max(1));
    size * (f64::from(room) / needed).clamp(0.4, 1.0)
}
