//! Numbers as text that loses nothing.

use serde_json::Value;

/// `value` with 17 significant digits, which identify every f64; `inf`, `-inf` or `nan` otherwise.
///
/// ```
/// use tribos::record::number;
/// // The f64 next to 0.1 lies a little above it.
/// assert_eq!(number(0.1), "1.0000000000000001e-1");
/// assert_eq!(number(0.1).parse(), Ok(0.1));
/// assert_eq!(number(f64::NEG_INFINITY), "-inf");
/// ```
pub fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:.16e}")
    } else if value.is_nan() {
        "nan".into()
    } else if value > 0.0 {
        "inf".into()
    } else {
        "-inf".into()
    }
}

/// `value` as JSON with 17 significant digits; infinities and NaN, which JSON lacks, as strings.
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
        for value in [0.1, -1.0 / 3.0, 5e-324, f64::MAX, 0.0, 1e22] {
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
}
