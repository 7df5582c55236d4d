//! Texts of single programs: LSMGeometry of ESyS-Particle, model parts of Kratos, exports of MUSEN.

use super::found::{FoundSpheres, RowName};
use super::{Assembly, AssemblyError, Source};
use std::collections::HashMap;
use tribos_base::exchange::sphere_columns::SphereColumn::{
    Density, Material, Radius, SpinX, VelocityX, X,
};
use tribos_base::exchange::spheres::Cell;
use tribos_base::exchange::text::{Line, Lines, TextError};

const CUT_SHORT: &str = "is the file cut short?";
/// Largest number of spheres.
const MOST: u64 = u32::MAX as u64;

/// So many numbers from the words of a line on.
fn numbers<const N: usize>(
    line: Line<'_>,
    words: &[&str],
    what: &'static str,
) -> Result<[f64; N], TextError> {
    let mut numbers = [0.0; N];
    if words.len() < N {
        return Err(line.invalid(what, format!("{N} numbers"), line.text));
    }
    for (number, word) in numbers.iter_mut().zip(words) {
        *number = line.number(what, word)?;
    }
    Ok(numbers)
}

/// A geometry of ESyS-Particle: box, periods, and spheres with a tag each.
pub(super) fn read_geometry(source: &Source<'_>, text: &str) -> Result<Assembly, AssemblyError> {
    let mut lines = Lines::new(text);
    let found = geometry(&mut lines).map_err(|cause| source.text_error(cause))?;
    found.checked(source.name, source.columns, "")
}

fn geometry(lines: &mut Lines<'_>) -> Result<FoundSpheres, TextError> {
    let mut cell = Cell::default();
    loop {
        let line = lines.need("BeginParticles", CUT_SHORT)?;
        match line.words()[..] {
            ["BoundingBox", ref ends @ ..] => {
                let [x0, y0, z0, x1, y1, z1] = numbers(line, ends, "an end of the box")?;
                cell.bounds = Some([[x0, x1], [y0, y1], [z0, z1]]);
            }
            ["PeriodicBoundaries", ref flags @ ..] => {
                let flags: [f64; 3] = numbers(line, flags, "a flag")?;
                cell.is_periodic = flags.map(|flag| flag != 0.0);
            }
            ["BeginParticles", ..] => break,
            _ => {}
        }
    }
    cell.is_periodic = cell.is_periodic.map(|is| is && cell.bounds.is_some());
    lines.need("the kind of the particles", CUT_SHORT)?;
    let line = lines.need("the number of particles", CUT_SHORT)?;
    let count = line.whole("the number of particles", 0..=MOST, line.text.trim())?;
    let (mut found, mut names, mut tags) = (
        FoundSpheres::with_places(RowName::Lines(Vec::new())),
        Vec::new(),
        Vec::new(),
    );
    for _ in 0..count {
        let line = lines.need("a particle", CUT_SHORT)?;
        let words = line.words();
        let [x, y, z, radius] = numbers(line, &words, "a particle: x, y, z, radius, number, tag")?;
        found.push_vector(X, [x, y, z]);
        found.push(Radius, radius);
        tags.push(
            words
                .get(5)
                .map_or(Ok(0.0), |tag| line.number("a tag", tag))?,
        );
        names.push(line.number);
    }
    // Tags are any whole numbers: those that can number materials do.
    if tags.iter().all(|tag| (0.0..=254.0).contains(tag)) {
        found.set(Material, tags);
    } else {
        found
            .notes
            .push("its tags are left out: they are no numbers of materials".into());
    }
    (found.cell, found.rows) = (cell, RowName::Lines(names));
    Ok(found)
}

/// A node of Kratos.
struct Node {
    place: [f64; 3],
    line: usize,
}

/// A model part of Kratos: nodes that have a radius are spheres; the properties of their elements say density and material.
pub(super) fn read_model_part(source: &Source<'_>, text: &str) -> Result<Assembly, AssemblyError> {
    let found = model_part(text).map_err(|cause| source.text_error(cause))?;
    found.checked(source.name, source.columns, "no node has the data RADIUS")
}

