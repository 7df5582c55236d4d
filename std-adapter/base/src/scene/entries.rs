//! Keys and values of a scene with the place each was written at.

use super::hint::number_hint;
use super::problem::{Origin, SceneProblem};
use std::collections::BTreeMap;
use toml::de::{DeTable, DeValue};

/// A value as a file has it.
#[derive(Clone, Debug, PartialEq)]
pub enum Written {
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// Anything else, by its TOML name.
    Other(&'static str),
}

impl Written {
    /// The kind in words.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::Text(_) => "a text",
            Self::Other(kind) => kind,
        }
    }

    /// The text, if it is one.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// What a message says was there instead of what is wanted: a text is quoted, with a hint where
    /// a number was meant.
    pub fn got(&self) -> String {
        match self {
            Self::Number(x) => format!("not {x}"),
            Self::Text(text) => match number_hint(text) {
                Some(hint) => format!("got \"{text}\"; {hint}"),
                None => format!("got \"{text}\""),
            },
            Self::Other(kind) => format!("not {kind}"),
        }
    }
}

/// All keys of a scene.
#[derive(Clone, Debug, Default)]
pub struct Entries {
    /// Values by key, with their places.
    pub values: BTreeMap<String, (Written, Origin)>,
}

impl Entries {
    /// Parses the file and puts the overrides over it; one without a value takes a key of the file away, and one that cannot
    /// be read becomes a problem. Of a file that is not TOML nothing else is judged: that is the only problem then.
    pub fn parse(
        text: &str,
        overrides: &[String],
    ) -> Result<(Self, Vec<SceneProblem>), Vec<SceneProblem>> {
        let mut entries = Self::default();
        let mut problems = Vec::new();
        // Bytes that editors put first and TOML does not know.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lines = Lines::of(text);
        match DeTable::parse(text) {
            Ok(table) => {
                for (key, value) in table.get_ref() {
                    let origin = Origin::Line(lines.number(key.span().start));
                    let value = read_value(value.get_ref());
                    entries
                        .values
                        .insert(key.get_ref().to_string(), (value, origin));
                }
            }
            Err(error) => {
                let line = error.span().map_or(1, |span| lines.number(span.start));
                let message = format!("not TOML: {}; {}", error.message(), cure(text, line));
                return Err(vec![SceneProblem::new(Origin::Line(line), message)]);
            }
        }
        for item in overrides {
            match item.split_once('=') {
                Some((key, "")) if entries.values.remove(key.trim()).is_some() => {}
                Some((key, value)) if !key.trim().is_empty() => {
                    let value = read_override(value.trim());
                    entries
                        .values
                        .insert(key.trim().to_owned(), (value, Origin::Override));
                }
                _ => problems.push(SceneProblem::new(
                    Origin::Override,
                    format!("`{item}` is not of the form key=value"),
                )),
            }
        }
        Ok((entries, problems))
    }
}

/// Where the lines of a text end.
struct Lines(Vec<usize>);

impl Lines {
    fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self(ends.map(|(at, _)| at).collect())
    }

    /// Line number, from 1, of a byte of the text.
    fn number(&self, byte: usize) -> usize {
        self.0.partition_point(|end| *end < byte) + 1
    }
}

/// What to write in a line that is not TOML.
fn cure(text: &str, line: usize) -> String {
    let value = text
        .lines()
        .nth(line.saturating_sub(1))
        .and_then(|line| line.split_once('='))
        .map(|(_, value)| value.split('#').next().unwrap_or_default().trim());
    let hint = value.and_then(|value| Some(format!("got {value}; {}", number_hint(value)?)));
    hint.unwrap_or_else(|| "write lines of the form key = value".into())
}

fn read_value(value: &DeValue<'_>) -> Written {
    match value {
        DeValue::Float(number) => parsed(number.as_str()),
        DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
            Ok(integer) if (integer as f64) as i128 != i128::from(integer) => {
                Written::Other("an integer beyond 2^53, which would be rounded")
            }
            Ok(integer) => Written::Number(integer as f64),
            Err(_) => parsed(number.as_str()),
        },
        DeValue::String(text) => Written::Text(text.to_string()),
        other => Written::Other(match other {
            DeValue::Boolean(_) => "a boolean",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "an array",
            _ => "a table",
        }),
    }
}

fn parsed(text: &str) -> Written {
    text.parse()
        .map_or(Written::Other("an unreadable number"), Written::Number)
}

/// A value of an override: TOML if it reads as such, otherwise bare text.
fn read_override(text: &str) -> Written {
    match DeValue::parse(text) {
        Ok(value) => read_value(value.get_ref()),
        Err(_) => Written::Text(text.to_owned()),
    }
}
