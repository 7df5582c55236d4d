//! Tables of spheres as text: rows between blanks, commas or semicolons, with a heading, in a comment or not, or without;
//! a number of rows before them and the name of an element first, as in plain XYZ.

use super::found::{FoundSpheres, RowName};
use super::{Assembly, AssemblyError, PackingFormat, Source};
use tribos_base::exchange::extended_xyz;
use tribos_base::exchange::sphere_columns::SphereColumn::{self, Material, Radius, X, Y, Z};
use tribos_base::exchange::text::{Line, Lines};

/// Fewest known names of a heading.
const NAMED: usize = 3;
/// Columns of a row without a heading.
const PLAIN: [Option<SphereColumn>; 4] = [Some(X), Some(Y), Some(Z), Some(Radius)];
/// Columns of plain XYZ: the element, which stands for the material, then those of a row.
const ELEMENT: [Option<SphereColumn>; 5] =
    [Some(Material), Some(X), Some(Y), Some(Z), Some(Radius)];
/// What is said of tables that are not understood.
const CURE: &str = "say what the columns are by --columns (key `columns`), such as x,y,z,radius with - for one that is not \
                    read, or radius=all:0.5";

/// How the cells of a row are parted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Delimiter {
    Mark(char),
    Blanks,
}

impl Delimiter {
    /// The one of a line.
    fn of(text: &str) -> Self {
        let marks = [';', ',', '\t'];
        let mark = marks.into_iter().find(|mark| text.contains(*mark));
        // Tabs part rows as blanks do, unless a cell is empty.
        mark.filter(|mark| *mark != '\t' || text.contains("\t\t"))
            .map_or(Self::Blanks, Self::Mark)
    }

    /// The cells of a row; a mark at its end stands before nothing.
    fn cells(self, text: &str) -> Vec<&str> {
        match self {
            Self::Blanks => text.split_whitespace().collect(),
            Self::Mark(mark) => {
                let text = text.trim();
                let cells = text.strip_suffix(mark).unwrap_or(text).split(mark);
                cells.map(|cell| cell.trim().trim_matches('"')).collect()
            }
        }
    }
}

/// What rows begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FirstCell {
    /// An element, in plain XYZ.
    Element,
    /// An element if it is a word.
    Any,
}

/// A table while it is read.
struct Table {
    rows: FirstCell,
    delimiter: Delimiter,
    /// Names of the columns, if a heading has them.
    headings: Vec<String>,
    /// What each column holds, once the first row is read.
    columns: Vec<Option<SphereColumn>>,
    found: FoundSpheres,
    lines: Vec<usize>,
    /// Names of materials that are words, in the order of their appearance.
    names: Vec<String>,
}

/// The spheres of a table, or of each frame of plain XYZ.
pub(super) fn read(
    source: &Source<'_>,
    text: &str,
    format: PackingFormat,
) -> Result<Vec<Assembly>, AssemblyError> {
    let (mut lines, mut all) = (Lines::new(text), Vec::new());
    lines.skip_blank_lines();
    while lines.peek().is_some() {
        let assembly = if format == PackingFormat::PlainXyz {
            frame(source, &mut lines)?
        } else {
            rows(source, &mut lines)?
        };
        source.keep(&mut all, assembly);
        lines.skip_blank_lines();
    }
    Ok(all)
}

/// A frame of plain XYZ: the number of rows, a line of any text, the rows. Some programs leave out the text.
fn frame(source: &Source<'_>, lines: &mut Lines<'_>) -> Result<Assembly, AssemblyError> {
    let refused = |cause| source.text_error(cause);
    let line = lines
        .need("the number of spheres", "is the file cut short?")
        .map_err(refused)?;
    let most = u64::from(u32::MAX);
    let count = line
        .whole("the number of spheres", 0..=most, line.text.trim())
        .map_err(refused)?;
    let mut table = Table::new(FirstCell::Element);
    let comment = lines.here();
    let is_row = |line: Line<'_>| {
        let cells = line.words();
        cells.len() >= PLAIN.len() && cells.iter().skip(1).all(|cell| cell.parse::<f64>().is_ok())
    };
    if !is_row(comment) && lines.next().is_some() {
        let text = comment.text.to_ascii_lowercase();
        if text.contains("lattice=") || text.contains("pbc=") {
            table.found.cell = extended_xyz::cell(comment).map_err(refused)?;
        } else {
            table.heading(comment.text);
        }
    }
    for _ in 0..count {
        let line = lines
            .need("a sphere", "is the file cut short?")
            .map_err(refused)?;
        table.row(source, line)?;
    }
    table.finish(source)
}

/// All rows of a table.
fn rows(source: &Source<'_>, lines: &mut Lines<'_>) -> Result<Assembly, AssemblyError> {
    let mut table = Table::new(FirstCell::Any);
    for line in lines.by_ref() {
        let text = line.text.trim();
        match text.strip_prefix(['#', '%', '!']) {
            _ if text.is_empty() => {}
            Some(comment) if table.lines.is_empty() => table.comment(source, line, comment)?,
            Some(_) => {}
            None if table.lines.is_empty() && table.headings.is_empty() && table.heading(text) => {}
            None => table.row(source, line.without_comment())?,
        }
    }
    table.finish(source)
}

