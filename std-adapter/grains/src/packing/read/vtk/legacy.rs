//! VTK's legacy files (.vtk): PolyData and UnstructuredGrid, as text or bytes.

use super::blocks::Packing;
use super::{Array, Points, is_wanted};
use crate::packing::read::PackingColumns;

/// Lines of the head: version, title, `ASCII` or `BINARY`.
const HEAD: usize = 3;
/// Numbers of these files are big-endian.
const NUMBERS: Packing = Packing {
    header: 0,
    is_packed: false,
    is_big_endian: true,
};

/// What is left of a file.
struct Cursor<'a> {
    rest: &'a [u8],
    /// Number of the line, from 1, in files of text.
    line: usize,
    is_binary: bool,
}

impl<'a> Cursor<'a> {
    /// The next line.
    fn line(&mut self) -> Option<&'a str> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|byte| *byte == b'\n');
        let (line, rest) = self
            .rest
            .split_at(end.map_or(self.rest.len(), |end| end + 1));
        (self.rest, self.line) = (rest, self.line + 1);
        Some(std::str::from_utf8(line).unwrap_or_default().trim())
    }

    /// The next line that is not blank, as words.
    fn words(&mut self) -> Option<Vec<&'a str>> {
        loop {
            let line = self.line()?;
            if !line.is_empty() {
                return Some(line.split_whitespace().collect());
            }
        }
    }

    /// The next word of a text.
    fn word(&mut self) -> Option<&'a str> {
        let begin = self
            .rest
            .iter()
            .position(|byte| !byte.is_ascii_whitespace())?;
        self.line += self.rest[..begin]
            .iter()
            .filter(|byte| **byte == b'\n')
            .count();
        let rest = &self.rest[begin..];
        let end = rest
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.rest = rest;
        std::str::from_utf8(word).ok()
    }

    /// So many numbers of a type.
    fn numbers(&mut self, kind: &str, count: usize) -> Result<Vec<f64>, String> {
        let short = || format!("the file ends before {count} numbers of type {kind}");
        if !self.is_binary {
            let mut all = Vec::new();
            for _ in 0..count {
                let word = self.word().ok_or_else(short)?;
                all.push(
                    word.parse()
                        .map_err(|_| format!("line {}: `{word}` is no number", self.line))?,
                );
            }
            return Ok(all);
        }
        let unknown = || {
            format!("numbers have the type {kind}; floats and integers of 8 to 64 bits are read")
        };
        let one = NUMBERS.numbers(kind, &[0; 8]).ok_or_else(unknown)?;
        let length = count.checked_mul(8 / one.len()).ok_or_else(short)?;
        let (block, rest) = self.rest.split_at_checked(length).ok_or_else(short)?;
        self.rest = rest;
        NUMBERS.numbers(kind, block).ok_or_else(unknown)
    }
}

