//! VTK PolyData (.vtp) and UnstructuredGrid (.vtu): arrays as text, in base64 in place, or appended as bytes or in base64, as
//! they are or packed by zlib.

use super::blocks::Packing;
use super::{Array, Points, is_wanted};
use crate::packing::read::PackingColumns;
use tribos_base::exchange::spheres::Cell;

/// How to write a file that is read here.
const CURE: &str = "in ParaView save it with Compressor Type ZLib or None";
/// What stands before appended blocks.
const APPENDED: &[u8] = b"<AppendedData";

/// The pieces of a file. All axes are open unless it has the field data that Tribos writes: the ends of the box and
/// which axes repeat.
pub(super) fn read(
    bytes: &[u8],
    chosen: Option<&PackingColumns>,
) -> Result<(Vec<Points>, Option<Cell>), String> {
    let file = Document::open(bytes)?;
    let mut pieces = Vec::new();
    for piece in between(file.text, "<Piece", "</Piece>") {
        let count = attribute(tag(piece, "<Piece").unwrap_or_default(), "NumberOfPoints");
        if count == Some("0") {
            continue;
        }
        let points = between(piece, "<Points", "</Points>").next();
        let place = points.and_then(|points| arrays(points).next());
        let Some((tag, body)) = place else {
            return Err(
                "there is no array `Points`; give positions as Points and the point data radius"
                    .into(),
            );
        };
        let places = file.numbers("Points", tag, body)?;
        let mut read = Points {
            places,
            arrays: Vec::new(),
        };
        for (tag, body) in between(piece, "<PointData", "</PointData>").flat_map(arrays) {
            let name = attribute(tag, "Name").unwrap_or_default();
            if is_wanted(name, chosen) {
                let width =
                    attribute(tag, "NumberOfComponents").and_then(|width| width.parse().ok());
                let numbers = file.numbers(name, tag, body)?;
                read.arrays.push(Array {
                    name: name.into(),
                    width: width.unwrap_or(1),
                    numbers,
                });
            }
        }
        pieces.push(read);
    }
    if pieces.is_empty() && !file.text.contains("<Piece") {
        return Err(
            "there is no array `Points`; give positions as Points and the point data radius".into(),
        );
    }
    Ok((pieces, file.cell()?))
}

/// A file with what holds for all its arrays.
struct Document<'a> {
    text: &'a str,
    packing: Packing,
    /// Appended blocks from the mark before them on, and whether they are in base64.
    appended: Option<(&'a [u8], bool)>,
}

impl<'a> Document<'a> {
    fn open(bytes: &'a [u8]) -> Result<Self, String> {
        let end = bytes
            .windows(APPENDED.len())
            .position(|word| word == APPENDED);
        let (head, tail) = bytes.split_at(end.unwrap_or(bytes.len()));
        let text = std::str::from_utf8(head)
            .map_err(|error| format!("its byte {} is not of a text", error.valid_up_to()))?;
        let root = tag(text, "<VTKFile").ok_or("it is no VTK file")?;
        if !matches!(
            attribute(root, "type"),
            Some("PolyData" | "UnstructuredGrid")
        ) {
            return Err(
                "only PolyData (.vtp) and UnstructuredGrid (.vtu) are read: the centres as points"
                    .into(),
            );
        }
        let is_packed = match attribute(root, "compressor") {
            None | Some("") => false,
            Some("vtkZLibDataCompressor") => true,
            Some(other) => return Err(format!("it is compressed by {other}; {CURE}")),
        };
        let header = match attribute(root, "header_type") {
            Some("UInt64") => 8,
            None | Some("UInt32") => 4,
            Some(other) => {
                return Err(format!(
                    "the header type {other} is unknown; UInt32 and UInt64 are read"
                ));
            }
        };
        let appended = (!tail.is_empty()).then(|| {
            let close = tail
                .iter()
                .position(|byte| *byte == b'>')
                .unwrap_or(tail.len());
            let (open, blocks) = tail.split_at(close);
            let is_text = String::from_utf8_lossy(open).contains("base64");
            let begin = blocks
                .iter()
                .position(|byte| *byte == b'_')
                .map_or(blocks.len(), |at| at + 1);
            (&blocks[begin..], is_text)
        });
        let is_big_endian = attribute(root, "byte_order") == Some("BigEndian");
        Ok(Self {
            text,
            packing: Packing {
                header,
                is_packed,
                is_big_endian,
            },
            appended,
        })
    }

