//! VTK PolyData (.vtp): arrays as text or base64 in place, without compression.

use super::{Assembly, AssemblyError};
use crate::packing::mixed;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Vector3;
use tribos_base::space::{PeriodicBox, SpaceError};

/// How to write a file that is read here.
const CURE: &str = "in ParaView save it with Data Mode Ascii or Binary and Compressor Type None";

/// The spheres of a file. All axes are open unless it has the field data that Tribos writes: the ends of the box and
/// which axes repeat.
pub(super) fn read(file: &str, text: &str) -> Result<Assembly, AssemblyError> {
    let refused = |reason: String| AssemblyError::Content {
        file: file.into(),
        reason,
    };
    let vtp = Document::open(text).map_err(refused)?;
    let need = |name: &str| {
        let array = vtp.array(name).map_err(refused)?;
        array.ok_or_else(|| {
            refused(format!(
                "there is no array `{name}`; give positions as Points and the point data radius"
            ))
        })
    };
    let positions = vectors(&need("Points")?);
    let radii = need("radius")?;
    let optional = |name: &str| -> Result<Option<Vec<Vector3<f64>>>, AssemblyError> {
        Ok(vtp.array(name).map_err(refused)?.map(|all| vectors(&all)))
    };
    let numbers =
        |name: &str, [least, most]: [f64; 2]| -> Result<Option<Vec<f64>>, AssemblyError> {
            let all = vtp.array(name).map_err(refused)?;
            let is_out = |value: &f64| !(least..=most).contains(value);
            match all.iter().flatten().find(|value| is_out(value)) {
                Some(value) => Err(refused(format!(
                    "{name} must be numbers from {least} to {most}, not {value}"
                ))),
                None if all.as_ref().is_some_and(|all| all.len() != positions.len()) => {
                    let points = positions.len();
                    Err(refused(format!(
                        "{points} points need as many values of {name}"
                    )))
                }
                None => Ok(all),
            }
        };
    let (velocities, spins) = (optional("velocity")?, optional("angular_velocity")?);
    for (name, given) in [
        ("radius", Some(radii.len())),
        ("velocity", velocities.as_ref().map(Vec::len)),
        ("angular_velocity", spins.as_ref().map(Vec::len)),
    ] {
        if let Some(given) = given.filter(|given| *given != positions.len()) {
            let points = positions.len();
            return Err(refused(format!(
                "{points} points need as many values of {name}, not {given}"
            )));
        }
    }
    if let Some(at) = radii
        .iter()
        .position(|radius| !radius.is_finite() || *radius <= 0.0)
    {
        let given = radii[at];
        return Err(refused(format!(
            "point {at}: the radius must be a finite number > 0, not {given}"
        )));
    }
    if let Some(at) = positions
        .iter()
        .position(|place| !place.iter().all(|x| x.is_finite()))
    {
        return Err(refused(format!(
            "point {at}: its coordinates must be finite"
        )));
    }
    let materials = numbers("material", [1.0, f64::from(u8::MAX)])?;
    let materials = materials.map(|all| all.into_iter().map(|material| material as u8).collect());
    let densities = numbers("density", [f64::MIN_POSITIVE, f64::MAX])?;
    let cell = cell(&vtp).map_err(refused)?;
    let space = cell.map_or(Ok(PeriodicBox::OPEN), |cell| cell.space());
    let space = space.map_err(|cause| AssemblyError::Space {
        file: file.into(),
        cause,
    })?;
    let mut assembly = Assembly {
        materials: materials.filter(|all: &Vec<u8>| mixed(all)),
        densities,
        is_assumed: cell.is_none(),
        velocities,
        spins,
        ..Assembly::new(space, positions, radii)
    };
    if let Some(cell) = cell {
        assembly.bounds = cell.ends;
    }
    Ok(assembly)
}

/// The box in the field data.
#[derive(Clone, Copy)]
struct Cell {
    ends: [[f64; 2]; 3],
    is_periodic: [bool; 3],
    tilt: f64,
}

impl Cell {
    fn space(&self) -> Result<PeriodicBox, SpaceError> {
        let period = |axis: usize| {
            let [low, high] = self.ends[axis];
            self.is_periodic[axis].then_some(high - low)
        };
        Ok(PeriodicBox::new([0, 1, 2].map(period))?.sheared(self.tilt))
    }
}

/// The box, if the file has one.
fn cell(vtp: &Document) -> Result<Option<Cell>, String> {
    let field = |name: &str| vtp.array_in(("<FieldData", "</FieldData>"), name);
    let (Some(ends), Some(repeats)) = (field("box")?, field("periodic")?) else {
        return Ok(None);
    };
    let tilt = field("tilt")?.and_then(|tilt| tilt.first().copied());
    match (ends.as_slice(), repeats.as_slice()) {
        (&[x0, x1, y0, y1, z0, z1], &[x, y, z]) => Ok(Some(Cell {
            ends: [[x0, x1], [y0, y1], [z0, z1]],
            is_periodic: [x, y, z].map(|repeats| repeats != 0.0),
            tilt: tilt.unwrap_or(0.0),
        })),
        _ => Err("its field data `box` and `periodic` need 6 and 3 numbers".into()),
    }
}

