//! Tables of numbers, read row by row.
//!
//! A line names the columns, which come in any order. What stands between cells, the decimal mark and lines before the
//! header are found from the first lines. Blank lines and lines that begin with `#` are left out;
//! blanks and quotation marks around a cell are not part of it. Every refusal names the file and the line.

use super::cells::Decimal;
use super::dialect::WordsBelow;
use super::heading::Heading;
use super::lines::Lines;
use super::log::{LogOptions, rename};
use super::sheet::Sheet;
use super::units::any_unit;
use std::io::BufRead;
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
    /// The file as a whole is wrong, or what was asked of it.
    #[error("{file}: {reason}")]
    Whole {
        /// Name of the file.
        file: String,
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
    sheet: Sheet<'a>,
    /// Names of the wanted columns, in the order of a row.
    names: &'static [&'static str],
    /// Place of each of them in a line, and the size of its unit.
    places: Vec<(usize, f64)>,
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
        choose: impl FnMut(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        Self::with(
            Lines::open(path)?,
            OtherColumns::Refused,
            &LogOptions::default(),
            choose,
        )
    }

    /// The same of a file that a command line names: `-` is standard input.
    pub fn asked_for(
        path: &Path,
        choose: impl FnMut(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        Self::with_options(path, &LogOptions::default(), choose)
    }

    /// The same, with what a user says of columns and units, whose roles are the names of the columns. Where columns are
    /// named, the file may have others.
    pub fn with_options(
        path: &Path,
        options: &LogOptions,
        choose: impl FnMut(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        let others = match options.columns.0.is_empty() {
            true => OtherColumns::Refused,
            false => OtherColumns::Ignored,
        };
        Self::with(Lines::asked_for(path)?, others, options, choose)
    }

    /// The same of an open source with this name.
    pub fn of(
        name: &Path,
        source: impl BufRead + 'a,
        others: OtherColumns,
        choose: impl FnMut(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        Self::with(
            Lines::of(name, Box::new(source)),
            others,
            &LogOptions::default(),
            choose,
        )
    }

    fn with(
        lines: Lines<'a>,
        others: OtherColumns,
        options: &LogOptions,
        mut choose: impl FnMut(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, TableError> {
        let mut known = |header: &[&str]| {
            let headings: Vec<Heading> = header.iter().map(|text| Heading::of(text)).collect();
            let header = both(headings.iter());
            let names = choose(&header);
            let is_wanted = |name: &&&str| header.contains(*name);
            names.iter().filter(is_wanted).count() + options.named_in(&headings)
        };
        let mut sheet = Sheet::open(lines, options.skip, WordsBelow::Rows, &mut known)?;
        let at = sheet.header_line();
        if sheet.headings.is_empty() && options.columns.0.is_empty() {
            // The first line is taken for a header that misses the names.
            let first = if sheet.advance()? { sheet.text() } else { "" };
            sheet.headings = sheet
                .dialect
                .delimiter
                .cells(first)
                .map(Heading::of)
                .collect();
        }
        let renamed = rename(&mut sheet.headings, sheet.width, options);
        renamed.map_err(|reason| sheet.refusal_at(at, &reason))?;
        let names = choose(&both(sheet.headings.iter()));
        let header: Vec<&str> = sheet
            .headings
            .iter()
            .map(|heading| named(heading, names))
            .collect();
        let refused = |reason: String| sheet.refusal_at(at, &reason);
        let places = places(&header, names, others).map_err(refused)?;
        let has_units = sheet.units_line().is_some();
        let sized = places.into_iter().map(|place| {
            let heading = sheet.headings.get(place);
            // An ending such as _deg of a wanted name is part of it.
            let is_apart = |heading: &&Heading| {
                has_units || heading.is_negated || !names.contains(&&*heading.text)
            };
            let heading = heading.filter(is_apart);
            let size = heading.map_or(Ok(1.0), size).map_err(refused)?;
            Ok((place, size))
        });
        let places = sized.collect::<Result<Vec<_>, TableError>>()?;
        let header = header.into_iter().map(Into::into).collect();
        Ok(Self {
            sheet,
            names,
            places,
            header,
            words: Vec::new(),
            count: 0,
        })
    }

    /// Reads the next row into `row`, a number for each of the first names; the other columns are words. Its line,
    /// or none at the end.
    pub fn next(&mut self, row: &mut [f64]) -> Result<Option<u64>, TableError> {
        if !self.sheet.advance()? {
            return match self.count {
                0 => Err(self.sheet.refusal_at(
                    self.sheet.number() + 1,
                    &format!(
                        "no rows; give one line of {} for each",
                        self.names.join(",")
                    ),
                )),
                _ => Ok(None),
            };
        }
        let (dialect, line) = (self.sheet.dialect, self.sheet.text());
        self.words.clear();
        let cells = || dialect.delimiter.cells(line);
        let count = cells().count();
        let filled = if count == self.header.len() {
            let target = (&mut *row, &mut self.words);
            fill(cells(), dialect.decimal, (self.names, &self.places), target)
        } else {
            Err(format!(
                "{count} columns instead of {}; give {}",
                self.header.len(),
                self.header.join(",")
            ))
        };
        filled.map_err(|reason| self.sheet.refusal(&reason))?;
        self.count += 1;
        Ok(Some(self.sheet.number()))
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
        self.sheet.refusal(reason)
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
        if head.is_empty() {
            continue;
        }
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
fn fill<'a>(
    cells: impl Iterator<Item = &'a str>,
    decimal: Decimal,
    (names, places): (&[&str], &[(usize, f64)]),
    (row, words): (&mut [f64], &mut Vec<String>),
) -> Result<(), String> {
    words.resize(names.len().saturating_sub(row.len()), String::new());
    for (place, text) in cells.enumerate() {
        let Some(at) = places.iter().position(|(known, _)| *known == place) else {
            continue;
        };
        let size = places.get(at).map_or(1.0, |(_, size)| *size);
        if let (Some(value), Some(name)) = (row.get_mut(at), names.get(at)) {
            let number = decimal.finite(text);
            *value = size * number.map_err(|cure| format!("{name} is `{text}`; {cure}"))?;
        } else if let Some(word) = words.get_mut(at - row.len()) {
            word.push_str(text);
        }
    }
    Ok(())
}

/// Texts of headings, and their names without units.
fn both<'a>(headings: impl Iterator<Item = &'a Heading>) -> Vec<&'a str> {
    headings
        .flat_map(|heading| [&*heading.text, &*heading.name])
        .collect()
}

/// The name of a column: without its unit if it is wanted so.
fn named<'a>(heading: &'a Heading, names: &[&str]) -> &'a str {
    let is_wanted = |name: &str| names.contains(&name);
    match !is_wanted(&heading.text) && is_wanted(&heading.name) {
        true => &heading.name,
        false => &heading.text,
    }
}

/// Size of the unit of a heading in SI.
fn size(heading: &Heading) -> Result<f64, String> {
    let sign = if heading.is_negated { -1.0 } else { 1.0 };
    let Some(unit) = &heading.unit else {
        return Ok(sign);
    };
    any_unit(unit).map(|(_, size)| sign * size).ok_or_else(|| {
        format!(
            "the unit `{unit}` of column `{}` is not known; give SI units, or no unit",
            heading.text
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn tables_of_other_dialects_and_units_are_the_same_tables() {
        let read = |text: &str| {
            let columns: &'static [&'static str] = &["x", "y_deg"];
            let rows = Rows::of(
                Path::new("feet.csv"),
                text.as_bytes(),
                OtherColumns::Refused,
                |_| columns,
            );
            rows.and_then(|rows| rows.all(9))
                .map_err(|refusal| refusal.to_string())
        };
        for text in [
            "y_deg;x\n1,5;2\n-3;4e-1\n",
            "made by hand\nx [mm]\ty_deg\n2000\t1.5\n400\t-3\n",
            "x y_deg\n2 1.5\n0.4 -3\n",
            "x,y_deg\nmm,-\n2000,1.5\n400,-3\n",
            "# x,y_deg\n2,1.5\n0.4,-3\n",
        ] {
            assert_eq!(read(text), Ok(vec![[2.0, 1.5], [0.4, -3.0]]), "{text}");
        }
        for (text, reason) in [
            (
                "x;y_deg\n1,5;\n",
                "feet.csv:2: y_deg is ``; give a number such as 0.5 or 1e-3",
            ),
            (
                "x [yard],y_deg\n1,2\n",
                "feet.csv:1: the unit `yard` of column `x [yard]` is not known; give SI units, or no unit",
            ),
            (
                "1;2\n3;4\n",
                "feet.csv:1: column `x` is missing; the header must be x,y_deg",
            ),
        ] {
            assert_eq!(read(text), Err(reason.to_owned()), "{text:?}");
        }
    }

    #[test]
    fn columns_and_units_are_as_the_options_say() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let file = folder.path().join("pushes.txt");
        let read = |text: &str,
                    columns: &str,
                    units: &str,
                    skip|
         -> Result<_, Box<dyn std::error::Error>> {
            std::fs::write(&file, text)?;
            let mut options = LogOptions {
                skip,
                ..LogOptions::default()
            };
            if !columns.is_empty() {
                options.columns = columns.parse()?;
            }
            if !units.is_empty() {
                options.units = units.parse()?;
            }
            let rows = Rows::with_options(&file, &options, |_| &["fx", "fy"]);
            let told = |refusal: TableError| refusal.to_string();
            Ok(rows.and_then(|rows| rows.all::<2>(9)).map_err(told))
        };
        for (text, columns, units, skip) in [
            ("fy;n;fx\n1,5;7;2\n", "fx=fx", "", 0),
            ("a;b [mN]\n2;1500\n", "fx=a,fy=b", "", 0),
            ("fy,fx\n2,1.5\n", "fx=fy,fy=fx", "", 0),
            ("9 9 9\n-0.002 0 1.5\n", "fx=-1,fy=3", "fx=kN", 1),
        ] {
            assert_eq!(
                read(text, columns, units, skip)?,
                Ok(vec![[2.0, 1.5]]),
                "{text}"
            );
        }
        let refused = read("fx,fy\n1,2\n", "", "fx=yard", 0)?
            .err()
            .unwrap_or_default();
        assert!(
            refused.ends_with("pushes.txt:1: --units fx: the unit `yard` is not known"),
            "{refused}"
        );
        let refused = read("fx,fy\n1,2\n", "fx=Fx2", "", 0)?
            .err()
            .unwrap_or_default();
        assert!(
            refused.contains(
                ":1: --columns fx: there is no column `Fx2`; the columns are 1 `fx`, 2 `fy`"
            ),
            "{refused}"
        );
        Ok(())
    }

    #[test]
    fn columns_of_words_do_not_hide_the_delimiter() -> Result<(), TableError> {
        // More numbers stand between blanks than between commas.
        let text =
            "place,verdict,what,why,n\np 4 1,ok,a 1 2 3 4; 5,1 2 3,7\np 4 2,no,b 1 2 3 4; 5,n,8\n";
        let columns: &'static [&'static str] = &["n", "place"];
        let rows = Rows::of(
            Path::new("a"),
            text.as_bytes(),
            OtherColumns::Ignored,
            |_| columns,
        );
        let mut rows = rows?;
        let mut row = [0.0];
        assert_eq!(
            (rows.next(&mut row)?, row, rows.words()),
            (Some(2), [7.0], &["p 4 1".to_owned()][..])
        );
        Ok(())
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
