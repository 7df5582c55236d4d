//! The cells of a line and the numbers in them, as programs of several countries write them.

use crate::scene::finite_number;
use std::borrow::Cow;

/// What stands between the cells of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Delimiter {
    /// One such character.
    Mark(char),
    /// Any number of blanks.
    Blanks,
}

impl Delimiter {
    /// All of them, those first that rather stand between columns.
    pub const ALL: [Self; 5] = [
        Self::Mark('\t'),
        Self::Mark(';'),
        Self::Mark('|'),
        Self::Mark(','),
        Self::Blanks,
    ];

    /// Its name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mark('\t') => "tabs",
            Self::Mark(';') => "semicolons",
            Self::Mark('|') => "strokes",
            Self::Mark(',') => "commas",
            Self::Mark(_) => "marks",
            Self::Blanks => "blanks",
        }
    }

    /// The cells of a line, without the blanks and the quotation marks around them.
    pub fn cells(self, line: &str) -> Cells<'_> {
        let rest = match self {
            Self::Blanks => line.trim(),
            Self::Mark(_) => line,
        };
        let has_quotes = line.contains('"');
        Cells {
            delimiter: self,
            rest: Some(rest),
            has_quotes,
        }
    }
}

/// The cells of a line, one after the other.
#[derive(Debug)]
pub(super) struct Cells<'a> {
    delimiter: Delimiter,
    rest: Option<&'a str>,
    has_quotes: bool,
}

impl Cells<'_> {
    /// Whether a letter ends a cell.
    fn is_end(&self, letter: char) -> bool {
        match self.delimiter {
            Delimiter::Mark(mark) => letter == mark,
            Delimiter::Blanks => letter.is_whitespace(),
        }
    }

    /// Length of the first cell. Delimiters between quotation marks do not count.
    fn end_of(&self, rest: &str) -> Option<usize> {
        if !self.has_quotes {
            return match self.delimiter {
                Delimiter::Mark(mark) => rest.find(mark),
                Delimiter::Blanks => rest.find(char::is_whitespace),
            };
        }
        let mut is_quoted = false;
        rest.find(|letter| {
            is_quoted ^= letter == '"';
            !is_quoted && self.is_end(letter)
        })
    }
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest?;
        let cell = match self.end_of(rest) {
            Some(end) => {
                let (cell, behind) = rest.split_at(end);
                self.rest = match self.delimiter {
                    Delimiter::Mark(mark) => behind.get(mark.len_utf8()..),
                    Delimiter::Blanks => Some(behind.trim_start()),
                };
                cell
            }
            None => {
                self.rest = None;
                rest
            }
        };
        let cell = cell.trim();
        let inside = cell
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'));
        Some(inside.map_or(cell, str::trim))
    }
}

/// The mark before the decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Decimal {
    /// 1234.5, perhaps with commas between thousands.
    Point,
    /// 1234,5, perhaps with points between thousands.
    Comma,
}

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// A finite number.
    Number(f64),
    /// Nothing.
    Empty,
    /// A mark for a value that is not there, or an infinite one.
    Missing,
    /// Anything else.
    Word,
}

/// Marks that programs write in the place of a number, in small letters.
const MISSING: [&str; 26] = [
    "nan",
    "-nan",
    "+nan",
    "nan(ind)",
    "-nan(ind)",
    "1.#qnan",
    "1.#ind",
    "-1.#ind",
    "na",
    "n/a",
    "#n/a",
    "#nv",
    "null",
    "none",
    "-",
    "--",
    "---",
    "?",
    "#div/0!",
    "#value!",
    "#wert!",
    "#ref!",
    "#bezug!",
    "#num!",
    "#zahl!",
    "missing",
];
/// Digits of a group of a long number.
const GROUP: usize = 3;

impl Decimal {
    /// What a cell holds.
    pub fn read(self, cell: &str) -> Cell {
        if cell.is_empty() {
            return Cell::Empty;
        }
        if let Some(value) = self.number(cell) {
            return match value.is_finite() {
                true => Cell::Number(value),
                false => Cell::Missing,
            };
        }
        let is_missing = MISSING.iter().any(|mark| cell.eq_ignore_ascii_case(mark));
        if is_missing {
            Cell::Missing
        } else {
            Cell::Word
        }
    }

    /// The number in a cell, which may be infinite.
    pub fn number(self, cell: &str) -> Option<f64> {
        // Most cells are plain.
        let has_comma = cell.contains(',');
        if !has_comma
            && (self == Self::Point || !cell.contains('.'))
            && let Ok(value) = cell.parse::<f64>()
        {
            return Some(value).filter(|value| !value.is_nan());
        }
        let value: f64 = self.pointed(cell)?.parse().ok()?;
        Some(value).filter(|value| value.is_finite())
    }

