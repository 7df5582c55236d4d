//! The second line of a frame: `key=value`, values with blanks in quotes.

use crate::exchange::sphere_columns::SphereColumn;
use crate::exchange::spheres::{Cell, Weight};
use crate::exchange::text::{Line, TextError};

/// Contents of the line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    pub cell: Cell,
    /// Number of columns.
    pub count: usize,
    /// First column of each property.
    /// None of spheres that are all alike.
    pub species: Option<usize>,
    pub place: usize,
    pub velocity: Option<usize>,
    pub id: Option<usize>,
    /// Column of the size, and its ratio to the radius.
    pub size: Option<(usize, f64)>,
    pub spin: Option<usize>,
    pub material: Option<usize>,
    pub weight: Option<(usize, Weight)>,
}

/// Columns of a file without `Properties`.
const PLAIN: &str = "species:S:1:pos:R:3";

/// The cell that a line of `Lattice`, `Origin` and `pbc` says.
pub(super) fn cell(line: Line) -> Result<Cell, TextError> {
    let entries = entries(line)?;
    let find = |key: &str| find(&entries, key);
    let origin = match find("Origin") {
        Some(text) => numbers(line, "Origin", text)?,
        None => [0.0; 3],
    };
    let lattice = find("Lattice")
        .map(|text| lattice(line, text))
        .transpose()?;
    let is_periodic = match find("pbc") {
        Some(text) => periods(line, text)?,
        None => [lattice.is_some(); 3],
    };
    if lattice.is_none() && is_periodic.contains(&true) {
        return Err(line.missing("Lattice", "a periodic axis needs its length"));
    }
    let (lattice, tilt) = match lattice {
        Some((edges, tilt)) => (Some(edges), tilt),
        None => (None, 0.0),
    };
    if tilt != 0.0 && !(is_periodic[0] && is_periodic[2]) {
        return Err(line.missing(
            "pbc",
            "a cell that leans along x over z is periodic along both",
        ));
    }
    let bounds = |lengths: [f64; 3]| {
        std::array::from_fn(|axis| [origin[axis], origin[axis] + lengths[axis]])
    };
    Ok(Cell {
        bounds: lattice.map(bounds),
        tilt,
        is_periodic,
        is_silent: find("pbc").is_none() && lattice.is_none(),
    })
}

/// The value of a key.
fn find<'a>(entries: &[(&str, &'a str)], key: &str) -> Option<&'a str> {
    let mut entries = entries.iter();
    let found = entries.find(|(name, _)| name.eq_ignore_ascii_case(key));
    found.map(|&(_, value)| value)
}

impl Header {
    pub fn read(line: Line) -> Result<Self, TextError> {
        let entries = entries(line)?;
        let properties = properties(line, find(&entries, "Properties").unwrap_or(PLAIN))?;
        let column = |is_named: &dyn Fn(&str) -> bool, kind: &str, width: usize| {
            let mut properties = properties.iter();
            let matches = |p: &&Property| is_named(p.name) && p.kind == kind && p.width == width;
            properties.find(matches).map(|property| property.from)
        };
        let named = |name: &'static str| move |given: &str| given == name;
        let scalar = |wanted: SphereColumn, kind: &str| {
            column(&|name| SphereColumn::scalar(name) == Some(wanted), kind, 1)
        };
        let vector = |first: SphereColumn| {
            column(
                &|name| SphereColumn::vector(name) == Some(first as usize),
                "R",
                3,
            )
        };
        let radius = scalar(SphereColumn::Radius, "R").map(|at| (at, 1.0));
        let size = radius.or(scalar(SphereColumn::Diameter, "R").map(|at| (at, 0.5)));
        let species =
            column(&named("species"), "S", 1).or_else(|| column(&named("species"), "I", 1));
        if species.is_none() && size.is_none() {
            return Err(line.missing(
                "species:S:1",
                "Properties must name it, or radius:R:1 of spheres",
            ));
        }
        let density = scalar(SphereColumn::Density, "R").map(|at| (at, Weight::Density));
        let mass = scalar(SphereColumn::Mass, "R").map(|at| (at, Weight::Mass));
        Ok(Self {
            cell: cell(line)?,
            count: properties.iter().map(|property| property.width).sum(),
            species,
            place: column(&named("pos"), "R", 3)
                .ok_or_else(|| line.missing("pos:R:3", "Properties must name it"))?,
            velocity: vector(SphereColumn::VelocityX),
            id: column(&named("id"), "I", 1),
            size,
            spin: vector(SphereColumn::SpinX),
            material: scalar(SphereColumn::Material, "I"),
            // A mass is a density where there is a size.
            weight: density.or(mass.filter(|_| size.is_some())),
        })
    }
}

