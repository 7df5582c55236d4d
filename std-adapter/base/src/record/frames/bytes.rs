//! Numbers as bytes and back.

/// A single-precision number's upper half, rounded to nearest; NaN stays NaN. Relative error at
/// most 2⁻⁸.
pub(super) fn upper_half(value: f32) -> u16 {
    const LOWER: u32 = 16;
    if value.is_nan() {
        return (f32::NAN.to_bits() >> LOWER) as u16;
    }
    let bits = value.to_bits();
    // Ties to even.
    let half = 0x7fff + (bits >> LOWER & 1);
    (bits.saturating_add(half) >> LOWER) as u16
}

/// The number of an upper half.
pub(super) fn from_upper_half(bits: u16) -> f32 {
    f32::from_bits(u32::from(bits) << 16)
}

/// Takes numbers from the front of a file.
#[derive(Debug)]
pub(super) struct Source<'a>(pub &'a [u8]);

impl Source<'_> {
    /// The next bytes.
    pub fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    /// A list of `count` items, if there are enough bytes.
    pub fn list<T, const N: usize>(
        &mut self,
        count: usize,
        of: impl Fn([u8; N]) -> T,
    ) -> Option<Vec<T>> {
        let bytes = self.0.get(..count.checked_mul(N)?)?;
        self.0 = &self.0[bytes.len()..];
        Some(bytes.as_chunks::<N>().0.iter().map(|x| of(*x)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_upper_half_is_off_by_a_256th_at_most() {
        for exponent in -120..120 {
            for step in 0..1000 {
                let value = (1.0 + step as f32 / 1000.0) * libm::exp2f(exponent as f32);
                for value in [value, -value] {
                    let error = (from_upper_half(upper_half(value)) - value) / value;
                    assert!(error.abs() <= 1.0 / 256.0, "{value}");
                }
            }
        }
        for value in [0.0, 1.0, -2.0, f32::INFINITY] {
            assert_eq!(from_upper_half(upper_half(value)), value);
        }
        assert!(from_upper_half(upper_half(f32::NAN)).is_nan());
        assert!(from_upper_half(upper_half(f32::from_bits(0x7f80_0001))).is_nan());
    }
}
