//! Angles on the command line.

use crate::command::number;

/// Radians, or degrees with the suffix `deg`.
pub fn parse(text: &str) -> Result<f64, String> {
    let text = text.trim();
    match text.strip_suffix("deg") {
        Some(degrees) => number::finite(degrees).map(f64::to_radians),
        None => number::finite(text.strip_suffix("rad").unwrap_or(text)),
    }
    .map_err(|_| "give radians such as 1.57 or degrees such as 90deg".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_and_radians_are_told_apart() {
        assert_eq!(parse("180deg"), Ok(std::f64::consts::PI));
        assert_eq!(parse("-1.5"), Ok(-1.5));
        assert_eq!(parse(" 2 rad"), Ok(2.0));
        for bad in ["", "deg", "90grad", "nan", "infdeg"] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}
