//! Numbers on the command line, refused with a reason before any work.

use crate::failure::Failure;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::num::NonZeroU32;
use std::ops::RangeInclusive;
use std::time::Duration;
use tribos::friction::{Coefficients, ContactRadius, FrictionError};
use tribos_core::Real;

/// A finite number.
pub fn finite(text: &str) -> Result<f64, String> {
    tribos::friction::finite_number(text)
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

/// A coefficient of friction, or two.
pub fn coefficients(text: &str) -> Result<Coefficients, String> {
    text.parse()
        .map_err(|error: FrictionError| error.to_string())
}

/// The radius of a contact, or what makes it of the load.
pub fn radius(text: &str) -> Result<ContactRadius, String> {
    text.parse()
        .map_err(|error: FrictionError| error.to_string())
}

/// What a radius may be, for the longer help.
pub fn radius_help(first: &str) -> String {
    let all = ContactRadius::SYNTAX.map(|(syntax, meaning)| format!("{syntax}: {meaning}"));
    format!("{first}\n\n{}", all.join("; "))
}

/// A number of seconds ≥ 0.
pub fn pause(text: &str) -> Result<Duration, String> {
    not_negative(text).map(|x| Duration::try_from_secs_f64(x).unwrap_or(Duration::MAX))
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
    finite(text)
        .and_then(|x| tribos::friction::valid_exponent(x).map_err(|refusal| refusal.to_string()))
}

/// One of these words, each with its help, as the library reads it. Older names of a word follow it after bars.
pub fn named<T, const N: usize>(
    words: [(&'static str, &'static str); N],
) -> impl TypedValueParser<Value = T>
where
    T: std::str::FromStr<Err: std::error::Error + Send + Sync + 'static>
        + Clone
        + Send
        + Sync
        + 'static,
{
    let values = words.map(|(word, help)| {
        let (word, older) = word.split_once('|').unwrap_or((word, ""));
        let older = older.split('|').filter(|name| !name.is_empty());
        PossibleValue::new(word).aliases(older).help(help)
    });
    PossibleValuesParser::new(values).try_map(|word| word.parse::<T>())
}

/// A whole number from 1 to the largest u32.
pub fn count(text: &str) -> Result<NonZeroU32, String> {
    let count = text.trim().parse();
    count.map_err(|_| format!("give a whole number from 1 to {}", u32::MAX))
}

/// A whole number of a range.
pub fn whole(range: RangeInclusive<u32>) -> impl Fn(&str) -> Result<u32, String> + Clone {
    move |text| {
        let number = text.trim().parse().ok();
        number
            .filter(|number| range.contains(number))
            .ok_or(format!(
                "give a whole number from {} to {}",
                range.start(),
                range.end()
            ))
    }
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
