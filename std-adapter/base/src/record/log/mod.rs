//! Logs of measurements as machines and spreadsheets write them: columns in SI, and words for what was understood.

mod assign;
mod collect;
mod derive;
mod look;
mod options;
mod role;
#[cfg(test)]
mod tests;
mod words;

pub use look::{LogPreview, LookColumn, look, look_from};
pub use options::{ColumnChoice, ColumnChoices, LogOptionError, LogOptions, UnitChoices};
pub use role::LogRole;

use super::cells::{Cell, Decimal, Delimiter};
use super::dialect::WordsBelow;
use super::heading::Heading;
use super::lines::Lines;
use super::sheet::Sheet;
use super::table::TableError;
pub(super) use assign::rename;
use assign::{Assigned, assign, missing};
use collect::Collector;
use derive::{Plan, derivatives};
use std::io::BufRead;
use std::path::Path;

/// Why a row of a log is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropReason {
    /// A cell of a column that is read is empty.
    Empty,
    /// A cell of a column that is read is NaN, infinite, or a mark for no value.
    NotANumber,
    /// The row ends before a column that is read.
    Short,
    /// The time is that of the row before.
    RepeatedTime,
    /// The time is before that of an earlier row.
    TimeBack,
    /// The line repeats the header.
    Header,
}

impl DropReason {
    /// All of them.
    const ALL: [Self; 6] = [
        Self::Empty,
        Self::NotANumber,
        Self::Short,
        Self::RepeatedTime,
        Self::TimeBack,
        Self::Header,
    ];

    /// Words behind a number of rows.
    pub fn name(self) -> &'static str {
        match self {
            Self::Empty => "with an empty cell",
            Self::NotANumber => "with NaN",
            Self::Short => "too short",
            Self::RepeatedTime => "with a repeated time",
            Self::TimeBack => "with a time that goes back",
            Self::Header => "that repeat the header",
        }
    }

    /// What to do where most rows are of this kind.
    fn cure(self) -> &'static str {
        match self {
            Self::Empty | Self::NotANumber => {
                "name another column with --columns, or leave a role out with --columns NAME=none"
            }
            Self::Short => "look at the file with --look: it may hold several tables",
            Self::RepeatedTime => {
                "the time has too few digits, or is another column: name it with --columns t=\"…\""
            }
            Self::TimeBack => {
                "the file may hold several records: give one of them, or leave the time out by --columns t=none"
            }
            Self::Header => "give one table",
        }
    }
}

/// Columns of a log in SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// The columns by the names of their roles.
    pub columns: Vec<(&'static str, Vec<f64>)>,
    /// Line of each row, or its number from 1 where there are no lines.
    pub lines: Vec<u64>,
    /// What was understood, a line for each part.
    pub understood: Vec<String>,
    /// The same in one line, or two if rows were dropped; nothing for a table as Tribos writes it.
    pub brief: Vec<String>,
    /// Numbers of rows that were left out, by reason.
    pub dropped: Vec<(DropReason, u64)>,
    /// Units in SI of the columns whose unit is known.
    pub units: Vec<(&'static str, &'static str)>,
}

impl Log {
    /// The column of a role.
    pub fn column(&self, role: &str) -> Option<&[f64]> {
        let found = self.columns.iter().find(|(name, _)| *name == role);
        found.map(|(_, column)| column.as_slice())
    }

    /// The unit in SI of a role's column, if it is known.
    pub fn unit(&self, role: &str) -> Option<&'static str> {
        let found = self.units.iter().find(|(name, _)| *name == role);
        found.map(|(_, unit)| *unit)
    }

    /// The column of a role, taken out.
    pub fn take(&mut self, role: &str) -> Option<Vec<f64>> {
        let found = self.columns.iter_mut().find(|(name, _)| *name == role);
        found.map(|(_, column)| std::mem::take(column))
    }
}

/// Reads the columns of these roles from a file, or from standard input for `-`: row by row, so that only the numbers are
/// held in memory.
///
/// Delimiter, decimal mark, lines before the header and units are found from the first lines. Columns are found by the
/// options, by the roles' names or by [their usual names](LogRole::synonyms). Rows without a number in one of
/// them are dropped and counted, as are rows whose time does not rise. A needed velocity without a column is made from the
/// position, a needed acceleration from the velocity.
pub fn read_log(path: &Path, roles: &[LogRole], options: &LogOptions) -> Result<Log, TableError> {
    read(Lines::asked_for(path)?, roles, options)
}

