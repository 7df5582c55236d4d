//! Random numbers that are bit-identical on every platform and in every version.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng as _;

/// 2⁻⁵³, the distance of the numbers in [0, 1).
const UNIT: f64 = 1.0 / 9_007_199_254_740_992.0;

/// Seeded numbers: PCG XSL RR 128/64 (O'Neill 2014), its 128-bit state from the seed by two numbers
/// of SplitMix64 (Steele, Lea & Flood 2014), so that neighbouring seeds have nothing in common.
///
/// A library generates only the 64 bits; everything else is computed here, so that no version of
/// it changes a result. Different purposes use different streams of one seed.
///
/// ```
/// use tribos::random::Random;
/// let mut numbers = Random::new(7, 0);
/// assert_ne!(numbers.clone().bits(), Random::new(7, 1).bits()); // another stream
/// let first = numbers.clone().bits() >> 11;
/// assert_eq!(numbers.unit(), first as f64 / 2.0_f64.powi(53));
/// // The mean of n uniform numbers is 1/2, with a standard error of 1/√(12 n).
/// let n = 10_000;
/// let mean = (0..n).map(|_| numbers.unit()).sum::<f64>() / f64::from(n);
/// assert!((mean - 0.5).abs() < 5.0 / (12.0 * f64::from(n)).sqrt());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Random(Pcg64);

impl Random {
    /// Generator for any seed and stream.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut state = seed;
        let [high, low] = [(); 2].map(|()| u128::from(split_mix(&mut state)));
        Self(Pcg64::new(high << 64 | low, stream.into()))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Leaves out some numbers of 64 bits.
    #[doc(hidden)]
    pub fn skip(&mut self, count: u64) {
        self.0.advance(count.into());
    }

    /// Uniform in [0, 1), a multiple of 2⁻⁵³: the upper 53 of the next 64 bits.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * UNIT
    }
}

/// One number of SplitMix64, with the constants of its authors.
fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
