//! A distribution of radii between bounds, drawn by its quantiles.

use super::CUT;
use super::normal::{quantile, share};

/// Radii between two positive bounds, with a finite table or a formula for their quantiles.
///
/// ```
/// use tribos::scene::SizeDistribution;
/// let radii = SizeDistribution::Normal(0.1).radii()?;
/// // The middle of a symmetric distribution is its mean.
/// assert!((radii.at(0.5) - 1.0).abs() < 1e-15 && (radii.mean() - 1.0).abs() < 1e-15);
/// let [low, high] = radii.bounds();
/// assert!((low - 0.7).abs() < 1e-15 && (high - 1.3).abs() < 1e-15);
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Radii(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// Between these bounds.
    Uniform([f64; 2]),
    /// Mean 1 and this deviation before the cut.
    Normal(f64),
    /// Median, and deviation of the logarithm before the cut.
    LogNormal(f64, f64),
    /// Radii in ascending order with the share of the spheres up to and including each.
    Table(Vec<[f64; 2]>),
}

impl Radii {
    pub(crate) fn uniform(low: f64, high: f64) -> Self {
        Self(Kind::Uniform([low, high]))
    }

    pub(super) fn normal(deviation: f64) -> Self {
        Self(Kind::Normal(deviation))
    }

    /// The mean e^(σ²/2) [Φ(c − σ) − Φ(−c − σ)]/[2Φ(c) − 1] of a cut distribution with median 1 is divided out.
    pub(super) fn log_normal(deviation: f64) -> Self {
        Self(Kind::LogNormal(1.0 / moment(deviation, 1.0), deviation))
    }

    /// From radii in ascending order with their weights.
    pub(super) fn table(rows: Vec<[f64; 2]>) -> Self {
        let total: f64 = rows.iter().map(|[_, weight]| weight).sum();
        let mean = rows.iter().map(|[r, weight]| r * weight).sum::<f64>() / total;
        let mut below = 0.0;
        let row = |[radius, weight]: [f64; 2]| {
            below += weight / total;
            [radius / mean, below]
        };
        Self(Kind::Table(rows.into_iter().map(row).collect()))
    }

    /// Smallest and largest radius.
    pub fn bounds(&self) -> [f64; 2] {
        match &self.0 {
            Kind::Uniform(bounds) => *bounds,
            Kind::Normal(deviation) => [1.0 - CUT * deviation, 1.0 + CUT * deviation],
            Kind::LogNormal(median, deviation) => {
                [-CUT, CUT].map(|z| median * libm::exp(z * deviation))
            }
            Kind::Table(rows) => {
                [rows.first(), rows.last()].map(|row| row.map_or(1.0, |row| row[0]))
            }
        }
    }

    /// Sum of two mean radii.
    pub(crate) fn two_means(&self) -> f64 {
        match &self.0 {
            Kind::Uniform([low, high]) => low + high,
            _ => 2.0,
        }
    }

    /// Mean radius.
    pub fn mean(&self) -> f64 {
        0.5 * self.two_means()
    }

    /// Mean of the third power, to which the volume is proportional.
    pub fn mean_cube(&self) -> f64 {
        match &self.0 {
            Kind::Uniform([low, high]) => 0.25 * (low + high) * (low * low + high * high),
            // ⟨(1 + σz)³⟩ = 1 + 3σ²⟨z²⟩, ⟨z²⟩ = 1 − 2cφ(c)/[2Φ(c) − 1].
            Kind::Normal(deviation) => {
                let kept = 2.0 * share(CUT) - 1.0;
                let square = 1.0 - 2.0 * CUT * super::normal::density(CUT) / kept;
                1.0 + 3.0 * deviation * deviation * square
            }
            Kind::LogNormal(median, deviation) => {
                median * median * median * moment(*deviation, 3.0)
            }
            Kind::Table(rows) => {
                let mut below = 0.0;
                let cube = |[radius, up_to]: &[f64; 2]| {
                    let weight = up_to - below;
                    below = *up_to;
                    weight * radius * radius * radius
                };
                rows.iter().map(cube).sum()
            }
        }
    }

    /// The radius below which this share of the spheres lies. *Domain*: 0 ≤ `share_below` < 1.
    pub fn at(&self, share_below: f64) -> f64 {
        // The share within the cut as a share of the whole distribution.
        let uncut = || {
            let low = share(-CUT);
            quantile(low + share_below * (1.0 - 2.0 * low)).clamp(-CUT, CUT)
        };
        match &self.0 {
            Kind::Uniform([low, high]) => low + (high - low) * share_below,
            Kind::Normal(deviation) => 1.0 + deviation * uncut(),
            Kind::LogNormal(median, deviation) => median * libm::exp(deviation * uncut()),
            Kind::Table(rows) => {
                let row = rows.partition_point(|[_, up_to]| *up_to <= share_below);
                rows.get(row).or(rows.last()).map_or(1.0, |row| row[0])
            }
        }
    }

    /// Whether all radii are equal, so that none needs to be drawn.
    pub(crate) fn are_equal(&self) -> bool {
        let [low, high] = self.bounds();
        low == high
    }
}

/// Mean of the n-th power of a log-normal number with median 1, cut at ±c deviations of its logarithm:
/// e^(n²σ²/2) [Φ(c − nσ) − Φ(−c − nσ)]/[2Φ(c) − 1].
fn moment(deviation: f64, n: f64) -> f64 {
    let shift = n * deviation;
    let kept = share(CUT - shift) - share(-CUT - shift);
    libm::exp(0.5 * shift * shift) * kept / (2.0 * share(CUT) - 1.0)
}
