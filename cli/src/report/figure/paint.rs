//! Paints a scene with the plotters backends.

mod text;

use super::error::FigureError;
use super::scene::{Color, Mark, Point, Scene};
use plotters::backend::{BitMapBackend, DrawingBackend, SVGBackend};
use plotters::style::{Color as _, RGBColor, ShapeStyle};

// Whole units per pixel: the backends know no fractions of a unit.
const SVG_SCALE: u32 = 10;
const PNG_SCALE: u32 = 3;

// How one backend is drawn on.
struct Pen {
    scale: f64,
    /// Whether marks become pixels at once.
    bitmap: bool,
}

/// The scene as an SVG document.
pub(super) fn svg(scene: &Scene) -> Result<String, FigureError> {
    let (width, height) = scene.size;
    let fine = (width * SVG_SCALE, height * SVG_SCALE);
    let pen = Pen {
        scale: f64::from(SVG_SCALE),
        bitmap: false,
    };
    let mut text = String::new();
    {
        let mut backend = SVGBackend::with_string(&mut text, fine);
        paint(&mut backend, scene, &pen)?;
    }

    // The fine units stay inside; the image keeps its size in pixels.
    let drawn = format!("width=\"{}\" height=\"{}\"", fine.0, fine.1);
    let shown = format!("width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\"");
    Ok(text.replacen(&drawn, &shown, 1))
}

/// The scene as a PNG file.
pub(super) fn png(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    let (width, height) = scene.size;
    let pixels = pixels(scene)?;
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(file)
}

// The scene as RGB bytes, drawn finely and averaged for smooth edges.
fn pixels(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    let (width, height) = (scene.size.0 * PNG_SCALE, scene.size.1 * PNG_SCALE);
    let mut fine = vec![255; width as usize * height as usize * 3];
    let pen = Pen {
        scale: f64::from(PNG_SCALE),
        bitmap: true,
    };
    {
        let mut backend = BitMapBackend::with_buffer_and_format(&mut fine, (width, height))
            .map_err(|error| FigureError::Draw(error.to_string()))?;
        paint::<BitMapBackend>(&mut backend, scene, &pen)?;
    }
    Ok(averaged(&fine, width as usize * 3, PNG_SCALE as usize))
}

// Averages square blocks of pixels.
fn averaged(fine: &[u8], row: usize, block: usize) -> Vec<u8> {
    let mut coarse = Vec::with_capacity(fine.len() / (block * block));
    let count = (block * block) as u32;
    for rows in fine.chunks_exact(row * block) {
        for left in (0..row).step_by(3 * block) {
            for channel in 0..3 {
                let lines = rows.chunks_exact(row);
                let sum: u32 = lines
                    .flat_map(|line| line[left..left + 3 * block].iter().skip(channel).step_by(3))
                    .map(|value| u32::from(*value))
                    .sum();
                coarse.push(((sum + count / 2) / count) as u8);
            }
        }
    }
    coarse
}

// Paints all marks in order.
fn paint<B: DrawingBackend>(backend: &mut B, scene: &Scene, pen: &Pen) -> Result<(), FigureError> {
    let size = (f64::from(scene.size.0), f64::from(scene.size.1));
    let white = shape(Color(255, 255, 255), 1.0).filled();
    let corners = (pen.units((0.0, 0.0)), pen.units(size));
    backend
        .draw_rect(corners.0, corners.1, &white, true)
        .map_err(failed)?;
    for mark in &scene.marks {
        match mark {
            Mark::Stroke {
                points,
                width,
                color,
            } => stroke(backend, points, *width, *color, pen)?,
            Mark::Fill {
                outline,
                color,
                opacity,
            } => {
                let corners: Vec<_> = outline.iter().map(|point| pen.units(*point)).collect();
                let style = shape(*color, *opacity).filled();
                backend.fill_polygon(corners, &style).map_err(failed)?;
            }
            Mark::Disc { at, radius, color } => {
                let style = shape(*color, 1.0).filled();
                let radius = pen.length(*radius);
                backend
                    .draw_circle(pen.units(*at), radius, &style, true)
                    .map_err(failed)?;
            }
            Mark::Text(text) => text::write(backend, text, pen)?,
        }
    }
    backend.present().map_err(failed)
}

// Paints a line, segment by segment with round corners on a bitmap.
fn stroke<B: DrawingBackend>(
    backend: &mut B,
    points: &[Point],
    width: f64,
    color: Color,
    pen: &Pen,
) -> Result<(), FigureError> {
    let mut path: Vec<_> = points.iter().map(|point| pen.units(*point)).collect();
    path.dedup();
    let thick = pen.length(width);
    let style = shape(color, 1.0).stroke_width(thick);
    if !pen.bitmap {
        return backend.draw_path(path, &style).map_err(failed);
    }
    for pair in path.windows(2) {
        segment(backend, pair[0], pair[1], &style)?;
    }
    let inner = path.iter().skip(1).take(path.len().saturating_sub(2));
    for corner in inner {
        let radius = thick / 2;
        backend
            .draw_circle(*corner, radius, &style.filled(), true)
            .map_err(failed)?;
    }
    Ok(())
}

// Paints one segment on a bitmap; thin upright and level ones fill whole pixels.
fn segment<B: DrawingBackend>(
    backend: &mut B,
    from: (i32, i32),
    to: (i32, i32),
    style: &ShapeStyle,
) -> Result<(), FigureError> {
    let sloped = from.0 != to.0 && from.1 != to.1;
    if sloped || style.stroke_width > PNG_SCALE {
        return backend.draw_path([from, to], style).map_err(failed);
    }
    let reach = style.stroke_width as i32 / 2;
    let (x, y) = if from.0 == to.0 {
        (reach, 0)
    } else {
        (0, reach)
    };
    let first = (from.0.min(to.0) - x, from.1.min(to.1) - y);
    let end = (from.0.max(to.0) + x + 1, from.1.max(to.1) + y + 1);
    backend
        .draw_rect(first, end, &style.filled(), true)
        .map_err(failed)
}

impl Pen {
    // Whole backend units of a point: a pixel on a bitmap, the nearest place else.
    fn units(&self, (x, y): Point) -> (i32, i32) {
        let whole = if self.bitmap { f64::floor } else { f64::round };
        (whole(x * self.scale) as i32, whole(y * self.scale) as i32)
    }

    // Whole backend units of a length, at least one.
    fn length(&self, pixels: f64) -> u32 {
        (pixels * self.scale).round().max(1.0) as u32
    }
}

// A colour as plotters knows it.
fn rgb(Color(red, green, blue): Color) -> RGBColor {
    RGBColor(red, green, blue)
}

// A plain style of one colour.
fn shape(color: Color, opacity: f64) -> ShapeStyle {
    rgb(color).mix(opacity).into()
}

// Any backend failure as our own error.
fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError::Draw(error.to_string())
}

#[cfg(test)]
mod tests;
