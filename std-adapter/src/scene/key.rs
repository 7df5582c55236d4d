//! One key of a scene file: what it means, what it may be and when it is needed.

use super::entries::Written;
use super::words::meant;
use crate::friction::{Law, Patch};
use crate::grains::Ramp;
use crate::packing::Sizes;
use crate::tip::Potential;

/// One key of a scene file.
///
/// ```
/// use tribos::scene::{Domain, Key, Need, SliderScene};
/// let is_exponent = |key: &&Key| key.name == "alpha";
/// let alpha = SliderScene::KEYS.iter().find(is_exponent).ok_or("no alpha")?;
/// // At alpha = -1 friction would have no finite torque.
/// assert!(matches!(alpha.domain, Domain::Between { above, .. } if above == -1.0));
/// assert!(alpha.domain.describe().starts_with("a number > -1 and <= "));
/// assert_eq!((alpha.unit, alpha.need), ("-", Need::UnlessGiven("law")));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// Name of the key, which is the name of the scene's field.
    pub name: &'static str,
    /// Unit of its value, or "-" for a pure number or a word.
    pub unit: &'static str,
    /// Meaning of the key, as a sentence.
    pub meaning: &'static str,
    /// Values that it may have.
    pub domain: Domain,
    /// Scenes that must or may have it.
    pub need: Need,
}

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// Any finite number.
    Finite,
    /// Finite and ≥ 0.
    NotNegative,
    /// Finite and > 0.
    Positive,
    /// `above` < value ≤ `up_to`.
    Between {
        /// Exclusive lower end.
        above: f64,
        /// Inclusive upper end.
        up_to: f64,
    },
    /// `from` ≤ value < `below`.
    Below {
        /// Inclusive lower end.
        from: f64,
        /// Exclusive upper end.
        below: f64,
    },
    /// From 0 to 1, both included.
    Fraction,
    /// A whole number from `from` to `up_to`.
    Count {
        /// Smallest.
        from: f64,
        /// Largest.
        up_to: f64,
    },
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A friction law with its parameters, as [`crate::friction::Law`] reads it.
    Law,
    /// A contact patch, as [`crate::friction::Patch`] reads it.
    Patch,
    /// A potential of atoms, as [`crate::tip::Potential`] reads it.
    Potential,
    /// A distribution of radii, as [`crate::scene::Sizes`] reads it.
    Sizes,
    /// The path of a file or a folder, relative to the working directory.
    Path,
    /// A number of this domain, or a ramp in time of such numbers, as [`crate::grains::Ramp`] reads it.
    Ramp(&'static Self),
}

