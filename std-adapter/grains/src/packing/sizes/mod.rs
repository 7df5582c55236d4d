//! Distributions of the radii of spheres about their mean.

mod normal;
mod radii;
mod table;

pub use radii::Radii;

use crate::packing::SettingError;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use tribos_base::record::Rows;
use tribos_base::scene::key::{Domain, Form, reads};

/// Distance of the cuts of normal and log-normal distributions from the middle, in standard deviations:
/// the quantiles 0.00135 and 0.99865.
const CUT: f64 = 3.0;
/// Largest standard deviation of a normal distribution: its smallest radius would be 0.
const WIDEST_NORMAL: f64 = 1.0 / CUT;
/// Largest standard deviation of the logarithm: the largest radius is e⁶ = 403 times the smallest.
const WIDEST_LOG_NORMAL: f64 = 1.0;

/// Distribution of radii by number, in units of the mean radius.
///
/// | text | distribution | domain |
/// |---|---|---|
/// | `uniform:S` | uniform from 1 − S to 1 + S | 0 < S < 1 |
/// | `normal:S` | normal with standard deviation S, cut at 1 ± 3S | 0 < S < 1/3 |
/// | `lognormal:S` | the logarithm is normal with standard deviation S, cut at its quantiles ±3S | 0 < S ≤ 1 |
/// | `table:FILE` | the radii of a CSV file with columns `radius,weight`, weights by number | both > 0 |
///
/// The mean is 1 after the cut; the radii of a table are scaled to it. A file is named relative to the
/// working directory.
///
/// ```
/// use tribos::scene::SizeDistribution;
/// let sizes: SizeDistribution = "lognormal:0.3".parse()?;
/// assert_eq!(sizes, SizeDistribution::LogNormal(0.3));
/// assert_eq!(sizes.to_string(), "lognormal:0.3");
/// let [low, high] = sizes.radii()?.bounds();
/// assert!((high / low - 1.8_f64.exp()).abs() < 1e-12); // six standard deviations of the logarithm
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum SizeDistribution {
    /// Uniform between bounds at this distance from the mean.
    Uniform(f64),
    /// Normal with this standard deviation before the cut.
    Normal(f64),
    /// The logarithm is normal with this standard deviation before the cut.
    LogNormal(f64),
    /// Radii and their numbers in a file.
    Table(PathBuf),
}

impl SizeDistribution {
    /// What a message says would be valid.
    pub(crate) const FORMS: &'static str = "a distribution such as \"uniform:0.2\", \"normal:0.1\", \"lognormal:0.3\" or \"table:FILE.csv\"";

    /// The distribution, ready to be drawn from; reads the file of a table.
    pub fn radii(&self) -> Result<Radii, SettingError> {
        self.check()?;
        match self {
            Self::Uniform(spread) => Ok(Radii::uniform(1.0 - spread, 1.0 + spread)),
            Self::Normal(deviation) => Ok(Radii::normal(*deviation)),
            Self::LogNormal(deviation) => Ok(Radii::log_normal(*deviation)),
            Self::Table(path) => {
                let rows = Rows::open(path, |_| &table::COLUMNS);
                let rows = rows.and_then(table::read).map_err(table::refused)?;
                Ok(Radii::table(rows))
            }
        }
    }

    /// Refuses widths out of their domains.
    fn check(&self) -> Result<(), SettingError> {
        let (name, given, holds, valid) = match *self {
            Self::Uniform(s) => ("uniform", s, s < 1.0, "> 0 and < 1"),
            Self::Normal(s) => ("normal", s, s < WIDEST_NORMAL, "> 0 and < 1/3"),
            Self::LogNormal(s) => ("lognormal", s, s <= WIDEST_LOG_NORMAL, "> 0 and <= 1"),
            Self::Table(_) => return Ok(()),
        };
        if given > 0.0 && holds {
            Ok(())
        } else {
            Err(SettingError::Width { name, valid, given })
        }
    }
}

/// A distribution of radii, as [`SizeDistribution`] reads it.
pub(crate) const SIZES: Domain = Domain::Form(&Form {
    name: "sizes",
    valid: SizeDistribution::FORMS,
    read: reads::<SizeDistribution>,
    numbers: None,
    names_absence: true,
});

tribos_base::spelled!(SizeDistribution);

impl fmt::Display for SizeDistribution {
    /// As [`SizeDistribution::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Uniform(spread) => write!(f, "uniform:{spread}"),
            Self::Normal(deviation) => write!(f, "normal:{deviation}"),
            Self::LogNormal(deviation) => write!(f, "lognormal:{deviation}"),
            Self::Table(path) => write!(f, "table:{}", path.display()),
        }
    }
}

impl FromStr for SizeDistribution {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let refused = || SettingError::Sizes(text.into());
        let (name, rest) = text.split_once(':').ok_or_else(refused)?;
        let rest = rest.trim();
        let width = || rest.parse::<f64>().map_err(|_| refused());
        let sizes = match name.trim() {
            "uniform" => Self::Uniform(width()?),
            "normal" => Self::Normal(width()?),
            "lognormal" => Self::LogNormal(width()?),
            "table" if !rest.is_empty() => Self::Table(rest.into()),
            _ => return Err(refused()),
        };
        sizes.check()?;
        Ok(sizes)
    }
}

#[cfg(test)]
mod tests;
