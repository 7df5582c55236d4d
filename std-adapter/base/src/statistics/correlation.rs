//! Correlation of values in the order of time, and how it enlarges the error of their mean.
//!
//! The standard error of a mean of values with the integrated autocorrelation time τ, in rows, is √(2τ) times that of
//! independent values:
//!
//! τ = ½ + Σ ρ(k), k = 1 … W,
//!
//! ρ(k) the autocorrelation at lag k and W the smallest window with W ≥ 5 τ(W) (Sokal, *Monte Carlo methods in
//! statistical mechanics*, 1989, section 3). A window beyond 64 rows is found on means of pairs, of
//! pairs of pairs and so on (Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989) 461), so that the cost is that of some 130
//! lags at most: from the long-run variance 2τσ² of the rows, that of their pairs is half.

/// The window is so many autocorrelation times (Sokal 1989: 4 to 10).
pub const WINDOWS: f64 = 5.0;
/// Most lags at one level of pairing.
pub const MOST_LAGS: usize = 64;

/// Factor by which errors of independent values grow.
pub fn error_factor(correlation_time: f64) -> f64 {
    (2.0 * correlation_time).max(1.0).sqrt()
}

/// Autocorrelation of values about their mean.
#[derive(Clone, Debug)]
pub struct Autocorrelation {
    centred: Vec<f64>,
    squares: f64,
}

impl Autocorrelation {
    /// None if all values are equal.
    pub fn of(mut centred: Vec<f64>) -> Option<Self> {
        let mean = centred.iter().sum::<f64>() / centred.len() as f64;
        for x in &mut centred {
            *x -= mean;
        }
        let squares = product(&centred, &centred);
        (squares > 0.0).then_some(Self { centred, squares })
    }

    /// ρ at a lag.
    pub fn at(&self, lag: usize) -> f64 {
        let later = self.centred.get(lag..).unwrap_or_default();
        product(&self.centred, later) / self.squares
    }
}

/// Sum of products, in eight sums side by side.
fn product(one: &[f64], other: &[f64]) -> f64 {
    const SUMS: usize = 8;
    let mut sums = [0.0; SUMS];
    let (ones, others) = (one.chunks_exact(SUMS), other.chunks_exact(SUMS));
    let both = one.len().min(other.len());
    let rest = both - both % SUMS;
    for (a, b) in ones.zip(others) {
        for ((sum, x), y) in sums.iter_mut().zip(a).zip(b) {
            *sum += x * y;
        }
    }
    let tail = one.iter().zip(other).skip(rest).map(|(x, y)| x * y);
    sums.iter().sum::<f64>() + tail.sum::<f64>()
}

/// Integrated autocorrelation time in rows; ½ for values that are all equal.
pub fn correlation_time(values: Vec<f64>) -> f64 {
    correlation(values)[0]
}

/// Integrated autocorrelation time and its window W, both in rows.
pub fn correlation(mut level: Vec<f64>) -> [f64; 2] {
    const INDEPENDENT: f64 = 0.5;
    // Rows per value of this level, times its variance over that of the rows.
    let mut share = 1.0;
    let mut first_variance = None;
    loop {
        let count = level.len();
        let Some(correlation) = Autocorrelation::of(level) else {
            return [INDEPENDENT, 0.0];
        };
        let variance = correlation.squares / count as f64;
        let of_rows = *first_variance.get_or_insert(variance);
        let mut time = INDEPENDENT;
        let may_pair = count > 4 * MOST_LAGS;
        let most = if may_pair { MOST_LAGS } else { count - 1 };
        for lag in 1..=most {
            time += correlation.at(lag);
            let is_last = lag == most && !may_pair;
            if lag as f64 >= WINDOWS * time || is_last {
                let time = share * time * variance / of_rows;
                return [time.max(0.0), share * lag as f64];
            }
        }
        let centred = correlation.centred.chunks_exact(2);
        level = centred.map(|pair| 0.5 * pair.iter().sum::<f64>()).collect();
        share *= 2.0;
    }
}

/// Slope over the order of the values, and the slope in its standard error.
pub fn drift(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = values.iter().sum::<f64>() / count;
    let order = || (0..values.len()).map(|i| i as f64 - middle);
    let spread = count * (count * count - 1.0) / 12.0; // Σ (i − middle)²
    let moment: f64 = order().zip(values).map(|(x, r)| x * (r - mean)).sum();
    let slope = moment / spread;
    let left: Vec<f64> = order()
        .zip(values)
        .map(|(x, r)| r - mean - slope * x)
        .collect();
    let variance = product(&left, &left) / (count - 2.0);
    let error = (variance / spread).sqrt() * error_factor(correlation_time(left));
    (slope, if error > 0.0 { slope / error } else { 0.0 })
}
