//! The table of a scene: its fields, from which reader, errors, JSON, schema and help follow.

use super::entries::{Entries, Written};
use super::key::{Domain, Key, Need, with_present_names};
use super::problem::{InvalidScene, SceneError, SceneProblem};
use super::reader::{self, SceneDiagnostics};
use super::words::Word;
use crate::record::json_number;
use serde_json::{Map, Value};
use std::fmt::Debug;
use std::path::PathBuf;

/// A value as files spell it.
pub trait Setting: Sized {
    /// The value as a file has it.
    fn written(&self) -> Written;

    /// The value that a file has, if it is one; only values in the domain of a key are read.
    fn read(written: &Written) -> Option<Self>;
}

impl Setting for f64 {
    fn written(&self) -> Written {
        Written::Number(*self)
    }

    fn read(written: &Written) -> Option<Self> {
        match written {
            Written::Number(x) => Some(*x),
            _ => None,
        }
    }
}

macro_rules! counts {
    ($($number:ty),+) => {$(
        impl Setting for $number {
            fn written(&self) -> Written {
                Written::Number(*self as f64)
            }

            fn read(written: &Written) -> Option<Self> {
                f64::read(written).map(|x| x as Self)
            }
        }
    )+};
}
counts!(u32, u64, usize);

impl<T: Word> Setting for T {
    fn written(&self) -> Written {
        Written::Text(self.word().to_owned())
    }

    fn read(written: &Written) -> Option<Self> {
        Self::of_word(written.text()?)
    }
}

impl Setting for PathBuf {
    fn written(&self) -> Written {
        Written::Text(self.display().to_string())
    }

    fn read(written: &Written) -> Option<Self> {
        Some(written.text()?.trim().into())
    }
}

/// Makes types that are read from and shown as text values of files.
#[macro_export]
#[doc(hidden)]
macro_rules! spelled {
    ($($of_text:ty),+) => {$(
        impl $crate::scene::table::Setting for $of_text {
            fn written(&self) -> $crate::scene::entries::Written {
                $crate::scene::entries::Written::Text(self.to_string())
            }

            fn read(written: &$crate::scene::entries::Written) -> Option<Self> {
                written.text()?.parse().ok()
            }
        }
    )+};
}

/// A field of a scene, which a key sets.
pub trait Slot {
    /// The value as a file has it; nothing where it is left out.
    fn written(&self) -> Option<Written>;

    /// Takes a value that lies in the domain of the key.
    fn set(&mut self, value: &Written);
}

impl<T: Setting> Slot for T {
    fn written(&self) -> Option<Written> {
        Some(Setting::written(self))
    }

    fn set(&mut self, value: &Written) {
        if let Some(read) = T::read(value) {
            *self = read;
        }
    }
}

impl<T: Setting> Slot for Option<T> {
    fn written(&self) -> Option<Written> {
        self.as_ref().map(Setting::written)
    }

    fn set(&mut self, value: &Written) {
        *self = T::read(value);
    }
}

/// What the scenes of all bodies have in common.
///
/// ```
/// use tribos::scene::{Body, PowderScene, TipScene};
/// let scenes: [&dyn Body; 2] = [&PowderScene::default(), &TipScene::default()];
/// assert_eq!(scenes.map(|scene| scene.body()), ["powder", "tip"]);
/// assert!(scenes.iter().all(|scene| scene.check().is_ok() && scene.json()["seed"] == 1));
/// ```
pub trait Body: Debug {
    /// What the scene is about: the value of the key `body`.
    fn body(&self) -> &'static str;

    /// The keys of its files.
    #[doc(hidden)]
    fn keys(&self) -> &'static [Key];

    /// Keys and values in force, defaults included; null for what is off.
    fn json(&self) -> Value;

    /// Checks the fields by the rules that files are read by.
    fn check(&self) -> Result<(), InvalidScene>;
}