fn vectors(numbers: &[f64]) -> Vec<Vector3<f64>> {
    let triples = numbers.as_chunks().0.iter();
    triples.map(|&[x, y, z]| Vector3::new(x, y, z)).collect()
}

/// A file with what holds for all its arrays.
struct Document<'a> {
    text: &'a str,
    /// Bytes of the length before a block.
    header: usize,
}

impl<'a> Document<'a> {
    fn open(text: &'a str) -> Result<Self, String> {
        let root = tag(text, "<VTKFile").ok_or("it is no VTK file")?;
        if attribute(root, "type") != Some("PolyData") {
            return Err("only PolyData (.vtp) is read: the centres as points".into());
        }
        if attribute(root, "compressor").is_some() {
            return Err(format!("it is compressed; {CURE}"));
        }
        if attribute(root, "byte_order").is_some_and(|order| order != "LittleEndian") {
            return Err("its bytes are in big-endian order; only LittleEndian is read".into());
        }
        if text.matches("<Piece").count() != 1 {
            return Err("it must have one piece of points".into());
        }
        let header = match attribute(root, "header_type") {
            Some("UInt64") => 8,
            None | Some("UInt32") => 4,
            Some(other) => {
                return Err(format!(
                    "the header type {other} is unknown; UInt32 and UInt64 are read"
                ));
            }
        };
        Ok(Self { text, header })
    }

    /// Numbers of the array of this name; `Points` is the array within that element.
    fn array(&self, name: &str) -> Result<Option<Vec<f64>>, String> {
        let ends = match name {
            "Points" => ("<Points>", "</Points>"),
            _ => ("<PointData", "</PointData>"),
        };
        self.array_in(ends, name)
    }

    /// Numbers of an array in the element between two tags.
    fn array_in(&self, (begin, end): (&str, &str), name: &str) -> Result<Option<Vec<f64>>, String> {
        let whole = self.text;
        let (from, to) = (whole.find(begin), whole.find(end));
        let Some(part) = from.zip(to).and_then(|(from, to)| whole.get(from..to)) else {
            return Ok(None);
        };
        let arrays = part.match_indices("<DataArray");
        let mut found =
            arrays.filter_map(|(at, _)| Some((tag(&part[at..], "<DataArray")?, &part[at..])));
        let wanted =
            found.find(|(tag, _)| name == "Points" || attribute(tag, "Name") == Some(name));
        let Some((tag, rest)) = wanted else {
            return Ok(None);
        };
        let body = rest[tag.len()..]
            .split('<')
            .next()
            .unwrap_or_default()
            .trim_start_matches('>')
            .trim();
        let kind = attribute(tag, "type").unwrap_or_default();
        match attribute(tag, "format") {
            Some("ascii") => {
                let number = |word: &str| {
                    word.parse()
                        .map_err(|_| format!("`{word}` in the array {name} is no number"))
                };
                body.split_whitespace()
                    .map(number)
                    .collect::<Result<_, _>>()
                    .map(Some)
            }
            Some("binary") => self.binary(name, kind, body).map(Some),
            _ => Err(format!("the array {name} is appended to the file; {CURE}")),
        }
    }

    fn binary(&self, name: &str, kind: &str, body: &str) -> Result<Vec<f64>, String> {
        let damaged = || format!("the array {name} is damaged");
        let bytes = STANDARD.decode(body).map_err(|_| damaged())?;
        let (head, data) = bytes.split_at_checked(self.header).ok_or_else(damaged)?;
        let length = head
            .iter()
            .rev()
            .fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
        if length != data.len() as u64 {
            return Err(damaged());
        }
        match kind {
            "Float64" => Ok(data
                .as_chunks()
                .0
                .iter()
                .map(|bytes| f64::from_le_bytes(*bytes))
                .collect()),
            "Float32" => Ok(data
                .as_chunks()
                .0
                .iter()
                .map(|bytes| f64::from(f32::from_le_bytes(*bytes)))
                .collect()),
            "Int64" => Ok(data
                .as_chunks()
                .0
                .iter()
                .map(|bytes| i64::from_le_bytes(*bytes) as f64)
                .collect()),
            "Int32" => Ok(data
                .as_chunks()
                .0
                .iter()
                .map(|bytes| f64::from(i32::from_le_bytes(*bytes)))
                .collect()),
            other => Err(format!(
                "the array {name} has the type {other}; Float32, Float64, Int32 and Int64 are read"
            )),
        }
    }
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
        let value = rest.strip_prefix('"')?.split('"').next()?;
        before.is_whitespace().then_some(value)
    })
}
