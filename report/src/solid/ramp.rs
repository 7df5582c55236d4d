//! Colours for values from dark blue over green to yellow, and the bar that explains them.

use super::svg_canvas::{Anchor, SvgCanvas, width};
use super::view::Frame;
use crate::figure::axis::{Axis, Span};
use crate::figure::{Color, FigureError, canvas};

/// Lightness and hue (degrees) at the low and the high end, and the colourfulness between, in
/// Oklab: lightness rises evenly, so that the order survives grey printing and colour blindness.
const LIGHTNESS: (f64, f64) = (0.36, 0.92);
const HUE: (f64, f64) = (285.0, 100.0);
const CHROMA: f64 = 0.125;
/// Steps of the ramp: finer than the eye can distinguish, with few shadings in a file.
const STEPS: f64 = 63.0;
/// Colour of a value that is missing.
pub const MISSING: Color = Color(200, 200, 200);

/// Width of the bar, its gap to the labels, and sizes of labels and name, px.
const BAR: f64 = 14.0;
const GAP: f64 = 7.0;
const LABEL: f64 = 12.0;
const NAME: f64 = 14.0;
/// Colour of the bar's frame.
const FRAME: Color = Color(80, 80, 80);

/// The colour at a share from 0, low, to 1, high.
pub fn color(share: f64) -> Color {
    if !share.is_finite() {
        return MISSING;
    }
    let share = (share.clamp(0.0, 1.0) * STEPS).round() / STEPS;
    let between = |(low, high): (f64, f64)| low + share * (high - low);
    let (sin, cos) = between(HUE).to_radians().sin_cos();
    oklab(between(LIGHTNESS), CHROMA * cos, CHROMA * sin)
}

// Oklab to sRGB (Ottosson 2020, "A perceptual color space for image processing"); colours that a
// screen cannot show are cut to what it can.
fn oklab(lightness: f64, a: f64, b: f64) -> Color {
    let long = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let medium = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let short = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    let red = 4.076_741_662_1 * long - 3.307_711_591_3 * medium + 0.230_969_929_2 * short;
    let green = -1.268_438_004_6 * long + 2.609_757_401_1 * medium - 0.341_319_396_5 * short;
    let blue = -0.004_196_086_3 * long - 0.703_418_614_7 * medium + 1.707_614_701_0 * short;
    Color(encoded(red), encoded(green), encoded(blue))
}

// The sRGB byte of a linear intensity (IEC 61966-2-1).
fn encoded(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let value = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * value).round() as u8
}

/// Draws the bar at the right of a frame, with ticks and the name of its axis, and returns the
/// rest of the frame.
pub fn bar(
    paper: &mut SvgCanvas,
    (axis, span): (&Axis, &Span),
    [left, top, right, bottom]: Frame,
) -> Result<Frame, FigureError> {
    let (high, low) = (top + 20.0, bottom - 30.0);
    let ticks = span.ticks(((low - high) / 45.0).max(2.0) as usize).0;
    let widest = ticks
        .iter()
        .map(|tick| width(&tick.1, LABEL))
        .fold(0.0, f64::max);
    let room = (low - high).max(1.0) as i32 * canvas::PX;
    let size = canvas::fitting(&axis.label, NAME, room);
    let named = if axis.label.is_empty() {
        0.0
    } else {
        NAME + GAP
    };
    let start = right - named - widest - GAP - BAR;
    let height = |share: f64| low + share * (high - low);

    // One stripe a step, then the frame, the ticks and the name.
    for step in 0..=STEPS as u32 {
        let (from, to) = (f64::from(step), f64::from(step + 1));
        let (below, above) = (height(from / (STEPS + 1.0)), height(to / (STEPS + 1.0)));
        let corners = [
            (start, below),
            (start + BAR, below),
            (start + BAR, above),
            (start, above),
        ];
        paper.tile(&corners, color(from / STEPS));
    }
    let end = start + BAR;
    let border = [
        (start, low),
        (end, low),
        (end, high),
        (start, high),
        (start, low),
    ];
    paper.line(&border, FRAME, 1.0);
    for (share, label) in ticks {
        let y = height(share);
        paper.line(&[(end, y), (end + 4.0, y)], FRAME, 1.0);
        paper.text((end + GAP, y), &label, LABEL, Anchor::Start);
    }
    let middle = (right - NAME / 2.0, (low + high) / 2.0);
    paper.turned_text(middle, &axis.label, size, Anchor::Middle, -90.0);
    Ok([left, top, start - GAP, bottom])
}

#[cfg(test)]
mod tests {
    use super::*;

    // Luminance of a colour (Rec. 709 weights of the linear intensities).
    fn luminance(Color(red, green, blue): Color) -> f64 {
        let linear = |byte: u8| (f64::from(byte) / 255.0).powf(2.2);
        0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
    }

    #[test]
    fn the_ramp_grows_lighter_all_the_way() {
        let shades: Vec<f64> = (0..=63)
            .map(|at| luminance(color(f64::from(at) / 63.0)))
            .collect();
        assert!(
            shades.windows(2).all(|pair| pair[1] > pair[0]),
            "{shades:?}"
        );
        assert!(shades[0] < 0.1 && shades[63] > 0.7);
    }

    #[test]
    fn known_colours_come_out_right() {
        // White, black and the corners of the sRGB gamut as Oklab has them.
        assert_eq!(oklab(1.0, 0.0, 0.0), Color(255, 255, 255));
        assert_eq!(oklab(0.0, 0.0, 0.0), Color(0, 0, 0));
        assert_eq!(oklab(0.627_955, 0.224_863, 0.125_846), Color(255, 0, 0));
        assert_eq!(oklab(0.452_014, -0.032_457, -0.311_528), Color(0, 0, 255));
    }

    #[test]
    fn missing_values_are_grey_and_outer_ones_end_colours() {
        assert_eq!(color(f64::NAN), MISSING);
        assert_eq!((color(-3.0), color(7.0)), (color(0.0), color(1.0)));
    }
}