fn model_part(text: &str) -> Result<FoundSpheres, TextError> {
    let (mut nodes, mut order) = (HashMap::new(), Vec::new());
    let (mut radii, mut velocities) = (HashMap::new(), [(); 3].map(|()| HashMap::new()));
    let (mut densities, mut properties) = (HashMap::new(), HashMap::new());
    let mut block: Vec<&str> = Vec::new();
    for line in Lines::new(text) {
        let code = line.text.split("//").next().unwrap_or_default();
        let words: Vec<&str> = code.split_whitespace().collect();
        let number = |what: &'static str, at: usize| {
            let word = words.get(at).ok_or_else(|| line.missing(what, CUT_SHORT))?;
            line.number(what, word)
        };
        let id = |at: usize| {
            let word = words.get(at).copied().unwrap_or_default();
            line.whole("a number of the model part", 0..=u64::MAX, word)
        };
        match (words.as_slice(), block.as_slice()) {
            ([], _) => {}
            (["Begin", rest @ ..], _) => block = rest.to_vec(),
            (["End", ..], _) => block.clear(),
            (_, ["Nodes"]) => {
                let place = numbers(line, &words[1..], "the place of a node")?;
                // Later blocks repeat nodes.
                if nodes
                    .insert(
                        id(0)?,
                        Node {
                            place,
                            line: line.number,
                        },
                    )
                    .is_none()
                {
                    order.push(id(0)?);
                }
            }
            (["PARTICLE_DENSITY", ..], ["Properties", of]) => {
                densities.insert(
                    of.parse::<u64>().unwrap_or_default(),
                    number("a density", 1)?,
                );
            }
            (_, ["Elements", kind, ..]) if kind.contains("Particle") => {
                properties.insert(id(2)?, id(1)?);
            }
            (_, ["NodalData", "RADIUS", ..]) => drop(radii.insert(id(0)?, number("a radius", 2)?)),
            (_, ["NodalData", name, ..]) => {
                let axis = ["VELOCITY_X", "VELOCITY_Y", "VELOCITY_Z"]
                    .iter()
                    .position(|known| known == name);
                if let Some(axis) = axis {
                    velocities[axis].insert(id(0)?, number("a velocity", 2)?);
                }
            }
            _ => {}
        }
    }
    let mut found = FoundSpheres::new(RowName::Lines(Vec::new()));
    let mut names = Vec::new();
    let is_dense = order.iter().filter(|id| radii.contains_key(id)).all(|id| {
        properties
            .get(id)
            .is_some_and(|of| densities.contains_key(of))
    });
    for id in order {
        let (Some(radius), Some(node)) = (radii.get(&id), nodes.get(&id)) else {
            continue;
        };
        found.push_vector(X, node.place);
        found.push(Radius, *radius);
        let of = properties.get(&id).copied().unwrap_or(1);
        found.push(Material, of as f64);
        if let (true, Some(density)) = (is_dense, densities.get(&of)) {
            found.push(Density, *density);
        }
        if velocities.iter().any(|all| !all.is_empty()) {
            let along = |axis: usize| velocities[axis].get(&id).copied().unwrap_or(0.0);
            found.push_vector(VelocityX, [0, 1, 2].map(along));
        }
        names.push(node.line);
    }
    found.rows = RowName::Lines(names);
    Ok(found)
}

/// Codes of MUSEN before numbers of an object, and how many numbers follow.
const OBJECT_CODES: [(&str, usize); 21] = [
    ("0", 1),
    ("1", 1),
    ("2", 1),
    ("5", 2),
    ("10", 3),
    ("11", 3),
    ("12", 3),
    ("15", 3),
    ("16", 3),
    ("17", 3),
    ("18", 1),
    ("20", 3),
    ("23", 1),
    ("24", 2),
    ("31", 4),
    ("36", 9),
    ("37", 1),
    ("42", 3),
    ("43", 3),
    ("44", 9),
    ("45", 3),
];
/// The type of a sphere.
const SPHERE: &str = "1";

/// Whether a text begins with an object of MUSEN's export: its number, then its type.
pub(super) fn is_export(text: &str) -> bool {
    let words: Vec<&str> = text
        .lines()
        .next()
        .unwrap_or_default()
        .split_whitespace()
        .collect();
    words.len() > 8
        && matches!(words[..], ["0", id, "1", "1" | "9" | "13" | "14", code, ..] if id.parse::<u64>().is_ok() && OBJECT_CODES.iter().any(|known| known.0 == code))
}