impl Table {
    fn new(rows: FirstCell) -> Self {
        Self {
            rows,
            delimiter: Delimiter::Blanks,
            headings: Vec::new(),
            columns: Vec::new(),
            found: FoundSpheres::new(RowName::Lines(Vec::new())),
            lines: Vec::new(),
            names: Vec::new(),
        }
    }

    /// A comment before the rows: the cell, or names of the columns.
    fn comment(
        &mut self,
        source: &Source<'_>,
        line: Line<'_>,
        comment: &str,
    ) -> Result<(), AssemblyError> {
        if comment.contains("Lattice=") {
            let line = Line {
                text: comment,
                ..line
            };
            self.found.cell = extended_xyz::cell(line).map_err(|cause| source.text_error(cause))?;
        } else if let Some(names) = comment.trim().strip_prefix("format ") {
            // As YADE writes them.
            self.heading(&names.replace('_', " "));
        } else {
            self.heading(comment);
        }
        Ok(())
    }

    /// Takes a text as heading if it names at least three known quantities, and none twice; whether it does.
    fn heading(&mut self, text: &str) -> bool {
        let delimiter = Delimiter::of(text);
        let names = delimiter.cells(text);
        let known: Vec<SphereColumn> = names.iter().filter_map(|name| known(name)).collect();
        if known.len() >= NAMED && known.contains(&X) && known.contains(&Y) {
            self.headings = names.into_iter().map(String::from).collect();
        }
        !self.headings.is_empty()
    }

    /// What the columns hold, from the heading, the user, or the number of cells of the first row.
    fn begin(&mut self, source: &Source<'_>, line: Line<'_>) -> Result<(), AssemblyError> {
        self.delimiter = Delimiter::of(line.text);
        let cells = self.delimiter.cells(line.text);
        let is_number = |cell: &&str| cell.parse::<f64>().is_ok();
        let begins_with_word = cells.first().is_some_and(|cell| !is_number(cell));
        // A heading that has one name less leaves out the element.
        if self.rows == FirstCell::Element && self.headings.len() + 1 == cells.len() {
            self.headings.insert(0, "type".into());
        }
        if self.headings.len() != cells.len() {
            self.headings.clear();
        }
        let usual: Vec<Option<SphereColumn>> = if self.headings.is_empty() {
            let is_element = begins_with_word || self.rows == FirstCell::Element;
            let plain = if is_element {
                ELEMENT.as_slice()
            } else {
                PLAIN.as_slice()
            };
            let columns = cells.len();
            let is_plain =
                columns == plain.len() || (columns + 1 == plain.len() && source.says_radii());
            if !is_plain && !source.has_places() {
                let what = format!("{} columns without names", cells.len());
                return Err(source.refused(line.number, &what, &cells, CURE));
            }
            plain.to_vec()
        } else {
            // Of two columns for one quantity the first counts.
            let mut seen = Vec::new();
            let mut once = |name: &String| {
                let column = known(name).filter(|column| !seen.contains(column))?;
                seen.push(column);
                Some(column)
            };
            self.headings.iter().map(&mut once).collect()
        };
        self.columns = match source.columns {
            Some(columns) => columns
                .assign(&usual, &self.headings, cells.len())
                .map_err(|reason| source.error(line.number, &reason))?,
            None => usual,
        };
        self.columns.truncate(cells.len());
        Ok(())
    }

    /// Adds a row.
    fn row(&mut self, source: &Source<'_>, line: Line<'_>) -> Result<(), AssemblyError> {
        if self.columns.is_empty() {
            self.begin(source, line)?;
        }
        let cells = self.delimiter.cells(line.text);
        if cells.len() != self.columns.len() {
            let valid = match self.lines.first() {
                Some(first) => format!("{} columns as in line {first}", self.columns.len()),
                None => format!("{} columns", self.columns.len()),
            };
            return Err(source.text_error(line.invalid("a row", valid, line.text)));
        }
        for (cell, column) in cells.into_iter().zip(&self.columns) {
            let Some(column) = column else { continue };
            let value = match (column, cell.parse::<f64>()) {
                (_, Ok(value)) if value.is_finite() => value,
                (Material, _) => number_of(&mut self.names, cell),
                _ => line
                    .number(column.name(), cell)
                    .map_err(|cause| source.text_error(cause))?,
            };
            self.found.push(*column, value);
        }
        self.lines.push(line.number);
        Ok(())
    }

    fn finish(mut self, source: &Source<'_>) -> Result<Assembly, AssemblyError> {
        if !self.names.is_empty() {
            self.found.notes.push(format!(
                "types are numbered as they appear: {}",
                self.names.join(", ")
            ));
        }
        self.found.rows = RowName::Lines(self.lines);
        self.found.checked(source.name, source.columns, CURE)
    }
}

/// The quantity of a heading, whose unit does not count.
fn known(name: &str) -> Option<SphereColumn> {
    let name = name
        .split(['[', '('])
        .next()
        .filter(|name| !name.is_empty())
        .unwrap_or(name);
    SphereColumn::of(name)
}

/// Number of a name, from 1.
fn number_of(names: &mut Vec<String>, name: &str) -> f64 {
    let known = names.iter().position(|other| other == name);
    let at = known.unwrap_or_else(|| {
        names.push(name.into());
        names.len() - 1
    });
    at as f64 + 1.0
}
