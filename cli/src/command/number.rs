//! Numbers on the command line, refused with a reason before any work.

use tribos::scene::number_hint;

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
