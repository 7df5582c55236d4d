//! MercuryDPM: the text of `.data`, a line of numbers before each state, and `.restart`.

use super::found::{FoundSpheres, RowName};
use super::{Assembly, AssemblyError, Source};
use tribos_base::exchange::sphere_columns::SphereColumn::{
    self, Density, Material, Radius, SpinX, VelocityX, X,
};
use tribos_base::exchange::spheres::Cell;
use tribos_base::exchange::text::{Line, Lines, TextError};

const CUT_SHORT: &str = "is the file cut short?";
/// Largest number of particles.
const MOST: u64 = u32::MAX as u64;

/// What a file of `.data` has in a plane or in space: numbers in the head of a state and in a row, places of the
/// number of the species and of the radius.
struct Layout {
    head: usize,
    row: usize,
}

const PLANE: Layout = Layout { head: 6, row: 8 };
const SPACE: Layout = Layout { head: 8, row: 14 };

/// Whether a text begins as `.data` does: a whole number of rows, the time and the ends of the box, then rows of so many
/// numbers.
pub(super) fn is_data(text: &str) -> bool {
    let mut lines = text
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<&str>>());
    let are_numbers = |words: &[&str]| words.iter().all(|word| word.parse::<f64>().is_ok());
    let layout_of = |head: &[&str]| {
        let layout = [PLANE, SPACE].into_iter();
        let mut layout = layout.filter(|layout| layout.head == head.len() && are_numbers(head));
        layout.next()
    };
    let mut is_data = false;
    while let Some(head) = lines.next() {
        let count = head.first().and_then(|word| word.parse::<u64>().ok());
        let (Some(layout), Some(count)) = (layout_of(&head), count) else {
            return is_data && head.is_empty();
        };
        is_data = true;
        // A flow may begin without a particle.
        if count > 0 {
            return lines
                .next()
                .is_some_and(|row| row.len() == layout.row && are_numbers(&row));
        }
    }
    is_data
}

/// The states of `.data`.
pub(super) fn read_data(source: &Source<'_>, text: &str) -> Result<Vec<Assembly>, AssemblyError> {
    let (mut lines, mut all) = (Lines::new(text), Vec::new());
    lines.skip_blank_lines();
    while lines.peek().is_some() {
        let found = state(&mut lines).map_err(|cause| source.text_error(cause))?;
        source.keep(&mut all, found.checked(source.name, source.columns, "")?);
        lines.skip_blank_lines();
    }
    Ok(all)
}

fn state(lines: &mut Lines<'_>) -> Result<FoundSpheres, TextError> {
    let line = lines.need("the head of a state", CUT_SHORT)?;
    let words = line.words();
    let layout = [PLANE, SPACE]
        .into_iter()
        .find(|layout| layout.head == words.len());
    let layout = layout.ok_or_else(|| {
        line.invalid(
            "the head of a state",
            "N, time and the ends of the box: 6 or 8 numbers",
            line.text,
        )
    })?;
    let count = line.whole("the number of particles", 0..=MOST, words[0])?;
    let ends = words[2..]
        .iter()
        .map(|word| line.number("an end of the box", word));
    let ends: Vec<f64> = ends.collect::<Result<_, _>>()?;
    let (low, high) = ends.split_at(ends.len() / 2);
    let at = |ends: &[f64], axis: usize| ends.get(axis).copied().unwrap_or(0.0);
    let mut found = FoundSpheres::with_places(RowName::Lines(Vec::new()));
    found.cell = Cell {
        bounds: (layout.row == SPACE.row)
            .then(|| [0, 1, 2].map(|axis| [at(low, axis), at(high, axis)])),
        is_silent: true,
        ..Cell::default()
    };
    let mut names = Vec::new();
    for _ in 0..count {
        let line = lines.need("a particle", CUT_SHORT)?;
        let numbers = line
            .words()
            .into_iter()
            .map(|word| line.number("a number of a particle", word));
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
        match numbers[..] {
            // Angles are of no use to spheres.
            [x, y, z, vx, vy, vz, radius, _, _, _, wx, wy, wz, species]
                if layout.row == SPACE.row =>
            {
                found.push_vector(X, [x, y, z]);
                found.push_vector(VelocityX, [vx, vy, vz]);
                found.push_vector(SpinX, [wx, wy, wz]);
                one(&mut found, radius, species);
            }
            [x, y, vx, vy, radius, _, spin, species] if layout.row == PLANE.row => {
                found.push_vector(X, [x, y, 0.0]);
                found.push_vector(VelocityX, [vx, vy, 0.0]);
                found.push_vector(SpinX, [0.0, 0.0, spin]);
                one(&mut found, radius, species);
            }
            _ => return Err(line.invalid("a row", format!("{} numbers", layout.row), line.text)),
        }
        names.push(line.number);
    }
    found.rows = RowName::Lines(names);
    Ok(found)
}

