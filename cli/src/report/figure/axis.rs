//! Axes and the span of values they show.

use super::error::FigureError;

// Share of the data span left free at each end of an automatic range.
const MARGIN: f64 = 0.04;

// Values beyond this size are treated as infinite.
const HUGE: f64 = 1e300;

// Positions this many plot widths away are as good as any farther ones.
const FAR: f64 = 1e4;

/// How values are spread along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps for equal differences.
    Linear,
    /// Equal steps for equal ratios; only positive values can be shown.
    Log10,
}

/// One axis of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) label: String,
    pub(super) scale: Scale,
    pub(super) range: Option<(f64, f64)>,
}

impl Axis {
    /// An axis whose range follows from the data.
    pub fn new(label: impl Into<String>, scale: Scale) -> Self {
        Self {
            label: label.into(),
            scale,
            range: None,
        }
    }

    /// A linear axis.
    pub fn linear(label: impl Into<String>) -> Self {
        Self::new(label, Scale::Linear)
    }

    /// A logarithmic axis.
    pub fn log10(label: impl Into<String>) -> Self {
        Self::new(label, Scale::Log10)
    }

    /// Fixes the shown range instead of taking it from the data.
    #[must_use]
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }
}

/// The shown span of an axis, in powers of ten on a log axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub scale: Scale,
    pub low: f64,
    pub high: f64,
}

impl Span {
    /// Takes the fixed range of an axis or fits one around the values.
    pub fn new(axis: &Axis, values: impl Iterator<Item = f64>) -> Result<Self, FigureError> {
        let Some((low, high)) = axis.range else {
            return Ok(Self::around(axis.scale, values));
        };
        let ends = unit(axis.scale, low).zip(unit(axis.scale, high));
        match ends {
            Some((from, to)) if to - from > 1e-9 * from.abs().max(to.abs()) => Ok(Self {
                scale: axis.scale,
                low: from,
                high: to,
            }),
            _ => Err(FigureError::Range {
                axis: axis.label.clone(),
                low,
                high,
            }),
        }
    }

    // Fits a span around all values that can be shown, with a margin.
    fn around(scale: Scale, values: impl Iterator<Item = f64>) -> Self {
        let ends =
            values
                .filter_map(|value| unit(scale, value))
                .fold(None, |ends, unit| match ends {
                    None => Some((unit, unit)),
                    Some((low, high)) => Some((unit.min(low), unit.max(high))),
                });
        let (low, high) = ends.unwrap_or((0.0, 1.0));
        let size = low.abs().max(high.abs());

        // A constant gets a window of its own size around it.
        if high - low <= 1e-9 * size || high == low {
            let half = match scale {
                Scale::Linear if size > 0.0 => 0.5 * size,
                _ => 0.5,
            };
            let (low, high) = (low - half, high + half);
            return Self { scale, low, high };
        }

        // The margin does not carry a positive axis below zero.
        let margin = MARGIN * (high - low);
        let floor = if scale == Scale::Linear && low >= 0.0 {
            0.0
        } else {
            f64::NEG_INFINITY
        };
        Self {
            scale,
            low: (low - margin).max(floor),
            high: high + margin,
        }
    }

    /// Position of a value, 0 at the low end and 1 at the high end.
    pub fn place(&self, value: f64) -> Option<f64> {
        let unit = unit(self.scale, value)?;
        let position = (unit - self.low) / (self.high - self.low);
        Some(position.clamp(-FAR, FAR))
    }

    /// Position that puts values a log axis cannot show at its far low end.
    pub fn place_or_end(&self, value: f64) -> Option<f64> {
        if value.is_nan() {
            return None;
        }
        let end = if value > 0.0 { FAR } else { -FAR };
        Some(self.place(value).unwrap_or(end))
    }
}

// Value in the unit of the axis, or nothing when it cannot be shown.
fn unit(scale: Scale, value: f64) -> Option<f64> {
    match scale {
        Scale::Linear => (value.abs() < HUGE).then_some(value),
        Scale::Log10 => (value > 1.0 / HUGE && value < HUGE).then(|| value.log10()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_axis_shows_positive_values_only() -> Result<(), FigureError> {
        let values = [-1.0, 0.0, f64::NAN, f64::INFINITY, 1e-3, 1e2];
        let span = Span::new(&Axis::log10("x"), values.into_iter())?;
        assert!((-3.5..-3.0).contains(&span.low) && (2.0..2.5).contains(&span.high));
        assert_eq!(span.place(0.0), None);
        assert_eq!(span.place(-3.0), None);
        assert!(span.place(1.0).is_some());
        Ok(())
    }

    #[test]
    fn empty_and_constant_data_still_span_something() -> Result<(), FigureError> {
        for scale in [Scale::Linear, Scale::Log10] {
            for values in [
                vec![],
                vec![2.0],
                vec![1e-250; 3],
                vec![0.0; 2],
                vec![1e299],
            ] {
                let span = Span::new(&Axis::new("x", scale), values.into_iter())?;
                assert!(span.high > span.low && (span.high - span.low).is_finite());
            }
        }
        Ok(())
    }

    #[test]
    fn impossible_ranges_are_errors() {
        let none = || std::iter::empty();
        for (low, high) in [
            (1.0, 1.0),
            (2.0, 1.0),
            (f64::NAN, 1.0),
            (0.0, f64::INFINITY),
        ] {
            assert!(Span::new(&Axis::linear("x").range(low, high), none()).is_err());
        }
        assert!(Span::new(&Axis::log10("x").range(0.0, 1.0), none()).is_err());
        assert!(Span::new(&Axis::linear("x").range(0.0, 1.0), none()).is_ok());
    }
}
