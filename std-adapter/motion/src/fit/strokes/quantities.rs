//! Names and units of everything that is measured: files, tables and arrays walk these lists.

use super::{Stroke, StrokeSummary};

/// A number of a stroke or of a summary.
#[derive(Clone, Copy, Debug)]
pub struct StrokeQuantity<T> {
    /// Name in files.
    pub name: &'static str,
    /// Unit; `f` is the unit of the friction, empty for pure numbers.
    pub unit: &'static str,
    /// One phrase on what it is.
    pub meaning: &'static str,
    /// Its value; NaN where there is none.
    pub value: fn(&T) -> f64,
}

impl Stroke {
    /// All numbers of a stroke.
    ///
    /// ```
    /// use tribos::fit::strokes::Stroke;
    /// assert_eq!(Stroke::QUANTITIES[0].name, "number");
    /// ```
    pub const QUANTITIES: [StrokeQuantity<Self>; 14] = [
        quantity("number", "", "number of the stroke, from 1", |s| {
            s.number as f64
        }),
        quantity("start", "s", "time of its first row", |s| s.start),
        quantity(
            "duration",
            "s",
            "time from its first to its last row",
            |s| s.duration,
        ),
        quantity("direction", "", "1 forward, -1 backward", |s| {
            s.direction.sign()
        }),
        quantity("length", "m", "distance", |s| or_nan(s.length)),
        quantity("speed", "m/s", "mean speed", |s| or_nan(s.mean_speed)),
        quantity("peak", "f", "static peak", |s| {
            or_nan(s.static_peak.map(|peak| peak.value))
        }),
        quantity("peak_time", "s", "time of the static peak", |s| {
            or_nan(s.static_peak.map(|peak| peak.time))
        }),
        quantity("mean", "f", "mean friction of the steady part", |s| s.mean),
        quantity(
            "deviation",
            "f",
            "standard deviation in the steady part",
            |s| s.deviation,
        ),
        quantity("slips", "", "number of slips", |s| {
            s.stick_slip.slips as f64
        }),
        quantity("drop", "f", "mean fall of a slip", |s| {
            or_nan(s.stick_slip.drop)
        }),
        quantity("period", "s", "mean time between slips", |s| {
            or_nan(s.stick_slip.period)
        }),
        quantity("cut_off", "", "1 if the record cuts it off", |s| {
            f64::from(u8::from(s.is_cut_off))
        }),
    ];
}

impl StrokeSummary {
    /// All numbers of a summary.
    ///
    /// ```
    /// use tribos::fit::strokes::StrokeSummary;
    /// assert_eq!(StrokeSummary::QUANTITIES[1].name, "mean");
    /// ```
    pub const QUANTITIES: [StrokeQuantity<Self>; 11] = [
        quantity("strokes", "", "number of the strokes", |s| s.strokes as f64),
        quantity("mean", "f", "mean friction", |s| s.mean),
        quantity("error", "f", "standard error of the mean", |s| {
            or_nan(s.standard_error)
        }),
        quantity(
            "deviation",
            "f",
            "standard deviation between strokes",
            |s| or_nan(s.deviation),
        ),
        quantity("offset", "f", "half of forward less backward", |s| {
            or_nan(s.offset)
        }),
        quantity("peak", "f", "mean of the static peaks", |s| {
            or_nan(s.static_peak)
        }),
        quantity(
            "peak_deviation",
            "f",
            "standard deviation of the static peaks",
            |s| or_nan(s.static_peak_deviation),
        ),
        quantity("slips", "", "number of slips", |s| s.slips as f64),
        quantity("drop", "f", "mean fall of a slip", |s| or_nan(s.drop)),
        quantity("period", "s", "mean time between slips", |s| {
            or_nan(s.period)
        }),
        quantity("distance", "m", "length of all strokes", |s| {
            or_nan(s.distance)
        }),
    ];
}

const fn quantity<T>(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: fn(&T) -> f64,
) -> StrokeQuantity<T> {
    StrokeQuantity {
        name,
        unit,
        meaning,
        value,
    }
}

fn or_nan(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}