/// Radius and species, which count from 0.
fn one(found: &mut FoundSpheres, radius: f64, species: f64) {
    found.push(Radius, radius);
    found.push(Material, species + 1.0);
}

/// The particles of `.restart`, with the densities of their species and the periods of their boundaries.
pub(super) fn read_restart(source: &Source<'_>, text: &str) -> Result<Assembly, AssemblyError> {
    let found = restart(text).map_err(|cause| source.text_error(cause))?;
    found.checked(source.name, source.columns, "")
}

fn restart(text: &str) -> Result<FoundSpheres, TextError> {
    let mut lines = Lines::new(text);
    let mut cell = Cell {
        bounds: Some([[0.0; 2]; 3]),
        ..Cell::default()
    };
    let (mut densities, mut is_bounded) = (Vec::new(), false);
    let mut notes = Vec::new();
    let mut has_species = true;
    let count = loop {
        let line = lines.need("the line `Particles N`", CUT_SHORT)?;
        let words = line.words();
        match words[..] {
            ["Particles", count, ..] => {
                break line.whole("the number of particles", 0..=MOST, count)?;
            }
            ["Species", count, ..] => {
                for _ in 0..line.whole("the number of species", 0..=MOST, count)? {
                    densities.push(density(lines.need("a species", CUT_SHORT)?)?);
                    // Species of pairs stand behind those of particles.
                    while lines
                        .peek()
                        .is_some_and(|line| line.text.contains("MixedSpecies"))
                    {
                        lines.next();
                    }
                }
            }
            // All are of one species.
            ["restart_version", "1" | "2"] => has_species = false,
            _ => {
                is_bounded |= bounds(line, &words, &mut cell)?;
                let kind = words.first().copied().unwrap_or_default();
                let is_repeat = kind.contains("PeriodicBoundary")
                    || kind.contains("LeesEdwards")
                    || words.contains(&"pos_left");
                if is_repeat && !period(line, &words, &mut cell)? {
                    notes.push(format!(
                        "its {kind} is left out: boxes repeat along their axes"
                    ));
                }
            }
        }
    };
    if !is_bounded {
        cell.bounds = cell.bounds.filter(|_| cell.is_periodic.contains(&true));
    }
    let mut found = FoundSpheres::with_places(RowName::Lines(Vec::new()));
    (found.cell, found.notes) = (cell, notes);
    let mut names = Vec::new();
    for _ in 0..count {
        let line = lines.need("a particle", CUT_SHORT)?;
        particle(&mut found, line)?;
        let species = if has_species { species(line)? } else { 0 };
        let density = densities.get(species).copied().flatten();
        found.push(
            Density,
            density.ok_or_else(|| {
                line.invalid(
                    "the species",
                    "one of those above, with a density",
                    &species.to_string(),
                )
            })?,
        );
        found.push(Material, species as f64 + 1.0);
        names.push(line.number);
    }
    found.rows = RowName::Lines(names);
    Ok(found)
}

/// The number behind a word, if the word is there.
fn behind(line: Line<'_>, words: &[&str], name: &str) -> Result<Option<f64>, TextError> {
    let at = words
        .iter()
        .position(|word| word.eq_ignore_ascii_case(name));
    let word = at.and_then(|at| words.get(at + 1));
    word.map(|word| line.number("a number of the file", word))
        .transpose()
}

/// Density of a species, if its line has one.
fn density(line: Line<'_>) -> Result<Option<f64>, TextError> {
    let words = line.words();
    Ok(behind(line, &words, "density")?.or(behind(line, &words, "rho")?))
}

