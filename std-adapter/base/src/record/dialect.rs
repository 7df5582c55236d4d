//! How a table is written: what stands between cells, the decimal mark, where header and units are. Found from the
//! first lines.

use super::cells::{Cell, Decimal, Delimiter};
use super::heading::without_brackets;
use super::units::any_unit;

/// A line from which the dialect is found.
#[derive(Clone, Debug)]
pub(super) struct HeadLine {
    pub number: u64,
    pub text: String,
    pub is_comment: bool,
}

/// What is done with lines of words between the header and the first numbers that are no units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WordsBelow {
    /// They are rows, and refused as such.
    Rows,
    /// They are left out.
    LeftOut,
}

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dialect {
    pub delimiter: Delimiter,
    pub decimal: Decimal,
    /// Places in the first lines of the header, the units and the first row.
    pub header: Option<usize>,
    pub units: Option<usize>,
    pub first: usize,
}

/// Points of a number in a line; a word has one less.
const NUMBER: usize = 2;
/// Rows at the end of the first lines that tell which columns hold numbers.
const SHOWN: usize = 5;
/// Words in the first cell of a line of units.
const UNIT_WORDS: [&str; 4] = ["unit", "units", "einheit", "einheiten"];

/// Letters before the names in a header that is a comment.
const COMMENT_MARKS: [char; 4] = ['#', '%', ' ', '\t'];

impl Dialect {
    /// From the first lines; `known` counts the names of a header that are known.
    pub fn of(
        head: &[HeadLine],
        below: WordsBelow,
        known: &mut dyn FnMut(&[&str]) -> usize,
    ) -> Self {
        let declared = head.first().and_then(|line| declared(&line.text));
        let (delimiter, decimal) = shape(head, declared, known);
        let rows: Vec<Vec<Cell>> = head
            .iter()
            .map(|line| match line.is_comment {
                true => Vec::new(),
                false => delimiter
                    .cells(&line.text)
                    .map(|cell| decimal.read(cell))
                    .collect(),
            })
            .collect();
        let width = width(&rows);
        let first = first_row(&rows, width);
        let from = usize::from(declared.is_some());
        let mut found = Self {
            delimiter,
            decimal,
            header: None,
            units: None,
            first,
        };
        found.header = found.header(head, &rows, (from, width), known);
        let Some(header) = found.header else {
            found.first = first.max(from).min(head.len());
            return found;
        };
        // Below the header: units, and in logs other words.
        found.first = header + 1;
        while let Some(line) = head.get(found.first).filter(|_| found.first < first) {
            let cells: Vec<&str> = delimiter.cells(&line.text).collect();
            let is_units = found.units.is_none() && is_units(&cells, decimal);
            if is_units {
                found.units = Some(found.first);
            } else if below == WordsBelow::Rows
                || rows.get(found.first).is_some_and(|row| has_number(row))
            {
                // A row with a fault is a row.
                break;
            }
            found.first += 1;
        }
        found
    }

    /// Names in a line of the head, which may be split otherwise than the numbers.
    pub fn names<'a>(&self, text: &'a str, width: usize) -> Vec<&'a str> {
        let text = text.trim_start_matches(COMMENT_MARKS);
        let usual: Vec<&str> = self.delimiter.cells(text).collect();
        if usual.len() == width {
            return usual;
        }
        let others = Delimiter::ALL
            .iter()
            .map(|other| other.cells(text).collect());
        let mut others = std::iter::once(between_wide_blanks(text)).chain(others);
        let fitting = others.find(|names: &Vec<&str>| names.len() == width);
        fitting.unwrap_or(usual)
    }

    /// The line with most of the known names, or the one above the numbers.
    fn header(
        &self,
        head: &[HeadLine],
        rows: &[Vec<Cell>],
        (from, width): (usize, usize),
        known: &mut dyn FnMut(&[&str]) -> usize,
    ) -> Option<usize> {
        let has_words = |row: &[Cell]| row.contains(&Cell::Word) && !has_number(row);
        let mut best = (0, false, None);
        for (at, (line, row)) in head
            .iter()
            .zip(rows)
            .enumerate()
            .take(self.first)
            .skip(from)
        {
            let names = self.names(&line.text, width);
            let is_named = (line.is_comment || has_words(row)) && !is_units(&names, self.decimal);
            let count = if is_named { known(&names) } else { 0 };
            let rank = (count, !line.is_comment && names.len() == width);
            // Of several headers the first counts; of single names, which stand in any text, the last.
            let is_last = count == 1 && rank == (best.0, best.1);
            if count > 0 && (rank > (best.0, best.1) || is_last) {
                best = (rank.0, rank.1, Some(at));
            }
        }
        if best.2.is_some() {
            return best.2;
        }
        // No name is known: the last line above the numbers that has a word for each column.
        let is_wide = |at: &usize| {
            let line = head.get(*at);
            line.is_some_and(|line| self.names(&line.text, width).len() == width)
        };
        let wordy = (from..self.first).filter(|at| rows.get(*at).is_some_and(|row| has_words(row)));
        let mut above = wordy.rev().filter(is_wide);
        let last = above.next();
        let is_of_units = last.and_then(|at| head.get(at)).is_some_and(|line| {
            let cells: Vec<&str> = self.delimiter.cells(&line.text).collect();
            is_units(&cells, self.decimal)
        });
        let none_above = head.iter().all(|line| line.is_comment);
        match (is_of_units, above.next()) {
            (true, Some(above)) => Some(above),
            _ => last.or((self.first >= head.len() && !none_above).then_some(from)),
        }
    }
}

