//! VTK PolyData (.vtp): arrays as text or base64 in place, without compression.

use super::{Assembly, AssemblyError};
use crate::space::PeriodicBox;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Vector3;

/// How to write a file that is read here.
const CURE: &str = "in ParaView save it with Data Mode Ascii or Binary and Compressor Type None";

/// The spheres of a file. It has no periods: all axes are open.
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
    Ok(Assembly {
        velocities,
        spins,
        ..Assembly::new(PeriodicBox::OPEN, positions, radii)
    })
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
        let whole = self.text;
        let (from, to) = match name {
            "Points" => (whole.find("<Points>"), whole.find("</Points>")),
            _ => (whole.find("<PointData"), whole.find("</PointData>")),
        };
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
            other => Err(format!(
                "the array {name} has the type {other}; Float32 and Float64 are read"
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
