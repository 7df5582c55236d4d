//! Reading and checking golden files; errors name their line.

use super::quantity::{Quantity, hex, read_hex};
use super::{FORMAT, Golden, Pinned};
use std::collections::BTreeMap;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A golden file that cannot be used.
///
/// ```
/// use tribos::golden::{Golden, GoldenError};
/// let old = Golden::parse("old.toml", "format = 0");
/// assert!(matches!(old, Err(GoldenError::Version { given, .. }) if given == "0"));
/// let cut = Golden::parse("cut.toml", "format = 1\n\n[[scene]]\npath = \"disk.t");
/// assert!(matches!(cut, Err(GoldenError::Damaged { line: 4, .. })));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GoldenError {
    /// Written in another version of the format.
    #[error(
        "{name}: format {given} of golden files is not known, only {FORMAT}; \
         write the file again with this version of tribos"
    )]
    Version {
        /// The file.
        name: String,
        /// Its format.
        given: String,
    },
    /// Not a golden file, or a damaged one.
    #[error("{name}:{line}: {message}; write the file again with `tribos golden write`")]
    Damaged {
        /// The file.
        name: String,
        /// Line number, from 1.
        line: usize,
        /// Description of the error.
        message: String,
    },
}

/// What is wrong, and at which byte.
struct ParseFault(usize, String);

type Table<'a> = Spanned<&'a DeTable<'a>>;

impl Golden {
    /// Reads the text of a file; `name` stands for it in messages.
    pub fn parse(name: &str, text: &str) -> Result<Self, GoldenError> {
        let damaged = |ParseFault(byte, message): ParseFault| GoldenError::Damaged {
            name: name.into(),
            line: 1 + text.bytes().take(byte).filter(|&b| b == b'\n').count(),
            message,
        };
        let table = DeTable::parse(text).map_err(|error| {
            let byte = error.span().map_or(0, |span| span.start);
            damaged(ParseFault(byte, format!("not TOML: {}", error.message())))
        })?;
        let table = Spanned::new(table.span(), table.get_ref());
        let format = match find(&table, "format") {
            Ok(value) => match value.get_ref() {
                DeValue::Integer(number) => number.as_str().to_owned(),
                _ => "of no number".into(),
            },
            Err(fault) => return Err(damaged(fault)),
        };
        if format != FORMAT.to_string() {
            return Err(GoldenError::Version {
                name: name.into(),
                given: format,
            });
        }
        let scenes = scenes(&table).map_err(damaged)?;
        Ok(Self { scenes })
    }
}

fn scenes(table: &Table<'_>) -> Result<Vec<Pinned>, ParseFault> {
    let list = find(table, "scene")?;
    let DeValue::Array(items) = list.get_ref() else {
        return Err(fault(list, "`scene` must be a list of tables"));
    };
    items
        .iter()
        .map(|item| match item.get_ref() {
            DeValue::Table(scene) => pinned(&Spanned::new(item.span(), scene)),
            _ => Err(fault(item, "a scene must be a table")),
        })
        .collect()
}

fn pinned(scene: &Table<'_>) -> Result<Pinned, ParseFault> {
    let digest = find(scene, "scene_digest")?;
    let state = match find(scene, "state") {
        Ok(_) => Some(part(scene, "state")?),
        Err(_) => None,
    };
    let pinned = Pinned {
        path: text(find(scene, "path")?)?.to_owned(),
        overrides: texts(find(scene, "set")?)?
            .iter()
            .map(|item| (*item).to_owned())
            .collect(),
        parameters: each(&part(scene, "parameters")?, quantity)?,
        summary: each(&part(scene, "summary")?, quantity)?,
        rows: whole(find(scene, "rows")?)?,
        block_rows: whole(find(scene, "block_rows")?)?,
        columns: each(&part(scene, "series")?, digests)?,
        state: state.map_or(Ok(BTreeMap::new()), |state| each(&state, bits))?,
    };
    if bits(digest)? != pinned.scene_digest() {
        let message = format!(
            "`scene_digest` is not that of the parameters, {}",
            hex(pinned.scene_digest())
        );
        return Err(fault(digest, message));
    }
    let blocks = pinned.rows.div_ceil(pinned.block_rows);
    match pinned
        .columns
        .iter()
        .find(|column| column.1.len() != blocks)
    {
        Some((name, _)) => {
            let message = format!("column \"{name}\" must have {blocks} digests");
            Err(ParseFault(scene.span().start, message))
        }
        None => Ok(pinned),
    }
}

fn find<'a>(table: &Table<'a>, name: &str) -> Result<&'a Spanned<DeValue<'a>>, ParseFault> {
    let mut entries = table.get_ref().iter();
    match entries.find(|(key, _)| key.get_ref() == name) {
        Some((_, value)) => Ok(value),
        None => Err(ParseFault(
            table.span().start,
            format!("`{name}` is missing"),
        )),
    }
}

fn part<'a>(table: &Table<'a>, name: &str) -> Result<Table<'a>, ParseFault> {
    let value = find(table, name)?;
    match value.get_ref() {
        DeValue::Table(part) => Ok(Spanned::new(value.span(), part)),
        _ => Err(fault(value, format!("`{name}` must be a table"))),
    }
}

/// All entries of a table, read alike.
fn each<T>(
    table: &Table<'_>,
    read: impl Fn(&Spanned<DeValue<'_>>) -> Result<T, ParseFault>,
) -> Result<BTreeMap<String, T>, ParseFault> {
    let entries = table.get_ref().iter();
    entries
        .map(|(key, value)| Ok((key.get_ref().to_string(), read(value)?)))
        .collect()
}

fn text<'a>(value: &'a Spanned<DeValue<'_>>) -> Result<&'a str, ParseFault> {
    match value.get_ref() {
        DeValue::String(text) => Ok(text),
        _ => Err(fault(value, "this must be a text")),
    }
}

fn texts<'a>(value: &'a Spanned<DeValue<'_>>) -> Result<Vec<&'a str>, ParseFault> {
    match value.get_ref() {
        DeValue::Array(items) => items.iter().map(text).collect(),
        _ => Err(fault(value, "this must be a list of texts")),
    }
}

fn quantity(value: &Spanned<DeValue<'_>>) -> Result<Quantity, ParseFault> {
    text(value).map(Quantity::read)
}

fn bits(value: &Spanned<DeValue<'_>>) -> Result<u64, ParseFault> {
    read_hex(text(value)?).ok_or_else(|| {
        fault(
            value,
            "this must be 0x and 16 lower-case hexadecimal digits",
        )
    })
}

fn digests(value: &Spanned<DeValue<'_>>) -> Result<Vec<u64>, ParseFault> {
    match value.get_ref() {
        DeValue::Array(items) => items.iter().map(bits).collect(),
        _ => Err(fault(value, "this must be a list of digests")),
    }
}

/// A number of rows.
fn whole(value: &Spanned<DeValue<'_>>) -> Result<usize, ParseFault> {
    let number = match value.get_ref() {
        DeValue::Integer(number) => number.as_str().parse().ok(),
        _ => None,
    };
    match number {
        Some(number) if number > 0 => Ok(number),
        _ => Err(fault(value, "this must be a whole number from 1")),
    }
}

fn fault(value: &Spanned<DeValue<'_>>, message: impl Into<String>) -> ParseFault {
    ParseFault(value.span().start, message.into())
}
