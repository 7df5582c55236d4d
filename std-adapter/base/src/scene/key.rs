//! One key of a scene file: what it means, what it may be and when it is needed.

use super::entries::Written;
use super::words::meant;
use serde_json::{Map, Value};
use std::fmt::Display;
use std::str::FromStr;

/// One key of a scene file.
///
/// ```
/// use tribos::scene::{Domain, Key, Need, DiskScene};
/// let is_exponent = |key: &&Key| key.name == "alpha";
/// let alpha = DiskScene::KEYS.iter().find(is_exponent).ok_or("no alpha")?;
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
    /// Its name in earlier versions, if that was another one; files that use it are read as before.
    pub was: Option<&'static str>,
    /// Unit of its value, or "-" for a pure number or a word.
    pub unit: &'static str,
    /// Meaning of the key, as a sentence.
    pub meaning: &'static str,
    /// Values that it may have.
    pub domain: Domain,
    /// Scenes that must or may have it.
    pub need: Need,
}

/// The key that the scenes of all bodies have.
pub const BODY: Key = Key {
    name: "body",
    was: None,
    unit: "-",
    meaning: "What the scene is about; a disk if it is left out.",
    domain: Domain::OneOf(&[]),
    need: Need::Optional,
};

/// The present name of a key that may be given by its earlier one.
pub fn present_name<'a>(keys: &[Key], name: &'a str) -> &'a str {
    let renamed = keys.iter().find(|key| key.was == Some(name));
    renamed.map_or(name, |key| key.name)
}

/// Values of a scene that an earlier version may have written, by the present names of their keys; keys that have come
/// since have the values of the default scene.
pub fn with_present_names(keys: &[Key], defaults: &Value, values: &Value) -> Value {
    let Value::Object(values) = values else {
        return values.clone();
    };
    let named = |(name, value): (&String, &Value)| (present_name(keys, name).into(), value.clone());
    let mut present: Map<String, Value> = values.iter().map(named).collect();
    for key in keys
        .iter()
        .filter(|key| key.name != BODY.name && key.may_be_new())
    {
        if let Some(default) = defaults.get(key.name) {
            present.entry(key.name).or_insert_with(|| default.clone());
        }
    }
    Value::Object(present)
}

/// Recorded times that a file can reasonably hold.
pub const MOST_SAMPLES: f64 = 1_000_000.0;

/// Seeds that a file can hold exactly.
pub const MOST_SEEDS: f64 = 9_007_199_254_740_992.0;

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
    /// A text of a form of its own, such as a law with its parameters.
    Form(&'static Form),
    /// The path of a file or a folder, relative to the working directory.
    Path,
}

/// A form of texts, which the room that reads them declares.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// Its name, by which forms are told apart.
    pub name: &'static str,
    /// What is valid, in words.
    pub valid: &'static str,
    /// The numbers that a text stands for, which belong to `numbers`, or why it is not of the form.
    pub read: fn(&str) -> Result<Vec<f64>, String>,
    /// Numbers that may stand in the place of a text, if any.
    pub numbers: Option<&'static Domain>,
    /// Whether the values in force have a null where the key is left out, or do not name it.
    pub names_absence: bool,
}

impl PartialEq for Form {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// The [reading](Form::read) of forms that stand for no numbers.
pub fn reads<T: FromStr<Err: Display>>(text: &str) -> Result<Vec<f64>, String> {
    let read = text.parse::<T>();
    read.map(|_| Vec::new())
        .map_err(|refused| refused.to_string())
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
            Self::Form(form) => match form.numbers {
                Some(numbers) => format!("{}, or {}", numbers.describe(), form.valid),
                None => form.valid.into(),
            },
            Self::Path => "the path of a file or a folder".into(),
            Self::OneOf(words) => format!("one of \"{}\"", words.join("\", \"")),
        }
    }

    /// Whether the values in force have a null where the key is left out.
    pub(super) fn names_absence(&self) -> bool {
        !matches!(self, Self::Form(form) if !form.names_absence)
    }

    /// True if the number belongs to the domain.
    pub fn admits(&self, x: f64) -> bool {
        x.is_finite()
            && match *self {
                Self::Finite => true,
                Self::Form(form) => form.numbers.is_some_and(|numbers| numbers.admits(x)),
                Self::NotNegative => x >= 0.0,
                Self::Positive => x > 0.0,
                Self::Between { above, up_to } => x > above && x <= up_to,
                Self::Below { from, below } => x >= from && x < below,
                Self::Fraction => (0.0..=1.0).contains(&x),
                Self::Count { from, up_to } => x >= from && x <= up_to && x.fract() == 0.0,
                Self::OneOf(_) | Self::Path => false,
            }
    }
}

impl Key {
    /// Whether the scenes of earlier versions may lack it.
    fn may_be_new(&self) -> bool {
        matches!(
            self.need,
            Need::Optional | Need::OnlyWith(..) | Need::NotWith(..) | Need::Without(_)
        )
    }

    /// What is wrong with a value outside the domain, or nothing.
    pub(super) fn objection(&self, value: &Written) -> Option<String> {
        let what = match (self.domain, value) {
            (Domain::OneOf(words), Written::Text(text)) if words.contains(&&**text) => return None,
            (Domain::OneOf(words), Written::Text(text)) => {
                format!("got \"{text}\"{}", meant(text, words))
            }
            (Domain::Form(form), Written::Text(text)) => match (form.read)(text) {
                Err(refused) => return Some(format!("`{}`: {refused}", self.name)),
                Ok(numbers) => {
                    format!(
                        "not {}",
                        numbers.into_iter().find(|x| !self.domain.admits(*x))?
                    )
                }
            },
            (Domain::Path, Written::Text(text)) if !text.trim().is_empty() => return None,
            (domain, Written::Number(x)) if domain.admits(*x) => return None,
            (Domain::Form(form), other) if form.numbers.is_none() => {
                format!("not {}", other.kind())
            }
            (Domain::OneOf(_) | Domain::Path, other) => format!("not {}", other.kind()),
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
