//! A first look at a log: what is understood, the columns and their ranges, the first rows.

use super::words::table;
use super::{LogOptions, LogRole, open, plan};
use crate::record::cells::Cell;
use crate::record::lines::Lines;
use crate::record::sheet::Sheet;
use crate::record::table::TableError;
use crate::record::{brief, json_number};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::io::BufRead;
use std::path::Path;

/// Rows that are shown.
const SHOWN: usize = 5;
/// Widest cell of the text, in letters.
const WIDEST: usize = 24;

/// A column of a log.
#[derive(Clone, Debug, PartialEq)]
pub struct LookColumn {
    /// Its heading; empty without one.
    pub name: String,
    /// The role for which it would be read.
    pub role: Option<&'static str>,
    /// Its unit in the file or the options.
    pub unit: Option<String>,
    /// Cells with a number.
    pub numbers: u64,
    /// Cells with nothing, or with a mark for it.
    pub missing: u64,
    /// Cells with something else.
    pub words: u64,
    /// Smallest and largest number as they stand in the file; none without numbers.
    pub range: Option<[f64; 2]>,
}

/// What a log would be read as.
#[derive(Clone, Debug, PartialEq)]
pub struct LogPreview {
    /// What is understood, a line for each part.
    pub understood: Vec<String>,
    /// Why the log could not be read with these options.
    pub trouble: Option<String>,
    /// The columns from the left.
    pub columns: Vec<LookColumn>,
    /// The cells of the first rows.
    pub first: Vec<Vec<String>>,
    /// Number of rows.
    pub rows: u64,
}

/// Looks at a file, or at standard input for `-`.
pub fn look(
    path: &Path,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<LogPreview, TableError> {
    of(Lines::asked_for(path)?, roles, options)
}

/// Looks at an open source with this name.
pub fn look_from<'a>(
    name: &Path,
    source: impl BufRead + 'a,
    roles: &[LogRole],
    options: &LogOptions,
) -> Result<LogPreview, TableError> {
    of(Lines::of(name, Box::new(source)), roles, options)
}

fn of(lines: Lines<'_>, roles: &[LogRole], options: &LogOptions) -> Result<LogPreview, TableError> {
    let mut sheet = open(lines, roles, options)?;
    let width = super::columns(&sheet);
    let mut look = LogPreview {
        understood: table(&sheet),
        trouble: None,
        columns: columns(&sheet, width),
        first: Vec::new(),
        rows: 0,
    };
    match plan(&sheet.headings, width, roles, options) {
        Ok(plan) => {
            for one in &plan.assigned {
                if let Some(column) = look.columns.get_mut(one.column) {
                    column.role = Some(one.role.name);
                    column.unit = one.unit.clone().or(column.unit.take());
                }
            }
            let made = plan.derived.iter();
            look.understood.extend(
                made.map(|(role, _, source)| format!("{} by differences of `{source}`", role.name)),
            );
            look.understood.extend(plan.remarks);
        }
        Err(why) => look.trouble = Some(why),
    }
    while sheet.advance()? {
        look.add(&sheet);
    }
    Ok(look)
}

/// The columns before a row was read.
fn columns(sheet: &Sheet<'_>, width: usize) -> Vec<LookColumn> {
    let column = |at: usize| {
        let heading = sheet.headings.get(at);
        LookColumn {
            name: heading.map_or(String::new(), |heading| heading.text.clone()),
            role: None,
            unit: heading.and_then(|heading| heading.unit.clone()),
            numbers: 0,
            missing: 0,
            words: 0,
            range: None,
        }
    };
    (0..width).map(column).collect()
}

impl LogPreview {
    /// Counts a row.
    fn add(&mut self, sheet: &Sheet<'_>) {
        self.rows += 1;
        let (delimiter, decimal) = (sheet.dialect.delimiter, sheet.dialect.decimal);
        let cells = || delimiter.cells(sheet.text());
        if self.first.len() < SHOWN {
            self.first.push(cells().map(Into::into).collect());
        }
        for (column, cell) in self.columns.iter_mut().zip(cells()) {
            match decimal.read(cell) {
                Cell::Number(value) => {
                    column.numbers += 1;
                    let [low, high] = column.range.unwrap_or([value; 2]);
                    column.range = Some([low.min(value), high.max(value)]);
                }
                Cell::Empty | Cell::Missing => column.missing += 1,
                Cell::Word => column.words += 1,
            }
        }
    }

    /// The look for people: parts in lines, columns and first rows as tables.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (at, line) in self.understood.iter().enumerate() {
            let name = if at == 0 { "file" } else { "" };
            let _ = writeln!(text, "{name:<14}{line}");
        }
        let _ = writeln!(text, "{:<14}{}", "rows", self.rows);
        if let Some(trouble) = &self.trouble {
            let _ = writeln!(text, "{:<14}{trouble}", "trouble");
        }
        let head = [
            "column", "name", "role", "unit", "numbers", "smallest", "largest", "others",
        ];
        let mut rows = vec![head.map(String::from).to_vec()];
        rows.extend(
            self.columns
                .iter()
                .enumerate()
                .map(|(at, column)| column.row(at + 1)),
        );
        text += "\n";
        text += &aligned(&rows);
        text += "\nfirst rows\n";
        text += &aligned(&self.first);
        text
    }

    /// The look as JSON.
    pub fn json(&self) -> Value {
        let columns = self.columns.iter().map(|column| {
            let [low, high] = column
                .range
                .map_or([Value::Null, Value::Null], |range| range.map(json_number));
            json!({
                "name": column.name,
                "role": column.role,
                "unit": column.unit,
                "numbers": column.numbers,
                "missing": column.missing,
                "words": column.words,
                "min": low,
                "max": high,
            })
        });
        json!({
            "understood": self.understood,
            "trouble": self.trouble,
            "rows": self.rows,
            "columns": columns.collect::<Vec<_>>(),
            "first": self.first,
        })
    }
}

impl LookColumn {
    /// The cells of its row.
    fn row(&self, number: usize) -> Vec<String> {
        let [low, high] = self.range.map_or([String::new(), String::new()], |range| {
            range.map(|x| brief(&x))
        });
        let others = [(self.missing, "missing"), (self.words, "words")];
        let others = others.iter().filter(|(count, _)| *count > 0);
        let others: Vec<String> = others
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        vec![
            number.to_string(),
            self.name.clone(),
            self.role.unwrap_or("").into(),
            self.unit.clone().unwrap_or_default(),
            self.numbers.to_string(),
            low,
            high,
            others.join(", "),
        ]
    }
}

/// Rows in columns of equal width.
fn aligned(rows: &[Vec<String>]) -> String {
    let count = rows.iter().map(Vec::len).max().unwrap_or_default();
    let cut = |cell: &str| cell.chars().take(WIDEST).collect::<String>();
    let width = |at: usize| {
        let cells = rows.iter().filter_map(|row| row.get(at));
        cells
            .map(|cell| cut(cell).chars().count())
            .max()
            .unwrap_or_default()
    };
    let widths: Vec<usize> = (0..count).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells = row
            .iter()
            .zip(&widths)
            .map(|(cell, width)| format!("{:<width$}", cut(cell)));
        let line = cells.collect::<Vec<_>>().join("  ");
        let _ = writeln!(text, "  {}", line.trim_end());
    }
    text
}
