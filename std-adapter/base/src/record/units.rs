//! Units that logs are written in, and what they are in SI.

use core::f64::consts::PI;

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Time, in s.
    Time,
    /// Length, in m.
    Length,
    /// Speed, in m/s.
    Speed,
    /// Acceleration, in m/s².
    Acceleration,
    /// Angle, in rad.
    Angle,
    /// Rate of turning, in rad/s.
    Rotation,
    /// Angular acceleration, in rad/s².
    AngularAcceleration,
    /// Force, in N.
    Force,
    /// Torque, in N m.
    Torque,
    /// Pressure, in Pa.
    Pressure,
    /// Ratio of two like quantities.
    Ratio,
    /// Electric current or voltage, which stands for a force or a torque and keeps its unit.
    Electric,
    /// A quantity that no table of Tribos has, such as a temperature.
    Other,
}

impl Dimension {
    /// Its unit in SI.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::Length => "m",
            Self::Speed => "m/s",
            Self::Acceleration => "m/s²",
            Self::Angle => "rad",
            Self::Rotation => "rad/s",
            Self::AngularAcceleration => "rad/s²",
            Self::Force => "N",
            Self::Torque => "N m",
            Self::Pressure => "Pa",
            Self::Ratio => "-",
            Self::Electric | Self::Other => "its unit",
        }
    }

    /// Its name in messages.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Length => "length",
            Self::Speed => "speed",
            Self::Acceleration => "acceleration",
            Self::Angle => "angle",
            Self::Rotation => "rate of turning",
            Self::AngularAcceleration => "angular acceleration",
            Self::Force => "force",
            Self::Torque => "torque",
            Self::Pressure => "pressure",
            Self::Ratio => "ratio",
            Self::Electric => "current or voltage",
            Self::Other => "quantity of another kind",
        }
    }
}

/// Standard gravity, in m/s² (CGPM 1901).
const GRAVITY: f64 = 9.806_65;
/// The international inch, in m.
const INCH: f64 = 0.0254;
/// Inches of a foot.
const INCHES_OF_FOOT: f64 = 12.0;
/// The international pound, in kg.
const POUND: f64 = 0.453_592_37;
/// Seconds of a minute, minutes of an hour.
const SIXTY: f64 = 60.0;
/// Degrees of half a turn.
const HALF_TURN: f64 = 180.0;
const MILLI: f64 = 1e-3;
const MICRO: f64 = 1e-6;

/// Spellings of units, as [`plain`] makes them, what they measure, and their size in SI.
const UNITS: &[(&[&str], Dimension, f64)] = {
    use Dimension::*;
    &[
        (
            &["s", "sec", "secs", "second", "seconds", "sek", "sekunden"],
            Time,
            1.0,
        ),
        (&["ms", "msec", "millisecond", "milliseconds"], Time, MILLI),
        (&["us", "usec", "microsecond", "microseconds"], Time, MICRO),
        (&["ns"], Time, 1e-9),
        (
            &["min", "mins", "minute", "minutes", "minuten"],
            Time,
            SIXTY,
        ),
        (
            &["h", "hr", "hour", "hours", "stunden"],
            Time,
            SIXTY * SIXTY,
        ),
        (&["m", "meter", "metre", "meters", "metres"], Length, 1.0),
        (&["cm"], Length, 1e-2),
        (&["mm", "millimeter", "millimetre"], Length, MILLI),
        (
            &["um", "micron", "microns", "micrometer", "micrometre"],
            Length,
            MICRO,
        ),
        (&["nm"], Length, 1e-9),
        (&["km"], Length, 1e3),
        (&["in", "inch", "inches"], Length, INCH),
        (&["ft", "foot", "feet"], Length, INCHES_OF_FOOT * INCH),
        (&["m/s", "m/sec", "mps", "ms-1", "ms^-1"], Speed, 1.0),
        (&["cm/s", "cm/sec", "cms-1"], Speed, 1e-2),
        (&["mm/s", "mm/sec", "mms-1", "mms^-1"], Speed, MILLI),
        (
            &["um/s", "um/sec", "ums-1", "micron/s", "microns/s"],
            Speed,
            MICRO,
        ),
        (&["nm/s"], Speed, 1e-9),
        (&["m/min"], Speed, 1.0 / SIXTY),
        (&["mm/min"], Speed, MILLI / SIXTY),
        (&["km/h"], Speed, 1e3 / (SIXTY * SIXTY)),
        (&["in/s"], Speed, INCH),
        (&["ft/s"], Speed, INCHES_OF_FOOT * INCH),
        (&["m/s2", "m/s^2", "ms-2", "m/s/s"], Acceleration, 1.0),
        (&["cm/s2", "cm/s^2"], Acceleration, 1e-2),
        (&["mm/s2", "mm/s^2"], Acceleration, MILLI),
        (&["g", "g0", "gn"], Acceleration, GRAVITY),
        (&["rad", "radian", "radians"], Angle, 1.0),
        (&["mrad"], Angle, MILLI),
        (
            &["deg", "°", "degree", "degrees", "grad"],
            Angle,
            PI / HALF_TURN,
        ),
        (&["rev", "turn", "turns"], Angle, 2.0 * PI),
        (&["rad/s", "rad/sec", "rads-1"], Rotation, 1.0),
        (
            &["deg/s", "deg/sec", "°/s", "degree/s", "degrees/s"],
            Rotation,
            PI / HALF_TURN,
        ),
        (
            &[
                "rpm", "1/min", "min-1", "min^-1", "u/min", "r/min", "rev/min",
            ],
            Rotation,
            2.0 * PI / SIXTY,
        ),
        (&["rps", "rev/s"], Rotation, 2.0 * PI),
        (&["rad/s2", "rad/s^2"], AngularAcceleration, 1.0),
        (
            &["deg/s2", "deg/s^2", "°/s2", "°/s^2"],
            AngularAcceleration,
            PI / HALF_TURN,
        ),
        (&["N", "newton", "newtons"], Force, 1.0),
        (&["mN"], Force, MILLI),
        (&["uN"], Force, MICRO),
        (&["nN"], Force, 1e-9),
        (&["kN"], Force, 1e3),
        (&["MN"], Force, 1e6),
        (&["kgf", "kp", "kg"], Force, GRAVITY),
        (&["gf", "g", "gram", "grams"], Force, MILLI * GRAVITY),
        (&["lbf", "lb", "lbs"], Force, POUND * GRAVITY),
        (&["Nm", "N*m", "Newtonmeter"], Torque, 1.0),
        (&["Nmm", "N*mm", "mNm", "mN*m"], Torque, MILLI),
        (&["Ncm", "N*cm"], Torque, 1e-2),
        (&["uNm"], Torque, MICRO),
        (&["kNm"], Torque, 1e3),
        (&["Pa"], Pressure, 1.0),
        (&["kPa"], Pressure, 1e3),
        (&["MPa", "N/mm2", "N/mm^2"], Pressure, 1e6),
        (&["GPa"], Pressure, 1e9),
        (&["bar"], Pressure, 1e5),
        (&["1", "-", "--", "–", "none", "dimensionless"], Ratio, 1.0),
        (&["%", "percent", "prozent"], Ratio, 1e-2),
        (&["A", "mA", "V", "mV", "volt", "ampere"], Electric, 1.0),
        (
            &["°C", "degC", "K", "Hz", "kHz", "W", "J", "dB", "%RH"],
            Other,
            1.0,
        ),
    ]
};

