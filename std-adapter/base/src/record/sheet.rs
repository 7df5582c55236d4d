//! A table whose dialect was found, line by line.

use super::cells::Decimal;
use super::dialect::{Dialect, HeadLine, WordsBelow};
use super::heading::{Heading, without_brackets};
use super::lines::Lines;
use super::table::TableError;

/// Lines from which the dialect is found.
const HEAD: usize = 120;

/// A table whose dialect was found. The first lines and one more are held in memory.
pub(super) struct Sheet<'a> {
    lines: Lines<'a>,
    head: Vec<HeadLine>,
    /// Place in the head of the next line; behind it the lines follow.
    next: usize,
    /// Place in the head of the row, if it stands there.
    current: Option<usize>,
    number: u64,
    pub dialect: Dialect,
    /// Names and units of the columns; none without a header.
    pub headings: Vec<Heading>,
    /// Cells of the first row.
    pub width: usize,
}

impl<'a> Sheet<'a> {
    /// Reads the first lines behind `skip` of them; `known` counts the names of a header that are known. Where a header is
    /// among the lines that are left out, and none behind them, it names the columns all the same.
    pub fn open(
        mut lines: Lines<'a>,
        skip: u64,
        below: WordsBelow,
        known: &mut dyn FnMut(&[&str]) -> usize,
    ) -> Result<Self, TableError> {
        let (mut head, mut before) = (Vec::new(), Vec::new());
        while head.len() < HEAD {
            let Some(is_comment) = lines.advance()? else {
                break;
            };
            let (number, text) = (lines.number(), lines.text().to_owned());
            let line = HeadLine {
                number,
                text,
                is_comment,
            };
            if number > skip {
                head.push(line);
            } else if before.len() < HEAD {
                before.push(line);
            }
        }
        let dialect = Dialect::of(&head, below, known);
        let cells = |line: &HeadLine| dialect.delimiter.cells(&line.text).count();
        let width = head
            .iter()
            .skip(dialect.first)
            .find(|line| !line.is_comment);
        let width = width.map_or(0, cells);
        let mut headings = headings(&head, &dialect, width);
        if headings.is_empty() && !before.is_empty() {
            headings = headings_before(before, &head, (&dialect, width), below, known);
        }
        Ok(Self {
            lines,
            next: dialect.first,
            current: None,
            head,
            number: 0,
            dialect,
            headings,
            width,
        })
    }

    /// Goes to the next row; false at the end.
    pub fn advance(&mut self) -> Result<bool, TableError> {
        while let Some(line) = self.head.get(self.next) {
            self.next += 1;
            if !line.is_comment {
                self.number = line.number;
                self.current = Some(self.next - 1);
                return Ok(true);
            }
        }
        self.current = None;
        let has_row = self.lines.next()?.is_some();
        self.number = self.lines.number();
        Ok(has_row)
    }

    /// The row.
    pub fn text(&self) -> &str {
        let kept = self.current.and_then(|at| self.head.get(at));
        kept.map_or_else(|| self.lines.text(), |line| line.text.as_str())
    }

    /// Number of the row's line, from 1.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// Line of the header, or of the first line.
    pub fn header_line(&self) -> u64 {
        let header = self.dialect.header.or(Some(0));
        self.line_of(header).unwrap_or(1)
    }

    /// Line of the units.
    pub fn units_line(&self) -> Option<u64> {
        self.line_of(self.dialect.units)
    }

    fn line_of(&self, at: Option<usize>) -> Option<u64> {
        at.and_then(|at| self.head.get(at)).map(|line| line.number)
    }

    /// Whether the row repeats the header or the units.
    pub fn is_header_again(&self) -> bool {
        let kept = [self.dialect.header, self.dialect.units];
        let mut kept = kept
            .into_iter()
            .flatten()
            .filter_map(|at| self.head.get(at));
        kept.any(|line| line.text == self.text())
    }

    /// Lines before the header or the first row that hold neither.
    pub fn left_out(&self) -> usize {
        let before = self.dialect.header.unwrap_or(self.dialect.first);
        let lines = self.head.iter().take(before);
        lines.filter(|line| !line.is_comment).count()
    }

    /// Words for a dialect other than that of the tables that Tribos writes.
    pub fn differences(&self) -> Vec<String> {
        let dialect = &self.dialect;
        let mut words: Vec<String> = self.lines.encoding().map(Into::into).into_iter().collect();
        if dialect.delimiter != super::cells::Delimiter::Mark(',') {
            words.push(dialect.delimiter.name().into());
        }
        if dialect.decimal == Decimal::Comma {
            words.push("decimal commas".into());
        }
        match self.left_out() {
            0 => {}
            1 => words.push("1 line before the header".into()),
            count => words.push(format!("{count} lines before the header")),
        }
        if self.headings.is_empty() {
            words.push("no header".into());
        }
        words
    }

    /// Words for an encoding other than UTF-8.
    pub fn encoding(&self) -> Option<&'static str> {
        self.lines.encoding()
    }

    /// Name of the source.
    pub fn name(&self) -> String {
        self.lines.name()
    }

    /// The refusal of the row that was read last.
    pub fn refusal(&self, reason: &str) -> TableError {
        self.refusal_at(self.number.max(1), reason)
    }

    /// The refusal of what stands in a line.
    pub fn refusal_at(&self, line: u64, reason: &str) -> TableError {
        self.lines.refusal_at(line, reason)
    }
}

/// Names and units of the columns from lines that are left out, if a header of as many columns is among them.
fn headings_before(
    mut before: Vec<HeadLine>,
    head: &[HeadLine],
    (dialect, width): (&Dialect, usize),
    below: WordsBelow,
    known: &mut dyn FnMut(&[&str]) -> usize,
) -> Vec<Heading> {
    before.extend(head.iter().cloned());
    let whole = Dialect::of(&before, below, known);
    let found = headings(&before, &whole, width);
    if whole.delimiter == dialect.delimiter && found.len() == width {
        found
    } else {
        Vec::new()
    }
}

/// Names and units of the columns, the units from the line of units where it has one.
fn headings(head: &[HeadLine], dialect: &Dialect, width: usize) -> Vec<Heading> {
    let line = |at: Option<usize>| at.and_then(|at| head.get(at));
    let Some(header) = line(dialect.header) else {
        return Vec::new();
    };
    let names = dialect.names(&header.text, width);
    let mut headings: Vec<Heading> = names.into_iter().map(Heading::of).collect();
    if let Some(units) = line(dialect.units) {
        let units = dialect.names(&units.text, headings.len());
        for (heading, unit) in headings.iter_mut().zip(units) {
            let unit = without_brackets(unit);
            if !unit.is_empty() {
                heading.unit = Some(unit.to_owned());
            }
        }
    }
    headings
}
