//! Arguments from integers and + − × / alone.

use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// A 64-bit linear congruential generator (Knuth's MMIX constants), the same everywhere.
#[derive(Clone, Debug)]
pub(crate) struct Lcg(u64);

const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
const INCREMENT: u64 = 1_442_695_040_888_963_407;

impl Lcg {
    /// A generator for one stream.
    pub fn new(seed: u64) -> Self {
        let mut out = Self(seed);
        out.bits();
        out
    }

    /// 64 bits, the better half of two states.
    pub fn bits(&mut self) -> u64 {
        let mut step = || {
            self.0 = self.0.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
            self.0 >> 32
        };
        step() << 32 | step()
    }
}

/// A speed m·2^k with 0 ≤ m < 1 and |k| ≤ 20, from integers and divisions.
pub(crate) fn speed<R: Real>(rng: &mut Lcg) -> R {
    let bits = rng.bits();
    let mantissa = (bits >> 40) as f64 / 16_777_216.0;
    let power = (1_u64 << (bits & 31)) as f64;
    R::from_f64(mantissa * power / 2048.0)
}

/// The difference of two speeds.
pub(crate) fn signed<R: Real>(rng: &mut Lcg) -> R {
    speed::<R>(rng) - speed::<R>(rng)
}

/// A number in [0, 1).
pub(crate) fn unit<R: Real>(rng: &mut Lcg) -> R {
    R::from_f64((rng.bits() >> 40) as f64 / 16_777_216.0)
}

/// A twist of three [`signed`] numbers.
pub(crate) fn twist<R: Real>(rng: &mut Lcg) -> Twist<R> {
    let [x, y, spin] = [(); 3].map(|()| signed::<R>(rng));
    Twist::new(x, y, spin)
}

/// `count` pairs of sliding and rim speed, three in eight of them equal or nearly so.
pub(crate) fn arguments<R: Real>(seed: u64, count: usize) -> impl Iterator<Item = (R, R)> {
    let mut rng = Lcg::new(seed);
    (0..count).map(move |n| {
        let slide: R = speed(&mut rng);
        let rim = match n % 8 {
            0 => slide,
            1 => slide * R::from_f64(1.0 + 1.0 / 4096.0),
            2 => slide * (R::ONE - R::EPSILON),
            _ => speed(&mut rng),
        };
        (slide, rim)
    })
}

/// Numbers of [`ends`].
pub(crate) const ENDS: usize = 16;

/// Both zeros, the ends of the subnormal and the normal range, 1 and its neighbours, infinities
/// and NaN.
pub(crate) fn ends<R: Real>() -> [R; ENDS] {
    let least = R::MIN_POSITIVE;
    let huge = R::ONE / least;
    let most = (R::TWO - R::EPSILON) * (huge * R::TWO);
    [
        R::ZERO,
        -R::ZERO,
        least * R::EPSILON,
        least * R::HALF - least * R::EPSILON,
        -least * (R::ONE - R::EPSILON),
        least,
        R::EPSILON,
        R::ONE - R::EPSILON * R::HALF,
        R::ONE,
        -R::ONE,
        R::ONE + R::EPSILON,
        huge,
        most,
        -most,
        R::INFINITY,
        R::NAN,
    ]
}

/// All pairs of [`ends`].
pub(crate) fn pairs_of_ends<R: Real>() -> impl Iterator<Item = (R, R)> {
    let all = ends::<R>();
    (0..ENDS * ENDS).map(move |n| (all[n / ENDS], all[n % ENDS]))
}

/// One in `every` of the triples of [`ends`].
pub(crate) fn triples_of_ends<R: Real>(every: usize) -> impl Iterator<Item = [R; 3]> {
    let all = ends::<R>();
    let triple = move |n| [n / (ENDS * ENDS), n / ENDS % ENDS, n % ENDS].map(|k| all[k]);
    (0..ENDS * ENDS * ENDS).step_by(every).map(triple)
}
