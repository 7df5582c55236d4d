//! Contact patches by name.

use super::number;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use tribos::scene::nearest;
use tribos_core::coupling::Annulus;
use tribos_core::patch::PowerPressure;

/// A patch as the command line names it.
#[derive(Clone, Debug, PartialEq)]
pub enum PatchName {
    /// The same pressure everywhere.
    Disk,
    /// All load on the rim.
    Ring,
    /// Uniform between this fraction of the radius and the radius.
    Annulus(f64),
    /// √(1−r²)
    Hertz,
    /// 1/√(1−r²)
    Punch,
    /// 1−r²
    Paraboloid,
    /// Σ aₖ r²ᵏ
    Polynomial(Vec<f64>),
    /// Points with weights, from a file.
    Points(PathBuf),
}

/// Names of the patches, without what may follow a colon.
const NAMES: [&str; 8] = [
    "disk",
    "ring",
    "annulus",
    "hertz",
    "punch",
    "paraboloid",
    "polynomial",
    "points",
];

/// What `--patch` takes.
pub const PATCHES: &str = "disk, ring, annulus:INNER, hertz, punch, paraboloid, \
    polynomial:a0,a1,... (pressure a0 + a1 r^2 + ..., r in radii) or points:FILE";

impl PatchName {
    /// The pressure (1−r²)^q of those that have one.
    pub fn pressure(&self) -> Option<PowerPressure> {
        match self {
            Self::Disk => Some(PowerPressure::UNIFORM),
            Self::Ring => Some(PowerPressure::RING),
            Self::Hertz => Some(PowerPressure::HERTZ),
            Self::Punch => Some(PowerPressure::FLAT_PUNCH),
            Self::Paraboloid => Some(PowerPressure::PARABOLOID),
            Self::Annulus(_) | Self::Polynomial(_) | Self::Points(_) => None,
        }
    }
}

impl fmt::Display for PatchName {
    /// As the command line takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Disk => f.write_str("disk"),
            Self::Ring => f.write_str("ring"),
            Self::Annulus(inner) => write!(f, "annulus:{inner}"),
            Self::Hertz => f.write_str("hertz"),
            Self::Punch => f.write_str("punch"),
            Self::Paraboloid => f.write_str("paraboloid"),
            Self::Polynomial(coefficients) => {
                let list: Vec<String> = coefficients.iter().map(f64::to_string).collect();
                write!(f, "polynomial:{}", list.join(","))
            }
            Self::Points(file) => write!(f, "points:{}", file.display()),
        }
    }
}

impl FromStr for PatchName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, rest) = match text.split_once(':') {
            Some((name, rest)) => (name.trim(), Some(rest.trim())),
            None => (text.trim(), None),
        };
        let plain = match name {
            "disk" => Some(Self::Disk),
            "ring" => Some(Self::Ring),
            "hertz" => Some(Self::Hertz),
            "punch" => Some(Self::Punch),
            "paraboloid" => Some(Self::Paraboloid),
            _ => None,
        };
        match (name, plain, rest) {
            (_, Some(patch), None) => Ok(patch),
            (_, Some(_), Some(rest)) => Err(format!("`{name}` takes no `{rest}`")),
            ("annulus", _, Some(inner)) => {
                let most = Annulus::<f64, ()>::MAX_INNER_RATIO;
                let inner = number::not_negative(inner)?;
                if inner <= most {
                    Ok(Self::Annulus(inner))
                } else {
                    Err(format!(
                        "the inner over the outer radius must be from 0 to {most}, not {inner}; \
                         a thinner annulus is a ring"
                    ))
                }
            }
            ("annulus", ..) => {
                Err("give the inner over the outer radius, such as annulus:0.8".into())
            }
            ("polynomial", _, Some(list)) if !list.is_empty() => {
                let most = PowerPressure::MAX_ORDER as usize + 1;
                let coefficients: Vec<f64> = list
                    .split(',')
                    .map(number::finite)
                    .collect::<Result<_, _>>()?;
                if coefficients.len() <= most {
                    Ok(Self::Polynomial(coefficients))
                } else {
                    Err(format!("give at most {most} coefficients"))
                }
            }
            ("polynomial", ..) => Err("give coefficients, such as polynomial:1,-0.5".into()),
            ("points", _, Some(file)) if !file.is_empty() => Ok(Self::Points(file.into())),
            ("points", ..) => Err("give a CSV file, such as points:feet.csv".into()),
            _ => Err(match nearest(name, NAMES) {
                Some(meant) => format!("unknown patch `{text}`; did you mean `{meant}`?"),
                None => format!("unknown patch `{text}`; the patches are {PATCHES}"),
            }),
        }
    }
}
