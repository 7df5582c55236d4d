//! JSON files that contain a digest of their own bytes, so that damage is detected before use.

use serde_json::{Map, Value};
use twox_hash::XxHash3_128;

/// Hexadecimal digits of a digest.
const DIGITS: usize = 32;
/// The last key of a sealed file, before its digits.
const KEY: &str = "\"digest\":\"";
/// What follows the digits.
const END: &str = "\"}\n";

/// Digest of some bytes: XXH3 of 128 bits (Collet, xxHash specification).
///
/// It detects accidents, not forgery: two different files have the same digest with a probability of
/// 3e-39, and anybody can compute it.
///
/// ```
/// use tribos::record::digest;
/// assert_eq!(digest(b""), 0x99aa_06d3_0147_98d8_6001_c324_468d_497f); // the author's test vector
/// assert_ne!(digest(b"time,speed"), digest(b"time,spee\x65")); // one bit
/// ```
pub fn digest(bytes: &[u8]) -> u128 {
    XxHash3_128::oneshot(bytes)
}

/// An object as one line of JSON whose last key, `digest`, is the [`digest`] of all bytes before it.
///
/// ```
/// use serde_json::{Map, Value};
/// use tribos::record::{with_digest, verified};
/// let kept = Map::from_iter([("steps".to_owned(), Value::from(7))]);
/// let text = with_digest(kept);
/// assert_eq!(verified(&text).ok_or("damaged")?["steps"], 7);
/// assert_eq!(verified(&text.replace('7', "8")), None);
/// # Ok::<(), &str>(())
/// ```
pub fn with_digest(object: Map<String, Value>) -> String {
    let is_empty = object.is_empty();
    let mut text = Value::Object(object).to_string();
    // Another key goes before the closing brace.
    text.pop();
    if !is_empty {
        text.push(',');
    }
    let digits = format!("{:032x}", digest(text.as_bytes()));
    text + KEY + &digits + END
}

/// The object of a [`with_digest`] text; `None` if any byte differs from what was written.
pub fn verified(text: &str) -> Option<Value> {
    let (head, kept) = parts(text)?;
    let is_whole = kept == format!("{:032x}", digest(head.as_bytes()));
    is_whole.then(|| serde_json::from_str(text).ok())?
}

/// A [`with_digest`] text with one more number in its object; any other text as it is.
pub(crate) fn with_number(text: String, key: &str, number: u64) -> String {
    let Some((head, _)) = parts(&text) else {
        return text;
    };
    let text = format!("{head}\"{key}\":{number},");
    let digits = format!("{:032x}", digest(text.as_bytes()));
    text + KEY + &digits + END
}

/// What the digest of a sealed text is of, and its digits.
fn parts(text: &str) -> Option<(&str, &str)> {
    let length = KEY.len() + DIGITS + END.len();
    let (head, tail) = text.split_at_checked(text.len().checked_sub(length)?)?;
    Some((head, tail.strip_prefix(KEY)?.strip_suffix(END)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_changed_bit_cut_or_doubled_byte_is_read() {
        let object = Map::from_iter([
            ("name".to_owned(), Value::from("tip")),
            ("numbers".to_owned(), Value::from(vec![1, 2, 3])),
        ]);
        let text = with_digest(object);
        assert!(verified(&text).is_some_and(|value| value["numbers"][2] == 3));
        let bytes = text.as_bytes();
        let read = |bytes: &[u8]| std::str::from_utf8(bytes).ok().and_then(verified);
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut other = bytes.to_vec();
                other[at] ^= 1 << bit;
                assert_eq!(read(&other), None, "bit {bit} of byte {at}");
            }
            assert_eq!(read(&bytes[..at]), None, "cut at {at}");
            let mut other = bytes.to_vec();
            other.insert(at, bytes[at]);
            assert_eq!(read(&other), None, "byte {at} twice");
        }
        // One number more is sealed with the rest.
        let more = with_number(text, "frames", 20);
        assert!(
            verified(&more).is_some_and(|value| value["frames"] == 20 && value["name"] == "tip")
        );
        assert_eq!(with_number("no seal".into(), "frames", 20), "no seal");
        assert_eq!(
            verified(&with_digest(Map::new())).map(|value| value["digest"].is_string()),
            Some(true)
        );
    }
}
