//! Local laws by name: `NAME:key=value,…`.

use super::catalogue::{LAWS, LawConstructor, LawEntry, LawParameter, MOST_PARAMETERS, find};
use super::refusal::finite_number;
use super::{FrictionError, LARGEST_EXPONENT, Precision};
use std::fmt::{self, Write as _};
use std::str::FromStr;
use tribos_core::law::{LawError, LocalLaw};
use tribos_core::real::Real;

/// A law of the local speed with a value for each of its parameters.
///
/// ```
/// use tribos::friction::Law;
/// use tribos::kernel::law::LocalLaw;
/// let law: Law = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".parse()?; // m/s
/// assert_eq!(law.to_string(), "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,delta=2,k=0");
/// assert!((law.build::<f64>()?.friction(1.0) - 0.2).abs() < 1e-12);
/// assert_eq!((law.name(), law.power_of_speed()), ("stribeck", None));
/// assert_eq!(Law::coulomb(0.3)?.power_of_speed(), Some([0.3, 0.0]));
/// assert_eq!(Law::power(0.3, -0.5)?.values().collect::<Vec<_>>(), [("gamma", 0.3), ("alpha", -0.5)]);
/// assert!("stribeck:mu_s=0.4".parse::<Law>().is_err_and(|why| why.to_string().contains("`mu_d`")));
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Law {
    entry: &'static LawEntry,
    maker: LawConstructor,
    values: [f64; MOST_PARAMETERS],
}

/// A local law behind a pointer.
///
/// ```
/// use tribos::friction::{AnyLaw, Law};
/// use tribos::kernel::law::LocalLaw;
/// let law: AnyLaw<f32> = Law::coulomb(0.5)?.build()?;
/// assert_eq!(law.friction(2.0), 0.5);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
pub struct AnyLaw<R>(pub(super) Box<dyn LocalLaw<R> + Send + Sync>);

impl<R> fmt::Debug for AnyLaw<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyLaw").finish_non_exhaustive()
    }
}

impl<R: Real> LocalLaw<R> for AnyLaw<R> {
    fn friction(&self, speed: R) -> R {
        self.0.friction(speed)
    }
    fn slope(&self, speed: R) -> R {
        self.0.slope(speed)
    }
}

impl Law {
    /// Coulomb friction.
    pub fn coulomb(mu: f64) -> Result<Self, FrictionError> {
        Self::named("coulomb", &[mu])
    }

    /// The power law γ|v|^α, with γ in (s/m)^α.
    pub fn power(gamma: f64, alpha: f64) -> Result<Self, FrictionError> {
        Self::named("power", &[gamma, alpha])
    }

    /// The law of this name with values in the order of its parameters, checked.
    fn named(name: &str, given: &[f64]) -> Result<Self, FrictionError> {
        let (entry, maker) = local(name)?;
        let mut values = [0.0; MOST_PARAMETERS];
        for (slot, value) in values.iter_mut().zip(given) {
            *slot = *value;
        }
        let law = Self {
            entry,
            maker,
            values,
        };
        law.build::<f64>().map(|_| law)
    }

    /// Its name in the catalogue.
    pub fn name(&self) -> &'static str {
        self.entry.name
    }

    /// Names and values of its parameters.
    pub fn values(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let values = self.entry.parameters.iter().zip(self.values);
        values.map(|(parameter, value)| (parameter.name, value))
    }

    /// Coefficient and exponent of a law that is a power of the speed.
    pub fn power_of_speed(&self) -> Option<[f64; 2]> {
        self.maker.power.map(|power| power(self.values))
    }

    /// The law itself. Its parameters are checked here.
    pub fn build<R: Precision>(&self) -> Result<AnyLaw<R>, FrictionError> {
        let made = R::make(&self.maker, self.values.map(R::from_f64));
        made.map(AnyLaw).map_err(|error| match error {
            LawError::Exponent {
                given,
                max: LARGEST_EXPONENT,
            } => FrictionError::Exponent { given },
            _ => FrictionError::Parameters {
                law: self.entry.name,
                error,
                needs: needs(self.entry.name, self.entry.parameters),
            },
        })
    }

    pub(super) fn coefficient(&self) -> f64 {
        self.power_of_speed().map_or(1.0, |[gamma, _]| gamma)
    }

    /// α of a power of the speed.
    pub(super) fn exponent(&self) -> f64 {
        self.power_of_speed().map_or(f64::NAN, |[_, alpha]| alpha)
    }

    /// d ln(friction)/d ln(speed): α of a power of the speed.
    pub(super) fn exponent_near(&self, speed: f64) -> f64 {
        match (self.power_of_speed(), self.build::<f64>()) {
            (Some([_, alpha]), _) => alpha,
            (None, Ok(law)) => law.slope(speed) * speed / law.friction(speed),
            (None, Err(_)) => f64::NAN,
        }
    }
}

impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.entry.name == other.entry.name && self.values == other.values
    }
}

impl fmt::Debug for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Law({self})")
    }
}

impl fmt::Display for Law {
    /// As [`Law::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list: Vec<String> = self
            .values()
            .map(|(name, x)| format!("{name}={x}"))
            .collect();
        write!(f, "{}:{}", self.entry.name, list.join(","))
    }
}

impl FromStr for Law {
    type Err = FrictionError;

    /// Values are read; whether they make sense is for [`Law::build`] to say.
    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let (name, list) = text.split_once(':').unwrap_or((text, ""));
        let (entry, maker) = local(name.trim())?;
        let values = read(entry.name, entry.parameters, list)?;
        Ok(Self {
            entry,
            maker,
            values,
        })
    }
}

/// The local law of this name and how it is made.
fn local(name: &str) -> Result<(&'static LawEntry, LawConstructor), FrictionError> {
    let entry = find(name).ok_or_else(|| {
        let names = || {
            LAWS.iter()
                .filter(|law| law.local.is_some())
                .map(|law| law.name)
        };
        let list = names().collect::<Vec<_>>().join(", ");
        FrictionError::unknown("local law", name, names(), format!("there are {list}"))
    })?;
    let maker = entry.local.ok_or(FrictionError::NotLocal {
        name: entry.name,
        reason: match entry.name {
            "lugre-bristles" => {
                "its bristles bend differently at every point of a patch; its steady form is `lugre`"
            }
            "rate-state-ageing" | "rate-state-slip" => {
                "its contacts age differently at every point of a patch; its steady form is `rate-state`"
            }
            _ => "`tribos laws` says which are",
        },
    })?;
    Ok((entry, maker))
}

/// One value for each parameter of `name`, in their order, from `key=value, ...`.
pub(super) fn read<const N: usize>(
    name: &'static str,
    parameters: &[LawParameter],
    list: &str,
) -> Result<[f64; N], FrictionError> {
    let mut given = [None; N];
    for item in list.split(',').filter(|item| !item.trim().is_empty()) {
        let (key, value) = item.split_once('=').ok_or_else(|| {
            FrictionError::Syntax(format!("`{item}` is not of the form key=value"))
        })?;
        let key = key.trim();
        let names = || parameters.iter().map(|parameter| parameter.name);
        let index = names().position(|name| name == key).ok_or_else(|| {
            let meant = super::text::nearest(key, names())
                .map_or("; ".into(), |near| format!("; did you mean `{near}`? "));
            let needs = needs(name, parameters);
            FrictionError::Syntax(format!("{name} has no `{key}`{meant}{needs}"))
        })?;
        let number =
            finite_number(value).map_err(|cure| FrictionError::Syntax(format!("{key}: {cure}")))?;
        if given
            .get_mut(index)
            .is_some_and(|slot| slot.replace(number).is_some())
        {
            return Err(FrictionError::Syntax(format!("`{key}` is given twice")));
        }
    }
    let mut values = [0.0; N];
    for ((slot, given), parameter) in values.iter_mut().zip(given).zip(parameters) {
        *slot = given.or(parameter.default).ok_or_else(|| {
            let needs = needs(name, parameters);
            FrictionError::Syntax(format!("`{}` is missing; {needs}", parameter.name))
        })?;
    }
    Ok(values)
}

/// "stribeck needs mu_s, mu_d, vs [m/s] and may have delta, k [s/m]".
fn needs(name: &str, parameters: &[LawParameter]) -> String {
    let list = |optional: bool| -> Vec<String> {
        let chosen = parameters.iter();
        chosen
            .filter(|parameter| parameter.default.is_some() == optional)
            .map(|parameter| match parameter.unit {
                "-" => parameter.name.to_owned(),
                unit => format!("{} [{unit}]", parameter.name),
            })
            .collect()
    };
    let mut text = format!("{name} needs {}", list(false).join(", "));
    if !list(true).is_empty() {
        let _ = write!(text, " and may have {}", list(true).join(", "));
    }
    text
}