/// Keys and values; a key without a value is a flag, which is ignored.
fn entries(line: Line<'_>) -> Result<Vec<(&str, &str)>, TextError> {
    let mut entries = Vec::new();
    let mut rest = line.text.trim_start();
    while !rest.is_empty() {
        let end = rest
            .find(|c: char| c == '=' || c.is_whitespace())
            .unwrap_or(rest.len());
        let (key, after) = rest.split_at(end);
        let Some(after) = after.strip_prefix('=') else {
            rest = after.trim_start();
            continue;
        };
        let quote = after.chars().next().filter(|c| matches!(c, '"' | '\''));
        let (value, after) = match quote {
            Some(quote) => after[1..].split_once(quote).ok_or_else(|| {
                line.missing(
                    "a quotation mark",
                    format!("the value of {key} does not end"),
                )
            })?,
            None => after.split_once(char::is_whitespace).unwrap_or((after, "")),
        };
        entries.push((key, value));
        rest = after.trim_start();
    }
    Ok(entries)
}

fn numbers<const N: usize>(
    line: Line,
    what: &'static str,
    text: &str,
) -> Result<[f64; N], TextError> {
    let words: Vec<&str> = text.split_whitespace().collect();
    if words.len() != N {
        return Err(line.invalid(what, format!("{N} numbers"), text));
    }
    let mut numbers = [0.0; N];
    for (number, word) in numbers.iter_mut().zip(words) {
        *number = line.number(what, word)?;
    }
    Ok(numbers)
}

/// Edges of a cell that is orthogonal, or leans along x over z, and how far.
fn lattice(line: Line, text: &str) -> Result<([f64; 3], f64), TextError> {
    let all: [f64; 9] = numbers(line, "Lattice", text)?;
    let edges = [all[0], all[4], all[8]];
    let others = [all[1], all[2], all[3], all[5], all[7]];
    if edges.iter().all(|&edge| edge > 0.0) && others.iter().all(|&other| other == 0.0) {
        Ok((edges, all[6]))
    } else {
        let valid = "of an orthogonal cell, or one that leans along x over z, `LX 0 0 0 LY 0 XZ 0 LZ` with lengths > 0";
        Err(line.invalid("Lattice", valid, text))
    }
}

fn periods(line: Line, text: &str) -> Result<[bool; 3], TextError> {
    let flag = |word: &str| match word {
        "T" | "t" | "True" | "true" | "1" => Some(true),
        "F" | "f" | "False" | "false" | "0" => Some(false),
        _ => None,
    };
    let flags: Option<Vec<bool>> = text.split_whitespace().map(flag).collect();
    let flags = flags.and_then(|flags| flags.try_into().ok());
    flags.ok_or_else(|| line.invalid("pbc", "three of T and F", text))
}

/// Columns of one property.
struct Property<'a> {
    name: &'a str,
    kind: &'a str,
    from: usize,
    width: usize,
}

fn properties<'a>(line: Line, text: &'a str) -> Result<Vec<Property<'a>>, TextError> {
    let words: Vec<&str> = text.split(':').collect();
    let (triples, rest) = words.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(line.invalid("Properties", "triples of NAME:KIND:COLUMNS", text));
    }
    let mut from = 0;
    let property = |&[name, kind, width]: &[&'a str; 3]| {
        let width = line.whole("the columns of a property", 1..=99, width)? as usize;
        from += width;
        Ok(Property {
            name,
            kind,
            from: from - width,
            width,
        })
    };
    triples.iter().map(property).collect()
}