    /// Numbers of an array.
    fn numbers(&self, name: &str, tag: &str, body: &str) -> Result<Vec<f64>, String> {
        let damaged = || format!("the array {name} is damaged");
        let bytes = match attribute(tag, "format") {
            Some("ascii") => {
                let number = |word: &str| {
                    word.parse()
                        .map_err(|_| format!("`{word}` in the array {name} is no number"))
                };
                return body.split_whitespace().map(number).collect();
            }
            Some("binary") => self.packing.array_of_text(body.as_bytes()),
            _ => {
                let offset =
                    attribute(tag, "offset").and_then(|offset| offset.parse::<usize>().ok());
                let (blocks, is_text) = self.appended.ok_or_else(damaged)?;
                let from = offset
                    .and_then(|offset| blocks.get(offset..))
                    .ok_or_else(damaged)?;
                if is_text {
                    // The next array begins where this one ends, the last before the tag that follows.
                    let offsets = self
                        .text
                        .match_indices("offset=\"")
                        .filter_map(|(at, word)| {
                            self.text[at + word.len()..]
                                .split('"')
                                .next()?
                                .parse::<usize>()
                                .ok()
                        });
                    let next = offsets.filter(|next| Some(*next) > offset).min();
                    let length = next.zip(offset).map(|(next, offset)| next - offset);
                    let tag = from
                        .iter()
                        .position(|byte| *byte == b'<')
                        .unwrap_or(from.len());
                    self.packing
                        .array_of_text(&from[..length.unwrap_or(tag).min(from.len())])
                } else {
                    self.packing.array(from)
                }
            }
        };
        let kind = attribute(tag, "type").unwrap_or_default();
        let numbers = self.packing.numbers(kind, &bytes.ok_or_else(damaged)?);
        numbers.ok_or_else(|| {
            format!(
                "the array {name} has the type {kind}; floats and integers of 8 to 64 bits are read"
            )
        })
    }

    /// The box in the field data, if the file has one.
    fn cell(&self) -> Result<Option<Cell>, String> {
        let field = |name: &str| -> Result<Option<Vec<f64>>, String> {
            let mut all = between(self.text, "<FieldData", "</FieldData>").flat_map(arrays);
            let found = all.find(|(tag, _)| attribute(tag, "Name") == Some(name));
            found
                .map(|(tag, body)| self.numbers(name, tag, body))
                .transpose()
        };
        let (Some(ends), Some(repeats)) = (field("box")?, field("periodic")?) else {
            return Ok(None);
        };
        let tilt = field("tilt")?.and_then(|tilt| tilt.first().copied());
        match (ends.as_slice(), repeats.as_slice()) {
            (&[x0, x1, y0, y1, z0, z1], &[x, y, z]) => Ok(Some(Cell {
                bounds: Some([[x0, x1], [y0, y1], [z0, z1]]),
                is_periodic: [x, y, z].map(|repeats| repeats != 0.0),
                tilt: tilt.unwrap_or(0.0),
                is_silent: false,
            })),
            _ => Err("its field data `box` and `periodic` need 6 and 3 numbers".into()),
        }
    }
}

/// The parts of a text between tags, with the first.
fn between<'a>(text: &'a str, begin: &'a str, end: &'a str) -> impl Iterator<Item = &'a str> {
    let tags = text.match_indices(begin).filter(move |(at, _)| {
        // `<Points` begins no `<PointData`.
        let next = text[at + begin.len()..].chars().next();
        next.is_some_and(|next| next.is_whitespace() || next == '>' || next == '/')
    });
    tags.filter_map(move |(at, _)| {
        let rest = &text[at..];
        rest.find(end).map(|end| &rest[..end])
    })
}

/// The tag of each array in a part of a text, and what stands in it.
fn arrays(part: &str) -> impl Iterator<Item = (&str, &str)> {
    part.match_indices("<DataArray").filter_map(|(at, _)| {
        let rest = &part[at..];
        let tag = tag(rest, "<DataArray")?;
        let inside = rest[tag.len()..]
            .trim_start_matches('>')
            .split("</DataArray")
            .next()
            .unwrap_or_default();
        let inside = if tag.ends_with('/') { "" } else { inside };
        // Keys with information stand before the numbers or behind them.
        let [before, behind] = [inside.split('<').next(), inside.rsplit('>').next()]
            .map(|part| part.unwrap_or_default().trim());
        Some((tag, if before.is_empty() { behind } else { before }))
    })
}

/// The tag that begins a text at its first occurrence, without its bracket.
fn tag<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    let from = text.find(name)?;
    text[from..].split('>').next()
}

/// The value of an attribute.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let mut words = tag.match_indices(name);
    words.find_map(|(at, _)| {
        let before = tag[..at].chars().next_back()?;
        let rest = tag[at + name.len()..]
            .trim_start()
            .strip_prefix('=')?
            .trim_start();
        let quote = rest
            .chars()
            .next()
            .filter(|quote| matches!(quote, '"' | '\''))?;
        let value = rest[1..].split(quote).next()?;
        before.is_whitespace().then_some(value)
    })
}
