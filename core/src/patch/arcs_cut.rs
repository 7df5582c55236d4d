//! An ellipse cut by a convex polygon.

use super::arcs::{Maker, Side};
use super::ellipse::Ellipse;
use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// Chords shorter than this, of the disk's radius, are points.
const SHORTEST: f64 = 8.0;

/// The ellipse as the image of the unit disk.
struct Image<R: Real> {
    centre: Vector2<R>,
    half_diameters: [Vector2<R>; 2],
    semi_axes: [R; 2],
    axes: [Vector2<R>; 2],
}

impl<R: Real> Image<R> {
    fn to_disk(&self, at: &Vector2<R>) -> Vector2<R> {
        let from = at - self.centre;
        let [a, b] = self.semi_axes;
        let [major, minor] = &self.axes;
        Vector2::new(dot(&from, major) / a, dot(&from, minor) / b)
    }

    fn of_disk(&self, at: &Vector2<R>) -> Vector2<R> {
        let [p, q] = &self.half_diameters;
        self.centre + p * at.x + q * at.y
    }
}

/// Lays the sides of the common part.
pub(super) fn cut<R: Real, S: AsRef<[Side<R>]> + AsMut<[Side<R>]>>(
    made: &mut Maker<R, S>,
    ellipse: &Ellipse<R>,
    corners: &[[R; 2]],
) -> Result<(), OutlineError> {
    let in_loop = 0;
    let [a, b] = ellipse.semi_axes();
    let axes = [ellipse.major_axis(), ellipse.minor()];
    let image = Image {
        centre: ellipse.centre(),
        half_diameters: [axes[0] * a, axes[1] * b],
        semi_axes: [a, b],
        axes,
    };
    if corners.len() < 3 {
        let given = corners.len();
        return Err(OutlineError::Corners { in_loop, given });
    }
    for (corner, at) in corners.iter().enumerate() {
        if !at.iter().all(|part| part.is_finite()) {
            return Err(OutlineError::Position { in_loop, corner });
        }
    }
    // Chords in their order; arcs go from the end of one to the start of the next one.
    let (mut first, mut last) = (None, None);
    let mut has_centre = true;
    let next = corners.iter().cycle().skip(1);
    for (from, to) in corners.iter().zip(next) {
        let ends = [*from, *to].map(Vector2::from);
        let [from, to] = ends.map(|end| image.to_disk(&end));
        let along = to - from;
        if from.x * along.y - from.y * along.x < R::ZERO {
            has_centre = false;
        }
        let Some(chord) = Chord::of(&from, &to) else {
            continue;
        };
        if let Some(end) = last {
            arc(made, &image, end, chord.from)?;
        }
        if first.is_none() {
            first = Some(chord.from);
        }
        last = Some(chord.to);
        made.line(image.of_disk(&chord.from), image.of_disk(&chord.to))?;
    }
    match (last, first) {
        (Some(end), Some(start)) => arc(made, &image, end, start),
        _ if has_centre => {
            let turn = R::TWO * R::PI;
            made.arc(image.centre, image.half_diameters, [R::ZERO, turn])
        }
        _ => Err(OutlineError::Flat { in_loop }),
    }
}

/// A part of the polygon's boundary in the unit disk.
struct Chord<R: Real> {
    from: Vector2<R>,
    to: Vector2<R>,
}

impl<R: Real> Chord<R> {
    /// The part of a line in the unit disk.
    fn of(from: &Vector2<R>, to: &Vector2<R>) -> Option<Self> {
        let along = to - from;
        let length = length(&along);
        if length == R::ZERO {
            return None;
        }
        let t = along / length;
        // Distance from the centre, and the half chord.
        let offset = from.x * t.y - from.y * t.x;
        let half_sq = (R::ONE - offset) * (R::ONE + offset);
        if half_sq <= R::ZERO {
            return None;
        }
        let half = half_sq.sqrt();
        let foot = Vector2::new(t.y, -t.x) * offset;
        let start = dot(from, &t);
        let end = start + length;
        // Ends on the circle, or corners of the polygon in the disk.
        let (low, first) = if start > -half {
            (start, *from)
        } else {
            (-half, foot - t * half)
        };
        let (high, last) = if end < half {
            (end, *to)
        } else {
            (half, foot + t * half)
        };
        if high - low <= R::from_f64(SHORTEST) * R::EPSILON {
            return None;
        }
        Some(Self {
            from: first,
            to: last,
        })
    }
}

/// The arc between the ends of two chords, counterclockwise; nothing between chords that meet.
fn arc<R: Real, S: AsRef<[Side<R>]> + AsMut<[Side<R>]>>(
    made: &mut Maker<R, S>,
    image: &Image<R>,
    from: Vector2<R>,
    to: Vector2<R>,
) -> Result<(), OutlineError> {
    let apart = to - from;
    if length(&apart) <= R::from_f64(SHORTEST) * R::EPSILON {
        return Ok(());
    }
    if is_short(&from, &to) {
        return quarter(made, image, &half_way(&from, &to), &from);
    }
    let middle = half_way(&from, &to);
    for (from, to) in [(from, middle), (middle, to)] {
        let half = half_way(&from, &to);
        if is_short(&from, &to) {
            quarter(made, image, &half, &from)?;
        } else {
            quarter(made, image, &half_way(&from, &half), &from)?;
            quarter(made, image, &half_way(&half, &to), &half)?;
        }
    }
    Ok(())
}

/// True for an arc of at most a third of a turn.
fn is_short<R: Real>(from: &Vector2<R>, to: &Vector2<R>) -> bool {
    dot(from, to) >= -R::HALF && from.x * to.y - from.y * to.x > R::ZERO
}

/// An arc about its middle from one end.
fn quarter<R: Real, S: AsRef<[Side<R>]> + AsMut<[Side<R>]>>(
    made: &mut Maker<R, S>,
    image: &Image<R>,
    middle: &Vector2<R>,
    from: &Vector2<R>,
) -> Result<(), OutlineError> {
    let [p, q] = &image.half_diameters;
    let along = p * middle.x + q * middle.y;
    let across = q * middle.x - p * middle.y;
    // The tangent of half the angle from the middle to the end.
    let sin = from.x * middle.y - from.y * middle.x;
    let reach = sin / (R::ONE + dot(from, middle));
    made.half_arc(image.centre, [along, across], reach)
}

/// The direction half way between two others, counterclockwise.
fn half_way<R: Real>(from: &Vector2<R>, to: &Vector2<R>) -> Vector2<R> {
    let apart = to - from;
    let sum = from + to;
    let is_left = from.x * to.y - from.y * to.x > R::ZERO;
    let way = if dot(from, to) < R::ZERO {
        Vector2::new(apart.y, -apart.x)
    } else if is_left {
        sum
    } else {
        -sum
    };
    way / length(&way)
}

#[inline(always)]
fn dot<R: Real>(a: &Vector2<R>, b: &Vector2<R>) -> R {
    a.x * b.x + a.y * b.y
}

#[inline(always)]
fn length<R: Real>(of: &Vector2<R>) -> R {
    of.x.hypot(of.y)
}
