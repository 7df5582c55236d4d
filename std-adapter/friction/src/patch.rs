//! Contact patches by name.

use super::refusal::finite_number;
use super::{FlatPatch, FrictionError};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tribos_core::coupling::{Annulus, WornAnnulus};
use tribos_core::patch::PowerPressure;

/// A contact patch: its shape and how it spreads the load. Lengths are in radii.
///
/// ```
/// use tribos::friction::Patch;
/// use tribos::kernel::patch::PowerPressure;
/// assert_eq!("annulus:0.8".parse(), Ok(Patch::Annulus(0.8)));
/// for (text, _) in Patch::SYNTAX.iter().filter(|(text, _)| !text.contains(':')) {
///     assert_eq!(text.parse::<Patch>().map(|patch| patch.to_string()).as_deref(), Ok(*text));
/// }
/// assert_eq!(Patch::Hertz.pressure(), Some(PowerPressure::HERTZ));
/// assert_eq!(Patch::from(PowerPressure::RING), Patch::Ring);
/// // An annulus too thin to be told from a ring is one.
/// assert_eq!([0.5, 1.0].map(Patch::band), [Patch::Annulus(0.5), Patch::Ring]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Patch {
    /// The same pressure everywhere.
    Disk,
    /// All load on the rim.
    Ring,
    /// Uniform pressure between this fraction of the radius and the radius.
    Annulus(f64),
    /// The pressure 1/r of a worn facing between this fraction of the radius and the radius: exact for dry friction.
    WornAnnulus(f64),
    /// The pressure √(1−r²) of elastic spheres.
    Hertz,
    /// The pressure 1/√(1−r²) of a rigid flat punch.
    Punch,
    /// The pressure 1−r².
    Paraboloid,
    /// The pressure (1−r²)^q of any other order q.
    Power(PowerPressure),
    /// The pressure Σ aₖ r²ᵏ.
    Polynomial(Vec<f64>),
    /// Points with weights, from a file. They have no axis: only nodes serve them.
    Points(PathBuf),
    /// A patch with straight edges, in m. It has no axis; dry friction on it is exact.
    Flat(FlatPatch),
}

/// Number of patches that are written here.
const OWN: usize = 10;

/// These, and then those of [`FlatPatch`].
const fn with_flat_ones(
    own: [(&'static str, &'static str); OWN],
) -> [(&'static str, &'static str); OWN + FlatPatch::SYNTAX.len()] {
    let mut all = [("", ""); OWN + FlatPatch::SYNTAX.len()];
    let mut place = 0;
    while place < all.len() {
        all[place] = if place < OWN {
            own[place]
        } else {
            FlatPatch::SYNTAX[place - OWN]
        };
        place += 1;
    }
    all
}

/// Most coefficients of a polynomial pressure.
pub(super) const MOST_COEFFICIENTS: usize = PowerPressure::MAX_ORDER as usize + 1;

impl Patch {
    /// Every patch as it is written, and what it is.
    pub const SYNTAX: &[(&str, &str)] = &with_flat_ones([
        ("disk", "uniform pressure"),
        ("ring", "all load on the rim"),
        (
            "annulus:INNER",
            "uniform from INNER, a share of the radius, to the rim",
        ),
        (
            "worn-annulus:INNER",
            "1/r from INNER, a share of the radius, to the rim, as worn clutches and thrust bearings",
        ),
        ("hertz", "sqrt(1 - r^2)"),
        ("punch", "1/sqrt(1 - r^2)"),
        ("paraboloid", "1 - r^2"),
        ("power:Q", "(1 - r^2)^Q"),
        ("polynomial:a0,a1,...", "a0 + a1 r^2 + ..."),
        ("points:FILE", "a CSV file with columns x, y, weight"),
    ]);

    /// A band of uniform pressure from `inner_ratio` to 1 radii; a ring if it is too thin for one.
    pub fn band(inner_ratio: f64) -> Self {
        if inner_ratio > Annulus::<f64, ()>::MAX_INNER_RATIO {
            Self::Ring
        } else {
            Self::Annulus(inner_ratio)
        }
    }

    /// The pressure (1−r²)^q of those that have one.
    pub fn pressure(&self) -> Option<PowerPressure> {
        match self {
            Self::Disk => Some(PowerPressure::UNIFORM),
            Self::Ring => Some(PowerPressure::RING),
            Self::Hertz => Some(PowerPressure::HERTZ),
            Self::Punch => Some(PowerPressure::FLAT_PUNCH),
            Self::Paraboloid => Some(PowerPressure::PARABOLOID),
            Self::Power(pressure) => Some(*pressure),
            Self::Annulus(_)
            | Self::WornAnnulus(_)
            | Self::Polynomial(_)
            | Self::Points(_)
            | Self::Flat(_) => None,
        }
    }

    /// The file that it is read from, if it is.
    pub fn file(&self) -> Option<&Path> {
        match self {
            Self::Points(file)
            | Self::Flat(
                FlatPatch::Polygon(file) | FlatPatch::Mesh(file) | FlatPatch::Feet(file),
            ) => Some(file),
            _ => None,
        }
    }

