//! CSV files with a fixed set of numeric columns, read row by row.

use super::lines::Lines;
use super::number;
use crate::failure::Failure;
use std::path::Path;

/// Reads the rows of a file that has these columns, in any order, and no others (`-` for standard
/// input); every refusal names the file and the line.
pub fn read<const N: usize>(
    path: &Path,
    columns: &'static [&'static str; N],
) -> Result<Vec<[f64; N]>, Failure> {
    let mut rows = Rows::open(path, |_| columns)?;
    let mut all = Vec::new();
    let mut row = [0.0; N];
    while rows.next(&mut row)?.is_some() {
        all.push(row);
    }
    Ok(all)
}

/// The rows of a file, one after the other: no more than one line is held in memory.
pub struct Rows {
    lines: Lines,
    /// Names of the columns, in the order of a row.
    names: &'static [&'static str],
    /// Place of each of them in a line.
    places: Vec<usize>,
    count: u64,
}

impl Rows {
    /// Opens a file (`-` for standard input) and reads its header; `choose` says which columns a
    /// file with this header must have.
    pub fn open(
        path: &Path,
        choose: impl FnOnce(&[&str]) -> &'static [&'static str],
    ) -> Result<Self, Failure> {
        let mut lines = Lines::open(path)?;
        let header = lines.next()?.unwrap_or_default().to_owned();
        let header: Vec<&str> = fields(&header).collect();
        let names = choose(&header);
        let places = places(&header, names).map_err(|message| lines.refusal(&message))?;
        Ok(Self {
            lines,
            names,
            places,
            count: 0,
        })
    }

    /// Reads the next row into `row`, a number for each name: its line, or none at the end.
    pub fn next(&mut self, row: &mut [f64]) -> Result<Option<u64>, Failure> {
        let wanted = self.names;
        let Some(line) = self.lines.next()? else {
            return match self.count {
                0 => Err(self.lines.refusal_at(
                    self.lines.number() + 1,
                    &format!("no rows; give one line of {} for each", wanted.join(",")),
                )),
                _ => Ok(None),
            };
        };
        let filled = fill(line, wanted, &self.places, row);
        filled.map_err(|message| self.lines.refusal(&message))?;
        self.count += 1;
        Ok(Some(self.lines.number()))
    }

    /// The refusal of what stands in the line that was read last.
    pub fn refusal(&self, message: &str) -> Failure {
        self.lines.refusal(message)
    }
}

/// Where each name stands in the header; names that are missing, unknown or there twice are refused.
fn places(header: &[&str], names: &[&str]) -> Result<Vec<usize>, String> {
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
        if !names.contains(head) {
            return Err(format!(
                "unknown column `{head}`; the header must be {wanted}"
            ));
        }
    }
    Ok(found)
}

/// The numbers of a line in the order of the names.
fn fill(line: &str, names: &[&str], places: &[usize], row: &mut [f64]) -> Result<(), String> {
    let count = fields(line).count();
    if count != names.len() {
        return Err(format!(
            "{count} columns instead of {}; give {}",
            names.len(),
            names.join(",")
        ));
    }
    for (place, text) in fields(line).enumerate() {
        let Some(at) = places.iter().position(|known| *known == place) else {
            continue;
        };
        if let (Some(value), Some(name)) = (row.get_mut(at), names.get(at)) {
            *value = number::finite(text).map_err(|cure| format!("{name} is `{text}`; {cure}"))?;
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
    fn columns_come_in_any_order_and_each_of_them_once() {
        let names = ["speed", "spin"];
        assert_eq!(places(&["spin", "speed"], &names), Ok(vec![1, 0]));
        for (header, words) in [
            (&["speed"][..], "`spin` is missing"),
            (&["speed", "spin", "speed"], "`speed` occurs twice"),
            (&["speed", "spin", "spam", "spam"], "unknown column `spam`"),
        ] {
            let refused = places(header, &names).err().unwrap_or_default();
            assert!(refused.contains(words), "{refused}");
        }
        let mut row = [0.0; 2];
        assert_eq!(fill("1, 2", &names, &[1, 0], &mut row), Ok(()));
        assert_eq!(row, [2.0, 1.0]);
    }
}
