//! Numbers on the command line, refused with a reason before any work.

use crate::failure::Failure;
use std::num::NonZeroU32;
use tribos::scene::number_hint;
use tribos_core::Real;

/// A finite number.
pub fn finite(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(x) => Err(format!("give a finite number, not {x}")),
        Err(_) => Err(match number_hint(text) {
            Some(hint) => format!("got {}; {hint}", text.trim()),
            None => "give a number such as 0.5 or 1e-3".into(),
        }),
    }
}

/// A finite number ≥ 0.
pub fn not_negative(text: &str) -> Result<f64, String> {
    finite(text).and_then(|x| {
        if x >= 0.0 {
            Ok(x)
        } else {
            Err("give a number >= 0".into())
        }
    })
}

/// A finite number > 0.
pub fn positive(text: &str) -> Result<f64, String> {
    finite(text).and_then(|x| {
        if x > 0.0 {
            Ok(x)
        } else {
            Err("give a number > 0".into())
        }
    })
}

/// A number ≥ 0, infinity included.
pub fn ratio(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(x) if x >= 0.0 => Ok(x),
        _ => Err("give a ratio >= 0, or inf for pure sliding".into()),
    }
}

/// A lean from 0 to 1.
pub fn lean(text: &str) -> Result<f64, String> {
    finite(text).and_then(|x| {
        if (0.0..=1.0).contains(&x) {
            Ok(x)
        } else {
            Err("give a lean from 0 to 1; beyond, a body may tip".into())
        }
    })
}

/// An exponent that some tier can serve.
pub fn exponent(text: &str) -> Result<f64, String> {
    let most = tribos_core::law::PowerLaw::<f64>::MAX_EXPONENT;
    finite(text).and_then(|x| {
        if x > -1.0 && x <= most {
            Ok(x)
        } else {
            Err(format!("give an exponent with -1 < alpha <= {most}"))
        }
    })
}

/// A whole number from 1 to the largest u32.
pub fn count(text: &str) -> Result<NonZeroU32, String> {
    let count = text.trim().parse();
    count.map_err(|_| format!("give a whole number from 1 to {}", u32::MAX))
}

/// `x` in the precision asked for; refused if it overflows there, or underflows.
pub fn in_range<R: Real>(name: &str, x: f64) -> Result<R, Failure> {
    let narrow = R::from_f64(x);
    let fault = if !narrow.is_finite() {
        "large"
    } else if narrow.abs() < R::MIN_POSITIVE && narrow.to_f64() != x {
        "small"
    } else {
        return Ok(narrow);
    };
    Err(Failure::input(format!(
        "{name} {x:e} is too {fault} for f32; use --precision f64"
    )))
}
