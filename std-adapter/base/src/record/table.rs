//! Tables of comma-separated values, read row by row.
//!
//! The first line names the columns, which come in any order. Blank lines and lines that begin with `#` are left out;
//! blanks and quotation marks around a field are not part of it. Every refusal names the file and the line.

use super::lines::Lines;
use crate::scene::finite_number;
use std::io::{self, BufRead};
use std::path::Path;

/// A table that cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    /// The file cannot be opened or read.
    #[error("cannot read {file}: {reason}")]
    Access {
        /// Name of the file.
        file: String,
        /// What the system says.
        reason: String,
    },
    /// A line is wrong.
    #[error("{file}:{line}: {reason}")]
    Line {
        /// Name of the file.
        file: String,
        /// Line number, from 1.
        line: u64,
        /// What is wrong, and what would be valid.
        reason: String,
    },
}

/// Columns beside those that are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OtherColumns {
    /// The table has none.
    Refused,
    /// They are left out.
    Ignored,
}

/// The rows of a table, one after the other: no more than one line is held in memory.
#[allow(missing_debug_implementations)] // Sources have none.
pub struct Rows<'a> {
    lines: Lines<'a>,
    /// Names of the wanted columns, in the order of a row.
    names: &'static [&'static str],
    /// Place of each of them in a line.
    places: Vec<usize>,
    /// All columns of the table.
    header: Vec<String>,
    /// The fields of the row read last that are words, in the order of the names.
    words: Vec<String>,
    count: u64,
}

