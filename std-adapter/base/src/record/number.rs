//! Numbers as text: without loss for files, rounded for people.

use serde_json::Value;

/// Significant digits of a number for people, unless they ask for others.
const USUAL: usize = 6;
/// Largest decimal exponent of small numbers that are written with a power of ten.
const SMALL: i32 = -5;

/// The shortest decimal text that reads back to the same f64; `inf`, `-inf` or `nan` otherwise.
///
/// Whole numbers keep `.0`, so that a column of floats stays a column of floats; a power of ten
/// is written below 1e-5 and from 1e16 on.
///
/// ```
/// use tribos::record::number;
/// assert_eq!([0.1, 2.0, 1.5e-7].map(number), ["0.1", "2.0", "1.5e-7"]);
/// // The last bit shows where it matters.
/// assert_eq!(number(0.1 + 0.2), "0.30000000000000004");
/// assert_eq!(number(f64::NEG_INFINITY), "-inf");
/// ```
pub fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else if value.is_nan() {
        "nan".into()
    } else if value > 0.0 {
        "inf".into()
    } else {
        "-inf".into()
    }
}

/// `value` rounded to `digits` significant ones, zeros at the end left out.
///
/// A power of ten is written below 1e-4, and from 1e6 or where the digits end on.
///
/// ```
/// use tribos::record::significant;
/// assert_eq!([1.0 / 3.0, 2.0, 1e7].map(|x| significant(x, 6)), ["0.333333", "2", "1e7"]);
/// ```
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return number(value);
    }
    if value == 0.0 {
        return "0".into();
    }
    let rounded = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let power: i32 = exponent.parse().unwrap_or(0);
    if power <= SMALL || power >= digits.max(USUAL) as i32 {
        return format!("{}e{power}", without_idle_zeros(mantissa));
    }
    let decimals = (digits as i32 - 1 - power).max(0) as usize;
    // From the rounded digits: a number is not rounded twice.
    let rounded = rounded.parse().unwrap_or(value);
    without_idle_zeros(&format!("{rounded:.decimals$}")).to_owned()
}

/// A number in a message, as [`significant`] rounds it for people.
#[doc(hidden)]
pub fn brief(value: &f64) -> String {
    significant(*value, USUAL)
}

fn without_idle_zeros(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

/// `value` as JSON in the form of [`number`], with a sign before every power of ten; infinities and NaN, which JSON lacks, as strings.
///
/// ```
/// use tribos::record::json_number;
/// assert_eq!(json_number(9.81).as_f64(), Some(9.81));
/// assert_eq!(json_number(f64::NAN), "nan");
/// ```
pub fn json_number(value: f64) -> Value {
    let text = number(value);
    match text.parse::<serde_json::Number>() {
        Ok(number) => Value::Number(number),
        Err(_) => Value::String(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_reads_back_to_the_same_bits() {
        let dense = (0..2000).map(|i| (1.0 + f64::EPSILON * f64::from(i)) * 3e-7);
        let edges = [0.1, -1.0 / 3.0, 5e-324, f64::MAX, 0.0, -0.0, 1e16, 1e22];
        for value in edges.into_iter().chain(dense) {
            assert_eq!(
                number(value).parse::<f64>().map(f64::to_bits),
                Ok(value.to_bits())
            );
            assert_eq!(
                json_number(value).to_string().parse::<f64>().ok(),
                Some(value)
            );
        }
        assert_eq!(json_number(f64::INFINITY), Value::String("inf".into()));
    }

    #[test]
    fn no_digit_is_written_that_the_bits_do_not_need() {
        for (value, text) in [
            (0.3, "0.3"),
            (9.81, "9.81"),
            (-2.0, "-2.0"),
            (0.0, "0.0"),
            (1e-5, "1e-5"),
            (6.25e20, "6.25e20"),
        ] {
            assert_eq!(number(value), text);
            // The JSON crate writes a sign before every power of ten.
            let signed = text.replace("e2", "e+2");
            assert_eq!(json_number(value).to_string(), signed);
        }
    }
}
