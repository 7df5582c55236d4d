//! Numbers for people: as many significant digits as asked for, without idle zeros.
//!
//! Files have `tribos::record::number` instead, which keeps the bits.

use std::str::FromStr;
use std::sync::OnceLock;
use tribos::record::{number, significant};

/// Significant digits unless `--digits` says otherwise.
const USUAL: usize = 6;
/// With so many significant digits every f64 reads back to the same bits.
const MOST: usize = 17;

/// What `--digits` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// So many significant digits.
    Significant(usize),
    /// The shortest text that reads back to the same bits.
    Full,
}

impl FromStr for Digits {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().parse() {
            Ok(digits @ 1..=MOST) => Ok(Self::Significant(digits)),
            _ if text.trim() == "full" => Ok(Self::Full),
            _ => Err(format!(
                "give a number of digits from 1 to {MOST}, or full for all that keep the bits"
            )),
        }
    }
}

/// What this process was asked for.
static CHOSEN: OnceLock<Digits> = OnceLock::new();

impl Digits {
    /// Takes these digits for all that follows; the first call decides.
    pub fn choose(self) {
        let _ = CHOSEN.set(self);
    }

    /// `value` as text.
    pub fn show(self, value: f64) -> String {
        match self {
            Self::Significant(digits) if value.is_finite() => significant(value, digits),
            _ => {
                let text = number(value);
                text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
            }
        }
    }
}

/// `value` with the digits that were asked for.
pub fn shown(value: f64) -> String {
    CHOSEN
        .get()
        .copied()
        .unwrap_or(Digits::Significant(USUAL))
        .show(value)
}

/// A value with its standard error, of two digits; the value alone where the error is not known.
pub fn with_error(value: f64, error: f64) -> String {
    match error.is_finite() {
        true => format!("{} ± {}", shown(value), significant(error, 2)),
        false => shown(value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_without_idle_zeros() {
        for (value, text) in [
            (0.3, "0.3"),
            (0.0, "0"),
            (-0.0, "0"),
            (2.0, "2"),
            (0.369_017_132_104, "0.369017"),
            (-1.0 / 3.0, "-0.333333"),
            (123_456.7, "123457"),
            (1_234_567.0, "1.23457e6"),
            (100_000.0, "100000"),
            (1e-4, "0.0001"),
            (1.234_567e-5, "1.23457e-5"),
            (0.999_999_7, "1"),
            (999_999.7, "1e6"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "nan"),
        ] {
            assert_eq!(Digits::Significant(USUAL).show(value), text);
        }
    }

    #[test]
    fn all_digits_keep_the_bits() {
        for value in [0.3, 0.1 + 0.2, -1e-300, 5e-324, f64::MAX, 1.0 / 3.0, 4096.0] {
            for digits in [Digits::Full, Digits::Significant(MOST)] {
                let text = digits.show(value);
                assert_eq!(
                    text.parse().map(f64::to_bits),
                    Ok(value.to_bits()),
                    "{text}"
                );
            }
        }
        assert_eq!(Digits::Full.show(0.3), "0.3");
        assert_eq!(Digits::Significant(1).show(0.96), "1");
        assert_eq!(Digits::Significant(2).show(1234.0), "1200");
    }

    #[test]
    fn other_numbers_of_digits_are_refused() {
        for text in ["0", "18", "-1", "six", ""] {
            assert!(text.parse::<Digits>().is_err(), "{text}");
        }
        assert_eq!("full".parse(), Ok(Digits::Full));
        assert_eq!("17".parse(), Ok(Digits::Significant(17)));
    }
}
