//! The ends of a box.

use crate::exchange::text::{Line, TextError};

/// Low and high end along an axis.
pub(super) fn bounds(line: Line, low: &str, high: &str) -> Result<[f64; 2], TextError> {
    let ends = [
        line.number("the low end of the box", low)?,
        line.number("the high end of the box", high)?,
    ];
    let length = ends[1] - ends[0];
    if length > 0.0 && length.is_finite() {
        Ok(ends)
    } else {
        let valid = format!("more than the low end {low} by a finite length");
        Err(line.invalid("the high end of the box", valid, high))
    }
}

/// The refusal of a box with angles.
pub(super) fn tilted(line: Line) -> TextError {
    crate::exchange::spheres::tilted(line.number)
}
