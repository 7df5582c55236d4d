//! Results as data: a table of quantities for each body, from which its summary, the columns of a sweep
//! and the documentation are made.
//!
//! A summary is a struct whose fields are the entries of `summary.json`;
//! [`summary!`](crate::summary!) declares both.

use crate::record::json_number;
use crate::scene::Body;
use nalgebra::Matrix3;
use serde_json::{Map, Value};

/// How far a quantity is told beyond its summary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reporting {
    /// Nowhere else.
    InSummary,
    /// In the series of a run alone.
    InSeries,
    /// A sweep has its mean in a column of its name.
    Swept,
    /// A sweep has its mean in a column of this name.
    SweptAs(&'static str),
    /// The terminal shows it, too, under this label.
    Shown(&'static str),
    /// A sweep has its mean in a column of the first name, and the terminal shows it under the second.
    ShownAs(&'static str, &'static str),
}

/// An entry of a summary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in the summary.
    pub name: &'static str,
    /// Its unit, `-` for none; that of the scene where a scene has units of its own.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Where it is told.
    pub reporting: Reporting,
    /// What it consists of; nothing for a single value.
    pub parts: &'static [Quantity],
    /// Whether its parts stand among the entries in its place.
    pub is_flat: bool,
}

impl Quantity {
    /// The column of its mean in a sweep, if it has one.
    pub fn column(&self) -> Option<&'static str> {
        match self.reporting {
            Reporting::InSummary | Reporting::InSeries => None,
            Reporting::Swept | Reporting::Shown(_) => Some(self.name),
            Reporting::SweptAs(column) | Reporting::ShownAs(column, _) => Some(column),
        }
    }

    /// Its label for the terminal, if people are shown it.
    fn label(&self) -> Option<&'static str> {
        match self.reporting {
            Reporting::Shown(label) | Reporting::ShownAs(_, label) => Some(label),
            _ => None,
        }
    }
}

/// The entries of a table with the names on the way to each, its parts after it.
pub fn entries(table: &'static [Quantity]) -> Vec<(Vec<&'static str>, &'static Quantity)> {
    let of = |entry: &'static Quantity| {
        let own = if entry.is_flat {
            vec![]
        } else {
            vec![entry.name]
        };
        let itself = (!entry.is_flat).then(|| (own.clone(), entry));
        let part = move |(path, part): (Vec<_>, _)| ([&own[..], &path].concat(), part);
        let parts = entries(entry.parts).into_iter().map(part);
        itself.into_iter().chain(parts)
    };
    let told = |entry: &&Quantity| entry.reporting != Reporting::InSeries;
    table.iter().filter(told).flat_map(of).collect()
}

/// A quantity that a sweep averages.
#[derive(Clone, Debug, PartialEq)]
pub struct SweptQuantity {
    /// The column of its mean.
    pub column: &'static str,
    /// Names on the way to it in the summary.
    pub path: Vec<&'static str>,
    /// Names on the way to its standard error, if it is a mean over time.
    pub error: Option<Vec<&'static str>>,
    /// Label for the terminal; none for a quantity that is not shown there.
    pub label: Option<&'static str>,
    /// Its unit.
    pub unit: &'static str,
}

impl SweptQuantity {
    /// The value in a summary.
    pub fn of<'a>(&self, summary: &'a Value) -> Option<&'a Value> {
        at(&self.path, summary)
    }

    /// Its standard error in a summary.
    pub fn error_of<'a>(&self, summary: &'a Value) -> Option<&'a Value> {
        at(self.error.as_ref()?, summary)
    }

    /// The value in a summary, with its unit, for people; `shown` rounds numbers.
    pub fn text(&self, summary: &Value, shown: fn(f64) -> String) -> String {
        let value = match self.of(summary) {
            None | Some(Value::Null) => return "none".into(),
            Some(Value::Number(number)) => shown(number.as_f64().unwrap_or(f64::NAN)),
            Some(Value::String(word)) => word.clone(),
            Some(other) => other.to_string(),
        };
        match self.unit {
            "-" => value,
            unit => format!("{value} {unit}"),
        }
    }

    /// A label with the unit.
    pub fn labelled(&self, label: &str) -> String {
        match self.unit {
            "-" => label.to_owned(),
            unit => format!("{label} [{unit}]"),
        }
    }
}

