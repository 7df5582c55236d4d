//! A named result or parameter: a number by its bits, or a text.

use super::digest::{Digest, canonical_bits};
use serde_json::Value;
use std::fmt;

/// One value of a summary or of a scene.
///
/// ```
/// use tribos::golden::Quantity;
/// assert_eq!(Quantity::Number(1.0).to_string(), "0x3ff0000000000000 (1.0)"); // IEEE 754
/// assert_ne!(Quantity::Number(0.0), Quantity::Number(-0.0)); // other bits
/// assert_eq!(Quantity::Number(f64::NAN), Quantity::Number(-f64::NAN)); // one NaN for all
/// assert_ne!(Quantity::Text("1.0".into()), Quantity::Number(1.0));
/// ```
#[derive(Clone, Debug)]
pub enum Quantity {
    /// A number, compared by its bits.
    Number(f64),
    /// A word, or a value that is not a finite number: `inf`, `null`, `true`.
    Text(String),
}

impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => canonical_bits(*a) == canonical_bits(*b),
            (Self::Text(a), Self::Text(b)) => a == b,
            _ => false,
        }
    }
}

impl Quantity {
    /// Spelling in a golden file: `0x` and the 16 hexadecimal digits of the bits, or the text.
    pub(super) fn spelled(&self) -> String {
        match self {
            Self::Number(value) => hex(canonical_bits(*value)),
            Self::Text(text) => text.clone(),
        }
    }

    /// The quantity of that spelling.
    pub(super) fn read(text: &str) -> Self {
        match read_hex(text) {
            Some(bits) => Self::Number(f64::from_bits(bits)),
            None => Self::Text(text.to_owned()),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write!(f, "{} ({value:?})", self.spelled()),
            Self::Text(text) => write!(f, "\"{text}\""),
        }
    }
}

/// `0x` and 16 digits.
pub(super) fn hex(bits: u64) -> String {
    format!("{bits:#018x}")
}

/// The bits of `0x` and 16 lower-case digits; none for any other text.
pub(super) fn read_hex(text: &str) -> Option<u64> {
    let bits = u64::from_str_radix(text.strip_prefix("0x")?, 16).ok()?;
    (hex(bits) == text).then_some(bits)
}

/// The leaves of a JSON value by their paths, such as `stress.total.0.2`, in its order. Branches
/// at the top for which `skip` holds are left out.
pub(super) fn leaves(value: &Value, skip: impl Fn(&str) -> bool) -> Vec<(String, Quantity)> {
    let mut found = Vec::new();
    let branches = value.as_object().into_iter().flatten();
    for (name, branch) in branches.filter(|(name, _)| !skip(name)) {
        collect(name.clone(), branch, &mut found);
    }
    found
}

fn collect(path: String, value: &Value, found: &mut Vec<(String, Quantity)>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                collect(format!("{path}.{name}"), value, found);
            }
        }
        Value::Array(items) => {
            for (index, value) in items.iter().enumerate() {
                collect(format!("{path}.{index}"), value, found);
            }
        }
        Value::Number(number) => {
            // The shortest form reads back to the same bits.
            let quantity = match number.to_string().parse() {
                Ok(value) => Quantity::Number(value),
                Err(_) => Quantity::Text(number.to_string()),
            };
            found.push((path, quantity));
        }
        Value::String(text) => found.push((path, Quantity::Text(text.clone()))),
        Value::Bool(_) | Value::Null => found.push((path, Quantity::Text(value.to_string()))),
    }
}

/// Digest of names and values.
pub(super) fn digest<'a>(all: impl IntoIterator<Item = (&'a String, &'a Quantity)>) -> u64 {
    let mut digest = Digest::EMPTY;
    for (name, quantity) in all {
        digest.text(name);
        digest.text(&quantity.spelled());
    }
    digest.value()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_is_read_back_as_it_was_spelled() {
        for value in [0.1, -0.0, f64::MAX, 5e-324, f64::INFINITY, f64::NAN] {
            let quantity = Quantity::Number(value);
            assert_eq!(Quantity::read(&quantity.spelled()), quantity);
        }
        for text in [
            "rest",
            "",
            "0x12",
            "0x+00000000000000f",
            "0xABCDEF0123456789",
        ] {
            let quantity = Quantity::Text(text.into());
            assert_eq!(Quantity::read(&quantity.spelled()), quantity);
        }
    }

    #[test]
    fn leaves_are_found_with_their_paths() {
        let value = serde_json::json!({"a": {"b": [1.5, null]}, "c": "x", "left": 3});
        let leaves = leaves(&value, |name| name == "left");
        let names: Vec<&str> = leaves.iter().map(|leaf| leaf.0.as_str()).collect();
        assert_eq!(names, ["a.b.0", "a.b.1", "c"]);
        assert_eq!(leaves[0].1, Quantity::Number(1.5));
    }
}
