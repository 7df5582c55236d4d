//! The inputs for all timings and errors.

/// Knuth's MMIX generator (TAOCP vol. 2, 3.3.4): the same inputs on every run.
#[derive(Clone, Debug)]
pub struct Lcg(u64);

impl Lcg {
    /// Starts a sequence.
    pub fn new(seed: u64) -> Self {
        Self(seed ^ 0x9E37_79B9_7F4A_7C15)
    }

    /// A number in [0, 1), from the upper bits.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [`low`, `high`).
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number in [`low`, `high`) with an even spread of orders of magnitude.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.uniform(low.log10(), high.log10()))
    }

    /// Fisher–Yates.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, (self.unit() * (i + 1) as f64) as usize);
        }
    }
}

/// Numbers of ratios ε of the three kinds in the mix.
const ORDERS_OF_MAGNITUDE: usize = 1500;
const MODERATE: usize = 1500;
const NEARLY_EQUAL: usize = 800;

/// Velocity ratios: 1,500 log-uniform in 1e-6..1e6, 1,500 uniform in 0..2, 800 with |1 − ε|
/// log-uniform in 1e-15..1e-1 on both sides of 1; shuffled.
pub fn ratios(seed: u64) -> Vec<f64> {
    let mut random = Lcg::new(seed);
    let mut out = Vec::with_capacity(ORDERS_OF_MAGNITUDE + MODERATE + NEARLY_EQUAL);
    out.extend((0..ORDERS_OF_MAGNITUDE).map(|_| random.log_uniform(1e-6, 1e6)));
    out.extend((0..MODERATE).map(|_| random.uniform(0.0, 2.0)));
    out.extend((0..NEARLY_EQUAL).map(|_| {
        let gap = random.log_uniform(1e-15, 1e-1);
        if random.unit() < 0.5 {
            1.0 - gap
        } else {
            1.0 + gap
        }
    }));
    random.shuffle(&mut out);
    out
}

/// The mix as pairs `[slide, rim]`, with rim speeds log-uniform in 0.1..10.
pub fn pairs(seed: u64) -> Vec<[f64; 2]> {
    with_rim_speeds(seed, &ratios(seed))
}

/// Mixes that follow each other in [`long_pairs`].
const REPEATS: u64 = 8;

/// Eight mixes in a row, for timing: a branch predictor learns 3,800 pairs that come again and
/// again by heart and then hides what a branch costs.
pub fn long_pairs(seed: u64) -> Vec<[f64; 2]> {
    (0..REPEATS).flat_map(|i| pairs(seed + 2 * i)).collect()
}

/// Gives every ratio a rim speed.
fn with_rim_speeds(seed: u64, ratios: &[f64]) -> Vec<[f64; 2]> {
    let mut random = Lcg::new(seed + 1);
    let pair = |&ratio| {
        let rim = random.log_uniform(0.1, 10.0);
        [ratio * rim, rim]
    };
    ratios.iter().map(pair).collect()
}

/// The same pairs rounded to f32.
pub fn narrowed(pairs: &[[f64; 2]]) -> Vec<[f32; 2]> {
    pairs.iter().map(|&[v, w]| [v as f32, w as f32]).collect()
}

/// Parts of the mix whose cost may differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// ε < 0.1
    Spinning,
    /// 0.9 < ε < 1.1
    Equal,
    /// ε > 10
    Sliding,
}

impl Region {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Spinning, Self::Equal, Self::Sliding];

    /// Name of the region in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Spinning => "spinning (eps < 0.1)",
            Self::Equal => "equal (0.9 < eps < 1.1)",
            Self::Sliding => "sliding (eps > 10)",
        }
    }

    /// The pairs of the mix that lie in this region.
    pub fn pairs(self, seed: u64) -> Vec<[f64; 2]> {
        let inside = |&ratio: &f64| match self {
            Self::Spinning => ratio < 0.1,
            Self::Equal => ratio > 0.9 && ratio < 1.1,
            Self::Sliding => ratio > 10.0,
        };
        let ratios: Vec<f64> = ratios(seed).into_iter().filter(inside).collect();
        with_rim_speeds(seed, &ratios)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mix_has_its_three_parts_and_repeats() {
        let first = ratios(7);
        assert_eq!(first, ratios(7));
        assert_ne!(first, ratios(8));
        assert_eq!(first.len(), 3800);
        let near = first.iter().filter(|r| (**r - 1.0).abs() < 1e-4).count();
        assert!((500..700).contains(&near), "{near}");
        for region in Region::ALL {
            assert!(region.pairs(7).len() > 500, "{}", region.name());
        }
    }
}