/// Whether a cell of a row is a number.
fn has_number(row: &[Cell]) -> bool {
    row.iter().any(|cell| matches!(cell, Cell::Number(_)))
}

/// The mark in a first line `sep=;`, as spreadsheets write it.
fn declared(text: &str) -> Option<Delimiter> {
    let text = text.trim().trim_matches('"');
    let (word, mark) = text.split_once('=')?;
    let mut letters = mark.chars();
    let mark = letters.next().filter(|_| letters.next().is_none())?;
    let is_declared = word.eq_ignore_ascii_case("sep");
    is_declared.then_some(match mark {
        ' ' => Delimiter::Blanks,
        mark => Delimiter::Mark(mark),
    })
}

/// Delimiter and decimal mark under which the lines hold most numbers and fewest words.
fn shape(
    head: &[HeadLine],
    declared: Option<Delimiter>,
    known: &mut dyn FnMut(&[&str]) -> usize,
) -> (Delimiter, Decimal) {
    let lines = || {
        head.iter()
            .filter(|line| !line.is_comment)
            .map(|line| line.text.as_str())
    };
    let delimiters = match declared {
        Some(delimiter) => vec![delimiter],
        None => fitting(head, known),
    };
    let mut best = (0, Delimiter::Mark(','), Decimal::Point);
    for &delimiter in &delimiters {
        for decimal in [Decimal::Point, Decimal::Comma] {
            let points: usize = lines().map(|line| points(line, delimiter, decimal)).sum();
            // `1,234` between semicolons is a decimal comma: who writes thousands with commas parts columns by commas.
            let has_commas = decimal == Decimal::Comma
                && delimiter != Delimiter::Mark(',')
                && best.1 == delimiter
                && lines().any(|line| has_decimal_comma(line, delimiter));
            if points > best.0 || (points == best.0 && points > 0 && has_commas) {
                best = (points, delimiter, decimal);
            }
        }
    }
    if best.0 > 0 {
        return (best.1, best.2);
    }
    // Without a number, the names of the first line decide.
    let first = lines().next().unwrap_or_default();
    let mut chosen = (0, declared.unwrap_or(Delimiter::Mark(',')));
    for &delimiter in &delimiters {
        let names: Vec<&str> = delimiter.cells(first).collect();
        let count = known(&names);
        if count > chosen.0 {
            chosen = (count, delimiter);
        }
    }
    (chosen.1, Decimal::Point)
}

/// Delimiters under which a line has most of the known names, if it has several and there are numbers under them; else
/// all.
fn fitting(head: &[HeadLine], known: &mut dyn FnMut(&[&str]) -> usize) -> Vec<Delimiter> {
    let mut most = 1;
    let mut fitting = Vec::new();
    for line in head {
        for delimiter in Delimiter::ALL {
            let text = line.text.trim_start_matches(COMMENT_MARKS);
            let names: Vec<&str> = delimiter.cells(text).collect();
            let count = known(&names);
            if count > most {
                (most, fitting) = (count, Vec::new());
            }
            if count == most && most > 1 && !fitting.contains(&delimiter) {
                fitting.push(delimiter);
            }
        }
    }
    let is_number = |cell: &str| {
        [Decimal::Point, Decimal::Comma]
            .iter()
            .any(|decimal| decimal.number(cell).is_some())
    };
    let has_numbers = |delimiter: &Delimiter| {
        let mut lines = head.iter().filter(|line| !line.is_comment);
        lines.any(|line| delimiter.cells(&line.text).any(is_number))
    };
    fitting.retain(has_numbers);
    if fitting.is_empty() {
        Delimiter::ALL.to_vec()
    } else {
        fitting
    }
}