/// The points of a file with their arrays.
pub(super) fn read(bytes: &[u8], chosen: Option<&PackingColumns>) -> Result<Points, String> {
    let mut cursor = Cursor {
        rest: bytes,
        line: 0,
        is_binary: false,
    };
    for at in 0..HEAD {
        let line = cursor.line().ok_or("the file is cut short")?;
        if at + 1 == HEAD {
            cursor.is_binary = match line {
                "ASCII" => false,
                "BINARY" => true,
                other => {
                    return Err(format!(
                        "line 3: the file must be ASCII or BINARY, not `{other}`"
                    ));
                }
            };
        }
    }
    let (mut points, mut of_points) = (Points::default(), false);
    while let Some(words) = cursor.words() {
        let number = |at: usize| words.get(at).and_then(|word| word.parse::<usize>().ok());
        let count = || {
            number(1).ok_or_else(|| {
                format!("`{}` needs a number behind its first word", words.join(" "))
            })
        };
        let upper = words[0].to_ascii_uppercase();
        match upper.as_str() {
            "DATASET" => {
                if !matches!(words.get(1), Some(&("POLYDATA" | "UNSTRUCTURED_GRID"))) {
                    return Err(
                        "only POLYDATA and UNSTRUCTURED_GRID are read: the centres as points"
                            .into(),
                    );
                }
            }
            "POINTS" => {
                let count = count()?.checked_mul(3).ok_or("too many points")?;
                points.places = cursor.numbers(words.get(2).unwrap_or(&"float"), count)?;
            }
            "VERTICES" | "LINES" | "POLYGONS" | "TRIANGLE_STRIPS" | "CELLS" => {
                skip_cells(&mut cursor, count()?, number(2).unwrap_or(0))?
            }
            "CELL_TYPES" => drop(cursor.numbers("int", count()?)?),
            "POINT_DATA" => of_points = true,
            "CELL_DATA" => of_points = false,
            "SCALARS" | "VECTORS" | "NORMALS" | "TENSORS" => {
                let width = match upper.as_str() {
                    "SCALARS" => number(3).unwrap_or(1),
                    "TENSORS" => 9,
                    _ => 3,
                };
                let name = words.get(1).copied().unwrap_or_default();
                if upper == "SCALARS" {
                    // The table of colours is named, and not read.
                    let before = (cursor.rest, cursor.line);
                    if cursor
                        .words()
                        .is_none_or(|words| words[0] != "LOOKUP_TABLE")
                    {
                        (cursor.rest, cursor.line) = before;
                    }
                }
                let many = points.places.len() / 3;
                let numbers = cursor.numbers(words.get(2).unwrap_or(&"float"), many * width)?;
                keep(
                    &mut points,
                    of_points && is_wanted(name, chosen),
                    Array {
                        name: name.into(),
                        width,
                        numbers,
                    },
                );
            }
            "FIELD" => {
                for _ in 0..number(2).unwrap_or(0) {
                    field(&mut cursor, &mut points, of_points, chosen)?;
                }
            }
            // Notes on an array end with a blank line.
            "METADATA" => while cursor.line().is_some_and(|line| !line.is_empty()) {},
            "LOOKUP_TABLE" => drop(cursor.numbers("unsigned_char", 4 * number(2).unwrap_or(0))?),
            other => {
                return Err(format!(
                    "the word `{other}` is unknown; points, cells and arrays of points are read"
                ));
            }
        }
    }
    Ok(points)
}

/// An array of a field: name, numbers a point, points, type.
fn field(
    cursor: &mut Cursor<'_>,
    points: &mut Points,
    of_points: bool,
    chosen: Option<&PackingColumns>,
) -> Result<(), String> {
    let words = loop {
        let words = cursor.words().ok_or("the file ends within a field")?;
        if words[0] != "METADATA" {
            break words;
        }
        while cursor.line().is_some_and(|line| !line.is_empty()) {}
    };
    let (&[name, width, count, kind], true) = (&words[..], words.len() == 4) else {
        return Err(format!(
            "an array of a field begins with name, components, tuples and type, not `{}`",
            words.join(" ")
        ));
    };
    let size = |word: &str| {
        word.parse::<usize>()
            .map_err(|_| format!("`{word}` is no number of values of {name}"))
    };
    let (width, count) = (size(width)?, size(count)?);
    if kind == "string" {
        for _ in 0..count {
            cursor.line();
        }
        return Ok(());
    }
    let numbers = cursor.numbers(kind, width.checked_mul(count).ok_or("too many values")?)?;
    keep(
        points,
        of_points && is_wanted(name, chosen),
        Array {
            name: name.into(),
            width,
            numbers,
        },
    );
    Ok(())
}

fn keep(points: &mut Points, is_kept: bool, array: Array) {
    if is_kept {
        points.arrays.push(array);
    }
}

/// Passes over cells: numbers one after the other, or since version 5 offsets and points.
fn skip_cells(cursor: &mut Cursor<'_>, count: usize, size: usize) -> Result<(), String> {
    let before = (cursor.rest, cursor.line);
    let words = cursor.words().unwrap_or_default();
    if words.first() != Some(&"OFFSETS") {
        (cursor.rest, cursor.line) = before;
        return cursor.numbers("int", size).map(drop);
    }
    cursor.numbers(words.get(1).unwrap_or(&"vtktypeint64"), count)?;
    let words = cursor.words().unwrap_or_default();
    cursor
        .numbers(words.get(1).unwrap_or(&"vtktypeint64"), size)
        .map(drop)
}