/// When a file must or may give a key. Pairs are another key and one of its words; where an override changes
/// that key, what the file gives for the old word is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// Every file gives it.
    Required,
    /// It has a default, or its absence has a meaning.
    Optional,
    /// Every file gives either this key or the named one; an override of that replaces this.
    UnlessGiven(&'static str),
    /// Every file gives one of this key and the two named ones; an override of those replaces this.
    UnlessEither(&'static str, &'static str),
    /// Every file gives it, except where the other key has this word: there it is 1.
    UnitWith(&'static str, &'static str),
    /// The key exists only where the other key has this word.
    PartOf(&'static str, &'static str),
    /// A file may give it only where the other key has this word.
    OnlyWith(&'static str, &'static str),
    /// A file may give it only where the other key does not have this word.
    NotWith(&'static str, &'static str),
    /// A file may give it only without the other key; an override of that replaces this.
    Without(&'static str),
}

impl Domain {
    /// In words.
    pub fn describe(&self) -> String {
        match self {
            Self::Finite => "a finite number".into(),
            Self::NotNegative => "a finite number >= 0".into(),
            Self::Positive => "a finite number > 0".into(),
            Self::Between { above, up_to } => format!("a number > {above} and <= {up_to}"),
            Self::Below { from, below } => format!("a number >= {from} and < {below}"),
            Self::Fraction => "a number from 0 to 1".into(),
            Self::Count { from, up_to } => format!("a whole number from {from} to {up_to}"),
            Self::Law => {
                "a law with its parameters, such as \"stribeck:mu_s=0.4,mu_d=0.2,vs=0.05\"".into()
            }
            Self::Patch => "a patch such as \"box:0.3x0.2\", \"polygon:FILE\" or \"disk\"".into(),
            Self::Potential => {
                "\"lennard-jones\", \"sutton-chen:Cu\" or another metal, or \"eam:FILE\"".into()
            }
            Self::Sizes => Sizes::FORMS.into(),
            Self::Path => "the path of a file or a folder".into(),
            Self::Ramp(values) => {
                format!(
                    "{}, or a ramp such as \"0:0, 0.5:1e3, 1:0\"",
                    values.describe()
                )
            }
            Self::OneOf(words) => format!("one of \"{}\"", words.join("\", \"")),
        }
    }

    /// True if the number belongs to the domain.
    pub(super) fn admits(&self, x: f64) -> bool {
        x.is_finite()
            && match *self {
                Self::Finite => true,
                Self::Ramp(values) => values.admits(x),
                Self::NotNegative => x >= 0.0,
                Self::Positive => x > 0.0,
                Self::Between { above, up_to } => x > above && x <= up_to,
                Self::Below { from, below } => x >= from && x < below,
                Self::Fraction => (0.0..=1.0).contains(&x),
                Self::Count { from, up_to } => x >= from && x <= up_to && x.fract() == 0.0,
                Self::OneOf(_)
                | Self::Law
                | Self::Patch
                | Self::Potential
                | Self::Sizes
                | Self::Path => false,
            }
    }
}

impl Key {
    /// What is wrong with a value outside the domain, or nothing.
    pub(super) fn objection(&self, value: &Written) -> Option<String> {
        let what = match (self.domain, value) {
            (Domain::OneOf(words), Written::Text(text)) if words.contains(&&**text) => return None,
            (Domain::OneOf(words), Written::Text(text)) => {
                format!("got \"{text}\"{}", meant(text, words))
            }
            (Domain::Law, Written::Text(text)) => {
                return Some(format!("`{}`: {}", self.name, text.parse::<Law>().err()?));
            }
            (Domain::Patch, Written::Text(text)) => {
                return Some(format!("`{}`: {}", self.name, text.parse::<Patch>().err()?));
            }
            (Domain::Potential, Written::Text(text)) => {
                let refused = text.parse::<Potential>().err()?;
                return Some(format!("`{}`: {refused}", self.name));
            }
            (Domain::Sizes, Written::Text(text)) => {
                return Some(format!("`{}`: {}", self.name, text.parse::<Sizes>().err()?));
            }
            (Domain::Ramp(values), Written::Text(text)) => match text.parse::<Ramp>() {
                Err(refused) => return Some(format!("`{}`: {refused}", self.name)),
                // Between its knots a ramp takes no value beyond theirs.
                Ok(ramp) => format!(
                    "not {}",
                    ramp.range().into_iter().find(|x| !values.admits(*x))?
                ),
            },
            (Domain::Path, Written::Text(text)) if !text.trim().is_empty() => return None,
            (
                Domain::OneOf(_)
                | Domain::Law
                | Domain::Patch
                | Domain::Potential
                | Domain::Sizes
                | Domain::Path,
                other,
            ) => format!("not {}", other.kind()),
            (domain, Written::Number(x)) if domain.admits(*x) => return None,
            (_, other) => other.got(),
        };
        let (name, domain) = (self.name, self.domain.describe());
        Some(format!("`{name}` must be {domain}, {what}"))
    }

    /// The complaint about a key that a file must have.
    pub(super) fn missing(&self) -> String {
        let Self {
            name,
            unit,
            meaning,
            domain,
            ..
        } = self;
        format!(
            "`{name}` is missing: {} [{unit}], {}",
            meaning.trim_end_matches('.'),
            domain.describe()
        )
    }
}
