//! What a user says of a log: columns, units, lines to leave out.

use crate::record::heading::Heading;
use std::str::FromStr;

/// What a user says of a log beside the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LogOptions {
    /// Which column is which.
    pub columns: ColumnChoices,
    /// Units of columns, before those of the header.
    pub units: UnitChoices,
    /// Lines at the beginning that are left out.
    pub skip: u64,
}

impl LogOptions {
    /// How many headings are named as columns.
    pub(in crate::record) fn named_in(&self, headings: &[Heading]) -> usize {
        let is_named = |heading: &&Heading| {
            let columns = self.columns.0.iter();
            let mut columns = columns.filter_map(|choice| choice.column.as_ref());
            columns.any(|column| *column == heading.text || *column == heading.name)
        };
        headings.iter().filter(is_named).count()
    }
}

/// A text of options that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LogOptionError {
    /// An entry has no equals sign, or nothing at one side of it.
    #[error("`{0}` is no pair; give NAME={form}, several after commas", form = .1)]
    Pair(String, &'static str),
    /// A name has two values.
    #[error("`{0}` is given twice; give it once")]
    Twice(String),
    /// A quotation mark has no other.
    #[error("a quotation mark is not closed in `{0}`")]
    Quote(String),
}

/// The word for a column that is not to be read.
const NONE: &str = "none";

/// A column by its name, or by its number from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnChoice {
    /// Name of the role, such as v.
    pub role: String,
    /// Name or number of the column; none if the role is not to be read.
    pub column: Option<String>,
    /// Whether its numbers change their sign.
    pub is_negated: bool,
}

/// Columns of roles: `t=Time,v="v [mm/s]",f=-Force,load=4`; a minus changes the sign, `none` leaves a role out.
///
/// ```
/// use tribos::record::ColumnChoices;
/// let columns: ColumnChoices = "t=1,f=-\"Kraft, gefiltert\"".parse()?;
/// assert_eq!(columns.0[1].column.as_deref(), Some("Kraft, gefiltert"));
/// assert!(columns.0[1].is_negated);
/// assert!("Time".parse::<ColumnChoices>().is_err());
/// # Ok::<(), tribos::record::LogOptionError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ColumnChoices(pub Vec<ColumnChoice>);

/// Units of roles: `v=mm/s,f=g`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UnitChoices(pub Vec<(String, String)>);

impl ColumnChoices {
    /// From pairs of role and column.
    pub fn of(pairs: impl IntoIterator<Item = (String, String)>) -> Self {
        let choices = pairs.into_iter().map(|(role, column)| {
            let (is_negated, column) = match column.strip_prefix('-') {
                Some(rest) if !rest.is_empty() => (true, rest.trim().trim_matches('"').to_owned()),
                _ => (false, column),
            };
            let column = Some(column).filter(|column| column != NONE);
            ColumnChoice {
                role,
                column,
                is_negated,
            }
        });
        Self(choices.collect())
    }
}

impl FromStr for ColumnChoices {
    type Err = LogOptionError;

    fn from_str(text: &str) -> Result<Self, LogOptionError> {
        pairs(text, "COLUMN").map(Self::of)
    }
}

impl FromStr for UnitChoices {
    type Err = LogOptionError;

    fn from_str(text: &str) -> Result<Self, LogOptionError> {
        pairs(text, "UNIT").map(Self)
    }
}

/// Pairs `a=b` between commas; commas between quotation marks are part of a name.
fn pairs(text: &str, form: &'static str) -> Result<Vec<(String, String)>, LogOptionError> {
    if !text.matches('"').count().is_multiple_of(2) {
        return Err(LogOptionError::Quote(text.into()));
    }
    let mut is_quoted = false;
    let entries = text.split(|letter| {
        is_quoted ^= letter == '"';
        letter == ',' && !is_quoted
    });
    let mut all: Vec<(String, String)> = Vec::new();
    for entry in entries.map(str::trim).filter(|entry| !entry.is_empty()) {
        let no_pair = || LogOptionError::Pair(entry.into(), form);
        let (name, value) = entry.split_once('=').ok_or_else(no_pair)?;
        let (name, value) = (name.trim(), value.trim());
        let inside = value
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'));
        let value = inside.unwrap_or(value);
        if name.is_empty() || value.is_empty() {
            return Err(no_pair());
        }
        if all.iter().any(|(known, _)| known == name) {
            return Err(LogOptionError::Twice(name.into()));
        }
        all.push((name.into(), value.into()));
    }
    if all.is_empty() {
        return Err(LogOptionError::Pair(text.into(), form));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_read_with_quotation_marks_and_signs() -> Result<(), LogOptionError> {
        let made: ColumnChoices = "t=Time, v=v [mm/s],f=-\"F, raw\",load=none,x=-3".parse()?;
        let made: Vec<_> = made
            .0
            .iter()
            .map(|c| (&*c.role, c.column.as_deref(), c.is_negated))
            .collect();
        let wanted = [
            ("t", Some("Time"), false),
            ("v", Some("v [mm/s]"), false),
            ("f", Some("F, raw"), true),
            ("load", None, false),
            ("x", Some("3"), true),
        ];
        assert_eq!(made, wanted);
        let units: UnitChoices = "v=mm/s,f=g".parse()?;
        assert_eq!(
            units.0,
            [("v".into(), "mm/s".into()), ("f".into(), "g".into())]
        );
        Ok(())
    }

    #[test]
    fn what_is_no_pair_is_refused() {
        for (text, wanted) in [
            (
                "Time",
                "`Time` is no pair; give NAME=COLUMN, several after commas",
            ),
            (
                "t=",
                "`t=` is no pair; give NAME=COLUMN, several after commas",
            ),
            ("", "`` is no pair; give NAME=COLUMN, several after commas"),
            ("t=1,t=2", "`t` is given twice; give it once"),
            ("t=\"a", "a quotation mark is not closed in `t=\"a`"),
        ] {
            let refused = text
                .parse::<ColumnChoices>()
                .map_err(|error| error.to_string());
            assert_eq!(refused, Err(wanted.to_owned()));
        }
    }
}