/// Takes the ends of the box from a line that has them.
fn bounds(line: Line<'_>, words: &[&str], cell: &mut Cell) -> Result<bool, TextError> {
    let Some(all) = cell.bounds.as_mut().filter(|_| {
        words
            .first()
            .is_some_and(|word| word.eq_ignore_ascii_case("xMin"))
    }) else {
        return Ok(false);
    };
    for (ends, axis) in all.iter_mut().zip(["x", "y", "z"]) {
        for (end, name) in ends.iter_mut().zip(["Min", "Max"]) {
            *end = behind(line, words, &format!("{axis}{name}"))?.unwrap_or(*end);
        }
    }
    Ok(true)
}

/// Takes a period from the line of a boundary; whether it is along an axis.
fn period(line: Line<'_>, words: &[&str], cell: &mut Cell) -> Result<bool, TextError> {
    let normal = words.iter().position(|word| *word == "normal");
    let Some(normal) = normal.and_then(|at| words.get(at + 1..at + 4)) else {
        return Ok(false);
    };
    let side = |names: [&str; 3]| -> Result<Option<f64>, TextError> {
        let mut known = names.iter().filter(|name| words.contains(name));
        known
            .next()
            .map_or(Ok(None), |name| behind(line, words, name))
    };
    let left = side(["distanceLeft", "distance_left", "pos_left"])?;
    let ends = left.zip(side(["distanceRight", "distance_right", "pos_right"])?);
    let mut is_along = false;
    for (axis, word) in normal.iter().enumerate() {
        if line.number("a normal", word)? == 1.0
            && let (Some((low, high)), Some(bounds)) = (ends, cell.bounds.as_mut())
        {
            bounds[axis] = [low, high];
            cell.is_periodic[axis] = true;
            is_along = true;
        }
    }
    Ok(is_along)
}

/// Adds a particle.
fn particle(found: &mut FoundSpheres, line: Line<'_>) -> Result<(), TextError> {
    let words = line.words();
    let kind = words.first().copied().unwrap_or_default();
    if kind.contains("Superquadric") || kind.contains("SuperQuadric") || kind.contains("Clump") {
        return Err(TextError::Unsupported {
            line: line.number,
            what: format!("the particle `{kind}`"),
            cure: "only spheres are read",
        });
    }
    let three = |at: usize| -> Result<[f64; 3], TextError> {
        let words = words
            .get(at..at + 3)
            .ok_or_else(|| line.missing("a number of a particle", CUT_SHORT))?;
        let mut numbers = [0.0; 3];
        for (number, word) in numbers.iter_mut().zip(words) {
            *number = line.number("a number of a particle", word)?;
        }
        Ok(numbers)
    };
    let need = |name: &'static str| field(line, &words, name).map(|at| at + 1);
    let is_named = words.contains(&"position");
    let begin = begin_of(&words);
    let places: [(SphereColumn, usize); 3] = if is_named {
        [
            (X, need("position")?),
            (VelocityX, need("velocity")?),
            (SpinX, need("angularVelocity")?),
        ]
    } else {
        [(X, begin), (VelocityX, begin + 3), (SpinX, begin + 10)]
    };
    for (first, at) in places {
        found.push_vector(first, three(at)?);
    }
    let radius = if is_named { need("radius")? } else { begin + 6 };
    found.push(
        Radius,
        line.number("the radius", word(line, &words, radius)?)?,
    );
    Ok(())
}

/// The species of a particle, from 0.
fn species(line: Line<'_>) -> Result<usize, TextError> {
    let words = line.words();
    let at = match words.contains(&"position") {
        true => field(line, &words, "indSpecies")? + 1,
        false => begin_of(&words) + 15,
    };
    Ok(line.whole("the species", 0..=254, word(line, &words, at)?)? as usize)
}

/// The first number of a particle: files of versions before 1.0 have them in a fixed order behind two words or none.
fn begin_of(words: &[&str]) -> usize {
    let begin = words.iter().position(|word| word.parse::<f64>().is_ok());
    begin.unwrap_or(0)
}

fn word<'a>(line: Line<'_>, words: &[&'a str], at: usize) -> Result<&'a str, TextError> {
    let word = words.get(at).copied();
    word.ok_or_else(|| line.missing("a number of a particle", CUT_SHORT))
}

/// Where a field of a particle is named.
fn field(line: Line<'_>, words: &[&str], name: &'static str) -> Result<usize, TextError> {
    let cure = "each particle needs position, velocity, angularVelocity, radius and indSpecies";
    let at = words.iter().position(|word| *word == name);
    at.ok_or_else(|| line.missing(name, cure))
}
