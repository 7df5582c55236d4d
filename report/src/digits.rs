//! Rounded numbers for people.

/// Digits of a number for people.
const DIGITS: i32 = 6;

/// Six significant digits at most, without closing zeros.
pub fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !x.is_finite() {
        return x.to_string();
    }
    let rounded = format!("{x:.*e}", DIGITS as usize - 1);
    let (mantissa, power) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let text = match power.parse::<i32>() {
        Ok(power) if (-3..DIGITS).contains(&power) => {
            trimmed(&format!("{x:.*}", (DIGITS - 1 - power) as usize)).to_owned()
        }
        _ => format!("{}e{power}", trimmed(mantissa)),
    };
    text.replace('-', "−").replace("e−", "e-")
}

fn trimmed(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

/// Two digits.
pub fn brief(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if (1e-3..1e3).contains(&x.abs()) {
        let decimals = (1.0 - x.abs().log10().floor()).max(0.0) as usize;
        format!("{x:.decimals$}")
    } else {
        format!("{x:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_has_six_digits_at_most() {
        let cases = [
            (0.653_001_789_205_6, "0.653002"),
            (0.4, "0.4"),
            (1.0, "1"),
            (-4.0 / 9.0, "−0.444444"),
            (123_456.7, "123457"),
            (1_234_567.0, "1.23457e6"),
            (4.127_458e-8, "4.12746e-8"),
            (-1e-9, "−1e-9"),
            (0.999_999_999_9, "1"),
            (0.0, "0"),
            (-0.0, "0"),
            (f64::NAN, "NaN"),
        ];
        for (x, text) in cases {
            assert_eq!(short(x), text, "{x:e}");
        }
    }

    #[test]
    fn small_and_large_numbers_are_brief() {
        let cases = [
            (0.0, "0"),
            (5e-4, "5.0e-4"),
            (0.02, "0.020"),
            (54.2, "54"),
            (1.5, "1.5"),
        ];
        for (x, text) in cases {
            assert_eq!(brief(x), text);
        }
    }
}