impl<T: Table> Body for T {
    fn body(&self) -> &'static str {
        T::BODY
    }

    fn keys(&self) -> &'static [Key] {
        T::TABLE
    }

    fn json(&self) -> Value {
        self.values()
    }

    fn check(&self) -> Result<(), InvalidScene> {
        let problems = reader::check(self);
        if problems.is_empty() {
            return Ok(());
        }
        let body = T::BODY;
        Err(InvalidScene { body, problems })
    }
}

/// Access to one field of a scene.
#[derive(Debug)]
pub struct Field<S> {
    /// Its value as a file has it.
    pub written: fn(&S) -> Option<Written>,
    /// Takes a value that lies in the domain of the key.
    pub set: fn(&mut S, &Written),
}

/// A scene whose fields are the keys of its files.
pub trait Table: Clone + Debug + Default + PartialEq + 'static {
    /// Value of the key `body`.
    const BODY: &'static str;
    /// The title of a film of the body.
    const TITLE: &'static str;
    /// The keys: `body`, then one for each field.
    const TABLE: &'static [Key];
    /// The fields, in the order of their keys.
    const FIELDS: &'static [Field<Self>];

    /// Notes what is wrong with values that are right one by one.
    fn rules(&self, judge: &mut SceneDiagnostics<'_>);

    /// The value that counts, where it follows from other fields.
    fn in_force(&self, key: &str, written: Option<Written>) -> Option<Written>;

    /// Keys with their fields.
    fn rows() -> impl Iterator<Item = (&'static Key, &'static Field<Self>)> {
        Self::TABLE[1..].iter().zip(Self::FIELDS)
    }

    /// Whether the key has this word.
    fn says(&self, key: &str, word: &str) -> bool {
        let row = Self::rows().find(|(other, _)| other.name == key);
        row.and_then(|(_, field)| (field.written)(self)) == Some(Written::Text(word.into()))
    }

    /// Every key with the value in force: null for what is off, nothing for keys of other variants.
    fn values(&self) -> Value {
        let mut map = Map::new();
        // The body that a file need not name is not named here either.
        if Self::BODY != crate::scene::DEFAULT_BODY {
            map.insert("body".into(), Self::BODY.into());
        }
        for (key, field) in Self::rows() {
            let written = (field.written)(self);
            let is_foreign =
                matches!(key.need, Need::PartOf(other, word) if !self.says(other, word));
            if is_foreign || (!key.domain.names_absence() && written.is_none()) {
                continue;
            }
            let value = match self.in_force(key.name, written) {
                Some(Written::Number(x)) => shown(key, x),
                Some(Written::Text(word)) => word.into(),
                Some(Written::Other(_)) | None => Value::Null,
            };
            map.insert(key.name.into(), value);
        }
        Value::Object(map)
    }

    /// Values that an earlier version may have written, [as today's](with_present_names).
    fn present(values: &Value) -> Value {
        with_present_names(Self::TABLE, &Self::default().values(), values)
    }

    /// The scene with these [values](Self::values), if it is right and has them all.
    fn of_values(values: &Value) -> Option<Self> {
        let values = &Self::present(values);
        let mut scene = Self::default();
        for (key, field) in Self::rows() {
            let written = match values.get(key.name) {
                Some(Value::Number(x)) => Written::Number(x.as_f64()?),
                Some(Value::String(word)) => Written::Text(word.clone()),
                _ => continue,
            };
            if key.objection(&written).is_some() {
                return None;
            }
            (field.set)(&mut scene, &written);
        }
        (reader::check(&scene).is_empty() && scene.values() == *values).then_some(scene)
    }

    /// Reads a file of this body.
    fn read(name: &str, text: &str, overrides: &[String]) -> Result<Self, SceneError> {
        Entries::parse(text, overrides)
            .and_then(|(entries, problems)| Self::from_entries(&entries, problems))
            .map_err(|problems| SceneError::invalid(name, problems))
    }

    /// Reads the entries of a file of this body.
    fn from_entries(
        entries: &Entries,
        problems: Vec<SceneProblem>,
    ) -> Result<Self, Vec<SceneProblem>> {
        reader::read(entries, problems)
    }
}

