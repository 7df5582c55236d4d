//! The digest of a golden file: FNV-1a of 64 bits.
//!
//! It is implemented here because the bytes and their order are part of the file format, and the
//! crates for this hash take integers in the byte order of the machine.

/// 64-bit Fowler–Noll–Vo hash, version 1a, over numbers and texts.
///
/// ```
/// use tribos::golden::{Digest, canonical_bits};
/// let (offset, prime) = (0xcbf2_9ce4_8422_2325_u64, 0x0100_0000_01b3_u64); // FNV-1a
/// assert_eq!(Digest::EMPTY.value(), offset);
/// let mut digest = Digest::EMPTY;
/// digest.number(0.0); // eight bytes of zero: a multiplication each
/// assert_eq!(digest.value(), offset.wrapping_mul(prime.wrapping_pow(8)));
/// assert_eq!(Digest::of([0.0]), digest.value());
/// assert_ne!(Digest::of([-0.0]), digest.value()); // every bit counts
/// assert_eq!(canonical_bits(-f64::NAN), canonical_bits(f64::NAN)); // but those of NaN
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;
/// All NaN are replaced by this one: their payload and sign are not promised.
const CANONICAL_NAN: u64 = 0x7ff8_0000_0000_0000;

/// The bits of a number; one NaN for all.
pub fn canonical_bits(value: f64) -> u64 {
    if value.is_nan() {
        CANONICAL_NAN
    } else {
        value.to_bits()
    }
}

impl Digest {
    /// Digest of nothing.
    pub const EMPTY: Self = Self(OFFSET);

    /// Digest of all numbers, in their order.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> u64 {
        let mut digest = Self::EMPTY;
        for number in numbers {
            digest.number(number);
        }
        digest.value()
    }

    /// Adds a number: eight bytes, the lowest first. −0 and 0 differ, as their bits do.
    pub fn number(&mut self, value: f64) {
        self.bytes(&canonical_bits(value).to_le_bytes());
    }

    /// Adds a text: its length and its UTF-8.
    pub fn text(&mut self, text: &str) {
        self.bytes(&(text.len() as u64).to_le_bytes());
        self.bytes(text.as_bytes());
    }

    /// The digest of what was added.
    pub fn value(self) -> u64 {
        self.0
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(PRIME);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_words_have_the_digests_of_the_hash_s_authors() {
        // Noll's test vectors for FNV-1a 64.
        for (text, digest) in [
            ("", 0xcbf2_9ce4_8422_2325),
            ("a", 0xaf63_dc4c_8601_ec8c),
            ("foobar", 0x8594_4171_f739_67e8),
        ] {
            let mut hash = Digest::EMPTY;
            hash.bytes(text.as_bytes());
            assert_eq!(hash.value(), digest, "{text}");
        }
    }

    #[test]
    fn every_bit_counts_but_those_of_nan() {
        assert_ne!(Digest::of([0.0]), Digest::of([-0.0]));
        assert_ne!(Digest::of([1.0, 2.0]), Digest::of([2.0, 1.0]));
        assert_ne!(Digest::of([1.0]), Digest::of([1.0_f64.next_up()]));
        assert_eq!(Digest::of([f64::NAN]), Digest::of([-f64::NAN]));
    }
}
