//! Laws of bonds by name.

use super::AnyBond;
use std::fmt;
use std::str::FromStr;
use tribos_core::bond::{BrittleBond, ExponentialBond, PlasticBond, ReformingBond, WeibullBond};
use tribos_core::real::Real;
use tribos_friction::{FrictionError, finite_number};

/// How the bonds of a contact break.
///
/// ```
/// use tribos::kernel::law::LocalLaw;
/// use tribos::onset::Bond;
/// for (text, _) in Bond::SYNTAX.iter().filter(|(text, _)| !text.contains(':')) {
///     assert_eq!(text.parse::<Bond>().map(|bond| bond.to_string()).as_deref(), Ok(*text));
/// }
/// let bond: Bond = "weibull:m=8".parse()?;
/// // The largest force of a bond is the static coefficient.
/// let law = bond.with(0.4, 1e-5)?; // m
/// assert!((law.friction(1e-5 * 8.0_f64.powf(-0.125)) - 0.4).abs() < 1e-15);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bond {
    /// They yield and do not break.
    Plastic,
    /// They break, with exponentially spread strengths.
    Exponential,
    /// They break, with strengths spread by Weibull's exponent m.
    Weibull(f64),
    /// They all break at one strain.
    OneStrength,
    /// They break and re-form; the strengths have Erlang's distribution of n stages.
    ReForming(u32),
    /// They all break at one strain and re-form.
    ReFormingOneStrength,
}

impl Bond {
    /// Every law as it is written, and what it is.
    pub const SYNTAX: &[(&str, &str)] = &[
        ("plastic", "bonds yield and hold on"),
        ("exponential", "bonds break, in a broad spread of strengths"),
        (
            "weibull:m=M",
            "bonds break; the larger M, up to 200, the less they differ",
        ),
        ("one-strength", "all bonds break at one strain"),
        (
            "re-forming:n=N",
            "bonds break and re-form; relative spread 1/sqrt(N), N up to 1000",
        ),
        (
            "re-forming-one-strength",
            "all break at one strain and re-form",
        ),
    ];

    /// The kernel's law of which a bond holds at most `coefficient` (a force per load), with the strain x0 in m.
    ///
    /// *Domain*: both positive and finite; the exponent and the number of stages as in the kernel.
    pub fn with(self, coefficient: f64, strain: f64) -> Result<AnyBond, FrictionError> {
        let k = coefficient / strain;
        // The force at the peak for k = 1 and x0 = 1.
        let scaled = |peak: f64| k / peak;
        Ok(match self {
            Self::Plastic => AnyBond::Plastic(PlasticBond::new(k, strain)?),
            Self::Exponential => {
                let k = scaled(Real::exp(-1.0_f64));
                AnyBond::Exponential(ExponentialBond::new(k, strain)?)
            }
            Self::Weibull(m) => {
                let unit = AnyBond::Weibull(WeibullBond::new(1.0, 1.0, m)?);
                AnyBond::Weibull(WeibullBond::new(scaled(unit.largest_force()), strain, m)?)
            }
            Self::OneStrength => AnyBond::OneStrength(BrittleBond::new(k, strain)?),
            Self::ReForming(n) => {
                let unit = AnyBond::ReForming(ReformingBond::new(1.0, 1.0, n)?);
                let k = scaled(unit.largest_force());
                AnyBond::ReForming(ReformingBond::new(k, strain, n)?)
            }
            Self::ReFormingOneStrength => {
                AnyBond::ReForming(ReformingBond::one_strength(k, strain)?)
            }
        })
    }
}

impl fmt::Display for Bond {
    /// As [`Bond::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plastic => f.write_str("plastic"),
            Self::Exponential => f.write_str("exponential"),
            Self::Weibull(m) => write!(f, "weibull:m={m}"),
            Self::OneStrength => f.write_str("one-strength"),
            Self::ReForming(n) => write!(f, "re-forming:n={n}"),
            Self::ReFormingOneStrength => f.write_str("re-forming-one-strength"),
        }
    }
}

impl FromStr for Bond {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let (name, rest) = (name.trim(), rest.trim());
        let plain = match name {
            "plastic" => Self::Plastic,
            "exponential" => Self::Exponential,
            "one-strength" => Self::OneStrength,
            "re-forming-one-strength" => Self::ReFormingOneStrength,
            "weibull" => return weibull(rest),
            "re-forming" => return re_forming(rest),
            _ => {
                let all: Vec<&str> = Self::SYNTAX.iter().map(|(syntax, _)| *syntax).collect();
                let names = all.iter().filter_map(|syntax| syntax.split(':').next());
                let list = format!("there are {}", all.join(", "));
                return Err(FrictionError::unknown("law of bonds", text, names, list));
            }
        };
        if text.contains(':') {
            return Err(FrictionError::Syntax(format!("`{name}` takes no `{rest}`")));
        }
        Ok(plain)
    }
}

/// Largest exponent: above it the strengths differ by less than the strains of neighbouring nodes.
const MOST_WEIBULL: f64 = 200.0;

/// The value of the only `key` of a law.
fn value<'a>(rest: &'a str, key: &str, example: &str) -> Result<&'a str, FrictionError> {
    match rest.split_once('=') {
        Some((given, value)) if given.trim() == key => Ok(value.trim()),
        _ => Err(FrictionError::Syntax(format!("give {example}"))),
    }
}

fn weibull(rest: &str) -> Result<Bond, FrictionError> {
    let m = finite_number(value(rest, "m", "an exponent, such as weibull:m=8")?)
        .map_err(|cure| FrictionError::Syntax(format!("m: {cure}")))?;
    // The kernel's law knows which exponents it serves; nodes resolve the break of the narrowest.
    WeibullBond::new(1.0, 1.0, m)?;
    if m > MOST_WEIBULL {
        return Err(FrictionError::Syntax(format!(
            "m: give at most {MOST_WEIBULL}, not {m}; the limit of equal strengths is one-strength"
        )));
    }
    Ok(Bond::Weibull(m))
}

fn re_forming(rest: &str) -> Result<Bond, FrictionError> {
    let given = value(rest, "n", "a number of stages, such as re-forming:n=64")?;
    let n = given.parse().map_err(|_| {
        let most = ReformingBond::<f64>::MAX_STAGES;
        FrictionError::Syntax(format!(
            "n: give a whole number from 1 to {most}, not {given}"
        ))
    })?;
    ReformingBond::new(1.0, 1.0, n)?;
    Ok(Bond::ReForming(n))
}
