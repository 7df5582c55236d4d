//! Axes, the span of values they show, and their ticks.

use super::FigureError;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::ops::{Range, RangeInclusive};

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
    pub(crate) label: String,
    pub(super) range: Option<(f64, f64)>,
    scale: Scale,
    names: Vec<String>,
}

impl Axis {
    /// An axis whose range follows from the data.
    pub fn new(label: impl Into<String>, scale: Scale) -> Self {
        Self {
            label: label.into(),
            range: None,
            scale,
            names: Vec::new(),
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

    /// An axis of named cases at 1, 2, 3 and so on.
    pub fn named(label: impl Into<String>, names: Vec<String>) -> Self {
        let end = names.len() as f64 + 0.5;
        Self {
            names,
            ..Self::linear(label).range(0.5, end.max(1.5))
        }
    }

    /// Fixes the shown range instead of taking it from the data.
    #[must_use]
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }
}

/// The shown span of an axis, in powers of ten on a log axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    pub scale: Scale,
    pub low: f64,
    pub high: f64,
}

impl Span {
    /// Takes the fixed range of an axis or fits one around the values.
    pub fn new(axis: &Axis, values: impl Iterator<Item = f64>) -> Result<Self, FigureError> {
        let scale = axis.scale;
        let Some((low, high)) = axis.range else {
            let units = values.filter_map(|value| unit(scale, value));
            return Ok(Self::around(scale, units.collect()));
        };
        match unit(scale, low).zip(unit(scale, high)) {
            Some((low, high)) if high - low > grain(scale, low, high) => {
                Ok(Self { scale, low, high })
            }
            _ => Err(FigureError::Range(axis.label.clone(), low, high)),
        }
    }

    // Fits a span around all values with a margin; a constant gets one of its own size.
    fn around(scale: Scale, mut units: Vec<f64>) -> Self {
        units.sort_by(f64::total_cmp);
        let low = units.first().copied().unwrap_or(0.0);
        let high = units.last().copied().unwrap_or(1.0);
        let margin = match scale {
            _ if high - low > grain(scale, low, high) => 0.04 * (high - low),
            Scale::Linear if high != 0.0 => 0.5 * high.abs(),
            _ => 0.5,
        };

        // The margin does not carry a positive axis below zero.
        let positive = scale == Scale::Linear && low >= 0.0 && high > 0.0;
        let floor = if positive { 0.0 } else { f64::MIN };
        Self {
            scale,
            low: (low - margin).max(floor),
            high: high + margin,
        }
    }

    /// Share of the axis at a value, 0 at the low and 1 at the high end.
    pub fn place(&self, value: f64) -> Option<f64> {
        unit(self.scale, value).map(|unit| self.share(unit).clamp(-1e4, 1e4))
    }

    // Share of the axis at a value given in the unit of the axis.
    fn share(&self, unit: f64) -> f64 {
        (unit - self.low) / (self.high - self.low)
    }

    // Powers of ten inside the span of a log axis.
    fn decades(&self) -> RangeInclusive<i32> {
        self.low.ceil() as i32..=self.high.floor() as i32
    }

    // Decades from one labelled tick of a log axis to the next.
    fn stride(&self, count: usize) -> usize {
        ((self.high - self.low) / count as f64).ceil() as usize
    }

    /// Places between the `ticks` of a log axis: the eight values inside each decade, or the
    /// decades left out where not each has a label. An axis labelled by round values has none.
    pub fn fine_ticks(&self, count: usize) -> Vec<f64> {
        let decades = self.decades();
        let stride = self.stride(count);
        if self.scale == Scale::Linear || decades.clone().step_by(stride).count() < 2 {
            return Vec::new();
        }
        let powers = decades.start() - 1..=*decades.end();
        let parts = |power: i32| (2..=9).map(move |part: i32| (power, f64::from(part).log10()));
        let units: Vec<f64> = if stride == 1 {
            let all = powers.flat_map(parts);
            all.map(|(power, part)| f64::from(power) + part).collect()
        } else {
            let left_out = decades.enumerate().filter(|(at, _)| at % stride != 0);
            left_out.map(|(_, power)| f64::from(power)).collect()
        };
        let places = units.into_iter().map(|unit| self.share(unit));
        places.filter(|at| (0.0..=1.0).contains(at)).collect()
    }