/// The entry of a summary under these names.
fn at<'a>(path: &[&str], summary: &'a Value) -> Option<&'a Value> {
    let mut names = path.iter();
    names.try_fold(summary, |value, name| value.get(name))
}

/// The quantities with the means over time that `averages` of a summary has in place of the last line of a series, and
/// those of all other columns after them.
pub fn averaged(
    mut quantities: Vec<SweptQuantity>,
    series: &'static [Quantity],
) -> Vec<SweptQuantity> {
    for column in series.iter().filter(|column| is_averaged(column.name)) {
        let entry = |last| vec!["averages", column.name, last];
        let mean = SweptQuantity {
            column: column.name,
            path: entry("mean"),
            error: Some(entry("error")),
            label: column.label(),
            unit: column.unit,
        };
        match quantities
            .iter_mut()
            .find(|known| known.column == column.name)
        {
            Some(known) => *known = mean,
            None => quantities.push(mean),
        }
    }
    quantities
}

/// Whether a column of a series has a mean over time: neither the time nor the number of steps.
pub fn is_averaged(column: &str) -> bool {
    !["time", "step"].contains(&column)
}

/// The quantities of a table that a sweep averages, parts after the entries before them.
pub fn swept(table: &'static [Quantity]) -> Vec<SweptQuantity> {
    let of = |(path, quantity): (_, &Quantity)| {
        Some(SweptQuantity {
            column: quantity.column()?,
            path,
            error: None,
            label: quantity.label(),
            unit: quantity.unit,
        })
    };
    entries(table).into_iter().filter_map(of).collect()
}

/// What a sweep shows of the summaries of a body.
#[derive(Clone, Copy, Debug)]
pub struct SweepView {
    /// The column that is drawn.
    pub drawn: &'static str,
    /// Title of its picture.
    pub title: &'static str,
    /// A word of the summary whose share is told: column, entry as a JSON pointer, word.
    pub share: [&'static str; 3],
}

/// A value of a summary.
pub trait Recorded {
    /// What it consists of; nothing for a single value.
    const PARTS: &'static [Quantity] = &[];