impl<'a> Rows<'a> {
    /// Opens a file and reads its header; `choose` says which columns a
    /// file with this header must have, and it may have no others.
    pub fn open(
        path: &Path,
        choose: impl FnOnce(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        Self::with(Lines::open(path)?, OtherColumns::Refused, choose)
    }

    /// The same of a file that a command line names: `-` is standard input.
    pub fn asked_for(
        path: &Path,
        choose: impl FnOnce(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        if path == Path::new("-") {
            return Self::of(path, io::stdin().lock(), OtherColumns::Refused, choose);
        }
        Self::open(path, choose)
    }

    /// The same of an open source with this name.
    pub fn of(
        name: &Path,
        source: impl BufRead + 'a,
        others: OtherColumns,
        choose: impl FnOnce(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        Self::with(Lines::of(name, Box::new(source)), others, choose)
    }

    fn with(
        mut lines: Lines<'a>,
        others: OtherColumns,
        choose: impl FnOnce(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        let header = lines.next()?.unwrap_or_default().to_owned();
        let header: Vec<&str> = fields(&header).collect();
        let names = choose(&header);
        let places = places(&header, names, others).map_err(|reason| lines.refusal(&reason))?;
        Ok(Self {
            lines,
            names,
            places,
            header: header.into_iter().map(Into::into).collect(),
            words: Vec::new(),
            count: 0,
        })
    }

    /// Reads the next row into `row`, a number for each of the first names; the other columns are words. Its line,
    /// or none at the end.
    pub fn next(&mut self, row: &mut [f64]) -> Result<Option<u64>, TableError> {
        let Some(line) = self.lines.next()? else {
            return match self.count {
                0 => Err(self.lines.refusal_at(
                    self.lines.number() + 1,
                    &format!(
                        "no rows; give one line of {} for each",
                        self.names.join(",")
                    ),
                )),
                _ => Ok(None),
            };
        };
        self.words.clear();
        let count = fields(line).count();
        let filled = if count == self.header.len() {
            fill(line, self.names, &self.places, row, &mut self.words)
        } else {
            Err(format!(
                "{count} columns instead of {}; give {}",
                self.header.len(),
                self.header.join(",")
            ))
        };
        filled.map_err(|reason| self.lines.refusal(&reason))?;
        self.count += 1;
        Ok(Some(self.lines.number()))
    }

    /// All rows of numbers, at most so many.
    pub fn all<const N: usize>(mut self, most: usize) -> Result<Vec<[f64; N]>, TableError> {
        let (mut all, mut row) = (Vec::new(), [0.0; N]);
        while self.next(&mut row)?.is_some() {
            all.push(row);
            if all.len() > most {
                return Err(self.refusal(&format!("more than {most} rows")));
            }
        }
        Ok(all)
    }

    /// Words of the row read last, in the order of the names.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The refusal of what stands in the line that was read last.
    pub fn refusal(&self, reason: &str) -> TableError {
        self.lines.refusal(reason)
    }
}

/// Where each name stands in the header; names that are missing, unknown or there twice are refused.
fn places(header: &[&str], names: &[&str], others: OtherColumns) -> Result<Vec<usize>, String> {
    let wanted = names.join(",");
    let found = names.iter().map(|name| {
        let place = header.iter().position(|head| head == name);
        place.ok_or_else(|| format!("column `{name}` is missing; the header must be {wanted}"))
    });
    let found = found.collect::<Result<Vec<usize>, String>>()?;
    for (at, head) in header.iter().enumerate() {
        if header[..at].contains(head) {
            return Err(format!(
                "column `{head}` occurs twice; the header must be {wanted}"
            ));
        }
        if others == OtherColumns::Refused && !names.contains(head) {
            return Err(format!(
                "unknown column `{head}`; the header must be {wanted}"
            ));
        }
    }
    Ok(found)
}

/// The numbers of a line in the order of the names, and then its words.
fn fill(
    line: &str,
    names: &[&str],
    places: &[usize],
    row: &mut [f64],
    words: &mut Vec<String>,
) -> Result<(), String> {
    words.resize(names.len().saturating_sub(row.len()), String::new());
    for (place, text) in fields(line).enumerate() {
        let Some(at) = places.iter().position(|known| *known == place) else {
            continue;
        };
        if let (Some(value), Some(name)) = (row.get_mut(at), names.get(at)) {
            *value = finite_number(text).map_err(|cure| format!("{name} is `{text}`; {cure}"))?;
        } else if let Some(word) = words.get_mut(at - row.len()) {
            word.push_str(text);
        }
    }
    Ok(())
}

/// The fields of a line without the blanks and the quotation marks around them.
fn fields(line: &str) -> impl Iterator<Item = &str> {
    let mut is_quoted = false;
    let fields = line.split(move |letter| {
        is_quoted ^= letter == '"';
        letter == ',' && !is_quoted
    });
    fields.map(|field| {
        let field = field.trim();
        let inside = field
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'));
        inside.map_or(field, str::trim)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_freed_of_blanks_and_quotation_marks() {
        let all: Vec<&str> = fields(" 1 ,\"2\",\"a,b\", \" 3\" ,").collect();
        assert_eq!(all, ["1", "2", "a,b", "3", ""]);
    }

    #[test]
    fn columns_come_in_any_order_and_faults_are_named_by_line() {
        let read = |text: &str| {
            let rows = Rows::of(
                Path::new("feet.csv"),
                text.as_bytes(),
                OtherColumns::Refused,
                |_| &["x", "y"],
            );
            let all = rows.and_then(|rows| rows.all(2));
            all.map_err(|refusal| refusal.to_string())
        };
        assert_eq!(read("# m\ny,x\n1, 2\n"), Ok(vec![[2.0, 1.0]]));
        for (text, reason) in [
            (
                "",
                "feet.csv:1: column `x` is missing; the header must be x,y",
            ),
            (
                "x,z\n1,2",
                "feet.csv:1: column `y` is missing; the header must be x,y",
            ),
            (
                "x,y,y\n1,2,3",
                "feet.csv:1: column `y` occurs twice; the header must be x,y",
            ),
            (
                "x,y,z\n1,2,3",
                "feet.csv:1: unknown column `z`; the header must be x,y",
            ),
            (
                "x,y\n1,2\n3",
                "feet.csv:3: 1 columns instead of 2; give x,y",
            ),
            (
                "x,y\n1,inf",
                "feet.csv:2: y is `inf`; give a finite number, not inf",
            ),
            (
                "x,y\n",
                "feet.csv:2: no rows; give one line of x,y for each",
            ),
            ("x,y\n1,2\n1,2\n1,2\n", "feet.csv:4: more than 2 rows"),
        ] {
            assert_eq!(read(text), Err(reason.to_owned()), "{text:?}");
        }
    }

    #[test]
    fn words_stand_beside_numbers_and_other_columns_are_left_out() -> Result<(), TableError> {
        let text = "color,name,x\nred,a,1\nblue,b,2\n";
        let mut rows = Rows::of(
            Path::new("a"),
            text.as_bytes(),
            OtherColumns::Ignored,
            |_| &["x", "name"],
        )?;
        let mut row = [0.0];
        assert_eq!(
            (rows.next(&mut row)?, row, rows.words()),
            (Some(2), [1.0], &["a".to_owned()][..])
        );
        assert_eq!(
            (rows.next(&mut row)?, row, rows.words()),
            (Some(3), [2.0], &["b".to_owned()][..])
        );
        assert_eq!(rows.next(&mut row)?, None);
        Ok(())
    }
}
