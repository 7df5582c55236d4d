//! Deterministic arguments: enumerated, pseudo-random, and dense at the borders between formulas.

/// A 64-bit linear congruential generator (Knuth's MMIX constants), the same on every platform.
#[derive(Clone, Debug)]
pub struct Lcg(u64);

const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
const INCREMENT: u64 = 1_442_695_040_888_963_407;
/// 2⁻³²
const UNIT: f64 = 1.0 / 4_294_967_296.0;

impl Lcg {
    /// A generator for one random stream.
    pub fn new(seed: u64) -> Self {
        let mut out = Self(seed);
        out.bits();
        out
    }

    /// 64 bits, from the upper halves of two states.
    pub fn bits(&mut self) -> u64 {
        let mut step = || {
            self.0 = self.0.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
            self.0 >> 32
        };
        step() << 32 | step()
    }

    /// Uniform in [0, 1), a multiple of 2⁻³².
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 32) as f64 * UNIT
    }

    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Log-uniform in [low, high).
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

/// Velocity ratios ε: `count` log-uniform over 10^±6, `count` uniform in [0, 2), and steps of one
/// unit in the last place and of powers of two away from 1, where the two regimes meet.
pub fn ratios(count: usize) -> Vec<f64> {
    let mut rng = Lcg::new(1);
    let mut out: Vec<f64> = (0..count).map(|_| rng.log_between(1e-6, 1e6)).collect();
    out.extend((0..count).map(|_| rng.between(0.0, 2.0)));
    let (mut below, mut above) = (1.0_f64, 1.0_f64);
    for _ in 0..64 {
        below = below.next_down();
        above = above.next_up();
        out.extend([below, above]);
    }
    out.push(1.0);
    for halvings in 1..=52 {
        let gap = 0.5_f64.powi(halvings);
        for factor in [1.0, 1.25, 1.5, 1.75] {
            out.extend([1.0 - gap * factor * 0.5, 1.0 + gap * factor]);
        }
    }
    out
}

/// Arguments at both borders of every table cell in z = 1 − ε², and their neighbours.
pub fn cell_borders() -> Vec<f64> {
    let mut out = Vec::new();
    for octave in 0..52 {
        for start in [1.0, 0.75] {
            let z = start * 0.5_f64.powi(octave);
            let ratio = (1.0 - z).sqrt();
            out.extend([ratio, ratio.next_up(), ratio.next_down()].map(f64::abs));
        }
    }
    let above: Vec<f64> = out
        .iter()
        .filter(|r| r.is_normal())
        .map(|r| 1.0 / r)
        .collect();
    out.extend(above);
    out
}

/// Pairs of speeds (v, w) that differ by a fraction 2⁻ᵏ, k = 1…52, either one larger, chosen so that the
/// quotient is not exact by chance.
pub fn nearly_equal() -> Vec<(f64, f64)> {
    let mut out = Vec::new();
    for base in [1.0, 1.1, 0.7, 0.531_415, 123.456] {
        for halvings in 1..=52 {
            let gap = 0.5_f64.powi(halvings);
            for other in [base * (1.0 + gap), base * (1.0 - gap)] {
                out.extend([(base, other), (other, base)]);
            }
        }
    }
    out
}

/// [`ratios`] rounded to `f32`, with the `f32` neighbours of 1.
pub fn ratios_f32(count: usize) -> Vec<f32> {
    let mut out: Vec<f32> = ratios(count).iter().map(|&r| r as f32).collect();
    let (mut below, mut above) = (1.0_f32, 1.0_f32);
    for _ in 0..64 {
        below = below.next_down();
        above = above.next_up();
        out.extend([below, above]);
    }
    out
}

/// Zero, one, the limits of the normal and subnormal range, infinity and NaN, with both signs.
pub fn special_f64() -> Vec<f64> {
    let positive = [
        0.0,
        5e-324,
        f64::MIN_POSITIVE.next_down(),
        f64::MIN_POSITIVE,
        1e-160,
        0.5,
        1.0_f64.next_down(),
        1.0,
        1.0_f64.next_up(),
        1e160,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    positive.into_iter().flat_map(|x| [x, -x]).collect()
}