    /// The value as JSON; nothing for parts that a run does not have.
    fn recorded(&self) -> Option<Value>;
}

impl Recorded for f64 {
    fn recorded(&self) -> Option<Value> {
        Some(json_number(*self))
    }
}

macro_rules! plain {
    ($($value:ty),+) => {$(
        impl Recorded for $value {
            fn recorded(&self) -> Option<Value> {
                Some((*self).into())
            }
        }
    )+};
}
plain!(bool, u32, u64, usize, &'static str);

/// A number that a run does not have is null, a part is left out.
impl<T: Recorded> Recorded for Option<T> {
    const PARTS: &'static [Quantity] = T::PARTS;

    fn recorded(&self) -> Option<Value> {
        match self {
            Some(value) => value.recorded(),
            None => T::PARTS.is_empty().then_some(Value::Null),
        }
    }
}

impl<T: Recorded, const N: usize> Recorded for [T; N] {
    fn recorded(&self) -> Option<Value> {
        Some(self.iter().filter_map(T::recorded).collect())
    }
}

/// A tensor row by row.
impl Recorded for Matrix3<f64> {
    fn recorded(&self) -> Option<Value> {
        self.transpose().data.0.recorded()
    }
}

/// Entries of a list are not told one by one.
impl<T: Recorded> Recorded for Vec<T> {
    fn recorded(&self) -> Option<Value> {
        Some(self.iter().filter_map(T::recorded).collect())
    }
}

/// A summary, whose fields are its entries.
pub trait Summary {
    /// The entries, in the order of the fields.
    const QUANTITIES: &'static [Quantity];

    /// Names with values.
    fn entries(&self) -> Map<String, Value>;
}

impl<T: Summary> Recorded for T {
    const PARTS: &'static [Quantity] = T::QUANTITIES;

    fn recorded(&self) -> Option<Value> {
        Some(Value::Object(self.entries()))
    }
}

/// The file of a summary: its entries, the scene and the version.
pub fn file(mut entries: Map<String, Value>, scene: &dyn Body) -> Value {
    entries.insert("scene".into(), scene.json());
    entries.insert("version".into(), env!("CARGO_PKG_VERSION").into());
    Value::Object(entries)
}

/// Declares a summary: each line is an entry with its meaning, type and unit, and where else it is told. The struct and
/// its [`Summary`] are made from them. `= part` makes the entry of another summary, `= series` a line of a series, whose
/// columns are its entries. A value that is `= optional` is left out where a run does not have it; entries of one that is
/// `= flat` stand among the others.
#[macro_export]
#[doc(hidden)]
macro_rules! summary {
    (@reporting) => { $crate::results::Reporting::InSummary };
    (@reporting $reporting:expr) => { $reporting };
    (@flat flat) => { true };
    (@flat $($presence:ident)?) => { false };
    (@put $map:ident, $value:expr, $name:expr, flat) => {
        $map.append(&mut $crate::results::Summary::entries(&$value));
    };
    (@put $map:ident, $value:expr, $name:expr, optional) => {
        if let Some(value) = $value.as_ref().and_then($crate::results::Recorded::recorded) {
            $map.insert($name.into(), value);
        }
    };
    (@put $map:ident, $value:expr, $name:expr) => {
        if let Some(value) = $crate::results::Recorded::recorded(&$value) {
            $map.insert($name.into(), value);
        }
    };
    (@kind part $name:ident $($field:ident)+) => {};
    (@kind series $name:ident $($field:ident)+) => {
        impl $name {
            /// Names of the columns.
            pub const COLUMNS: [&'static str; <Self as $crate::results::Summary>::QUANTITIES.len()] =
                [$(stringify!($field)),+];

            /// The line.
            pub fn values(&self) -> [f64; Self::COLUMNS.len()] {
                [$(self.$field),+]
            }
        }

        impl From<[f64; $name::COLUMNS.len()]> for $name {
            fn from([$($field),+]: [f64; $name::COLUMNS.len()]) -> Self {
                Self { $($field),+ }
            }
        }
    };
    (@kind $name:ident $($field:ident)+) => {
        impl $name {
            /// The summary as JSON, with its scene.
            pub fn json(&self, scene: &dyn $crate::scene::Body) -> $crate::serde_json::Value {
                $crate::results::file($crate::results::Summary::entries(self), scene)
            }
        }
    };
    (
        $(#[$about:meta])*
        pub struct $name:ident $(= $part:ident)?;
        $(
            $(#[doc = $doc:literal])+
            $field:ident: $type:ty $(= $presence:ident)?, $unit:literal $(, $reporting:expr)?;
        )+
    ) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $(
                $(#[doc = $doc])+
                #[doc = concat!("*Unit*: ", $unit, ".")]
                pub $field: $type,
            )+
        }

        $crate::results::summary!(@kind $($part)? $name $($field)+);

        impl $crate::results::Summary for $name {
            const QUANTITIES: &'static [$crate::results::Quantity] = &[
                $($crate::results::Quantity {
                    name: stringify!($field),
                    unit: $unit,
                    meaning: concat!($($doc),+).trim_ascii(),
                    reporting: $crate::results::summary!(@reporting $($reporting)?),
                    parts: <$type as $crate::results::Recorded>::PARTS,
                    is_flat: $crate::results::summary!(@flat $($presence)?),
                }),+
            ];

            fn entries(&self) -> $crate::serde_json::Map<String, $crate::serde_json::Value> {
                let mut map = $crate::serde_json::Map::new();
                $(
                    if $crate::results::summary!(@reporting $($reporting)?) != $crate::results::Reporting::InSeries {
                        $crate::results::summary!(@put map, self.$field, stringify!($field) $(, $presence)?);
                    }
                )+
                map
            }
        }
    };
}
pub use summary;
