//! Angles on the command line.

use crate::command::digits::shown;
use crate::command::number;
use std::f64::consts::TAU;

/// An angle as it was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// Its value, rad.
    pub radians: f64,
    /// Whether a unit was given.
    has_unit: bool,
}

/// Radians, or degrees with the suffix `deg`.
pub fn parse(text: &str) -> Result<Angle, String> {
    let text = text.trim();
    let radians = match text.strip_suffix("deg") {
        Some(degrees) => number::finite(degrees).map(f64::to_radians),
        None => number::finite(text.strip_suffix("rad").unwrap_or(text)),
    };
    let refusal = |_| format!("got `{text}`; give radians such as 1.57 or degrees such as 90deg");
    Ok(Angle {
        radians: radians.map_err(refusal)?,
        has_unit: text.ends_with("deg") || text.ends_with("rad"),
    })
}

impl Angle {
    /// A hint if more than a turn was given without a unit: it may have been meant in degrees.
    pub fn hint(self) -> Option<String> {
        let radians = self.radians;
        (!self.has_unit && radians.abs() > TAU).then(|| {
            format!(
                "--angle {radians} is read in radians, {:.4} turns; write {radians}deg for degrees, \
                 {radians}rad to say so",
                radians / TAU
            )
        })
    }

    /// In both units, for people.
    pub fn text(self) -> String {
        format!(
            "{} rad ({} deg)",
            shown(self.radians),
            shown(self.radians.to_degrees())
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_and_radians_are_told_apart() {
        let radians = |text| parse(text).map(|angle| angle.radians);
        assert_eq!(radians("180deg"), Ok(std::f64::consts::PI));
        assert_eq!(radians("-1.5"), Ok(-1.5));
        assert_eq!(radians(" 2 rad"), Ok(2.0));
        let hints = |text| parse(text).is_ok_and(|angle| angle.hint().is_some());
        assert!(hints("90") && hints("-6.3"));
        assert!(!hints("90deg") && !hints("90rad") && !hints("6.2"));
        for bad in ["", "deg", "90grad", "nan", "infdeg"] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}