/// The spheres of an export of MUSEN, at the last time of each, with the densities of their compounds.
pub(super) fn read_export(source: &Source<'_>, text: &str) -> Result<Assembly, AssemblyError> {
    let found = export(text).map_err(|cause| source.text_error(cause))?;
    found.checked(
        source.name,
        source.columns,
        "export also the geometry of the objects",
    )
}

fn export(text: &str) -> Result<FoundSpheres, TextError> {
    let mut found = FoundSpheres::new(RowName::Lines(Vec::new()));
    let (mut names, mut compounds, mut densities) = (Vec::new(), Vec::new(), HashMap::new());
    for line in Lines::new(text) {
        let words = line.words();
        match words[..] {
            ["0", _, "1", SPHERE, ..] => {
                compounds.push(object(&mut found, line, &words)?);
                names.push(line.number);
            }
            ["22", ref ends @ ..] => {
                let [x0, y0, z0, x1, y1, z1] = numbers(line, ends, "an end of the domain")?;
                found.cell.bounds = Some([[x0, x1], [y0, y1], [z0, z1]]);
            }
            ["28", ref rest @ ..] => {
                let [is_on, x, y, z, ends @ ..] = numbers::<10>(line, rest, "a period")?;
                for (axis, is_periodic) in [x, y, z].into_iter().enumerate() {
                    if is_on != 0.0 && is_periodic != 0.0 {
                        found.cell.is_periodic[axis] = true;
                        found.cell.bounds.get_or_insert_default()[axis] =
                            [ends[axis], ends[axis + 3]];
                    }
                }
            }
            // Key and name of a compound, then pairs of property and value: 0 is the density.
            ["32", key, ref rest @ ..] => {
                let pairs = (0..rest.len())
                    .find(|at| rest[*at] == "0" && (rest.len() - at).is_multiple_of(2));
                if let Some(word) = pairs.and_then(|at| rest.get(at + 1)) {
                    densities.insert(key, line.number("a density", word)?);
                }
            }
            _ => {}
        }
    }
    let mut kinds: Vec<&str> = Vec::new();
    let is_dense = !compounds.is_empty() && compounds.iter().all(|key| densities.contains_key(key));
    for key in compounds {
        if !kinds.contains(&key) {
            kinds.push(key);
        }
        let kind = kinds.iter().position(|other| *other == key).unwrap_or(0);
        found.push(Material, kind as f64 + 1.0);
        if let (true, Some(density)) = (is_dense, densities.get(key)) {
            found.push(Density, *density);
        }
    }
    found.rows = RowName::Lines(names);
    Ok(found)
}

/// Adds a sphere; the key of its compound.
fn object<'a>(
    found: &mut FoundSpheres,
    line: Line<'_>,
    words: &[&'a str],
) -> Result<&'a str, TextError> {
    let (mut rest, mut compound) = (words, "");
    let (mut radius, mut vectors) = (None, [None; 3]);
    while let [code, tail @ ..] = rest {
        let known = OBJECT_CODES.iter().find(|(known, _)| known == code);
        let (_, count) = known
            .ok_or_else(|| line.invalid("a code of an object", "one of those of MUSEN", code))?;
        let (values, tail) = tail
            .split_at_checked(*count)
            .ok_or_else(|| line.missing("a number of an object", CUT_SHORT))?;
        match *code {
            "5" => radius = Some(line.number("the radius", values[0])?),
            "12" => vectors[0] = Some(numbers(line, values, "a coordinate")?),
            "15" => vectors[1] = Some(numbers(line, values, "a velocity")?),
            "16" => vectors[2] = Some(numbers(line, values, "an angular velocity")?),
            "23" => compound = values[0],
            _ => {}
        }
        rest = tail;
    }
    let missing = |what| line.missing(what, "export also geometry and coordinates of the objects");
    let [place, velocity, spin] = vectors;
    found.push_vector(X, place.ok_or_else(|| missing("the place of a sphere"))?);
    found.push(
        Radius,
        radius.ok_or_else(|| missing("the radius of a sphere"))?,
    );
    found.push_vector(VelocityX, velocity.unwrap_or([0.0; 3]));
    found.push_vector(SpinX, spin.unwrap_or([0.0; 3]));
    Ok(compound)
}