/// For scenes in which every value in force is the one of its field.
pub fn as_written<S>(_: &S, _: &str, written: Option<Written>) -> Option<Written> {
    written
}

/// A number as JSON: whole where it counts something.
fn shown(key: &Key, x: f64) -> Value {
    match key.domain {
        Domain::Count { .. } if key.domain.admits(x) => (x as u64).into(),
        _ => json_number(x),
    }
}

/// Declares a scene: each line is a field with its meaning, type, default, unit, domain and, unless
/// it is optional, its need. `now was before` names a key that earlier versions called `before`. The struct,
/// its `Default` and its [`Table`] are made from them.
#[macro_export]
#[doc(hidden)]
macro_rules! scene {
    (@need) => { $crate::scene::key::Need::Optional };
    (@need $need:expr) => { $need };
    (@was) => { None };
    (@was $was:ident) => { Some(stringify!($was)) };
    (
        $(#[$about:meta])*
        pub struct $name:ident = $body:literal, $title:literal, $rules:expr, $in_force:expr;
        $(
            $(#[doc = $doc:literal])+
            $field:ident $(was $was:ident)?: $type:ty = $default:expr, $unit:literal, $domain:expr $(, $need:expr)?;
        )+
    ) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $(
                $(#[doc = $doc])+
                #[doc = concat!(
                    "\n\n*Unit*: ", $unit, ". *Domain*: `", stringify!($domain),
                    "`. *Default*: `", stringify!($default), "`."
                )]
                pub $field: $type,
            )+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default),+ }
            }
        }

        impl $crate::scene::table::Table for $name {
            const BODY: &'static str = $body;
            const TITLE: &'static str = $title;
            const TABLE: &'static [$crate::scene::Key] = &[
                $crate::scene::Key {
                    domain: $crate::scene::Domain::OneOf(&[$body]),
                    ..$crate::scene::BODY
                },
                $($crate::scene::Key {
                    name: stringify!($field),
                    was: $crate::scene::table::scene!(@was $($was)?),
                    unit: $unit,
                    meaning: concat!($($doc),+).trim_ascii(),
                    domain: $domain,
                    need: $crate::scene::table::scene!(@need $($need)?),
                }),+
            ];
            const FIELDS: &'static [$crate::scene::table::Field<Self>] = &[
                $($crate::scene::table::Field {
                    written: |scene| $crate::scene::table::Slot::written(&scene.$field),
                    set: |scene, value| $crate::scene::table::Slot::set(&mut scene.$field, value),
                }),+
            ];

            fn rules(&self, judge: &mut $crate::scene::reader::SceneDiagnostics<'_>) {
                $rules(self, judge);
            }

            fn in_force(
                &self,
                key: &str,
                written: Option<$crate::scene::entries::Written>,
            ) -> Option<$crate::scene::entries::Written> {
                $in_force(self, key, written)
            }
        }

        impl $name {
            /// Keys of a scene file of this body, in the order of the documentation.
            pub const KEYS: &'static [$crate::scene::Key] =
                <Self as $crate::scene::table::Table>::TABLE;

            /// Reads the text of a scene file with `overrides` of the form `key=value` put over it;
            /// `name` stands for the file in messages.
            pub fn parse(
                name: &str,
                text: &str,
                overrides: &[String],
            ) -> Result<Self, $crate::scene::SceneError> {
                $crate::scene::table::Table::read(name, text, overrides)
            }

            /// Checks the fields by the rules that files are read by.
            pub fn check(&self) -> Result<(), $crate::scene::InvalidScene> {
                $crate::scene::Body::check(self)
            }

            /// Keys and values in force, defaults included; null for what is off.
            pub fn json(&self) -> $crate::serde_json::Value {
                $crate::scene::Body::json(self)
            }
        }
    };
}
pub use scene;
