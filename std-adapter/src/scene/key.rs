//! The vocabulary of a scene: which keys there are and which values each may take.

use super::entries::{Entries, Value};
use super::hint::nearest;
use super::problem::{Origin, Problem};

/// One key of a scene file.
///
/// ```
/// use tribos::scene::{Domain, Key, SliderScene};
/// let is_exponent = |key: &&Key| key.name == "alpha";
/// let alpha = SliderScene::KEYS.iter().find(is_exponent).ok_or("no alpha")?;
/// // At alpha = -1 friction would have no finite torque.
/// assert!(matches!(alpha.domain, Domain::Between { above, .. } if above == -1.0));
/// assert!(alpha.domain.describe().starts_with("a number > -1 and <= "));
/// assert_eq!(alpha.unit, "-");
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// Its unit in SI, or "-" for a pure number or text.
    pub unit: &'static str,
    /// What it means.
    pub meaning: &'static str,
    /// What it may be.
    pub domain: Domain,
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
    /// From 0 to 1, both included.
    Fraction,
    /// A whole number from 1 to `up_to`.
    Count {
        /// Largest.
        up_to: f64,
    },
    /// One of these words.
    OneOf(&'static [&'static str]),
}

impl Domain {
    /// In words.
    pub fn describe(&self) -> String {
        match self {
            Self::Finite => "a finite number".into(),
            Self::NotNegative => "a finite number >= 0".into(),
            Self::Positive => "a finite number > 0".into(),
            Self::Between { above, up_to } => format!("a number > {above} and <= {up_to}"),
            Self::Fraction => "a number from 0 to 1".into(),
            Self::Count { up_to } => format!("a whole number from 1 to {up_to}"),
            Self::OneOf(words) => format!("one of \"{}\"", words.join("\", \"")),
        }
    }

    /// True if the number belongs to the domain.
    pub(super) fn admits(&self, x: f64) -> bool {
        x.is_finite()
            && match *self {
                Self::Finite => true,
                Self::NotNegative => x >= 0.0,
                Self::Positive => x > 0.0,
                Self::Between { above, up_to } => x > above && x <= up_to,
                Self::Fraction => (0.0..=1.0).contains(&x),
                Self::Count { up_to } => x >= 1.0 && x <= up_to && x.fract() == 0.0,
                Self::OneOf(_) => false,
            }
    }
}

/// Unknown keys that are named one by one; a file with more is something else than a scene.
const MOST_UNKNOWN: usize = 20;

/// Takes values out of entries and collects what is wrong with them.
pub(super) struct Reader {
    keys: &'static [Key],
    entries: Entries,
    problems: Vec<Problem>,
}

impl Reader {
    /// Starts with a complaint about every key that is not in the vocabulary.
    pub fn new(keys: &'static [Key], entries: Entries, mut problems: Vec<Problem>) -> Self {
        let is_known = |name: &str| keys.iter().any(|key| key.name == name);
        let mut strangers = entries.values.iter().filter(|(name, _)| !is_known(name));
        for (name, (_, origin)) in strangers.by_ref().take(MOST_UNKNOWN) {
            problems.push(Problem::new(*origin, unknown(keys, name)));
        }
        let more = strangers.count();
        if more > 0 {
            problems.push(Problem::new(
                Origin::File,
                format!("and {more} more keys that are unknown"),
            ));
        }
        Self {
            keys,
            entries,
            problems,
        }
    }

    /// A number that must be there. NaN, with a problem noted, if it is not or is out of domain.
    pub fn required(&mut self, name: &str) -> f64 {
        match self.optional(name) {
            Some(number) => number,
            None => {
                if !self.is_given(name) {
                    let key = self.key(name);
                    let message = format!(
                        "`{name}` is missing: {} [{}], {}",
                        key.meaning,
                        key.unit,
                        key.domain.describe()
                    );
                    self.problems.push(Problem::new(Origin::File, message));
                }
                f64::NAN
            }
        }
    }

