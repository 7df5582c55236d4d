//! Which column of a table is what, as a user says it.

use std::fmt;
use std::str::FromStr;
use tribos_base::exchange::sphere_columns::SphereColumn;
use tribos_base::scene::key::{Domain, Form, reads};

/// The word for a column that is not read.
const SKIPPED: &str = "-";
/// What stands before a value of all spheres.
const ALL: &str = "all:";

/// Columns of a file of spheres: names in their order, with `-` for one that is not read; or `NAME=COLUMN`, a column
/// by its heading or its number from 1; or `NAME=all:VALUE`, one value for all spheres.
///
/// Names are `x`, `y`, `z`, `radius`, `diameter`, `density`, `mass`, `type`, `vx`, `vy`, `vz`, `wx`, `wy`, `wz`, and what
/// programs call them.
///
/// ```
/// use tribos::measure::{Assembly, PackingColumns};
/// let columns: PackingColumns = "-,x,y,z,radius=all:0.5".parse()?;
/// let pair = Assembly::parse_as("pair.xyz", b"2\n\nA 0 0 0\nA 1 0 0\n", Some(&columns))?;
/// assert_eq!(pair.radii, [0.5; 2]);
/// assert!("x,y,colour".parse::<PackingColumns>().is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PackingColumns {
    /// What the columns hold, one after the other; empty if headings say it.
    places: Vec<Option<SphereColumn>>,
    /// Columns by name.
    named: Vec<(SphereColumn, Source)>,
}

/// Where the values of a quantity come from.
#[derive(Clone, Debug, PartialEq)]
enum Source {
    /// The column of this number from 1, or of this heading.
    Column(String),
    /// One value.
    All(f64),
}

/// Why a text is no list of columns.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PackingColumnsError {
    /// A name is none of those that are known.
    #[error(
        "`{0}` is no column; known are x, y, z, radius, diameter, density, mass, type, vx, vy, vz, wx, wy, wz, and - for one that is not read"
    )]
    Name(String),
    /// A quantity is given twice.
    #[error("`{0}` is given twice; give it once")]
    Twice(&'static str),
    /// The value of all spheres is no number.
    #[error("`{0}` is no number for all spheres; give NAME=all:VALUE")]
    Value(String),
    /// Nothing is given.
    #[error("there is no column; give such as x,y,z,radius or radius=all:0.5")]
    Empty,
}

impl PackingColumns {
    /// What a message says would be valid.
    const FORMS: &'static str =
        "columns such as \"x,y,z,radius\", \"-,x,y,z,radius=all:0.5\" or \"radius=R [mm]\"";

    /// Whether the order of the columns is given.
    pub(super) fn has_places(&self) -> bool {
        !self.places.is_empty()
    }

    /// The value of all spheres, if it is given.
    pub(super) fn of_all(&self, wanted: SphereColumn) -> Option<f64> {
        self.named.iter().find_map(|(column, source)| match source {
            Source::All(value) if *column == wanted => Some(*value),
            _ => None,
        })
    }

    /// The first entry that names a column of the file: of no use where the file itself says what is what.
    pub(super) fn of_file(&self) -> Option<String> {
        let is_of_file = |(column, source): &(SphereColumn, Source)| match source {
            Source::Column(name) => Some(format!("{}={name}", column.name())),
            Source::All(_) => None,
        };
        let named = self.named.iter().find_map(is_of_file);
        named.or(self.has_places().then(|| self.to_string()))
    }

    /// What each of `width` columns holds, of which headings may be known.
    pub(super) fn assign(
        &self,
        usual: &[Option<SphereColumn>],
        headings: &[String],
        width: usize,
    ) -> Result<Vec<Option<SphereColumn>>, String> {
        if self.places.len() > width {
            let (given, columns) = (self.places.len(), self);
            return Err(format!(
                "there are {width} columns, and {given} are named: {columns}"
            ));
        }
        let mut all = if self.has_places() {
            self.places.clone()
        } else {
            usual.to_vec()
        };
        all.resize(width, None);
        for (column, source) in &self.named {
            for other in all.iter_mut().filter(|other| **other == Some(*column)) {
                *other = None;
            }
            let Source::Column(name) = source else {
                continue;
            };
            let by_name = headings.iter().position(|heading| heading == name);
            let number = name.parse::<usize>().ok();
            let by_number = number
                .filter(|number| (1..=width).contains(number))
                .map(|number| number - 1);
            let at = by_name.or(by_number).ok_or_else(|| match headings.len() {
                0 => format!("there is no column `{name}`; give a number from 1 to {width}"),
                _ => format!(
                    "there is no column `{name}`; there are {}",
                    headings.join(", ")
                ),
            })?;
            if let Some(place) = all.get_mut(at) {
                *place = Some(*column);
            }
        }
        Ok(all)
    }
}

impl FromStr for PackingColumns {
    type Err = PackingColumnsError;

    fn from_str(text: &str) -> Result<Self, PackingColumnsError> {
        let (mut places, mut named) = (Vec::new(), Vec::new());
        let known = |name: &str| {
            let column = SphereColumn::of(name);
            column.ok_or_else(|| PackingColumnsError::Name(name.into()))
        };
        for entry in text.split(',').map(str::trim) {
            match entry.split_once('=') {
                Some((name, source)) => {
                    let (column, source) = (known(name.trim())?, source.trim());
                    let source = match source.strip_prefix(ALL) {
                        Some(value) => {
                            let number = value
                                .trim()
                                .parse::<f64>()
                                .ok()
                                .filter(|value| value.is_finite());
                            Source::All(
                                number.ok_or_else(|| PackingColumnsError::Value(entry.into()))?,
                            )
                        }
                        None => Source::Column(source.into()),
                    };
                    named.push((column, source));
                }
                None if entry == SKIPPED => places.push(None),
                None if entry.is_empty() => return Err(PackingColumnsError::Empty),
                None => places.push(Some(known(entry)?)),
            }
        }
        let mut seen = Vec::new();
        let given = places
            .iter()
            .flatten()
            .chain(named.iter().map(|(column, _)| column));
        for column in given {
            if seen.contains(column) {
                return Err(PackingColumnsError::Twice(column.name()));
            }
            seen.push(*column);
        }
        Ok(Self { places, named })
    }
}

impl fmt::Display for PackingColumns {
    /// As [`PackingColumns::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let places = self.places.iter();
        let mut all: Vec<String> = places
            .map(|place| place.map_or(SKIPPED, SphereColumn::name).into())
            .collect();
        all.extend(self.named.iter().map(|(column, source)| match source {
            Source::Column(name) => format!("{}={name}", column.name()),
            Source::All(value) => format!("{}={ALL}{value}", column.name()),
        }));
        f.write_str(&all.join(","))
    }
}

/// The refusal of columns without a file.
pub(crate) const COLUMNS_ALONE: &str =
    "`columns` says what the columns of `initial_state` are; give that too, or leave it out";

/// Columns of a table, as [`PackingColumns`] reads them.
pub(crate) const COLUMNS: Domain = Domain::Form(&Form {
    name: "columns",
    valid: PackingColumns::FORMS,
    read: reads::<PackingColumns>,
    numbers: None,
    names_absence: false,
});

tribos_base::spelled!(PackingColumns);