/// What a line says for a dialect.
fn points(line: &str, delimiter: Delimiter, decimal: Decimal) -> usize {
    let [mut numbers, mut words] = [0, 0];
    for cell in delimiter.cells(line) {
        match decimal.read(cell) {
            Cell::Number(_) => numbers += 1,
            Cell::Word => words += 1,
            Cell::Empty | Cell::Missing => {}
        }
    }
    (NUMBER * numbers).saturating_sub(words)
}

fn has_decimal_comma(line: &str, delimiter: Delimiter) -> bool {
    let mut cells = delimiter.cells(line);
    cells.any(|cell| cell.contains(',') && Decimal::Comma.number(cell).is_some())
}

/// Whether a row is one of numbers.
fn is_counted(row: &[Cell]) -> bool {
    let numbers = row
        .iter()
        .filter(|cell| matches!(cell, Cell::Number(_)))
        .count();
    let words = row.iter().filter(|cell| **cell == Cell::Word).count();
    NUMBER * numbers > words
}

/// The commonest number of cells of the rows of numbers, the later one of equals; 0 without any.
fn width(rows: &[Vec<Cell>]) -> usize {
    let counted = || rows.iter().filter(|row| is_counted(row)).map(Vec::len);
    let times = |width: usize| counted().filter(|other| *other == width).count();
    let widest = counted().max_by_key(|width| times(*width));
    widest.unwrap_or_default()
}

/// The first row whose cells are numbers in those columns that hold numbers further down.
fn first_row(rows: &[Vec<Cell>], width: usize) -> usize {
    let is_row = |row: &&Vec<Cell>| row.len() == width && is_counted(row);
    let shown: Vec<&Vec<Cell>> = rows.iter().rev().filter(is_row).take(SHOWN).collect();
    let holds_numbers = |column: usize| {
        let cells = shown.iter().filter_map(|row| row.get(column));
        let numbers = cells.filter(|cell| matches!(cell, Cell::Number(_))).count();
        2 * numbers >= shown.len()
    };
    let numeric: Vec<usize> = (0..width).filter(|column| holds_numbers(*column)).collect();
    let is_first = |row: &Vec<Cell>| {
        let cell = |column: &usize| row.get(*column).copied().unwrap_or(Cell::Word);
        !numeric.is_empty()
            && numeric.iter().all(|column| cell(column) != Cell::Word)
            && numeric
                .iter()
                .any(|column| matches!(cell(column), Cell::Number(_)))
    };
    rows.iter().position(is_first).unwrap_or(rows.len())
}

/// Whether a line holds units, and nothing else.
fn is_units(cells: &[&str], decimal: Decimal) -> bool {
    let is_word = |cell: &str| {
        UNIT_WORDS
            .iter()
            .any(|word| cell.eq_ignore_ascii_case(word))
    };
    let is_unit = |cell: &&str| {
        let unit = without_brackets(cell);
        unit.is_empty() || is_word(unit) || any_unit(unit).is_some() || unit.len() < cell.len()
    };
    let tells = |cell: &&str| {
        let unit = without_brackets(cell);
        matches!(decimal.read(unit), Cell::Word) && any_unit(unit).is_some()
    };
    cells.iter().all(is_unit) && cells.iter().any(tells)
}

/// The parts of a header between blanks; one blank before a bracket, or inside of one, parts no names.
fn between_wide_blanks(text: &str) -> Vec<&str> {
    let mut depth = 0_u32;
    let mut names = text.split(|letter: char| {
        match letter {
            '[' | '(' | '<' | '{' => depth += 1,
            ']' | ')' | '>' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && letter.is_whitespace()
    });
    let mut all: Vec<&str> = Vec::new();
    let mut begin = 0;
    for name in names.by_ref() {
        let end = begin + name.len();
        let opens = name.starts_with(['[', '(', '<', '{', '/']);
        match all.pop() {
            Some(before) if opens && !name.is_empty() => {
                let start = begin - before.len() - 1;
                all.push(text.get(start..end).unwrap_or(name));
            }
            Some(before) => {
                all.push(before);
                all.extend((!name.is_empty()).then_some(name));
            }
            None => all.extend((!name.is_empty()).then_some(name)),
        }
        begin = end + 1;
    }
    all
}