    /// Whether the friction is the same in all directions.
    pub fn has_axis(&self) -> bool {
        !matches!(self, Self::Points(_) | Self::Flat(_))
    }

    /// Whether Coulomb friction on it has a fitted form of its own.
    pub(super) fn has_form(&self) -> bool {
        matches!(
            self,
            Self::Disk | Self::Ring | Self::Hertz | Self::Punch | Self::Paraboloid
        )
    }
}

impl From<PowerPressure> for Patch {
    fn from(pressure: PowerPressure) -> Self {
        let named = [
            Self::Disk,
            Self::Ring,
            Self::Hertz,
            Self::Punch,
            Self::Paraboloid,
        ];
        let same = |patch: &Self| patch.pressure() == Some(pressure);
        named
            .into_iter()
            .find(same)
            .unwrap_or(Self::Power(pressure))
    }
}

impl fmt::Display for Patch {
    /// As [`Patch::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Disk => f.write_str("disk"),
            Self::Ring => f.write_str("ring"),
            Self::Annulus(inner) => write!(f, "annulus:{inner}"),
            Self::WornAnnulus(inner) => write!(f, "worn-annulus:{inner}"),
            Self::Hertz => f.write_str("hertz"),
            Self::Punch => f.write_str("punch"),
            Self::Paraboloid => f.write_str("paraboloid"),
            Self::Power(pressure) => write!(f, "power:{}", pressure.order()),
            Self::Polynomial(coefficients) => {
                let list: Vec<String> = coefficients.iter().map(f64::to_string).collect();
                write!(f, "polynomial:{}", list.join(","))
            }
            Self::Points(file) => write!(f, "points:{}", file.display()),
            Self::Flat(patch) => patch.fmt(f),
        }
    }
}

impl FromStr for Patch {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let (name, rest) = match text.split_once(':') {
            Some((name, rest)) => (name.trim(), rest.trim()),
            None => (text.trim(), ""),
        };
        let plain = match name {
            "disk" => Self::Disk,
            "ring" => Self::Ring,
            "hertz" => Self::Hertz,
            "punch" => Self::Punch,
            "paraboloid" => Self::Paraboloid,
            _ => return with_parameters(name, rest, text),
        };
        if text.contains(':') {
            return Err(FrictionError::Syntax(format!(
                "`{name}` takes no `{rest}`: its radius is given apart, with --radius or the key radius"
            )));
        }
        Ok(plain)
    }
}

/// The patches with something after a colon.
fn with_parameters(name: &str, rest: &str, text: &str) -> Result<Patch, FrictionError> {
    let numbers = || -> Result<Vec<f64>, FrictionError> {
        let list = rest.split(',').map(finite_number);
        list.collect::<Result<_, _>>()
            .map_err(FrictionError::Syntax)
    };
    let missing = |cure: &str| Err(FrictionError::Syntax(format!("give {cure}")));
    match name {
        "annulus" if rest.is_empty() => {
            missing("the inner over the outer radius, such as annulus:0.8")
        }
        "annulus" => match *numbers()? {
            [inner] if inner < 0.0 => missing("a number >= 0"),
            [inner] if Patch::band(inner) == Patch::Annulus(inner) => Ok(Patch::Annulus(inner)),
            [inner] => Err(FrictionError::Syntax(format!(
                "the inner over the outer radius must be from 0 to {}, not {inner}; a thinner annulus \
                 is a ring",
                Annulus::<f64, ()>::MAX_INNER_RATIO
            ))),
            _ => missing("one number, such as annulus:0.8"),
        },
        "worn-annulus" => match *numbers()? {
            [inner] => Ok(Patch::WornAnnulus(WornAnnulus::new(inner)?.inner_ratio())),
            _ => missing("the inner over the outer radius, such as worn-annulus:0.6"),
        },
        "power" if rest.is_empty() => missing("the order q of (1-r^2)^q, such as power:0.25"),
        "power" => match *numbers()? {
            [order] => Ok(PowerPressure::new(order)?.into()),
            _ => missing("one number, such as power:0.25"),
        },
        "polynomial" if rest.is_empty() => missing("coefficients, such as polynomial:1,-0.5"),
        "polynomial" => {
            let coefficients = numbers()?;
            if coefficients.len() <= MOST_COEFFICIENTS {
                Ok(Patch::Polynomial(coefficients))
            } else {
                missing(&format!("at most {MOST_COEFFICIENTS} coefficients"))
            }
        }
        "points" if rest.is_empty() => missing("a CSV file, such as points:feet.csv"),
        "points" => Ok(Patch::Points(rest.into())),
        _ if FlatPatch::is_named_by(text) => text.parse().map(Patch::Flat),
        _ => {
            let all: Vec<&str> = Patch::SYNTAX.iter().map(|(syntax, _)| *syntax).collect();
            let names = all.iter().filter_map(|syntax| syntax.split(':').next());
            let list = format!("the patches are {}", all.join(", "));
            Err(FrictionError::unknown("patch", text, names, list))
        }
    }
}