    /// A number that may be left out.
    pub fn optional(&mut self, name: &str) -> Option<f64> {
        let domain = self.key(name).domain;
        let (value, origin) = self.entries.values.get(name)?;
        let message = match value {
            Value::Number(x) if domain.admits(*x) => return Some(*x),
            other => format!("`{name}` must be {}, {}", domain.describe(), other.got()),
        };
        self.problems.push(Problem::new(*origin, message));
        None
    }

    /// Index of a word among those that its key admits; the first if left out.
    pub fn word(&mut self, name: &str) -> usize {
        let domain = self.key(name).domain;
        let (Domain::OneOf(words), Some((value, origin))) = (domain, self.entries.values.get(name))
        else {
            return 0;
        };
        let message = match value {
            Value::Text(text) => match words.iter().position(|word| word == text) {
                Some(index) => return index,
                None => {
                    let meant = nearest(text, words.iter().copied())
                        .map_or(String::new(), |near| format!("; did you mean \"{near}\"?"));
                    format!(
                        "`{name}` must be {}, got \"{text}\"{meant}",
                        domain.describe()
                    )
                }
            },
            other => format!(
                "`{name}` must be {}, not {}",
                domain.describe(),
                other.kind()
            ),
        };
        self.problems.push(Problem::new(*origin, message));
        0
    }

    /// True if the key stands in the file or an override.
    pub fn is_given(&self, name: &str) -> bool {
        self.entries.values.contains_key(name)
    }

    /// Notes a problem at the place of `name`.
    pub fn object(&mut self, name: &str, message: String) {
        let origin = self
            .entries
            .values
            .get(name)
            .map_or(Origin::File, |(_, origin)| *origin);
        self.problems.push(Problem::new(origin, message));
    }

    /// `scene` if nothing was wrong, else all problems in the order of the file.
    pub fn finish<T>(mut self, scene: T) -> Result<T, Vec<Problem>> {
        if self.problems.is_empty() {
            return Ok(scene);
        }
        self.problems.sort_by_key(|problem| match problem.origin {
            Origin::Line(line) => (0, line),
            Origin::Override => (1, 0),
            Origin::File => (2, 0),
        });
        Err(self.problems)
    }

    /// The vocabulary's entry; unknown names are the program's own mistake and read as free text.
    fn key(&self, name: &str) -> Key {
        const FREE: Key = Key {
            name: "",
            unit: "-",
            meaning: "",
            domain: Domain::Finite,
        };
        self.keys
            .iter()
            .copied()
            .find(|key| key.name == name)
            .unwrap_or(FREE)
    }
}

/// The complaint about an unknown key, with the nearest known one or all of them.
fn unknown(keys: &[Key], name: &str) -> String {
    match nearest(name, keys.iter().map(|key| key.name)) {
        Some(key) => format!("unknown key `{name}`; did you mean `{key}`?"),
        None => {
            let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
            format!("unknown key `{name}`; the keys are {}", names.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{SceneError, parse_scene};
    use std::time::{Duration, Instant};

    /// A disk with so many keys that nobody knows, and how long it takes to refuse it.
    fn refused(strangers: usize) -> (String, usize, Duration) {
        let mut text = String::from("speed = 1\n");
        for key in 0..strangers {
            text += &format!("key_{key} = 1\n");
        }
        let began = Instant::now();
        let refusal = parse_scene("many.toml", &text, &[]);
        let took = began.elapsed();
        let Err(error @ SceneError::Invalid { .. }) = refusal else {
            unreachable!("unknown keys");
        };
        let told = error.to_string();
        (told.clone(), told.lines().count(), took)
    }

    #[test]
    fn any_number_of_unknown_keys_is_refused_in_a_time_in_proportion() {
        let (told, lines, few) = refused(20_000);
        assert!(told.contains("and 19980 more keys that are unknown"));
        let (told, more_lines, many) = refused(200_000);
        assert!(told.contains("and 199980 more keys that are unknown"));
        // Twenty are named, as with few; every missing key is named too.
        assert_eq!(lines, more_lines);
        assert!(lines < 40, "{lines}");
        // Ten times the keys: a time that grew as the square would be a hundred times as long.
        assert!(many < 50 * few, "{few:?} {many:?}");
    }
}