/// The spelling of the table: no blanks, dots or stars of products, one letter for micro, small superscripts as digits.
fn plain(text: &str) -> String {
    let letters = text.chars().filter(|letter| {
        !letter.is_whitespace() && !matches!(letter, '·' | '⋅' | '*' | '\'' | '"')
    });
    let text: String = letters.collect();
    let text = text.replace(['µ', 'μ'], "u").replace("º", "°");
    text.replace('⁻', "-").replace('²', "2").replace('¹', "1")
}

/// A unit of one of these dimensions: what it measures and its size in SI. Of units that are spelled alike, such as g,
/// the first dimension counts.
pub(super) fn unit(text: &str, dimensions: &[Dimension]) -> Option<(Dimension, f64)> {
    dimensions
        .iter()
        .find_map(|wanted| all_named(text).find(|(dimension, _)| dimension == wanted))
}

/// Whether a text is a unit of any dimension: the first that the table has.
pub(super) fn any_unit(text: &str) -> Option<(Dimension, f64)> {
    all_named(text).next()
}

/// All units of this name: with its capitals, or without them if the table has none with them.
fn all_named(text: &str) -> impl Iterator<Item = (Dimension, f64)> {
    let exact = plain(text);
    let is_known = |name: &str| UNITS.iter().any(|(names, ..)| names.contains(&name));
    // `Nm` and `nm`, `mN` and `MN` differ; `MM/S` and `RPM` mean what they mean in small letters.
    let name = match is_known(&exact) {
        true => exact,
        false => {
            let small = exact.to_lowercase();
            if is_known(&small) { small } else { exact }
        }
    };
    UNITS
        .iter()
        .filter(move |(names, ..)| names.contains(&name.as_str()))
        .map(|(_, dimension, size)| (*dimension, *size))
}

/// The first spelling of every unit of these dimensions.
pub(super) fn known(dimensions: &[Dimension]) -> String {
    let names = dimensions.iter().flat_map(|wanted| {
        let units = UNITS
            .iter()
            .filter(move |(_, dimension, _)| dimension == wanted);
        units.filter_map(|(names, ..)| names.first().copied())
    });
    names.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_their_sizes_and_capitals_count_where_they_differ() {
        use Dimension::*;
        for (text, dimension, size) in [
            ("mm/s", Speed, 1e-3),
            ("µm/s", Speed, 1e-6),
            ("μm / s", Speed, 1e-6),
            ("MM/S", Speed, 1e-3),
            ("m/min", Speed, 0.016_666_666_666_666_666),
            ("rpm", Rotation, 0.104_719_755_119_659_77),
            ("1/min", Rotation, 0.104_719_755_119_659_77),
            ("°/s", Rotation, 0.017_453_292_519_943_295),
            ("mN", Force, 1e-3),
            ("MN", Force, 1e6),
            ("lbf", Force, 4.448_221_615_260_5),
            ("N·m", Torque, 1.0),
            ("N mm", Torque, 1e-3),
            ("nm", Length, 1e-9),
            ("Nm", Torque, 1.0),
            ("m/s²", Acceleration, 1.0),
            ("ms", Time, 1e-3),
            ("h", Time, 3600.0),
            ("ft", Length, 0.3048),
        ] {
            let found = any_unit(text).unwrap_or((Ratio, f64::NAN));
            assert_eq!(found.0, dimension, "{text}");
            assert!((found.1 / size - 1.0).abs() < 1e-14, "{text}: {}", found.1);
        }
        assert_eq!(any_unit("furlong"), None);
        // A gram weighs as a force; as an acceleration it is that of gravity.
        assert_eq!(unit("g", &[Force]), Some((Force, 9.806_65e-3)));
        assert_eq!(
            unit("g", &[Speed, Acceleration]),
            Some((Acceleration, 9.806_65))
        );
        assert_eq!(unit("N", &[Speed]), None);
        assert!(known(&[Speed]).starts_with("m/s, cm/s, mm/s"));
    }
}
