//! Source of the inputs: one seed gives the same input on every platform.

use tribos_core::real::Real;

/// Range from which the numbers of an input are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// Every bit pattern: NaN, infinities, subnormals, the limits of the range.
    Any,
    /// Zero and magnitudes from 2⁻¹² to 2¹², for which every result must be finite.
    Mild,
}

/// Random numbers of one input.
#[derive(Clone, Debug)]
pub struct Source {
    state: u64,
    regime: Regime,
    last: f64,
}

/// Steele, Lea and Flood's SplitMix64 (OOPSLA 2014).
const STRIDE: u64 = 0x9e37_79b9_7f4a_7c15;
const MIX: [u64; 2] = [0xbf58_476d_1ce4_e5b9, 0x94d0_49bb_1331_11eb];
/// Largest power of two of a mild number, up or down.
const MILD: i32 = 12;

/// The seed of input `index` of a run with `seed`.
pub fn seed_of(seed: u64, index: u64) -> u64 {
    mixed(seed ^ mixed(index.wrapping_add(STRIDE)))
}

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(MIX[0]);
    z = (z ^ (z >> 27)).wrapping_mul(MIX[1]);
    z ^ (z >> 31)
}

impl Source {
    /// The random numbers of one seed; half of the seeds are mild.
    pub fn new(seed: u64) -> Self {
        let mut source = Self {
            state: seed,
            regime: Regime::Any,
            last: 1.0,
        };
        if source.one_in(2) {
            source.regime = Regime::Mild;
        }
        source
    }

    /// The regime of this input.
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// True if every result must be finite.
    pub fn is_mild(&self) -> bool {
        self.regime == Regime::Mild
    }

    /// A 64-bit number.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STRIDE);
        mixed(self.state)
    }

    /// A number below `count` > 0.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }

    /// True with probability 1/`count`.
    pub fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    /// A random element.
    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A number from 0 to 1.
    pub fn unit<R: Real>(&mut self) -> R {
        R::from_f64((self.bits() >> 40) as f64 / 16_777_216.0)
    }

    /// A number of the regime, of either sign: often equal to the last one, adjacent to it, or in a tiny
    /// ratio to it.
    pub fn number<R: Real>(&mut self) -> R {
        let value = match (self.below(12), self.regime) {
            (0, _) => self.last,
            (1, _) => -self.last,
            (2, _) => self.last * (1.0 + R::EPSILON.to_f64() * (self.below(9) as f64 - 4.0)),
            (3, Regime::Any) => self.last * two_to(-(self.below(160) as i32)),
            (4, _) => 0.0,
            (5 | 6, Regime::Any) => self.end::<R>().to_f64(),
            (_, Regime::Any) => self.pattern::<R>(),
            (_, Regime::Mild) => self.mild(),
        };
        self.last = value;
        R::from_f64(value)
    }

    /// A number of the regime that is usually ≥ 0, and always if mild.
    pub fn size<R: Real>(&mut self) -> R {
        let number = self.number::<R>();
        if self.is_mild() || !self.one_in(8) {
            number.abs()
        } else {
            number
        }
    }

    /// A number that is usually > 0, and always if mild.
    pub fn positive<R: Real>(&mut self) -> R {
        let size = self.size::<R>();
        if self.is_mild() && size == R::ZERO {
            R::ONE
        } else {
            size
        }
    }

    /// An ordinary number > 0 in every regime, for inputs that must not be refused.
    pub fn ordinary<R: Real>(&mut self) -> R {
        R::from_f64(self.mild().abs())
    }

    /// Three numbers.
    pub fn vector<R: Real>(&mut self) -> nalgebra::Vector3<R> {
        nalgebra::Vector3::from([(); 3].map(|()| self.number::<R>()))
    }

    fn mild(&mut self) -> f64 {
        let mantissa = 1.0 + (self.bits() >> 12) as f64 * two_to(-52);
        let power = self.below(2 * MILD as usize) as i32 - MILD;
        let sign = if self.one_in(2) { 1.0 } else { -1.0 };
        sign * mantissa * two_to(power)
    }

    /// An arbitrary bit pattern of the type.
    fn pattern<R: Real>(&mut self) -> f64 {
        let bits = self.bits();
        if size_of::<R>() == size_of::<f32>() {
            f64::from(f32::from_bits(bits as u32))
        } else {
            f64::from_bits(bits)
        }
    }

    /// The limits of the range and the neighbours of 1.
    fn end<R: Real>(&mut self) -> R {
        let least = R::MIN_POSITIVE;
        let most = (R::TWO - R::EPSILON) * (R::ONE / least * R::TWO);
        let ends = [
            -R::ZERO,
            least * R::EPSILON,
            least,
            least * (R::ONE - R::EPSILON),
            R::EPSILON,
            R::ONE - R::EPSILON * R::HALF,
            R::ONE,
            R::ONE + R::EPSILON,
            R::ONE / least,
            most,
            R::INFINITY,
            R::NAN,
        ];
        let end = self.one_of(&ends);
        if self.one_in(2) { end } else { -end }
    }
}

/// 2^`power` for powers of normal numbers.
fn two_to(power: i32) -> f64 {
    f64::from_bits(((1023 + i64::from(power)) as u64) << 52)
}
