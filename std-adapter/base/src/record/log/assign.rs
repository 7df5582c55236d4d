//! Which column of a log is which quantity, and in which unit.

use super::options::{ColumnChoice, LogOptions};
use super::role::{LogRole, best_rank};
use crate::record::heading::{Heading, plain_name};
use crate::record::units::{Dimension, any_unit, known, unit};
use crate::scene::nearest;

/// A column that is read for a role.
#[derive(Clone, Debug)]
pub(super) struct Assigned {
    pub role: LogRole,
    /// Place of the column, from 0.
    pub column: usize,
    /// Its heading in the file, or its number.
    pub name: String,
    /// Factor to SI, negative for a changed sign.
    pub factor: f64,
    /// The unit in words, if there was one.
    pub unit: Option<String>,
    /// The unit in SI.
    pub si: &'static str,
    /// Whether the column has the role's own name and nothing else was said of it.
    pub is_plain: bool,
}

/// Columns of the roles and remarks.
pub(super) type Assignment = (Vec<Assigned>, Vec<String>);

/// Finds a column for each role; `width` is the number of cells of a row. Why a needed one is not found, or not clear.
pub(super) fn assign(
    headings: &[Heading],
    width: usize,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Assignment, String> {
    known_roles(roles, options)?;
    let (mut all, mut remarks): Assignment = Default::default();
    for role in roles {
        let choice = options
            .columns
            .0
            .iter()
            .find(|choice| choice.role == role.name);
        let column = match choice {
            Some(ColumnChoice { column: None, .. }) => None,
            Some(ColumnChoice {
                column: Some(column),
                ..
            }) => Some(
                chosen(headings, width, column)
                    .map_err(|why| format!("--columns {}: {why}", role.name))?,
            ),
            None => match guessed(role, headings) {
                Ok(column) => column,
                Err(why) if role.is_needed => return Err(why),
                Err(why) => {
                    remarks.push(format!("{} is not read: {why}", role.name));
                    None
                }
            },
        };
        let Some(column) = column else {
            continue;
        };
        let heading = headings.get(column);
        let sign = if choice.is_some_and(|choice| choice.is_negated) {
            -1.0
        } else {
            1.0
        };
        let (size, unit, si) = in_si(role, heading, options, &mut remarks)?;
        let text = heading.map_or(String::new(), |heading| heading.text.clone());
        all.push(Assigned {
            role: *role,
            column,
            is_plain: text == role.name && unit.is_none() && sign > 0.0,
            name: if text.is_empty() {
                format!("column {}", column + 1)
            } else {
                text
            },
            factor: sign * size,
            unit,
            si,
        });
    }
    once(&all)?;
    for (role, unit) in &options.units.0 {
        if !all.iter().any(|one| one.role.name == role) {
            return Err(format!(
                "--units {role}={unit}: no column is read for {role}; {}",
                listed(headings, width)
            ));
        }
    }
    Ok((all, remarks))
}

/// The refusal of a log without a needed role.
pub(super) fn missing(role: &LogRole, headings: &[Heading], width: usize) -> String {
    let LogRole { name, meaning, .. } = role;
    let unit = role.unit();
    let columns = listed(headings, width);
    match (headings.len(), width) {
        (0, 0..=1) | (1, 0..=1) => format!(
            "no column for {name} ({meaning} [{unit}]): the line is a single cell; between cells may stand commas, \
             semicolons, tabs or blanks; {columns}"
        ),
        (0, _) => format!(
            "no header line: say which column is {name} ({meaning} [{unit}]) by its number, such as \
             --columns {name}=2; there are {width} columns; lines before a header further down are left out by --skip N"
        ),
        _ => format!(
            "no column for {name} ({meaning} [{unit}]); {columns}; name it with --columns {name}=\"…\""
        ),
    }
}

/// Gives columns the names and the units of options; without a header all others stay nameless.
pub(in crate::record) fn rename(
    headings: &mut Vec<Heading>,
    width: usize,
    options: &LogOptions,
) -> Result<(), String> {
    if headings.is_empty() {
        headings.resize(width, Heading::of(""));
    }
    let given = headings.clone();
    for choice in &options.columns.0 {
        let (role, Some(column)) = (&choice.role, &choice.column) else {
            continue;
        };
        let found = chosen(&given, given.len(), column)
            .map_err(|why| format!("--columns {role}: {why}"))?;
        // Another column of the name makes room.
        for other in headings.iter_mut().filter(|other| other.name == *role) {
            *other = Heading::of("");
        }
        let unit = given.get(found).and_then(|heading| heading.unit.clone());
        if let Some(heading) = headings.get_mut(found) {
            *heading = Heading {
                is_negated: choice.is_negated,
                ..with_unit(role, unit)
            };
        }
    }
    for (role, text) in &options.units.0 {
        let Some(heading) = headings.iter_mut().find(|heading| heading.name == *role) else {
            return Err(format!("--units {role}={text}: there is no column {role}"));
        };
        any_unit(text).ok_or_else(|| format!("--units {role}: the unit `{text}` is not known"))?;
        let is_negated = heading.is_negated;
        *heading = Heading {
            is_negated,
            ..with_unit(role, Some(text.clone()))
        };
    }
    Ok(())
}

/// The heading of a role with this unit.
fn with_unit(role: &str, unit: Option<String>) -> Heading {
    let beside = unit
        .as_ref()
        .map_or(String::new(), |unit| format!(" [{unit}]"));
    Heading {
        text: format!("{role}{beside}"),
        name: role.into(),
        unit,
        is_negated: false,
    }
}

/// Refuses roles in options that nobody asked for.
fn known_roles(roles: &[LogRole], options: &LogOptions) -> Result<(), String> {
    let columns = options
        .columns
        .0
        .iter()
        .map(|choice| ("--columns", &choice.role));
    let units = options.units.0.iter().map(|(role, _)| ("--units", role));
    for (option, given) in columns.chain(units) {
        if !roles.iter().any(|role| role.name == given) {
            let names = roles
                .iter()
                .map(|role| format!("{} ({})", role.name, role.meaning));
            let names = names.collect::<Vec<_>>().join(", ");
            return Err(format!("{option}: `{given}` is none of {names}"));
        }
    }
    Ok(())
}

/// Refuses a column that is read for two roles.
fn once(all: &[Assigned]) -> Result<(), String> {
    for (at, one) in all.iter().enumerate() {
        if let Some(other) = all.iter().take(at).find(|other| other.column == one.column) {
            let [a, b] = [other, one].map(|one| one.role.name);
            return Err(format!(
                "`{}` is read for {a} and for {b}; name another with --columns",
                one.name
            ));
        }
    }
    Ok(())
}

/// The column of this name, or of this number from 1.
fn chosen(headings: &[Heading], width: usize, column: &str) -> Result<usize, String> {
    let like = |same: &dyn Fn(&Heading) -> bool| -> Vec<usize> {
        let all = headings.iter().enumerate();
        all.filter(|(_, heading)| same(heading))
            .map(|(at, _)| at)
            .collect()
    };
    let wanted = plain_name(column);
    for found in [
        like(&|heading| heading.text == column),
        like(&|heading| heading.name == column),
        like(&|heading| !wanted.is_empty() && plain_name(&heading.name) == wanted),
    ] {
        match found[..] {
            [] => {}
            [one] => return Ok(one),
            [one, other, ..] => {
                let [one, other] = [one + 1, other + 1];
                return Err(format!(
                    "columns {one} and {other} are both named `{column}`; give the number of one"
                ));
            }
        }
    }
    let number = column
        .parse::<usize>()
        .ok()
        .and_then(|number| number.checked_sub(1));
    number.filter(|at| *at < width).ok_or_else(|| {
        let near = nearest(column, headings.iter().map(|heading| heading.text.as_str()));
        let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
        format!(
            "there is no column `{column}`; {}{near}",
            listed(headings, width)
        )
    })
}

/// The column that names a role best.
fn guessed(role: &LogRole, headings: &[Heading]) -> Result<Option<usize>, String> {
    let ranked = |at: usize, heading: &Heading| {
        let rank = role.rank(heading)?;
        // What names another quantity better is that quantity.
        (best_rank(heading)? >= rank).then_some((rank, at))
    };
    let all = headings.iter().enumerate();
    let mut all: Vec<(usize, usize)> = all
        .filter_map(|(at, heading)| ranked(at, heading))
        .collect();
    all.sort_unstable();
    match all[..] {
        [(rank, one), (other_rank, other), ..] if rank == other_rank => {
            let name = |at: usize| headings.get(at).map_or("", |heading| heading.text.as_str());
            let role = role.name;
            Err(if name(one) == name(other) {
                format!(
                    "columns {} and {} are both named `{}`; take one by its number: --columns {role}={}",
                    one + 1,
                    other + 1,
                    name(one),
                    one + 1
                )
            } else {
                format!(
                    "`{}` and `{}` may both be {role}; name one: --columns {role}=\"{}\"",
                    name(one),
                    name(other),
                    name(one)
                )
            })
        }
        [(_, one), ..] => Ok(Some(one)),
        [] => Ok(None),
    }
}

/// Size of a column's unit in SI, and the unit.
fn in_si(
    role: &LogRole,
    heading: Option<&Heading>,
    options: &LogOptions,
    remarks: &mut Vec<String>,
) -> Result<(f64, Option<String>, &'static str), String> {
    let name = role.name;
    let given = options.units.0.iter().find(|(known, _)| known == name);
    if let Some((_, text)) = given {
        let found = unit(text, role.dimensions).ok_or_else(|| {
            format!(
                "--units {name}: the unit `{text}` is not known; known are {}",
                known(role.dimensions)
            )
        })?;
        return Ok((found.1, Some(text.clone()), found.0.unit()));
    }
    let Some((text, heading)) = heading.and_then(|heading| Some((heading.unit.as_ref()?, heading)))
    else {
        return Ok((1.0, None, role.unit()));
    };
    match unit(text, role.dimensions) {
        Some((Dimension::Electric, _)) => {
            remarks.push(format!("{name} is taken as it is, in {text}"));
            Ok((1.0, Some(text.clone()), ""))
        }
        Some((dimension, size)) => Ok((size, Some(text.clone()), dimension.unit())),
        None => match any_unit(text) {
            Some((dimension, _)) => Err(format!(
                "`{}` is in {text}, a {}, but {name} is {} [{}]; name another column with --columns \
                 {name}=\"…\", or its unit with --units {name}=…",
                heading.text,
                dimension.name(),
                role.meaning,
                role.unit()
            )),
            None => {
                remarks.push(format!(
                    "the unit `{text}` of {name} is not known: its numbers are taken as they are, in {}; \
                     --units {name}=… gives another",
                    role.unit()
                ));
                Ok((1.0, None, role.unit()))
            }
        },
    }
}

/// The columns of a file in a message.
fn listed(headings: &[Heading], width: usize) -> String {
    if headings.is_empty() {
        return format!("the file has no header and {width} columns");
    }
    let names = headings
        .iter()
        .enumerate()
        .map(|(at, heading)| format!("{} `{}`", at + 1, heading.text));
    format!("the columns are {}", names.collect::<Vec<_>>().join(", "))
}