    /// A finite number, or why a text is none and what to write instead.
    pub fn finite(self, cell: &str) -> Result<f64, String> {
        match self.number(cell) {
            Some(value) if value.is_finite() => Ok(value),
            _ if self == Self::Comma && cell.contains('.') => {
                Err("other numbers of the file have decimal commas; write a decimal comma".into())
            }
            _ => finite_number(cell),
        }
    }

    /// The cell with a decimal point and without marks between thousands; none if these stand at other places.
    fn pointed(self, cell: &str) -> Option<Cow<'_, str>> {
        let cell = plain_letters(cell);
        let [mark, group] = match self {
            Self::Point => ['.', ','],
            Self::Comma => [',', '.'],
        };
        let is_group =
            |letter: char| letter == group || matches!(letter, '\'' | '\u{a0}' | '\u{202f}');
        let mantissa = cell
            .find(['e', 'E'])
            .map_or(&*cell, |at| cell.get(..at).unwrap_or_default());
        let whole = mantissa.split(mark).next().unwrap_or_default();
        let decimals = mantissa.get(whole.len()..).unwrap_or_default();
        if whole.contains(is_group) {
            let mut groups = whole.trim_start_matches(['+', '-']).split(is_group);
            let first = groups.next().unwrap_or_default();
            let is_first = (1..=GROUP).contains(&first.len()) && !first.starts_with('0');
            if !is_first || !groups.all(|group| group.len() == GROUP) {
                return None;
            }
        }
        if decimals.contains(is_group) || decimals.matches(mark).count() > 1 {
            return None;
        }
        // A comma that ends a text stands between cells, not before decimals.
        if self == Self::Comma && decimals == "," {
            return None;
        }
        let letters = cell.chars().filter(|letter| !is_group(*letter));
        let pointed = letters.map(|letter| if letter == mark { '.' } else { letter });
        Some(Cow::Owned(pointed.collect()))
    }
}

/// The minus of typesetters and the D of Fortran as programs write them.
fn plain_letters(cell: &str) -> Cow<'_, str> {
    let is_fortran = |letter| matches!(letter, 'd' | 'D');
    if !cell.contains(is_fortran) && cell.is_ascii() {
        return Cow::Borrowed(cell);
    }
    Cow::Owned(cell.replace(is_fortran, "e").replace('\u{2212}', "-"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_freed_of_blanks_and_quotation_marks() {
        let cells = |mark: char, line| Delimiter::Mark(mark).cells(line).collect::<Vec<_>>();
        assert_eq!(
            cells(',', " 1 ,\"2\",\"a,b\", \" 3\" ,"),
            ["1", "2", "a,b", "3", ""]
        );
        assert_eq!(cells(';', "1;;2"), ["1", "", "2"]);
        let blanks = |line| Delimiter::Blanks.cells(line).collect::<Vec<_>>();
        assert_eq!(blanks("  1  2\t3 "), ["1", "2", "3"]);
        assert_eq!(blanks("\"v [mm/s]\" f"), ["v [mm/s]", "f"]);
    }

    #[test]
    fn numbers_of_both_decimal_marks_are_read_and_other_texts_are_not() {
        use Decimal::{Comma, Point};
        for (decimal, text, value) in [
            (Point, "1.5", Some(1.5)),
            (Point, "1,234.5", Some(1234.5)),
            (Point, "-12,345,678", Some(-12_345_678.0)),
            (Point, "1'234.5", Some(1234.5)),
            (Point, "1.5D+02", Some(150.0)),
            (Point, "\u{2212}1.5", Some(-1.5)),
            (Point, "1,5", None),
            (Point, "0,125", None),
            (Point, "1.234,5", None),
            (Point, "1.2.3", None),
            (Point, "1.234,567", None),
            (Comma, "1,5", Some(1.5)),
            (Comma, "1.234,5", Some(1234.5)),
            (Comma, "1.234", Some(1234.0)),
            (Comma, "1\u{a0}234,5", Some(1234.5)),
            (Comma, "-1,5e-3", Some(-1.5e-3)),
            (Comma, ",5", Some(0.5)),
            (Comma, "0.125", None),
            (Comma, "12.5", None),
            (Comma, "1,", None),
            (Comma, "1,2,3", None),
            (Comma, "7", Some(7.0)),
            (Point, "12:30", None),
            (Point, "2024-01-05", None),
            (Point, "", None),
            (Point, "d", None),
        ] {
            assert_eq!(decimal.number(text), value, "{decimal:?} {text}");
        }
        for text in ["NaN", "#N/A", "inf", "-", "NULL", "#DIV/0!"] {
            assert_eq!(Point.read(text), Cell::Missing, "{text}");
        }
        assert_eq!(
            [Point.read(""), Point.read("off")],
            [Cell::Empty, Cell::Word]
        );
    }
}