/// The same from an open source with this name.
pub fn read_log_from<'a>(
    name: &Path,
    source: impl BufRead + 'a,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Log, TableError> {
    read(Lines::of(name, Box::new(source)), roles, options)
}

/// The same from columns that are in memory, by their names, such as those of a data frame.
pub fn log_of_columns(
    name: &str,
    columns: &[(String, Vec<f64>)],
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Log, TableError> {
    let headings: Vec<Heading> = columns.iter().map(|(name, _)| Heading::of(name)).collect();
    let whole = |reason: String| TableError::Whole {
        file: name.into(),
        reason,
    };
    let plan = plan(&headings, headings.len(), roles, options).map_err(whole)?;
    let mut collector = Collector::new(&plan.assigned);
    let length = |one: &Assigned| {
        columns
            .get(one.column)
            .map_or(0, |(_, values)| values.len())
    };
    let count = plan.assigned.first().map_or(0, length);
    if let Some(other) = plan.assigned.iter().find(|one| length(one) != count) {
        let reason = format!(
            "columns of different lengths: {count}, and {} of `{}`",
            length(other),
            other.name
        );
        return Err(whole(reason));
    }
    for row in 0..count {
        for (slot, one) in plan.assigned.iter().enumerate() {
            let value = columns
                .get(one.column)
                .and_then(|(_, values)| values.get(row));
            collector.put(
                slot,
                match value {
                    Some(value) if value.is_finite() => Cell::Number(*value),
                    Some(_) => Cell::Missing,
                    None => Cell::Empty,
                },
            );
        }
        collector.end(row as u64 + 1);
    }
    finish(collector, plan, None).map_err(whole)
}

/// Places of the columns that [`log_of_columns`] reads; the others may be empty there.
pub fn used_columns(
    name: &str,
    columns: &[String],
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Vec<usize>, TableError> {
    let headings: Vec<Heading> = columns.iter().map(|name| Heading::of(name)).collect();
    let plan = plan(&headings, headings.len(), roles, options);
    let used = plan.map(|plan| plan.assigned.iter().map(|one| one.column).collect());
    used.map_err(|reason| TableError::Whole {
        file: name.into(),
        reason,
    })
}

/// Columns of roles and what is to be made of them.
fn plan(
    headings: &[Heading],
    width: usize,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Plan, String> {
    let (assigned, remarks) = assign(headings, width, roles, options)?;
    let mut plan = Plan {
        assigned,
        remarks,
        derived: Vec::new(),
    };
    for role in roles.iter().filter(|role| role.is_needed) {
        if !plan.has(role.name) && !plan.derives(role, headings, width, options)? {
            return Err(missing(role, headings, width));
        }
    }
    plan.without_idle_position(roles, options);
    Ok(plan)
}

/// The number of names in a header that options or roles know.
fn known<'a>(roles: &'a [LogRole], options: &'a LogOptions) -> impl FnMut(&[&str]) -> usize + 'a {
    move |header| {
        // Numbers name nothing.
        let names = header
            .iter()
            .filter(|text| Decimal::Point.number(text).is_none());
        let headings: Vec<Heading> = names.map(|text| Heading::of(text)).collect();
        let is_known = |heading: &&Heading| roles.iter().any(|role| role.rank(heading).is_some());
        headings.iter().filter(is_known).count() + options.named_in(&headings)
    }
}

fn read(lines: Lines<'_>, roles: &[LogRole], options: &LogOptions) -> Result<Log, TableError> {
    let mut sheet = open(lines, roles, options)?;
    let header = sheet.header_line();
    let plan = plan(&sheet.headings, columns(&sheet), roles, options);
    let plan = plan.map_err(|reason| sheet.refusal_at(header, &reason))?;
    let mut collector = Collector::new(&plan.assigned);
    let slots = slots(&plan.assigned, columns(&sheet));
    let mut count = 0_u64;
    while sheet.advance()? {
        count += 1;
        match read_row(&sheet, &slots, &mut collector) {
            Ok(()) => collector.end(sheet.number()),
            Err(_) if sheet.is_header_again() => collector.skip(DropReason::Header),
            Err(fault) => return Err(sheet.refusal(&fault.told(&sheet, &plan.assigned))),
        }
    }
    if count == 0 {
        let reason = "no rows of numbers; give one line for each measurement below the header";
        return Err(sheet.refusal_at(sheet.number() + 1, reason));
    }
    let log = finish(collector, plan, Some(&sheet));
    log.map_err(|reason| TableError::Whole {
        file: sheet.name(),
        reason,
    })
}

/// A table with its dialect, in which the names of options and roles count.
fn open<'a>(
    lines: Lines<'a>,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<Sheet<'a>, TableError> {
    Sheet::open(
        lines,
        options.skip,
        WordsBelow::LeftOut,
        &mut known(roles, options),
    )
}

/// Number of columns: those of the header, or of the first row without one.
fn columns(sheet: &Sheet<'_>) -> usize {
    match sheet.headings.len() {
        0 => sheet.width,
        count => count,
    }
}

/// Which slot of a row each column fills.
fn slots(assigned: &[Assigned], width: usize) -> Vec<Option<usize>> {
    let slot = |column: usize| assigned.iter().position(|one| one.column == column);
    (0..width).map(slot).collect()
}

/// What is wrong with a row.
enum Fault {
    /// A word stands in the column of a slot.
    Word(usize, String),
    /// It has so many cells, more than the header.
    Wide(usize),
}

/// The cells of a row that are read.
fn read_row(
    sheet: &Sheet<'_>,
    slots: &[Option<usize>],
    collector: &mut Collector,
) -> Result<(), Fault> {
    let (delimiter, decimal) = (sheet.dialect.delimiter, sheet.dialect.decimal);
    for (at, cell) in delimiter.cells(sheet.text()).enumerate() {
        match slots.get(at) {
            Some(None) => {}
            Some(Some(slot)) => match decimal.read(cell) {
                Cell::Word => return Err(Fault::Word(*slot, cell.to_owned())),
                value => collector.put(*slot, value),
            },
            // Marks at the end of a line stand before nothing.
            None if cell.is_empty() => {}
            None => return Err(Fault::Wide(delimiter.cells(sheet.text()).count())),
        }
    }
    Ok(())
}

impl Fault {
    /// The refusal of the row.
    fn told(&self, sheet: &Sheet<'_>, assigned: &[Assigned]) -> String {
        let delimiter = sheet.dialect.delimiter.name();
        match self {
            Self::Word(slot, cell) => {
                let one = assigned.get(*slot);
                let role = one.map_or("", |one| one.role.name);
                let name = one.map_or("", |one| one.name.as_str());
                let reason = sheet.dialect.decimal.finite(cell).err().unwrap_or_default();
                let column = if name == role {
                    role.to_owned()
                } else {
                    format!("{role} (`{name}`)")
                };
                format!(
                    "{column} is `{cell}`; {reason}; a value that is missing is empty or NaN, lines before \
                     the table are left out by --skip N, another column is named by --columns {role}=\"…\""
                )
            }
            Self::Wide(cells) => {
                let columns = columns(sheet);
                let is_doubled =
                    *cells > columns && sheet.dialect.delimiter == Delimiter::Mark(',');
                let cure = match is_doubled && sheet.dialect.decimal == Decimal::Point {
                    true => "if its numbers have decimal commas, part its columns by semicolons",
                    false => "give every row the columns of the header",
                };
                format!("{cells} cells between {delimiter} instead of {columns}; {cure}")
            }
        }
    }
}

/// The log of the collected rows; refused if most rows were dropped.
fn finish(collector: Collector, plan: Plan, sheet: Option<&Sheet<'_>>) -> Result<Log, String> {
    collector.check(&plan.assigned)?;
    let Collector {
        columns,
        lines,
        dropped,
        ..
    } = collector;
    let names = plan.assigned.iter().map(|one| one.role.name);
    let mut log = Log {
        columns: names.zip(columns).collect(),
        lines,
        ..Log::default()
    };
    log.dropped = DropReason::ALL
        .into_iter()
        .zip(dropped)
        .filter(|(_, count)| *count > 0)
        .collect();
    derivatives(&mut log, &plan.derived)?;
    let known = plan.assigned.iter().filter(|one| one.unit.is_some());
    log.units = known.map(|one| (one.role.name, one.si)).collect();
    log.understood = words::understood(&plan, sheet, &log.dropped);
    log.brief = words::brief(&plan, sheet, &log.dropped);
    Ok(log)
}