    /// Places and labels of about `count` ticks.
    pub fn ticks(&self, count: usize) -> Ticks {
        let (mut low, mut high) = (self.low, self.high);
        if self.scale == Scale::Log10 {
            let tick = |power| (self.share(f64::from(power)), ten_to(power));
            let decades = self.decades().step_by(self.stride(count));
            let ticks: Vec<_> = decades.map(tick).collect();
            if ticks.len() > 1 {
                return Ticks(ticks);
            }
            (low, high) = (10_f64.powf(low), 10_f64.powf(high));
        }

        // Round values, found by plotters on a span of everyday size.
        let size = 10_f64.powi((high - low).log10().floor() as i32);
        let points = RangedCoordf64::from(low / size..high / size).key_points(count);

        // Very large and very small values share one power of ten.
        let largest = low.abs().max(high.abs());
        let everyday = (1e-2..1e5).contains(&largest);
        let power = largest.log10().floor() * f64::from(u8::from(!everyday));
        let factor = format!("·{}", ten_to(power as i32));
        let label = |value: f64| {
            let digits = (value / 10_f64.powf(power) * 1e9).round() / 1e9 + 0.0;
            let plain = everyday || digits == 0.0;
            digits.to_string().replace('-', "−") + if plain { "" } else { &factor }
        };
        let values = points.into_iter().map(|point| point * size);
        let ticks = values.filter_map(|value| Some((self.place(value)?, label(value))));
        Ticks(ticks.collect())
    }
}

impl Axis {
    /// Its named cases, or about `count` ticks.
    pub(super) fn ticks(&self, span: &Span, count: usize) -> Ticks {
        if self.names.is_empty() {
            return span.ticks(count);
        }
        let places = (1..).map(|case: i32| span.place(f64::from(case)));
        let ticks = places.zip(&self.names);
        Ticks(
            ticks
                .filter_map(|(at, name)| Some((at?, name.clone())))
                .collect(),
        )
    }
}

/// Places and labels of ticks on an axis that runs from 0 to 1 for plotters.
pub(crate) struct Ticks(pub Vec<(f64, String)>);

impl Ranged for Ticks {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, at: &f64, (low, high): (i32, i32)) -> i32 {
        low + (at * f64::from(high - low)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.0.iter().map(|tick| tick.0).collect()
    }

    fn range(&self) -> Range<f64> {
        0.0..1.0
    }
}

impl ValueFormatter<f64> for Ticks {
    fn format_ext(&self, at: &f64) -> String {
        let tick = self.0.iter().find(|tick| tick.0 == *at);
        tick.map_or(String::new(), |tick| tick.1.clone())
    }
}

// Value in the unit of the axis, or nothing when it cannot be shown. On a linear axis what is next
// to the smallest numbers is nought: a span of them has no round values.
fn unit(scale: Scale, value: f64) -> Option<f64> {
    match scale {
        Scale::Linear if value.abs() < 1e-280 => Some(0.0),
        Scale::Linear => (value.abs() < 1e300).then_some(value),
        Scale::Log10 => (1e-300..1e300).contains(&value).then(|| value.log10()),
    }
}

// The smallest span between two ends that can be told from rounding errors.
fn grain(scale: Scale, low: f64, high: f64) -> f64 {
    let least = if scale == Scale::Log10 { 1.0 } else { 0.0 };
    1e-9 * low.abs().max(high.abs()).max(least)
}

// A power of ten in superscript digits.
fn ten_to(power: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |sign: char| {
        sign.to_digit(10)
            .map_or('⁻', |digit| RAISED[digit as usize])
    };
    let power = power.to_string();
    "10".chars().chain(power.chars().map(raised)).collect()
}
